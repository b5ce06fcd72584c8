// A contact is known by its grains' ids, or by a grain and a surface of a wall: its history can
// be asked for at any time, in either order, and what is exported is exactly that.
#include "support/bed.h"
#include "support/bits.h"

#define STEPS 3000

/** A contact asked for by the ids of its grains has the history of the exported one. */
static void check_pair(const scene *s, const clod_contact *there)
{
    const uint64_t *id = s->state.grains.id;
    clod_contact asked, turned;
    assert_true(
        clod_step_contact_of(&s->step, (uint64_t[2]){id[there->i], id[there->j]}, &asked));
    assert_true(asked.i == there->i && asked.j == there->j && asked.shape == -1);
    assert_memory_equal(asked.history, there->history, sizeof asked.history);
    assert_true(
        clod_step_contact_of(&s->step, (uint64_t[2]){id[there->j], id[there->i]}, &turned));
    assert_true(turned.i == there->j && turned.j == there->i);
    assert_true(turned.history[0] == there->history[0]); // P
    assert_true(turned.history[1] == there->history[1]); // dk
    for (int k = 2; k < 8; k++) {                        // both springs
        assert_true(turned.history[k] == -there->history[k]);
    }
}

static void check_wall(const scene *s, const clod_contact *there)
{
    clod_contact asked;
    assert_true(clod_step_wall_contact_of(&s->step, s->state.grains.id[there->i], there->j,
                                          there->shape, &asked));
    assert_true(asked.i == there->i && asked.j == there->j && asked.shape == there->shape);
    assert_memory_equal(asked.history, there->history, sizeof asked.history);
}

/** Contacts that the brute force finds: every pair of grains is asked for. */
static size_t ask_for_all(const scene *s)
{
    size_t found = 0;
    clod_contact ignored;
    for (uint64_t a = 0; a < s->state.grains.count; a++) {
        for (uint64_t b = a + 1; b < s->state.grains.count; b++) {
            found += clod_step_contact_of(&s->step, (uint64_t[2]){a, b}, &ignored);
        }
    }
    return found;
}

/** Rows from other ranks may be in order, and their contacts in that of the rebuild before. */
static void contacts_of_sorted_rows_are_turned(void **state)
{
    (void)state;
    scene s, turned;
    clod_status status = {0};
    bed_init(&s, BED_CLUSTER, 7);
    scene_start(&s);
    scene_run(&s, STEPS);
    assert_true(clod_step_export(&s.step, &status));
    turned = s;
    assert_true(clod_state_copy(&turned.state, &s.state, &status));
    for (size_t k = 0; k < turned.state.contact_count; k += 2) {
        if (turned.state.contacts[k].shape < 0) {
            clod_contact_turn(&turned.state.contacts[k]);
        }
    }
    assert_true(clod_neighbour_sort_as_built(&s.step.neighbour, &turned.state, &status));
    check_same_bits(&s.state, &turned.state);
    clod_state_fini(&turned.state);
    scene_end(&s);
}

static void every_contact_is_found_by_its_identity(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        for (int threads = 1; threads <= 4; threads += 3) {
            scene s;
            bed_init(&s, (bed_kind)kind, 7);
            scene_start_with(&s, (clod_step_options){.threads = threads});
            scene_run(&s, STEPS);
            assert_true(clod_step_export(&s.step, &s.step.status));
            const size_t pairs = s.state.contact_count - s.state.wall_contact_count;
            assert_true(pairs > 50);
            for (size_t k = 0; k < s.state.contact_count; k++) {
                const clod_contact *there = &s.state.contacts[k];
                assert_true(k == 0 || k == pairs || clod_contact_compare(there - 1, there) < 0);
                if (k < pairs) {
                    check_pair(&s, there);
                } else {
                    check_wall(&s, there);
                }
            }
            assert_int_equal(ask_for_all(&s), pairs);
            scene_end(&s);
        }
    }
}

static void what_is_not_there_is_not_found(void **state)
{
    (void)state;
    scene s;
    bed_init(&s, BED_DRUM, 3);
    scene_start(&s);
    scene_run(&s, 100);
    const uint64_t none = s.state.grains.count;
    clod_contact c;
    assert_false(clod_step_contact_of(&s.step, (uint64_t[2]){0, 0}, &c));
    assert_false(clod_step_contact_of(&s.step, (uint64_t[2]){0, none}, &c));
    assert_false(clod_step_contact_of(&s.step, (uint64_t[2]){none, 0}, &c));
    assert_false(clod_step_wall_contact_of(&s.step, none, 0, 0, &c));
    assert_false(clod_step_wall_contact_of(&s.step, 0, -1, 0, &c));
    assert_false(clod_step_wall_contact_of(&s.step, 0, s.state.walls.count, 0, &c));
    assert_false(clod_step_wall_contact_of(&s.step, 0, 0, 99, &c));
    scene_end(&s);
}

/** To look changes nothing: a run that is exported at odd moments has the bits of one that is
 *  not, and as many lists. */
static void an_export_leaves_everything_as_it_is(void **state)
{
    (void)state;
    scene looked, plain;
    bed_init(&looked, BED_HOPPER, 5);
    bed_init(&plain, BED_HOPPER, 5);
    scene_start(&looked);
    scene_start(&plain);
    for (int k = 1; k < 60; k++) {
        scene_run(&looked, k);
        assert_true(clod_step_export(&looked.step, &looked.step.status));
        scene_run(&plain, k);
    }
    assert_int_equal(looked.step.refreshes, plain.step.refreshes);
    assert_int_equal(looked.step.rebuilds, plain.step.rebuilds);
    assert_true(clod_step_export(&plain.step, &plain.step.status));
    check_same_bits(&looked.state, &plain.state);
    scene_end(&looked);
    scene_end(&plain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contacts_of_sorted_rows_are_turned),
        cmocka_unit_test(every_contact_is_found_by_its_identity),
        cmocka_unit_test(what_is_not_there_is_not_found),
        cmocka_unit_test(an_export_leaves_everything_as_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
