#include "state/alter.h"

#include "base/memory.h"

void clod_state_keep_walls(clod_state *self, const int32_t *rank)
{
    clod_walls *walls = &self->walls;
    int32_t kept = 0;
    for (int32_t w = 0; w < walls->count; w++) {
        if (rank[w] < 0) {
            clod_wall_fini(&walls->wall[w]);
        } else {
            walls->wall[kept++] = walls->wall[w];
        }
    }
    walls->count = kept;
}

bool clod_state_reserve_walls(clod_state *self, size_t count, clod_status *status)
{
    const size_t old = (size_t)self->walls.count;
    if (count == 0) {
        return true;
    }
    clod_wall *grown = clod_memory_grow(self->walls.wall, old, old + count, sizeof *grown);
    if (grown == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu walls", old + count);
    }
    self->walls.wall = grown;
    return true;
}

void clod_state_add_walls(clod_state *self, clod_wall *walls, size_t count)
{
    for (size_t w = 0; w < count; w++) {
        self->walls.wall[self->walls.count++] = walls[w];
        clod_wall_give(&walls[w]);
    }
}
