// Grains of a simulation that grow and shrink between steps.

#include <math.h>

#include "support/sim_made.h"

#define COUNT 40

/** Grains that fly in a box without gravity. */
static const char CASE[] =
    "materials: {ore: {density: 2500 kg/m3}, lead: {density: 11000 kg/m3}}\n"
    "contacts: {default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.3}}\n"
    "gravity: [0, 0, 0]\n"
    "time: {step: 1e-5 s, overlap_limit: 0.5}\n"
    "domain: {min: [0 mm, 0 mm, 0 mm], max: [24 mm, 24 mm, 24 mm], periodic: [true, true, "
    "true]}\n"
    "stages: [{name: fly, duration: 1 s}]\n"
    "grains:\n"
    "  - {material: ore, count: 20, radius: {distribution: uniform, min: 0.9 mm, max: 1 mm}, "
    "region: {box: {min: [0 mm, 0 mm, 0 mm], max: [24 mm, 24 mm, 24 mm]}}, velocity: [1 m/s, "
    "0 m/s, 0 m/s]}\n"
    "  - {material: lead, count: 20, radius: {distribution: uniform, min: 0.9 mm, max: 1 "
    "mm}, region: {box: {min: [0 mm, 0 mm, 0 mm], max: [24 mm, 24 mm, 24 mm]}}, velocity: "
    "[-1 m/s, 0 m/s, 0 m/s]}\n"
    "output: {energy: true}\n";

/** A radius for each id, larger by up to a half than that of the case. */
static double radius_of(uint64_t id)
{
    return 1e-3 + 5e-4 * (double)(id % 11) / 10.0;
}

static uint64_t id_at(const clod_sim_view *ids, size_t row)
{
    return *(const uint64_t *)((const char *)ids->data + row * ids->stride);
}

static void grow(clod_sim *sim)
{
    double radii[COUNT];
    const clod_sim_view ids = sim_view(sim, "id");
    assert_int_equal(ids.rows, COUNT);
    for (size_t g = 0; g < COUNT; g++) {
        radii[g] = radius_of(id_at(&ids, g));
    }
    CHECK(clod_sim_set_radii(sim, radii, &status));
}

