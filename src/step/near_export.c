// The way back: from the blocks into the state's list of contacts.
#include "base/memory.h"
#include "state/limits.h"
#include "step/near_walk.h"

/** Pairs after which what has been read in all groups is given back. */
#define OTHER_GROUPS_EVERY ((size_t)8 * CLOD_NEAR_GIVE_BACK)

static void history_get(const clod_history *from, int lane, double to[8])
{
    to[0] = from->plastic[lane];
    to[1] = from->tangent[lane];
    for (int c = 0; c < 3; c++) {
        to[2 + c] = from->spring[c][lane];
        to[5 + c] = from->roll[c][lane];
    }
}

/** Room for as many contacts as the lists have lanes, and none in it; unchanged without memory.
 */
static bool reserve_contacts(const clod_near *self, clod_state *state, clod_status *status)
{
    const size_t most = (self->pairs.count + self->walls.count) * CLOD_LANES;
    if (!clod_limits_contacts(most, status)) {
        return false;
    }
    if (most > state->contact_capacity) {
        const size_t capacity = most + most / 8;
        void *fresh = clod_memory_alloc(capacity, sizeof *state->contacts);
        if (fresh == NULL) {
            return clod_status_fail(status, CLOD_FAILED,
                                    "no memory for the contacts of %zu grains",
                                    state->grains.count);
        }
        clod_memory_free(state->contacts);
        state->contacts = fresh;
        state->contact_capacity = capacity;
    }
    state->contact_count = state->wall_contact_count = 0;
    return true;
}

/**
 * Give back blocks that have been read to the end: those of all parts before the one that the
 * walk is in, with those of its first law, and from time to time those of the other groups that
 * are being read.
 */
static size_t give_back_blocks(const clod_near *self, const clod_near_walk *walk, size_t given,
                               bool others)
{
    clod_contact_block *blocks = self->pairs.block;
    const size_t bytes = self->pairs.capacity * sizeof *blocks;
    const size_t first = clod_near_group(self, walk->part, 0);
    const size_t groups = bytes >= CLOD_MEMORY_LARGE && others ? clod_near_groups(self) : 0;
    for (size_t q = first + 1; q < groups; q++) {
        clod_memory_give_back(&blocks[self->pairs.group_start[q]],
                              walk->fill[q] / CLOD_LANES * sizeof *blocks, bytes);
    }
    const size_t read = self->pairs.group_start[first] + walk->fill[first] / CLOD_LANES;
    return clod_near_give_back(blocks, bytes, given, read * sizeof *blocks);
}

static void export_pairs(const clod_near *self, const clod_neighbour *neighbour,
                         clod_state *state, const clod_laws *laws)
{
    const clod_contact_block *blocks = self->pairs.block;
    clod_near_walk walk = clod_near_walk_begin(self, &neighbour->pairs, state, laws);
    size_t given = 0;
    size_t next = CLOD_NEAR_GIVE_BACK;
    while (clod_near_walk_on(&walk)) { // ascending: no sorting
        const size_t at = clod_near_walk_lane(&walk);
        const clod_history *history = &blocks[at / CLOD_LANES].history;
        const int lane = (int)(at % CLOD_LANES);
        if (history->tangent[lane] == 0.0) { // never touched
            continue;
        }
        clod_contact *to = &state->contacts[state->contact_count++];
        *to = (clod_contact){.i = walk.i, .j = walk.j, .shape = -1};
        history_get(history, lane, to->history);
        if (state->contact_count >= next) {
            given = give_back_blocks(self, &walk, given, next % OTHER_GROUPS_EVERY == 0);
            next += CLOD_NEAR_GIVE_BACK;
        }
    }
}

/** Each candidate learns its row of contacts, or -1. */
static void export_walls(const clod_near *self, clod_neighbour *neighbour, clod_state *state)
{
    const clod_wall_block *blocks = self->walls.block;
    const size_t before = state->contact_count;
    for (size_t k = 0; k < neighbour->walls.count; k++) {
        clod_wall_candidate *c = &neighbour->walls.item[k];
        if (c->lane < 0) {
            continue;
        }
        const clod_history *history = &blocks[c->lane / CLOD_LANES].history;
        const int lane = c->lane % CLOD_LANES;
        c->lane = -1;
        if (history->tangent[lane] != 0.0) {
            c->lane = (int32_t)state->contact_count;
            clod_contact *to = &state->contacts[state->contact_count++];
            *to = (clod_contact){.i = c->i, .j = c->wall, .shape = c->shape};
            history_get(history, lane, to->history);
        }
    }
    state->wall_contact_count = state->contact_count - before;
}

bool clod_near_export(clod_near *self, clod_neighbour *neighbour, clod_state *state,
                      const clod_laws *laws, clod_status *status)
{
    if (!reserve_contacts(self, state, status)) {
        return false;
    }
    export_pairs(self, neighbour, state, laws);
    export_walls(self, neighbour, state);
    const size_t blocks = self->pairs.capacity * sizeof(clod_contact_block);
    clod_near_give_back(self->pairs.block, blocks, 0, blocks);
    return true;
}
