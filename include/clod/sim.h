#pragma once
/**
 * @file sim.h
 * A simulation in the hands of another program: made from a case, advanced by a number of
 * steps, read and changed between them. docs/library.md has a whole program.
 *
 * SI units throughout. A function that can fail returns false or NULL and fills its status; a
 * NULL where an argument is needed is such a failure, with the names of function and argument.
 * Functions without a status stop the program instead, naming both.
 *
 * Threads: any number of simulations at the same time, each used by one thread at a time. The
 * threads that a simulation computes with are its own affair (clod_sim_options).
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A simulation; its content is hidden. */
typedef struct clod_sim clod_sim;

typedef struct clod_sim_options {
    int threads;      ///< 0 = as many of all processors as pay
    const char *simd; ///< instruction set: scalar, avx2, avx512, neon; NULL = the best
} clod_sim_options;

/**
 * Make the state that a case begins with; forces of step 0 are computed.
 *
 * Stages, series and stop criteria are those of `clod run`; here the caller decides what
 * happens when. Walls begin with their own motion and load, adhesion is that of the first
 * stage. A case with a tester gives the filled cell of the tester without its procedure.
 *
 * @param from     checked case, borrowed until clod_sim_destroy
 * @param options  NULL = all defaults
 * @return         owned (clod_sim_destroy), or NULL
 * Errors  CLOD_USAGE: the case cannot be built, or has no grains; CLOD_FAILED: memory.
 * Threads safe.   Test  tests/sim/test_sim.c
 */
clod_sim *clod_sim_create(const clod_case *from, const clod_sim_options *options,
                          clod_status *status);

/** The same from a case file, read as by clod_case_load; the simulation owns the case. */
clod_sim *clod_sim_create_from_file(const char *path, const clod_sim_options *options,
                                    clod_status *status);

/**
 * The same from the text of a case.
 *
 * @param name  used in messages; files that the case names are relative to its folder
 * @param text  YAML, ends with a zero byte; not needed after the call
 */
clod_sim *clod_sim_create_from_text(const char *name, const char *text,
                                    const clod_sim_options *options, clod_status *status);

/** Free a simulation and null the pointer; NULL is fine. */
void clod_sim_destroy(clod_sim **self);

// ---- time

/**
 * Advance by a number of steps; the same bits for any number of threads and however the steps
 * are divided among calls.
 *
 * @param steps  >= 0
 * Errors  CLOD_FAILED: a number that is not finite, an overlap beyond the range of the laws, a
 *         grain that left the domain: the text names grain and step.
 * Test    tests/sim/test_sim.c
 */
bool clod_sim_advance(clod_sim *self, int64_t steps, clod_status *status);

double clod_sim_time(const clod_sim *self);  ///< s simulated
double clod_sim_dt(const clod_sim *self);    ///< s, time step
int64_t clod_sim_step(const clod_sim *self); ///< steps done since the case began

/** Adhesion (k_adh and other pulls) as a fraction of the case's value, 0 to 1, from now on. */
bool clod_sim_set_adhesion(clod_sim *self, double fraction, clod_status *status);

// ---- grains

typedef enum clod_sim_type {
    CLOD_SIM_F64, ///< double
    CLOD_SIM_U64, ///< uint64_t
    CLOD_SIM_U16, ///< uint16_t
} clod_sim_type;

/** A property of all grains, where it lies in memory: no copy is made. */
typedef struct clod_sim_view {
    const char *name; ///< static
    const char *unit; ///< static, as in case files; "1" for a plain number
    clod_sim_type type;
    size_t rows;       ///< grains
    size_t components; ///< 1 or 3 numbers for each grain
    size_t stride;     ///< bytes from one grain's to the next one's
    bool writable;     ///< false: it must not be written
    void *data;        ///< first grain's; numbers of one grain lie side by side
} clod_sim_view;

size_t clod_sim_grain_count(const clod_sim *self);

/**
 * Look at a property of the grains.
 *
 *   position [m], velocity [m/s], angular_velocity [rad/s]     3 numbers, may be written
 *   force [N], torque [N m]    3 numbers, may be written: sums of the last step with the weight
 *   radius [m], mass [kg], inverse_inertia [1/(kg m2)]         1 number
 *   id [1] (uint64_t, never changes), material [1] (uint16_t, index in the case)
 *
 * A view and the numbers of the rows are valid until the next clod_sim_advance, change,
 * energies, contacts, measure, file or destruction: the neighbour search sorts the rows. A
 * grain is told by its id. Positions may lie outside a periodic domain by less than a period.
 *
 * Velocities count from the next step on, without more ado. After writing positions call
 * clod_sim_positions_changed. What is written to force or torque acts in the first half of the
 * next step; every step computes them anew.
 *
 * @param view  [out] unchanged on failure
 * Errors  CLOD_USAGE: no such name; the text lists all.   Test  tests/sim/test_sim.c
 */
