// A new order of grains by all parts: the same rows and contacts as by gathering and sorting.
#include "step/reorder.h"
#include "support/bed.h"
#include "support/bits.h"

/** A bed with contacts whose grains have changed places among each other, all of them. */
static void shuffled_bed(scene *s, bed_kind kind, int threads)
{
    dice roll = {7};
    bed_init(s, kind, 3);
    scene_start_with(s, (clod_step_options){.threads = threads});
    scene_run(s, 2500);
    clod_grains *grains = &s->state.grains;
    for (size_t g = grains->count; g > 1; g--) {
        const size_t other = (size_t)dice_real(&roll, 0.0, (double)g - 1e-9);
        double row[4];
        memcpy(row, grains->position[g - 1], sizeof row);
        memcpy(grains->position[g - 1], grains->position[other], sizeof row);
        memcpy(grains->position[other], row, sizeof row);
    }
}

static void one_after_the_other(scene *s)
{
    clod_step *step = &s->step;
    assert_true(clod_near_gather(&step->near, &s->state, &step->walls, &step->status));
    clod_near_gather_end(&step->near);
    assert_true(clod_neighbour_sort(&step->neighbour, &s->state, &step->status));
}

/** The order of the grains, by all parts, but by one thread. */
static void find_order(clod_step *step)
{
    clod_state *state = step->state;
    clod_neighbour *neighbour = &step->neighbour;
    const int parts = step->near.parts;
    clod_layer_order order = {.neighbour = neighbour,
                              .grains = &state->grains,
                              .place = (const double(*)[4])state->grains.position,
                              .parts = parts};
    clod_barrier alone;
    clod_barrier_init(&alone, 1, 1);
    assert_true(clod_neighbour_reserve(neighbour, state, &step->status));
    for (int p = parts; p-- > 0;) {
        assert_true(clod_neighbour_wrap(neighbour, state, 0,
                                        clod_threads_chunk(state->grains.count, p, parts)));
        clod_layer_order_measure(&order, p);
    }
    clod_layer_order_begin(&order);
    for (int p = parts; p-- > 0;) {
        clod_layer_order_find_keys(&order, p);
    }
    clod_layer_order_sort(&order, (clod_chunk){0, (size_t)parts}, &alone);
}

static void by_parts(scene *s)
{
    clod_step *step = &s->step;
    clod_neighbour *neighbour = &step->neighbour;
    const int parts = step->near.parts;
    const clod_reorder job = {.neighbour = neighbour,
                              .near = &step->near,
                              .state = &s->state,
                              .walls = &step->walls,
                              .grains = s->state.grains.count};
    clod_row_column columns[CLOD_ROW_COLUMNS];
    find_order(step);
    for (int p = parts; p-- > 0;) { // in any order
        clod_reorder_begin(&job, p);
    }
    for (int p = parts; p-- > 0;) {
        clod_reorder_count(&job, p);
    }
    assert_true(clod_reorder_room(&job, &step->status));
    for (int p = parts; p-- > 0;) {
        clod_reorder_copy(&job, p);
    }
    for (int p = parts; p-- > 0;) {
        clod_reorder_ascend(&job, p);
    }
    const int count = clod_neighbour_columns(&s->state.grains, columns);
    for (int k = 0; k < count; k++) {
        for (int p = parts; p-- > 0;) {
            clod_neighbour_rows_out(neighbour, &columns[k],
                                    clod_threads_chunk(job.grains, p, parts));
        }
        for (int p = parts; p-- > 0;) {
            clod_neighbour_rows_back(neighbour, &columns[k],
                                     clod_threads_chunk(job.grains, p, parts));
        }
    }
    clod_near_gather_end(&step->near);
    assert_true(clod_neighbour_note(&step->neighbour, &s->state, &step->status));
    for (int p = parts; p-- > 0;) {
        clod_neighbour_note_positions(&s->state, clod_threads_chunk(job.grains, p, parts));
    }
    step->neighbour.now = false;
}

static void parts_do_what_gathering_and_sorting_do(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene plain;
        shuffled_bed(&plain, (bed_kind)kind, 1);
        one_after_the_other(&plain);
        assert_true(plain.state.contact_count > 20);
        for (int threads = 1; threads <= 5; threads += 2) {
            scene s;
            shuffled_bed(&s, (bed_kind)kind, threads);
            by_parts(&s);
            assert_int_equal(s.state.wall_contact_count, plain.state.wall_contact_count);
            check_same_bits(&plain.state, &s.state);
            scene_end(&s);
        }
        scene_end(&plain);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_do_what_gathering_and_sorting_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
