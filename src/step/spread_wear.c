#include "step/spread_wear.h"

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

/** Law by law, form by form, in the order of grains. */
static bool is_before(const clod_wear_record *a, const clod_wear_record *b)
{
    if (a->group != b->group) {
        return a->group < b->group;
    }
    if (a->key != b->key) {
        return a->key < b->key;
    }
    return a->id != b->id ? a->id < b->id : a->number < b->number;
}

/** The record at `root` goes down the heap to its place. */
static void sift(clod_wear_record *record, size_t root, size_t count)
{
    const clod_wear_record sinking = record[root];
    for (size_t child = 2 * root + 1; child < count; child = 2 * root + 1) {
        child += child + 1 < count && is_before(&record[child], &record[child + 1]);
        if (!is_before(&sinking, &record[child])) {
            break;
        }
        record[root] = record[child];
        root = child;
    }
    record[root] = sinking;
}

/** Heapsort: in place, since qsort may allocate. */
static void sort(clod_wear_record *record, size_t count)
{
    for (size_t k = count / 2; k > 0; k--) {
        sift(record, k - 1, count);
    }
    for (size_t last = count; last > 1; last--) {
        const clod_wear_record greatest = record[0];
        record[0] = record[last - 1];
        record[last - 1] = greatest;
        sift(record, 0, last - 1);
    }
}

static void add_all(clod_state *state, clod_wear_record *record, size_t count)
{
    sort(record, count);
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
