// How the grains are cut into parts for the threads.
#include "step/near_parts.h"

void clod_near_cut(const clod_near_job *job)
{
    clod_near *self = job->near;
    const size_t grains = job->state->grains.count;
    self->part_start[0] = 0;
    self->part_start[self->parts] = grains;
    if (self->parts == 1) {
        return;
    }
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
