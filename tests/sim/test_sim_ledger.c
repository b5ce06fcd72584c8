// What has come and gone, and the energy ledger, from the library's object.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "support/sim_made.h"

/** Cohesive grains above a floor; sides are open, and remove what leaves. */
#define CASE(count, more)                                                                      \
    "materials: {ore: {density: 2500 kg/m3}}\n"                                                \
    "contacts: {default: {law: eepa, exponent: 1, k1: 1e4 N/m, k2: 2e4 N/m, k_adh: 5e3 N/m,\n" \
    "  pull_off_force: 1 mN, restitution: 0.5, friction: 0.3}}\n"                              \
    "time: {step: 5e-6 s}\n"                                                                   \
    "stages: [{name: fall, duration: 1 s}]\n"                                                  \
    "walls:\n"                                                                                 \
    "  floor: {material: ore, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], "                   \
    "normal: [0, 0, 1]}}]}\n"                                                                  \
    "  sides: {material: ore, shapes: [\n"                                                     \
    "    {cylinder: {foot: [0 mm, 0 mm, 0 mm], radius: 8 mm, length: 60 mm}}]}\n"              \
    "grains:\n"                                                                                \
    "  - {material: ore, count: " count ", radius: {distribution: uniform, min: 2 mm, "        \
    "max: 2 mm}, region: {annulus: {center: [0 mm, 0 mm, 10 mm], inner_radius: 0 mm, "         \
    "outer_radius: 6 mm, height: 40 mm}}}\n" more
#define OPEN                                                                                   \
    "domain: {min: [-30 mm, -30 mm, -5 mm], max: [30 mm, 30 mm, 90 mm], open: delete}\n"

static clod_sim_ledger ledger_of(clod_sim *sim)
{
    clod_sim_ledger ledger;
    CHECK(clod_sim_ledger_look(sim, &ledger, &status));
    return ledger;
}

static double sum_of(clod_sim *sim)
{
    clod_sim_energy e;
    CHECK(clod_sim_energies(sim, &e, &status));
    return e.translation + e.rotation + e.potential + e.normal + e.sliding + e.rolling;
}

/** One grain falls and comes to rest: what it lost is what it had, and the books close. */
static void what_is_lost_was_there(void **state)
{
    (void)state;
    clod_sim *sim = sim_made(CASE("1", OPEN "output: {energy: true}\n"), 1);
    const double before = sum_of(sim);
    CHECK(clod_sim_advance(sim, 200000, &status));
    const clod_sim_ledger end = ledger_of(sim);
    const double mass = 2500.0 * 4.0 / 3.0 * M_PI * 8e-9;
    const double rest = mass * 9.81 * 2e-3;        // on the floor, but for the overlap
    check_close(sum_of(sim), rest, 0.02 * before); // a contact that was pressed stores some
    check_relative(end.plastic + end.dash_pot + end.friction, before - rest, 0.02);
    assert_true(end.plastic > 0.0 && end.dash_pot > 0.0);
    check_close(end.residual, 0.0, 1e-3 * before);
    assert_true(end.rolling == 0.0 && end.wall_work == 0.0 && end.exchanged == 0.0);
    CHECK(clod_sim_open_ledger(sim, &status)); // anew
    assert_true(ledger_of(sim).dash_pot == 0.0);
    clod_sim_destroy(&sim);
}

/** What the owner changes is exchanged: it leaves the residual as it is, to rounding. */
static void changes_are_booked(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 2; threads++) {
        clod_sim *sim = sim_made(CASE("35", OPEN), threads);
        CHECK(clod_sim_advance(sim, 40000, &status));
        CHECK(clod_sim_open_ledger(sim, &status));
        double before = sum_of(sim);
        CHECK(clod_sim_set_adhesion(sim, 0.3, &status));
        double booked = sum_of(sim) - before;
        assert_true(fabs(booked) > 1e-10);
        check_relative(ledger_of(sim).exchanged, booked, 1e-6);
        check_close(ledger_of(sim).residual, 0.0, 1e-6 * fabs(booked));
        before = sum_of(sim);
        CHECK(clod_sim_set_wall_position(sim, 0, (double[3]){0.0, 0.0, 2e-5}, &status));
        const double moved = sum_of(sim) - before;
        assert_true(moved > 1e-8); // into the grains that lie there
        check_relative(ledger_of(sim).exchanged, booked + moved, 1e-6);
        booked = ledger_of(sim).exchanged;
        before = sum_of(sim);
        const double tilt[4] = {1.0, 5e-4, 0.0, 0.0}; // 1 mrad about x
        CHECK(clod_sim_set_wall_orientation(sim, 0, tilt, &status));
        const double tilted = sum_of(sim) - before;
        assert_true(fabs(tilted) > 1e-10);
        check_relative(ledger_of(sim).exchanged - booked, tilted, 1e-6);
        booked = ledger_of(sim).exchanged;
        const clod_sim_grain grain = {
            .id = 900, .position = {0.0, 0.0, 0.08}, .radius = 1e-3, .velocity = {0.1, 0, 0}};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
        const double mass = 2500.0 * 4.0 / 3.0 * M_PI * 1e-9;
        const double brought = mass * (9.81 * 0.08 + 0.5 * 0.01);
        check_relative(ledger_of(sim).exchanged - booked, brought, 1e-6);
        check_close(ledger_of(sim).residual, 0.0, 1e-6 * brought);
        clod_sim_exchange exchange;
        CHECK(clod_sim_exchange_look(sim, &exchange, &status));
        assert_int_equal(exchange.added, 1);
        check_relative(exchange.added_mass, mass, 1e-12);
        clod_sim_destroy(&sim);
    }
}

