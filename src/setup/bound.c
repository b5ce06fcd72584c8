#include "setup/bound.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "config/sizes.h"
#include "config/testers.h"
#include "measure/stock.h"
#include "setup/arrival.h"
#include "setup/bed.h"

/** The sizes of grains that are to come: two each of the smallest and of the median, which can
 *  meet their like. */
static bool add_coming(clod_setup_bound *self, const clod_case *from,
                       const clod_case_grains *group, clod_status *status)
{
    clod_sizes sizes;
    const bool good = clod_sizes_init(&sizes, group, status);
    if (good) {
        const int material = clod_case_material_index(from, group->material);
        clod_timestep_add(&self->sizes[material], 2.0, sizes.min);
        clod_timestep_add(&self->sizes[material], 2.0, clod_sizes_quantile(&sizes, 0.5));
    }
    clod_sizes_fini(&sizes);
    return good;
}

/** Of nothing yet. */
static bool begin(clod_setup_bound *self, const clod_case *from, clod_status *status)
{
    *self = (clod_setup_bound){.stress = from->time.design_stress};
    const size_t materials = from->material_count + 1; // never an array of none
    self->sizes = clod_memory_alloc(materials, sizeof *self->sizes);
    self->is_wall = clod_memory_alloc(materials, sizeof *self->is_wall);
    return (self->sizes != NULL && self->is_wall != NULL) ||
           clod_status_fail(status, CLOD_FAILED, "no memory for the time step");
}

/** The grains that are to come, the walls, and the stress that the case gives, if it does. */
static bool add_rest(clod_setup_bound *self, const clod_case *from, const clod_state *state,
                     clod_status *status)
{
    for (size_t k = 0; k < from->grains_count; k++) {
        if (from->grains[k].comes && !add_coming(self, from, &from->grains[k], status)) {
            return false;
        }
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            self->is_wall[clod_wall_material(wall, s)] = true;
        }
    }
    if (self->stress == 0.0) {
        self->stress = clod_case_tester_stress(from);
    }
    return true;
}

/** Stress and speed of a bed, where the case does not give the stress. */
static void add_bed(clod_setup_bound *self, const clod_case *from, const clod_setup_bed *bed,
                    const clod_state *state)
{
    self->stress = clod_setup_bed_stress(bed, from, state);
    self->speed = clod_setup_bed_impact(bed, state);
}

bool clod_setup_bound_init_of(clod_setup_bound *self, const clod_case *from,
                              const clod_setup_tally *tally, const clod_state *state,
                              clod_status *status)
{
    bool good = begin(self, from, status);
    if (good) {
        memcpy(self->sizes, tally->sizes, from->material_count * sizeof *self->sizes);
    }
    good = good && add_rest(self, from, state, status);
    if (good && self->stress == 0.0) {
        add_bed(self, from, &tally->bed, state);
    }
    return good;
}

bool clod_setup_bound_init(clod_setup_bound *self, const clod_case *from,
                           const clod_state *state, clod_status *status)
{
    bool good = begin(self, from, status);
    for (size_t g = 0; good && g < state->grains.count; g++) {
        clod_timestep_add(&self->sizes[state->grains.material[g]], 1.0,
                          state->grains.position[g][3]);
    }
    good = good && add_rest(self, from, state, status);
    if (good && self->stress == 0.0) {
        const clod_setup_bed bed = clod_setup_bed_of(state);
        add_bed(self, from, &bed, state);
    }
    return good;
}

/** The same of a bed that is asked for sums, under the stress that a case with inlets gives. */
static bool init_from(clod_setup_bound *self, const clod_case *from, const clod_survey *survey,
                      clod_status *status)
{
    clod_stock *stock = clod_memory_alloc(from->material_count + 1, sizeof *stock);
    bool good = begin(self, from, status) &&
                (stock != NULL ||
                 clod_status_fail(status, CLOD_FAILED, "no memory for the time step")) &&
                clod_stock_take(stock, from->material_count, survey, status);
    for (size_t m = 0; good && m < from->material_count; m++) {
        self->sizes[m] = (clod_timestep_sizes){
            .count = stock[m].count, .least = stock[m].least, .sum = stock[m].sum};
    }
    clod_memory_free(stock);
    return good && add_rest(self, from, survey->state, status);
}

clod_timestep clod_setup_bound_timestep(const clod_setup_bound *self, const clod_case *from)
{
    const clod_timestep_grains grains = {.sizes = self->sizes,
                                         .is_wall = self->is_wall,
                                         .stress = self->stress,
                                         .speed = self->speed};
    return clod_timestep_choose(from, &grains);
}

void clod_setup_bound_fini(clod_setup_bound *self)
{
    clod_memory_free(self->sizes);
    clod_memory_free(self->is_wall);
    *self = (clod_setup_bound){0};
}

/** Whether `dt` is stable within a bound. */
static bool is_stable(const clod_setup_bound *self, const clod_case *from, double dt,
                      const char *what, clod_status *status)
{
    const clod_timestep t = clod_setup_bound_timestep(self, from);
    return !(t.limit > 0.0) || dt <= t.limit ||
           clod_status_fail(
               status, CLOD_USAGE,
               "time.step: with %s the time step of %.4g s is beyond the critical one, %.4g s under %.4g N "
               "between %s and %s: the run would blow up. Give time.step in the case, %.4g s "
               "or less",
               what, dt, t.limit, t.limit_force, t.limit_a, t.limit_b, t.automatic);
}

bool clod_setup_bound_fits(const clod_case *from, const clod_state *state, const char *what,
                           clod_status *status)
{
    clod_setup_bound bound;
    const bool good = clod_setup_bound_init(&bound, from, state, status) &&
                      is_stable(&bound, from, state->dt, what, status);
    clod_setup_bound_fini(&bound);
    return good;
}

