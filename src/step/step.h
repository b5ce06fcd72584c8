#pragma once
/**
 * @file step.h
 * The step: everything that happens between two moments of a simulation, and the scratch it
 * needs. The state itself is in state/state.h.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "law/law.h"
#include "measure/survey.h"
#include "parallel/barrier.h"
#include "parallel/exact.h"
#include "parallel/ranks.h"
#include "state/bed_source.h"
#include "state/state.h"
#include "step/balance.h"
#include "step/kernel.h"
#include "step/layer_order.h"
#include "step/near.h"
#include "step/near_reader.h"
#include "step/outlet_shapes.h"
#include "step/reorder.h"

/** Largest overlap the laws are meant for, as a fraction of the smaller radius. */
#define CLOD_STEP_OVERLAP 0.2

typedef struct clod_step_options {
    int threads;          ///< 0 = all processors
    const char *simd;     ///< instruction set, NULL = best
    bool brute_force;     ///< neighbour search over all pairs (tests)
    double overlap_limit; ///< of the smaller radius, at which to stop; 0 = CLOD_STEP_OVERLAP
    /** Whether laws and time step suit what state->changes brings, before it is done; its loaded
     *  walls get their damping (clod_setup_bound_accepts); NULL: nobody asks. */
    bool (*accepts)(const void *context, const clod_state *state, clod_status *status);
    const void *context;          ///< of accepts; borrowed until clod_step_fini
    clod_balance_options balance; ///< of several ranks
    clod_ranks *ranks; ///< that step the bed together; borrowed; NULL: this process alone
    /** The state has rank 0's share of the rows alone, here is what else it was dealt (crew_deal.h), which
     *  is taken; NULL: the state has all. */
    struct clod_crew_share *dealt;
    struct clod_spread *spread; ///< the state is this rank's part of a bed (crew.h); borrowed
} clod_step_options;

/** What contacts turned into heat in one step [J]. */
typedef struct clod_step_heat {
    clod_exact plastic, dash_pot, friction, rolling, lag;
} clod_step_heat;

/** Energies of a moment as sums [J]: of grains, and what contacts store; `turning` by rolling
 *  springs. */
typedef struct clod_step_stored {
    clod_exact translation, rotation, potential;
    clod_exact normal, sliding, turning;
} clod_step_stored;

/** What one thread keeps to itself, on its own cache lines; motions are the same in all. */
typedef struct clod_step_thread {
    _Alignas(64) double max_speed2; ///< m2/s2, of its grains (and of the walls: thread 0)
    double build_motion;            ///< m, bound of any motion since the last rebuild
    double age;                     ///< s, of the near list
    double gone, off_course; ///< m, sums of what looks have seen since then (near_skins.h)
    double wall_motion;      ///< m, bound of walls' motion since the last near list
    double wall_speed;       ///< m/s, fastest of walls in this step (thread 0)
    bool used_up;            ///< a grain of its has left its course by more than its skin
    bool finite;             ///< its grains' numbers
    bool all_finite;         ///< those of all threads in this step
    bool excess;   ///< an overlap beyond the laws' range, with its contacts in this step
    bool late;     ///< the same with any thread or rank in a step before
    bool noted;    ///< it has been, in this advance
    bool stop;     ///< physics went wrong, with any thread: this step is the last
    bool kick_due; ///< its grains' second half kick is still to be done
    clod_step_heat dissipated; ///< by its contacts in this step, with the ledger
} clod_step_thread;

/** What goes through the making of lists (remake.h). */
typedef struct clod_step_remake {
    bool again;               ///< the candidates too: a rebuild
    bool changes;             ///< what state->changes asks for is done in it
    double speed;             ///< m/s, of the fastest point now
    size_t going;             ///< grains that go
    bool left;                ///< some leave through a way out
    const int32_t *wall_rank; ///< [walls] new numbers, -1: it goes; NULL: all stay; borrowed
    double before;            ///< J, energy before anything came or went
    _Atomic int failed;       ///< the phase that did, or one behind the last
    clod_layer_order order;
    clod_reorder reorder;
    clod_near_job job;
} clod_step_remake;

