#include "sim/inlets.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/plural.h"
#include "base/random.h"
#include "setup/grains.h"
#include "setup/insertion_space.h"
#include "setup/sizes.h"
#include "sim/outputs.h"

/** Random places that are tried for a grain before it waits. */
#define TRIES 200
/** Draws of a grain at one step: three for each try. */
#define DRAWS (3 * TRIES)
#define NO_INLET_STEPS INT64_MAX

static size_t inlets_size(const clod_case *from)
{
    return clod_setup_grains_coming(from) > 0 ? sizeof(clod_inlets) : 0;
}

/** Begin with a state that no grain has come into. */
static void inlets_begin(void *memory, const clod_case *from, const clod_state *state)
{
    clod_inlets *self = memory;
    if (clod_setup_grains_coming(from) == 0) {
        return;
    }
    *self = (clod_inlets){.next = state->step, .next_id = 1, .begin = state->time};
    for (size_t g = 0; g < state->grains.count; g++) {
        const uint64_t id = state->grains.id[g];
        self->next_id = id >= self->next_id ? id + 1 : self->next_id;
    }
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

// ---- one insertion of one inlet

/** What an insertion works with. */
typedef struct filling {
    clod_inlets *all;
    clod_inlet *self;
    const clod_case *from;
    const clod_case_grains *group;
    clod_state *state;
    clod_sizes sizes;
    clod_insertion_space space;
    double density; ///< kg/m3
    uint16_t material;
} filling;

static double mass_of(const filling *self, double radius)
{
    return self->density * (4.0 / 3.0) * M_PI * radius * radius * radius;
}

/** What is due by now: kg of a mass flow, grains of a number flow. */
static double due_of(const filling *self)
{
    const clod_case_inlet *inlet = &self->group->inlet;
    double time = (double)self->state->step * self->state->dt;
    if (inlet->end > 0.0) {
        time = fmin(time, inlet->end);
    }
    const double since = fmax(0.0, time - fmax(inlet->start, self->all->begin));
    return since * (inlet->mass_flow > 0.0 ? inlet->mass_flow : inlet->number_flow);
}

/** Whether the next grain, of this mass, is due: to the nearest grain, within the amount. */
static bool is_due(const filling *self, double mass)
{
    const clod_inlet *inlet = self->self;
    const clod_case_grains *group = self->group;
    const double due = due_of(self);
    const bool by_mass = group->inlet.mass_flow > 0.0;
    const bool now =
        by_mass ? inlet->mass + 0.5 * mass <= due : (double)inlet->count + 0.5 <= due;
    return now && (group->count == 0 || inlet->count < group->count) &&
           (group->mass == 0.0 || inlet->mass + 0.5 * mass <= group->mass);
}

static bool next_is_due(const filling *self)
{
    return is_due(self,
                  mass_of(self, clod_sizes_radius(&self->sizes, (uint64_t)self->from->seed,
                                                  self->all->next_id)));
}

/** A place for the grain of an id; false: none was found. */
static bool find_place(const filling *self, uint64_t id, double place[4])
{
    const uint64_t seed = (uint64_t)self->from->seed;
    const uint64_t first = (uint64_t)self->state->step * DRAWS; // others at every step
    for (uint64_t t = 0; t < TRIES; t++) {
        double u[3];
        for (uint64_t a = 0; a < 3; a++) {
            u[a] = clod_random_uniform(seed, CLOD_RANDOM_POSITION, id, first + 3 * t + a);
        }
        if (clod_insertion_space_draw(&self->space, place, self->space.low[2],
                                      self->space.high[2], u) &&
            clod_insertion_space_clear(&self->space, place)) {
            return true;
        }
    }
    return false;
}

static bool add_grain(filling *self, const double place[4], clod_status *status)
{
    clod_new_grain grain = {
        .id = self->all->next_id++, .density = self->density, .material = self->material};
    memcpy(grain.position, place, sizeof grain.position);
    memcpy(grain.velocity, self->group->velocity, sizeof grain.velocity);
    clod_changes_add_grain(&self->state->changes, &grain);
    self->self->count++;
    self->self->mass += mass_of(self, place[3]);
    return clod_insertion_space_take(&self->space, place, status);
}

/** Put what is due; what waits is noted. */
static bool put_all(filling *self, clod_status *status)
{
    clod_inlet *inlet = self->self;
    bool waits = false;
    while (!waits) {
        const uint64_t id = self->all->next_id;
        double place[4] = {0.0, 0.0, 0.0,
                           clod_sizes_radius(&self->sizes, (uint64_t)self->from->seed, id)};
        if (!is_due(self, mass_of(self, place[3]))) {
            break;
        }
        waits = !find_place(self, id, place);
        if (!waits && !add_grain(self, place, status)) {
            return false;
        }
    }
    const bool by_mass = self->group->inlet.mass_flow > 0.0;
    inlet->owed = waits ? due_of(self) - (by_mass ? inlet->mass : (double)inlet->count) : 0.0;
    inlet->most = fmax(inlet->most, inlet->owed);
    inlet->blocked += waits;
    inlet->since = !waits ? -1 : inlet->since < 0 ? self->state->step : inlet->since;
    return true;
}

/** Note what other inlets have put at this step: it is not in the state yet. */
static bool note_others(filling *self, clod_status *status)
{
    const clod_changes *queue = &self->state->changes;
    for (size_t k = 0; k < queue->new_grains; k++) {
        if (!clod_insertion_space_take(&self->space, queue->new_grain[k].position, status)) {
            return false;
        }
    }
    return true;
}

static bool fill(clod_inlets *all, size_t number, const clod_case *from,
                 const clod_case_grains *group, clod_state *state, clod_status *status)
{
    const int material = clod_case_material_index(from, group->material);
    filling self = {.all = all,
                    .self = &all->inlet[number],
                    .from = from,
                    .group = group,
                    .state = state,
                    .density = from->materials[material].density,
                    .material = (uint16_t)material};
    bool good = clod_sizes_init(&self.sizes, group, status);
    if (good && next_is_due(&self)) {
        const double largest = cbrt(clod_sizes_largest_volume(&self.sizes) * 0.75 / M_PI);
        const double top = group->region.kind == CLOD_REGION_BOX
                               ? group->region.max[2]
                               : group->region.center[2] + group->region.height;
        good = clod_insertion_space_init(&self.space, &group->region, top, state, largest,
                                         state->grains.count + 1, status) &&
               note_others(&self, status) && put_all(&self, status);
        clod_insertion_space_fini(&self.space);
    } else {
        self.self->owed = 0.0;
        self.self->since = -1;
    }
    clod_sizes_fini(&self.sizes);
    return good;
}

static bool inlets_act(void *memory, const clod_free_moment *now, clod_status *status)
{
    clod_inlets *self = memory;
    const clod_case *from = now->from;
    clod_state *state = now->state;
    if (clod_setup_grains_coming(from) == 0 || state->step != self->next) {
        return true;
    }
    self->next = clod_outputs_next(CLOD_INLETS_INTERVAL, state->dt, state->step);
    size_t number = 0;
    for (size_t k = 0; k < from->grains_count; k++) {
        if (from->grains[k].comes &&
            !fill(self, number++, from, &from->grains[k], state, status)) {
            return false;
        }
    }
    return true;
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
                                         by_mass ? "owed [kg]" : "owed [1]"};
    snprintf(text, size, "inlet_%zu.%s", k / PER_INLET + 1, name[k % PER_INLET]);
}

