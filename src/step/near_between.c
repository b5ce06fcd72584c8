#include "step/near_between.h"

#include <string.h>

#include "base/room.h"
#include "step/near_parts.h"

/** The first block between parts; those of all parts and laws follow each other. */
static size_t first_block(const clod_near *self)
{
    return self->pairs.group_start[clod_near_group(self, self->parts, 0)];
}

/** At most so many runs: one for each contact, or each two parts and law. */
static size_t most_runs(const clod_near *self)
{
    const size_t parts = (size_t)self->parts;
    const size_t contacts = (self->pairs.count - first_block(self)) * CLOD_LANES;
    const size_t pairs = parts * (parts - 1) / 2 * (size_t)self->laws;
    return contacts < pairs ? contacts : pairs;
}

bool clod_near_between_reserve(clod_near *near)
{
    if (near->parts == 1) {
        return true;
    }
    clod_near_between *self = &near->between;
    const size_t lanes = (near->pairs.count - first_block(near)) * CLOD_LANES;
    return clod_room_for(&self->share, &self->share_capacity, lanes, sizeof *self->share) &&
           clod_room_for(&self->run, &self->run_capacity, most_runs(near), sizeof *self->run);
}

/** Go on to the next run of a group, in which i's part stays the same; false: there is none. */
static bool next_run(const clod_near *self, size_t group, clod_near_run *run, int *part)
{
    run->begin = run->end;
    if (run->begin == self->pairs.group_count[group]) {
        return false;
    }
    const clod_contact_block *blocks = self->pairs.block;
    blocks += self->pairs.group_start[group];
    *part = clod_near_part_of(self, blocks[run->begin / CLOD_LANES].i[run->begin % CLOD_LANES]);
    for (; run->end < self->pairs.group_count[group]; run->end++) {
        const int32_t i = blocks[run->end / CLOD_LANES].i[run->end % CLOD_LANES];
        if ((size_t)i >= self->part_start[*part + 1]) {
            break;
        }
    }
    return true;
}

/** Count the runs of each (law, earlier part), or put them down behind those that are there. */
static void walk_runs(clod_near *self, bool put)
{
    size_t *start = self->between.run_start;
    for (int32_t law = 0; law < self->laws; law++) {
        for (int later = 1; later < self->parts; later++) { // so they ascend by it
            clod_near_run run = {.later = later};
            int part = 0;
            while (next_run(self, clod_near_group_between(self, later, law), &run, &part)) {
                const size_t k = (size_t)law * (size_t)self->parts + (size_t)part;
                if (put) {
                    self->between.run[start[k]] = run;
                }
                start[put ? k : k + 1]++;
            }
        }
    }
}

void clod_near_between_make(clod_near *self)
{
    const size_t lists = (size_t)self->laws * (size_t)self->parts;
    size_t *start = self->between.run_start;
    memset(start, 0, (lists + 1) * sizeof *start);
    if (self->parts == 1) {
        return;
    }
    walk_runs(self, false);
    for (size_t k = 0; k < lists; k++) {
        start[k + 1] += start[k];
    }
    walk_runs(self, true); // now start[k] is where k ends
    memmove(start + 1, start, lists * sizeof *start);
    start[0] = 0;
}

double (*clod_near_between_shares(const clod_near *self, int later, int32_t law))[8]
{
    const size_t block = self->pairs.group_start[clod_near_group_between(self, later, law)];
    return self->between.share + (block - first_block(self)) * CLOD_LANES;
}

static const clod_contact_block *blocks_of(const clod_near *self, const clod_near_run *run,
                                           int32_t law)
{
    const clod_contact_block *blocks = self->pairs.block;
    return blocks + self->pairs.group_start[clod_near_group_between(self, run->later, law)];
}

void clod_near_between_take(const clod_near *self, const clod_near_run *run, int32_t law,
                            double (*load)[8])
{
    const double(*share)[8] =
        (const double(*)[8])clod_near_between_shares(self, run->later, law);
    const clod_contact_block *blocks = blocks_of(self, run, law);
    for (size_t k = run->begin; k < run->end; k++) {
        double *to = load[blocks[k / CLOD_LANES].i[k % CLOD_LANES]];
        for (int c = 0; c < 8; c++) {
            to[c] += share[k][c];
        }
    }
}
