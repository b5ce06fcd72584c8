#include "step/near_reader.h"

clod_near_reader clod_near_reader_begin(clod_near *near, const clod_wall_rows *walls)
{
    return (clod_near_reader){.near = near,
                              .walls = walls,
                              .list = &near->pairs,
                              .cursor = clod_near_cursor_begin(near, &near->pairs, 0)};
}

/** Go on to the next part, or to the walls; false: at the end. */
static bool turn_page(clod_near_reader *self)
{
    if (++self->part == self->near->parts) {
        if (self->list == &self->near->walls) {
            self->part--; // and stays there
            return false;
        }
        self->list = &self->near->walls;
        self->part = 0;
    }
    self->cursor = clod_near_cursor_begin(self->near, self->list, self->part);
    return true;
}

size_t clod_near_reader_next(clod_near_reader *self, clod_contact *to, size_t room)
{
    size_t count = 0;
    while (count < room) {
        if (clod_near_cursor_next(&self->cursor)) {
            clod_near_cursor_copy(&self->cursor, self->walls, &to[count++]);
        } else if (!turn_page(self)) {
            break;
        }
    }
    return count;
}
