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
#include "state/state.h"
#include "step/step.h"

#define CLOD_SIM_COLUMN_TEXT 128

/** What a column of the series is known by. */
typedef struct clod_sim_heading {
    int owner;                       ///< its measure
    char text[CLOD_SIM_COLUMN_TEXT]; ///< name and, behind a zero byte, unit
} clod_sim_heading;

struct clod_sim {
    clod_case *owned;      ///< NULL: the case is borrowed
    const clod_case *from; ///< the case
    clod_step_options options;
    clod_state state;
    clod_laws laws;
    clod_step step;
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

/** Changes that were asked for are made, and all contacts copied into the state. */
bool clod_sim_hold(clod_sim *self, clod_status *status);

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

/** Something moved that the step did not move: neighbours are looked for anew before all else.
 */
void clod_sim_moved(clod_sim *self);

/** Step for the state that is there; the laws get its adhesion. */
bool clod_sim_take_up(clod_sim *self, clod_status *status);
