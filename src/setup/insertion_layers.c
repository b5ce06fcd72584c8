// Grains in loose layers from the bottom up. A grain stays in its layer, so only those of the same layer and
// of the one below can be in its way (and of the first one, where the region repeats upwards): a band of
// layers at a time is looked at, and no list of all grains is needed.
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"
#include "config/region.h"
#include "setup/insertion_batch.h"

/** First draw of the layers' random numbers, beyond all tries. */
#define LAYER_DRAWS (UINT64_C(1) << 32)
/** Sites that a band has at least. */
#define BAND_SITES 16384.0

/** The grains of a layer. */
typedef struct layer {
    double (*place)[4]; ///< [count] owned
    size_t count, room;
} layer;

/** A region on its way to be full. */
typedef struct filling {
    clod_insertion_batch *batch;
    clod_insertion_space *space;
    double pitch;   ///< m, height of a layer
    int64_t layers; ///< in all
    int64_t band;   ///< layers in a band
    int64_t block;  ///< bands for which the grains that were there before are collected at once
    double sites;   ///< of a layer, about
    layer first, last; ///< the first of all, and the newest
    bool is_first;     ///< it is being filled
} filling;

static void note(layer *self, const double place[4])
{
    memcpy(self->place[self->count++], place, sizeof *self->place);
}

/** Room for one more grain. */
static bool make_room(layer *self, clod_status *status)
{
    return clod_room_for_one(&self->place, &self->room, self->count, sizeof *self->place) ||
           clod_status_fail(status, CLOD_FAILED, "no memory for a layer of %zu grains",
                            self->count);
}

/** Whole number of pieces of a length that each have at least `pitch`. */
static int64_t pieces(double length, double pitch)
{
    return (int64_t)(length / pitch * (1.0 + 1e-12));
}

/** Put the next grain of the batch where it is free; place[3] is its radius [m] with its clearance. */
static bool put(filling *self, const double place[4], double radius, clod_status *status)
{
    const double sphere[4] = {place[0], place[1], place[2], radius};
    layer *first = self->is_first ? &self->first : &self->last;
    if (!make_room(&self->last, status) || !make_room(first, status)) {
        return false;
    }
    note(&self->last, place);
    if (self->is_first) {
        note(first, place);
    }
    return clod_insertion_space_take(self->space, place, status) &&
           clod_insertion_batch_put(self->batch, self->batch->reached++, sphere, status);
}

/** Put the next grain of the batch at a site, if it is free there. */
static bool take_site(filling *self, const double site[3], const double pitch[3],
                      clod_status *status)
{
    const clod_insertion_batch *batch = self->batch;
    const size_t g = batch->reached;
    if (g == batch->what->count) {
        return true;
    }
    double u[3];
    double place[4];
    clod_insertion_batch_draw(batch, g, LAYER_DRAWS, u);
    const double radius = clod_insertion_batch_radius(batch, g);
    place[3] = radius * (1.0 + CLOD_INSERTION_CLEARANCE);
    for (int a = 0; a < 3; a++) {
        const double room = fmax(0.0, pitch[a] - 2.0 * place[3]);
        place[a] = site[a] + (u[a] - 0.5) * room;
    }
    return !clod_insertion_space_clear(self->space, place) || put(self, place, radius, status);
}

/** One layer of a box: a grid of square cells. */
static bool layer_box(filling *self, double z, clod_status *status)
{
    const clod_insertion_space *space = self->space;
    const double wide[2] = {space->high[0] - space->low[0], space->high[1] - space->low[1]};
    const int64_t nx = pieces(wide[0], 2.0 * self->batch->largest);
    const int64_t ny = pieces(wide[1], 2.0 * self->batch->largest);
    for (int64_t c = 0; c < nx * ny; c++) {
        const int64_t column = c % nx;
        const int64_t row = c / nx;
        const double pitch[3] = {wide[0] / (double)nx, wide[1] / (double)ny, self->pitch};
        const double site[3] = {space->low[0] + ((double)column + 0.5) * pitch[0],
                                space->low[1] + ((double)row + 0.5) * pitch[1], z};
        if (!take_site(self, site, pitch, status)) {
            return false;
        }
    }
    return true;
}

