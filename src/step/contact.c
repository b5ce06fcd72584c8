// Stages between, contact and wall: the force of every contact onto its grains, in the order of
// contacts whatever the number of threads.
#include "parallel/threads.h"
#include "step/near_between.h"
#include "step/step.h"

/** Contacts of one group, whose grains come before row `end`. */
static bool run_group(clod_step *self, size_t group, int32_t law, size_t end)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    clod_contact_block *blocks = pairs->block;
    const size_t begin = pairs->group_start[group];
    for (size_t b = begin; self->near.ledger && b < pairs->group_start[group + 1]; b++) {
        self->kernel->contact_spend(&self->view, &self->laws->law[law], &blocks[b],
                                    &pairs->spent[b]);
    }
    const size_t contacts = pairs->group_count[group];
    return contacts > 0 && self->kernel->contact(&self->view, &self->laws->law[law],
                                                 &blocks[begin], contacts, end, NULL);
}

/** This thread's share of the blocks of a law between two parts. */
static bool run_between(clod_step *self, int32_t law, int part)
{
    const clod_near *near = &self->near;
    const size_t group = clod_near_group(near, near->parts, law);
    const size_t begin = near->pairs.group_start[group];
    const size_t first = near->pairs.group_start[clod_near_group(near, near->parts, 0)];
    const size_t end = near->pairs.group_start[group + 1];
    const clod_chunk mine = clod_threads_chunk(end - begin, part, self->threads);
    clod_contact_block *blocks = near->pairs.block;
    for (size_t b = begin + mine.begin; near->ledger && b < begin + mine.end; b++) {
        self->kernel->contact_spend(&self->view, &self->laws->law[law], &blocks[b],
                                    &near->pairs.spent[b]);
    }
    const size_t from = mine.begin * CLOD_LANES;
    const size_t all = near->pairs.group_count[group];
    const size_t to = mine.end * CLOD_LANES < all ? mine.end * CLOD_LANES : all;
    const size_t number = (begin - first) * CLOD_LANES + from;
    return to > from && self->kernel->contact(&self->view, &self->laws->law[law],
                                              blocks + begin + mine.begin, to - from, 0,
                                              near->between.share + 2 * number);
}

void clod_step_between(clod_step *self, int part)
{
    bool excess = false;
    for (int32_t l = 0; l < self->laws->count && self->near.parts > 1; l++) {
        excess |= run_between(self, l, part);
    }
    self->thread[part].excess = excess;
}

void clod_step_contact(clod_step *self, int part)
{
    double(*load)[8] = self->state->grains.load;
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    bool excess = false;
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        for (int32_t l = 0; l < self->laws->count; l++) {
            if (self->near.parts > 1) {
                clod_near_between_add(&self->near, p, l, false, load);
            }
            excess |= run_group(self, clod_near_group(&self->near, p, l), l,
                                self->near.part_start[p + 1]);
            if (self->near.parts > 1) {
                clod_near_between_add(&self->near, p, l, true, load);
            }
        }
    }
    self->thread[part].excess |= excess;
}

/** Wall contacts of one group. */
static bool run_walls(clod_step *self, size_t group, const clod_law *law)
{
    const clod_near_blocks *walls = &self->near.walls;
    clod_wall_block *blocks = walls->block;
    const size_t begin = walls->group_start[group];
    for (size_t b = begin; self->near.ledger && b < walls->group_start[group + 1]; b++) {
        self->kernel->wall_spend(&self->view, law, &blocks[b], &walls->spent[b]);
    }
    const size_t contacts = walls->group_count[group];
    return contacts > 0 && self->kernel->wall(&self->view, law, &blocks[begin], contacts);
}

void clod_step_wall(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    bool excess = false;
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        for (int32_t l = 0; l < self->laws->count; l++) {
            excess |= run_walls(self, clod_near_group(&self->near, p, l), &self->laws->law[l]);
        }
    }
    self->thread[part].excess |= excess;
}
