#include "setup/insertion.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/plural.h"
#include "base/random.h"
#include "base/sort.h"
#include "config/region.h"
#include "setup/insertion_space.h"
#include "state/limits.h"

/** Grains keep this fraction of their radius away from everything, against rounding. */
#define CLEARANCE 1e-6
/** Solid fraction above which random positions are not tried. */
#define RANDOM_LIMIT 0.33
/** Random positions that are tried for one grain. */
#define TRIES 4000
/** Random positions that are tried in a column before its filling front rises. */
#define COLUMN_TRIES 500
/** Solid fraction that a column reaches at the very least. */
#define COLUMN_LEAST 0.1
/** First draw of the layers' random numbers, beyond all tries. */
#define LAYER_DRAWS (UINT64_C(1) << 32)

/** Grains on the way into a state. */
typedef struct clod_insertion_batch {
    const clod_insertion *what;
    double (*place)[4]; ///< [count] radius set, centre to be found; owned
    double largest;     ///< m, largest radius with its clearance
    double volume;      ///< m3, of all grains
    size_t reached;     ///< grains that found a position
} clod_insertion_batch;

static bool batch_init(clod_insertion_batch *self, const clod_insertion *what, size_t grains,
                       clod_status *status)
{
    *self = (clod_insertion_batch){.what = what};
    if (!clod_limits_grains(grains + what->count, status)) {
        return false;
    }
    self->place = clod_memory_alloc(what->count + 1, sizeof *self->place);
    if (self->place == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", what->count);
    }
    for (size_t g = 0; g < what->count; g++) {
        const double radius = clod_sizes_radius(what->sizes, what->seed, what->first_id + g);
        self->place[g][3] = radius;
        self->largest = fmax(self->largest, radius * (1.0 + CLEARANCE));
        self->volume += 4.0 / 3.0 * M_PI * radius * radius * radius;
    }
    return true;
}

static bool batch_append(const clod_insertion_batch *self, clod_state *state,
                         clod_status *status)
{
    const clod_insertion *what = self->what;
    const double spin[3] = {0.0, 0.0, 0.0};
    for (size_t g = 0; g < what->count; g++) {
        if (!clod_grains_add(&state->grains, self->place[g], what->velocity, spin,
                             what->density, what->material, what->first_id + g, status)) {
            return false;
        }
    }
    return true;
}

/** Three random numbers of a grain. */
static void draw(const clod_insertion *what, size_t g, uint64_t number, double u[3])
{
    for (uint64_t k = 0; k < 3; k++) {
        u[k] = clod_random_uniform(what->seed, CLOD_RANDOM_POSITION, what->first_id + g,
                                   3 * number + k);
    }
}

/** Put grain g where `place` says, when that is free; *put tells. False without memory. */
static bool try_place(clod_insertion_batch *batch, clod_insertion_space *space, size_t g,
                      const double place[4], bool *put, clod_status *status)
{
    *put = clod_insertion_space_clear(space, place);
    if (!*put) {
        return true;
    }
    memcpy(batch->place[g], place, 3 * sizeof(double));
    batch->reached++;
    return clod_insertion_space_take(space, place, status);
}

/** Try random positions between two heights for grain g, with draws [first, first + tries). */
static bool try_random(clod_insertion_batch *batch, clod_insertion_space *space, size_t g,
                       const double range[2], uint64_t first, uint64_t tries, bool *put,
                       clod_status *status)
{
    double place[4] = {0.0, 0.0, 0.0, batch->place[g][3] * (1.0 + CLEARANCE)};
    *put = false;
    for (uint64_t t = first; t < first + tries && !*put; t++) {
        double u[3];
        draw(batch->what, g, t, u);
        if (!clod_insertion_space_draw(space, place, range[0], range[1], u)) {
            return true;
        }
        if (!try_place(batch, space, g, place, put, status)) {
            return false;
        }
    }
    return true;
}

