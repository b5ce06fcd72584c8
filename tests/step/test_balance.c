// Ranks have about the same work: a bed that becomes uneven is cut anew, with the same bits.
#include "step/balance.h"

#include "step/crew_part.h"

#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

#define SOME 100 ///< steps

typedef struct balanced_bed {
    clod_step_options options;
    scene *into;                     ///< of rank 0
    clod_ranks_evenness evenness;    ///< of its end
    double grains_begin, grains_end; ///< most grains of a rank over the mean
} balanced_bed;

/** Most grains of a rank over the mean, by the places at the last rebuild. */
static double most_grains(scene *s, int ranks)
{
    clod_status status = {0};
    int count[RANKS_MOST] = {0}, most = 0;
    assert_true(clod_step_see(&s->step, &status));
    for (size_t g = 0; g < s->state.grains.count; g++) {
        const int r =
            clod_partition_owner(&s->step.crew->spread.partition, s->state.build_position[g]);
        most = ++count[r] > most ? count[r] : most;
    }
    return (double)most * ranks / (double)s->state.grains.count;
}

// ---- cut anew at every step

/** A wall beside the bed is so fast that lists are made anew in every step. */
static void run_fast(scene *s, clod_step_options options)
{
    bed_init(s, BED_SLIT, 1);
    clod_wall *wall = scene_wall(
        s, "far", shape_plane((clod_vec3){0.0, 0.0, -1.0}, (clod_vec3){0.0, 0.0, 1.0}));
    wall->velocity.x = 1e4;
    scene_start_with(s, options);
    scene_run(s, SOME);
}

/** Now and then a rank seems to have worked for much longer. */
static void exchange_and_work(clod_ranks *ranks, const clod_message *out, int outs,
                              const clod_message *in, int ins)
{
    static dice roll[RANKS_MOST];
    ranks_exchange(ranks, out, outs, in, ins);
    roll[ranks->rank].state += (uint64_t)ranks->rank;
    ranks->count.spun -= dice_pick(&roll[ranks->rank], 20) == 0 ? 1e-2 : 0.0;
}

static void run_fast_rank(clod_ranks *ranks, void *context)
{
    balanced_bed *how = context;
    ranks->exchange = exchange_and_work;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    how->options.ranks = ranks;
    run_fast(how->into, how->options);
    assert_true(clod_step_export(&how->into->step, &(clod_status){0}));
    how->evenness = ranks->evenness;
    clod_crew_end(&how->into->step.crew);
    clod_crew_dismiss(ranks);
}

/** By time, which is another one each time: so the planes move in every step. */
static void a_bed_that_is_cut_anew_at_every_step_has_the_same_bits(void **state)
{
    (void)state;
    static const int RANKS[] = {2, 3, 4, 7, 16};
    scene one;
    run_fast(&one, (clod_step_options){.threads = 1});
    assert_true(one.step.rebuilds >= SOME);
    assert_true(clod_step_export(&one.step, &(clod_status){0}));
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        if (left_out(k, 3)) {
            continue;
        }
        scene several;
        balanced_bed how = {.options = {.threads = 1, .balance.threshold = 1.0},
                            .into = &several};
        ranks_run(RANKS[k], run_fast_rank, &how);
        assert_int_equal(several.step.rebuilds, one.step.rebuilds);
        assert_int_equal(how.evenness.cuts, how.evenness.looks);
        assert_true(how.evenness.cuts >= SOME - 1);
        assert_true(how.evenness.moved > 10 * SOME);
        check_same_bits(&one.state, &several.state);
        scene_end(&several);
    }
    scene_end(&one);
}

// ---- a bed that empties on one side

/** 4 x 6 x 6 grains at rest for x < 0, and as many that fly out through the side at x > 0. */
static void make_leaving(scene *s)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-5, &ore);
    s->state.domain.max[0] = 0.06;
    s->state.domain.removes = true;
    for (int k = 0; k < 8 * 6 * 6; k++) {
        const int at[3] = {k % 8, k / 8 % 6, k / 48};
        const double x = -0.04 + 0.01 * at[0] + 0.005;
        const size_t g = scene_grain(s, x, 0.01 * at[1], 0.01 * at[2], 2e-3);
        if (x > 0.0) {
            scene_move(s, g, 20.0, 0.0, 0.0);
        }
    }
}

static void run_leaving_rank(clod_ranks *ranks, void *context)
{
    balanced_bed *how = context;
    scene *s = how->into;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    how->options.ranks = ranks;
    make_leaving(s);
    scene_start_with(s, how->options);
    how->grains_begin = most_grains(s, ranks->size);
    scene_run(s, 600);
    assert_int_equal(s->state.exchange.left[CLOD_FACES - 1] + s->state.exchange.left[0] +
                         s->state.exchange.left[1],
                     4 * 6 * 6);
    how->grains_end = most_grains(s, ranks->size);
    how->evenness = ranks->evenness;
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

static balanced_bed leave(int ranks, double threshold)
{
    scene s;
    balanced_bed how = {
        .options = {.threads = 1, .balance = {.threshold = threshold, .by_counts = true}},
        .into = &s};
    ranks_run(ranks, run_leaving_rank, &how);
    scene_end(&s);
    return how;
}

static void a_bed_that_empties_on_one_side_is_shared_again(void **state)
{
    (void)state;
    for (int ranks = 2; ranks <= 4; ranks += 2) {
        const balanced_bed never = leave(ranks, 1e9), now = leave(ranks, 0.0);
        assert_true(never.grains_begin <= 1.1);
        assert_true(now.grains_begin <= 1.1);
        assert_true(never.grains_end >= 1.9); // half of the ranks have nothing
        assert_true(now.grains_end <= 1.1);
        assert_int_equal(never.evenness.cuts, 0);
        assert_true(now.evenness.cuts >= 1);
        assert_true(now.evenness.cuts < now.evenness.looks); // not when it is even
        assert_true(now.evenness.most > 1.1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bed_that_is_cut_anew_at_every_step_has_the_same_bits),
        cmocka_unit_test(a_bed_that_empties_on_one_side_is_shared_again),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
