#include "state/impacts.h"

#include <math.h>

#include "base/lower_bound.h"

/** J: 1, 2, 5 of each decade, as decimal constants so that they are the same everywhere. */
static const double BOUND[CLOD_IMPACT_BOUNDS] = {
    1e-12, 2e-12, 5e-12, 1e-11, 2e-11, 5e-11, 1e-10, 2e-10, 5e-10, 1e-9, 2e-9, 5e-9, 1e-8, 2e-8,
    5e-8,  1e-7,  2e-7,  5e-7,  1e-6,  2e-6,  5e-6,  1e-5,  2e-5,  5e-5, 1e-4, 2e-4, 5e-4, 1e-3,
    2e-3,  5e-3,  1e-2,  2e-2,  5e-2,  1e-1,  2e-1,  5e-1,  1e0,   2e0,  5e0,  1e1,  2e1,  5e1,
    1e2,   2e2,   5e2,   1e3,   2e3,   5e3,   1e4,   2e4,   5e4,   1e5,  2e5,  5e5,  1e6};

clod_impact clod_impact_of(double mass, double approach, double speed2)
{
    const double speed = sqrt(fmax(speed2, approach * approach));
    return (clod_impact){.angle = asin(approach / speed),
                         .speed = speed,
                         .energy = 0.5 * mass * speed * speed,
                         .normal = 0.5 * mass * approach * approach};
}

static int angle_class(double angle)
{
    const int class = (int)floor(angle * (CLOD_IMPACT_ANGLES / (0.5 * M_PI)));
    return class < CLOD_IMPACT_ANGLES ? class : CLOD_IMPACT_ANGLES - 1;
}

static int energy_class(double energy)
{
    clod_lower_bound in = {0, CLOD_IMPACT_BOUNDS};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, BOUND[middle] <= energy);
    }
    return (int)in.low;
}

static void add_class(clod_impact_class *self, const clod_impact_class *of)
{
    self->number += of->number;
    self->energy += of->energy;
    self->normal += of->normal;
}

void clod_impacts_add(clod_impacts *self, const clod_impact *impact)
{
    clod_impact_sums *all = &self->all;
    all->number += 1.0;
    all->angle += impact->angle;
    all->angle2 += impact->angle * impact->angle;
    all->speed += impact->speed;
    all->speed2 += impact->speed * impact->speed;
    all->normal += impact->normal;
    all->normal2 += impact->normal * impact->normal;
    all->energy += impact->energy;
    add_class(&self->of[angle_class(impact->angle)][energy_class(impact->normal)],
              &(clod_impact_class){1.0, impact->energy, impact->normal});
}

double clod_impacts_energy_from(int class)
{
    if (class == 0) {
        return 0.0;
    }
    return class <= CLOD_IMPACT_BOUNDS ? BOUND[class - 1] : (double)INFINITY;
}

clod_impact_class clod_impacts_at_angle(const clod_impacts *self, int angle)
{
    clod_impact_class sum = {.number = 0.0};
    for (int e = 0; e < CLOD_IMPACT_ENERGIES; e++) {
        add_class(&sum, &self->of[angle][e]);
    }
    return sum;
}

clod_impact_class clod_impacts_with_energy(const clod_impacts *self, int energy)
{
    clod_impact_class sum = {.number = 0.0};
    for (int a = 0; a < CLOD_IMPACT_ANGLES; a++) {
        add_class(&sum, &self->of[a][energy]);
    }
    return sum;
}
