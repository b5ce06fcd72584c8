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
    self->phi_e = (clod_curve_point){.x = 1.0, .y = phi_e * DEGREE};
    self->phi_t = (clod_curve_point){.x = 1.0, .y = 40.0 * DEGREE};
    self->rho = (clod_curve_point){.x = 1.0, .y = rho};
    self->wall = (clod_curve_point){.x = 1.0, .y = tan(phi_w * DEGREE)};
    self->solid = (clod_solid){
        .strength = {.way = CLOD_CURVE_EXTENDED, .points = self->strength, .count = 0},
        .phi_e = {.way = CLOD_CURVE_HELD, .points = &self->phi_e, .count = 1},
        .phi_t = {.way = CLOD_CURVE_HELD, .points = &self->phi_t, .count = 1},
        .rho = {.way = CLOD_CURVE_HELD, .points = &self->rho, .count = 1},
        .wall = {.way = CLOD_CURVE_EXTENDED, .points = &self->wall, .count = 1}};
}

/** Add a point of the flow function, kPa. */
static inline void add_strength(made *self, double sigma_1, double strength)
{
    self->strength[self->solid.strength.count++] =
        (clod_curve_point){.x = 1e3 * sigma_1, .y = 1e3 * strength};
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
