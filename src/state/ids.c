#include "state/ids.h"

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
    size_t low = 0, high = self->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (self->item[middle].key < id) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < self->count && self->item[low].key == id ? (int64_t)self->item[low].index : -1;
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
