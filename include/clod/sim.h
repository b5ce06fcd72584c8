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
#include "clod/ranks.h"
#include "clod/sim_series.h"
#include "clod/sim_walls.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct clod_sim_options {
    int threads; ///< 0 = as many of all processors as pay, and one in each of several ranks
    const char *simd;  ///< instruction set: scalar, avx2, avx512, neon; NULL = the best
    bool each_process; ///< where mpirun started several processes: this one has a simulation of
                       ///< its own, as the others may; otherwise that is refused
    clod_ranks *ranks; ///< that compute it together, one simulation at a time; this process is
                       ///< number 0 of them. Borrowed until clod_sim_destroy; NULL: none
} clod_sim_options;

/**
 * Make the state that a case begins with; forces of step 0 are computed.
 *
 * Stages, series and stop criteria are those of `clod run`; here the caller decides what
 * happens when. Walls begin with their own motion and load, adhesion is that of the first
 * stage. A case with a tester gives the filled cell of the tester without its procedure. A
 * case may have stages and no grains, which this program adds then; it must give `domain`,
 * `time.step` and `time.design_stress`.
 *
 * @param from     checked case, borrowed until clod_sim_destroy
 * @param options  NULL = all defaults
 * @return         owned (clod_sim_destroy), or NULL
 * Errors  CLOD_USAGE: the case cannot be built; several processes were started, and neither ranks nor
 *         each_process is given; another rank than number 0, or ranks that have a simulation already.
 *         CLOD_FAILED: memory.
 * Threads safe; with ranks the one that opened them, here and in every call of this simulation.
 * Test    tests/sim/test_sim.c, test_sim_processes.c, test_sim_ranks.c
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
 *         grain that left the domain: the text names grain and step. Memory, as
 *         clod_sim_change.
 * Test    tests/sim/test_sim.c
 */
bool clod_sim_advance(clod_sim *self, int64_t steps, clod_status *status);

double clod_sim_time(const clod_sim *self);  ///< s simulated
double clod_sim_dt(const clod_sim *self);    ///< s, time step
int64_t clod_sim_step(const clod_sim *self); ///< steps done since the case began

/**
 * Adhesion (k_adh and other pulls) as a fraction of the case's value, 0 to 1, from now on. What
 * this does to the energy that contacts store is booked as exchanged in an open ledger.
 */
bool clod_sim_set_adhesion(clod_sim *self, double fraction, clod_status *status);

// ---- grains

