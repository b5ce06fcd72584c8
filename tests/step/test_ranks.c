// A bed spread over ranks has the bits of one process, whatever their number.
#include "step/crew.h"

#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"

#define STEPS 1500

/** A bed, stepped by rank 0 and those that serve it. */
typedef struct rank_bed {
    bed_kind kind;
    bool ledger;
    clod_step_options options;
    scene *into; ///< of rank 0
} rank_bed;

static void run_bed(scene *s, const rank_bed *how)
{
    clod_status status = {0};
    bed_init(s, how->kind, 1);
    scene_start_with(s, how->options);
    if (how->ledger) {
        scene_open_ledger(s);
    }
    for (int k = 0; k < 5; k++) { // looks do not matter
        scene_run(s, STEPS / 5);
        if (k % 2 == 0 && !clod_step_see(&s->step, &status)) {
            fail_msg("%s", status.text);
        }
    }
    if (!clod_step_export(&s->step, &status)) {
        fail_msg("%s", status.text);
    }
}

static void run_rank(clod_ranks *ranks, void *context)
{
    rank_bed how = *(const rank_bed *)context;
    if (ranks->rank == 0) {
        how.options.ranks = ranks;
        run_bed(how.into, &how);
        clod_crew_end(&how.into->step.crew);
        clod_crew_dismiss(ranks);
    } else {
        clod_crew_serve(ranks);
    }
}

static void compare(bed_kind kind, bool ledger, int threads)
{
    static const int RANKS[] = {2, 3, 4, 7};
    rank_bed how = {.kind = kind, .ledger = ledger, .options = {.threads = 1}};
    scene one;
    run_bed(&one, &how);
    how.options.threads = threads;
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        scene several;
        how.into = &several;
        ranks_run(RANKS[k], run_rank, &how);
        assert_true(several.step.rebuilds >= 2);
        assert_int_equal(several.step.rebuilds, one.step.rebuilds);
        check_same_bits(&one.state, &several.state);
        scene_end(&several);
    }
    scene_end(&one);
}

static void a_drum_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare(BED_DRUM, false, 1);
}

static void a_periodic_slit_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare(BED_SLIT, false, 1);
}

static void a_cluster_without_walls_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare(BED_CLUSTER, false, 1);
}

static void a_hopper_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare(BED_HOPPER, false, 1);
}

static void the_ledger_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare(BED_DRUM, true, 1);
    compare(BED_CLUSTER, true, 1);
}

static void ranks_with_threads_have_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare(BED_SLIT, true, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drum_has_the_bits_of_one_rank),
        cmocka_unit_test(a_periodic_slit_has_the_bits_of_one_rank),
        cmocka_unit_test(a_cluster_without_walls_has_the_bits_of_one_rank),
        cmocka_unit_test(a_hopper_has_the_bits_of_one_rank),
        cmocka_unit_test(the_ledger_has_the_bits_of_one_rank),
        cmocka_unit_test(ranks_with_threads_have_the_bits_of_one_rank),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
