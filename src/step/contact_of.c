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

bool clod_step_contact_of(const clod_step *self, const uint64_t id[2], clod_contact *contact)
{
    const int32_t row[2] = {row_of(&self->state->grains, id[0]),
                            row_of(&self->state->grains, id[1])};
    if (row[0] < 0 || row[1] < 0 || row[0] == row[1] || !self->near.made) {
        return false;
    }
    const bool turned = row[0] > row[1];
    int lane;
    const clod_history *history =
        clod_near_find(&self->near, &self->near.pairs, row[turned], row[!turned], &lane);
    if (history == NULL) {
        return false;
    }
    *contact = (clod_contact){.i = row[turned], .j = row[!turned], .shape = -1};
    clod_history_get(history, lane, contact->history);
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
        shape >= walls->wall[wall].shape_count || !self->near.made) {
        return false;
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
