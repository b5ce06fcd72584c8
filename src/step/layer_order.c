#include "step/layer_order.h"

#include "base/memory.h"
#include "parallel/parallel_sort.h"

bool clod_layer_order_reserve(clod_neighbour *neighbour, int parts)
{
    const size_t count = (size_t)parts;
    if (count > neighbour->order_capacity) {
        clod_memory_free(neighbour->order_part);
        clod_memory_free(neighbour->sort_part);
        neighbour->order_part = clod_memory_alloc(count, sizeof *neighbour->order_part);
        neighbour->sort_part = clod_memory_alloc(count, sizeof *neighbour->sort_part);
        neighbour->order_capacity = count;
    }
    return neighbour->order_part != NULL && neighbour->sort_part != NULL;
}

static clod_chunk rows_of(const clod_layer_order *self, int part)
{
    return clod_threads_chunk(self->grains->count, part, self->parts);
}

static size_t stay(const clod_layer_order *self)
{
    return self->grains->count - self->going;
}

void clod_layer_order_measure(const clod_layer_order *self, int part)
{
    const clod_chunk rows = rows_of(self, part);
    clod_layers_extent all = clod_layers_extent_of(NULL, 0);
    size_t g = rows.begin;
    while (g < rows.end) { // rows up to one that goes
        size_t end = g;
        while (end < rows.end && !clod_neighbour_goes(self->neighbour, self->going, end)) {
            end++;
        }
        const clod_layers_extent run = clod_layers_extent_of(self->place + g, end - g);
        clod_layers_extent_merge(&all, &run);
        g = end + 1;
    }
    self->neighbour->order_part[part].extent = all;
}

void clod_layer_order_begin(clod_layer_order *self)
{
    clod_layers_extent bed = clod_layers_extent_of(NULL, 0);
    for (int p = 0; p < self->parts; p++) {
        clod_layer_order_part *part = &self->neighbour->order_part[p];
        part->begin = bed.count;
        clod_layers_extent_merge(&bed, &part->extent);
    }
    const clod_layers *given = self->neighbour->layers;
    self->layers = given != NULL ? *given : clod_layers_from(&bed);
}

void clod_layer_order_find_keys(const clod_layer_order *self, int part)
{
    const clod_chunk rows = rows_of(self, part);
    clod_sort_item *to = self->neighbour->sort + self->neighbour->order_part[part].begin;
    for (size_t g = rows.begin; g < rows.end; g++) {
        if (!clod_neighbour_goes(self->neighbour, self->going, g)) {
            *to++ = (clod_sort_item){clod_layers_key(&self->layers, self->place[g]), g};
        }
    }
}

/** Put items of one key by the ids of their grains. The keys are not written: another part may
 *  look at them. */
static void sort_by_id(clod_sort_item *items, size_t count, const uint64_t *id)
{
    for (size_t k = 1; k < count; k++) {
        const uint64_t moving = items[k].index;
        size_t at = k;
        while (at > 0 && id[items[at - 1].index] > id[moving]) {
            items[at].index = items[at - 1].index;
            at--;
        }
        items[at].index = moving;
    }
}

/** New rows of the grains of those runs of equal keys that begin in a part. */
static void number_rows(const clod_layer_order *self, clod_sort_item *sorted, int part)
{
    const clod_chunk mine = clod_threads_chunk(stay(self), part, self->parts);
    size_t begin = mine.begin;
    while (begin > 0 && begin < mine.end && sorted[begin].key == sorted[begin - 1].key) {
        begin++;
    }
    while (begin < mine.end) {
        size_t end = begin + 1;
        while (end < stay(self) && sorted[end].key == sorted[begin].key) {
            end++;
        }
        sort_by_id(sorted + begin, end - begin, self->grains->id);
        for (; begin < end; begin++) {
            self->neighbour->rank[sorted[begin].index] = (int32_t)begin;
        }
    }
}

void clod_layer_order_sort(const clod_layer_order *self, clod_chunk parts,
                           clod_barrier *barrier)
{
    clod_neighbour *neighbour = self->neighbour;
    const clod_parallel_sort job = {.items = neighbour->sort,
                                    .scratch = neighbour->sort_scratch,
                                    .count = stay(self),
                                    .part = neighbour->sort_part,
                                    .parts = self->parts};
    clod_sort_item *sorted = clod_parallel_sort_do(&job, parts, barrier);
    for (size_t p = parts.begin; p < parts.end; p++) {
        number_rows(self, sorted, (int)p);
    }
    if (parts.begin == 0 && sorted != job.items) { // the arrays change places
        neighbour->sort = job.scratch;
        neighbour->sort_scratch = job.items;
    }
}

void clod_layer_order_find(clod_layer_order *self)
{
    clod_barrier alone;
    clod_barrier_init(&alone, 1, 1);
    self->parts = 1;
    clod_layer_order_measure(self, 0);
    clod_layer_order_begin(self);
    clod_layer_order_find_keys(self, 0);
    clod_layer_order_sort(self, (clod_chunk){0, 1}, &alone);
}
