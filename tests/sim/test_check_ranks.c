// What ranks would cost, beside counts of docs/scaling.md and sums made by hand.

#include "sim/check_ranks.h"

#include "support/check.h"

static clod_check_ranks_share share_of(double grains, int ranks)
{
    const clod_check_ranks_bed bed = {grains, ranks, 1.29};
    return clod_check_ranks_share_of(&bed);
}

/**
 * bench/packings/pack_4k: radii evenly from 2.85 to 3.49 mm, mean volume 4/3 pi (3.17^3 + 3.17
 * 0.64^2/4) = 134.7937 mm3; 7.707 mm (0.62/134.7937 mm3)^(1/3). docs/scaling.md rounds it up.
 */
static void a_rank_sees_1_29_layers_of_the_packing(void **unused)
{
    (void)unused;
    check_relative(clod_check_ranks_layers(3.17e-3, 3.49e-3, 134.7937e-9, 0.62), 1.28173, 1e-5);
}

/** Predicted in the table of docs/scaling.md by bench/scaling/geometry.py, in whole grains; the
 * beds of 3e5 and 3e6 there are no cubes. */
static void ghosts_are_those_of_the_table(void **unused)
{
    (void)unused;
    static const struct {
        double grains;
        int ranks;
        double ghosts;
    } TABLE[] = {{3750, 2, 623},    {3750, 4, 726},   {3750, 8, 639},   {3750, 16, 458},
                 {30000, 2, 2491},  {30000, 4, 2698}, {30000, 8, 2196}, {30000, 16, 1521},
                 {30000, 32, 1002}, {30000, 64, 639}};
    for (size_t t = 0; t < sizeof TABLE / sizeof TABLE[0]; t++) {
        const clod_check_ranks_share share = share_of(TABLE[t].grains, TABLE[t].ranks);
        check_relative(share.own, TABLE[t].grains / TABLE[t].ranks, 1e-12);
        check_relative(share.ghosts, TABLE[t].ghosts, 4e-3); // the table has 1.29 rounded
    }
}

/** n ((1 + 2 l / n^(1/3))^3 - 1) with n = 1000: 1.258^3 - 1 = 0.990865512. */
static void many_ranks_are_cubes_with_others_on_all_sides(void **unused)
{
    (void)unused;
    const clod_check_ranks_share share = share_of(512e3, 512);
    check_relative(share.ghosts, 990.865512, 1e-9);
    check_relative(share.neighbours, 26.0, 1e-12);
    check_relative(share_of(512e3, 4).neighbours, 3.0, 1e-12);
}

static void no_rank_has_more_than_all(void **unused)
{
    (void)unused;
    check_relative(share_of(8, 2).ghosts, 4.0, 1e-9);
    check_relative(share_of(8, 8).ghosts, 7.0, 1e-9);
    assert_true(share_of(8, 1).ghosts == 0.0);
}

static void a_merge_has_rounds_within_a_machine_and_between(void **unused)
{
    (void)unused;
    assert_true(clod_check_ranks_merge(1, 16) == 0.0);
    check_relative(clod_check_ranks_merge(8, 16), 4.5e-6, 1e-9);  // 3 of 1.5
    check_relative(clod_check_ranks_merge(6, 16), 6e-6, 1e-9);    // 2, and 2 as 6 is no power
    check_relative(clod_check_ranks_merge(64, 16), 9.2e-6, 1e-9); // 4 of 1.5, 2 of 1.6
    check_relative(clod_check_ranks_merge(1000000, 1), 33.4e-6, 1e-9); // 19 of 1.6, 2 of 1.5
}

static double step_of(double grains, int ranks, double row, int node)
{
    const clod_check_ranks_bed bed = {grains, ranks, 1.29};
    const clod_check_ranks_machine machine = {row, 100e-9, node};
    return clod_check_ranks_step(&bed, &machine);
}

/**
 * 1000 grains and 990.865512 ghosts a rank. Ghosts by 0.7 of a row, calls 2 (25 0.66 + 26 0) + 1.2
 * = 34.2 us (2.7 kB a message), copies 1.5 us + 71.342 kB / 6.1 GB/s = 13.195 us, a merge of 9
 * rounds 13.5 us.
 */
