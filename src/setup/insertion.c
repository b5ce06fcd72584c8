#include "setup/insertion.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/plural.h"
#include "base/random.h"
#include "base/sort.h"
#include "config/region.h"
#include "setup/insertion_batch.h"
#include "setup/insertion_space.h"
#include "state/limits.h"

/** Solid fraction above which random positions are not tried. */
#define RANDOM_LIMIT 0.33
/** Random positions that are tried in a column before its filling front rises. */
#define COLUMN_TRIES 500
/** Solid fraction that a column reaches at the very least. */
#define COLUMN_LEAST 0.1

double clod_insertion_batch_radius(const clod_insertion_batch *self, size_t g)
{
    const clod_insertion *what = self->what;
    return clod_sizes_radius(what->sizes, what->seed, what->first_id + g);
}

clod_insertion_extent clod_insertion_measure(const clod_insertion *self)
{
    clod_insertion_extent extent = {0};
    for (size_t g = 0; g < self->count; g++) {
        const double radius = clod_sizes_radius(self->sizes, self->seed, self->first_id + g);
        extent.largest = fmax(extent.largest, radius);
        extent.volume += 4.0 / 3.0 * M_PI * radius * radius * radius;
    }
    return extent;
}

static bool batch_init(clod_insertion_batch *self, clod_state *state,
                       const clod_insertion *what, clod_status *status)
{
    *self = (clod_insertion_batch){.what = what, .state = state, .before = state->grains.count};
    if (!clod_limits_grains(self->before + what->count, status)) {
        return false;
    }
    const clod_insertion_extent extent =
        what->extent != NULL ? *what->extent : clod_insertion_measure(what);
    self->largest = extent.largest * (1.0 + CLOD_INSERTION_CLEARANCE);
    self->volume = extent.volume;
    return true;
}

bool clod_insertion_batch_put(const clod_insertion_batch *self, size_t g,
                              const double sphere[4], clod_status *status)
{
    const clod_insertion *what = self->what;
    const double spin[3] = {0.0, 0.0, 0.0};
    return clod_grains_add(&self->state->grains, sphere, what->velocity, spin, what->density,
                           what->material, what->first_id + g, status) &&
           (what->pieces == NULL || clod_setup_pieces_give(what->pieces, false, status));
}

void clod_insertion_batch_draw(const clod_insertion_batch *self, size_t g, uint64_t number,
                               double u[3])
{
    const clod_insertion *what = self->what;
    for (uint64_t k = 0; k < 3; k++) {
        u[k] = clod_random_uniform(what->seed, CLOD_RANDOM_POSITION, what->first_id + g,
                                   3 * number + k);
    }
}

/** Least size of a region, within which a sphere has to be whole [m]. */
static double thickness(const clod_insertion_space *space)
{
    const clod_case_region *region = space->region;
    double least = HUGE_VAL;
    for (int a = 0; a < 3 && !space->face; a++) {
        least = space->through[a] ? least : fmin(least, space->high[a] - space->low[a]);
    }
    if (space->face) {
        least = 2.0 * fmin(space->half[0], space->half[1]);
    } else if (clod_region_row(region)->upright && region->inner_radius > 0.0) {
        least = fmin(least, region->outer_radius - region->inner_radius);
    }
    return least;
}

bool clod_insertion_batch_no_room(const clod_insertion_batch *batch,
                                  const clod_insertion_space *space, clod_status *status)
{
    const clod_insertion *what = batch->what;
    const double thick = thickness(space);
    if (thick < 2.0 * batch->largest) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "%s%s: is %.4g mm thick, no thicker than a grain with its clearance: the largest has "
            "%.4g mm, and grains lie whole in it. Make it thicker, as a rule several grains",
            what->name, strncmp(what->name, "grains.", 7) == 0 ? ".region" : "", 1e3 * thick,
            2e3 * batch->largest / (1.0 + CLOD_INSERTION_CLEARANCE));
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        "%s: only %zu of %zu grain%s fit%s into the region (%s, x %g to %g m, y %g to %g m, z "
        "%g "
        "to %g m) clear of walls and of each other; their solid volume is %.3g times that of "
        "the region, 0.3 fits at random and about 0.45 in layers. Make the region larger (it "
        "may be "
        "higher than the settled bed), or ask for fewer or smaller grains",
        what->name, batch->reached, what->count, clod_plural((double)what->count),
        what->count == 1 ? "s" : "", clod_region_row(space->region)->name, space->low[0],
        space->high[0], space->low[1], space->high[1], space->low[2], space->high[2],
        batch->volume / clod_insertion_space_volume(space));
}

