// Grains and walls come and go at one point: what stays keeps its bits, its contacts and their
// history; every grain and joule is accounted for; and nothing depends on the order of
// requests, on threads or on a cut.
#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define STEPS (sanitized() ? 2400 : 6000)

static clod_new_grain new_grain(uint64_t id, double x, double y, double z, double radius)
{
    return (clod_new_grain){
        .id = id, .position = {x, y, z, radius}, .density = ORE.density, .material = 0};
}

static void change(scene *s)
{
    clod_status status = {0};
    if (!clod_step_change(&s->step, &status)) {
        fail_msg("%s", status.text);
    }
}

#define PITCH 4.05e-3 ///< m
#define FIRST 2.05e-3 ///< m, height of the lowest layer

/** A cubic lattice of n^3 grains that falls on a floor, but for two that are left out. */
static void lattice(scene *s, int n, int first_left_out, int second_left_out)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-6, &ore);
    s->state.gravity[2] = -9.81;
    for (int k = 0; k < n * n * n; k++) {
        const int column = k % n, line = k / n % n, layer = k / n / n;
        const double x = PITCH * column, y = PITCH * line, z = PITCH * layer;
        if (k != first_left_out && k != second_left_out) {
            const size_t g = scene_grain(s, x, y, FIRST + z, 2e-3);
            s->state.grains.id[g] = (uint64_t)k;
            scene_move(s, g, 0.0, 0.0, -1.0);
        }
    }
    scene_wall(s, "floor", shape_floor(0.0));
}

static void finish(scene *s, int64_t steps)
{
    scene_run(s, steps);
    assert_true(clod_step_export(&s->step, &s->step.status));
}

/** A state to which grains were added, or from which they were removed, before its first step
 *  is the state that was made so. */
static void added_and_removed_is_as_if_made_so(void **state)
{
    (void)state;
    scene made, added, removed;
    lattice(&made, 5, -1, -1);
    scene_start(&made);
    finish(&made, STEPS);
    assert_true(made.state.contact_count > 20);

    lattice(&added, 5, 17, 60);
    scene_start_with(&added, (clod_step_options){.threads = 2});
    clod_new_grain grain = new_grain(60, 0.0, PITCH * 2, FIRST + PITCH * 2, 2e-3);
    grain.velocity[2] = -1.0;
    clod_changes_add_grain(&added.state.changes, &grain);
    grain = new_grain(17, PITCH * 2, PITCH * 3, FIRST, 2e-3);
    grain.velocity[2] = -1.0;
    clod_changes_add_grain(&added.state.changes, &grain);
    change(&added);
    finish(&added, STEPS);
    check_same_bits(&made.state, &added.state);
    assert_int_equal(added.state.exchange.added, 2);
    check_relative(added.state.exchange.added_mass, 2.0 * made.state.grains.velocity[0][3],
                   1e-15);

    lattice(&removed, 5, -1, -1);
    for (uint64_t k = 0; k < 3; k++) { // between the others
        const size_t g = scene_grain(&removed, PITCH * (0.5 + (double)k), 0.5 * PITCH,
                                     FIRST + 0.5 * PITCH, 1e-4);
        removed.state.grains.id[g] = 1000 + k;
    }
    scene_start(&removed);
    for (uint64_t k = 3; k-- > 0;) {
        clod_changes_remove_grain(&removed.state.changes, 1000 + k);
    }
    finish(&removed, STEPS); // an advance makes the changes by itself
    check_same_bits(&made.state, &removed.state);
    assert_int_equal(removed.state.exchange.removed, 3);
    scene_end(&made);
    scene_end(&added);
    scene_end(&removed);
}

/** Ids of the grains that go from the beds, and a place where others come. */
static const uint64_t LOST[] = {5, 40, 17, 63, 2};
#define LOST_COUNT (sizeof LOST / sizeof *LOST)

static size_t row_of(const scene *s, uint64_t id)
{
    size_t g = 0;
    while (s->state.grains.id[g] != id) {
        g++;
    }
    return g;
}

