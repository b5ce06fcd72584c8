// Grains that cross an open side of a domain that removes them are counted by side, to the last
// grain and joule; and requests that are wrong change nothing.
#include <stdint.h>

#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

/** One grain at rest, 0.4 m high, above an open side at 0.1 m, with the ledger open; its mass. */
static double let_one_fall(scene *s)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-5, &ore);
    s->state.gravity[2] = -9.81;
    scene_grain(s, 0.0, 0.0, 0.4, 1e-3);
    s->state.domain.removes = true;
    s->state.domain.min[2] = 0.1;
    scene_start(s);
    scene_open_ledger(s);
    return s->state.grains.velocity[0][3];
}

/** One grain in free fall from rest takes away what it had: m g z, whenever it is noticed. */
static void a_falling_grain_takes_its_energy_away(void **state)
{
    (void)state;
    scene s;
    const double mass = let_one_fall(&s);
    scene_run(&s, 30000); // it crosses after sqrt(2 0.3/9.81) = 0.2473 s
    assert_int_equal(s.state.grains.count, 0);
    assert_int_equal(s.state.exchange.left[4], 1);
    check_relative(s.state.exchange.left_mass[4], mass, 1e-15);
    check_relative(s.state.ledger.exchanged, -mass * 9.81 * 0.4, 1e-12);
    // 0.3 m and at most what it falls until it is noticed: 0.15 of its radius and a step
    const double energy = s.state.exchange.left_energy[4];
    assert_true(energy > mass * 9.81 * 0.3 && energy < mass * 9.81 * 0.3003);
    const clod_energies now = clod_step_energies(&s.step);
    check_close(clod_ledger_residual(&s.state.ledger, &now), 0.0, 1e-12 * mass);
    scene_end(&s);
}

/** Without grains a moving wall asks for no lists: before, each step made them anew. */
static void nothing_is_made_for_an_empty_bed(void **state)
{
    (void)state;
    const clod_case_contact ore = contact_ore();
    scene s;
    scene_init(&s, 1e-5, &ore);
    s.state.gravity[2] = -9.81;
    scene_grain(&s, 0.0, 0.0, 0.1, 1e-3);
    scene_wall(&s, "floor", shape_floor(-10.0))->velocity = (clod_vec3){0.0, 0.0, -0.1};
    scene_start(&s);
    clod_changes_remove_grain(&s.state.changes, s.state.grains.id[0]);
    scene_run(&s, 1);
    assert_int_equal(s.state.grains.count, 0);
    const int64_t rebuilds = s.step.rebuilds, refreshes = s.step.refreshes;
    scene_run(&s, 100);
    assert_int_equal(s.step.rebuilds, rebuilds);
    assert_int_equal(s.step.refreshes, refreshes);
    const clod_new_grain comes = {
        .id = 7, .position = {0.0, 0.0, 0.3, 1e-3}, .density = 2000.0, .material = 0};
    clod_changes_add_grain(&s.state.changes, &comes);
    scene_run(&s, 1000); // 10 ms of free fall from rest
    check_relative(s.state.grains.position[0][2], 0.3 - 0.5 * 9.81 * 1e-4, 1e-9);
    scene_end(&s);
}

/** A grain that is beyond an open side already when others are asked for leaves then. */
static void a_change_lets_go_what_is_beyond_a_side(void **state)
{
    (void)state;
    const clod_new_grain comes = {
        .id = 7, .position = {0.01, 0.0, 0.3, 1e-3}, .density = 2000.0, .material = 0};
    scene s;
    const double mass = let_one_fall(&s);
    while (s.state.grains.position[0][2] >= 0.1) {
        scene_run(&s, 1);
    }
    assert_int_equal(s.state.grains.count, 1); // beyond, and not noticed yet
    const double fallen = 0.4 - s.state.grains.position[0][2];
    clod_changes_add_grain(&s.state.changes, &comes);
    assert_true(clod_step_change(&s.step, &s.step.status));
    assert_int_equal(s.state.grains.count, 1);
    assert_int_equal(s.state.grains.id[0], 7);
    assert_int_equal(s.state.exchange.left[4], 1);
    check_relative(s.state.exchange.left_energy[4], mass * 9.81 * fallen, 1e-10);
    const clod_energies now = clod_step_energies(&s.step);
    check_close(clod_ledger_residual(&s.state.ledger, &now), 0.0, 1e-12 * mass);
    scene_end(&s);
}

