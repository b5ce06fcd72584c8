#include "parallel/ranks.h"

#include <string.h>

#include "base/assert.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/room.h"

#define LEAST_ROOM 64 ///< bytes of each rank, for the functions of this file

bool clod_ranks_init(clod_ranks *self, clod_status *status)
{
    self->message = clod_memory_alloc(2 * (size_t)self->size, sizeof *self->message);
    return (self->message != NULL && clod_room_for(&self->room, &self->room_bytes,
                                                   (size_t)self->size * LEAST_ROOM, 1)) ||
           clod_status_fail(status, CLOD_FAILED, "no memory for messages of %d ranks",
                            self->size);
}

/** A call has ended. */
static void count_time(clod_ranks_count *count, double began, double worked)
{
    count->waited += clod_clock_now() - began;
    count->spun += clod_clock_worked() - worked;
}

void clod_ranks_share(clod_ranks *self, const void *mine, size_t bytes, void *all)
{
    const double began = clod_clock_now(), worked = clod_clock_worked();
    self->share(self, mine, bytes, all);
    count_time(&self->count, began, worked);
    self->count.shares++;
    self->count.share_bytes += (int64_t)bytes;
}

/** Messages that are not empty, and their bytes. */
static void count_messages(const clod_message *out, int outs, int64_t *messages, int64_t *bytes)
{
    for (int k = 0; k < outs; k++) {
        *messages += out[k].bytes > 0;
        *bytes += (int64_t)out[k].bytes;
    }
}

bool clod_ranks_keep(clod_ranks *self, const clod_message *out, int outs,
                     const clod_message *in, int ins, clod_status *status)
{
    self->kept_messages = self->kept_bytes = 0;
    count_messages(out, outs, &self->kept_messages, &self->kept_bytes);
    return self->keep(self, out, outs, in, ins) ||
           clod_status_fail(status, CLOD_FAILED, "no memory for %d messages between ranks",
                            outs + ins);
}

void clod_ranks_repeat(clod_ranks *self)
{
    const double began = clod_clock_now(), worked = clod_clock_worked();
    self->repeat(self);
    count_time(&self->count, began, worked);
    self->count.exchanges++;
    self->count.messages += self->kept_messages;
    self->count.bytes += self->kept_bytes;
}

void clod_ranks_exchange(clod_ranks *self, const clod_message *out, int outs,
                         const clod_message *in, int ins)
{
    const double began = clod_clock_now(), worked = clod_clock_worked();
    self->exchange(self, out, outs, in, ins);
    count_time(&self->count, began, worked);
    self->count.exchanges++;
    count_messages(out, outs, &self->count.messages, &self->count.bytes);
}

void clod_ranks_fini(clod_ranks *self)
{
    clod_memory_free(self->message);
    clod_memory_free(self->room);
    clod_memory_free(self->place);
    self->place = NULL;
    self->message = NULL;
    self->room = NULL;
    self->room_bytes = 0;
}

bool clod_ranks_reserve(clod_ranks *self, size_t bytes, clod_status *status)
{
    const size_t wanted = (size_t)self->size * (bytes > LEAST_ROOM ? bytes : LEAST_ROOM);
    char *grown = self->room;
    if (wanted > self->room_bytes) { // the old room is needed to agree
        grown = clod_memory_alloc(wanted, 1);
    }
    const bool good = clod_ranks_agree(
        self,
        grown != NULL || clod_status_fail(status, CLOD_FAILED,
                                          "no memory for sums over %d ranks", self->size),
        status);
    if (good && grown != self->room) {
        clod_memory_free(self->room);
        self->room = grown;
        self->room_bytes = wanted;
    } else if (grown != self->room) {
        clod_memory_free(grown);
    }
    return good;
}

void clod_ranks_merge(clod_ranks *self, void *data, size_t bytes,
                      void (*merge)(const void *context, void *into, const void *from),
                      const void *context)
{
    CLOD_ASSERT((size_t)self->size * bytes <= self->room_bytes);
    clod_ranks_share(self, data, bytes, self->room);
    memcpy(data, self->room, bytes);
    for (int r = 1; r < self->size; r++) {
        merge(context, data, self->room + (size_t)r * bytes);
    }
}

/** Bytes of one rank to all others. */
static void tell_from(clod_ranks *self, int from, void *data, size_t bytes)
{
    const clod_message in = {from, data, bytes};
    int outs = 0;
    for (int r = 0; r < self->size; r++) {
        if (r != from) {
            self->message[outs++] = (clod_message){r, data, bytes};
        }
    }
    const bool mine = self->rank == from;
    clod_ranks_exchange(self, self->message, mine ? outs : 0, &in, mine ? 0 : 1);
}

void clod_ranks_tell(clod_ranks *self, void *data, size_t bytes)
{
    tell_from(self, 0, data, bytes);
}

bool clod_ranks_agree(clod_ranks *self, bool good, clod_status *status)
{
    const char mine = good ? 1 : 0;
    clod_ranks_share(self, &mine, 1, self->room);
    for (int r = 0; r < self->size; r++) {
        if (self->room[r] == 0) {
            tell_from(self, r, status, sizeof *status);
            return false;
        }
    }
    return true;
}

/** How many bytes come from each rank: `begin` of it up to that of the next one. */
static void count_bytes(clod_ranks *self, const clod_bytes *out, size_t *begin)
{
    int outs = 0, ins = 0;
    size_t *number = begin + 1;
    for (int r = 0; r < self->size; r++) {
        number[r] = out[r].count;
        if (r != self->rank) {
            self->message[outs++] =
                (clod_message){r, (void *)&out[r].count, sizeof out[r].count};
        }
    }
    for (int r = 0; r < self->size; r++) {
        if (r != self->rank) {
            self->message[outs + ins++] = (clod_message){r, &number[r], sizeof number[r]};
        }
    }
    clod_ranks_exchange(self, self->message, outs, self->message + outs, ins);
    begin[0] = 0;
    for (int r = 0; r < self->size; r++) {
        begin[r + 1] += begin[r];
    }
}

bool clod_ranks_swap(clod_ranks *self, const clod_bytes *out, clod_bytes *in, size_t *begin,
                     clod_status *status)
{
    count_bytes(self, out, begin);
    bool good = clod_room_for(&in->data, &in->capacity, begin[self->size], 1);
    for (int r = 0; r < self->size; r++) {
        good = good && !out[r].lacks_memory;
    }
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for %zu bytes from other ranks",
                         begin[self->size]);
    }
    if (!clod_ranks_agree(self, good, status)) {
        return false;
    }
    in->count = begin[self->size];
    int outs = 0, ins = 0;
    for (int r = 0; r < self->size; r++) {
        if (r == self->rank && out[r].count > 0) {
            memcpy(in->data + begin[r], out[r].data, out[r].count);
        } else if (r != self->rank) {
            self->message[outs++] = (clod_message){r, out[r].data, out[r].count};
        }
    }
    for (int r = 0; r < self->size; r++) {
        if (r != self->rank) {
            const size_t bytes = begin[r + 1] - begin[r];
            void *to = bytes > 0 ? in->data + begin[r] : NULL;
            self->message[outs + ins++] = (clod_message){r, to, bytes};
        }
    }
    clod_ranks_exchange(self, self->message, outs, self->message + outs, ins);
    return true;
}
