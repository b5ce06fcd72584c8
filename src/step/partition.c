#include "step/partition.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

/** How much longer than the axis of the last cut another one must be to be cut instead. */
#define MUCH_LONGER 1.5

bool clod_partition_init(clod_partition *self, int ranks, clod_status *status)
{
    const double wanted = (double)CLOD_PARTITION_EACH * ranks;
    const double most = fmin(fmax(wanted, CLOD_PARTITION_LEAST), CLOD_PARTITION_MOST);
    const double finer = cbrt(most / CLOD_PARTITION_LEAST);
    *self = (clod_partition){.ranks = ranks,
                             .most = (size_t)most,
                             .across = (int32_t)(CLOD_PARTITION_ACROSS_LEAST * finer)};
    self->weight = clod_memory_alloc(self->most, sizeof *self->weight);
    self->plane = clod_memory_alloc((size_t)ranks, sizeof *self->plane);
    return (self->weight != NULL && self->plane != NULL) ||
           clod_status_fail(status, CLOD_FAILED, "no memory to cut a bed for %d ranks", ranks);
}

size_t clod_partition_blocks(const clod_partition *self)
{
    return (size_t)self->n[0] * (size_t)self->n[1] * (size_t)self->n[2];
}

void clod_partition_begin(clod_partition *self, const double min[3], const double max[3])
{
    double length[3], longest = 0.0;
    for (int a = 0; a < 3; a++) {
        length[a] = max[a] > min[a] ? max[a] - min[a] : 0.0;
        longest = fmax(longest, length[a]);
        self->min[a] = min[a];
    }
    double blocks = INFINITY;
    for (double width = longest / self->across; blocks > (double)self->most; width *= 1.26) {
        blocks = 1.0;
        for (int a = 0; a < 3; a++) {
            const double n = longest > 0.0 ? fmax(floor(length[a] / width), 1.0) : 1.0;
            self->n[a] = (int32_t)fmin(n, self->across);
            self->width[a] = length[a] / (double)self->n[a];
            blocks *= (double)self->n[a];
        }
    }
    memset(self->weight, 0, clod_partition_blocks(self) * sizeof *self->weight);
}

/** Number of the block along an axis in which a coordinate is, or the nearest one. */
static int32_t along(const clod_partition *self, int axis, double x)
{
    const double at = (x - self->min[axis]) / self->width[axis];
    const int32_t last = self->n[axis] - 1;
    return !(at > 0.0) ? 0 : at >= (double)last ? last : (int32_t)at;
}

static size_t block_of(const clod_partition *self, int32_t x, int32_t y, int32_t z)
{
    return ((size_t)z * (size_t)self->n[1] + (size_t)y) * (size_t)self->n[0] + (size_t)x;
}

void clod_partition_add(clod_partition *self, const double position[3], double weight)
{
    self->weight[block_of(self, along(self, 0, position[0]), along(self, 1, position[1]),
                          along(self, 2, position[2]))] += (float)weight;
}

void clod_partition_scale(clod_partition *self, double factor)
{
    const size_t blocks = clod_partition_blocks(self);
    for (size_t b = 0; b < blocks; b++) {
        self->weight[b] *= (float)factor;
    }
}

void clod_partition_merge(float *into, const float *from, size_t blocks)
{
    for (size_t b = 0; b < blocks; b++) {
        into[b] += from[b];
    }
}

int clod_partition_owner(const clod_partition *self, const double position[3])
{
    int first = 0, last = self->ranks;
    while (last - first > 1) {
        const int middle = first + (last - first) / 2;
        const clod_partition_plane plane = self->plane[middle];
        *(position[plane.axis] < plane.at ? &last : &first) = middle;
    }
    return first;
}

// ---- the cut

/** A box of ranks [first, last); lengths in blocks. */
typedef struct piece {
    double low[3], high[3];
    int first, last;
} piece;

/** What of block k is between two places along an axis. */
static double share_of(int32_t k, double low, double high)
{
    return fmax(fmin(high, (double)k + 1.0) - fmax(low, (double)k), 0.0);
}

/** Blocks that a piece has a share of along an axis: [range[0], range[1]). */
static void blocks_of(const piece *at, int axis, int32_t range[2])
{
    range[0] = (int32_t)floor(at->low[axis]);
    range[1] = (int32_t)ceil(at->high[axis]);
}

/** Weight in each slice of a piece across an axis; of all. */
static double weigh(const clod_partition *self, const piece *at, int axis,
                    double slice[CLOD_PARTITION_ACROSS_MOST])
{
    int32_t range[3][2];
    double all = 0.0;
    for (int a = 0; a < 3; a++) {
        blocks_of(at, a, range[a]);
    }
    memset(slice, 0, CLOD_PARTITION_ACROSS_MOST * sizeof *slice);
    for (int32_t z = range[2][0]; z < range[2][1]; z++) {
        for (int32_t y = range[1][0]; y < range[1][1]; y++) {
            const double row =
                share_of(z, at->low[2], at->high[2]) * share_of(y, at->low[1], at->high[1]);
            for (int32_t x = range[0][0]; x < range[0][1]; x++) {
                const int32_t k[3] = {x, y, z};
                const double weight = row * share_of(x, at->low[0], at->high[0]) *
                                      (double)self->weight[block_of(self, x, y, z)];
                slice[k[axis]] += weight;
                all += weight;
            }
        }
    }
    return all;
}

