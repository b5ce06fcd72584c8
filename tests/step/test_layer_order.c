// The order of grains by several parts and threads: that of the C library's sort by key, then id,
// with many grains of one key, and some that go. A domain that grains have left is found by all
// parts alike.
#include <pthread.h>
#include <stdlib.h>

#include "step/layer_order.h"
#include "support/dice.h"
#include "support/scene.h"

#define GRAINS 120
#define PLACES 25 ///< where the grains are; half of them at the first: its run goes over parts
#define MOST_THREADS 3

static void stacked_bed(scene *s)
{
    dice roll = {11};
    double place[PLACES][3];
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-6, &ore);
    for (int p = 0; p < PLACES; p++) {
        for (int a = 0; a < 3; a++) {
            place[p][a] = dice_real(&roll, -1.0, 1.0);
        }
    }
    for (size_t g = 0; g < GRAINS; g++) {
        const double *at = place[g % 2 == 0 ? 0 : dice_pick(&roll, PLACES)];
        scene_grain(s, at[0], at[1], at[2], 1e-3);
        s->state.grains.id[g] = g * 7919 % GRAINS; // each once: 7919 is a prime number
    }
}

/** A grain as the expected order has it. */
typedef struct expected_row {
    uint64_t key, id;
    int32_t old;
} expected_row;

static int compare(const void *a, const void *b)
{
    const expected_row *x = a;
    const expected_row *y = b;
    if (x->key != y->key) {
        return x->key < y->key ? -1 : 1;
    }
    return (x->id > y->id) - (x->id < y->id);
}

/** The order of grains whose rank is not below 0; their number. */
static size_t expected_order(const scene *s, const int32_t *rank, expected_row row[GRAINS])
{
    double staying[GRAINS][4];
    size_t stay = 0;
    for (int32_t g = 0; g < GRAINS; g++) {
        if (rank[g] >= 0) {
            memcpy(staying[stay], s->state.grains.position[g], sizeof *staying);
            row[stay++] = (expected_row){.id = s->state.grains.id[g], .old = g};
        }
    }
    const clod_layers layers = clod_layers_of((const double(*)[4])staying, stay);
    for (size_t k = 0; k < stay; k++) {
        row[k].key = clod_layers_key(&layers, staying[k]);
    }
    qsort(row, stay, sizeof *row, compare);
    return stay;
}

typedef struct member {
    clod_layer_order *order;
    clod_barrier *barrier;
    int number;
} member;

/** What a thread of the step does, with a barrier where it has one. */
static void *take_part(void *argument)
{
    const member *self = argument;
    const clod_chunk parts =
        clod_threads_chunk((size_t)self->order->parts, self->number, self->barrier->threads);
    for (size_t p = parts.begin; p < parts.end; p++) {
        clod_layer_order_measure(self->order, (int)p);
    }
    clod_barrier_wait(self->barrier);
    if (self->number == 0) {
        clod_layer_order_begin(self->order);
    }
    clod_barrier_wait(self->barrier);
    for (size_t p = parts.begin; p < parts.end; p++) {
        clod_layer_order_find_keys(self->order, (int)p);
    }
    clod_barrier_wait(self->barrier);
    clod_layer_order_sort(self->order, parts, self->barrier);
    return NULL;
}

static void run_threads(clod_layer_order *order, int threads)
{
    clod_barrier barrier;
    pthread_t thread[MOST_THREADS];
    member members[MOST_THREADS];
    clod_barrier_init(&barrier, threads, threads);
    for (int t = 0; t < threads; t++) {
        members[t] = (member){order, &barrier, t};
        assert_int_equal(pthread_create(&thread[t], NULL, take_part, &members[t]), 0);
    }
    for (int t = 0; t < threads; t++) {
        assert_int_equal(pthread_join(thread[t], NULL), 0);
    }
}

/** Every `every`th grain goes, or none. */
static void check_order(scene *s, int parts, int threads, size_t every)
{
    clod_status status = {0};
    clod_neighbour neighbour;
    expected_row row[GRAINS];
    size_t going = 0;
    clod_neighbour_init(&neighbour, &s->state, false);
    assert_true(clod_neighbour_reserve(&neighbour, &s->state, &status) &&
                clod_layer_order_reserve(&neighbour, parts));
    for (size_t g = 0; every > 0 && g < GRAINS; g += every) {
        neighbour.rank[g] = CLOD_NEIGHBOUR_GOES;
        going++;
    }
    const size_t stay = expected_order(s, neighbour.rank, row);
    assert_int_equal(stay, GRAINS - going);
    clod_layer_order order = {.neighbour = &neighbour,
                              .grains = &s->state.grains,
                              .place = (const double(*)[4])s->state.grains.position,
                              .going = going,
                              .parts = parts};
    run_threads(&order, threads);
    for (size_t k = 0; k < stay; k++) {
        assert_int_equal(neighbour.sort[k].index, row[k].old);
        assert_int_equal(neighbour.rank[row[k].old], k);
    }
    for (size_t g = 0; every > 0 && g < GRAINS; g += every) {
        assert_int_equal(neighbour.rank[g], CLOD_NEIGHBOUR_GOES);
    }
    clod_neighbour_fini(&neighbour);
}

static void grains_come_by_key_and_then_by_id(void **state)
{
    (void)state;
    static const size_t EVERY[] = {0, 7, 2, 1}; // 2: all of the first place; 1: all there are
    scene s;
    stacked_bed(&s);
    for (int threads = 1; threads <= MOST_THREADS; threads++) {
        for (size_t k = 0; k < sizeof EVERY / sizeof *EVERY; k++) {
            check_order(&s, threads, threads, EVERY[k]);
            check_order(&s, 8, threads, EVERY[k]);
            check_order(&s, GRAINS + 3, threads, EVERY[k]); // parts without grains
        }
    }
    clod_state_fini(&s.state);
}

/** By parts the same rows are wrapped, and the first of two grains outside is named. */
static void all_rows_are_wrapped_and_the_first_outside_is_named(void **state)
{
    (void)state;
    for (int parts = 1; parts <= 5; parts++) {
        clod_status status = {0};
        scene s;
        stacked_bed(&s);
        double(*position)[4] = s.state.grains.position;
        clod_neighbour neighbour = {0};
        s.state.domain.periodic[0] = true; // 20 m
        position[119][0] = 30.5;
        position[110][2] = -11.0;
        position[30][1] = 12.0;
        int outside = 0;
        for (int p = parts; p-- > 0;) {
            outside += !clod_neighbour_wrap(&neighbour, &s.state, 0,
                                            clod_threads_chunk(GRAINS, p, parts));
        }
        assert_int_equal(outside, parts == 1 ? 1 : 2);
        assert_true(position[119][0] == -9.5);
        assert_false(clod_neighbour_inside(&neighbour, &s.state, 0, &status));
        char expected[96];
        snprintf(expected, sizeof expected,
                 "step 0: grain %d has left the domain: y = 12 m, allowed -10 to 10 m; ",
                 30 * 7919 % GRAINS);
        assert_memory_equal(status.text, expected, strlen(expected));
        position[30][1] = 10.0;
        position[110][2] = -10.0;
        assert_true(clod_neighbour_inside(&neighbour, &s.state, 0, &status));
        clod_state_fini(&s.state);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grains_come_by_key_and_then_by_id),
        cmocka_unit_test(all_rows_are_wrapped_and_the_first_outside_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
