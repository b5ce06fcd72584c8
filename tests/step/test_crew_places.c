// Places of grains that ranks keep: bricks fill a box once, the order of sizes is that of one list, and
// what is free is what a look at all grains finds free.
#include "step/crew_places.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "step/crew.h"
#include "step/crew_bricks.h"
#include "step/crew_deal.h"
#include "support/check.h"
#include "support/dice.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

static const int RANKS[] = {2, 3, 4, 7, 12};
#define SOME (sizeof RANKS / sizeof *RANKS)

// ---- bricks

static bool is_in(const clod_domain_box *box, const double at[3], double rounding)
{
    bool in = true;
    for (int a = 0; a < 3; a++) {
        in = in && at[a] >= box->low[a] - rounding && at[a] <= box->high[a] + rounding;
    }
    return in;
}

static double volume(const clod_domain_box *box)
{
    double product = 1.0;
    for (int a = 0; a < 3; a++) {
        product *= box->high[a] - box->low[a];
    }
    return product;
}

static void bricks_fill_a_box_once(void **state)
{
    (void)state;
    dice roll = {3};
    for (int ranks = 1; ranks <= 64; ranks++) {
        const clod_domain_box box = {{-1.0, 2.0, 0.5},
                                     {-1.0 + dice_real(&roll, 0.1, 3.0),
                                      2.0 + dice_real(&roll, 0.1, 3.0),
                                      0.5 + dice_real(&roll, 0.1, 3.0)}};
        int32_t bricks[3];
        clod_crew_bricks(&box, ranks, bricks);
        assert_int_equal(bricks[0] * bricks[1] * bricks[2], ranks);
        double sum = 0.0;
        for (int r = 0; r < ranks; r++) {
            const clod_domain_box brick = clod_crew_brick(&box, bricks, r);
            double middle[4];
            for (int a = 0; a < 3; a++) {
                middle[a] = 0.5 * (brick.low[a] + brick.high[a]);
            }
            assert_int_equal(clod_crew_brick_of(&box, bricks, middle), r);
            sum += volume(&brick);
        }
        check_relative(sum, volume(&box), 1e-12);
        for (int k = 0; k < 200; k++) {
            double at[4];
            for (int a = 0; a < 3; a++) {
                at[a] = dice_real(&roll, box.low[a], box.high[a]);
            }
            const int owner = clod_crew_brick_of(&box, bricks, at);
            const clod_domain_box brick = clod_crew_brick(&box, bricks, owner);
            assert_true(is_in(&brick, at, 1e-12));
        }
    }
}

static void bricks_of_a_cube_are_cubes(void **state)
{
    (void)state;
    const clod_domain_box cube = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
    int32_t bricks[3];
    clod_crew_bricks(&cube, 64, bricks);
    for (int a = 0; a < 3; a++) {
        assert_int_equal(bricks[a], 4);
    }
}

// ---- the order of sizes

#define GRAINS 5000

static double radius[GRAINS]; ///< m

/** The larger first, and equal ones by number. */
static int compare_sizes(const void *a, const void *b)
{
    const size_t x = *(const size_t *)a, y = *(const size_t *)b;
    if (radius[x] != radius[y]) {
        return radius[x] > radius[y] ? -1 : 1;
    }
    return x < y ? -1 : 1;
}

static void begin_places(clod_crew_places *self, clod_ranks *ranks, const clod_state *of,
                         const clod_crew_places_what *what)
{
    clod_status status = {0};
    if (!clod_crew_places_begin(self, ranks, of, what, &status)) {
        fail_msg("%s", status.text);
    }
}

static const clod_crew_places_what ANY = {
    .box = {{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}}, .largest = 0.1, .grains = GRAINS};