/** The deepest contact of the first step of an advance with an overlap beyond the laws' range. */
typedef struct clod_step_trouble {
    bool any;
    int64_t step;
    double fraction;    ///< of the smaller radius
    uint64_t id[2];     ///< of the grains; of a wall its number, from CLOD_TROUBLE_WALLS on
    clod_status status; ///< what is told of it
} clod_step_trouble;

/** A shape of a wall. */
typedef struct clod_step_shape {
    int32_t wall, shape;
} clod_step_shape;

typedef struct clod_step {
    clod_state *state;     ///< borrowed
    const clod_laws *laws; ///< borrowed; adhesion may change between calls of advance
    const clod_kernel *kernel;
    int threads;
    clod_barrier barrier;
    clod_step_thread *thread; ///< [threads]
    clod_gate *gate; ///< [near.parts] opened when a law's shares for earlier parts are there
    clod_gate *placed_gate;   ///< [threads] opened when a thread's shapes of walls are placed
    clod_neighbour neighbour; ///< candidates
    clod_near near;           ///< contact blocks
    clod_wall_rows walls;     ///< where they are in this step
    int32_t *moving;          ///< [moving_count] walls that can move
    int32_t *summed;          ///< [summed_count] walls with contacts, a load, or a force before
    int32_t moving_count, summed_count;
    clod_step_shape *placed; ///< [placed_count] shapes of moving walls with grains near
    size_t placed_count;
    clod_outlet_shapes outlets; ///< surfaces that remove grains
    uint8_t *is_near;           ///< scratch [shapes]: whether grains are near
    bool walls_finite;          ///< forces on walls in the last step
    clod_kernel_view view; ///< what the contact loops read; dt is 0 for a fresh state's forces
    clod_passed
        *passed; ///< [threads][planes] since the state has it; NULL: there are no planes
    clod_step_remake remake;
    int64_t begin; ///< step of the state when it was taken
    int64_t steps; ///< that the advance going on is to make
    bool (*accepts)(const void *context, const clod_state *state, clod_status *status);
    const void *context; ///< of accepts; both as in clod_step_options
    bool failed;         ///< a rebuild went wrong; status says why
    clod_status status;
    clod_step_trouble trouble;
    // for reports
    int64_t rebuilds, refreshes;
    struct clod_spread *spread; ///< NULL: all grains are in this process
    struct clod_crew *crew;     ///< ranks that step the bed in place of this process; or NULL
    void (*after_stage)(int part, int stage); ///< called by every thread; NULL: nobody asks
} clod_step;

/**
 * Get ready to advance a state; the forces of a fresh state are computed. With several ranks its rows
 * are theirs then: clod_step_see brings them.
 *
 * @param self     [out]
 * @param state    borrowed until clod_step_fini; the history of its contacts goes on
 * @param laws     borrowed
 * @return         false: no memory, unknown instruction set, or a state that cannot be
 * Errors  CLOD_FAILED, CLOD_USAGE.   Threads  one per state.
 */
bool clod_step_init(clod_step *self, clod_state *state, const clod_laws *laws,
                    const clod_step_options *options, clod_status *status);

/**
 * Advance by a number of steps of velocity Verlet.
 *
 * @return  false when physics went wrong: a number that is not finite, or an overlap beyond the laws'
 *          range in the step before, for which one step more is made than asked for where it was in
 *          the last one: the state is whole then; or a list that could not be made anew: then positions
 *          are one step ahead and forces are zero. The text names the grain and the step.
 * Errors  CLOD_FAILED.   Threads  uses options.threads; same bits for any number.
 */
bool clod_step_advance(clod_step *self, int64_t steps, clod_status *status);

/**
 * Make the changes of state->changes now, at a rebuild; the queue is empty then. An advance
 * with changes asked for begins with this.
 *
 * @return  false: an id or a name that is not right, a grain or wall that options.accepts
 *          refuses (nothing is changed then), or no memory
 * Errors  CLOD_USAGE, CLOD_FAILED.   Threads  one per state.   Test  tests/step/test_change.c
 */
