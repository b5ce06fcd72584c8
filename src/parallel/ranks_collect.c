#include "parallel/ranks_collect.h"

#include <string.h>

#include "base/room.h"

/** How many bytes come from each rank: `begin` of it up to that of the next one. */
static void count_bytes(clod_ranks *self, size_t mine, size_t *begin)
{
    const bool first = self->rank == 0;
    const clod_message out = {0, &mine, sizeof mine};
    for (int r = 1; first && r < self->size; r++) {
        self->message[r - 1] = (clod_message){r, &begin[r + 1], sizeof *begin};
    }
    clod_ranks_exchange(self, &out, !first, self->message, first ? self->size - 1 : 0);
    if (first) {
        begin[0] = 0;
        begin[1] = mine;
        for (int r = 1; r < self->size; r++) {
            begin[r + 1] += begin[r];
        }
    }
}

/** Messages of rank 0 with the bytes of all others; how many. */
static int name_others(clod_ranks *self, char *all, const size_t *begin)
{
    for (int r = 1; r < self->size; r++) {
        const size_t bytes = begin[r + 1] - begin[r];
        self->message[r - 1] = (clod_message){r, bytes > 0 ? all + begin[r] : NULL, bytes};
    }
    return self->size - 1;
}

bool clod_ranks_collect(clod_ranks *self, const clod_bytes *mine, clod_bytes *all,
                        size_t *begin, clod_status *status)
{
    const bool first = self->rank == 0;
    count_bytes(self, mine->count, begin);
    bool good = !mine->lacks_memory;
    if (first) {
        good = good && clod_room_for(&all->data, &all->capacity, begin[self->size], 1);
    }
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for bytes from all ranks");
    }
    if (!clod_ranks_agree(self, good, status)) {
        return false;
    }
    const clod_message out = {0, mine->data, mine->count};
    const int others = first ? name_others(self, all->data, begin) : 0;
    clod_ranks_exchange(self, &out, !first, self->message, others);
    if (first) {
        all->count = begin[self->size];
        if (mine->count > 0) {
            memcpy(all->data, mine->data, mine->count);
        }
    }
    return true;
}

void clod_ranks_return(clod_ranks *self, const void *all, const size_t *begin, void *mine,
                       size_t bytes)
{
    const bool first = self->rank == 0;
    const clod_message in = {0, mine, bytes};
    const int others = first ? name_others(self, (char *)all, begin) : 0;
    clod_ranks_exchange(self, self->message, others, &in, !first);
    if (first && bytes > 0) {
        memcpy(mine, all, bytes);
    }
}
