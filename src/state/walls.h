#pragma once
/**
 * @file walls.h
 * Walls: rigid bodies made of shapes, with motion, load and the force they feel.
 */

#include <stdint.h>

#include "base/vec3.h"
#include "clod/case.h"
#include "clod/status.h"

/**
 * A surface in the frame of its wall (the frame in which it was given; it turns about the
 * wall's spin axis and moves with the wall's shift).
 */
typedef struct clod_shape {
    clod_shape_kind kind;
    bool symmetric;   ///< turning about the wall's spin axis leaves it where it is
    clod_vec3 center; ///< plane: point; disc, annulus, box, bar: centre; cylinder: foot of axis
    clod_vec3 axis[3]; ///< orthonormal; axis[2]: normal, or cylinder axis; box, bar: its frame
    double inner, outer; ///< radii: disc outer, annulus both, cylinder outer [m]
    double half[3];      ///< box, bar: half sizes along axis[]; cylinder: half[2] = half length
    clod_side side;
} clod_shape;

typedef struct clod_wall {
    char name[32];
    uint16_t material;
    int32_t shape_count;
    clod_shape *shapes; ///< owned
    // motion
    clod_vec3 velocity;         ///< m/s, of the whole wall; the servo adds to it
    clod_vec3 surface_velocity; ///< m/s
    double spin;                ///< rad/s
    clod_vec3 spin_axis;        ///< unit
    clod_vec3 spin_point;       ///< m, in the frame of the wall
    clod_vec3 shift;            ///< m, moved so far
    double angle;               ///< rad, turned so far
    // load
    clod_load_kind load;
    clod_vec3 load_axis;   ///< unit; the load pushes along it
    double load_force;     ///< N, aimed at
    double area;           ///< m2
    double mass;           ///< kg
    double damping;        ///< N s/m
    double servo_velocity; ///< m/s along load_axis
    // result of the last step
    clod_vec3 force;  ///< N, of the grains on the wall
    clod_vec3 torque; ///< N m, of the grains on the wall, about spin_point + shift
    double power;     ///< W, done by the wall on the grains
    // sums since clod_walls_reset_sums, in step order
    int64_t sum_steps;
    clod_vec3 sum_force, sum_torque;
    double sum_power;
} clod_wall;

typedef struct clod_walls {
    int32_t count;
    clod_wall *wall; ///< owned
} clod_walls;

/** Velocity of the wall's material at a point of space [m/s], belt motion included. */
static inline clod_vec3 clod_wall_velocity_at(const clod_wall *self, clod_vec3 point)
{
    const clod_vec3 origin = clod_vec3_add(self->spin_point, self->shift);
    const clod_vec3 arm = clod_vec3_sub(point, origin);
    clod_vec3 v = clod_vec3_add(self->velocity, self->surface_velocity);
    v = clod_vec3_axpy(v, self->servo_velocity, self->load_axis);
    return clod_vec3_axpy(v, self->spin, clod_vec3_cross(self->spin_axis, arm));
}

/** Upper bound of the speed with which any point of the wall's shapes moves [m/s]. */
double clod_wall_speed_bound(const clod_wall *self);

/** Start new sums of force, torque and power on every wall. */
void clod_walls_reset_sums(clod_walls *self);

bool clod_walls_copy(clod_walls *self, const clod_walls *from, clod_status *status);
void clod_walls_fini(clod_walls *self);
