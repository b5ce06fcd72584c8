#include "step/spread_wear.h"

#include <stdlib.h>

#include "base/room.h"

clod_wear_record *clod_spread_wear_note(clod_step *step, size_t group, int32_t row)
{
    clod_spread *spread = step->spread;
    const clod_state *state = step->state;
    if (spread->wear_lost || !clod_room_for_one(&spread->wear, &spread->wear_room,
                                                spread->wear_count, sizeof *spread->wear)) {
        spread->wear_lost = true;
        return NULL;
    }
    clod_wear_record *record = &spread->wear[spread->wear_count];
    *record =
        (clod_wear_record){.key = clod_layers_key(&spread->layers, state->build_position[row]),
                           .id = state->grains.id[row],
                           .group = (int64_t)(group % ((size_t)step->near.laws * CLOD_FORMS)),
                           .number = (int64_t)spread->wear_count++};
    return record;
}

static int compare(uint64_t a, uint64_t b)
{
    return (a > b) - (a < b);
}

/** Law by law, form by form, in the order of grains. */
static int in_order(const void *a, const void *b)
{
    const clod_wear_record *x = a, *y = b;
    const int by_group = compare((uint64_t)x->group, (uint64_t)y->group);
    const int by_key = compare(x->key, y->key), by_id = compare(x->id, y->id);
    return by_group != 0 ? by_group
           : by_key != 0 ? by_key
           : by_id != 0  ? by_id
                         : compare((uint64_t)x->number, (uint64_t)y->number);
}

static void add_all(clod_state *state, clod_wear_record *record, size_t count)
{
    if (count > 1) {
        qsort(record, count, sizeof *record, in_order);
    }
    for (size_t k = 0; k < count; k++) {
        clod_wall *wall = &state->walls.wall[record[k].wall];
        double *sum = wall->wear[record[k].place];
        for (int c = 0; c < CLOD_WEAR_SUMS; c++) {
            sum[c] += record[k].sum[c];
        }
        if (record[k].begins != 0) {
            clod_impacts_add(clod_wear_impacts(wall, record[k].face), &record[k].impact);
        }
    }
}

void clod_spread_wear_add(clod_step *step)
{
    clod_spread *spread = step->spread;
    clod_bytes *out = spread->wear_out;
    clod_status ignored;
    clod_bytes_clear(&out[0]); // the others stay empty
    clod_bytes_put(&out[0], spread->wear, spread->wear_count * sizeof *spread->wear);
    out[0].lacks_memory |= spread->wear_lost;
    spread->wear_count = 0;
    if (!clod_ranks_swap(spread->ranks, out, &spread->wear_in, spread->wear_begin, &ignored)) {
        spread->wear_lost = true;
        return;
    }
    add_all(step->state, (clod_wear_record *)(void *)spread->wear_in.data,
            spread->wear_in.count / sizeof(clod_wear_record));
}
