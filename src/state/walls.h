#pragma once
/**
 * @file walls.h
 * Walls: rigid bodies made of shapes, with motion, load and the force they feel.
 */

#include <stdint.h>
#include <string.h>

#include "base/quat.h"
#include "base/vec3.h"
#include "clod/case.h"
#include "clod/status.h"
#include "mesh/surface.h"
#include "state/shape_kinds.h"

/**
 * How the material of a surface moves while the surface stays where it is, beside what its wall
 * does: a belt. In the frame of the wall; all zero: not at all. Material moves along its
 * surface only: of the sum of all parts what is normal to the surface does not count.
 */
typedef struct clod_belt {
    clod_vec3 velocity;  ///< m/s, the same everywhere
    clod_vec3 direction; ///< unit; along its projection onto the surface the material moves ...
    double speed;        ///< m/s, ... with this speed (not where it is normal to the surface)
    double spin;         ///< rad/s, about an axis
    clod_vec3 spin_axis; ///< unit
    clod_vec3 spin_point; ///< m
} clod_belt;

/** Squared length of a direction's projection below which it is normal to the surface. */
#define CLOD_BELT_ACROSS 1e-12

/** A surface in the frame of its wall: the frame in which it was given. */
typedef struct clod_shape {
    clod_shape_kind kind;
    int32_t material; ///< 1 + number of its own material; 0: that of its wall
    clod_belt belt;
    bool symmetric;   ///< turning about the wall's spin axis leaves it where it is
    clod_vec3 center; ///< plane: point; disc, annulus, box, bar: centre; else: foot of the axis
    clod_vec3
        axis[3]; ///< orthonormal; axis[2]: normal, or axis of a shell; box, bar: its frame
    double inner, outer; ///< m, radii: disc, cylinder outer; annulus both; cone: top and foot
    double half[3]; ///< m, box, bar: half sizes along axis[]; shells: half[2] = half length
    clod_side side;
    clod_surface *surface;  ///< mesh: with one user for this shape; else NULL
    int32_t patch;          ///< mesh: of the surface
    int32_t slot;           ///< mesh: which of the contacts with the patch (surface_touch.h)
    int32_t place;          ///< first of its places among those of the wall (wear.h)
    int32_t face;           ///< first of its surfaces among those of the wall (wear.h)
    int32_t outlet;         ///< 1 + number of that which removes grains that touch it; 0: none
    double archard, finnie; ///< m3/J, worn volume for a sum of work (wear.h)
} clod_shape;

/** Whether it is a mesh whose facets are not there: a checkpoint has none. */
static inline bool clod_shape_lacks_facets(const clod_shape *self)
{
    return clod_shape_kinds_row(self->kind)->faceted && self->surface == NULL;
}

/** Copies of shapes, with users of their surfaces; NULL without memory. */
clod_shape *clod_shapes_copy(const clod_shape *shapes, int32_t count);

/** Free shapes and null; their surfaces lose a user each. NULL is fine. */
void clod_shapes_free(clod_shape **shapes, int32_t count);

/** Sums of a place of a wall (wear.h). */
#define CLOD_WEAR_SUMS 11

/** Radius of a shell at its top, or of the hole of an annulus; 0 for a disc [m]. */
static inline double clod_shape_end_radius(const clod_shape *self)
{
    return clod_shape_kinds_row(self->kind)->straight ? self->outer : self->inner;
}

/** Whether it is the first shape of a mesh, which has those of all its patches behind it. */
static inline bool clod_shape_begins_mesh(const clod_shape *self)
{
    return self->surface != NULL && self->patch == 0 && self->slot == 0;
}

/** Harmonic motion: displacement amplitude sin(2 pi frequency t + phase), along and about. */
typedef struct clod_oscillation {
    clod_vec3 direction; ///< unit, or 0 without amplitude
    double amplitude;    ///< m along direction
    double angle;        ///< rad about the spin axis
    double frequency;    ///< Hz; 0: the wall does not oscillate
    double phase;        ///< rad
} clod_oscillation;

