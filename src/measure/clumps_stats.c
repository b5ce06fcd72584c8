// What clumps of a moment are, all together.
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/sort.h"
#include "measure/clumps.h"

static double diameter(double volume)
{
    return cbrt(6.0 / M_PI * volume);
}

/** Diameters below which shares of the mass are: clumps from small to large. */
static bool find_quantiles(const clod_clumps *self, clod_clump_stats *stats)
{
    static const double SHARE[3] = {0.1, 0.5, 0.9};
    double *const at[3] = {&stats->d10, &stats->d50, &stats->d90};
    clod_sort_item *item = clod_memory_alloc(2 * self->count + 1, sizeof *item);
    if (item == NULL) {
        return false;
    }
    for (size_t k = 0; k < self->count; k++) {
        item[k].index = k;
        memcpy(&item[k].key, &self->clump[k].volume, sizeof item[k].key); // ascends as > 0
    }
    clod_sort(item, item + self->count, self->count);
    double mass = 0.0;
    int next = 0;
    for (size_t k = 0; k < self->count; k++) {
        const clod_clump *clump = &self->clump[item[k].index];
        mass += clump->mass;
        const bool last = k + 1 == self->count;
        for (; next < 3 && (last || mass >= SHARE[next] * stats->mass); next++) {
            *at[next] = diameter(clump->volume);
        }
    }
    clod_memory_free(item);
    return true;
}

bool clod_clumps_sum_up(const clod_clumps *self, clod_clump_stats *stats,
                        clod_clump_sizes *sizes, clod_status *status)
{
    *stats = (clod_clump_stats){.number = (double)self->count};
    *sizes = (clod_clump_sizes){0};
    double by_mass = 0.0;
    for (size_t k = 0; k < self->count; k++) {
        const clod_clump *clump = &self->clump[k];
        const int at = clod_clump_class(clump->grains);
        stats->grains += clump->grains;
        stats->mass += clump->mass;
        by_mass += clump->mass * clump->grains;
        stats->largest = fmax(stats->largest, clump->grains);
        stats->largest_mass = fmax(stats->largest_mass, clump->mass);
        sizes->number[at] += 1.0;
        sizes->mass[at] += clump->mass;
    }
    if (self->count == 0) {
        return true;
    }
    stats->share = stats->mass / self->grains_mass;
    stats->mean = stats->grains / stats->number;
    stats->mean_by_mass = by_mass / stats->mass;
    return find_quantiles(self, stats) ||
           clod_status_fail(status, CLOD_FAILED, "no memory for %zu clumps", self->count);
}
