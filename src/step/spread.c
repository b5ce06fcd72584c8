#include "step/spread.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
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
    const size_t sums = (size_t)walls * sizeof *self->wall_sum + sizeof(clod_spread_sums);
    self->wall_sum = clod_memory_alloc(1, sums);
    ghosts->out_start = clod_memory_alloc(size + 1, sizeof *ghosts->out_start);
    ghosts->in_start = clod_memory_alloc(size + 1, sizeof *ghosts->in_start);
    ghosts->message = clod_memory_alloc(2 * size, sizeof *ghosts->message);
    self->reached = clod_memory_alloc(size, sizeof *self->reached);
    self->wear_out = clod_memory_alloc(size, sizeof *self->wear_out);
    self->wear_begin = clod_memory_alloc(size + 1, sizeof *self->wear_begin);
    const bool good =
        (self->wall_sum != NULL && self->reached != NULL && self->wear_out != NULL &&
         self->wear_begin != NULL && ghosts->out_start != NULL && ghosts->in_start != NULL &&
         ghosts->message != NULL) ||
        clod_status_fail(status, CLOD_FAILED, "no memory for %d ranks", ranks->size);
    const bool cuts = good && clod_partition_init(&self->partition, ranks->size, status);
    const size_t blocks = self->partition.most * sizeof *self->partition.weight;
    return clod_ranks_agree(ranks, cuts, status) &&
           clod_ranks_reserve(ranks, blocks > sums ? blocks : sums, status);
}

int clod_spread_reach(const clod_spread *self, const clod_domain *domain, const double place[4],
                      double skin, int *rank)
{
    const double reach = REACH_MARGIN * (place[3] + self->bed.largest + skin);
    return clod_partition_reach(&self->partition, domain, place, reach, rank);
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

/** Count a row of a rank, or list it. */
static void add_row(size_t *next, int rank, size_t g, int32_t *row)
{
    if (row != NULL) {
        row[next[rank]] = (int32_t)g;
    }
    next[rank]++;
}

/** Rows that go to, and come from, each rank: they are counted, or with lists of rows listed. */
static void add_rows(const clod_spread *self, const clod_state *state, double skin, size_t *out,
                     size_t *in, int32_t *out_row, int32_t *in_row)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        if (!clod_spread_owns(self, (int32_t)g)) {
            add_row(in, self->owner[g], g, in_row);
            continue;
        }
        const double *p = state->build_position[g];
        const int count = clod_spread_reach(self, &state->domain, p, skin, self->reached);
        for (int k = 0; k < count; k++) {
            if (self->reached[k] != self->ranks->rank) {
                add_row(out, self->reached[k], g, out_row);
            }
        }
    }
}

/** From the numbers of rows of each rank, in start[1 ...], where they begin; how many there are. */
static size_t sum_up(size_t *start, size_t ranks)
{
    for (size_t r = 0; r < ranks; r++) {
        start[r + 1] += start[r];
    }
    return start[ranks];
}

/** Where rows of each rank begin, after each of these has gone to where the next one was. */
static void step_back(size_t *start, size_t ranks)
{
    memmove(start + 1, start, ranks * sizeof *start);
    start[0] = 0;
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
    const size_t ranks = (size_t)self->ranks->size;
    memset(ghosts->out_start, 0, (ranks + 1) * sizeof *ghosts->out_start);
    memset(ghosts->in_start, 0, (ranks + 1) * sizeof *ghosts->in_start);
    add_rows(self, state, skin, ghosts->out_start + 1, ghosts->in_start + 1, NULL, NULL);
    const size_t out = sum_up(ghosts->out_start, ranks), in = sum_up(ghosts->in_start, ranks);
    const size_t numbers = clod_spread_numbers(state);
    if (!clod_room_for(&ghosts->out, &ghosts->out_room, out, sizeof *ghosts->out) ||
        !clod_room_for(&ghosts->in, &ghosts->in_room, in, sizeof *ghosts->in) ||
        !clod_room_for(&ghosts->sent, &ghosts->sent_room, out * numbers, sizeof(double)) ||
        !clod_room_for(&ghosts->got, &ghosts->got_room, in * numbers, sizeof(double))) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the ghosts of %zu grains",
                                state->grains.count);
    }
    add_rows(self, state, skin, ghosts->out_start, ghosts->in_start, ghosts->out, ghosts->in);
    step_back(ghosts->out_start, ranks);
    step_back(ghosts->in_start, ranks);
    return keep_messages(self, numbers, status);
}

void clod_spread_share(const clod_spread *self, void *column, size_t size)
{
    const clod_ghosts *ghosts = &self->ghosts;
    const size_t each = size / sizeof(double);
    const int ranks = self->ranks->size;
    char *rows = column;
    CLOD_ASSERT(size % sizeof(double) == 0 && each <= 3 * (size_t)CLOD_SPREAD_VECTOR);
    for (size_t k = 0; k < ghosts->out_start[ranks]; k++) {
        memcpy(ghosts->sent + k * each, rows + (size_t)ghosts->out[k] * size, size);
    }
    clod_message *out = self->ranks->message; // those of every step are kept
    const int outs = address(self, ghosts->out_start, ghosts->sent, each, out);
    const int ins = address(self, ghosts->in_start, ghosts->got, each, out + outs);
    clod_ranks_exchange(self->ranks, out, outs, out + outs, ins);
    for (size_t k = 0; k < ghosts->in_start[ranks]; k++) {
        memcpy(rows + (size_t)ghosts->in[k] * size, ghosts->got + k * each, size);
    }
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
    clod_memory_free(self->wall_sum);
    clod_memory_free(self->reached);
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
