#include "setup/grains.h"

#include <math.h>
#include <stdio.h>

#include "base/assert.h"
#include "base/memory.h"
#include "base/sort.h"
#include "setup/domain.h"
#include "setup/grains_file.h"
#include "setup/insertion.h"
#include "setup/insertion_grid.h"

/** Base area of a region [m2]. */
static double base_area(const clod_case_region *region)
{
    if (region->kind == CLOD_REGION_BOX) {
        return (region->max[0] - region->min[0]) * (region->max[1] - region->min[1]);
    }
    return M_PI * (region->outer_radius * region->outer_radius -
                   region->inner_radius * region->inner_radius);
}

/** Number of grains of a group that is not given one by one. */
static size_t group_count(const clod_case_grains *group, const clod_insertion *what)
{
    if (group->count > 0) {
        return (size_t)group->count;
    }
    const double volume = group->mass > 0.0 ? group->mass / what->density
                                            : group->fill_height * group->fill_fraction *
                                                  base_area(&group->region);
    return clod_sizes_count(what->sizes, what->seed, what->first_id, volume);
}

static bool insert_group(const clod_case *from, const clod_case_grains *group, const char *name,
                         int64_t seed, uint64_t *next_id, clod_state *state,
                         clod_status *status)
{
    const int material = clod_case_material_index(from, group->material);
    CLOD_ASSERT(material >= 0); // checked at load
    clod_sizes sizes;
    clod_insertion what = {
        .name = name,
        .region = &group->region,
        .sizes = &sizes,
        .seed = (uint64_t)seed,
        .first_id = *next_id,
        .material = (uint16_t)material,
        .density = from->materials[material].density,
        .velocity = {group->velocity[0], group->velocity[1], group->velocity[2]}};
    bool good = clod_sizes_init(&sizes, group, status);
    if (good) {
        what.count = group_count(group, &what);
        good = clod_insert_region(state, &what, status);
        *next_id += what.count;
        clod_sizes_fini(&sizes);
    }
    return good;
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

bool clod_setup_grains(const clod_case *from, int64_t seed, clod_state *state,
                       clod_status *status)
{
    uint64_t next_id = 1;
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        char name[32];
        snprintf(name, sizeof name, "grains[%zu]", k);
        const bool good =
            group->file != NULL
                ? clod_grains_file_read(from, group, &next_id, &state->grains, status)
                : insert_group(from, group, name, seed, &next_id, state, status);
        if (!good) {
            return false;
        }
    }
    return check_ids(&state->grains, status);
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
        largest = fmax(largest, grains->place[g][3]);
    }
    clod_insertion_grid grid;
    bool good =
        clod_insertion_grid_init(&grid, low, high, period, largest, grains->count, status);
    for (size_t g = 0; good && g < grains->count; g++) {
        const double *place = grains->place[g];
        size_t other = 0;
        const double overlap = clod_insertion_grid_overlap(&grid, place, &other);
        if (overlap > worst->overlap) {
            *worst = (clod_setup_overlap){grains->id[other], grains->id[g], overlap,
                                          overlap / fmin(place[3], grains->place[other][3])};
        }
        good = clod_insertion_grid_add(&grid, place, status);
    }
    clod_insertion_grid_fini(&grid);
    return good;
}
