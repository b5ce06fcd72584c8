// Stages between, contact and wall: the force of every contact onto its grains, in the order of
// contacts whatever the number of threads.
#include "parallel/threads.h"
#include "step/near_between.h"
#include "step/step.h"

/** Memory of a group from which it pays to ask for its rows ahead [bytes]: less lies in the
 * caches. */
#define LARGE_GROUP ((size_t)4 << 20)

/** The row behind the last of a part, up to which rows are asked for; 0: none are. */
static size_t ask_until(const clod_step *self, int part, size_t blocks)
{
    const clod_grains *grains = &self->state->grains;
    const size_t end = self->near.part_start[part + 1];
    const size_t row = sizeof *grains->place + sizeof *grains->motion +
                       sizeof *grains->turning + sizeof *grains->load;
    const size_t memory =
        (end - self->near.part_start[part]) * row + blocks * sizeof(clod_contact_block);
    return memory < LARGE_GROUP ? 0 : end;
}

/** Contacts of one law within one part. */
static bool run_within(clod_step *self, int part, int32_t law)
{
    const clod_near_blocks *pairs = &self->near.pairs;
    const size_t group = clod_near_group(&self->near, part, law);
    const size_t begin = pairs->group_start[group], end = pairs->group_start[group + 1];
    clod_contact_block *blocks = pairs->block;
    for (size_t b = begin; self->near.ledger && b < end; b++) {
        self->kernel->contact_spend(&self->view, &self->laws->law[law], &blocks[b],
                                    &pairs->spent[b]);
    }
    const size_t contacts = pairs->group_count[group];
    return contacts > 0 &&
           self->kernel->contact(&self->view, &self->laws->law[law], &blocks[begin], contacts,
                                 ask_until(self, part, end - begin), NULL);
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
            excess |= run_within(self, p, l);
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