/** Some grains go, and in the place of some of them smaller ones come. */
static void ask(scene *s, bool backwards)
{
    for (size_t n = 0; n < LOST_COUNT; n++) {
        const size_t k = backwards ? LOST_COUNT - 1 - n : n;
        clod_changes_remove_grain(&s->state.changes, LOST[k]);
        const double *at = s->state.grains.position[row_of(s, LOST[k])];
        const clod_new_grain grain = new_grain(5000 + k, at[0], at[1], at[2], 1e-3);
        if (k > 1) {
            clod_changes_add_grain(&s->state.changes, &grain);
        }
    }
}

/** Go on from a copy of the state, with another number of threads. */
static void replace(scene *s, int threads)
{
    clod_state copy = {0};
    assert_true(clod_step_export(&s->step, &s->step.status));
    assert_true(clod_state_copy(&copy, &s->state, &s->step.status));
    scene_end(s);
    s->state = copy;
    scene_start_with(s, (clod_step_options){.threads = threads});
}

static void order_threads_and_cuts_change_no_bit(void **state)
{
    (void)state;
    const int64_t steps = 1500; // contacts with walls need them
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene whole;
        bed_init(&whole, (bed_kind)kind, 9);
        scene_start(&whole);
        scene_run(&whole, steps);
        ask(&whole, false);
        finish(&whole, steps);
        for (int threads = looks_for_races() ? 3 : 1; threads <= (looks_for_races() ? 3 : 5);
             threads += 2) {
            scene cut;
            bed_init(&cut, (bed_kind)kind, 9);
            scene_start_with(&cut, (clod_step_options){.threads = threads});
            scene_run(&cut, steps);
            ask(&cut, true);
            change(&cut);
            replace(&cut, 6 - threads);
            scene_run(&cut, steps / 3);
            replace(&cut, threads);
            finish(&cut, steps - steps / 3);
            check_same_bits(&whole.state, &cut.state);
            scene_end(&cut);
        }
        scene_end(&whole);
    }
}

/** Contacts of the grains that stay, before and after. */
static void others_keep_their_history(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene s;
        bed_init(&s, (bed_kind)kind, 3);
        scene_start_with(&s, (clod_step_options){.threads = 3});
        scene_run(&s, STEPS);
        clod_state before = {0};
        assert_true(clod_step_export(&s.step, &s.step.status));
        assert_true(clod_state_copy(&before, &s.state, &s.step.status));
        ask(&s, false);
        change(&s);
        size_t kept = 0, gone = 0;
        for (size_t k = 0; k < before.contact_count - before.wall_contact_count; k++) {
            const clod_contact *then = &before.contacts[k];
            const uint64_t id[2] = {before.grains.id[then->i], before.grains.id[then->j]};
            bool stays = true;
            for (size_t l = 0; l < LOST_COUNT; l++) {
                stays = stays && id[0] != LOST[l] && id[1] != LOST[l];
            }
            clod_contact now;
            assert_int_equal(clod_step_contact_of(&s.step, id, &now), stays);
            if (stays) {
                assert_memory_equal(now.history, then->history, sizeof now.history);
            }
            kept += stays;
            gone += !stays;
        }
        assert_true(kept > 50 && gone > 2);
        assert_true(clod_step_export(&s.step, &s.step.status));
        assert_int_equal(s.state.contact_count - s.state.wall_contact_count, kept);
        clod_state_fini(&before);
        scene_end(&s);
    }
}

/** The books close over changes as they do without (tests/step/test_ledger.c). */
static void the_ledger_closes(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene s;
        bed_init(&s, (bed_kind)kind, 2);
        scene_start(&s);
        scene_open_ledger(&s);
        scene_run(&s, 10000);
        const clod_energies then = clod_step_energies(&s.step);
        const double before = clod_ledger_residual(&s.state.ledger, &then);
        ask(&s, false);
        change(&s);
        clod_energies now = clod_step_energies(&s.step);
        // the change itself: to rounding
        check_close(clod_ledger_residual(&s.state.ledger, &now), before,
                    1e-13 * clod_energies_sum(&then));
        assert_true(fabs(s.state.ledger.exchanged) > 1e-6);
        scene_run(&s, 10000);
        now = clod_step_energies(&s.step);
        const clod_ledger *l = &s.state.ledger;
        const double lost = l->plastic + l->dash_pot + l->friction + l->rolling;
        check_at_most(fabs(clod_ledger_residual(l, &now)), 5e-3 * lost);
        scene_end(&s);
    }
}

