#include "setup/grains.h"

#include <math.h>
#include <stdio.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/plural.h"
#include "base/sort.h"
#include "config/region.h"
#include "geometry/sphere_grid.h"
#include "setup/amount.h"
#include "setup/domain.h"
#include "setup/grains_file.h"
#include "setup/insertion.h"

#define MASS_OFF 0.05 ///< of the mass asked for, that the grains may weigh more or less
#define KEY_TEXT 64

/** Number or solid volume that a group asks for; `key` is its text, made here. */
static clod_amount group_amount(const clod_case *from, size_t k, const clod_sizes *sizes,
                                char key[KEY_TEXT])
{
    const clod_case_grains *group = &from->grains[k];
    const int material = clod_case_material_index(from, group->material);
    CLOD_ASSERT(material >= 0); // checked at load
    const double density = from->materials[material].density;
    const char *word = group->count > 0 ? "count" : group->mass > 0.0 ? "mass" : "fill_height";
    snprintf(key, KEY_TEXT, "grains.%zu.%s", k, word);
    return (clod_amount){.key = key,
                         .sizes = sizes,
                         .count = group->count,
                         .volume = group->mass > 0.0
                                       ? group->mass / density
                                       : group->fill_height * group->fill_fraction *
                                             clod_region_area(&group->region),
                         .density = density};
}

size_t clod_setup_grains_coming(const clod_case *from)
{
    size_t count = 0;
    for (size_t k = 0; k < from->grains_count; k++) {
        count += from->grains[k].comes;
    }
    return count;
}

/** Time of all stages together [s]. */
static double whole_time(const clod_case *from)
{
    double end = 0.0;
    for (size_t s = 0; s < from->stage_count; s++) {
        end += from->stages[s].duration;
    }
    return end;
}

bool clod_setup_grains_open(const clod_case *from, clod_status *status)
{
    const double end = whole_time(from);
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        if (group->comes && group->inlet.start >= end) {
            return clod_status_fail(
                status, CLOD_USAGE,
                "grains.%zu.inlet.start: %.6g s is not before the end of the run, %.6g s, which "
                "its stages last together: nothing comes. Let it start before, or make a stage "
                "longer",
                k, group->inlet.start, end);
        }
    }
    return true;
}

double clod_setup_grains_due(const clod_case *from, size_t k)
{
    const clod_case_grains *group = &from->grains[k];
    const clod_case_inlet *inlet = &group->inlet;
    const double radius =
        group->sieve_count > 0 ? 0.5 * group->sieve[0].size : group->radius_min;
    const int material = clod_case_material_index(from, group->material);
    const double mass =
        4.0 / 3.0 * M_PI * radius * radius * radius * from->materials[material].density;
    const double end = inlet->end > 0.0 ? fmin(whole_time(from), inlet->end) : whole_time(from);
    const double time = fmax(0.0, end - inlet->start);
    const double flow = inlet->mass_flow > 0.0 ? inlet->mass_flow / mass : inlet->number_flow;
    return group->mass > 0.0 ? fmin(flow * time, group->mass / mass) : flow * time;
}

/** Number of grains that come through an inlet in all, if none has to wait. */
static double expect_coming(const clod_case *from, const clod_case_grains *group,
                            const clod_sizes *sizes)
{
    const clod_case_inlet *inlet = &group->inlet;
    const int material = clod_case_material_index(from, group->material);
    const double mass = clod_sizes_mean_volume(sizes) * from->materials[material].density;
    const double all = whole_time(from);
    const double end = inlet->end > 0.0 ? fmin(all, inlet->end) : all;
    const double time = fmax(0.0, end - inlet->start);
    double grains =
        time * (inlet->mass_flow > 0.0 ? inlet->mass_flow / mass : inlet->number_flow);
    grains = group->count > 0 ? fmin(grains, (double)group->count) : grains;
    return ceil(group->mass > 0.0 ? fmin(grains, group->mass / mass) : grains);
}

bool clod_setup_grains_expect(const clod_case *from, double share, double *grains,
                              clod_status *status)
{
    *grains = 0.0;
    bool good = true;
    for (size_t k = 0; good && k < from->grains_count; k++) {
        char key[KEY_TEXT];
        clod_sizes sizes;
        if (from->grains[k].file != NULL) {
            continue;
        }
        good = clod_sizes_init(&sizes, &from->grains[k], status);
        if (good && from->grains[k].comes) {
            *grains += expect_coming(from, &from->grains[k], &sizes);
        } else if (good) {
            const clod_amount amount = group_amount(from, k, &sizes, key);
            *grains += clod_amount_expect(&amount);
            good = clod_amount_fits(key, *grains, share, status);
        }
        clod_sizes_fini(&sizes);
    }
    return good;
}

