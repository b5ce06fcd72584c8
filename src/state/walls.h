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
    clod_vec3 center; ///< plane: point; disc, annulus, box, bar: centre; else: foot of the axis
    clod_vec3
        axis[3]; ///< orthonormal; axis[2]: normal, or axis of a shell; box, bar: its frame
    double inner, outer; ///< m, radii: disc, cylinder outer; annulus both; cone: top and foot
    double half[3]; ///< m, box, bar: half sizes along axis[]; shells: half[2] = half length
    clod_side side;
} clod_shape;

/** Harmonic motion: displacement amplitude sin(2 pi frequency t + phase), along and about. */
typedef struct clod_oscillation {
    clod_vec3 direction; ///< unit, or 0 without amplitude
    double amplitude;    ///< m along direction
    double angle;        ///< rad about the spin axis
    double frequency;    ///< Hz; 0: the wall does not oscillate
    double phase;        ///< rad
} clod_oscillation;

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
    clod_vec3 shift;            ///< m, where it is: moved so far, with the oscillation
    double angle;               ///< rad, turned so far, with the oscillation
    clod_oscillation oscillation;
    clod_vec3 travel;        ///< m, if it oscillates: shift without that, the sum of all else
    double turned;           ///< rad, if it oscillates: angle without that
    clod_vec3 sway_velocity; ///< m/s, of the oscillation, mean over the last step
    double sway_spin;        ///< rad/s, the same about the spin axis
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

/** Velocity of the wall's material without that of its turning [m/s], belt motion included. */
static inline clod_vec3 clod_wall_velocity(const clod_wall *self)
{
    clod_vec3 v = clod_vec3_add(self->velocity, self->surface_velocity);
    v = clod_vec3_axpy(v, self->servo_velocity, self->load_axis);
    return clod_vec3_add(v, self->sway_velocity);
}

/** Speed with which the wall turns about its spin axis [rad/s]. */
static inline double clod_wall_spin(const clod_wall *self)
{
    return self->spin + self->sway_spin;
}

/** Velocity of the wall's material at a point of space [m/s], belt motion included. */
static inline clod_vec3 clod_wall_velocity_at(const clod_wall *self, clod_vec3 point)
{
    const clod_vec3 origin = clod_vec3_add(self->spin_point, self->shift);
    const clod_vec3 arm = clod_vec3_sub(point, origin);
    return clod_vec3_axpy(clod_wall_velocity(self), clod_wall_spin(self),
                          clod_vec3_cross(self->spin_axis, arm));
}

/** Put an oscillating wall where it is at time 0, with its velocity there. */
void clod_wall_start(clod_wall *self);

/**
 * Move a wall through one step: by its velocity, servo, spin and oscillation.
 *
 * The displacement of the oscillation is a function of the step's number alone, so it does not
 * drift; its velocity is the displacement of this step over dt.
 *
 * @param dt    time step [s]
 * @param step  number of the step at whose end the wall will be; its time is step dt
 * Errors  none.   Threads  pure.   Test  tests/geometry/test_wall_motion.c
 */
void clod_wall_move(clod_wall *self, double dt, int64_t step);

/**
 * Upper bound of the distance from the spin axis of any point that a turn would move [m]: it
 * follows from the shapes alone. Planes do not count: a wall that turns has none but symmetric
 * ones.
 */
double clod_wall_reach(const clod_wall *self);

/** Upper bound of the speed with which any point of the wall's shapes moves [m/s]; `reach` is
 *  that of clod_wall_reach. */
double clod_wall_speed_within(const clod_wall *self, double reach);

/** The same where nobody has kept the reach. */
double clod_wall_speed_bound(const clod_wall *self);

/** Start new sums of force, torque and power on every wall. */
void clod_walls_reset_sums(clod_walls *self);

bool clod_walls_copy(clod_walls *self, const clod_walls *from, clod_status *status);
void clod_walls_fini(clod_walls *self);