/** A bed that bursts apart in an open domain, until nobody is left. */
static void burst_with(scene *s, int threads)
{
    bed_init(s, BED_CLUSTER, 6);
    for (int a = 0; a < 3; a++) {
        s->state.domain.periodic[a] = a == 1;
        s->state.domain.min[a] = a == 1 ? -0.02 : -0.03;
        s->state.domain.max[a] = a == 1 ? 0.025 : 0.07;
    }
    s->state.domain.removes = true;
    scene_start_with(s, (clod_step_options){.threads = threads});
}

static void every_grain_is_counted_once(void **state)
{
    (void)state;
    scene one;
    burst_with(&one, 1);
    const size_t grains = one.state.grains.count;
    double mass = 0.0;
    for (size_t g = 0; g < grains; g++) {
        mass += one.state.grains.velocity[g][3];
    }
    scene_run(&one, 30000);
    const size_t middle = one.state.grains.count;
    assert_true(middle > 0 && middle < grains); // some are gone, others stay
    for (int64_t steps = 0; steps < 2000000 && one.state.grains.count > 0; steps += 10000) {
        scene_run(&one, 10000);
    }
    assert_int_equal(one.state.grains.count, 0);
    int64_t left = 0;
    double left_mass = 0.0;
    for (int f = 0; f < CLOD_FACES; f++) {
        left += one.state.exchange.left[f];
        left_mass += one.state.exchange.left_mass[f];
        assert_true(f / 2 != 1 || one.state.exchange.left[f] == 0); // y repeats itself
    }
    assert_true(one.state.exchange.left[0] > 0 && one.state.exchange.left[1] > 0);
    assert_true(one.state.exchange.left[4] > 0); // most are thrown down
    assert_int_equal(left, grains);
    check_relative(left_mass, mass, 1e-13);
    scene_end(&one);
}

/** Threads and cuts change no bit while grains leave. */
static void leaving_has_the_same_bits(void **state)
{
    (void)state;
    scene one;
    burst_with(&one, 1);
    const int64_t all = sanitized() ? 12000 : 30000;
    scene_run(&one, all);
    assert_true(clod_step_export(&one.step, &one.step.status));
    for (int threads = looks_for_races() ? 5 : 2; threads <= 5;
         threads += sanitized() ? 3 : 1) {
        scene cut;
        burst_with(&cut, threads);
        for (int64_t steps = 0; steps < all; steps += 6000) {
            clod_state copy = {0};
            scene_run(&cut, 6000);
            assert_true(clod_step_export(&cut.step, &cut.step.status));
            assert_true(clod_state_copy(&copy, &cut.state, &cut.step.status));
            scene_end(&cut);
            cut.state = copy;
            scene_start_with(&cut, (clod_step_options){.threads = threads});
        }
        assert_true(clod_step_export(&cut.step, &cut.step.status));
        check_same_bits(&one.state, &cut.state);
        assert_memory_equal(&one.state.exchange, &cut.state.exchange,
                            sizeof one.state.exchange);
        scene_end(&cut);
    }
    scene_end(&one);
}

