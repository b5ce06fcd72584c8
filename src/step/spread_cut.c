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

/** Units of work that a contact is for each of its grains: one in all, with a wall too. */
static double units_of(const clod_contact *contact)
{
    return contact->shape < 0 ? 0.5 : 1.0;
}

/** Units of work of own grains: each is one, and its contacts have theirs. */
static double count_units(const clod_spread *self, const clod_state *state)
{
    double units = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        units += clod_spread_has(self, g) ? 1.0 : 0.0;
    }
    for (size_t k = 0; k < state->contact_count; k++) {
        const clod_contact *contact = &state->contacts[k];
        const bool first = clod_spread_has(self, (size_t)contact->i);
        const bool second = contact->shape < 0 && clod_spread_has(self, (size_t)contact->j);
        units += (first ? units_of(contact) : 0.0) + (second ? units_of(contact) : 0.0);
    }
    return units;
}

/** Put units of work into the block of a row, if it is own. */
static void weigh_row(clod_spread *self, const clod_state *state, int32_t row, double units)
{
    if (clod_spread_has(self, (size_t)row)) {
        clod_partition_add(&self->partition, state->build_position[row], units);
    }
}

/** Put the units of work of own grains into the blocks. */
static void weigh(clod_spread *self, const clod_state *state)
{
    clod_partition_begin(&self->partition, self->bed.min, self->bed.max);
    for (size_t g = 0; g < state->grains.count; g++) {
        weigh_row(self, state, (int32_t)g, 1.0);
    }
    for (size_t k = 0; k < state->contact_count; k++) {
        const clod_contact *contact = &state->contacts[k];
        weigh_row(self, state, contact->i, units_of(contact));
        if (contact->shape < 0) {
            weigh_row(self, state, contact->j, units_of(contact));
        }
    }
}

/** Cut by the weights of all ranks. */
static void cut_anew(clod_spread *self, const clod_state *state)
{
    clod_partition *partition = &self->partition;
    weigh(self, state);
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
    if (!self->partition.exists ||
        clod_balance_asks(&self->balance, self->ranks, count_units(self, state))) {
        cut_anew(self, state);
    }
    clod_partition_bound(&self->partition, self->bed.min, self->bed.max);
}