/** A grain thrown over the rim leaves at x max with the energy of its flight. */
static void what_leaves_is_counted_by_side(void **state)
{
    (void)state;
    clod_sim *sim = sim_made(CASE("1", OPEN "output: {energy: true}\n"), 1);
    const clod_sim_grain grain = {
        .id = 7, .position = {0.0, 0.0, 0.08}, .radius = 1e-3, .velocity = {2.0, 0.0, 0.0}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    clod_sim_exchange exchange;
    CHECK(clod_sim_exchange_look(sim, &exchange, &status));
    assert_int_equal(exchange.added, 0); // a request
    CHECK(clod_sim_advance(sim, 10000, &status));
    CHECK(clod_sim_exchange_look(sim, &exchange, &status));
    assert_int_equal(exchange.added, 1);
    const double mass = 2500.0 * 4.0 / 3.0 * M_PI * 1e-9, fall = 9.81 * 0.03 / 2.0; // m/s
    for (int side = 0; side < CLOD_SIM_SIDES; side++) {
        assert_int_equal(exchange.left[side].grains, side == CLOD_SIM_X_MAX);
    }
    check_relative(exchange.left[CLOD_SIM_X_MAX].mass, mass, 1e-12);
    // it leaves when the lists are made the next time, a little beyond the border
    check_relative(exchange.left[CLOD_SIM_X_MAX].energy, 0.5 * mass * (4.0 + fall * fall),
                   5e-3);
    check_close(ledger_of(sim).residual, 0.0, 1e-9);
    CHECK(clod_sim_remove_grain(sim, 1, &status));
    CHECK(clod_sim_remove_wall(sim, "sides", &status));
    CHECK(clod_sim_change(sim, &status));
    CHECK(clod_sim_exchange_look(sim, &exchange, &status));
    assert_int_equal(exchange.removed, 1);
    assert_int_equal(exchange.walls_removed, 1);
    check_relative(exchange.removed_mass, 8.0 * mass, 1e-12);
    clod_sim_destroy(&sim);
}

/** The ledger and the counts go through a checkpoint. */
static void books_go_through_a_checkpoint(void **temporary)
{
    const char *folder = *temporary;
    clod_sim *sim = sim_made(CASE("30", OPEN "output: {energy: true}\n"), 1);
    clod_sim *again = sim_made(CASE("30", OPEN "output: {energy: true}\n"), 2);
    CHECK(clod_sim_remove_grain(sim, 3, &status));
    CHECK(clod_sim_advance(sim, 15000, &status));
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    CHECK(clod_sim_read_checkpoint(again, folder, NULL, &status));
    CHECK(clod_sim_advance(sim, 5000, &status));
    CHECK(clod_sim_advance(again, 5000, &status));
    const clod_sim_ledger a = ledger_of(sim), b = ledger_of(again);
    assert_true(a.dash_pot > 0.0 && a.exchanged < 0.0);
    assert_memory_equal(&a, &b, sizeof a);
    clod_sim_exchange exchange;
    CHECK(clod_sim_exchange_look(again, &exchange, &status));
    assert_int_equal(exchange.removed, 1);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&again);
}

static void what_cannot_be_is_refused(void **state)
{
    (void)state;
    clod_sim *sim = sim_made(CASE("1", OPEN), 1);
    clod_sim_ledger ledger;
    clod_sim_exchange exchange;
    expect_refused(clod_sim_ledger_look(sim, &ledger, &status), "the ledger is not open");
    expect_refused(clod_sim_ledger_look(sim, NULL, &status), "ledger is NULL");
    expect_refused(clod_sim_ledger_look(NULL, &ledger, &status), "self is NULL");
    expect_refused(clod_sim_open_ledger(NULL, &status), "self is NULL");
    expect_refused(clod_sim_exchange_look(sim, NULL, &status), "exchange is NULL");
    expect_refused(clod_sim_exchange_look(NULL, &exchange, &status), "self is NULL");
    clod_sim_destroy(&sim);
    sim = sim_made(CASE("1",
                        "domain: {min: [-30 mm, -30 mm, -50 mm], max: [30 mm, 30 mm, 90 mm], "
                        "periodic: [false, false, true]}\n"),
                   1);
    expect_refused(clod_sim_open_ledger(sim, &status), "gravity has a part along z");
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_lost_was_there),
        cmocka_unit_test(changes_are_booked),
        cmocka_unit_test(what_leaves_is_counted_by_side),
        cmocka_unit_test_setup_teardown(books_go_through_a_checkpoint, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test(what_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
