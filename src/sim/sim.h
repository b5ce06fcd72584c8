#pragma once
/**
 * @file sim.h
 * Inside of the public clod_sim (clod/sim.h): a state, its step, and what is lent to the
 * caller.
 */

#include <pthread.h>

#include "base/given.h"
#include "clod/sim.h"
#include "law/law.h"
#include "parallel/ranks.h"
#include "sim/free_measures.h"
#include "state/state.h"
#include "step/step.h"

#define CLOD_SIM_ARRAYS 10 ///< properties of grains (sim_arrays.c)

/** What a column of the series is known by. */
typedef struct clod_sim_heading {
    int owner;                        ///< its measure
    char text[CLOD_FREE_COLUMN_TEXT]; ///< name and, behind a zero byte, unit
} clod_sim_heading;

/** A property of grains lent as a copy (sim_loans.c). */
typedef struct clod_sim_loan clod_sim_loan;

struct clod_sim {
    clod_case *owned;      ///< NULL: the case is borrowed
    const clod_case *from; ///< the case
    clod_step_options options;
    clod_state state;
    clod_laws laws;
    clod_step step;
    clod_sim_loan *loan[CLOD_SIM_ARRAYS]; ///< of several ranks; NULL: was never lent
    size_t lent[CLOD_SIM_ARRAYS];         ///< bytes of each that is valid now; 0: it is not
    bool written; ///< the state has what was written into loans, and ranks have not
    clod_sim_contact *contacts; ///< [contact_capacity] lent by clod_sim_contacts
    size_t contact_capacity;
    void *measures; ///< [measures_size] what the series remembers; NULL: it is not open
    size_t measures_size;
    clod_sim_column *columns;   ///< [column_count] lent by clod_sim_series_row
    clod_sim_heading *headings; ///< [column_count] of them
    size_t column_count;
    double *row;    ///< [row_count] values of the walls that there are now
    size_t *row_to; ///< [row_count] their columns; column_count: that of none
    size_t row_count;
    bool row_is_old; ///< walls may have come or gone since row was made
};

/** Cases, and walls from a text, are read one at a time. */
extern pthread_mutex_t clod_sim_case_lock;

/** Whether the three numbers are finite; else CLOD_USAGE. */
bool clod_sim_finite(const double numbers[3], const char *function, const char *name,
                     clod_status *status);

/** Whether there is a wall with this index; else CLOD_USAGE. */
bool clod_sim_has_wall(const clod_sim *self, int32_t wall, const char *function,
                       clod_status *status);

/** Whether there is such a wall, and it has a shape with this number; else CLOD_USAGE. */
bool clod_sim_has_shape(const clod_sim *self, int32_t wall, int32_t shape, const char *function,
                        clod_status *status);

/** Whether several ranks step it. */
static inline bool clod_sim_is_spread(const clod_sim *self)
{
    return self->options.ranks != NULL && self->options.ranks->size > 1;
}

/** Whether this rank may let ranks compute, and they do nothing else; else CLOD_USAGE. */
bool clod_sim_ranks_are_free(const clod_ranks *ranks, const char *function,
                             clod_status *status);

/** The ranks of a simulation leave: it can be read and destroyed. NULL is fine. */
void clod_sim_lose_ranks(clod_sim *self);

/** What the caller has written counts, and the changes that were asked for are made. */
bool clod_sim_settle(clod_sim *self, clod_status *status);

/** The same, and all contacts are in the state. */
bool clod_sim_hold(clod_sim *self, clod_status *status);

/** What the caller has written counts, and the energy for the ledger then (clod_step_balance). */
bool clod_sim_balance(clod_sim *self, double *energy, clod_status *status);

// ---- loans, of a bed that several ranks have (sim_loans.c)

/** Property number `array` as a view of the state, which was seen. */
clod_sim_view clod_sim_view_of(clod_sim *self, size_t array);

/**
 * Lend a copy, or the one that is lent already.
 *
 * @param view  [in,out] of the state; then of the copy
 */
bool clod_sim_lend(clod_sim *self, size_t array, clod_sim_view *view, clod_status *status);

/** Bring into the state what the caller has written. */
void clod_sim_fetch(clod_sim *self);

/** The same, and ranks get it. */
bool clod_sim_take(clod_sim *self, clod_status *status);

/** The state was changed behind views that stay valid, and has all that was written into them. */
void clod_sim_renew_loans(clod_sim *self);

/** Rows are no more what they were: views say so by numbers that are none. */
void clod_sim_recall(clod_sim *self);

void clod_sim_free_loans(clod_sim *self);

/**
 * Whether a wall of this name may come or go: no measure of an open series needs it.
 *
 * Errors  CLOD_USAGE: what needs it.
 */
bool clod_sim_wall_is_free(const clod_sim *self, const char *name, const char *function,
                           clod_status *status);

/** Steps with the measures of the open series, which act between them. */
bool clod_sim_advance_measured(clod_sim *self, int64_t steps, clod_status *status);

/** The measures take what the sums of walls have; the caller begins these anew. */
void clod_sim_sums_end(clod_sim *self);

/** Free what the series needs. */
void clod_sim_close_series(clod_sim *self);

/** Walls were put elsewhere, or radii changed, where the energy was `before` (clod_sim_balance):
 *  neighbours are looked for anew before all else, and the difference is booked then. */
void clod_sim_moved(clod_sim *self, double before);

/** Step for the state that is there; the laws get its adhesion. */
bool clod_sim_take_up(clod_sim *self, clod_status *status);
