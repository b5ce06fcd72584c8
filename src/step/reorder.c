#include "step/reorder.h"

#include <string.h>

#include "step/near_cursor.h"
#include "step/near_walk.h"

/** Where the next contact of each grain goes: pairs, and those with walls. */
static int32_t *next_of(const clod_neighbour *self, bool pairs)
{
    return pairs ? self->cell_of : self->cell_item;
}

void clod_reorder_begin(clod_neighbour *self, size_t grains)
{
    memset(next_of(self, true), 0, grains * sizeof(int32_t));
    memset(next_of(self, false), 0, grains * sizeof(int32_t));
}

/** Earlier grain in the new order of the contact that a cursor is at. */
static int32_t first_of(const clod_neighbour *self, const clod_near_cursor *at, bool pairs)
{
    if (!pairs) {
        return self->rank[((const clod_wall_block *)at->block)->i[at->lane]];
    }
    const clod_contact_block *block = at->block;
    const int32_t i = self->rank[block->i[at->lane]], j = self->rank[block->j[at->lane]];
    return i < j ? i : j;
}

static void count_list(clod_neighbour *self, const clod_near *near, bool pairs, int part)
{
    int32_t *next = next_of(self, pairs);
    clod_near_cursor cursor =
        clod_near_cursor_begin(near, pairs ? &near->pairs : &near->walls, part);
    while (clod_near_cursor_next(&cursor)) {
        __atomic_fetch_add(&next[first_of(self, &cursor, pairs)], 1, __ATOMIC_RELAXED);
    }
}

void clod_reorder_count(clod_neighbour *self, const clod_near *near, int part)
{
    count_list(self, near, true, part);
    count_list(self, near, false, part);
}

/** From numbers to where each grain's contacts begin; the end of the last. */
static size_t sum_up(int32_t *next, size_t grains, size_t begin)
{
    for (size_t g = 0; g < grains; g++) {
        const int32_t count = next[g];
        next[g] = (int32_t)begin;
        begin += (size_t)count;
    }
    return begin;
}

bool clod_reorder_room(clod_neighbour *self, const clod_near *near, clod_state *state,
                       clod_status *status)
{
    const size_t grains = state->grains.count;
    const size_t pairs = sum_up(next_of(self, true), grains, 0);
    const size_t all = sum_up(next_of(self, false), grains, pairs);
    return clod_near_gather_reserve(near, state, pairs, all - pairs, status);
}

static void copy_list(clod_neighbour *self, const clod_near *near, clod_state *state,
                      const clod_wall_rows *walls, bool pairs, int part)
{
    int32_t *next = next_of(self, pairs);
    size_t count = 0;
    clod_near_cursor cursor =
        clod_near_cursor_begin(near, pairs ? &near->pairs : &near->walls, part);
    while (clod_near_cursor_next(&cursor)) {
        clod_contact contact;
        clod_near_cursor_copy(&cursor, walls, &contact);
        clod_neighbour_rename(self, &contact);
        state->contacts[__atomic_fetch_add(&next[contact.i], 1, __ATOMIC_RELAXED)] = contact;
        if (pairs && ++count % CLOD_NEAR_GIVE_BACK == 0) {
            clod_near_cursor_release(&cursor);
        }
    }
}

void clod_reorder_copy(clod_neighbour *self, const clod_near *near, clod_state *state,
                       const clod_wall_rows *walls, int part)
{
    copy_list(self, near, state, walls, true, part);
    copy_list(self, near, state, walls, false, part);
}

/** By insertion: a handful. */
static void ascend(clod_contact *contacts, size_t begin, size_t end)
{
    for (size_t k = begin + 1; k < end; k++) {
        const clod_contact moving = contacts[k];
        size_t at = k;
        for (; at > begin && clod_contact_compare(&contacts[at - 1], &moving) > 0; at--) {
            contacts[at] = contacts[at - 1];
        }
        contacts[at] = moving;
    }
}

void clod_reorder_ascend(const clod_neighbour *self, clod_state *state, clod_chunk grains)
{
    for (int list = 0; list < 2; list++) {
        const int32_t *end = next_of(self, list == 0); // by now the contacts of each end there
        const size_t base = list == 0 ? 0 : state->contact_count - state->wall_contact_count;
        for (size_t g = grains.begin; g < grains.end; g++) {
            ascend(state->contacts, g == 0 ? base : (size_t)end[g - 1], (size_t)end[g]);
        }
    }
}