// ---- random positions: they are appended in order of id when all have one

/** Grains at random positions. */
typedef struct scatter {
    clod_insertion_batch *batch;
    clod_insertion_space *space;
    uint32_t *sphere; ///< [count] where the grid has them; owned
} scatter;

static bool fail_without_memory(const clod_insertion_batch *batch, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains",
                            batch->what->count);
}

static bool scatter_init(scatter *self, clod_insertion_batch *batch,
                         clod_insertion_space *space, clod_status *status)
{
    const size_t count = batch->what->count;
    *self = (scatter){batch, space, clod_memory_alloc(count + 1, sizeof *self->sphere)};
    return self->sphere != NULL || fail_without_memory(batch, status);
}

/** Centre of a grain that was put, and its radius with its clearance [m]. */
static const double *scatter_place(const scatter *self, size_t g)
{
    return self->space->grid.sphere[self->sphere[g]];
}

static bool scatter_append(const scatter *self, clod_status *status)
{
    bool good = true;
    for (size_t g = 0; good && g < self->batch->what->count; g++) {
        const double *place = scatter_place(self, g);
        const double sphere[4] = {place[0], place[1], place[2],
                                  clod_insertion_batch_radius(self->batch, g)};
        good = clod_insertion_batch_put(self->batch, g, sphere, status);
    }
    return good;
}

/** Put grain g where `place` says, when that is free; *put tells. False without memory. */
static bool try_place(const scatter *self, size_t g, const double place[4], bool *put,
                      clod_status *status)
{
    *put = clod_insertion_space_clear(self->space, place);
    if (!*put) {
        return true;
    }
    self->sphere[g] = (uint32_t)self->space->grid.sphere_count;
    self->batch->reached++;
    return clod_insertion_space_take(self->space, place, status);
}

/** Try random positions between two heights for grain g, with draws [first, first + tries). */
static bool try_random(const scatter *self, size_t g, const double range[2], uint64_t first,
                       uint64_t tries, bool *put, clod_status *status)
{
    double place[4] = {0.0};
    place[3] = clod_insertion_batch_radius(self->batch, g) * (1.0 + CLOD_INSERTION_CLEARANCE);
    *put = false;
    for (uint64_t t = first; t < first + tries && !*put; t++) {
        double u[3];
        clod_insertion_batch_draw(self->batch, g, t, u);
        if (!clod_insertion_space_draw(self->space, place, range[0], range[1], u)) {
            return true;
        }
        if (!try_place(self, g, place, put, status)) {
            return false;
        }
    }
    return true;
}

/** Numbers of all grains, large ones first; owned by the caller. NULL without memory. */
static uint32_t *order_by_size(const clod_insertion_batch *batch)
{
    const size_t count = batch->what->count;
    clod_sort_item *items = clod_memory_alloc(2 * count, sizeof *items);
    uint32_t *order = clod_memory_alloc(count, sizeof *order);
    for (size_t g = 0; items != NULL && g < count; g++) {
        const double radius = clod_insertion_batch_radius(batch, g);
        uint64_t bits; // positive doubles have the order of their bits
        memcpy(&bits, &radius, sizeof bits);
        items[g] = (clod_sort_item){.key = ~bits, .index = g};
    }
    if (items != NULL && order != NULL) {
        clod_sort(items, items + count, count);
        for (size_t k = 0; k < count; k++) {
            order[k] = (uint32_t)items[k].index;
        }
    } else {
        clod_memory_free(order);
        order = NULL;
    }
    clod_memory_free(items);
    return order;
}

/** All grains at random positions, in an order; stops at the first that finds none. */
static bool fill_random(const scatter *self, const uint32_t *order, clod_status *status)
{
    const double range[2] = {self->space->low[2], self->space->high[2]};
    bool good = true;
    bool put = true;
    for (size_t k = 0; good && put && k < self->batch->what->count; k++) {
        good = try_random(self, order[k], range, 0, CLOD_INSERTION_TRIES, &put, status);
    }
    return good;
}