/** All grains at random positions, large ones first; stops at the first that finds none. */
static bool fill_random(clod_insertion_batch *batch, clod_insertion_space *space,
                        clod_status *status)
{
    const size_t count = batch->what->count;
    clod_sort_item *items = clod_memory_alloc(2 * count, sizeof *items);
    if (items == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", count);
    }
    for (size_t g = 0; g < count; g++) {
        uint64_t bits; // positive doubles have the order of their bits
        memcpy(&bits, &batch->place[g][3], sizeof bits);
        items[g] = (clod_sort_item){.key = ~bits, .index = g};
    }
    clod_sort(items, items + count, count);
    const double range[2] = {space->low[2], space->high[2]};
    bool good = true;
    bool put = true;
    for (size_t k = 0; good && put && k < count; k++) {
        good = try_random(batch, space, items[k].index, range, 0, TRIES, &put, status);
    }
    clod_memory_free(items);
    return good;
}

/** Whole number of pieces of a length that each have at least `pitch`. */
static int64_t pieces(double length, double pitch)
{
    return (int64_t)(length / pitch * (1.0 + 1e-12));
}

/** Put the next grain of the batch at a site, if it is free there. */
static bool take_site(clod_insertion_batch *batch, clod_insertion_space *space,
                      const double site[3], const double pitch[3], clod_status *status)
{
    const size_t g = batch->reached;
    if (g == batch->what->count) {
        return true;
    }
    double place[4] = {0.0, 0.0, 0.0, batch->place[g][3] * (1.0 + CLEARANCE)};
    double u[3];
    draw(batch->what, g, LAYER_DRAWS, u);
    for (int a = 0; a < 3; a++) {
        const double room = fmax(0.0, pitch[a] - 2.0 * place[3]);
        place[a] = site[a] + (u[a] - 0.5) * room;
    }
    bool put;
    return try_place(batch, space, g, place, &put, status);
}

/** One layer of a box: a grid of square cells. */
static bool layer_box(clod_insertion_batch *batch, clod_insertion_space *space, double z,
                      double height, clod_status *status)
{
    const double wide[2] = {space->high[0] - space->low[0], space->high[1] - space->low[1]};
    const int64_t nx = pieces(wide[0], 2.0 * batch->largest);
    const int64_t ny = pieces(wide[1], 2.0 * batch->largest);
    for (int64_t c = 0; c < nx * ny; c++) {
        const int64_t column = c % nx;
        const int64_t row = c / nx;
        const double pitch[3] = {wide[0] / (double)nx, wide[1] / (double)ny, height};
        const double site[3] = {space->low[0] + ((double)column + 0.5) * pitch[0],
                                space->low[1] + ((double)row + 0.5) * pitch[1], z};
        if (!take_site(batch, space, site, pitch, status)) {
            return false;
        }
    }
    return true;
}

/** One layer of an annulus: rings from the outside in. */
static bool layer_annulus(clod_insertion_batch *batch, clod_insertion_space *space, double z,
                          double height, clod_status *status)
{
    const clod_case_region *region = space->region;
    const double r = batch->largest;
    const double pitch[3] = {0.0, 0.0, height};
    double rho = region->outer_radius - r;
    for (; rho >= 0.0 && (region->inner_radius == 0.0 || rho - r >= region->inner_radius);
         rho -= 2.0 * r) {
        const int64_t sites = rho < r ? 1 : (int64_t)(M_PI / asin(r / rho) * (1.0 + 1e-12));
        double u[3];
        draw(batch->what, batch->reached, LAYER_DRAWS + 1, u);
        for (int64_t s = 0; s < sites; s++) {
            const double angle = 2.0 * M_PI * (u[0] + (double)s / (double)sites);
            const double site[3] = {region->center[0] + rho * cos(angle),
                                    region->center[1] + rho * sin(angle), z};
            if (!take_site(batch, space, site, pitch, status)) {
                return false;
            }
        }
    }
    return true;
}

/** How a layer is put into regions of a kind; NULL: there are none before a face. */
static bool (*const LAYER[])(clod_insertion_batch *batch, clod_insertion_space *space, double z,
                             double height, clod_status *status) = {
    [CLOD_REGION_BOX] = layer_box,
    [CLOD_REGION_ANNULUS] = layer_annulus,
    [CLOD_REGION_RECTANGLE] = NULL, // and discs
};