/** The axis of the last cut, or the longest if that is much longer. */
static int choose_axis(const clod_partition *self, const piece *at, int before)
{
    double length[3];
    int best = self->exists ? before : 0;
    for (int a = 0; a < 3; a++) {
        length[a] = (at->high[a] - at->low[a]) * self->width[a];
    }
    for (int a = 0; a < 3; a++) {
        const double kept = self->exists && best == before ? MUCH_LONGER : 1.0;
        best = length[a] > kept * length[best] ? a : best;
    }
    return best;
}

/** Where a piece has so much of its weight below. */
static double cut_at(const piece *at, int axis, const double slice[CLOD_PARTITION_ACROSS_MOST],
                     double wanted)
{
    int32_t range[2];
    double below = 0.0;
    blocks_of(at, axis, range);
    for (int32_t k = range[0]; k < range[1]; k++) {
        const double low = fmax((double)k, at->low[axis]);
        if (slice[k] > 0.0 && below + slice[k] >= wanted) {
            return low +
                   share_of(k, at->low[axis], at->high[axis]) * (wanted - below) / slice[k];
        }
        below += slice[k];
    }
    return at->high[axis];
}

void clod_partition_cut(clod_partition *self)
{
    piece stack[64]; // halves of ranks: as deep as the bits of an int
    int depth = 0;
    bool some = false;
    stack[depth++] = (piece){.high = {self->n[0], self->n[1], self->n[2]}, .last = self->ranks};
    while (depth > 0) {
        const piece at = stack[--depth];
        const int ranks = at.last - at.first;
        if (ranks == 1) {
            continue;
        }
        double slice[CLOD_PARTITION_ACROSS_MOST];
        const int lower = ranks / 2, middle = at.first + lower;
        clod_partition_plane *plane = &self->plane[middle];
        const int axis = plane->axis = choose_axis(self, &at, plane->axis);
        const double all = weigh(self, &at, axis, slice);
        some = some || all > 0.0;
        const double cut = cut_at(&at, axis, slice, all * (double)lower / (double)ranks);
        plane->at = self->min[axis] + self->width[axis] * cut;
        piece left = at, right = at;
        left.last = right.first = middle;
        left.high[axis] = right.low[axis] = cut;
        stack[depth++] = right;
        stack[depth++] = left;
    }
    self->exists = self->exists || some; // all pieces of a first cut have no axis to keep
}

// ---- boxes

void clod_partition_bound(clod_partition *self, const double min[3], const double max[3])
{
    memcpy(self->low, min, sizeof self->low);
    memcpy(self->high, max, sizeof self->high);
}

/** Box of ranks [first, last). */
typedef struct span {
    double low[3], high[3]; ///< m
    int first, last;
} span;

/** Whether a place is within `reach` of a box along every axis. */
static bool is_near(const span *at, const clod_domain *domain, const double position[3],
                    double reach)
{
    bool near = true;
    for (int a = 0; a < 3; a++) {
        const double half = 0.5 * (at->high[a] - at->low[a]);
        const double middle = at->low[a] + half;
        const double off = fabs(clod_domain_separation(domain, a, position[a], middle)) - half;
        near = near && half >= 0.0 && off <= reach;
    }
    return near;
}

int clod_partition_reach(const clod_partition *self, const clod_domain *domain,
                         const double position[3], double reach, int *rank)
{
    span stack[64]; // halves of ranks: as deep as the bits of an int
    int depth = 0, count = 0;
    stack[depth] = (span){.first = 0, .last = self->ranks};
    memcpy(stack[depth].low, self->low, sizeof self->low);
    memcpy(stack[depth++].high, self->high, sizeof self->high);
    while (depth > 0) {
        const span at = stack[--depth];
        if (!is_near(&at, domain, position, reach)) {
            continue;
        }
        if (at.last - at.first == 1) {
            rank[count++] = at.first;
            continue;
        }
        const int middle = at.first + (at.last - at.first) / 2;
        const clod_partition_plane plane = self->plane[middle];
        span lower = at, upper = at;
        lower.last = upper.first = middle;
        lower.high[plane.axis] = fmin(at.high[plane.axis], plane.at);
        upper.low[plane.axis] = fmax(at.low[plane.axis], plane.at);
        if (upper.low[plane.axis] <= at.high[plane.axis]) { // else it has none
            stack[depth++] = upper;
        }
        if (plane.at > at.low[plane.axis]) {
            stack[depth++] = lower;
        }
    }
    return count;
}

void clod_partition_fini(clod_partition *self)
{
    clod_memory_free(self->weight);
    clod_memory_free(self->plane);
    *self = (clod_partition){0};
}