/** Give all sizes, some at a time, and have them back, some at a time. */
static void sort_sizes(clod_ranks *ranks, void *context)
{
    const int *kinds = context; // different sizes
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    clod_status status = {0};
    clod_state none = {0};
    clod_crew_places places = {0};
    dice roll = {(uint64_t)*kinds};
    static size_t expected[GRAINS];
    for (size_t g = 0; g < GRAINS; g++) {
        radius[g] = 0.01 * (1 + dice_pick(&roll, *kinds));
        expected[g] = g;
    }
    qsort(expected, GRAINS, sizeof *expected, compare_sizes);
    begin_places(&places, ranks, &none, &ANY);
    for (size_t g = 0, count; g < GRAINS; g += count) {
        count = 1 + (size_t)dice_pick(&roll, 300);
        count = count < GRAINS - g ? count : GRAINS - g;
        assert_true(clod_crew_places_sizes(&places, ranks, radius + g, count, &status));
    }
    size_t found = 0;
    do {
        assert_true(
            clod_crew_places_next(&places, ranks, 1 + (size_t)dice_pick(&roll, 40), &status));
        for (size_t k = 0; k < places.sizes.ready; k++) {
            assert_true(found < GRAINS);
            assert_int_equal(places.sizes.pool[k].index, expected[found++]);
        }
    } while (places.sizes.ready > 0);
    assert_int_equal(found, GRAINS);
    clod_crew_places_end(&places, ranks);
    clod_crew_dismiss(ranks);
}

static void sizes_come_in_the_order_of_one_list(void **state)
{
    (void)state;
    const int kinds[] = {1, 7, 1000000};
    for (size_t k = 0; k < SOME; k++) {
        for (size_t of = 0; of < sizeof kinds / sizeof *kinds; of++) {
            int some = kinds[of];
            ranks_run(RANKS[k], sort_sizes, &some);
        }
    }
}

// ---- what is free

/** Distance in a direction of which the box may be a period. */
static double distance(const clod_crew_places_what *what, int a, double x, double y)
{
    const double period = what->domain.max[a] - what->domain.min[a];
    const double d = fabs(x - y);
    return what->domain.periodic[a] ? fmin(d, fabs(d - period)) : d;
}

static bool overlap(const clod_crew_places_what *what, const double a[4], const double b[4])
{
    double square = 0.0;
    for (int k = 0; k < 3; k++) {
        const double d = distance(what, k, a[k], b[k]);
        square += d * d;
    }
    return square < (a[3] + b[3]) * (a[3] + b[3]);
}

#define EARLIER 40
#define PUT 1200
#define BATCH 60

/** Grains that are there, then batches of grains at random places: those free of all are put. */
typedef struct crowd {
    clod_crew_places_what what;
    double there[EARLIER + PUT][4];
    size_t count; ///< of them
    uint64_t number;
    dice roll;
} crowd;

static bool is_free(const crowd *self, const double place[4])
{
    bool free = true;
    for (size_t k = 0; free && k < self->count; k++) {
        free = !overlap(&self->what, place, self->there[k]);
    }
    return free;
}

static void draw(crowd *self, double place[4])
{
    for (int a = 0; a < 3; a++) {
        place[a] = dice_real(&self->roll, self->what.box.low[a], self->what.box.high[a]);
    }
    place[3] = dice_real(&self->roll, 0.2, 1.0) * self->what.largest;
}

/** Ask about places, and compare with a look at all; put those that are free of each other. */
static size_t try_batch(crowd *self, clod_crew_places *places, clod_ranks *ranks)
{
    clod_status status = {0};
    double place[BATCH][4];
    bool clear[BATCH], expected[BATCH];
    clod_placed_sphere put[BATCH];
    size_t count = 0;
    for (size_t k = 0; k < BATCH; k++) {
        draw(self, place[k]);
        expected[k] = is_free(self, place[k]);
    }
    assert_true(
        clod_crew_places_ask(places, ranks, (const double(*)[4])place, BATCH, clear, &status));
    for (size_t k = 0; k < BATCH; k++) {
        assert_int_equal(clear[k], expected[k]);
        if (is_free(self, place[k])) {
            memcpy(self->there[self->count++], place[k], sizeof *place);
            memcpy(put[count].place, place[k], sizeof *place);
            put[count++].number = self->number++;
        }
    }
    assert_true(clod_crew_places_put(places, ranks, put, count, &status));
    return count;
}

