// From the blocks of the near list into the state's list of contacts.
#include "base/memory.h"
#include "state/limits.h"
#include "step/near_cursor.h"
#include "step/near_walk.h"

bool clod_near_gather_reserve(const clod_near *self, clod_state *state, size_t pairs,
                              size_t walls, clod_status *status)
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
    state->contact_count = pairs + walls;
    state->wall_contact_count = walls;
    return true;
}

void clod_near_gather_count(clod_near *self, int part)
{
    clod_near_range range = {0};
    clod_near_cursor pairs = clod_near_cursor_begin(self, &self->pairs, part);
    while (clod_near_cursor_next(&pairs)) {
        range.pairs++;
    }
    clod_near_cursor walls = clod_near_cursor_begin(self, &self->walls, part);
    while (clod_near_cursor_next(&walls)) {
        range.walls++;
    }
    self->gathered[part] = range;
}

bool clod_near_gather_room(clod_near *self, clod_state *state, clod_status *status)
{
    size_t pairs = 0, walls = 0;
    for (int p = 0; p < self->parts; p++) {
        self->gathered[p].pair = pairs;
        pairs += self->gathered[p].pairs;
    }
    for (int p = 0; p < self->parts; p++) {
        self->gathered[p].wall = pairs + walls;
        walls += self->gathered[p].walls;
    }
    return clod_near_gather_reserve(self, state, pairs, walls, status);
}

/** Copy the contacts of a part along one of the lists. */
static void copy_list(const clod_near *self, const clod_near_blocks *list,
                      const clod_wall_rows *walls, int part, bool release, clod_contact *to)
{
    size_t count = 0;
    clod_near_cursor cursor = clod_near_cursor_begin(self, list, part);
    while (clod_near_cursor_next(&cursor)) {
        clod_near_cursor_copy(&cursor, walls, &to[count++]);
        if (release && count % CLOD_NEAR_GIVE_BACK == 0) {
            clod_near_cursor_release(&cursor);
        }
    }
}

void clod_near_gather_copy(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                           int part, bool release)
{
    const clod_near_range *range = &self->gathered[part];
    if (range->pairs > 0) { // else there may be no list at all
        copy_list(self, &self->pairs, walls, part, release, &state->contacts[range->pair]);
    }
    if (range->walls > 0) {
        copy_list(self, &self->walls, walls, part, false, &state->contacts[range->wall]);
    }
}

void clod_near_gather_end(clod_near *self)
{
    const size_t blocks = self->pairs.capacity * sizeof(clod_contact_block);
    clod_near_give_back(self->pairs.block, blocks, 0, blocks);
    self->made = false;
}

bool clod_near_gather(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                      clod_status *status)
{
    if (!self->made) {
        return true;
    }
    for (int p = 0; p < self->parts; p++) {
        clod_near_gather_count(self, p);
    }
    if (!clod_near_gather_room(self, state, status)) {
        return false;
    }
    for (int p = 0; p < self->parts; p++) {
        clod_near_gather_copy(self, state, walls, p, false);
    }
    return true;
}
