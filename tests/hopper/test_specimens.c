// What specimens of shear tests share: worked out by hand.

#include "hopper/specimens.h"

#include "support/check.h"

#define LOCI 3

/** Loci of which only the values are there that a hopper takes. */
typedef struct made {
    clod_locus loci[LOCI][4];
    clod_locus_mark marks[LOCI][4];
    clod_locus_group groups[LOCI];
    clod_locus_study study;
} made;

static void add(made *self, size_t g, int64_t seed, double sigma_1, double strength)
{
    clod_locus_group *group = &self->groups[g];
    const size_t k = group->seed_count++;
    group->seeds = self->loci[g];
    self->marks[g][k].seed = seed;
    self->loci[g][k] = (clod_locus){.marks = &self->marks[g][k]};
    self->loci[g][k].sigma_1.value = sigma_1;
    self->loci[g][k].sigma_c.value = strength;
    group->locus.sigma_1.value = 0.0;
    group->locus.sigma_c.value = 0.0;
    for (size_t i = 0; i <= k; i++) {
        group->locus.sigma_1.value +=
            self->loci[g][i].sigma_1.value / (double)group->seed_count;
        group->locus.sigma_c.value +=
            self->loci[g][i].sigma_c.value / (double)group->seed_count;
    }
    self->study = (clod_locus_study){.groups = self->groups, .count = LOCI};
}

/**
 * First locus: seeds 7 and 3 with sigma_1 90 and 110, f_c 24 and 20: off the means by 10 and 2, over
 * sqrt(2 x 1). Second: seeds 3, 7 and 9 with f_c 30, 33, 36: off by 3, over sqrt(3 x 2). Third: seed 9
 * alone, which tells no scatter.
 */
static void moves_belong_to_seeds(void **state)
{
    (void)state;
    static made of;
    add(&of, 0, 7, 90.0, 24.0);
    add(&of, 0, 3, 110.0, 20.0);
    add(&of, 1, 3, 200.0, 30.0);
    add(&of, 1, 7, 200.0, 33.0);
    add(&of, 1, 9, 200.0, 36.0);
    add(&of, 2, 9, 400.0, 50.0);
    clod_specimens self;
    assert_true(clod_specimens_of(&of.study, &self));
    assert_int_equal(self.count, 3);
    assert_int_equal(self.seeds[0], 3);
    assert_int_equal(self.seeds[1], 7);
    assert_int_equal(self.seeds[2], 9);
    const double *sigma = clod_specimens_at(&self, 0, CLOD_SPECIMENS_SIGMA_1);
    const double *low = clod_specimens_at(&self, 0, CLOD_SPECIMENS_STRENGTH);
    const double *high = clod_specimens_at(&self, 1, CLOD_SPECIMENS_STRENGTH);
    check_close(sigma[0], 10.0 / sqrt(2.0), 1e-12);
    check_close(sigma[1], -10.0 / sqrt(2.0), 1e-12);
    check_close(low[0], -2.0 / sqrt(2.0), 1e-12);
    check_close(low[1], 2.0 / sqrt(2.0), 1e-12);
    assert_true(isnan(sigma[2]) && isnan(low[2]));
    check_close(high[0], -3.0 / sqrt(6.0), 1e-12);
    check_close(high[1], 0.0, 1e-12);
    check_close(high[2], 3.0 / sqrt(6.0), 1e-12);
    for (size_t s = 0; s < 3; s++) {
        assert_true(isnan(clod_specimens_at(&self, 2, CLOD_SPECIMENS_STRENGTH)[s]));
    }
    // and back: what each said alone
    check_close(clod_specimens_value_of(22.0, low, 3, 0), 20.0, 1e-12);
    check_close(clod_specimens_value_of(33.0, high, 3, 2), 36.0, 1e-12);
    assert_true(isnan(clod_specimens_value_of(22.0, low, 3, 2)));
    assert_true(isnan(clod_specimens_value_of(50.0, NULL, 3, 2)));
    clod_specimens_fini(&self);
}

static void without_repeats_there_are_none(void **state)
{
    (void)state;
    static made of;
    for (size_t g = 0; g < LOCI; g++) {
        add(&of, g, 1, 100.0 * (double)(g + 1), 20.0);
    }
    clod_specimens self;
    assert_true(clod_specimens_of(&of.study, &self));
    assert_null(self.spread);
    clod_specimens_fini(&self);
}

/**
 * Who is where, of seven specimens at five stresses: the first and the third point share nobody, but
 * each of them somebody with the second; the fourth is of other specimens, the last of none. The
 * chain has the freedom of its pair, 1.
 */
static void sets_are_chains_of_specimens(void **state)
{
    (void)state;
    const double none = (double)NAN;
    const double spread[4][7] = {{0.1, 0.2, 0.3, none, none, none, none},
                                 {none, none, 0.1, 0.2, none, none, none},
                                 {none, none, none, 0.1, none, 0.2, 0.3},
                                 {none, none, none, none, 0.0, none, none}};
    const double two[8] = {none, none, none, none, 1.0, none, none, 0.0};
    clod_curve_point points[5] = {{.x = 3.0, .spread = spread[2]},
                                  {.x = 1.0, .spread = spread[1]},
                                  {.x = 2.0, .spread = spread[0]},
                                  {.x = 4.0, .spread = spread[3]},
                                  {.x = 5.0}};
    clod_specimens_sort(points, 5, 7);
    assert_int_equal(points[0].set, points[1].set);
    assert_int_equal(points[1].set, points[2].set);
    assert_true(points[3].set != points[0].set && points[4].set != points[0].set);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(points[i].freedom, 1);
    }
    assert_int_equal(points[3].freedom, 0); // one specimen tells no scatter
    assert_int_equal(points[4].freedom, 0);
    clod_curve_point one = {.x = 1.0, .spread = two};
    clod_specimens_sort(&one, 1, 8);
    assert_int_equal(one.freedom, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moves_belong_to_seeds),
        cmocka_unit_test(without_repeats_there_are_none),
        cmocka_unit_test(sets_are_chains_of_specimens),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