/** One layer of an annulus: rings from the outside in. */
static bool layer_annulus(filling *self, double z, clod_status *status)
{
    const clod_case_region *region = self->space->region;
    const double r = self->batch->largest;
    const double pitch[3] = {0.0, 0.0, self->pitch};
    double rho = region->outer_radius - r;
    for (; rho >= 0.0 && (region->inner_radius == 0.0 || rho - r >= region->inner_radius);
         rho -= 2.0 * r) {
        const int64_t sites = rho < r ? 1 : (int64_t)(M_PI / asin(r / rho) * (1.0 + 1e-12));
        double u[3];
        clod_insertion_batch_draw(self->batch, self->batch->reached, LAYER_DRAWS + 1, u);
        for (int64_t s = 0; s < sites; s++) {
            const double angle = 2.0 * M_PI * (u[0] + (double)s / (double)sites);
            const double site[3] = {region->center[0] + rho * cos(angle),
                                    region->center[1] + rho * sin(angle), z};
            if (!take_site(self, site, pitch, status)) {
                return false;
            }
        }
    }
    return true;
}

/** How a layer is put into regions of a kind; NULL: there are none before a face. */
static bool (*const LAYER[])(filling *self, double z, clod_status *status) = {
    [CLOD_REGION_BOX] = layer_box,
    [CLOD_REGION_ANNULUS] = layer_annulus,
    [CLOD_REGION_RECTANGLE] = NULL, // and discs
};

static bool take_layer(clod_insertion_space *space, const layer *grains, clod_status *status)
{
    bool good = true;
    for (size_t k = 0; good && k < grains->count; k++) {
        good = clod_insertion_space_take(space, grains->place[k], status);
    }
    return good;
}

/** Heights between which some layers from l on are [m]; the number of layers. */
static int64_t range_of(const filling *self, int64_t l, int64_t layers, double range[2])
{
    const clod_insertion_space *space = self->space;
    const int64_t end = l + layers < self->layers ? l + layers : self->layers;
    range[0] = space->low[2] + (double)l * self->pitch;
    range[1] = end == self->layers ? space->high[2] : space->low[2] + (double)end * self->pitch;
    return end - l;
}

/** Whether images of the first layer, a period higher, reach what is below a height. */
static bool first_reaches(const filling *self, double top)
{
    const clod_domain *domain = &self->space->state->domain;
    const double period = domain->max[2] - domain->min[2];
    return domain->periodic[2] &&
           top + 2.0 * self->batch->largest >= self->space->low[2] + period;
}

/** Begin the band of layers from l on: what may be in the way of its grains is noted. */
static bool begin_band(filling *self, int64_t l, clod_status *status)
{
    clod_insertion_space *space = self->space;
    double range[2];
    if (l % (self->band * self->block) == 0) {
        range_of(self, l, self->band * self->block, range);
        if (!clod_insertion_space_block(space, range[0], range[1], status)) {
            return false;
        }
    }
    const double sites = self->sites * (double)range_of(self, l, self->band, range);
    return clod_insertion_space_band(space, range[0], range[1], (size_t)sites, status) &&
           take_layer(space, &self->last, status) &&
           (self->last.count == 0 || !first_reaches(self, range[1]) ||
            take_layer(space, &self->first, status));
}

static bool fill(filling *self, clod_status *status)
{
    const clod_insertion_batch *batch = self->batch;
    const clod_insertion_space *space = self->space;
    bool good = true;
    for (int64_t l = 0; good && l < self->layers && batch->reached < batch->what->count; l++) {
        const double z = space->low[2] + ((double)l + 0.5) * self->pitch;
        good = l % self->band != 0 || begin_band(self, l, status);
        self->last.count = 0;
        self->is_first = l == 0;
        good = good && LAYER[space->region->kind](self, z, status);
    }
    return good && (batch->reached == batch->what->count ||
                    clod_insertion_batch_no_room(batch, space, status));
}

bool clod_insertion_layers_fill(clod_insertion_batch *batch, clod_insertion_space *space,
                                clod_status *status)
{
    if (LAYER[space->region->kind] == NULL) {
        return clod_insertion_batch_no_room(batch, space, status);
    }
    const double height = space->high[2] - space->low[2];
    const double wide = 2.0 * batch->largest;
    filling self = {.batch = batch, .space = space, .layers = pieces(height, wide)};
    self.pitch = height / (double)self.layers;
    self.sites = clod_region_area(space->region) / (wide * wide) + 1.0;
    self.band = (int64_t)ceil(BAND_SITES / self.sites);
    self.block = (int64_t)ceil(sqrt((double)self.layers / (double)self.band));
    const bool good = fill(&self, status);
    clod_memory_free(self.first.place);
    clod_memory_free(self.last.place);
    return good;
}
