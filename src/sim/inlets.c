#include "sim/inlets.h"

#include <inttypes.h>

#include "base/plural.h"
#include "setup/bound.h"
#include "setup/grains.h"
#include "sim/inlets_fill.h"
#include "sim/outputs.h"

/** Time for which an inlet is blocked before it is said [s]: a stream close to the limit of
 *  room waits for a millisecond now and then. */
#define BLOCKED_LEAST 0.01
#define NO_INLET_STEPS INT64_MAX

static size_t inlets_size(const clod_case *from)
{
    return clod_setup_grains_coming(from) > 0 ? sizeof(clod_inlets) : 0;
}

/** Begin with a state that no grain has come into. */
static void inlets_begin(void *memory, const clod_case *from, const clod_state *state,
                         const clod_free_start *bed)
{
    clod_inlets *self = memory;
    if (clod_setup_grains_coming(from) == 0) {
        return;
    }
    *self =
        (clod_inlets){.next = state->step, .next_id = bed->last_id + 1, .begin = state->time};
    self->first_id = self->next_id;
    for (size_t k = 0; k < clod_setup_grains_coming(from); k++) {
        self->inlet[k].since = -1;
    }
}

static int64_t inlets_plan(const void *memory, const clod_case *from, const clod_state *state,
                           const clod_steady_time *steady)
{
    (void)steady;
    const clod_inlets *self = memory;
    const bool some = clod_setup_grains_coming(from) > 0;
    return some && self->next > state->step ? self->next - state->step : NO_INLET_STEPS;
}

/** Another insertion is due. */
static void inlets_sight(const void *memory, const clod_free_moment *now, clod_sight *sees)
{
    const clod_inlets *self = memory;
    const bool due = clod_setup_grains_coming(now->from) > 0 && now->state->step == self->next;
    if (due && !sees->whole) {
        sees->whole = !clod_inlets_sight(now->from, sees);
    }
}

/** Laws and time step suit what comes: looked at when the run begins, and with every row. */
static bool inlets_check(void *memory, const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    return clod_setup_grains_coming(now->from) == 0 ||
           clod_setup_bound_streams(now->from, now->survey, status);
}

static bool inlets_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_inlets *self = memory;
    const clod_case *from = now->from;
    clod_state *state = now->state;
    if (clod_setup_grains_coming(from) == 0 || state->step != self->next) {
        return true;
    }
    if (state->time == self->begin && !inlets_check(memory, now, status)) {
        return false;
    }
    self->next = clod_outputs_next(CLOD_CASE_INLET_INTERVAL, state->dt, state->step);
    return clod_inlets_fill(self, from, state, status);
}

// ---- what is told

/** The group of the inlet with a number, from 0. */
static const clod_case_grains *group_of(const clod_case *from, size_t number)
{
    size_t k = 0;
    for (size_t inlets = 0;; k++) {
        inlets += from->grains[k].comes;
        if (inlets > number) {
            return &from->grains[k];
        }
    }
}

/** Unit of the backlog of a group's inlet. */
static const char *unit_of(const clod_case_grains *group)
{
    return group->inlet.mass_flow > 0.0 ? "kg" : "grains";
}

/** That an inlet is blocked, or is no more: a sentence, and the same as fields. */
static void say(const clod_inlet *self, size_t number, const clod_case *from,
                const clod_state *state, clod_news *news)
{
    const clod_case_grains *group = group_of(from, number);
    const bool by_mass = group->inlet.mass_flow > 0.0;
    news->event = self->said != 0 ? "inlet blocked begins" : "inlet blocked ends";
    news->fields = json_pack("{s:I, s:I, s:f, s:f}", "inlet", (json_int_t)number + 1, "step",
                             (json_int_t)state->step, "time_s", state->time,
                             by_mass ? "backlog_kg" : "backlog_grains", self->backlog);
    if (self->said != 0) {
        const double since = (double)self->since * state->dt;
        json_object_set_new(news->fields, "since_s", json_real(since));
        snprintf(
            news->text, sizeof news->text,
            "warning: inlet %zu is blocked since %.6g s: at %.6g s %.4g %s wait for a place",
            number + 1, since, state->time, self->backlog, unit_of(group));
    } else {
        snprintf(news->text, sizeof news->text,
                 "inlet %zu is not blocked any more: at %.6g s nothing waits for a place",
                 number + 1, state->time);
    }
}

/** The next inlet that is blocked for BLOCKED_LEAST, or is no more, and was not said. */
static bool inlets_news(void *memory, const clod_case *from, const clod_state *state,
                        clod_news *news)
{
    clod_inlets *self = memory;
    for (size_t k = 0; k < clod_setup_grains_coming(from); k++) {
        clod_inlet *inlet = &self->inlet[k];
        const double waited =
            inlet->since < 0 ? 0.0 : (double)(state->step - inlet->since) * state->dt;
        const bool begins = inlet->said == 0 && waited >= BLOCKED_LEAST;
        const bool ends = inlet->said != 0 && inlet->since < 0;
        if (begins || ends) {
            inlet->said = begins;
            say(inlet, k, from, state, news);
            return true;
        }
    }
    return false;
}

