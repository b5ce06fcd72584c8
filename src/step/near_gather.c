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
    if (!reserve_contacts(self, state, status)) {
        return false;
    }
    state->contact_count = pairs + walls;
    state->wall_contact_count = walls;
    return true;
}

static void copy_pairs(const clod_near *self, clod_state *state, int part, bool release)
{
    if (self->gathered[part].pairs == 0) { // there may be no list at all
        return;
    }
    clod_contact *to = &state->contacts[self->gathered[part].pair];
    size_t count = 0;
    clod_near_cursor cursor = clod_near_cursor_begin(self, &self->pairs, part);
    while (clod_near_cursor_next(&cursor)) {
        const clod_contact_block *block = cursor.block;
        const int lane = cursor.lane;
        *to = (clod_contact){.i = block->i[lane], .j = block->j[lane], .shape = -1};
        clod_history_get(&block->history, lane, to->history);
        to++;
        if (release && ++count % CLOD_NEAR_GIVE_BACK == 0) {
            clod_near_cursor_release(&cursor);
        }
    }
}

static void copy_walls(const clod_near *self, clod_state *state, const clod_wall_rows *walls,
                       int part)
{
    if (self->gathered[part].walls == 0) {
        return;
    }
    clod_contact *to = &state->contacts[self->gathered[part].wall];
    clod_near_cursor cursor = clod_near_cursor_begin(self, &self->walls, part);
    while (clod_near_cursor_next(&cursor)) {
        const clod_wall_block *block = cursor.block;
        const int lane = cursor.lane;
        const int32_t wall = block->wall[lane];
        const int32_t shape = block->shape[lane] / CLOD_SHAPE_ROWS - walls->first_shape[wall];
        *to = (clod_contact){.i = block->i[lane], .j = wall, .shape = shape};
        clod_history_get(&block->history, lane, to->history);
        to++;
    }
}

void clod_near_gather_copy(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                           int part, bool release)
{
    copy_pairs(self, state, part, release);
    copy_walls(self, state, walls, part);
}

void clod_near_gather_end(clod_near *self, bool release)
{
    if (release) {
        const size_t blocks = self->pairs.capacity * sizeof(clod_contact_block);
        clod_near_give_back(self->pairs.block, blocks, 0, blocks);
        self->made = false;
    }
}

bool clod_near_gather(clod_near *self, clod_state *state, const clod_wall_rows *walls,
                      bool release, clod_status *status)
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
        clod_near_gather_copy(self, state, walls, p, release);
    }
    clod_near_gather_end(self, release);
    return true;
}