/** All grains that were put come back by their numbers. */
static void check_fetched(const crowd *self, clod_crew_places *places, clod_ranks *ranks)
{
    enum { PIECE = 37 };
    clod_status status = {0};
    double place[PIECE][4];
    for (size_t first = 0; first < self->number; first += PIECE) {
        const size_t left = self->number - first, count = left < PIECE ? left : PIECE;
        memset(place, 0, sizeof place);
        assert_true(clod_crew_places_fetch(places, ranks, first, count, place, &status));
        assert_memory_equal(place, self->there[EARLIER + first], count * sizeof *place);
    }
}

static void crowd_run(clod_ranks *ranks, void *context)
{
    crowd *self = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    clod_status status = {0};
    clod_crew_places places = {0};
    clod_state rows = {0};
    for (size_t k = 0; k < EARLIER; k++) {
        const double none[3] = {0.0};
        draw(self, self->there[k]);
        assert_true(clod_grains_add(&rows.grains, self->there[k], none, none, 1000.0, 0, k + 1,
                                    &status));
    }
    assert_true(clod_crew_deal_begin(ranks, &rows, EARLIER, EARLIER, &status));
    assert_true(clod_crew_deal(ranks, &rows, 0, &status)); // ranks have their rows now
    assert_true(ranks->size == 1 || rows.grains.count < EARLIER);
    self->count = EARLIER;
    begin_places(&places, ranks, &rows, &self->what);
    size_t batches = 0;
    while (self->count + BATCH <= EARLIER + PUT && batches++ < 60) {
        try_batch(self, &places, ranks);
    }
    assert_true(self->number > 200); // it gets crowded, and many were put
    check_fetched(self, &places, ranks);
    clod_crew_places_end(&places, ranks);
    clod_state_fini(&rows);
    clod_crew_dismiss(ranks);
}

static void compare_places(const clod_crew_places_what *what)
{
    for (size_t k = 0; k < SOME; k += sanitized() ? 2 : 1) {
        static crowd self;
        self = (crowd){.what = *what, .roll = {7 + k}};
        ranks_run(RANKS[k], crowd_run, &self);
    }
}

static void free_places_are_those_of_a_look_at_all_grains(void **state)
{
    (void)state;
    compare_places(&(clod_crew_places_what){
        .box = {{0.0, 0.0, 0.0}, {1.0, 0.7, 0.4}}, .largest = 0.05, .grains = PUT});
}

/** The box is a whole period in two directions: places at one side are near those at the other. */
static void free_places_know_of_periodic_images(void **state)
{
    (void)state;
    compare_places(&(clod_crew_places_what){.domain = {.min = {0.0, 0.0, -1.0},
                                                       .max = {1.0, 0.5, 2.0},
                                                       .periodic = {true, true, false}},
                                            .box = {{0.0, 0.0, 0.0}, {1.0, 0.5, 0.5}},
                                            .largest = 0.06,
                                            .grains = PUT});
}

/** Bricks that are thinner than a grain. */
static void free_places_are_right_in_a_box_of_few_grains(void **state)
{
    (void)state;
    compare_places(&(clod_crew_places_what){
        .box = {{0.0, 0.0, 0.0}, {0.3, 0.31, 3.0}}, .largest = 0.1, .grains = PUT});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bricks_fill_a_box_once),
        cmocka_unit_test(bricks_of_a_cube_are_cubes),
        cmocka_unit_test(sizes_come_in_the_order_of_one_list),
        cmocka_unit_test(free_places_are_those_of_a_look_at_all_grains),
        cmocka_unit_test(free_places_know_of_periodic_images),
        cmocka_unit_test(free_places_are_right_in_a_box_of_few_grains),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