/** Each grain goes, and one of its id, with the other radius, comes where it was. */
static void exchange(clod_sim *sim)
{
    const clod_sim_view ids = sim_view(sim, "id"), position = sim_view(sim, "position");
    const clod_sim_view velocity = sim_view(sim, "velocity");
    const clod_sim_view spin = sim_view(sim, "angular_velocity");
    const clod_sim_view material = sim_view(sim, "material");
    for (size_t g = 0; g < ids.rows; g++) {
        const uint16_t m =
            *(const uint16_t *)((const char *)material.data + g * material.stride);
        clod_sim_grain grain = {.id = id_at(&ids, g), .material = m};
        grain.radius = radius_of(grain.id);
        memcpy(grain.position, clod_sim_row(&position, g), sizeof grain.position);
        memcpy(grain.velocity, clod_sim_row(&velocity, g), sizeof grain.velocity);
        memcpy(grain.angular_velocity, clod_sim_row(&spin, g), sizeof grain.angular_velocity);
        CHECK(clod_sim_remove_grain(sim, grain.id, &status));
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
    CHECK(clod_sim_change(sim, &status));
}

static size_t contacts_of(clod_sim *sim)
{
    clod_sim_bed bed;
    CHECK(clod_sim_measure(sim, &bed, &status));
    return bed.pairs;
}

/** All that the rows have, bit for bit. */
static void assert_same(clod_sim *a, clod_sim *b)
{
    assert_int_equal(clod_sim_grain_count(a), clod_sim_grain_count(b));
    for (size_t n = 0; n < clod_sim_array_count(); n++) {
        const clod_sim_view x = sim_view(a, clod_sim_array_name(n));
        const clod_sim_view y = sim_view(b, clod_sim_array_name(n));
        if (x.type == CLOD_SIM_F64) {
            for (size_t g = 0; g < x.rows; g++) {
                assert_memory_equal(clod_sim_row(&x, g), clod_sim_row(&y, g),
                                    x.components * sizeof(double));
            }
        }
    }
}

/** Without contacts at that moment, a grain that grows is one that another one replaces. */
static void grown_grains_are_like_new_ones(void **unused)
{
    (void)unused;
    clod_sim *a = sim_made(CASE, 1), *b = sim_made(CASE, 2);
    CHECK(clod_sim_advance(a, 20, &status));
    CHECK(clod_sim_advance(b, 20, &status));
    assert_int_equal(contacts_of(a), 0);
    grow(a);
    exchange(b);
    size_t met = 0;
    for (int k = 0; k < 20; k++) {
        CHECK(clod_sim_advance(a, 200, &status));
        CHECK(clod_sim_advance(b, 200, &status));
        assert_same(a, b);
        met += contacts_of(a);
    }
    assert_true(met > 5);
    clod_sim_ledger x, y;
    CHECK(clod_sim_ledger_look(a, &x, &status));
    CHECK(clod_sim_ledger_look(b, &y, &status));
    check_relative(x.exchanged, y.exchanged, 1e-12);
    check_relative(x.residual, y.residual, 1e-6);
    clod_sim_destroy(&a);
    clod_sim_destroy(&b);
}

/** What growing into each other does to the energy is exchanged, and comes from nowhere else. */
static void the_ledger_knows_of_it(void **unused)
{
    (void)unused;
    clod_sim *sim = sim_made(CASE, 1);
    clod_sim_energy before, now;
    clod_sim_ledger first, ledger;
    CHECK(clod_sim_advance(sim, 2000, &status));
    CHECK(clod_sim_energies(sim, &before, &status));
    CHECK(clod_sim_ledger_look(sim, &first, &status));
    grow(sim);
    CHECK(clod_sim_energies(sim, &now, &status));
    CHECK(clod_sim_ledger_look(sim, &ledger, &status));
    assert_true(now.translation > 1.2 * before.translation); // more mass
    assert_true(now.normal > before.normal);                 // into each other
    const double gained = now.translation + now.rotation + now.normal + now.sliding -
                          before.translation - before.rotation - before.normal - before.sliding;
    check_relative(ledger.exchanged, gained, 1e-9);
    check_close(ledger.residual, first.residual, 1e-9 * gained);
    clod_sim_destroy(&sim);
}

static void what_cannot_be_changes_nothing(void **unused)
{
    (void)unused;
    static const struct {
        double radius;
        const char *words;
    } WRONG[] = {{0.0, "is 0 m; give a finite number above 0"},
                 {NAN, "is nan m"},
                 {7e-3, "the period along x is 0.024 m"},
                 {1e-5, "with these radii the time step of 1e-05 s is beyond the critical"}};
    clod_sim *sim = sim_made(CASE, 1), *other = sim_made(CASE, 1);
    double radii[COUNT];
    for (size_t k = 0; k < sizeof WRONG / sizeof *WRONG; k++) {
        const clod_sim_view now = sim_view(sim, "radius");
        for (size_t g = 0; g < COUNT; g++) {
            radii[g] = g == 30 ? WRONG[k].radius : *clod_sim_row(&now, g);
        }
        expect_refused(clod_sim_set_radii(sim, radii, &status), WRONG[k].words);
    }
    const clod_sim_view now = sim_view(sim, "radius");
    for (size_t g = 0; g < COUNT; g++) {
        radii[g] = *clod_sim_row(&now, g);
    }
    CHECK(clod_sim_remove_grain(sim, 5, &status));
    expect_refused(clod_sim_set_radii(sim, radii, &status), "call clod_sim_change first");
    CHECK(clod_sim_remove_grain(other, 5, &status));
    CHECK(clod_sim_advance(sim, 2000, &status));
    CHECK(clod_sim_advance(other, 2000, &status));
    assert_same(sim, other);
    clod_sim_destroy(&sim);
    clod_sim_destroy(&other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grown_grains_are_like_new_ones),
        cmocka_unit_test(the_ledger_knows_of_it),
        cmocka_unit_test(what_cannot_be_changes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
