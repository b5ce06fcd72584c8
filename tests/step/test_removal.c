// A wall that is taken away at one stroke while grains touch it, as the mould of a uniaxial
// test: its contacts are forgotten, and a run that is cut there goes on with the same bits.

#include "support/bed.h"
#include "support/bits.h"

#define STEPS 9500

/** A bed in a drum that has come down on its floor, the neighbour search made anew. */
static void settle(scene *s)
{
    bed_init(s, BED_DRUM, 4);
    scene_start(s);
    scene_run(s, 8000);
    s->state.build_motion = INFINITY;
    scene_run(s, 50);
}

static size_t contacts_with(scene *s, const char *name)
{
    clod_status status = {0};
    size_t count = 0;
    assert_true(clod_step_export(&s->step, &status));
    const size_t first = s->state.contact_count - s->state.wall_contact_count;
    for (size_t k = first; k < s->state.contact_count; k++) {
        const clod_wall *wall = &s->state.walls.wall[s->state.contacts[k].j];
        count += strcmp(wall->name, name) == 0;
    }
    return count;
}

static void take_away(scene *s)
{
    assert_true(contacts_with(s, "drum") > 5);
    clod_changes_remove_wall(&s->state.changes, "drum");
    assert_true(clod_step_change(&s->step, &s->step.status));
}

static void contacts_go_with_their_wall(void **state)
{
    (void)state;
    scene s;
    settle(&s);
    take_away(&s);
    assert_int_equal(s.state.walls.count, 2);
    assert_int_equal(contacts_with(&s, "drum"), 0);
    assert_true(contacts_with(&s, "base") > 5); // those of the others stay
    scene_run(&s, 50);
    assert_int_equal(s.state.exchange.walls_removed, 1);
    scene_end(&s);
}

/** Go on from a copy: a new state and a new step. */
static void replace(scene *s)
{
    clod_status status = {0};
    clod_state copy = {0};
    assert_true(clod_step_export(&s->step, &status));
    assert_true(clod_state_copy(&copy, &s->state, &status));
    scene_end(s);
    s->state = copy;
    scene_start(s);
}

static void finish(scene *s)
{
    clod_status status = {0};
    scene_run(s, STEPS - s->state.step);
    assert_true(clod_step_export(&s->step, &status));
}

/** Cut before, when and after the wall has gone. */
static void a_run_cut_there_goes_on_with_the_same_bits(void **state)
{
    (void)state;
    scene whole;
    settle(&whole);
    take_away(&whole);
    finish(&whole);
    for (int moment = 0; moment < 3; moment++) {
        scene cut;
        settle(&cut);
        if (moment == 0) {
            replace(&cut);
        }
        take_away(&cut);
        if (moment > 0) {
            scene_run(&cut, moment - 1);
            replace(&cut);
        }
        finish(&cut);
        check_same_bits(&whole.state, &cut.state);
        scene_end(&cut);
    }
    scene_end(&whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_go_with_their_wall),
        cmocka_unit_test(a_run_cut_there_goes_on_with_the_same_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
