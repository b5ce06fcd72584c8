#include "hopper/solid.h"

#include <math.h>

#include "hopper/radial.h"

#define ROUNDS 200
#define CLOSE 1e-10 // relative change of sigma_w at which it is found

double clod_solid_wall_angle(const clod_solid *self, double sigma_w)
{
    const clod_curve *wall = &self->wall;
    const double angle = atan2(clod_curve_at(wall, sigma_w), sigma_w);
    if (wall->count < 2 || sigma_w >= wall->points[0].x) {
        return angle;
    }
    // a line with an intercept below 0 would promise a wall without friction where none was measured
    const double least = wall->points[0].x;
    return fmax(angle, atan2(clod_curve_at(wall, least), least));
}

/**
 * From sigma_w = sigma_1 downwards: a smaller normal stress has a larger angle, which makes the
 * stress smaller still, so the rounds fall to the largest stress that fits.
 */
static void slide(const clod_solid *self, clod_solid_state *at)
{
    const double s = sin(at->phi_e);
    at->sigma_w = at->sigma_1;
    for (int round = 0; round < ROUNDS; round++) {
        at->phi_w = clod_solid_wall_angle(self, at->sigma_w);
        const double beta = clod_radial_beta(at->phi_e, at->phi_w);
        if (!(beta >= 0.0)) {
            break;
        }
        const double before = at->sigma_w;
        at->sigma_w = at->sigma_1 * (1.0 + s * cos(2.0 * beta)) / (1.0 + s);
        if (fabs(before - at->sigma_w) <= CLOSE * at->sigma_w) {
            return;
        }
    }
    at->phi_w = M_PI_2;
}

clod_solid_state clod_solid_at(const clod_solid *self, double sigma_1)
{
    clod_solid_state at = {
        .sigma_1 = sigma_1,
        .strength = clod_curve_at(&self->strength, sigma_1),
        .phi_e = clod_curve_at(&self->phi_e, sigma_1),
        .phi_t = clod_curve_at(&self->phi_t, sigma_1),
        .rho = clod_curve_at(&self->rho, sigma_1),
    };
    slide(self, &at);
    return at;
}

double clod_solid_end(const clod_solid *self)
{
    const clod_curve *const curves[] = {&self->strength, &self->phi_e, &self->phi_t};
    double end = 0.0;
    for (size_t c = 0; c < 3; c++) {
        const size_t count = curves[c]->count;
        end = count > 0 ? fmax(end, curves[c]->points[count - 1].x) : end;
    }
    return end;
}