typedef enum clod_sim_type {
    CLOD_SIM_F64, ///< double
    CLOD_SIM_U64, ///< uint64_t
    CLOD_SIM_U16, ///< uint16_t
    CLOD_SIM_I32, ///< int32_t
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
 *   radius [m] (clod_sim_set_radii), mass [kg], inverse_inertia [1/(kg m2)]   1 number
 *   id [1] (uint64_t, never changes), material [1] (uint16_t, index in the case)
 *
 * A view and the numbers of the rows are valid until the next clod_sim_advance, change,
 * energies, contacts, contact_of, ledger, measure, file or destruction: the neighbour search
 * sorts the rows. On several ranks (clod_sim_options) the bed is gathered, once between two steps; the
 * view is one of a copy, and what was written into it goes to the ranks before the next step. When its
 * rows are no more what they were, it has NaN, and ids and materials that nobody has. A grain is told
 * by its id. Positions may lie outside a periodic domain by less
 * than a period.
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
 * Row of a grain now; a walk over all rows, which several ranks gather.
 *
 * @return  row, or SIZE_MAX when there is no grain with this id, or no memory to gather the bed
 */
size_t clod_sim_row_of_id(clod_sim *self, uint64_t id);

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
 * done together before the next step, energies, contacts, contact_of, ledger or file, or by
 * clod_sim_change; what goes goes first. The order of requests changes no bit. When one of them
 * is wrong, none is done and all are dropped.
 *
 * The time step stays that of the case. What comes and would make it unstable is refused: give
 * time.step in the case when much smaller grains or stiffer walls come.
 *
 * Errors  CLOD_USAGE: no such material. By what does the changes, which then does none: an id
 *         that is taken or unknown, a position outside of the domain, numbers that are not
 *         finite, a period too short for it; no contact law for what it can meet; a time step
 *         beyond the critical one with it, under the load of now.
 *         CLOD_FAILED: no memory for this request; those of before stay.
 * Test    tests/sim/test_sim_change.c, test_sim_memory.c
 */
bool clod_sim_add_grain(clod_sim *self, const clod_sim_grain *grain, clod_status *status);
bool clod_sim_remove_grain(clod_sim *self, uint64_t id, clod_status *status);

/**
 * Do what was asked for now. Views, rows and indices of walls are not valid any more.
 *
 * Errors  CLOD_USAGE: a request is wrong, and nothing has changed; CLOD_FAILED: memory. Without
 *         memory for the requests or the rows of grains nothing has changed either, and all
 *         requests are dropped. Without memory for the lists of contacts the simulation can
 *         only be destroyed or read from a checkpoint: until then every call that needs the
 *         lists gives this text again.
 * Test    tests/sim/test_sim_change.c, test_sim_memory.c
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

/**
 * Give the grains other radii, at once; masses and inertias follow with the densities of the
 * case, velocities stay. The next step looks for neighbours anew. Contacts that are still closed
 * keep their history; what overlaps more pushes more, from the second half of the next step on,
 * as with positions: grow by a little at a time what is in contact. The change of energy is
 * booked as exchanged in an open ledger.
 *
 * @param radii  [clod_sim_grain_count] m, in the order of the rows
 * Errors  CLOD_USAGE: one that is not finite or not above 0, a period too short for the largest,
 *         a time step beyond the critical one with these radii, requests that wait (call
 *         clod_sim_change first); CLOD_FAILED: memory. Nothing is changed then.
 * Test    tests/sim/test_sim_radii.c
 */
bool clod_sim_set_radii(clod_sim *self, const double *radii, clod_status *status);

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
 * Errors  as clod_sim_change; CLOD_FAILED: memory.   Test  tests/sim/test_sim.c
 */
bool clod_sim_contacts(clod_sim *self, const clod_sim_contact **contacts, size_t *count,
                       clod_status *status);

/**
 * Find the contact of two grains by their ids.
 *
 * The contact is as met by id_1 against id_2: spring and roll are those of grain id_1, row_1 is
 * its row. Asked for in the other order they change their signs, plastic and tangent do not
 * (clod_sim_contact_field.turns). clod_sim_contacts names each contact in one order only, which
 * may change when the rows are sorted.
 *
 * @param id_1, id_2  of the grains, in any order
 * @param contact     [out] unchanged when there is none
 * @param found       [out] false: the grains do not touch, are the same, or one of them is not
 *                    there (any more); this is no error
 * Cost    a walk over all grains.
 * Errors  a request that is wrong, as clod_sim_change.   Test  tests/sim/test_sim_contacts.c
 */
bool clod_sim_contact_of(clod_sim *self, uint64_t id_1, uint64_t id_2,
                         clod_sim_contact *contact, bool *found, clod_status *status);

/**
 * Find the contact of a grain with a shape of a wall.
 *
 * @param wall     index, 0 to clod_sim_wall_count - 1
 * @param shape    number in the wall, from 0
 * @param contact  [out] unchanged when there is none
 * @param found    [out] false: they do not touch, or there is no such grain (any more)
 * Errors  CLOD_USAGE: no such wall or shape; as clod_sim_contact_of.
 * Test    tests/sim/test_sim_contacts.c
 */
bool clod_sim_wall_contact_of(clod_sim *self, uint64_t id, int32_t wall, int32_t shape,
                              clod_sim_contact *contact, bool *found, clod_status *status);

/** A member of clod_sim_contact, for programs that do not know the struct. */
typedef struct clod_sim_contact_field {
    const char *name; ///< static
    const char *unit; ///< static; "1" for a plain number
    clod_sim_type type;
    size_t components; ///< numbers, side by side
    size_t offset;     ///< bytes from the beginning of the struct
    bool turns;        ///< changes its sign when the grains are named in the other order
} clod_sim_contact_field;

/** Number of members. */
size_t clod_sim_contact_field_count(void);

/**
 * Look at a member: those that say which contact it is, then all that a contact remembers.
 *
 * @param index  0 to clod_sim_contact_field_count() - 1
 * @param field  [out]
 * Errors  CLOD_USAGE: no such member.   Threads  safe.   Test  tests/sim/test_sim_contacts.c
 */
bool clod_sim_contact_field_look(size_t index, clod_sim_contact_field *field,
                                 clod_status *status);

// ---- measures

/** Energies now [J]; potential: weight, zero at the origin; the last three: in contacts. */
typedef struct clod_sim_energy {
    double translation, rotation, potential, normal, sliding, rolling;
} clod_sim_energy;

/** Errors  as clod_sim_change; CLOD_FAILED: memory.   Test  tests/sim/test_sim.c */
bool clod_sim_energies(clod_sim *self, clod_sim_energy *energy, clod_status *status);

/** What the contacts say about the bed. */
typedef struct clod_sim_bed {
    size_t pairs, walls; ///< closed contacts between grains, and with walls
    double coordination; ///< mean number of other grains that a grain touches
    double max_overlap;  ///< of grain pairs, as a fraction of the smaller radius
    double mean_overlap; ///< likewise
    double max_speed;    ///< m/s, fastest grain
} clod_sim_bed;

/** Errors  as clod_sim_change; CLOD_FAILED: memory.   Test  tests/sim/test_sim.c */
bool clod_sim_measure(clod_sim *self, clod_sim_bed *bed, clod_status *status);

/** Grains that left through one side of the domain (domain.open: delete). */
typedef struct clod_sim_left {
    int64_t grains;
    double mass;   ///< kg
    double energy; ///< J, kinetic, of rotation included
} clod_sim_left;

/** Sides of the domain. */
typedef enum clod_sim_side {
    CLOD_SIM_X_MIN,
    CLOD_SIM_X_MAX,
    CLOD_SIM_Y_MIN,
    CLOD_SIM_Y_MAX,
    CLOD_SIM_Z_MIN,
    CLOD_SIM_Z_MAX,
    CLOD_SIM_SIDES ///< how many there are
} clod_sim_side;

/** What has come and gone since the case began; requests count when they are done. */
typedef struct clod_sim_exchange {
    int64_t added, removed; ///< grains, by requests
    double added_mass;      ///< kg
    double removed_mass;    ///< kg
    int64_t walls_removed;
    clod_sim_left left[CLOD_SIM_SIDES]; ///< by clod_sim_side
} clod_sim_exchange;

/**
 * Look at what has come and gone: the numbers of `left` in summary.json.
 *
 * @param exchange  [out]
 * Errors  CLOD_USAGE: NULL.   Test  tests/sim/test_sim_ledger.c
 */
bool clod_sim_exchange_look(const clod_sim *self, clod_sim_exchange *exchange,
                            clod_status *status);

/** The energy ledger: what has gone since it was opened [J] (docs/theory/energy.md). */
typedef struct clod_sim_ledger {
    double plastic;   ///< lost by plasticity and adhesion
    double dash_pot;  ///< lost in dash-pots
    double friction;  ///< lost by sliding
    double rolling;   ///< lost by rolling resistance
    double lag;       ///< work beyond that of forces with an earlier velocity; either sign
    double wall_work; ///< done by the walls on the grains
    double exchanged; ///< brought in by what came, was put elsewhere or changed, less what left
    double residual;  ///< appeared from nowhere: 0 is right
} clod_sim_ledger;

/**
 * Open the energy ledger now, or begin it anew. It is open from the start when the case has
 * output.energy, and goes through checkpoints; a step takes longer with it.
 *
 * What the library does is booked: requests, adhesion, walls put elsewhere. What the caller
 * writes into arrays is not: it shows up in the residual.
 *
 * Errors  CLOD_USAGE: gravity along a periodic direction, in which potential energy has no
 *         value; CLOD_FAILED: memory.   Test  tests/sim/test_sim_ledger.c
 */
bool clod_sim_open_ledger(clod_sim *self, clod_status *status);

/**
 * Look at the ledger now: the numbers of energy.csv.
 *
 * @param ledger  [out]
 * Errors  CLOD_USAGE: it is not open; as clod_sim_energies.   Test  tests/sim/test_sim_ledger.c
 */
bool clod_sim_ledger_look(clod_sim *self, clod_sim_ledger *ledger, clod_status *status);

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