/** A plane through the origin for the queue, its normal leaning over by an angle. */
static void add_plane(scene *s, const char *name, double lean)
{
    const clod_vec3 normal = {sin(lean), 0.1 * lean, cos(lean)};
    clod_wall wall = {.shape_count = 1, .spin_axis = {0.0, 0.0, 1.0}};
    snprintf(wall.name, sizeof wall.name, "%s", name);
    wall.shapes = clod_memory_alloc(1, sizeof *wall.shapes);
    wall.shapes[0] = shape_plane((clod_vec3){0.0, 0.0, 0.0}, clod_vec3_unit(normal));
    clod_changes_add_wall(&s->state.changes, &wall);
}

/** One grain on three walls, and three grains of different mass: asked for in both orders. */
static void the_order_of_what_comes_changes_no_bit(void **state)
{
    (void)state;
    static const char *const NAMES[] = {"a", "b", "c"};
    scene s[2];
    for (int k = 0; k < 2; k++) {
        const clod_case_contact ore = contact_ore();
        scene_init(&s[k], 1e-6, &ore);
        scene_grain(&s[k], 0.0, 0.0, 1.99e-3, 2e-3);
        scene_start(&s[k]);
        for (int n = 0; n < 3; n++) {
            const int w = k == 0 ? n : 2 - n;
            const clod_new_grain grain =
                new_grain(100 + (uint64_t)w, 0.01 * (w + 1), 0.0, 0.02, 1e-3 + 1e-4 * w);
            clod_changes_add_grain(&s[k].state.changes, &grain);
            add_plane(&s[k], NAMES[w], 0.1 * (w - 1) + 0.02);
        }
        change(&s[k]);
        finish(&s[k], 20);
    }
    assert_true(s[0].state.wall_contact_count == 3);
    check_same_bits(&s[0].state, &s[1].state);
    assert_memory_equal(&s[0].state.exchange, &s[1].state.exchange, sizeof s[0].state.exchange);
    scene_end(&s[0]);
    scene_end(&s[1]);
}

static void a_wall_that_is_added_is_as_one_that_stood(void **state)
{
    (void)state;
    scene stood, added;
    lattice(&stood, 4, -1, -1);
    lattice(&added, 4, -1, -1);
    clod_memory_free(added.state.walls.wall[0].shapes);
    added.state.walls.count = 0;
    scene_start(&stood);
    scene_start(&added);
    clod_wall floor = stood.state.walls.wall[0];
    floor.shapes = clod_memory_alloc(1, sizeof *floor.shapes);
    floor.shapes[0] = stood.state.walls.wall[0].shapes[0];
    clod_changes_add_wall(&added.state.changes, &floor);
    assert_null(floor.shapes); // taken over
    change(&added);
    finish(&stood, STEPS);
    finish(&added, STEPS);
    assert_true(stood.state.wall_contact_count > 5);
    check_same_bits(&stood.state, &added.state);
    scene_end(&stood);
    scene_end(&added);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(added_and_removed_is_as_if_made_so),
        cmocka_unit_test(order_threads_and_cuts_change_no_bit),
        cmocka_unit_test(others_keep_their_history),
        cmocka_unit_test(the_ledger_closes),
        cmocka_unit_test(a_wall_that_is_added_is_as_one_that_stood),
        cmocka_unit_test(the_order_of_what_comes_changes_no_bit),
    };
    if (sanitized()) {
        cmocka_set_skip_filter(
            "the_ledger_closes"); // its sums; the same code runs in the others
    }
    if (looks_for_races()) {
        cmocka_set_test_filter("order_*"); // the others' threads do the same
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
