#include "state/ids.h"

#include "base/lower_bound.h"
#include "base/memory.h"

bool clod_ids_init(clod_ids *self, const uint64_t *id, size_t count, clod_status *status)
{
    *self = (clod_ids){.count = count};
    self->item = clod_memory_alloc(count + 1, sizeof *self->item);
    clod_sort_item *scratch = clod_memory_alloc(count + 1, sizeof *scratch);
    if (self->item == NULL || scratch == NULL) {
        clod_memory_free(scratch);
        clod_ids_fini(self);
        return clod_status_fail(status, CLOD_FAILED, "no memory to find %zu grains by id",
                                count);
    }
    for (size_t g = 0; g < count; g++) {
        self->item[g] = (clod_sort_item){id[g], g};
    }
    clod_sort(self->item, scratch, count);
    clod_memory_free(scratch);
    return true;
}

int64_t clod_ids_row(const clod_ids *self, uint64_t id)
{
    clod_lower_bound in = {0, self->count};
    while (in.low < in.high) {
        const size_t middle = clod_lower_bound_middle(&in);
        clod_lower_bound_halve(&in, self->item[middle].key < id);
    }
    if (in.low == self->count || self->item[in.low].key != id) {
        return -1;
    }
    return (int64_t)self->item[in.low].index;
}

bool clod_ids_are_different(const clod_ids *self)
{
    bool different = true;
    for (size_t g = 1; g < self->count; g++) {
        different = different && self->item[g].key != self->item[g - 1].key;
    }
    return different;
}

void clod_ids_fini(clod_ids *self)
{
    clod_memory_free(self->item);
    *self = (clod_ids){0};
}
