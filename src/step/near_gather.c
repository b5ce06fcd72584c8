// From the blocks of the near list into the state's list of contacts.
#include "base/memory.h"
#include "state/limits.h"
#include "step/near_cursor.h"
#include "step/near_walk.h"

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

static void gather_pairs(const clod_near *self, clod_state *state, bool release)
{
    clod_near_cursor cursor = clod_near_cursor_begin(self, &self->pairs);
    while (clod_near_cursor_next(&cursor)) {
        const clod_contact_block *block = cursor.block;
        const int lane = cursor.lane;
        clod_contact *to = &state->contacts[state->contact_count++];
        *to = (clod_contact){.i = block->i[lane], .j = block->j[lane], .shape = -1};
        clod_history_get(&block->history, lane, to->history);
        if (release && state->contact_count % CLOD_NEAR_GIVE_BACK == 0) {
            clod_near_cursor_release(&cursor);
        }
    }
}

static void gather_walls(const clod_near *self, clod_state *state, const clod_wall_rows *walls)
{
    const size_t before = state->contact_count;
    clod_near_cursor cursor = clod_near_cursor_begin(self, &self->walls);
    while (clod_near_cursor_next(&cursor)) {
        const clod_wall_block *block = cursor.block;
        const int lane = cursor.lane;
        const int32_t wall = block->wall[lane] / CLOD_WALL_ROWS;
        const int32_t shape = block->shape[lane] / CLOD_SHAPE_ROWS - walls->first_shape[wall];
        clod_contact *to = &state->contacts[state->contact_count++];
        *to = (clod_contact){.i = block->i[lane], .j = wall, .shape = shape};
        clod_history_get(&block->history, lane, to->history);
    }
    state->wall_contact_count = state->contact_count - before;
}

bool clod_near_gather(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                      bool release, clod_status *status)
{
    if (!self->made) {
        return true;
    }
    if (!reserve_contacts(self, state, status)) {
        return false;
    }
    gather_pairs(self, state, release);
    gather_walls(self, state, walls);
    if (release) {
        const size_t blocks = self->pairs.capacity * sizeof(clod_contact_block);
        clod_near_give_back(self->pairs.block, blocks, 0, blocks);
        self->made = false;
    }
    return true;
}
