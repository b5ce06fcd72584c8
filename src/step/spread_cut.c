// Where grains are spread over ranks: who gets which part of the bed.
#include "step/spread.h"

static void merge_bed(const void *context, void *into, const void *from)
{
    (void)context;
    clod_layers_extent_merge(into, from);
}

static void merge_weights(const void *context, void *into, const void *from)
{
    clod_partition_merge(into, from, *(const size_t *)context);
}

/** Extent of the own rows. */
static clod_layers_extent extent_of(const clod_spread *self, const clod_state *state)
{
    clod_layers_extent all = clod_layers_extent_of(NULL, 0);
    for (size_t g = 0; g < state->grains.count; g++) {
        if (clod_spread_has(self, g)) {
            const clod_layers_extent one =
                clod_layers_extent_of((const double(*)[4])state->build_position + g, 1);
            clod_layers_extent_merge(&all, &one);
        }
    }
    return all;
}

/** Put units of work into the block of a row, if it is own; how many. */
static double weigh_row(clod_spread *self, const clod_state *state, int32_t row, double units)
{
    if (!clod_spread_has(self, (size_t)row)) {
        return 0.0;
    }
    clod_partition_add(&self->partition, state->build_position[row], units);
    return units;
}

/** Put the units of work of own grains into the blocks: each is one, a half of a contact with
 *  another is a half, a contact with a wall is one. How many they are. */
static double weigh(clod_spread *self, const clod_state *state)
{
    double units = 0.0;
    clod_partition_begin(&self->partition, self->bed.min, self->bed.max);
    for (size_t g = 0; g < state->grains.count; g++) {
        units += weigh_row(self, state, (int32_t)g, 1.0);
    }
    for (size_t k = 0; k < state->contact_count; k++) {
        const clod_contact *contact = &state->contacts[k];
        if (contact->shape < 0) {
            units += weigh_row(self, state, contact->i, 0.5);
            units += weigh_row(self, state, contact->j, 0.5);
        } else {
            units += weigh_row(self, state, contact->i, 1.0);
        }
    }
    return units;
}

/** Cut by the weights of all ranks. */
static void cut_anew(clod_spread *self)
{
    clod_partition *partition = &self->partition;
    const size_t blocks = clod_partition_blocks(partition);
    clod_partition_scale(partition, self->balance.each);
    clod_ranks_merge(self->ranks, partition->weight, blocks * sizeof *partition->weight,
                     merge_weights, &blocks);
    clod_partition_cut(partition);
}

void clod_spread_cut(clod_spread *self, const clod_state *state)
{
    self->bed = extent_of(self, state);
    clod_ranks_merge(self->ranks, &self->bed, sizeof self->bed, merge_bed, NULL);
    self->layers = clod_layers_from(&self->bed);
    self->balance.each = 1.0;
    const double units = weigh(self, state);
    if (!self->partition.exists || clod_balance_asks(&self->balance, self->ranks, units)) {
        cut_anew(self);
    }
    clod_partition_bound(&self->partition, self->bed.min, self->bed.max);
}