bool clod_sim_array(clod_sim *self, const char *name, clod_sim_view *view, clod_status *status);

/** Number of properties, and the name of each; NULL beyond the last. */
size_t clod_sim_array_count(void);
const char *clod_sim_array_name(size_t index);

/** Numbers of row `row` of a view of doubles; as clod_sim_array, valid as long as the view. */
static inline double *clod_sim_row(const clod_sim_view *view, size_t row)
{
    return (double *)(void *)((char *)view->data + row * view->stride);
}

/**
 * Row of a grain now; a walk over all rows.
 *
 * @return  row, or SIZE_MAX when there is no grain with this id
 */
size_t clod_sim_row_of_id(const clod_sim *self, uint64_t id);

/** A grain that is to come. */
typedef struct clod_sim_grain {
    uint64_t id;                ///< no other grain has it
    double position[3];         ///< m
    double radius;              ///< m
    double velocity[3];         ///< m/s
    double angular_velocity[3]; ///< rad/s
    size_t material;            ///< index in the case; its density gives mass and inertia
} clod_sim_grain;

/**
 * Ask for a grain to come, or for one to go. All that was asked for, of grains and walls, is
 * done together before the next step, energies, contacts or file, or by clod_sim_change; what
 * goes goes first. The order of requests changes no bit. When one of them is wrong, none is done
 * and all are dropped.
 *
 * The time step stays that of the case. What comes and would make it unstable is refused: give
 * time.step in the case when much smaller grains or stiffer walls come.
 *
 * Errors  CLOD_USAGE: no such material; a time step beyond the critical one with this grain, under
 *         the load that the case began with. An id that is taken or unknown, a position outside of
 *         the domain, numbers that are not finite: by what does the changes, which then does none.
 * Test    tests/sim/test_sim_change.c
 */
bool clod_sim_add_grain(clod_sim *self, const clod_sim_grain *grain, clod_status *status);
bool clod_sim_remove_grain(clod_sim *self, uint64_t id, clod_status *status);

/**
 * Do what was asked for now. Views, rows and indices of walls are not valid any more.
 *
 * Errors  CLOD_USAGE: a request is wrong, and nothing has changed; CLOD_FAILED: memory.
 */
bool clod_sim_change(clod_sim *self, clod_status *status);

/**
 * Say that positions have been written: the next step looks for neighbours anew. Contacts that
 * are still closed keep their history.
 *
 * The forces of the last step act in the first half of the next one; for a grain that was in
 * contact, write its force too if that matters.
 *
 * Errors  CLOD_USAGE: a position that is not finite; CLOD_FAILED: memory.
 * Test    tests/sim/test_sim.c
 */
bool clod_sim_positions_changed(clod_sim *self, clod_status *status);

// ---- contacts

/** A closed contact and its history; docs/theory says what a law keeps in it. */
typedef struct clod_sim_contact {
    uint64_t id_1;    ///< of the grain
    uint64_t id_2;    ///< of the other grain; 0 for a wall
    size_t row_1;     ///< row of the grain now
    size_t row_2;     ///< row of the other grain now; 0 for a wall
    int32_t wall;     ///< index of the wall; -1: another grain
    int32_t shape;    ///< of the wall; -1: another grain
    double plastic;   ///< m^n, plastic overlap^n; luding: largest overlap [m]
    double tangent;   ///< N/m, loading tangent of the last step
    double spring[3]; ///< m, tangential spring of grain 1 against its partner
    double roll[3];   ///< rad, rolling spring of grain 1 against its partner
} clod_sim_contact;

/**
 * All closed contacts: those between grains first, then those with walls.
 *
 * @param contacts  [out] [count], owned by the simulation; valid until the next call that takes
 *                  a clod_sim that is not const
 * @param count     [out]
 * Errors  CLOD_FAILED: memory.   Test  tests/sim/test_sim.c
 */
bool clod_sim_contacts(clod_sim *self, const clod_sim_contact **contacts, size_t *count,
                       clod_status *status);

// ---- walls

