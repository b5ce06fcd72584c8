#pragma once
// Solids of a few points for tests.

#include "hopper/design.h"
#include "support/check.h"

#define DEGREE (M_PI / 180.0)

/** A solid with its flow function and constant angles and density. */
typedef struct made {
    clod_curve_point strength[64], phi_e, phi_t, rho, wall;
    clod_solid solid;
} made;

static inline void make_solid(made *self, double phi_e, double phi_w, double rho)
{
    self->phi_e = (clod_curve_point){1.0, phi_e * DEGREE, 0, 0, NULL};
    self->phi_t = (clod_curve_point){1.0, 40.0 * DEGREE, 0, 0, NULL};
    self->rho = (clod_curve_point){1.0, rho, 0, 0, NULL};
    self->wall = (clod_curve_point){1.0, tan(phi_w * DEGREE), 0, 0, NULL};
    self->solid = (clod_solid){.strength = {CLOD_CURVE_EXTENDED, self->strength, 0},
                               .phi_e = {CLOD_CURVE_HELD, &self->phi_e, 1},
                               .phi_t = {CLOD_CURVE_HELD, &self->phi_t, 1},
                               .rho = {CLOD_CURVE_HELD, &self->rho, 1},
                               .wall = {CLOD_CURVE_EXTENDED, &self->wall, 1}};
}

/** Add a point of the flow function, kPa. */
static inline void add_strength(made *self, double sigma_1, double strength)
{
    self->strength[self->solid.strength.count++] =
        (clod_curve_point){1e3 * sigma_1, 1e3 * strength, 0, 0, NULL};
}

static inline clod_hopper_wish wish_of(clod_radial_shape shape, double half_angle,
                                       clod_hopper_arch arch)
{
    return (clod_hopper_wish){.shape = shape,
                              .half_angle = half_angle * DEGREE,
                              .margin = 3.0 * DEGREE,
                              .arch = arch,
                              .tolerance = CLOD_RADIAL_TOLERANCE};
}