/** Start of a wall's belts: they stand until `at`, and have their speed `duration` later. */
typedef struct clod_start_up {
    double at;       ///< s, time of the simulation
    double duration; ///< s, in which the speed rises linearly
} clod_start_up;

#define CLOD_WALL_NAME 32 ///< bytes of a wall's name

typedef struct clod_wall {
    char name[CLOD_WALL_NAME];
    uint16_t material; ///< of the shapes that have none of their own
    int32_t shape_count;
    clod_shape *shapes; ///< owned
    // motion
    clod_vec3 velocity;         ///< m/s, of the whole wall; the servo adds to it
    clod_vec3 surface_velocity; ///< m/s, a belt of all shapes, in space; their own add to it
    double spin;                ///< rad/s
    clod_vec3 spin_axis;        ///< unit, in space
    clod_vec3 spin_point;       ///< m, in the frame of the wall
    // pose: a point p of the frame is at
    // spin_point + shift + turn(spin_axis, angle) orientation (p - spin_point)
    clod_quat orientation; ///< unit; the pose at angle 0; all zero: as it was given
    clod_vec3 shift;       ///< m, where it is: moved so far, with the oscillation
    double angle;          ///< rad, turned so far, with the oscillation
    clod_oscillation oscillation;
    clod_vec3 travel;        ///< m, if it oscillates: shift without that, the sum of all else
    double turned;           ///< rad, if it oscillates: angle without that
    clod_vec3 sway_velocity; ///< m/s, of the oscillation, mean over the last step
    double sway_spin;        ///< rad/s, the same about the spin axis
    clod_start_up start_up;  ///< of the belts of its shapes
    double belt_lag;         ///< 1 - fraction of their speed that these have; 0: all of it
    // load
    clod_load_kind load;
    clod_vec3 load_axis;     ///< unit; the load pushes along it
    double load_force;       ///< N, aimed at
    double area;             ///< m2
    double mass;             ///< kg
    double damping_fraction; ///< of critical, to make damping; 0 after a checkpoint is read
    double damping;          ///< N s/m
    double servo_velocity;   ///< m/s along load_axis
    // result of the last step
    clod_vec3 force;   ///< N, of the grains on the wall
    clod_vec3 torque;  ///< N m, of the grains on the wall, about spin_point + shift
    double power;      ///< W, done by the wall and its belts on the grains
    double belt_power; ///< W, the part of it that the shapes' belts do
    // sums since clod_walls_reset_sums, in step order
    int64_t sum_steps;
    clod_vec3 sum_force, sum_torque;
    double sum_power;
    // what grains did to each place of it (wear.h)
    int32_t wear_places, wear_rows;
    double wear_since, wear_row;    ///< s, times at which the sums began, and of the last row
    double (*wear)[CLOD_WEAR_SUMS]; ///< owned [wear_rows] places, then the sums of each surface
                                    ///< at the last row of the series, then those of now, as
                                    ///< sim/surfaces.c needs them, then the impacts of each
                                    ///< surface (clod_wear_impacts); NULL: nobody asked
} clod_wall;

/** Free what a wall owns. */
void clod_wall_fini(clod_wall *self);

/** Note that another owns what a wall owned. */
void clod_wall_give(clod_wall *self);

typedef struct clod_walls {
    int32_t count;
    clod_wall *wall; ///< owned
} clod_walls;

/** Velocity of the wall without that of its turning, and without its belts [m/s]. */
static inline clod_vec3 clod_wall_velocity(const clod_wall *self)
{
    const clod_vec3 v = clod_vec3_axpy(self->velocity, self->servo_velocity, self->load_axis);
    return clod_vec3_add(v, self->sway_velocity);
}

/** Speed with which the wall turns about its spin axis [rad/s]. */
static inline double clod_wall_spin(const clod_wall *self)
{
    return self->spin + self->sway_spin;
}

/** Velocity of the wall at a point of space [m/s], without its belts. */
static inline clod_vec3 clod_wall_velocity_at(const clod_wall *self, clod_vec3 point)
{
    const clod_vec3 origin = clod_vec3_add(self->spin_point, self->shift);
    const clod_vec3 arm = clod_vec3_sub(point, origin);
    return clod_vec3_axpy(clod_wall_velocity(self), clod_wall_spin(self),
                          clod_vec3_cross(self->spin_axis, arm));
}