bool clod_step_change(clod_step *self, clod_status *status);

/**
 * The same of grains that come into a bed spread over ranks: they are in the queue of rank 0, that
 * of the others is empty; their owners get them.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_ranks.c
 */
bool clod_step_take(clod_step *self, clod_status *status);

/**
 * Open the energy ledger of the state at this moment: from now on every step records what
 * contacts dissipate and walls do. It stays open in copies and checkpoints of the state.
 *
 * @return false without memory.   Threads  one per state.   Source  docs/theory/energy.md
 */
bool clod_step_open_ledger(clod_step *self, clod_status *status);

/** Kinetic, potential and stored energies now, with the walls where they are now; not a number
 *  after a list that could not be made: the next advance says why. */
clod_energies clod_step_energies(clod_step *self);

/** The sums of them, over what is in this process. */
void clod_step_store(clod_step *self, clod_step_stored *sums);

/** Forces of a state that nobody has stepped, when its lists are there: the stages without time
 *  passing. False when an overlap is beyond the laws' range. Threads: thread 0 of each rank. */
bool clod_step_first_forces(clod_step *self, clod_status *status);

/** Room for what the ledger needs in every step, which keeps it from now on. */
bool clod_step_keep_ledger(clod_step *self, clod_status *status);

/** Energy of the state for the ledger [J]; 0 when it is not open. */
double clod_step_balance(clod_step *self);

/** Book as exchanged what has been done to the energy since it was `before` [J], with the ledger
 *  open: something came, went or was set, which is no motion of grains. */
void clod_step_book(clod_step *self, double before);

/**
 * Copy all contacts that touch, with their histories of now, into state->contacts: ascending,
 * pairs before walls. The next advance empties that list.
 *
 * @return  false without memory
 * Errors  CLOD_FAILED.   Threads  one per state.   Test  tests/step/test_contact_identity.c
 */
bool clod_step_export(clod_step *self, clod_status *status);

/**
 * Bring the state to this moment, before somebody looks at its grains or contacts: several ranks
 * have them, one process has nothing to do.
 *
 * @return  false without memory
 * Errors  CLOD_FAILED.   Threads  one per state.   Test  tests/step/test_ranks.c
 */
bool clod_step_see(clod_step *self, clod_status *status);

/** Most boxes of clod_step_see_near. */
#define CLOD_STEP_BOXES 32

/**
 * The same of the grains that reach into some boxes, with margin or not: then the state may hold
 * them alone, in any order, without contacts; clod_step_see brings the others.
 *
 * @param box    [count] m; periodic images count
 * @param count  up to CLOD_STEP_BOXES
 * @return       false without memory
 * Errors  CLOD_FAILED.   Threads  one per state.   Test  tests/step/test_ranks.c
 */
bool clod_step_see_near(clod_step *self, const clod_domain_box *box, int count,
                        clod_status *status);

/** The same of the list of grains that have left (state->gone). */
bool clod_step_see_gone(clod_step *self, clod_status *status);

/**
 * Somebody has changed grains or shapes of walls in the state, which was seen: ranks get the bed
 * anew, with its lists of neighbours as of the last rebuild; one process has nothing to do.
 *
 * @return  false: no memory; then the step has failed for good
 * Errors  CLOD_FAILED.   Threads  one per state.   Test  tests/sim/test_sim_ranks.c
 */
bool clod_step_renew(clod_step *self, clod_status *status);

/**
 * The bed as one that can be asked for sums at this moment, wherever its grains are.
 *
 * @param contacts  of this step (clod_step_contacts), borrowed; NULL: nothing asks for them
 * Threads  one per state.   Test  tests/step/test_ranks_survey.c
 */
clod_survey clod_step_survey(clod_step *self, const clod_contact_source *contacts);

/** Number of grains of the whole bed, whoever has them. */
size_t clod_step_grains(const clod_step *self);

/** Where the reading of a step's contacts is. */
typedef struct clod_step_reader {
    clod_step *step;
    clod_near_reader blocks;
    clod_contact_list list; ///< when the step has no list
} clod_step_reader;

