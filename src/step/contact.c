// Stages contact, touch and wall: the force of every contact onto its grains, in the order of contacts
// whatever the number of threads.
#include "parallel/threads.h"
#include "step/near_between.h"
#include "step/step.h"
#include "step/touch.h"

/** Memory of a group from which it pays to prefetch its rows [bytes]: less lies in the
 * caches. */
#define LARGE_GROUP ((size_t)4 << 20)

/** The row behind the last of a part, up to which rows are prefetched; 0: none are. */
static size_t prefetch_until(const clod_step *self, int part, size_t blocks)
{
    const clod_grains *grains = &self->state->grains;
    const size_t end = self->near.part_start[part + 1];
    const size_t row = sizeof *grains->position + sizeof *grains->velocity +
                       sizeof *grains->angular_velocity + sizeof *grains->load;
    const size_t memory =
        (end - self->near.part_start[part]) * row + blocks * sizeof(clod_contact_block);
    return memory < LARGE_GROUP ? 0 : end;
}

/** Contacts of one group; `apart` as for the kernel. */
static bool run_group(clod_step *self, size_t group, int32_t law, size_t end,
                      double (*apart)[8])
{
    const clod_near_blocks *pairs = &self->near.pairs;
    const size_t contacts = pairs->group_count[group];
    if (contacts == 0) {
        return false;
    }
    clod_contact_block *blocks = pairs->block;
    const size_t begin = pairs->group_start[group];
    for (size_t b = begin; self->near.ledger && b < pairs->group_start[group + 1]; b++) {
        self->kernel->contact_dissipate(&self->view, &self->laws->law[law], &blocks[b],
                                        &pairs->dissipated[b]);
    }
    return self->kernel->contact(&self->view, &self->laws->law[law], &blocks[begin], contacts,
                                 end, apart);
}

/** Contacts of one law of the grains of a part with those of earlier ones. */
static bool run_between(clod_step *self, int part, int32_t law)
{
    const size_t group = clod_near_group_between(&self->near, part, law);
    return self->near.pairs.group_count[group] > 0 &&
           run_group(self, group, law, 0, clod_near_between_shares(&self->near, part, law));
}

/** Contacts of one law within one part. */
static bool run_within(clod_step *self, int part, int32_t law)
{
    const size_t *start = self->near.pairs.group_start;
    const size_t group = clod_near_group(&self->near, part, law);
    return run_group(self, group, law,
                     prefetch_until(self, part, start[group + 1] - start[group]), NULL);
}

/** What the grains of a part get from contacts of one law that later parts have computed. */
static void take_from_later(clod_step *self, int part, int32_t law)
{
    const clod_near_between *between = &self->near.between;
    const uint64_t mine = clod_gate_opened(&self->gate[part]);
    const size_t k = (size_t)law * (size_t)self->near.parts + (size_t)part;
    for (size_t r = between->run_start[k]; r < between->run_start[k + 1]; r++) {
        clod_gate_wait(&self->gate[between->run[r].later], mine);
        clod_near_between_take(&self->near, &between->run[r], law, self->state->grains.load);
    }
}

/** All contacts of a part, law by law: with earlier parts, within, with later ones. */
static bool run_part(clod_step *self, int part)
{
    bool excess = false;
    for (int32_t l = 0; l < self->laws->count; l++) {
        excess |= run_between(self, part, l);
        clod_gate_open(&self->gate[part]); // its shares are there
        excess |= run_within(self, part, l);
        take_from_later(self, part, l);
    }
    return excess;
}

void clod_step_contact(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    bool excess = false;
    // the last first: a thread with several parts must not wait for itself
    for (int p = (int)mine.end; p-- > (int)mine.begin;) {
        excess |= run_part(self, p);
    }
    self->thread[part].excess = excess;
}

/** Carry in the sums of forces on walls by a part's grains, where one may have more contacts than fit. */
static void carry_sums(clod_step *self, int part)
{
    const int32_t walls = self->state->walls.count;
    const int32_t *sum = self->near.part_sum + (size_t)part * (size_t)walls;
    for (int32_t w = 0; self->near.crowded && w < walls; w++) {
        if (sum[w] >= 0) {
            clod_fixed_carry(&self->near.wall_sum[sum[w]]);
        }
    }
}

/** Wall contacts of one group. */
static bool run_walls(clod_step *self, int part, int32_t l, clod_wall_form form)
{
    const clod_law *law = &self->laws->law[l];
    const clod_near_blocks *walls = &self->near.walls;
    const size_t group = clod_near_wall_group(&self->near, part, l, form);
    const size_t begin = walls->group_start[group];
    const size_t contacts = walls->group_count[group];
    if (contacts == 0) { // there may be no blocks at all
        return false;
    }
    clod_wall_block *blocks = (clod_wall_block *)walls->block + begin;
    bool excess = false;
    for (size_t b = begin; self->near.ledger && b < walls->group_start[group + 1]; b++) {
        self->kernel->wall_dissipate(&self->view, law, form, &blocks[b - begin],
                                     &walls->dissipated[b]);
    }
    for (size_t first = 0; first < contacts; first += CLOD_FIXED_ADDENDS) {
        const size_t left = contacts - first, block = first / CLOD_LANES;
        excess |= self->kernel->wall(&self->view, law, form, &blocks[block],
                                     self->near.wear ? &walls->rub[begin + block] : NULL,
                                     left < CLOD_FIXED_ADDENDS ? left : CLOD_FIXED_ADDENDS);
        carry_sums(self, part);
    }
    return excess;
}

/** All wall contacts of a part. */
static bool run_part_walls(clod_step *self, int part)
{
    bool excess = false;
    for (int32_t l = 0; l < self->laws->count; l++) {
        for (int form = 0; form < CLOD_FORMS; form++) {
            excess |= run_walls(self, part, l, (clod_wall_form)form);
        }
    }
    return excess;
}

void clod_step_touch(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    const uint64_t step = clod_gate_opened(&self->placed_gate[part]);
    for (int t = 0; t < self->threads; t++) {
        clod_gate_wait(&self->placed_gate[t], step);
    }
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        clod_touch_find(&self->near, self->state, &self->walls, p);
    }
}

void clod_step_wall(clod_step *self, int part)
{
    const clod_chunk mine = clod_threads_chunk((size_t)self->near.parts, part, self->threads);
    bool excess = false;
    for (int p = (int)mine.begin; p < (int)mine.end; p++) {
        excess |= run_part_walls(self, p);
    }
    self->thread[part].excess |= excess;
}
