// Interrupted = uninterrupted: a run that is exported, copied into a new state and taken up by
// a new step goes on with the same bits, wherever it is cut.

#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define STEPS 2400

/** Go on from a copy: a new state and a new step. */
static void replace(scene *s, clod_step_options options)
{
    clod_status status = {0};
    clod_state copy = {0};
    assert_true(clod_step_export(&s->step, &status));
    assert_true(clod_state_copy(&copy, &s->state, &status));
    check_same_bits(&copy, &s->state);
    scene_end(s);
    s->state = copy;
    scene_start_with(s, options);
}

static void run_whole(scene *s, bed_kind kind)
{
    clod_status status = {0};
    bed_init(s, kind, 2);
    scene_start(s);
    scene_open_ledger(s);
    scene_run(s, STEPS);
    assert_true(s->step.rebuilds > 8);
    assert_true(clod_step_export(&s->step, &status));
}

static void finish(scene *s)
{
    clod_status status = {0};
    scene_run(s, STEPS - s->state.step);
    assert_true(clod_step_export(&s->step, &status));
}

/** Cut at 40 random moments, each time into another number of threads and instruction set. */
static void a_run_cut_at_random_goes_on_with_the_same_bits(void **state)
{
    (void)state;
    const char *const sets[] = {"scalar", "avx2", "avx512", "neon"};
    dice roll = {5};
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene whole, cut;
        run_whole(&whole, (bed_kind)kind);
        bed_init(&cut, (bed_kind)kind, 2);
        scene_start(&cut);
        scene_open_ledger(&cut);
        for (int k = 0; k < 40; k++) {
            scene_run(&cut, 1 + dice_pick(&roll, STEPS / 40 - 1));
            const char *set = sets[dice_pick(&roll, 4)];
            replace(&cut,
                    (clod_step_options){.threads = 1 + dice_pick(&roll, 2),
                                        .simd = clod_kernel_choose(set) != NULL ? set : NULL,
                                        .brute_force = dice_pick(&roll, 2) == 0});
        }
        finish(&cut);
        check_same_bits(&whole.state, &cut.state);
        scene_end(&whole);
        scene_end(&cut);
    }
}

/** Cut just before, in and after steps that rebuild. */
static void a_run_cut_around_rebuilds_goes_on_with_the_same_bits(void **state)
{
    (void)state;
    const clod_step_options one = {.threads = 1};
    const int apart = sanitized() ? 3 : 1; // the other beds are cut at random
    for (int kind = 0; kind < BED_KINDS; kind += apart) {
        scene whole, cut;
        int64_t moment[64];
        int rebuilds = 0;
        bed_init(&whole, (bed_kind)kind, 2);
        scene_start(&whole);
        scene_open_ledger(&whole);
        while (whole.state.step < STEPS) {
            const int64_t before = whole.step.rebuilds;
            scene_run(&whole, 1);
            if (whole.step.rebuilds > before) {
                moment[rebuilds++] = whole.state.step;
            }
        }
        assert_true(clod_step_export(&whole.step, &whole.step.status));
        for (int shift = -2; shift <= 1; shift += sanitized() ? 3 : 1) {
            bed_init(&cut, (bed_kind)kind, 2);
            scene_start(&cut);
            scene_open_ledger(&cut);
            for (int k = 0; k < rebuilds; k++) {
                scene_run(&cut, moment[k] + shift - cut.state.step);
                replace(&cut, one);
            }
            finish(&cut);
            check_same_bits(&whole.state, &cut.state);
            scene_end(&cut);
        }
        scene_end(&whole);
    }
}

/** A copy of a fresh state is as fresh. */
static void a_fresh_copy_starts_the_same(void **state)
{
    (void)state;
    scene whole, cut;
    run_whole(&whole, BED_DRUM);
    bed_init(&cut, BED_DRUM, 2);
    clod_status status = {0};
    clod_state copy = {0};
    assert_true(clod_state_copy(&copy, &cut.state, &status));
    clod_state_fini(&cut.state);
    cut.state = copy;
    scene_start(&cut);
    scene_open_ledger(&cut);
    replace(&cut, (clod_step_options){.threads = 1}); // and once more before the first step
    finish(&cut);
    check_same_bits(&whole.state, &cut.state);
    scene_end(&whole);
    scene_end(&cut);
}

/** k_adh changes between stages; the history stays with the contacts. */
static void adhesion_may_change_where_the_run_is_cut(void **state)
{
    (void)state;
    scene s[2];
    for (int k = 0; k < 2; k++) {
        bed_init(&s[k], BED_SLIT, 2);
        clod_laws_set_adhesion(&s[k].laws, 0.1);
        scene_start(&s[k]);
        scene_open_ledger(&s[k]);
        scene_run(&s[k], 1200);
        if (k == 1) {
            replace(&s[k], (clod_step_options){.threads = 1});
        }
        clod_laws_set_adhesion(&s[k].laws, 1.0);
        finish(&s[k]);
    }
    check_same_bits(&s[0].state, &s[1].state);
    scene_end(&s[0]);
    scene_end(&s[1]);
}

/** Contacts that cannot belong to the positions are found out, not guessed. */
static void a_state_that_does_not_hold_together_is_refused(void **state)
{
    (void)state;
    scene s;
    clod_status status = {0};
    bed_init(&s, BED_SLIT, 2);
    scene_start(&s);
    scene_open_ledger(&s);
    scene_run(&s, 1000);
    assert_true(clod_step_export(&s.step, &status));
    s.state.contacts[0].j = (int32_t)s.state.grains.count - 1; // far away in the order
    const unsigned long long grain = s.state.grains.id[s.state.contacts[0].i];
    clod_step_fini(&s.step);
    const clod_step_options one = {.threads = 1};
    assert_false(clod_step_init(&s.step, &s.state, &s.laws, &one, &status));
    assert_int_equal(status.code, CLOD_FAILED);
    char text[512];
    snprintf(
        text, sizeof text,
        "step 1000: grain %llu is far away from a grain or wall that it touched one step "
        "before; the time step (1e-06 s) is most likely too large, see clod check; or the "
        "grain crossed a periodic side within its radius of where a wall ends: walls do not "
        "repeat, so let them end farther from the side, or go on beyond both sides",
        grain);
    assert_string_equal(status.text, text);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_run_cut_at_random_goes_on_with_the_same_bits),
        cmocka_unit_test(a_run_cut_around_rebuilds_goes_on_with_the_same_bits),
        cmocka_unit_test(a_fresh_copy_starts_the_same),
        cmocka_unit_test(adhesion_may_change_where_the_run_is_cut),
        cmocka_unit_test(a_state_that_does_not_hold_together_is_refused),
    };
    if (looks_for_races()) {
        cmocka_set_test_filter("a_run_cut_at_random*"); // others have one thread
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