/**
 * All contacts that touch, with their histories of now, without a list of them: those that
 * clod_step_export copies.
 *
 * @param reader  [out] borrowed as long as the source is used: until the next advance
 * @return        source; one at a time of a step
 * Errors  none.   Threads  one per state.   Test  tests/step/test_contact_reader.c
 */
clod_contact_source clod_step_contacts(clod_step *self, clod_step_reader *reader);

/** Grains and contacts of a step on their way into a file. */
typedef struct clod_step_bed {
    clod_step_reader reader;
    clod_contact_source contacts;
    clod_bed_view view;
} clod_step_bed;

/**
 * All grains and contacts of this moment, slab by slab, wherever they are: the state need not have
 * them.
 *
 * @param self  [out] borrowed as long as the source is used: until the next advance
 * @return      source; one at a time of a step, and no other reader of its contacts beside it
 * Threads  one per state.   Test  tests/step/test_ranks_slabs.c
 */
clod_bed_source clod_step_bed_source(clod_step *step, clod_step_bed *self);

/**
 * History of one contact of two grains now, by their ids.
 *
 * @param id       ids of the grains, in any order
 * @param contact  [out] its rows and history, as met by id[0] against id[1]
 * @return         false: they do not touch, or there are no such grains
 * Errors  none.   Threads  one per state.   Test  tests/step/test_contact_identity.c
 */
bool clod_step_contact_of(const clod_step *self, const uint64_t id[2], clod_contact *contact);

/**
 * The same of a grain and a surface of a wall.
 *
 * @param wall, shape  their numbers in state->walls
 */
bool clod_step_wall_contact_of(const clod_step *self, uint64_t id, int32_t wall, int32_t shape,
                               clod_contact *contact);

/**
 * Own skins for a near list that is made now. The farther grains may go, the longer the list lasts
 * and the more of its pairs do not touch: these cost least.
 *
 * @param speed  of the fastest grain or point of a wall [m/s]
 * Errors  none.   Threads  pure.   Source  docs/adr/0037.   Test  tests/step/test_thin_skin.c
 */
clod_near_skins clod_step_skins(const clod_step *self, double speed);

/** A near list has been made outside of a step: motion counts from now on, for all threads. */
void clod_step_begin_motion(clod_step *self);

void clod_step_fini(clod_step *self);

// ---- lists of walls (wall_lists.c)

/** Before steps: which walls can move in them; rows of all walls for where they are. */
void clod_step_list_moving(clod_step *self);

/** After a near list is made: which walls a step adds up, and which shapes it moves. */
void clod_step_list_summed(clod_step *self);

/** After steps: how many went into the sums of every wall. */
void clod_step_count_steps(clod_step *self, int64_t steps);

// ---- stages, in the order of the table (stages.h); `part` is the thread's number

void clod_step_drift(clod_step *self, int part);
void clod_step_ghosts(clod_step *self, int part);
void clod_step_place(clod_step *self, int part);
void clod_step_near(clod_step *self, int part);
void clod_step_contact(clod_step *self, int part);
void clod_step_touch(clod_step *self, int part);
void clod_step_wall(clod_step *self, int part);
void clod_step_dissipate(clod_step *self, int part);
void clod_step_wear(clod_step *self, int thread);
void clod_step_servo(clod_step *self, int part);
void clod_step_ledger(clod_step *self, int part);

// ---- after the last one of a call

/** What has passed planes, onto the state. */
void clod_step_passages(clod_step *self, int part);

// ---- what stages of thread 0 do; where grains are spread over ranks, all of it in stage ghosts

/** Walls that can move do. */
void clod_step_move_walls(clod_step *self);

/** What the contacts of a step did to walls, and to those that are loaded. */
void clod_step_push_walls(clod_step *self);

/** What they dissipated, onto the ledger if there is one. */
void clod_step_add_ledger(clod_step *self);

/** The half kick that the last drift has left: in the next one, or after the last step. */
void clod_step_settle(clod_step *self, int part);