static void a_step_is_the_sum_of_its_parts(void **unused)
{
    (void)unused;
    check_relative(step_of(1000, 1, 100e-9, 1), 100e-6, 1e-9);
    check_relative(step_of(512e3, 512, 100e-9, 512), (100.0 + 69.360586 + 34.2 + 13.5) * 1e-6,
                   1e-6);
    // with threads own rows take half, and so does what of a ghost is not packing: 0.7 (40 + 30) ns
    check_relative(step_of(512e3, 512, 50e-9, 512), (50.0 + 48.552410 + 34.2 + 13.5) * 1e-6,
                   1e-6);
}

/**
 * 8 a machine, across 2: (20 + 2.58)^3 of 8 12.58^3 = 15926.924 stay, 11512.558 do not: 4414.366
 * come, 317.834 kB, 13.243 us and 1.6; the merge has 3 rounds of 1.5 and 6 of 1.6: 14.1 us.
 */
static void between_machines_all_comes_through_one_adapter(void **unused)
{
    (void)unused;
    check_relative(step_of(512e3, 512, 100e-9, 8),
                   (100.0 + 69.360586 + 34.2 + 14.843099) * 1e-6, 1e-6);
}

/** 512e3 grains on 512 ranks: shares of 1000, and 990.865512 ghosts. */
static void memory_is_by_the_table(void **unused)
{
    (void)unused;
    const clod_check_ranks_bed bed = {512e3, 512, 1.29};
    const double steps = 610.0 * 2.45 * 1990.865512;
    clod_check_ranks_start start = {0};
    clod_check_ranks_memory memory = clod_check_ranks_memory_of(&bed, &start);
    check_relative(memory.begin_0, 720e3, 1e-12);
    check_relative(memory.begin, 760e3, 1e-12);
    check_relative(memory.steps_0, steps, 1e-9);
    check_relative(memory.steps, steps, 1e-9);
    start = (clod_check_ranks_start){.whole = true, .gathered = true};
    memory = clod_check_ranks_memory_of(&bed, &start);
    check_relative(memory.begin_0, 560.0 * 512e3, 1e-12);
    check_relative(memory.begin, 1500e3, 1e-12);
    check_relative(memory.steps_0, 1250.0 * 512e3, 1e-12);
    check_relative(memory.steps, steps, 1e-9);
}

/** The table of docs/scaling.md, Making, and straight lines between and beyond its rows. */
static void making_is_by_the_table(void **unused)
{
    (void)unused;
    const double found[][2] = {{0.34, 1.1},  {0.60, 1.1},  {0.06, 2.1},  {0.15, 2.5},
                               {0.30, 11.6}, {0.105, 2.3}, {0.225, 7.05}};
    for (size_t k = 0; k < sizeof found / sizeof *found; k++) {
        const clod_check_ranks_start start = {.made = 1e6, .solid = found[k][0]};
        check_relative(clod_check_ranks_making(&start), found[k][1], 1e-12);
    }
}

/** 1e8 grains on 101 ranks: 42 GB at 0.3 GB/s, and 6104 slabs of ten numbers from 100 ranks. */
static void a_checkpoint_goes_through_rank_0(void **unused)
{
    (void)unused;
    const clod_check_ranks_bed bed = {1e8, 101, 1.29};
    check_relative(clod_check_ranks_writing(&bed, 42e9), 140.0 + 6104.0 * 1000.0 * 0.66e-6,
                   1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_rank_sees_1_29_layers_of_the_packing),
        cmocka_unit_test(ghosts_are_those_of_the_table),
        cmocka_unit_test(many_ranks_are_cubes_with_others_on_all_sides),
        cmocka_unit_test(no_rank_has_more_than_all),
        cmocka_unit_test(a_merge_has_rounds_within_a_machine_and_between),
        cmocka_unit_test(a_step_is_the_sum_of_its_parts),
        cmocka_unit_test(between_machines_all_comes_through_one_adapter),
        cmocka_unit_test(memory_is_by_the_table),
        cmocka_unit_test(making_is_by_the_table),
        cmocka_unit_test(a_checkpoint_goes_through_rank_0),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
