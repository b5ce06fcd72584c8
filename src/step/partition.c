#include "step/partition.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

bool clod_partition_init(clod_partition *self, int ranks, clod_status *status)
{
    *self = (clod_partition){.ranks = ranks};
    self->owner = clod_memory_alloc(CLOD_PARTITION_BLOCKS, sizeof *self->owner);
    self->weight = clod_memory_alloc(CLOD_PARTITION_BLOCKS, sizeof *self->weight);
    self->low = clod_memory_alloc((size_t)ranks, sizeof *self->low);
    self->high = clod_memory_alloc((size_t)ranks, sizeof *self->high);
    return (self->owner != NULL && self->weight != NULL && self->low != NULL &&
            self->high != NULL) ||
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
    for (double width = longest / CLOD_PARTITION_ACROSS; blocks > CLOD_PARTITION_BLOCKS;
         width *= 1.26) {
        blocks = 1.0;
        for (int a = 0; a < 3; a++) {
            const double n = longest > 0.0 ? fmax(floor(length[a] / width), 1.0) : 1.0;
            self->n[a] = (int32_t)fmin(n, CLOD_PARTITION_ACROSS);
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

static size_t block_at(const clod_partition *self, const double p[3])
{
    return block_of(self, along(self, 0, p[0]), along(self, 1, p[1]), along(self, 2, p[2]));
}

void clod_partition_add(clod_partition *self, const double position[3])
{
    self->weight[block_at(self, position)]++;
}

void clod_partition_merge(int32_t *into, const int32_t *from, size_t blocks)
{
    for (size_t b = 0; b < blocks; b++) {
        into[b] = into[b] < INT32_MAX - from[b] ? into[b] + from[b] : INT32_MAX;
    }
}

int clod_partition_owner(const clod_partition *self, const double position[3])
{
    return self->owner[block_at(self, position)];
}

/** Blocks [low, high) of ranks [first, last). */
typedef struct piece {
    int32_t low[3], high[3];
    int first, last;
} piece;

/** Grains in each slice of a piece across an axis; of all. */
static int64_t weigh(const clod_partition *self, const piece *at, int axis,
                     int64_t slice[CLOD_PARTITION_ACROSS])
{
    int64_t all = 0;
    memset(slice, 0, CLOD_PARTITION_ACROSS * sizeof *slice);
    for (int32_t z = at->low[2]; z < at->high[2]; z++) {
        for (int32_t y = at->low[1]; y < at->high[1]; y++) {
            for (int32_t x = at->low[0]; x < at->high[0]; x++) {
                const int32_t k[3] = {x, y, z};
                const int32_t weight = self->weight[block_of(self, x, y, z)];
                slice[k[axis]] += weight;
                all += weight;
            }
        }
    }
    return all;
}

/** The axis along which a piece is longest; of equal ones the one with most blocks. */
static int longest_axis(const clod_partition *self, const piece *at)
{
    int best = 0;
    double most = -1.0;
    for (int a = 0; a < 3; a++) {
        const int32_t n = at->high[a] - at->low[a];
        const double length = n > 1 ? (double)n * self->width[a] : 0.0;
        if (length > most) {
            most = length;
            best = a;
        }
    }
    return best;
}

/** Where to cut: the lower ranks get the share of the grains that is nearest to theirs. */
static int32_t cut_at(const piece *at, int axis, const int64_t slice[CLOD_PARTITION_ACROSS],
                      double wanted)
{
    int32_t best = at->low[axis];
    double below = 0.0, least = INFINITY;
    for (int32_t k = at->low[axis]; k <= at->high[axis]; k++) {
        if (fabs(below - wanted) < least) {
            least = fabs(below - wanted);
            best = k;
        }
        below += k < at->high[axis] ? (double)slice[k] : 0.0;
    }
    return best;
}

/** A piece for one rank alone. */
static void give(clod_partition *self, const piece *at)
{
    for (int a = 0; a < 3; a++) {
        self->low[at->first][a] = self->min[a] + self->width[a] * (double)at->low[a];
        self->high[at->first][a] = self->min[a] + self->width[a] * (double)at->high[a];
    }
    for (int32_t z = at->low[2]; z < at->high[2]; z++) {
        for (int32_t y = at->low[1]; y < at->high[1]; y++) {
            for (int32_t x = at->low[0]; x < at->high[0]; x++) {
                self->owner[block_of(self, x, y, z)] = at->first;
            }
        }
    }
}

void clod_partition_cut(clod_partition *self)
{
    piece stack[64]; // halves of ranks: as deep as the bits of an int
    int depth = 0;
    stack[depth++] = (piece){.high = {self->n[0], self->n[1], self->n[2]}, .last = self->ranks};
    while (depth > 0) {
        const piece at = stack[--depth];
        const int ranks = at.last - at.first;
        if (ranks == 1) {
            give(self, &at);
            continue;
        }
        int64_t slice[CLOD_PARTITION_ACROSS];
        const int axis = longest_axis(self, &at);
        const int lower = ranks / 2;
        const double all = (double)weigh(self, &at, axis, slice);
        piece left = at, right = at;
        left.last = right.first = at.first + lower;
        left.high[axis] = right.low[axis] =
            cut_at(&at, axis, slice, all * (double)lower / (double)ranks);
        stack[depth++] = right;
        stack[depth++] = left;
    }
}

bool clod_partition_reaches(const clod_partition *self, const clod_domain *domain, int rank,
                            const double position[3], double reach)
{
    for (int a = 0; a < 3; a++) {
        const double low = self->low[rank][a], high = self->high[rank][a];
        const double half = 0.5 * (high - low);
        const double off =
            fabs(clod_domain_separation(domain, a, position[a], low + half)) - half;
        if (!(off <= reach) || !(high > low || self->width[a] == 0.0)) {
            return false;
        }
    }
    return true;
}

void clod_partition_fini(clod_partition *self)
{
    clod_memory_free(self->owner);
    clod_memory_free(self->weight);
    clod_memory_free(self->low);
    clod_memory_free(self->high);
    *self = (clod_partition){0};
}
