#pragma once
/**
 * @file sim_walls.h
 * Walls of a simulation (clod/sim.h, which includes this header): what they feel, and their
 * motion in the hands of the caller.
 */

#include <stdbool.h>
#include <stdint.h>

#include "clod/case.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A simulation; its content is hidden. */
typedef struct clod_sim clod_sim;

/** A wall as it is now. Forces and torques are those of the grains on the wall. */
typedef struct clod_sim_wall {
    const char *name;            ///< valid until a wall comes or goes
    double position[3];          ///< m, moved from where the case puts it
    double orientation[4];       ///< w, x, y, z: from the frame in which it was given to space
    double angle;                ///< rad, turned about its spin axis since that axis was set
    double velocity[3];          ///< m/s, of the whole wall, as set
    double surface_velocity[3];  ///< m/s, of its surface without motion of the wall, as set
    double spin;                 ///< rad/s about its spin axis, as set
    double angular_velocity[3];  ///< rad/s, the same as a vector along the axis
    double material_velocity[3]; ///< m/s: velocity, load servo, oscillation, surface_velocity;
                                 ///< without rotation and the belts of shapes
    double material_spin;        ///< rad/s about its spin axis: spin, oscillation
    double force[3];             ///< N, last step
    double torque[3];            ///< N m about the spin point, last step
    double power;                ///< W done by the wall on the grains, last step
    double mean_force[3];        ///< N, mean over the steps since clod_sim_reset_wall_means
    double mean_torque[3];       ///< N m, likewise
    double mean_power;           ///< W, likewise
    int64_t mean_steps;          ///< so many steps; 0: the means are 0
    bool loaded;                 ///< a load moves it (force or stress)
    double load;                 ///< N that it aims at; 0 without
} clod_sim_wall;

int32_t clod_sim_wall_count(const clod_sim *self);

/** Index of a wall by name, or -1; it stays the same as long as no wall comes or goes. */
int32_t clod_sim_wall_index(const clod_sim *self, const char *name);

/**
 * Look at a wall.
 *
 * @param wall  index, 0 to clod_sim_wall_count - 1
 * @param view  [out] copy of the moment
 * Errors  CLOD_USAGE: no such wall.   Test  tests/sim/test_sim.c
 */
bool clod_sim_wall_look(const clod_sim *self, int32_t wall, clod_sim_wall *view,
                        clod_status *status);

/**
 * Drive a wall from now on: velocity of the whole wall [m/s], velocity of its surface without
 * motion of the wall (belt) [m/s], rotation about its spin axis [rad/s], force of its load [N].
 * These are velocity, surface_velocity, spin and load of clod_sim_wall.
 *
 * A load that rises is held to the critical time step, as that of a wall that comes: this looks
 * once at all grains. One that falls costs nothing.
 *
 * Errors  CLOD_USAGE: no such wall, a number that is not finite, a plane that would turn out of
 *         itself, a load below 0, a load on a wall that came without one, a time step beyond the
 *         critical one under the load; CLOD_FAILED: memory; nothing is changed.
 * Test    tests/sim/test_sim.c, tests/sim/test_sim_wall_loads.c
 */
bool clod_sim_set_wall_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                clod_status *status);
bool clod_sim_set_wall_surface_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                        clod_status *status);
bool clod_sim_set_wall_spin(clod_sim *self, int32_t wall, double spin, clod_status *status);
bool clod_sim_set_wall_load(clod_sim *self, int32_t wall, double force, clod_status *status);

/**
 * How the material of a shape moves while the shape stays where it is: a belt, on top of the
 * motion of its wall and of the wall's surface velocity. Vectors are in the frame in which the
 * wall was given (after rotate and move of a case) and turn with the wall. All zero: none.
 */
typedef struct clod_sim_belt {
    double velocity[3];   ///< m/s, the same everywhere
    double speed;         ///< m/s along the projection of `direction` onto the surface
    double direction[3];  ///< made to length 1; not zero when there is a speed
    double spin;          ///< rad/s about spin_axis through spin_point
    double spin_axis[3];  ///< made to length 1; not zero when there is a spin
    double spin_point[3]; ///< m
} clod_sim_belt;

/**
 * Drive the belt of one shape from now on; the case may give the shape one to begin with.
 *
 * @param shape  number in the wall, from 0
 * @param belt   what is normal to the surface moves nothing
 * Errors  CLOD_USAGE: no such wall or shape, a number that is not finite, a speed without
 *         direction, a spin without axis; nothing is changed.
 * Source  docs/theory/walls.md.   Test  tests/sim/test_sim_belts.c
 */