/** Columns of the series for each inlet. */
#define PER_INLET 3

static size_t inlets_columns(const clod_case *from, const clod_state *state)
{
    (void)state;
    return PER_INLET * clod_setup_grains_coming(from);
}

static void inlets_column(const clod_case *from, const clod_state *state, size_t k, char *text,
                          size_t size)
{
    (void)state;
    const bool by_mass = group_of(from, k / PER_INLET)->inlet.mass_flow > 0.0;
    const char *const name[PER_INLET] = {"grains [1]", "mass [kg]",
                                         by_mass ? "backlog [kg]" : "backlog [1]"};
    snprintf(text, size, "inlet_%zu.%s", k / PER_INLET + 1, name[k % PER_INLET]);
}

static void inlets_row(void *memory, const clod_free_moment *now, double *row)
{
    const clod_inlets *self = memory;
    for (size_t k = 0; k < clod_setup_grains_coming(now->from); k++) {
        row[PER_INLET * k] = (double)self->inlet[k].count;
        row[PER_INLET * k + 1] = self->inlet[k].mass;
        row[PER_INLET * k + 2] = self->inlet[k].backlog;
    }
}

static void inlets_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const clod_inlets *self = memory;
    const clod_case *from = now->from;
    const double dt = now->state->dt;
    size_t number = 0;
    for (size_t k = 0; k < from->grains_count; k++) {
        if (!from->grains[k].comes) {
            continue;
        }
        const clod_inlet *inlet = &self->inlet[number++];
        fprintf(out, "  inlet %-15zu %" PRId64 " grain%s, %.6g kg came in\n", number,
                inlet->count, clod_plural((double)inlet->count), inlet->mass);
        if (inlet->blocked > 0) {
            fprintf(out,
                    "  WARNING               inlet %zu (grains.%zu) was blocked at %" PRId64
                    " of its insertions, one a ms: up to %.4g %s waited for a place, %.4g "
                    "still do\n",
                    number, k, inlet->blocked, inlet->most, unit_of(&from->grains[k]),
                    inlet->backlog);
        }
        if (inlet->since >= 0) {
            fprintf(out, "  WARNING               it has been blocked since %.6g s\n",
                    (double)inlet->since * dt);
        }
    }
}

static bool inlets_told(const clod_case *from)
{
    return clod_setup_grains_coming(from) > 0;
}

static void inlets_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t k = 0; k < clod_setup_grains_coming(from); k++) {
        char number[24];
        const char *unit = group_of(from, k)->inlet.mass_flow > 0.0 ? "kg" : "grains";
        snprintf(number, sizeof number, "%zu", k);
        clod_free_paths_add(paths, number,
                            "group grains mass_kg backlog_%s most_backlog_%s "
                            "blocked_insertions blocked_since_s",
                            unit, unit);
    }
}

static json_t *inlets_json(const void *memory, const clod_free_moment *now)
{
    const clod_inlets *self = memory;
    const clod_case *from = now->from;
    const double dt = now->state->dt;
    json_t *list = json_array();
    size_t number = 0;
    for (size_t k = 0; k < from->grains_count; k++) {
        if (!from->grains[k].comes) {
            continue;
        }
        const clod_inlet *inlet = &self->inlet[number++];
        const bool by_mass = from->grains[k].inlet.mass_flow > 0.0;
        json_t *one = json_pack("{s:I, s:I, s:f, s:f, s:f, s:I}", "group", (json_int_t)k,
                                "grains", (json_int_t)inlet->count, "mass_kg", inlet->mass,
                                by_mass ? "backlog_kg" : "backlog_grains", inlet->backlog,
                                by_mass ? "most_backlog_kg" : "most_backlog_grains",
                                inlet->most, "blocked_insertions", (json_int_t)inlet->blocked);
        if (inlet->since >= 0) {
            json_object_set_new(one, "blocked_since_s", json_real((double)inlet->since * dt));
        }
        json_array_append_new(list, one);
    }
    return list;
}

const clod_free_measure CLOD_MEASURE_INLETS = {.key = "inlets",
                                               .size = inlets_size,
                                               .begin = inlets_begin,
                                               .sight = inlets_sight,
                                               .act = inlets_act,
                                               .look = inlets_check,
                                               .plan = inlets_plan,
                                               .news = inlets_news,
                                               .columns = inlets_columns,
                                               .column = inlets_column,
                                               .row = inlets_row,
                                               .report = inlets_report,
                                               .told = inlets_told,
                                               .paths = inlets_paths,
                                               .json = inlets_json};
