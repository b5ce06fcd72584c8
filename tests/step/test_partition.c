// The cut of a bed for ranks: everyone has his share, and knows whose grains matter to whom.
#include "step/partition.h"

#include <stdlib.h>

#include "support/check.h"
#include "support/dice.h"

#define GRAINS 4000

static double place[GRAINS][3];

/** Grains in a bed of 1 x 2 x 0.5 m, most of them at one end. */
static void make_bed(void)
{
    dice roll = {5};
    for (int g = 0; g < GRAINS; g++) {
        const double x = dice_real(&roll, 0.0, 1.0);
        place[g][0] = x * x * x;
        place[g][1] = dice_real(&roll, 0.0, 2.0);
        place[g][2] = dice_real(&roll, 0.0, 0.5);
    }
}

static clod_partition partition_of(int ranks, int grains)
{
    static const double MIN[3] = {0.0, 0.0, 0.0}, MAX[3] = {1.0, 2.0, 0.5};
    clod_status status = {0};
    clod_partition self;
    assert_true(clod_partition_init(&self, ranks, &status));
    clod_partition_begin(&self, MIN, MAX);
    for (int g = 0; g < grains; g++) {
        clod_partition_add(&self, place[g]);
    }
    clod_partition_cut(&self);
    return self;
}

static void every_rank_has_its_share(void **state)
{
    (void)state;
    static const int RANKS[] = {1, 2, 3, 4, 7, 16};
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        clod_partition self = partition_of(RANKS[k], GRAINS);
        int count[16] = {0};
        for (int g = 0; g < GRAINS; g++) {
            count[clod_partition_owner(&self, place[g])]++;
        }
        for (int r = 0; r < RANKS[k]; r++) {
            // a slice of blocks has at most some 4 % of a half of the bed
            check_relative((double)count[r], (double)GRAINS / RANKS[k], 0.15);
        }
        clod_partition_fini(&self);
    }
}

/** Distance along one axis from a place to an interval, with images a period away; by hand. */
static double distance(double x, double low, double high, double period)
{
    double least = INFINITY;
    for (int image = -1; image <= 1; image++) {
        const double at = x + image * period;
        least = fmin(least, fmax(fmax(low - at, at - high), 0.0));
    }
    return least;
}

static void what_is_near_a_box_reaches_it(void **state)
{
    (void)state;
    const clod_domain domain = {.max = {1.0, 2.0, 0.5}, .periodic = {true, true, false}};
    clod_partition self = partition_of(7, GRAINS);
    const double reach = 0.06;
    int near = 0;
    for (int g = 0; g < GRAINS; g++) {
        for (int r = 0; r < 7; r++) {
            bool expected = true;
            for (int a = 0; a < 3; a++) {
                const double period = domain.periodic[a] ? domain.max[a] : 1e9;
                expected = expected && distance(place[g][a], self.low[r][a], self.high[r][a],
                                                period) <= reach;
            }
            near += expected;
            assert_int_equal(clod_partition_reaches(&self, &domain, r, place[g], reach),
                             expected);
            if (clod_partition_owner(&self, place[g]) == r) {
                assert_true(expected);
            }
        }
    }
    assert_true(near > GRAINS + 100 && near < 3 * GRAINS);
    clod_partition_fini(&self);
}

static void grains_that_lie_apart_have_two_ranks(void **state)
{
    (void)state;
    const clod_domain domain = {.max = {1.0, 2.0, 0.5}};
    clod_partition self = partition_of(16, 2);
    int owners[16] = {0};
    for (int g = 0; g < 2; g++) {
        owners[clod_partition_owner(&self, place[g])]++;
    }
    int busy = 0;
    for (int r = 0; r < 16; r++) {
        busy += owners[r] > 0;
        assert_true(owners[r] == 0 ||
                    clod_partition_reaches(&self, &domain, r, place[0], 1e-9) ||
                    clod_partition_reaches(&self, &domain, r, place[1], 1e-9));
    }
    assert_int_equal(busy, 2);
    clod_partition_fini(&self);
}

/** Ranks with 2^30 grains each in one block of the lower half, and as many in the upper one: as
 *  if 8 of them had told their numbers. */
static void blocks_of_more_grains_than_an_int_counts_are_cut(void **state)
{
    (void)state;
    clod_partition self = partition_of(2, 0);
    const size_t blocks = clod_partition_blocks(&self);
    int32_t *other = calloc(blocks, sizeof *other);
    other[0] = other[blocks - 1] = 1 << 30;
    for (int r = 0; r < 8; r++) {
        clod_partition_merge(self.weight, other, blocks);
    }
    assert_int_equal(self.weight[0], INT32_MAX);
    clod_partition_cut(&self);
    const double low[3] = {0.0, 0.0, 0.0}, high[3] = {1.0, 2.0, 0.5};
    assert_int_equal(clod_partition_owner(&self, low), 0);
    assert_int_equal(clod_partition_owner(&self, high), 1);
    free(other);
    clod_partition_fini(&self);
}

int main(void)
{
    make_bed();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_rank_has_its_share),
        cmocka_unit_test(what_is_near_a_box_reaches_it),
        cmocka_unit_test(grains_that_lie_apart_have_two_ranks),
        cmocka_unit_test(blocks_of_more_grains_than_an_int_counts_are_cut),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
