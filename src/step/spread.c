#include "step/spread.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/room.h"

/** Beyond rounding of what reaches a box. */
#define REACH_MARGIN 1.000001

bool clod_spread_init(clod_spread *self, clod_ranks *ranks, int32_t walls, clod_status *status)
{
    *self = (clod_spread){.ranks = ranks};
    const size_t size = (size_t)ranks->size;
    clod_ghosts *ghosts = &self->ghosts;
    self->walls = walls;
    const size_t sums = (size_t)walls * sizeof *self->felt + sizeof(clod_spread_sums);
    self->felt = clod_memory_alloc(1, sums);
    ghosts->out_start = clod_memory_alloc(size + 1, sizeof *ghosts->out_start);
    ghosts->in_start = clod_memory_alloc(size + 1, sizeof *ghosts->in_start);
    ghosts->message = clod_memory_alloc(2 * size, sizeof *ghosts->message);
    self->wear_out = clod_memory_alloc(size, sizeof *self->wear_out);
    self->wear_begin = clod_memory_alloc(size + 1, sizeof *self->wear_begin);
    const bool good =
        (self->felt != NULL && self->wear_out != NULL && self->wear_begin != NULL &&
         ghosts->out_start != NULL && ghosts->in_start != NULL && ghosts->message != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks", ranks->size);
    const size_t blocks = CLOD_PARTITION_BLOCKS * sizeof *self->partition.weight;
    return clod_ranks_agree(ranks,
                            good && clod_partition_init(&self->partition, ranks->size, status),
                            status) &&
           clod_ranks_reserve(ranks, blocks > sums ? blocks : sums, status);
}

double clod_spread_reach(const clod_spread *self, double radius, double skin)
{
    return REACH_MARGIN * (radius + self->bed.largest + skin);
}

// ---- whose rows

static bool reserve(clod_spread *self, size_t rows)
{
    return clod_room_for(&self->owner, &self->owner_room, rows + 1, sizeof *self->owner) &&
           clod_room_for(&self->run, &self->run_room, rows + 1, sizeof *self->run);
}

/** Owners, and runs of own rows. */
static void find_owners(clod_spread *self, const clod_state *state)
{
    self->runs = 0;
    for (size_t g = 0; g < state->grains.count; g++) {
        self->owner[g] = clod_partition_owner(&self->partition, state->build_position[g]);
        if (!clod_spread_owns(self, (int32_t)g)) {
            continue;
        }
        if (self->runs == 0 || self->run[self->runs - 1].end != g) {
            self->run[self->runs++] = (clod_chunk){g, g};
        }
        self->run[self->runs - 1].end = g + 1;
    }
}

/** Rows that come, or go: those of each rank ascend. With `row` NULL they are counted alone. */
static size_t list_rows(const clod_spread *self, const clod_state *state, double skin, bool out,
                        size_t *start, int32_t *row)
{
    size_t count = 0;
    for (int r = 0; r < self->ranks->size; r++) {
        start[r] = count;
        for (size_t g = 0; r != self->ranks->rank && g < state->grains.count; g++) {
            const double *p = state->build_position[g];
            const bool goes =
                out ? clod_spread_owns(self, (int32_t)g) &&
                          clod_partition_reaches(&self->partition, &state->domain, r, p,
                                                 clod_spread_reach(self, p[3], skin))
                    : self->owner[g] == r;
            if (goes && row != NULL) {
                row[count] = (int32_t)g;
            }
            count += goes;
        }
    }
    start[self->ranks->size] = count;
    return count;
}

/** Messages with the rows [start[r], start[r + 1]) for each rank r; how many there are. */
static int address(const clod_spread *self, const size_t *start, double *numbers, size_t each,
                   clod_message *message)
{
    int count = 0;
    for (int r = 0; r < self->ranks->size; r++) {
        const size_t rows = start[r + 1] - start[r];
        if (rows > 0) {
            message[count++] =
                (clod_message){r, numbers + start[r] * each, rows * each * sizeof *numbers};
        }
    }
    return count;
}

/** The messages of every step until the next list. */
static bool keep_messages(clod_spread *self, size_t numbers, clod_status *status)
{
    const clod_ghosts *ghosts = &self->ghosts;
    clod_message *out = ghosts->message;
    const int outs = address(self, ghosts->out_start, ghosts->sent, numbers, out);
    const int ins = address(self, ghosts->in_start, ghosts->got, numbers, out + outs);
    return clod_ranks_keep(self->ranks, out, outs, out + outs, ins, status);
}

static bool list_ghosts(clod_spread *self, const clod_state *state, double skin,
                        clod_status *status)
{
    clod_ghosts *ghosts = &self->ghosts;
    const size_t out = list_rows(self, state, skin, true, ghosts->out_start, NULL);
    const size_t in = list_rows(self, state, skin, false, ghosts->in_start, NULL);
    const size_t numbers = clod_spread_numbers(state);
    if (!clod_room_for(&ghosts->out, &ghosts->out_room, out, sizeof *ghosts->out) ||
        !clod_room_for(&ghosts->in, &ghosts->in_room, in, sizeof *ghosts->in) ||
        !clod_room_for(&ghosts->sent, &ghosts->sent_room, out * numbers, sizeof(double)) ||
        !clod_room_for(&ghosts->got, &ghosts->got_room, in * numbers, sizeof(double))) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the ghosts of %zu grains",
                                state->grains.count);
    }
    list_rows(self, state, skin, true, ghosts->out_start, ghosts->out);
    list_rows(self, state, skin, false, ghosts->in_start, ghosts->in);
    return keep_messages(self, numbers, status);
}