static void inlets_row(void *memory, const clod_free_moment *now, double *row)
{
    const clod_inlets *self = memory;
    for (size_t k = 0; k < clod_setup_grains_coming(now->from); k++) {
        row[PER_INLET * k] = (double)self->inlet[k].count;
        row[PER_INLET * k + 1] = self->inlet[k].mass;
        row[PER_INLET * k + 2] = self->inlet[k].owed;
    }
}

/** Unit of what is owed at a group's inlet. */
static const char *unit_of(const clod_case_grains *group)
{
    return group->inlet.mass_flow > 0.0 ? "kg" : "grains";
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
                    "  WARNING               inlet %zu (grains[%zu]) was blocked at %" PRId64
                    " of its insertions, one a ms: up to %.4g %s waited for a place, %.4g "
                    "still do\n",
                    number, k, inlet->blocked, inlet->most, unit_of(&from->grains[k]),
                    inlet->owed);
        }
        if (inlet->since >= 0) {
            fprintf(out, "  WARNING               it has been blocked since %.6g s\n",
                    (double)inlet->since * dt);
        }
    }
}

static json_t *inlets_json(const void *memory, const clod_free_moment *now)
{
    const clod_inlets *self = memory;
    const clod_case *from = now->from;
    const double dt = now->state->dt;
    if (clod_setup_grains_coming(from) == 0) {
        return NULL;
    }
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
                                by_mass ? "owed_kg" : "owed_grains", inlet->owed,
                                by_mass ? "most_owed_kg" : "most_owed_grains", inlet->most,
                                "blocked_insertions", (json_int_t)inlet->blocked);
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
                                               .act = inlets_act,
                                               .plan = inlets_plan,
                                               .columns = inlets_columns,
                                               .column = inlets_column,
                                               .row = inlets_row,
                                               .report = inlets_report,
                                               .json = inlets_json};
