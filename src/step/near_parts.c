// How the grains are cut into parts for the threads.
#include "step/near_parts.h"

// Work by the time that it takes (docs/adr/0022).
#define GRAIN_WORK 1 ///< moving a grain
#define PAIR_WORK 3  ///< a contact between two grains
#define WALL_WORK 4  ///< one with a wall: its gap comes on top

/** A contact is the work of its later grain: that one's part computes it. */
static void weigh_pairs(int32_t *weight, const clod_pairs *pairs)
{
    for (size_t k = 0; k < pairs->count; k++) {
        weight[pairs->item[k].j] += PAIR_WORK * pairs->item[k].near;
    }
}

/** A wall leaves all work to the grain. */
static void weigh_walls(int32_t *weight, const clod_wall_candidates *walls)
{
    for (size_t k = 0; k < walls->count; k++) {
        weight[walls->item[k].i] += WALL_WORK * walls->item[k].near;
    }
}

void clod_near_cut(clod_near *self, const clod_neighbour *neighbour, size_t grains)
{
    self->part_start[0] = 0;
    self->part_start[self->parts] = grains;
    if (self->parts == 1) {
        return;
    }
    for (size_t g = 0; g < grains; g++) {
        self->weight[g] = GRAIN_WORK;
    }
    weigh_pairs(self->weight, &neighbour->pairs);
    weigh_walls(self->weight, &neighbour->walls);
    int64_t all = 0;
    for (size_t g = 0; g < grains; g++) {
        all += self->weight[g];
    }
    int64_t sum = 0;
    int part = 1;
    for (size_t g = 0; g < grains && part < self->parts; g++) {
        for (; part < self->parts && sum * self->parts >= all * part; part++) {
            self->part_start[part] = g;
        }
        sum += self->weight[g];
    }
    for (; part < self->parts; part++) {
        self->part_start[part] = grains;
    }
}

int clod_near_part_of(const clod_near *self, int32_t grain)
{
    int part = 0;
    while (part + 1 < self->parts && (size_t)grain >= self->part_start[part + 1]) {
        part++;
    }
    return part;
}