static void refuse(scene *s, const char *text)
{
    clod_status status = {0};
    assert_false(clod_step_change(&s->step, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    if (strstr(status.text, text) == NULL) {
        fail_msg("'%s' does not say '%s'", status.text, text);
    }
    assert_false(clod_changes_any(&s->state.changes));
}

/** A grain too large for the period is refused before anything changes; an id that goes may
 *  come again. */
static void the_whole_queue_is_looked_at_first(void **state)
{
    (void)state;
    scene s;
    bed_init(&s, BED_CLUSTER, 6);
    scene_start(&s);
    const size_t grains = s.state.grains.count;
    const clod_new_grain large = {
        .id = 900, .position = {0.0, 0.0, 0.09, 1e-2}, .density = 2000.0, .material = 0};
    clod_changes_add_grain(&s.state.changes, &large);
    refuse(&s, "domain: the period along x is 0.045 m"); // it must be 4.6 R at least
    assert_int_equal(s.state.grains.count, grains);
    scene_run(&s, 10); // as if not asked

    const uint64_t id = s.state.grains.id[0];
    clod_new_grain again = large;
    again.id = id;
    again.position[3] = 1e-3;
    clod_changes_remove_grain(&s.state.changes, id);
    clod_changes_add_grain(&s.state.changes, &again);
    assert_true(clod_step_change(&s.step, &s.step.status));
    assert_int_equal(s.state.grains.count, grains);
    scene_end(&s);
}

/** Each wrong request, beside one that is right. */
static void wrong_requests_change_nothing(void **state)
{
    (void)state;
    scene s, plain;
    bed_init(&s, BED_DRUM, 8);
    bed_init(&plain, BED_DRUM, 8);
    scene_start(&s);
    scene_start(&plain);
    scene_run(&s, 3000);
    scene_run(&plain, 3000);
    clod_changes *changes = &s.state.changes;
    const clod_new_grain good = {
        .id = 900, .position = {0.0, 0.0, 0.09, 1e-3}, .density = 2000.0, .material = 1};
    clod_new_grain bad = good;

    clod_changes_remove_grain(changes, 4);
    clod_changes_remove_grain(changes, 12345);
    refuse(&s, "grain 12345 cannot be removed: there is none with this id");
    clod_changes_remove_grain(changes, 4);
    clod_changes_remove_grain(changes, 4);
    refuse(&s, "grain 4 cannot be removed: it is to be removed twice");
    clod_changes_remove_wall(changes, "roof");
    refuse(&s, "wall 'roof' cannot be removed: there is none of this name");
    clod_wall lid = {.name = "lid"};
    clod_changes_add_wall(changes, &lid);
    refuse(&s, "wall 'lid' cannot be added: another one has this name");
    bad.id = 4;
    clod_changes_add_grain(changes, &bad);
    refuse(&s, "grain 4 cannot be added: another one has this id");
    clod_changes_add_grain(changes, &good);
    clod_changes_add_grain(changes, &good);
    refuse(&s, "grain 900 cannot be added: another one has this id");
    bad = good;
    bad.material = 3;
    clod_changes_add_grain(changes, &bad);
    refuse(&s, "material 3 is unknown");
    bad = good;
    bad.position[1] = NAN;
    clod_changes_add_grain(changes, &bad);
    refuse(&s, "must be finite");
    bad = good;
    bad.position[3] = 0.0;
    clod_changes_add_grain(changes, &bad);
    refuse(&s, "radius (0 m)");
    bad = good;
    bad.position[2] = 10.5;
    clod_changes_add_grain(changes, &bad);
    refuse(&s, "(0, 0, 10.5) m is outside of the domain");

    scene_run(&s, 3000);
    scene_run(&plain, 3000);
    assert_true(clod_step_export(&s.step, &s.step.status));
    assert_true(clod_step_export(&plain.step, &plain.step.status));
    check_same_bits(&s.state, &plain.state);
    assert_int_equal(s.step.rebuilds, plain.step.rebuilds);
    scene_end(&s);
    scene_end(&plain);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_falling_grain_takes_its_energy_away),
        cmocka_unit_test(a_change_lets_go_what_is_beyond_a_side),
        cmocka_unit_test(nothing_is_made_for_an_empty_bed),
        cmocka_unit_test(every_grain_is_counted_once),
        cmocka_unit_test(leaving_has_the_same_bits),
        cmocka_unit_test(the_whole_queue_is_looked_at_first),
        cmocka_unit_test(wrong_requests_change_nothing),
    };
    if (sanitized()) {
        cmocka_set_skip_filter("every_grain_*"); // long; the same code runs in leaving_*
    }
    if (looks_for_races()) {
        cmocka_set_test_filter("leaving_*"); // the others have one thread
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