bool clod_sim_set_belt(clod_sim *self, int32_t wall, int32_t shape, const clod_sim_belt *belt,
                       clod_status *status);

/** Look at the belt of a shape; directions have length 1 or are zero. Errors as above. */
bool clod_sim_belt_look(const clod_sim *self, int32_t wall, int32_t shape, clod_sim_belt *belt,
                        clod_status *status);

/**
 * Turn a wall at once to an orientation: the unit quaternion w, x, y, z (Hamilton) from the
 * frame in which its shapes were given to space, about the point of its spin axis (which moves
 * with the wall). With clod_sim_set_wall_position this is any pose.
 *
 * @param orientation  [4]; made to length 1
 * Errors  CLOD_USAGE: no such wall, numbers that are not finite or all 0, a wall that
 *         oscillates; nothing is changed.   Test  tests/sim/test_sim_walls.c
 */
bool clod_sim_set_wall_orientation(clod_sim *self, int32_t wall, const double orientation[4],
                                   clod_status *status);

/**
 * Let a wall turn with an angular velocity about a point from now on; it stays where it is.
 *
 * A new axis or point costs a rebuild of the neighbour lists, another speed does not.
 *
 * @param velocity  [3] rad/s; 0 stops the rotation and leaves the axis as it is
 * @param point     [3] m, in space
 * Errors  CLOD_USAGE: no such wall, a number that is not finite, a plane that would turn out of
 *         itself, a wall that oscillates; nothing is changed.   Test  tests/sim/test_sim_walls.c
 */
bool clod_sim_set_wall_angular_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                        const double point[3], clod_status *status);

/**
 * Put a wall elsewhere at once; what it meets there it overlaps.
 *
 * @param position  m from where the case puts it
 * Errors  CLOD_USAGE: no such wall, a number that is not finite, a wall that oscillates;
 *         CLOD_FAILED: memory.   Test  tests/sim/test_sim.c
 */
bool clod_sim_set_wall_position(clod_sim *self, int32_t wall, const double position[3],
                                clod_status *status);

/**
 * Ask for a wall to come, as clod_sim_add_grain. It begins as a wall of a case does that starts at this
 * moment: where its shapes are given, its load servo at rest. The damping of a load follows from the
 * bed that is there once all requests are done, without those grains that go; on no grains there
 * is none. Phase of an oscillation and start-up of belts are those of the simulation's time, as in
 * the case: the wall comes to a sin(2 pi f t + phase), t from the start of the simulation.
 *
 * @param wall  as in a case (clod/case.h), with a name of its own; spin_axis, load_axis and direction
 *              of the oscillation are those of a case that does not say, where they are zero; borrowed
 * Errors  CLOD_USAGE: an unknown material; a plane that would turn out of itself; a number of its
 *         motion, load or oscillation out of the range that its key has in a case (clod explain
 *         walls); an oscillation that moves nothing, or along its load; a stress without an
 *         area; a period shorter than 50 steps, a name
 *         that a measure of an open series needs (clod_sim_open_series). By what does the changes:
 *         a name that is taken or unknown, a material without a contact law for the grains, a time
 *         step beyond the critical one with it, under its load.
 * Test    tests/sim/test_sim_change.c, tests/sim/test_sim_wall_loads.c
 */
bool clod_sim_add_wall(clod_sim *self, const clod_case_wall *wall, clod_status *status);

/**
 * The same from a text, read and checked as the wall of a case file.
 *
 * @param name  of the wall
 * @param text  YAML (or JSON): what stands below the name of a wall in a case; ends with a zero
 *              byte; not needed after the call
 * Errors  CLOD_USAGE: all that is wrong in the text, by line and column; as clod_sim_add_wall.
 * Test    tests/sim/test_sim_wall_text.c
 */
bool clod_sim_add_wall_from_text(clod_sim *self, const char *name, const char *text,
                                 clod_status *status);

/**
 * Ask for a wall to go, as clod_sim_remove_grain; indices of the others change.
 *
 * Errors  as clod_sim_remove_grain; CLOD_USAGE: a measure of an open series needs it
 *         (clod_sim_open_series).   Test  tests/sim/test_sim_change.c, tests/sim/test_sim_series.c
 */
bool clod_sim_remove_wall(clod_sim *self, const char *name, clod_status *status);

/** Begin the means of force, torque and power of all walls anew. */
void clod_sim_reset_wall_means(clod_sim *self);

#ifdef __cplusplus
}
#endif
