#include "parallel/ranks.h"

#include <string.h>

#include "base/assert.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/room.h"

#define LEAST_ROOM 64 ///< bytes, for the functions of this file

bool clod_ranks_init(clod_ranks *self, clod_status *status)
{
    self->message = clod_memory_alloc(2 * (size_t)self->size, sizeof *self->message);
    self->number = clod_memory_alloc(3 * (size_t)self->size, sizeof *self->number);
    return (self->message != NULL && self->number != NULL &&
            clod_room_for(&self->room, &self->room_bytes, LEAST_ROOM, 1)) ||
           clod_status_fail(status, CLOD_FAILED, "no memory for messages of %d ranks",
                            self->size);
}

int clod_ranks_beside(const clod_ranks *self)
{
    return self->place == NULL ? self->size
                               : clod_rank_places_beside(self->place, self->size, self->rank);
}

/** A call has ended. */
static void count_time(clod_ranks_count *count, double began, double worked)
{
    count->waited += clod_clock_now() - began;
    count->spun += clod_clock_worked() - worked;
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

void clod_ranks_start(clod_ranks *self)
{
    const double began = clod_clock_now(), worked = clod_clock_worked();
    self->start(self);
    count_time(&self->count, began, worked);
}

void clod_ranks_finish(clod_ranks *self)
{
    const double began = clod_clock_now(), worked = clod_clock_worked();
    self->finish(self);
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
    clod_memory_free(self->number);
    clod_memory_free(self->room);
    clod_memory_free(self->place);
    self->place = NULL;
    self->message = NULL;
    self->number = NULL;
    self->room = NULL;
    self->room_bytes = 0;
}

bool clod_ranks_reserve(clod_ranks *self, size_t bytes, clod_status *status)
{
    const size_t wanted = bytes > LEAST_ROOM ? bytes : LEAST_ROOM;
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

/** A merge on its way through the ranks. */
typedef struct merging {
    void *data;
    size_t bytes;
    void (*merge)(const void *context, void *into, const void *from);
    const void *context;
} merging;

/** A round of messages, which every rank takes part in; a peer of -1 is none. */
static void send_round(clod_ranks *self, int to, int from, void *out, void *in, size_t bytes)
{
    const clod_message sent = {to, out, bytes}, got = {from, in, bytes};
    self->exchange(self, &sent, to >= 0, &got, from >= 0);
    self->count.merge_messages += to >= 0;
    self->count.merge_bytes += to >= 0 ? (int64_t)bytes : 0;
}

/** Merge with what lies in the room, of lower ranks or of higher ones. */
static void merge_room(clod_ranks *self, const merging *m, bool lower)
{
    if (lower) {
        m->merge(m->context, self->room, m->data);
        memcpy(m->data, self->room, m->bytes);
    } else {
        m->merge(m->context, m->data, self->room);
    }
}

/** All ranks, a power of two of them and `spare` more: of the first spare pairs one sits out. */
static void merge_all(clod_ranks *self, const merging *m, int power, int spare)
{
    const bool paired = self->rank < 2 * spare, sits = paired && self->rank % 2 == 1;
    if (spare > 0) {
        const int to = sits ? self->rank - 1 : -1, from = paired && !sits ? self->rank + 1 : -1;
        send_round(self, to, from, m->data, self->room, m->bytes);
        if (from >= 0) {
            merge_room(self, m, false);
        }
    }
    const int place = paired ? self->rank / 2 : self->rank - spare;
    for (int bit = 1; bit < power; bit *= 2) {
        const int other = place ^ bit;
        const int peer = sits ? -1 : other < spare ? 2 * other : other + spare;
        send_round(self, peer, peer, m->data, self->room, m->bytes);
        if (!sits) {
            merge_room(self, m, other < place);
        }
    }
    if (spare > 0) {
        const int to = paired && !sits ? self->rank + 1 : -1, from = sits ? self->rank - 1 : -1;
        send_round(self, to, from, m->data, m->data, m->bytes);
    }
}

void clod_ranks_merge(clod_ranks *self, void *data, size_t bytes,
                      void (*merge)(const void *context, void *into, const void *from),
                      const void *context)
{
    CLOD_ASSERT(bytes <= self->room_bytes);
    const double began = clod_clock_now(), worked = clod_clock_worked();
    int power = 1;
    while (power <= self->size / 2) {
        power *= 2;
    }
    const merging m = {data, bytes, merge, context};
    merge_all(self, &m, power, self->size - power);
    count_time(&self->count, began, worked);
    self->count.merges++;
}

/**
 * Bytes of one rank to all others: from it to the one halfway around, from both to those halfway on,
 * and so on (a binomial tree).
 */
static void tell_from(clod_ranks *self, int from, void *data, size_t bytes)
{
    const int place = (self->rank - from + self->size) % self->size;
    int half = 1;
    while (half < self->size) {
        half *= 2;
    }
    for (half /= 2; half > 0; half /= 2) {
        const bool has = place % (2 * half) == 0, gets = place % (2 * half) == half;
        const clod_message out = {(self->rank + half) % self->size, data, bytes};
        const clod_message in = {(self->rank - half + self->size) % self->size, data, bytes};
        clod_ranks_exchange(self, &out, has && place + half < self->size, &in, gets);
    }
}

void clod_ranks_tell(clod_ranks *self, void *data, size_t bytes)
{
    tell_from(self, 0, data, bytes);
}

void clod_ranks_gather(clod_ranks *self, const void *mine, size_t bytes, void *all)
{
    const clod_message out = {0, (void *)mine, bytes};
    for (int r = 1; r < self->size; r++) {
        self->message[r - 1] = (clod_message){r, (char *)all + (size_t)r * bytes, bytes};
    }
    const bool first = self->rank == 0;
    clod_ranks_exchange(self, &out, first ? 0 : 1, self->message, first ? self->size - 1 : 0);
    if (first) {
        memcpy(all, mine, bytes);
    }
    clod_ranks_tell(self, all, (size_t)self->size * bytes);
}

static void merge_least(const void *context, void *into, const void *from)
{
    (void)context;
    int *mine = into;
    const int other = *(const int *)from;
    *mine = other < *mine ? other : *mine;
}

bool clod_ranks_agree(clod_ranks *self, bool good, clod_status *status)
{
    int first = good ? self->size : self->rank; // on which it did not go well
    clod_ranks_merge(self, &first, sizeof first, merge_least, NULL);
    if (first < self->size) {
        tell_from(self, first, status, sizeof *status);
    }
    return first == self->size;
}

/** The numbers of a round of numbers for all: those with the bit of their distance. */
static size_t pick(const clod_ranks *self, int bit, const size_t *from, size_t *picked)
{
    size_t count = 0;
    for (int d = bit; d < self->size; d++) {
        if ((d & bit) != 0) {
            picked[count++] = from[d];
        }
    }
    return count;
}

/** The same back to where they were picked. */
static void put_back(const clod_ranks *self, int bit, const size_t *picked, size_t *to)
{
    size_t count = 0;
    for (int d = bit; d < self->size; d++) {
        if ((d & bit) != 0) {
            to[d] = picked[count++];
        }
    }
}

/**
 * A number from each rank to each. A number that is to go d ranks on goes by 1, by 2, by 4, ... for
 * each bit of d, with all others that go so (Bruck et al. 1997).
 *
 * @param number  [size] for the rank as many places on; then from the rank as many places back
 */
static void exchange_numbers(clod_ranks *self, size_t *number)
{
    size_t *sent = self->number + self->size, *got = sent + self->size;
    for (int bit = 1; bit < self->size; bit *= 2) {
        const size_t bytes = pick(self, bit, number, sent) * sizeof *sent;
        const clod_message out = {(self->rank + bit) % self->size, sent, bytes};
        const clod_message in = {(self->rank - bit + self->size) % self->size, got, bytes};
        clod_ranks_exchange(self, &out, 1, &in, 1);
        put_back(self, bit, got, number);
    }
}

/** How many bytes come from each rank: `begin` of it up to that of the next one. */
static void count_bytes(clod_ranks *self, const clod_bytes *out, size_t *begin)
{
    const int size = self->size;
    for (int d = 0; d < size; d++) {
        self->number[d] = out[(self->rank + d) % size].count;
    }
    exchange_numbers(self, self->number);
    begin[0] = 0;
    for (int r = 0; r < size; r++) {
        begin[r + 1] = begin[r] + self->number[(self->rank - r + size) % size];
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
