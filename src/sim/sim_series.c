// The series of a simulation: what the case measures beside walls and grains, and its inlets.
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "sim/free_measures.h"
#include "sim/sim.h"

/** What the measures look at now. */
static clod_free_moment moment_of(clod_sim *self, const clod_survey *survey)
{
    return clod_free_measures_moment(self->measures, self->from, &self->state, survey);
}

bool clod_sim_wall_is_free(const clod_sim *self, const char *name, const char *function,
                           clod_status *status)
{
    char text[96];
    return self->measures == NULL ||
           !clod_free_measures_need(self->from, name, text, sizeof text) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: the series is open, and %s needs the wall '%s'; remove or add "
                            "it in a simulation without the series, or before it is opened",
                            function, text, name);
}

void clod_sim_close_series(clod_sim *self)
{
    clod_memory_free(self->measures);
    clod_memory_free(self->columns);
    clod_memory_free(self->headings);
    clod_memory_free(self->row);
    clod_memory_free(self->row_to);
    self->measures = NULL;
    self->columns = NULL;
    self->headings = NULL;
    self->row = NULL;
    self->row_to = NULL;
}

/** Column k of the walls that there are now: "gauge_chute.flow [kg/s]". */
static clod_sim_heading heading_of(const clod_sim *self, size_t k)
{
    clod_sim_heading heading = {.owner = clod_free_measures_owner(self->from, &self->state, k)};
    clod_free_measures_column(self->from, &self->state, k, heading.text, sizeof heading.text);
    return heading;
}

/** Names and units of the columns. */
static void name_columns(clod_sim *self)
{
    for (size_t k = 0; k < self->column_count; k++) {
        self->headings[k] = heading_of(self, k);
        char *text = self->headings[k].text;
        char *unit = strstr(text, " [");
        self->columns[k] = (clod_sim_column){.name = text, .unit = ""};
        if (unit != NULL) {
            *unit = '\0';
            unit[strcspn(unit + 2, "]") + 2] = '\0';
            self->columns[k].unit = unit + 2;
        }
    }
}

/** Number of the column with this heading; most often it is the next one. The name alone is not
 *  enough: force_z of a wall `surface_a` is named as that of the surface of a wall `a`. */
static size_t find_column(const clod_sim *self, const clod_sim_heading *heading, size_t next)
{
    const char *unit = strstr(heading->text, " [");
    const size_t length = unit != NULL ? (size_t)(unit - heading->text) : strlen(heading->text);
    for (size_t k = 0; k < self->column_count; k++) {
        const size_t at = (next + k) % self->column_count;
        const char *name = self->columns[at].name;
        if (self->headings[at].owner == heading->owner &&
            strncmp(name, heading->text, length) == 0 && name[length] == '\0') {
            return at;
        }
    }
    return self->column_count;
}

/** Room for the values of the walls that there are now, and the columns that these have. */
static bool make_row(clod_sim *self, clod_status *status)
{
    const size_t count = clod_free_measures_columns(self->from, &self->state);
    double *row = clod_memory_alloc(count + 1, sizeof *row);
    size_t *to = clod_memory_alloc(count + 1, sizeof *to);
    if (row == NULL || to == NULL) {
        clod_memory_free(row);
        clod_memory_free(to);
        return clod_status_fail(status, CLOD_FAILED, "no memory for a row of %zu columns",
                                count);
    }
    size_t next = 0;
    for (size_t k = 0; k < count; k++) {
        const clod_sim_heading heading = heading_of(self, k);
        to[k] = find_column(self, &heading, next);
        next = to[k] < self->column_count ? to[k] + 1 : next;
    }
    clod_memory_free(self->row);
    clod_memory_free(self->row_to);
    self->row = row;
    self->row_to = to;
    self->row_count = count;
    self->row_is_old = false;
    return true;
}

/** Values into their columns; those of walls that are gone have none. */
static void fill_columns(clod_sim *self)
{
    for (size_t k = 0; k < self->column_count; k++) {
        self->columns[k].value = (double)NAN;
    }
    for (size_t k = 0; k < self->row_count; k++) {
        if (self->row_to[k] < self->column_count) {
            self->columns[self->row_to[k]].value = self->row[k];
        }
    }
}

bool clod_sim_open_series(clod_sim *self, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !clod_sim_settle(self, status) ||
        !clod_step_see(&self->step, status)) {
        return false;
    }
    clod_sim_close_series(self);
    self->measures_size = clod_free_measures_size(self->from);
    self->column_count = clod_free_measures_columns(self->from, &self->state);
    self->measures = clod_memory_alloc(1, self->measures_size);
    self->columns = clod_memory_alloc(self->column_count + 1, sizeof *self->columns);
    self->headings = clod_memory_alloc(self->column_count + 1, sizeof *self->headings);
    if (self->measures == NULL || self->columns == NULL || self->headings == NULL) {
        clod_sim_close_series(self);
        return clod_status_fail(status, CLOD_FAILED, "no memory for a series of %zu columns",
                                self->column_count);
    }
    clod_free_measures_begin(self->measures, self->from, &self->state);
    self->state.exchange.residence_since = moment_of(self, NULL).steady.since;
    name_columns(self);
    self->row_is_old = true;
    clod_walls_reset_sums(&self->state.walls);
    return true;
}

/** The state has what measures must see of the bed to act. */
static bool see(clod_sim *self, clod_status *status)
{
    clod_sight sees = {0};
    const clod_free_moment now = moment_of(self, NULL);
    clod_free_measures_sight(self->measures, &now, &sees);
    return sees.whole ? clod_step_see(&self->step, status)
                      : sees.boxes == 0 ||
                            clod_step_see_near(&self->step, sees.box, sees.boxes, status);
}

bool clod_sim_advance_measured(clod_sim *self, int64_t steps, clod_status *status)
{
    bool good = true;
    while (good && steps > 0) {
        clod_step_reader reader;
        good = clod_step_change(&self->step, status) && // not together with what inlets bring
               see(self, status);
        const clod_contact_source contacts = clod_step_contacts(&self->step, &reader);
        const clod_survey survey = clod_step_survey(&self->step, &contacts);
        const clod_free_moment now = moment_of(self, &survey);
        good = good && clod_free_measures_act(self->measures, &now, status);
        const int64_t plan = clod_free_measures_plan(self->measures, self->from, &self->state);
        const int64_t next = plan < steps ? plan : steps;
        good = good && clod_step_advance(&self->step, next, status);
        steps -= next;
    }
    return good;
}

void clod_sim_sums_end(clod_sim *self)
{
    if (self->measures != NULL) {
        const clod_free_moment now = moment_of(self, NULL);
        clod_free_measures_sums_end(self->measures, &now);
    }
}

bool clod_sim_series_row(clod_sim *self, const clod_sim_column **columns, size_t *count,
                         clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(columns, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    if (self->measures == NULL) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: the series is not open; call clod_sim_open_series",
                                __func__);
    }
    if (!clod_sim_settle(self, status) || (self->row_is_old && !make_row(self, status))) {
        return false;
    }
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(&self->step, &reader);
    const clod_survey survey = clod_step_survey(&self->step, &contacts);
    clod_free_moment now = moment_of(self, &survey);
    if (!clod_free_measures_look(self->measures, &now, status)) {
        return false;
    }
    const clod_measure_motion motion = clod_measure_motion_from(&survey);
    now.motion = &motion;
    clod_free_measures_row(self->measures, &now, self->row);
    clod_walls_reset_sums(&self->state.walls);
    fill_columns(self);
    *columns = self->columns;
    *count = self->column_count;
    return true;
}