/** Try random positions for all grains; nothing is appended when one finds none. */
static bool scatter_all(clod_insertion_batch *batch, clod_insertion_space *space,
                        clod_status *status)
{
    scatter self;
    uint32_t *order = order_by_size(batch);
    const bool good =
        scatter_init(&self, batch, space, status) &&
        (order != NULL || fail_without_memory(batch, status)) &&
        clod_insertion_space_block(space, space->low[2], space->high[2], status) &&
        clod_insertion_space_band(space, space->low[2], space->high[2], batch->what->count,
                                  status) &&
        fill_random(&self, order, status) &&
        (batch->reached < batch->what->count || scatter_append(&self, status));
    clod_memory_free(order);
    clod_memory_free(self.sphere);
    return good;
}

/** Fill a region, from an empty one on. */
static bool fill(clod_insertion_batch *batch, clod_status *status)
{
    const clod_insertion *what = batch->what;
    const clod_case_region *region = what->region;
    const double top = clod_region_row(region)->top(region);
    clod_insertion_space space;
    bool good =
        clod_insertion_space_open(&space, region, top, batch->state, batch->largest, status);
    space.pieces = what->pieces;
    const double fraction = batch->volume / clod_insertion_space_volume(&space);
    const bool kept = what->pieces != NULL && what->pieces->taker->keeper != NULL;
    good = good &&
           (fraction > RANDOM_LIMIT || (kept ? clod_insertion_kept_fill(batch, &space, status)
                                             : scatter_all(batch, &space, status)));
    if (good && batch->reached < what->count) {
        batch->reached = 0;
        good = clod_insertion_layers_fill(batch, &space, status);
    }
    clod_insertion_space_fini(&space);
    return good;
}

bool clod_insert_region(clod_state *state, const clod_insertion *what, clod_status *status)
{
    clod_insertion_batch batch;
    const bool good = batch_init(&batch, state, what, status) && fill(&batch, status);
    if (!good && what->pieces == NULL && state->grains.count > batch.before) {
        state->grains.count = batch.before;
        clod_grains_pad(&state->grains);
    }
    return good;
}

/** Grains in order of id between a bottom and a front that rises when free positions get rare.
 */
static bool fill_column(const scatter *self, double *height, clod_status *status)
{
    const clod_insertion_space *space = self->space;
    const double r = self->batch->largest;
    double range[2] = {space->low[2], space->low[2] + 4.0 * r};
    *height = space->low[2];
    for (size_t g = 0; g < self->batch->what->count; g++) {
        bool put = false;
        for (uint64_t first = 0; !put; first += COLUMN_TRIES) {
            if (range[1] > space->high[2]) {
                return clod_insertion_batch_no_room(self->batch, space, status);
            }
            if (!try_random(self, g, range, first, COLUMN_TRIES, &put, status)) {
                return false;
            }
            range[1] += put ? 0.0 : 0.5 * r;
            range[0] = fmax(space->low[2], range[1] - 8.0 * r);
        }
        *height = fmax(*height,
                       scatter_place(self, g)[2] + clod_insertion_batch_radius(self->batch, g));
    }
    return true;
}

bool clod_insert_annulus_column(clod_state *state, const clod_insertion *what, double *height,
                                clod_status *status)
{
    clod_insertion_batch batch;
    clod_insertion_space space = {0};
    scatter self = {0};
    const clod_case_region *region = what->region;
    const double outer = region->outer_radius;
    const double inner = region->inner_radius;
    bool good =
        batch_init(&batch, state, what, status) && scatter_init(&self, &batch, &space, status);
    const double area = M_PI * (outer * outer - inner * inner);
    const double top =
        region->center[2] + batch.volume / (COLUMN_LEAST * area) + 40.0 * batch.largest;
    good = good &&
           clod_insertion_space_init(&space, region, top, state, batch.largest, what->count,
                                     status) &&
           fill_column(&self, height, status) && scatter_append(&self, status);
    clod_insertion_space_fini(&space);
    clod_memory_free(self.sphere);
    return good;
}
