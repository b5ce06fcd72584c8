// The series of a simulation: what the case measures beside walls and grains, and its inlets.
#include <string.h>

#include "base/memory.h"
#include "sim/free_measures.h"
#include "sim/sim.h"

/** What the measures look at now. */
static clod_free_moment moment_of(clod_sim *self, const clod_survey *survey)
{
    return clod_free_measures_moment(self->measures, self->from, &self->state, survey);
}

bool clod_sim_walls_are_free(const clod_sim *self, const char *function, clod_status *status)
{
    return self->measures == NULL ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: the series is open, and its measures know the walls of the case "
               "only; add and remove walls in a simulation without it",
               function);
}

void clod_sim_close_series(clod_sim *self)
{
    clod_memory_free(self->measures);
    clod_memory_free(self->columns);
    clod_memory_free(self->column_text);
    clod_memory_free(self->row);
    self->measures = NULL;
    self->columns = NULL;
    self->column_text = NULL;
    self->row = NULL;
}

/** Names and units from the headers of the columns: "gauge_chute.flow [kg/s]". */
static void name_columns(clod_sim *self)
{
    for (size_t k = 0; k < self->column_count; k++) {
        char *text = self->column_text[k];
        clod_free_measures_column(self->from, &self->state, k, text, CLOD_SIM_COLUMN_TEXT);
        char *unit = strstr(text, " [");
        self->columns[k] = (clod_sim_column){.name = text, .unit = ""};
        if (unit != NULL) {
            *unit = '\0';
            unit[strcspn(unit + 2, "]") + 2] = '\0';
            self->columns[k].unit = unit + 2;
        }
    }
}

bool clod_sim_open_series(clod_sim *self, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !clod_step_change(&self->step, status)) {
        return false;
    }
    clod_sim_close_series(self);
    self->measures_size = clod_free_measures_size(self->from);
    self->column_count = clod_free_measures_columns(self->from, &self->state);
    self->measures = clod_memory_alloc(1, self->measures_size);
    self->columns = clod_memory_alloc(self->column_count + 1, sizeof *self->columns);
    self->column_text = clod_memory_alloc(self->column_count + 1, sizeof *self->column_text);
    self->row = clod_memory_alloc(self->column_count + 1, sizeof *self->row);
    if (self->measures == NULL || self->columns == NULL || self->column_text == NULL ||
        self->row == NULL) {
        clod_sim_close_series(self);
        return clod_status_fail(status, CLOD_FAILED, "no memory for a series of %zu columns",
                                self->column_count);
    }
    clod_free_measures_begin(self->measures, self->from, &self->state);
    self->state.exchange.residence_since = moment_of(self, NULL).steady.since;
    name_columns(self);
    clod_walls_reset_sums(&self->state.walls);
    return true;
}

bool clod_sim_advance_measured(clod_sim *self, int64_t steps, clod_status *status)
{
    bool good = true;
    while (good && steps > 0) {
        clod_step_reader reader;
        good = clod_step_change(&self->step, status); // not together with what inlets bring
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
    if (!clod_step_change(&self->step, status)) {
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
    for (size_t k = 0; k < self->column_count; k++) {
        self->columns[k].value = self->row[k];
    }
    *columns = self->columns;
    *count = self->column_count;
    return true;
}