double clod_setup_grains_mass(const clod_case *from)
{
    double mass = 0.0;
    for (size_t k = 0; k < from->grains_count; k++) {
        char key[KEY_TEXT];
        if (from->grains[k].comes) {
            continue;
        }
        if (from->grains[k].file != NULL || from->grains[k].count > 0) {
            return 0.0;
        }
        const clod_amount amount = group_amount(from, k, NULL, key);
        mass += amount.volume * amount.density;
    }
    return mass;
}

bool clod_setup_grains_say_off(const clod_case *from, const clod_setup_bed *bed, char *text,
                               size_t size)
{
    const double asked = clod_setup_grains_mass(from);
    if (!(asked > 0.0) || !(fabs(bed->mass - asked) > MASS_OFF * asked)) {
        return false;
    }
    snprintf(
        text, size,
        "%zu grain%s of %.3g kg in all stand for the %.3g kg that mass or fill_height asks "
        "for: the nearest that whole grains of these sizes give. Ask for more, or for "
        "smaller grains",
        bed->grains, clod_plural((double)bed->grains), bed->mass, asked);
    return true;
}

/** A group that is inserted. */
typedef struct group_plan {
    clod_sizes sizes; ///< owned
    clod_insertion what;
    char name[KEY_TEXT];
} group_plan;

/** How many grains of which sizes, from `next_id` on, which is behind them then. */
static bool plan_group(group_plan *self, const clod_case *from, size_t k, int64_t seed,
                       double share, uint64_t *next_id, clod_status *status)
{
    const clod_case_grains *group = &from->grains[k];
    char key[KEY_TEXT];
    *self = (group_plan){0};
    if (!clod_sizes_init(&self->sizes, group, status)) {
        return false;
    }
    clod_amount amount = group_amount(from, k, &self->sizes, key);
    amount.share = share;
    snprintf(self->name, sizeof self->name, "grains.%zu", k);
    self->what = (clod_insertion){
        .name = self->name,
        .region = &group->region,
        .sizes = &self->sizes,
        .seed = (uint64_t)seed,
        .first_id = *next_id,
        .count = clod_amount_count(&amount, (uint64_t)seed, *next_id, status),
        .material = (uint16_t)clod_case_material_index(from, group->material),
        .density = amount.density,
        .velocity = {group->velocity[0], group->velocity[1], group->velocity[2]}};
    *next_id += self->what.count;
    return self->what.count > 0;
}

static bool insert_group(const clod_case *from, size_t k, int64_t seed, uint64_t *next_id,
                         clod_state *state, clod_status *status)
{
    group_plan group;
    const bool good = plan_group(&group, from, k, seed, 1.0, next_id, status) &&
                      clod_insert_region(state, &group.what, status);
    clod_sizes_fini(&group.sizes);
    return good;
}

/** Grains of a state lie in the domain. */
static bool check_places(const clod_case *from, const clod_state *state, clod_status *status)
{
    double diameter = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        diameter = fmax(diameter, 2.0 * state->grains.position[g][3]);
    }
    return clod_setup_pieces_inside(from, state, 0, diameter, status);
}

/** Every id belongs to one grain only. */
static bool check_ids(const clod_grains *grains, clod_status *status)
{
    const size_t count = grains->count;
    clod_sort_item *items = clod_memory_alloc(2 * count + 1, sizeof *items);
    if (items == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", count);
    }
    for (size_t g = 0; g < count; g++) {
        items[g] = (clod_sort_item){.key = grains->id[g], .index = g};
    }
    clod_sort(items, items + count, count);
    bool good = true;
    for (size_t k = 1; good && k < count; k++) {
        if (items[k].key == items[k - 1].key) {
            good = clod_status_fail(status, CLOD_USAGE,
                                    "grains: the id %llu belongs to two grains; ids of a file "
                                    "must differ from each other and from those of the groups "
                                    "before it, which count from 1",
                                    (unsigned long long)items[k].key);
        }
    }
    clod_memory_free(items);
    return good;
}

/** All grains into the state. */
static bool make_whole(const clod_case *from, int64_t seed, clod_state *state,
                       clod_status *status)
{
    uint64_t next_id = 1;
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        if (group->comes) {
            continue;
        }
        const bool good =
            group->file != NULL
                ? clod_grains_file_read(from, group, &next_id, &state->grains, status)
                : insert_group(from, k, seed, &next_id, state, status);
        if (!good) {
            return false;
        }
    }
    return clod_grains_reserve(&state->grains, state->grains.count, status) && // also of none
           check_ids(&state->grains, status) && check_places(from, state, status);
}