/** Loose layers from the bottom up. */
static bool fill_layers(clod_insertion_batch *batch, clod_insertion_space *space,
                        clod_status *status)
{
    const double height = space->high[2] - space->low[2];
    const int64_t layers = pieces(height, 2.0 * batch->largest);
    const double pitch = height / (double)layers;
    for (int64_t l = 0; l < layers && batch->reached < batch->what->count; l++) {
        const double z = space->low[2] + ((double)l + 0.5) * pitch;
        if (!LAYER[space->region->kind](batch, space, z, pitch, status)) {
            return false;
        }
    }
    return true;
}

static bool no_room(const clod_insertion_batch *batch, const clod_insertion_space *space,
                    clod_status *status)
{
    const clod_insertion *what = batch->what;
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

/** Fill a region by one method, from an empty region on. */
static bool fill(clod_insertion_batch *batch, const clod_state *state, bool random,
                 clod_status *status)
{
    const clod_case_region *region = batch->what->region;
    const double top = clod_region_row(region)->top(region);
    clod_insertion_space space;
    bool good = clod_insertion_space_init(&space, region, top, state, batch->largest,
                                          batch->what->count, status);
    batch->reached = 0;
    if (good && !random && LAYER[region->kind] == NULL) {
        good = no_room(batch, &space, status);
    } else if (good && random) {
        const double fraction = batch->volume / clod_insertion_space_volume(&space);
        good = fraction > RANDOM_LIMIT || fill_random(batch, &space, status);
    } else if (good) {
        good = fill_layers(batch, &space, status) &&
               (batch->reached == batch->what->count || no_room(batch, &space, status));
    }
    clod_insertion_space_fini(&space);
    return good;
}

bool clod_insert_region(clod_state *state, const clod_insertion *what, clod_status *status)
{
    clod_insertion_batch batch;
    bool good = batch_init(&batch, what, state->grains.count, status) &&
                fill(&batch, state, true, status);
    if (good && batch.reached < what->count) {
        good = fill(&batch, state, false, status);
    }
    good = good && batch_append(&batch, state, status);
    clod_memory_free(batch.place);
    return good;
}

/** Grains in order of id between a bottom and a front that rises when free positions get rare.
 */
static bool fill_column(clod_insertion_batch *batch, clod_insertion_space *space,
                        double *height, clod_status *status)
{
    const double r = batch->largest;
    double range[2] = {space->low[2], space->low[2] + 4.0 * r};
    *height = space->low[2];
    for (size_t g = 0; g < batch->what->count; g++) {
        bool put = false;
        for (uint64_t first = 0; !put; first += COLUMN_TRIES) {
            if (range[1] > space->high[2]) {
                return no_room(batch, space, status);
            }
            if (!try_random(batch, space, g, range, first, COLUMN_TRIES, &put, status)) {
                return false;
            }
            range[1] += put ? 0.0 : 0.5 * r;
            range[0] = fmax(space->low[2], range[1] - 8.0 * r);
        }
        *height = fmax(*height, batch->place[g][2] + batch->place[g][3]);
    }
    return true;
}

bool clod_insert_annulus_column(clod_state *state, const clod_insertion *what, double *height,
                                clod_status *status)
{
    clod_insertion_batch batch;
    clod_insertion_space space = {0};
    const clod_case_region *region = what->region;
    const double outer = region->outer_radius;
    const double inner = region->inner_radius;
    bool good = batch_init(&batch, what, state->grains.count, status);
    const double area = M_PI * (outer * outer - inner * inner);
    const double top =
        region->center[2] + batch.volume / (COLUMN_LEAST * area) + 40.0 * batch.largest;
    good = good &&
           clod_insertion_space_init(&space, region, top, state, batch.largest, what->count,
                                     status) &&
           fill_column(&batch, &space, height, status) && batch_append(&batch, state, status);
    clod_insertion_space_fini(&space);
    clod_memory_free(batch.place);
    return good;
}
