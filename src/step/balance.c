#include "step/balance.h"

#include <math.h>

#include "base/clock.h"

/** What a grain or contact of a rank weighs at most over the mean, and at least under it: a rank
 *  that something else held up once gets no cut that is far off. */
#define WEIGHT_MOST 4.0

/** Processor time of this thread outside of messages [s]. */
static double worked(const clod_ranks *ranks)
{
    return clod_clock_worked() - ranks->count.spun;
}

void clod_balance_go_on(clod_balance *self, const clod_ranks *ranks)
{
    self->began = worked(ranks);
    self->runs = true;
}

void clod_balance_pause(clod_balance *self, const clod_ranks *ranks)
{
    if (self->runs) {
        self->time += worked(ranks) - self->began;
        self->runs = false;
    }
}

/** Work of some ranks. */
typedef struct work {
    double time, most_time;   ///< s
    double units, most_units; ///< grains and contacts
    int64_t moved;
} work;

static void merge(const void *context, void *into, const void *from)
{
    (void)context;
    work *mine = into;
    const work *other = from;
    mine->time += other->time;
    mine->units += other->units;
    mine->moved += other->moved;
    mine->most_time = fmax(mine->most_time, other->most_time);
    mine->most_units = fmax(mine->most_units, other->most_units);
}

/** The most of a rank over the mean; 1 where there is nothing to do. */
static double most_over_mean(double most, double sum, int ranks)
{
    return sum > 0.0 ? most * (double)ranks / sum : 1.0;
}

static void note(clod_ranks_evenness *self, double uneven, int64_t moved)
{
    self->looks++;
    self->moved += moved;
    self->sum += uneven;
    self->most = fmax(self->most, uneven);
}

bool clod_balance_asks(clod_balance *self, clod_ranks *ranks, double units)
{
    const bool runs = self->runs;
    clod_balance_pause(self, ranks);
    const double time = self->time;
    work all = {time, time, units, units, self->moved};
    clod_ranks_merge(ranks, &all, sizeof all, merge, NULL);
    const bool by_time = !self->options.by_counts && all.time > 0.0 && all.units > 0.0;
    const double uneven = by_time ? most_over_mean(all.most_time, all.time, ranks->size)
                                  : most_over_mean(all.most_units, all.units, ranks->size);
    self->each = 1.0;
    if (by_time && units > 0.0) {
        const double over_mean = time / units * (all.units / all.time);
        self->each = fmin(fmax(over_mean, 1.0 / WEIGHT_MOST), WEIGHT_MOST);
    }
    note(&ranks->evenness, uneven, all.moved);
    self->time = 0.0;
    self->moved = 0;
    if (runs) {
        clod_balance_go_on(self, ranks);
    }
    const double threshold = self->options.threshold;
    const bool asks = uneven >= (threshold > 0.0 ? threshold : CLOD_BALANCE_THRESHOLD);
    ranks->evenness.cuts += asks;
    return asks;
}