bool clod_setup_grains(const clod_case *from, int64_t seed, clod_state *state,
                       clod_setup_tally *tally, clod_status *status)
{
    if (!make_whole(from, seed, state, status) ||
        !clod_setup_tally_init(tally, from, state, state->grains.count, status)) {
        return false;
    }
    clod_setup_tally_add(tally, state, 0);
    return true;
}

// ---- piece by piece

bool clod_setup_grains_in_pieces(const clod_case *from)
{
    bool good = from->grains_count > 0;
    for (size_t k = 0; k < from->grains_count; k++) {
        good = good && from->grains[k].file == NULL;
    }
    return good;
}

/** What is known of all groups before the first grain is made: their number, and what each takes.
 *  @param extents  [groups] */
static bool plan_all(const clod_case *from, int64_t seed, clod_setup_pieces *pieces,
                     clod_insertion_extent *extents, size_t *grains, clod_status *status)
{
    uint64_t next_id = 1;
    bool good = true;
    for (size_t k = 0; good && k < from->grains_count; k++) {
        if (from->grains[k].comes) {
            continue;
        }
        group_plan group;
        good = plan_group(&group, from, k, seed, pieces->taker->share, &next_id, status);
        if (good) {
            extents[k] = clod_insertion_measure(&group.what);
            pieces->diameter = fmax(pieces->diameter, 2.0 * extents[k].largest);
        }
        clod_sizes_fini(&group.sizes);
    }
    *grains = (size_t)(next_id - 1);
    return good;
}

/** Make one group after the other; each is given away before the next. */
static bool give_groups(const clod_case *from, int64_t seed, clod_setup_pieces *pieces,
                        const clod_insertion_extent *extents, clod_status *status)
{
    uint64_t next_id = 1;
    bool good = true;
    for (size_t k = 0; good && k < from->grains_count; k++) {
        if (from->grains[k].comes) {
            continue;
        }
        group_plan group;
        pieces->some = next_id > 1;
        good = plan_group(&group, from, k, seed, pieces->taker->share, &next_id, status);
        group.what.pieces = pieces;
        group.what.extent = &extents[k];
        good = good && clod_insert_region(pieces->state, &group.what, status) &&
               clod_setup_pieces_give(pieces, true, status);
        clod_sizes_fini(&group.sizes);
    }
    return good;
}

bool clod_setup_grains_give(const clod_case *from, int64_t seed, const clod_setup_taker *taker,
                            clod_state *state, clod_setup_tally *tally, clod_status *status)
{
    clod_setup_pieces pieces = {.taker = taker, .from = from, .state = state, .tally = tally};
    size_t grains;
    clod_insertion_extent *extents = clod_memory_alloc(from->grains_count, sizeof *extents);
    if (extents == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu groups of grains",
                                from->grains_count);
    }
    bool good = plan_all(from, seed, &pieces, extents, &grains, status) &&
                clod_setup_tally_init(tally, from, state, grains, status) &&
                taker->begin(taker->context, state, grains, status) &&
                give_groups(from, seed, &pieces, extents, status);
    clod_memory_free(extents);
    if (good && pieces.outside.code != CLOD_OK) {
        *status = pieces.outside;
        good = false;
    }
    return good;
}

bool clod_setup_worst_overlap(const clod_state *state, clod_setup_overlap *worst,
                              clod_status *status)
{
    *worst = (clod_setup_overlap){0};
    const clod_grains *grains = &state->grains;
    double low[3], high[3], period[3];
    double largest = 0.0;
    if (grains->count == 0) {
        return true;
    }
    clod_setup_bounds(state, low, high);
    for (int a = 0; a < 3; a++) {
        period[a] =
            state->domain.periodic[a] ? state->domain.max[a] - state->domain.min[a] : 0.0;
    }
    for (size_t g = 0; g < grains->count; g++) {
        largest = fmax(largest, grains->position[g][3]);
    }
    clod_sphere_grid grid = {0};
    bool good =
        clod_sphere_grid_begin(&grid, low, high, period, largest, grains->count, status);
    for (size_t g = 0; good && g < grains->count; g++) {
        const double *place = grains->position[g];
        size_t other = 0;
        const double overlap = clod_sphere_grid_overlap(&grid, place, &other);
        if (overlap > worst->overlap) {
            *worst = (clod_setup_overlap){grains->id[other], grains->id[g], overlap,
                                          overlap / fmin(place[3], grains->position[other][3])};
        }
        good = clod_sphere_grid_add(&grid, place, status);
    }
    clod_sphere_grid_fini(&grid);
    return good;
}