// ---- what is to come

/** Add what the queue brings. */
static void add_queue(clod_setup_bound *self, const clod_changes *queue)
{
    for (size_t k = 0; k < queue->new_grains; k++) {
        const clod_new_grain *grain = &queue->new_grain[k];
        clod_timestep_add(&self->sizes[grain->material], 1.0, grain->position[3]);
    }
    for (size_t k = 0; k < queue->new_walls; k++) {
        for (int32_t s = 0; s < queue->new_wall[k].shape_count; s++) {
            self->is_wall[clod_wall_material(&queue->new_wall[k], s)] = true;
        }
    }
}

/** Whether grains of material a have a law for grains, or walls, of material b. */
static bool has_law(const clod_case *from, int a, int b, bool wall, clod_status *status)
{
    const char *first = from->materials[a].name, *second = from->materials[b].name;
    return clod_case_pair(from, b, a)->exponent > 0.0 ||
           clod_status_fail(
               status, CLOD_USAGE,
               "contacts: there is no contact law for grains of '%s' with %s of '%s'; "
               "add the section %s-%s",
               first, wall ? "a wall" : "grains", second, first, second);
}

/** A grain of this material that comes has a law for all that it can meet. */
static bool grain_has_laws(const clod_setup_bound *self, const clod_case *from, int material,
                           clod_status *status)
{
    bool good = true;
    for (int m = 0; good && m < (int)from->material_count; m++) {
        good = (self->sizes[m].count == 0.0 || has_law(from, material, m, false, status)) &&
               (!self->is_wall[m] || has_law(from, material, m, true, status));
    }
    return good;
}

/** All grains have a law for a wall of this material that comes. */
static bool wall_has_laws(const clod_setup_bound *self, const clod_case *from, int material,
                          clod_status *status)
{
    bool good = true;
    for (int m = 0; good && m < (int)from->material_count; m++) {
        good = self->sizes[m].count == 0.0 || has_law(from, m, material, true, status);
    }
    return good;
}

/** Laws for all that the queue brings; a material is looked at once where it comes in a row. */
static bool queue_has_laws(const clod_setup_bound *self, const clod_case *from,
                           const clod_changes *queue, clod_status *status)
{
    bool good = true;
    int last = -1;
    for (size_t k = 0; good && k < queue->new_grains; k++) {
        const int material = queue->new_grain[k].material;
        good = material == last || grain_has_laws(self, from, material, status);
        last = material;
    }
    last = -1;
    for (size_t k = 0; good && k < queue->new_walls; k++) {
        for (int32_t s = 0; good && s < queue->new_wall[k].shape_count; s++) {
            const int material = clod_wall_material(&queue->new_wall[k], s);
            good = material == last || wall_has_laws(self, from, material, status);
            last = material;
        }
    }
    return good;
}

/** What of the queue a message names: the smallest grain, or a wall when there are none. */
static void name_queue(const clod_changes *queue, char *text, size_t size)
{
    const clod_new_grain *least = queue->new_grain;
    for (size_t k = 1; k < queue->new_grains; k++) {
        const clod_new_grain *grain = &queue->new_grain[k];
        least = grain->position[3] < least->position[3] ? grain : least;
    }
    if (queue->new_grains > 0) {
        snprintf(text, size, "grain %llu (radius %.4g mm)", (unsigned long long)least->id,
                 1e3 * least->position[3]);
    } else {
        snprintf(text, size, "wall '%s'", queue->new_wall[0].name);
    }
}

/** Whether laws and time step suit the queue, which the bound has. */
static bool suits(const clod_setup_bound *self, const clod_case *from, const clod_state *state,
                  clod_status *status)
{
    char what[64];
    name_queue(&state->changes, what, sizeof what);
    return queue_has_laws(self, from, &state->changes, status) &&
           is_stable(self, from, state->dt, what, status);
}

/** The same with loaded walls, which press on the bed and are damped against it. */
static bool suits_with_loads(const clod_case *from, const clod_state *state,
                             clod_status *status)
{
    clod_setup_bound bound = {0};
    clod_state after;
    const bool good = clod_setup_arrival_init(&after, from, state, status) &&
                      clod_setup_bound_init(&bound, from, &after, status) &&
                      suits(&bound, from, state, status);
    if (good) {
        const clod_timestep timestep = clod_setup_bound_timestep(&bound, from);
        clod_setup_arrival_damp(&after, &timestep, &state->changes);
    }
    clod_setup_bound_fini(&bound);
    clod_setup_arrival_fini(&after);
    return good;
}

bool clod_setup_bound_accepts(const void *from, const clod_state *state, clod_status *status)
{
    const clod_changes *queue = &state->changes;
    if (queue->new_grains + queue->new_walls == 0) {
        return true;
    }
    if (clod_setup_arrival_loads(queue)) {
        return suits_with_loads(from, state, status);
    }
    clod_setup_bound bound;
    bool good = clod_setup_bound_init(&bound, from, state, status);
    if (good) {
        add_queue(&bound, queue);
        good = suits(&bound, from, state, status);
    }
    clod_setup_bound_fini(&bound);
    return good;
}

bool clod_setup_bound_streams(const clod_case *from, const clod_survey *survey,
                              clod_status *status)
{
    clod_setup_bound bound;
    bool good = init_from(&bound, from, survey, status);
    for (size_t k = 0; good && k < from->grains_count; k++) {
        const int material = clod_case_material_index(from, from->grains[k].material);
        good = !from->grains[k].comes || grain_has_laws(&bound, from, material, status);
    }
    good =
        good && is_stable(&bound, from, survey->state->dt, "the grains that come in", status);
    clod_setup_bound_fini(&bound);
    return good;
}
