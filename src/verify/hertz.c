#include "verify/hertz.h"

#include <math.h>

double clod_verify_hertz_sphere(double density, double radius)
{
    return density * 4.0 / 3.0 * M_PI * radius * radius * radius;
}

double clod_verify_hertz_mass(const clod_verify_pair *self)
{
    return 1.0 / (1.0 / self->mass_a + (self->mass_b > 0.0 ? 1.0 / self->mass_b : 0.0));
}

double clod_verify_hertz_radius(const clod_verify_pair *self)
{
    return 1.0 / (1.0 / self->radius_a + (self->radius_b > 0.0 ? 1.0 / self->radius_b : 0.0));
}

double clod_verify_hertz_stiffness(const clod_verify_pair *self)
{
    return 4.0 / 3.0 * self->young_star * sqrt(clod_verify_hertz_radius(self));
}

double clod_verify_hertz_overlap(const clod_verify_pair *self)
{
    const double energy = clod_verify_hertz_mass(self) * self->speed * self->speed;
    return pow(1.25 * energy / clod_verify_hertz_stiffness(self), 0.4);
}

double clod_verify_hertz_force(const clod_verify_pair *self)
{
    return clod_verify_hertz_stiffness(self) * pow(clod_verify_hertz_overlap(self), 1.5);
}

double clod_verify_hertz_duration(const clod_verify_pair *self)
{
    const double integral = tgamma(1.4) * tgamma(0.5) / tgamma(0.9);
    return 2.0 * integral * clod_verify_hertz_overlap(self) / self->speed;
}

double clod_verify_hertz_mean_overlap(const clod_verify_pair *self)
{
    const double integral = tgamma(1.4) * tgamma(1.5) / tgamma(1.9);
    return integral * clod_verify_hertz_overlap(self);
}
