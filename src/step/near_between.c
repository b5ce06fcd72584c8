#include "step/near_between.h"

#include "base/memory.h"

/** Lanes of the blocks between parts of all laws, padding included. */
static size_t lanes_between(const clod_near *self)
{
    const size_t first = self->pairs.group_start[clod_near_group(self, self->parts, 0)];
    return (self->pairs.count - first) * CLOD_LANES;
}

bool clod_near_between_reserve(clod_near *near)
{
    if (near->parts == 1) {
        return true;
    }
    clod_near_between *self = &near->between;
    const size_t lanes = lanes_between(near);
    if (2 * lanes > self->share_capacity) {
        clod_memory_free(self->share);
        self->share_capacity = 2 * lanes + lanes / 2;
        self->share = clod_memory_alloc(self->share_capacity, sizeof *self->share);
    }
    if (lanes > self->by_later_capacity) {
        clod_memory_free(self->by_later);
        self->by_later_capacity = lanes + lanes / 4;
        self->by_later = clod_memory_alloc(self->by_later_capacity, sizeof *self->by_later);
    }
    return lanes == 0 || (self->share != NULL && self->by_later != NULL);
}

/** First of the sorted items [from, to) whose grain is at or behind `grain`. */
static size_t first_behind(const clod_sort_item *sort, size_t from, size_t to, size_t grain)
{
    while (from < to) {
        const size_t middle = from + (to - from) / 2;
        if (sort[middle].key < grain) {
            from = middle + 1;
        } else {
            to = middle;
        }
    }
    return from;
}

/** The contacts of one law, whose first number is `base`, in both orders. */
static void number_law(clod_near *self, int32_t law, size_t base, clod_sort_item *sort,
                       clod_sort_item *scratch)
{
    clod_near_between *between = &self->between;
    const size_t group = clod_near_group(self, self->parts, law);
    const clod_contact_block *blocks = self->pairs.block;
    const size_t begin = self->pairs.group_start[group] * CLOD_LANES;
    const size_t count = self->pairs.group_count[group];
    size_t *as_i = between->as_i + (size_t)law * (size_t)self->parts;
    size_t *as_j = between->as_j + (size_t)law * (size_t)self->parts;
    for (size_t k = 0; k < count; k++) { // ascending by i already
        const size_t at = begin + k;
        const int32_t i = blocks[at / CLOD_LANES].i[at % CLOD_LANES];
        sort[k] = (clod_sort_item){(uint64_t)(uint32_t)i, base + k};
    }
    for (int p = 0; p < self->parts; p++) {
        as_i[p] = base + first_behind(sort, 0, count, self->part_start[p]);
    }
    for (size_t k = 0; k < count; k++) {
        const size_t at = begin + k;
        sort[k].key = (uint64_t)(uint32_t)blocks[at / CLOD_LANES].j[at % CLOD_LANES];
    }
    clod_sort(sort, scratch, count); // stable: equal j stay in ascending i
    for (size_t k = 0; k < count; k++) {
        between->by_later[base + k] = (int32_t)sort[k].index;
    }
    for (int p = 0; p < self->parts; p++) {
        as_j[p] = base + first_behind(sort, 0, count, self->part_start[p]);
    }
}

void clod_near_between_make(clod_near *self, clod_sort_item *sort, clod_sort_item *scratch)
{
    if (self->parts == 1) {
        return;
    }
    const size_t first = self->pairs.group_start[clod_near_group(self, self->parts, 0)];
    for (int32_t l = 0; l < self->laws; l++) {
        const size_t group = clod_near_group(self, self->parts, l);
        number_law(self, l, (self->pairs.group_start[group] - first) * CLOD_LANES, sort,
                   scratch);
    }
}

static void add_row(double *load, const double *share)
{
    for (int c = 0; c < 8; c++) {
        load[c] += share[c];
    }
}

void clod_near_between_add(const clod_near *self, int part, int32_t law, bool as_i,
                           double (*load)[8])
{
    const clod_near_between *between = &self->between;
    const size_t group = clod_near_group(self, self->parts, law);
    const size_t first = self->pairs.group_start[clod_near_group(self, self->parts, 0)];
    const size_t base = (self->pairs.group_start[group] - first) * CLOD_LANES;
    const clod_contact_block *blocks = self->pairs.block;
    const size_t *start = (as_i ? between->as_i : between->as_j) + law * self->parts;
    const size_t end =
        part + 1 < self->parts ? start[part + 1] : base + self->pairs.group_count[group];
    for (size_t k = start[part]; k < end; k++) {
        const size_t number = as_i ? k : (size_t)between->by_later[k];
        const clod_contact_block *block = &blocks[first + number / CLOD_LANES];
        const int lane = (int)(number % CLOD_LANES);
        if (as_i) {
            add_row(load[block->i[lane]], between->share[2 * number]);
        } else {
            add_row(load[block->j[lane]], between->share[2 * number + 1]);
        }
    }
}