/** Orientation at angle 0, whether it was ever set or not. */
static inline clod_quat clod_wall_orientation(const clod_wall *self)
{
    const clod_quat q = self->orientation;
    return clod_quat_is_none(q) ? CLOD_QUAT_NONE : q;
}

/** Material of a shape. */
static inline uint16_t clod_wall_material(const clod_wall *self, int32_t shape)
{
    const int32_t own = self->shapes[shape].material;
    return own > 0 ? (uint16_t)(own - 1) : self->material;
}

/** Numbers that a pose is: shift, angle, orientation. */
#define CLOD_WALL_POSE_NUMBERS 8

/** The pose of a wall as numbers. */
static inline void clod_wall_pose_get(const clod_wall *self, double to[CLOD_WALL_POSE_NUMBERS])
{
    const clod_quat q = self->orientation;
    const double pose[CLOD_WALL_POSE_NUMBERS] = {
        self->shift.x, self->shift.y, self->shift.z, self->angle, q.w, q.x, q.y, q.z};
    memcpy(to, pose, sizeof pose);
}

/** Put a wall at a pose. */
static inline void clod_wall_pose_set(clod_wall *self,
                                      const double from[CLOD_WALL_POSE_NUMBERS])
{
    self->shift = clod_vec3_of(from);
    self->angle = from[3];
    self->orientation = (clod_quat){from[4], from[5], from[6], from[7]};
}

/** Whether the material of a shape moves beside its wall. */
static inline bool clod_belt_moves(const clod_belt *self)
{
    const clod_vec3 v = self->velocity;
    return v.x != 0.0 || v.y != 0.0 || v.z != 0.0 || self->speed != 0.0 || self->spin != 0.0;
}

/** Whether the material of any of its shapes moves beside it. */
bool clod_wall_has_belts(const clod_wall *self);

/**
 * Velocity of the material of a shape at a point of its surface [m/s], with wall and belts.
 *
 * @param point   m, in space
 * @param normal  unit, of the surface there
 */
clod_vec3 clod_wall_material_velocity(const clod_wall *self, int32_t shape, clod_vec3 point,
                                      clod_vec3 normal);

/**
 * Give the wall another orientation, turned about its spin point: the pose at angle 0, and the
 * angle is 0. Nothing else of its pose changes.
 *
 * @param orientation  unit quaternion from the frame to space
 */
void clod_wall_set_orientation(clod_wall *self, clod_quat orientation);

/**
 * Let the wall turn about another axis from now on; it stays where it is.
 *
 * @param axis   unit, in space
 * @param point  m, a point of the axis in space
 */
void clod_wall_set_spin_axis(clod_wall *self, clod_vec3 axis, clod_vec3 point);

/** Note for each shape whether turning about the spin axis leaves it where it is. */
void clod_wall_find_symmetry(clod_wall *self);

/** A plane that turning about the spin axis would tilt: endless, it cannot; or -1. */
int32_t clod_wall_plane_across(const clod_wall *self);

/** Put an oscillating wall where it is at time 0, with its velocity there; belts as at time 0. */
void clod_wall_start(clod_wall *self);

/**
 * Put a wall that comes after `step` steps where it would be by its oscillation and its start-up
 * if it had been there from the start.
 *
 * Errors  none.   Threads  pure.   Test  tests/sim/test_sim_wall_loads.c
 */
void clod_wall_join(clod_wall *self, double dt, int64_t step);

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

/** Number of the wall of this name, or -1. */
int32_t clod_walls_find(const clod_walls *self, const char *name);

/** Whether any shape removes grains that touch it. */
bool clod_walls_remove(const clod_walls *self);

/** Start new sums of force, torque and power on every wall. */
void clod_walls_reset_sums(clod_walls *self);

bool clod_walls_copy(clod_walls *self, const clod_walls *from, clod_status *status);
void clod_walls_fini(clod_walls *self);