bool clod_spread_list(clod_spread *self, const clod_state *state, double skin,
                      clod_status *status)
{
    bool good = reserve(self, state->grains.count) ||
                clod_status_fail(status, CLOD_FAILED, "no memory for the owners of %zu grains",
                                 state->grains.count);
    if (good) {
        find_owners(self, state);
        good = list_ghosts(self, state, skin, status);
    }
    good = clod_ranks_agree(self->ranks, good, status);
    self->adrift = self->adrift && !good;
    return good;
}

// ---- lists of the neighbour search

/** Pairs of which neither grain is this rank's. */
static void leave_out_pairs(const clod_spread *self, clod_pairs *pairs, size_t rows)
{
    size_t count = 0, next = 0;
    for (size_t i = 0; i < rows; i++) {
        const bool own = clod_spread_owns(self, (int32_t)i);
        size_t k = next;
        next = pairs->start[i + 1];
        pairs->start[i] = (uint32_t)count;
        for (; k < next; k++) {
            if (own || clod_spread_owns(self, (int32_t)pairs->item[k].j)) {
                pairs->item[count++] = pairs->item[k];
            }
        }
    }
    pairs->start[rows] = (uint32_t)count;
    pairs->count = count;
}

void clod_spread_leave_out(const clod_spread *self, clod_neighbour *neighbour, size_t rows)
{
    leave_out_pairs(self, &neighbour->pairs, rows);
    clod_wall_candidates *walls = &neighbour->walls;
    size_t count = 0;
    for (size_t k = 0; k < walls->count; k++) {
        if (clod_spread_owns(self, walls->item[k].i)) {
            walls->item[count++] = walls->item[k];
        }
    }
    walls->count = count;
}

static void least(const void *context, void *into, const void *from)
{
    (void)context;
    double *mine = into;
    *mine = fmin(*mine, *(const double *)from);
}

double clod_spread_least(const clod_spread *self, double number)
{
    clod_ranks_merge(self->ranks, &number, sizeof number, least, NULL);
    return number;
}

void clod_spread_fini(clod_spread *self)
{
    clod_ghosts *ghosts = &self->ghosts;
    clod_memory_free(ghosts->out);
    clod_memory_free(ghosts->in);
    clod_memory_free(ghosts->out_start);
    clod_memory_free(ghosts->in_start);
    clod_memory_free(ghosts->sent);
    clod_memory_free(ghosts->got);
    clod_memory_free(ghosts->message);
    clod_memory_free(self->owner);
    clod_memory_free(self->run);
    clod_memory_free(self->felt);
    clod_memory_free(self->wear);
    clod_memory_free(self->wear_begin);
    for (int r = 0; self->wear_out != NULL && r < self->ranks->size; r++) {
        clod_bytes_fini(&self->wear_out[r]);
    }
    clod_memory_free(self->wear_out);
    clod_bytes_fini(&self->wear_in);
    clod_partition_fini(&self->partition);
    *self = (clod_spread){0};
}
