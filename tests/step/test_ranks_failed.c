// Runs that break down: the state they leave is that of the step, the same from several ranks.
#include <stdio.h>
#include <string.h>

#include "state/wear.h"
#include "step/crew_part.h"

#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"

// steps of time: contacts are lost within ranks; between them too
#define NEAR 4e-4 ///< s
#define FAR 1e-2  ///< s

/** A bed that one too long step tears apart, in a rebuild that puts its rows into a new order. */
static void tear(scene *s, double dt, clod_step_options options)
{
    clod_status status = {0};
    bed_init(s, BED_CLUSTER, 1);
    scene_start_with(s, options);
    scene_run(s, 1000);
    s->state.dt = dt;
    assert_false(clod_step_advance(&s->step, 10, &status));
    assert_non_null(strstr(status.text, "is far away from a grain or wall that it touched"));
    assert_true(clod_step_export(&s->step, &status));
}

static void check_places(const clod_state *state)
{
    assert_true(state->grains.count > 300);
    for (size_t g = 0; g < state->grains.count; g++) {
        assert_memory_equal(state->build_position[g], state->grains.position[g],
                            sizeof *state->build_position);
    }
}

static void places_at_the_rebuild_are_in_the_order_of_grains(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 2; threads++) {
        scene s;
        tear(&s, FAR, (clod_step_options){.threads = threads});
        check_places(&s.state);
        assert_false(s.step.neighbour.now);
        scene_end(&s);
    }
}

typedef struct separated_bed {
    double dt;
    scene *into;
} separated_bed;

static void tear_rank(clod_ranks *ranks, void *context)
{
    const separated_bed *how = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    tear(how->into, how->dt, (clod_step_options){.threads = 1, .ranks = ranks});
    clod_crew_end(&how->into->step.crew);
    clod_crew_dismiss(ranks);
}

/** Contacts that are separated over ranks are no more; all else is the same. */
static void ranks_leave_what_one_leaves(void **state)
{
    (void)state;
    for (int far = 0; far < 2; far++) {
        scene one, several;
        separated_bed how = {far ? FAR : NEAR, &several};
        tear(&one, how.dt, (clod_step_options){.threads = 1});
        ranks_run(2, tear_rank, &how);
        check_places(&several.state);
        assert_true(bits_same_grains(&one.state.grains, &several.state.grains));
        if (far) {
            assert_true(several.state.contact_count < one.state.contact_count);
        } else {
            check_same_bits(&one.state, &several.state);
        }
        scene_end(&several);
        scene_end(&one);
    }
}

typedef struct deep_bed {
    scene *into;
    int64_t cut; ///< steps of a call
    clod_status status;
} deep_bed;

/** A bed with an overlap beyond a low limit, some time after its start. */
static void press(deep_bed *how, clod_step_options options)
{
    scene *s = how->into;
    options.overlap_limit = 8e-3;
    bed_init(s, BED_CLUSTER, 1);
    scene_start_with(s, options);
    while (clod_step_advance(&s->step, how->cut, &how->status)) {
        assert_true(s->state.step < 20000);
    }
    assert_true(clod_step_export(&s->step, &(clod_status){0}));
}

static void press_rank(clod_ranks *ranks, void *context)
{
    deep_bed *how = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    const int threads = ranks->size == 3 ? 2 : 1;
    press(how, (clod_step_options){.threads = threads, .ranks = ranks});
    clod_crew_end(&how->into->step.crew);
    clod_crew_dismiss(ranks);
}

/** It is told as it was in its step; all stop one step later, when all know: in a call of its own, in
 *  the next step of a call, or in the last one of a call. */
static void an_overlap_on_one_rank_stops_all_in_one_step(void **state)
{
    (void)state;
    scene one, other;
    deep_bed expected = {.into = &one, .cut = 20000};
    press(&expected, (clod_step_options){.threads = 1});
    char begins[40];
    snprintf(begins, sizeof begins, "step %d: grain ", (int)one.state.step - 1);
    assert_true(one.state.step > 100 && one.state.step < 20000);
    assert_true(strncmp(expected.status.text, begins, strlen(begins)) == 0);
    const int64_t cuts[] = {20000, 1, one.state.step - 1, one.state.step};
    for (int k = 0; k < 4 * 4; k++) {
        const int ranks = 1 + 2 * (k / 4);
        deep_bed found = {.into = &other, .cut = cuts[k % 4]};
        if (ranks == 1) {
            press(&found, (clod_step_options){.threads = 3});
        } else {
            ranks_run(ranks, press_rank, &found);
        }
        assert_string_equal(found.status.text, expected.status.text);
        assert_int_equal(other.state.step, one.state.step);
        check_same_bits(&one.state, &other.state);
        scene_end(&other);
    }
    scene_end(&one);
}

static void lose_wear(clod_ranks *ranks, void *context)
{
    scene *s = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    bed_init(s, BED_DRUM, 1);
    for (int32_t w = 0; w < s->state.walls.count; w++) {
        assert_true(clod_wear_begin(&s->state.walls.wall[w]));
    }
    scene_start_with(s, (clod_step_options){.threads = 1, .ranks = ranks});
    scene_run(s, 10);
    s->step.crew->spread.wear_lost = true; // as without memory
    for (int k = 0; k < 2; k++) {          // and for good
        clod_status status = {0};
        assert_false(clod_step_advance(&s->step, 10, &status));
        assert_int_equal(status.code, CLOD_FAILED);
        assert_string_equal(status.text, "no memory for the sums of surfaces");
    }
    assert_int_equal(s->state.step, 20);
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

static void a_lack_of_memory_for_surfaces_is_told(void **state)
{
    (void)state;
    scene s;
    ranks_run(2, lose_wear, &s);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_at_the_rebuild_are_in_the_order_of_grains),
        cmocka_unit_test(ranks_leave_what_one_leaves),
        cmocka_unit_test(an_overlap_on_one_rank_stops_all_in_one_step),
        cmocka_unit_test(a_lack_of_memory_for_surfaces_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