/** A wall as it is now. Forces and torques are those of the grains on the wall. */
typedef struct clod_sim_wall {
    const char *name;      ///< valid as long as the simulation
    double position[3];    ///< m, moved from where the case puts it
    double orientation[4]; ///< w, x, y, z: from the frame in which it was given to space
    double angle;          ///< rad, turned about its spin axis since that axis was set
    double velocity[3]; ///< m/s, of the wall's material: motion, load servo, oscillation, belt
    double spin;        ///< rad/s about its spin axis
    double force[3];    ///< N, last step
    double torque[3];   ///< N m about the spin point, last step
    double power;       ///< W done by the wall on the grains, last step
    double mean_force[3];  ///< N, mean over the steps since clod_sim_reset_wall_means
    double mean_torque[3]; ///< N m, likewise
    double mean_power;     ///< W, likewise
    int64_t mean_steps;    ///< so many steps; 0: the means are 0
    bool loaded;           ///< a load moves it (force or stress in the case)
    double load;           ///< N that it aims at; 0 without
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
 *
 * Errors  CLOD_USAGE: no such wall, a number that is not finite, a plane that would turn out of
 *         itself, a load on a wall that has none in the case.   Test tests/sim/test_sim.c
 */
bool clod_sim_set_wall_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                clod_status *status);
bool clod_sim_set_wall_surface_velocity(clod_sim *self, int32_t wall, const double velocity[3],
                                        clod_status *status);
bool clod_sim_set_wall_spin(clod_sim *self, int32_t wall, double spin, clod_status *status);
bool clod_sim_set_wall_load(clod_sim *self, int32_t wall, double force, clod_status *status);

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
 * Ask for a wall to come or go, as clod_sim_add_grain.
 *
 * @param wall  as in a case (clod/case.h), with a name of its own and without a load; borrowed
 * Errors  CLOD_USAGE: an unknown material, a load, a plane that would turn out of itself, a
 *         time step beyond the critical one with its material; a name that is taken or unknown: by what does the changes.
 * Test    tests/sim/test_sim_change.c
 */
bool clod_sim_add_wall(clod_sim *self, const clod_case_wall *wall, clod_status *status);
bool clod_sim_remove_wall(clod_sim *self, const char *name, clod_status *status);

/** Begin the means of force, torque and power of all walls anew. */
void clod_sim_reset_wall_means(clod_sim *self);

// ---- measures

/** Energies now [J]; potential: weight, zero at the origin; the last three: in contacts. */
typedef struct clod_sim_energy {
    double translation, rotation, potential, normal, sliding, rolling;
} clod_sim_energy;

/** Errors  CLOD_FAILED: memory.   Test  tests/sim/test_sim.c */
bool clod_sim_energies(clod_sim *self, clod_sim_energy *energy, clod_status *status);

/** What the contacts say about the bed. */
typedef struct clod_sim_bed {
    size_t pairs, walls; ///< closed contacts between grains, and with walls
    double coordination; ///< mean number of other grains that a grain touches
    double max_overlap;  ///< of grain pairs, as a fraction of the smaller radius
    double mean_overlap; ///< likewise
    double max_speed;    ///< m/s, fastest grain
} clod_sim_bed;

/** Errors  CLOD_FAILED: memory.   Test  tests/sim/test_sim.c */
bool clod_sim_measure(clod_sim *self, clod_sim_bed *bed, clod_status *status);

// ---- files

/**
 * Write a checkpoint into a results folder (docs/results-folder.md), the older of two in turn.
 *
 * @param folder  made if need be; one that another run is writing into, or with files of
 *                others, is refused
 * Errors  CLOD_USAGE: the folder; CLOD_FAILED: disk, memory; checkpoints of before are untouched.
 * Test    tests/sim/test_sim.c
 */
bool clod_sim_write_checkpoint(clod_sim *self, const char *folder, clod_status *status);

/**
 * Go on from the newest whole checkpoint in a folder, which this library or `clod run` wrote
 * for the same case; the next steps have the bits of a simulation that was never interrupted.
 *
 * @param part  of a test whose checkpoint it is, such as "fill"; NULL: of a free run or of
 *              clod_sim_write_checkpoint
 * Errors  CLOD_USAGE: another case; CLOD_FAILED: no whole checkpoint; the simulation is as it
 *         was. CLOD_FAILED without memory for the lists: it can only be destroyed.
 * Test    tests/sim/test_sim.c
 */
bool clod_sim_read_checkpoint(clod_sim *self, const char *folder, const char *part,
                              clod_status *status);

/**
 * Write grains and walls for ParaView into a results folder, named by the step.
 *
 * @param contacts  also the contacts between grains
 * Errors  as clod_sim_write_checkpoint.   Test  tests/sim/test_sim.c
 */
bool clod_sim_write_snapshot(clod_sim *self, const char *folder, bool contacts,
                             clod_status *status);

#ifdef __cplusplus
}
#endif
