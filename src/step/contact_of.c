// One contact, asked for by its identity.
#include "step/near_cursor.h"
#include "step/step.h"

/** Row of a grain; -1: there is none. */
static int32_t row_of(const clod_grains *grains, uint64_t id)
{
    for (size_t g = 0; g < grains->count; g++) {
        if (grains->id[g] == id) {
            return (int32_t)g;
        }
    }
    return -1;
}

/** A contact of these rows in the state, which has them when the step has no list. */
static bool find_listed(const clod_state *state, int32_t i, int32_t j, int32_t shape,
                        clod_contact *contact)
{
    for (size_t c = 0; c < state->contact_count; c++) {
        const clod_contact *there = &state->contacts[c];
        if (there->i == i && there->j == j && there->shape == shape) {
            *contact = *there;
            return true;
        }
    }
    return false;
}

/** A contact of two rows, the lower one first. */
static bool find_pair(const clod_step *self, int32_t i, int32_t j, clod_contact *contact)
{
    if (!self->near.made) {
        return find_listed(self->state, i, j, -1, contact);
    }
    int lane;
    const clod_history *history = clod_near_find(&self->near, &self->near.pairs, i, j, &lane);
    if (history != NULL) {
        *contact = (clod_contact){.i = i, .j = j, .shape = -1};
        clod_history_get(history, lane, contact->history);
    }
    return history != NULL;
}

bool clod_step_contact_of(const clod_step *self, const uint64_t id[2], clod_contact *contact)
{
    const int32_t row[2] = {row_of(&self->state->grains, id[0]),
                            row_of(&self->state->grains, id[1])};
    if (row[0] < 0 || row[1] < 0 || row[0] == row[1]) {
        return false;
    }
    const bool turned = row[0] > row[1];
    if (!find_pair(self, row[turned], row[!turned], contact)) {
        return false;
    }
    if (turned) {
        clod_contact_turn(contact);
    }
    return true;
}

bool clod_step_wall_contact_of(const clod_step *self, uint64_t id, int32_t wall, int32_t shape,
                               clod_contact *contact)
{
    const clod_walls *walls = &self->state->walls;
    const int32_t row = row_of(&self->state->grains, id);
    if (row < 0 || wall < 0 || wall >= walls->count || shape < 0 ||
        shape >= walls->wall[wall].shape_count) {
        return false;
    }
    if (!self->near.made) {
        return find_listed(self->state, row, wall, shape, contact);
    }
    int lane;
    const clod_history *history =
        clod_near_find(&self->near, &self->near.walls, row,
                       clod_wall_rows_shape(&self->walls, wall, shape), &lane);
    if (history == NULL) {
        return false;
    }
    *contact = (clod_contact){.i = row, .j = wall, .shape = shape};
    clod_history_get(history, lane, contact->history);
    return true;
}
