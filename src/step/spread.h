#pragma once
/**
 * @file spread.h
 * A bed spread over ranks, as one of them sees it: its own grains and ghosts, which are grains of
 * other ranks that own ones may touch before the next rebuild. A ghost is a row like any other,
 * in the one order of all grains (docs/adr/0038); its load is not read.
 *
 * Threads  thread 0 of each rank, all ranks at the same time, where not said otherwise.
 * Test     tests/step/test_ranks.c
 */

#include "parallel/fixed.h"
#include "parallel/ranks.h"
#include "step/balance.h"
#include "step/layers.h"
#include "step/leavers.h"
#include "step/partition.h"
#include "step/records.h"
#include "step/step.h"

/** Ghosts of every step: rows that go to and come from each rank. */
typedef struct clod_ghosts {
    int32_t *out, *in;            ///< rows, by rank; ascending for each
    size_t *out_start, *in_start; ///< [ranks + 1] first of each rank
    double *sent, *got;           ///< numbers of these rows
    clod_message *message;        ///< [2 * ranks]
    size_t out_room, in_room, sent_room, got_room;
} clod_ghosts;

/** What ranks tell each other in a step, behind the force on each wall in the step before. */
typedef struct clod_spread_sums {
    _Alignas(64) double max_speed2; ///< m2/s2, of the grains as they drift
    int64_t finite;                 ///< whether their numbers are
    int64_t excess;                 ///< an overlap beyond the laws' range, in the step before
    int64_t used_up;                ///< a grain has left its course by more than its own skin
    clod_step_heat dissipated;      ///< in the step before; sent with the ledger only
} clod_spread_sums;

/** What a contact did to a surface in a step (spread_wear.h). */
typedef struct clod_wear_record clod_wear_record;

/** Owner of a grain that leaves. */
#define CLOD_SPREAD_NOBODY (-1)

typedef struct clod_spread {
    clod_ranks *ranks;        ///< borrowed
    clod_layers_extent bed;   ///< of all grains, at the last rebuild
    clod_layers layers;       ///< of it
    clod_partition partition; ///< of the last cut
    clod_balance balance;
    int32_t *owner;  ///< [rows] rank of each grain; NULL: all are this rank's
    clod_chunk *run; ///< [runs] rows that are this rank's
    size_t runs, owner_room, run_room;
    int *reached;             ///< [ranks] scratch
    clod_separated separated; ///< at the last rebuild
    bool adrift; ///< on all ranks: rows have moved, and whose they are is not listed
    clod_ghosts ghosts;
    clod_fixed *wall_sum; ///< [walls] of each wall in a step, and behind it clod_spread_sums
    int32_t walls;
    bool sums_due; ///< what the step before did to walls and ledger is still to be added up
    // with the sums of surfaces
    clod_wear_record *wear; ///< [wear_count] of this step
    size_t wear_count, wear_room;
    clod_bytes *wear_out; ///< [ranks]
    clod_bytes wear_in;
    size_t *wear_begin; ///< [ranks + 1]
    bool wear_lost;     ///< some could not be added
} clod_spread;

/** Empty, with room for the forces on so many walls; on failure on any rank false on all. */
bool clod_spread_init(clod_spread *self, clod_ranks *ranks, int32_t walls, clod_status *status);

/**
 * Note the partition of the rows, which are in order: own runs, and who sends which to whom.
 *
 * @return  false without memory, on all ranks alike
 */
bool clod_spread_list(clod_spread *self, const clod_state *state, double skin,
                      clod_status *status);

/** Numbers of position, velocity and angular velocity each. */
enum { CLOD_SPREAD_VECTOR = 3 };

/** Numbers that are sent of a row: these three vectors, and with the ledger the load before. */
static inline size_t clod_spread_numbers(const clod_state *state)
{
    const size_t before = sizeof *state->grains.before / sizeof(double);
    return 3 * (size_t)CLOD_SPREAD_VECTOR + (state->grains.before != NULL ? before : 0);
}

/** Layers of the whole bed by state->build_position, and the boxes of ranks in it: cut anew if their
 *  work asks for it. Own rows are those of self->owner. */
void clod_spread_cut(clod_spread *self, const clod_state *state);

/** Ranks that a grain may matter to until the next rebuild, its own too; how many. [ranks] [out] */
int clod_spread_reach(const clod_spread *self, const clod_domain *domain, const double place[4],
                      double skin, int *rank);

/** Whether it went well on all ranks, see clod_ranks_agree; with NULL there is this one alone. */
static inline bool clod_spread_agree(const clod_spread *self, bool good, clod_status *status)
{
    return self == NULL ? good : clod_ranks_agree(self->ranks, good, status);
}

/** Room for so many rows; those behind the present ones are this rank's. False on this rank alone
 *  without memory. */
bool clod_spread_make_room(clod_spread *self, clod_state *state, size_t rows,
                           clod_status *status);

/** Whether no grain of any rank has the id of one in the queue of rank 0; on all alike. */
bool clod_spread_check_ids(clod_spread *self, const clod_state *state, clod_status *status);

/** Rows of ghosts as they are at their owners between two steps, whole kicks and all. */
void clod_spread_refresh(const clod_spread *self, clod_state *state);

/** Rows of ghosts, in a column of whole numbers of 8 bytes and up to 72 a row, as they are at their
 *  owners. */
void clod_spread_share(const clod_spread *self, void *column, size_t size);

/** Speed of the fastest own grain of all ranks, or of the fastest point of a wall [m/s]. */
double clod_spread_fastest(const clod_step *step);

/** Grains that leave at a rebuild, of all ranks: neighbour.rank marks those of the rows here. */
void clod_spread_mark_leavers(clod_step *step, const clod_leavers_outlets *outlets,
                              double half_kick, clod_leavers *sums);

/** Those that are marked have no owner from now on. */
void clod_spread_disown(clod_step *step);

/**
 * A rebuild, up to the search: grains, which are in the domain, migrate with their contacts in
 * state->contacts; rows and contacts are in order then.
 *
 * @param speed  of the fastest grain or point of a wall [m/s]
 * @return       false without memory, on all ranks alike
 */
bool clod_spread_rebuild(clod_step *step, double speed, clod_status *status);

/** After rows are sorted as at their last rebuild: what follows from the partition. */
bool clod_spread_sorted(clod_step *step, clod_status *status);

/** Drop the candidates that no own grain has. Threads: one. */
void clod_spread_leave_out(const clod_spread *self, clod_neighbour *neighbour, size_t rows);

/** The least of the numbers of all ranks. */
double clod_spread_least(const clod_spread *self, double number);

/** After the last step: add up what it did to walls and ledger. Threads: thread 0 of each rank. */
void clod_spread_settle(clod_step *step);

/** The trouble of all ranks that one process would tell, on all. */
void clod_spread_merge_trouble(clod_step *step);

/** Energies of all ranks; with NULL they are this one's alone. */
void clod_spread_merge_stored(const clod_spread *self, clod_step_stored *sums);

/** Whether a grain is this rank's. Threads: any. */
static inline bool clod_spread_owns(const clod_spread *self, int32_t row)
{
    return self->owner[row] == self->ranks->rank;
}

/** The same where a rank may have all rows. */
static inline bool clod_spread_has(const clod_spread *self, size_t row)
{
    return self->owner == NULL || clod_spread_owns(self, (int32_t)row);
}

/** The own rows of a run that are in a chunk. Threads: any. */
static inline clod_chunk clod_spread_run(const clod_spread *self, size_t run, clod_chunk rows)
{
    const clod_chunk all = self->run[run];
    return (clod_chunk){all.begin > rows.begin ? all.begin : rows.begin,
                        all.end < rows.end ? all.end : rows.end};
}

void clod_spread_fini(clod_spread *self);
