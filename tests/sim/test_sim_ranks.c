/** A simulation that several ranks step, in the hands of a program: everything that it can see has the
 *  bits of one process. */

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "support/sim_ranks.h"

#define STREAM_HEAD SIM_HEAD(", design_stress: 1 kPa")
static const char STREAM[] =
    STREAM_HEAD "grains:\n"
                "  - {material: ore, radius: {distribution: uniform, min: 1.4 mm, max: 1.6 "
                "mm}, inlet: {mass_flow: 30 g/s}, region: {box: {min: [-15 mm, -12 mm, 20 "
                "mm], max: [15 mm, 12 mm, 30 mm]}}, velocity: [0.2 m/s, 0 m/s, -1 m/s]}\n"
                "gauges: {low: {region: {box: {min: [-20 mm, -12 mm, 0 mm], max: [20 mm, 12 "
                "mm, 9 mm]}}, direction: [0, 0, -1]}}\n"
                "output: {energy: true}\n";

// ---- looking

static void look(sim_trace *trace, clod_sim *sim, const char *folder)
{
    (void)folder;
    trace_all(trace, sim, "at the start");
    for (int k = 0; k < 4; k++) {
        advance(sim, 700);
        trace_all(trace, sim, "steps");
    }
    assert_true(clod_sim_row_of_id(sim, 5) < clod_sim_grain_count(sim));
    fprintf(trace->out, "row %zu\n", clod_sim_row_of_id(sim, 5));
}

static void all_that_is_seen_is_the_same(void **state)
{
    (void)state;
    if (!looks_for_races()) { // two threads have more
        same_on_ranks((sim_life){.live = look, .text = SIM_BED, .threads = 1});
    }
    same_on_ranks((sim_life){.live = look, .text = SIM_BED, .threads = 2});
}

// ---- writing

/** Every third grain gets a push, another force and another place. */
static void push(sim_trace *trace, clod_sim *sim, const char *folder)
{
    (void)folder;
    advance(sim, 1500);
    clod_sim_view velocity = sim_view(sim, "velocity");
    for (size_t g = 0; g < velocity.rows; g += 3) {
        clod_sim_row(&velocity, g)[0] += 0.3;
    }
    clod_sim_view again = sim_view(sim, "velocity"); // what was written is there
    assert_ptr_equal(again.data, velocity.data);
    clod_sim_view force = sim_view(sim, "force"), spin = sim_view(sim, "angular_velocity");
    for (size_t g = 0; g < force.rows; g += 3) {
        clod_sim_row(&force, g)[2] += 1e-3;
        clod_sim_row(&spin, g)[1] = 20.0;
    }
    trace_all(trace, sim, "written");
    advance(sim, 1);
    trace_all(trace, sim, "a step after writing");
    advance(sim, 400);
    trace_all(trace, sim, "after writing");
    clod_sim_view position = sim_view(sim, "position");
    for (size_t g = 0; g < position.rows; g += 5) {
        clod_sim_row(&position, g)[2] += 1e-4;
    }
    velocity = sim_view(sim, "velocity");
    clod_sim_row(&velocity, 3)[2] = -0.5;
    CHECK(clod_sim_positions_changed(sim, &status));
    advance(sim, 300);
    trace_all(trace, sim, "put elsewhere");
    position = sim_view(sim, "position");
    clod_sim_row(&position, 0)[0] = NAN;
    expect_refused(clod_sim_positions_changed(sim, &status), "finite");
}

static void what_is_written_counts(void **state)
{
    (void)state;
    same_on_ranks((sim_life){.live = push, .text = SIM_BED, .threads = 1});
}

/** Numbers of views that are not valid any more are none; of those that are, what they were. */
static void stale(void *context, clod_ranks *ranks)
{
    (void)context;
    clod_sim *sim = made_on(SIM_BED, 1, ranks);
    advance(sim, 10);
    const clod_sim_view position = sim_view(sim, "position"), id = sim_view(sim, "id");
    clod_sim_energy energy;
    CHECK(clod_sim_energies(sim, &energy, &status)); // no row has moved
    assert_true(isfinite(clod_sim_row(&position, 7)[2]));
    const size_t first = (size_t) * (uint64_t *)id.data;
    assert_int_equal(clod_sim_row_of_id(sim, first), 0);
    advance(sim, 1);
    for (size_t g = 0; g < position.rows; g++) {
        assert_true(isnan(clod_sim_row(&position, g)[0]) &&
                    isnan(clod_sim_row(&position, g)[2]));
        assert_true(((const uint64_t *)id.data)[g] == UINT64_MAX);
    }
    const clod_sim_view now = sim_view(sim, "position");
    assert_true(isfinite(clod_sim_row(&now, 7)[2]));
    clod_sim_destroy(&sim);
}

static void old_views_have_no_numbers(void **state)
{
    (void)state;
    ranks_crew_run(2, stale, NULL);
    ranks_crew_run(3, stale, NULL);
}

// ---- changing

static void add_grains(clod_sim *sim, uint64_t id, double z)
{
    for (int k = 0; k < 40; k++) { // more than there are rows for
        const clod_sim_grain grain = {
            .id = id + (uint64_t)k,
            .position = {-16e-3 + 4e-3 * (k % 9), -8e-3 + 4e-3 * (int)(k / 9), z},
            .radius = 1.5e-3,
            .velocity = {0.0, 0.1, -0.5},
            .material = (size_t)(k % 2)};
        CHECK(clod_sim_add_grain(sim, &grain, &status));
    }
}

static void change(sim_trace *trace, clod_sim *sim, const char *folder)
{
    (void)folder;
    CHECK(clod_sim_open_ledger(sim, &status));
    advance(sim, 900);
    add_grains(sim, 9000, 0.06);
    for (uint64_t id = 1; id < 60; id += 7) {
        CHECK(clod_sim_remove_grain(sim, id, &status));
    }
    CHECK(clod_sim_add_wall_from_text(
        sim, "bar",
        "{material: clay, shapes: [{box: {center: [-19 mm, 0 mm, 45 mm], size: [3 mm, 30 mm, 2 "
        "mm]}}], velocity: [0 m/s, 0 m/s, -50 mm/s]}",
        &status));
    advance(sim, 300);
    trace_all(trace, sim, "grains and a wall came, grains went");
    CHECK(clod_sim_remove_wall(sim, "post", &status));
    CHECK(clod_sim_remove_grain(sim, 9001, &status));
    CHECK(clod_sim_change(sim, &status));
    trace_all(trace, sim, "a wall went");
    // a request that is wrong: nothing has changed, and ranks go on
    CHECK(clod_sim_remove_grain(sim, 9001, &status));
    add_grains(sim, 9500, 0.07);
    expect_refused(clod_sim_change(sim, &status), "9001");
    trace_all(trace, sim, "nothing was done");
    advance(sim, 300);
    trace_all(trace, sim, "on it goes");
    clod_sim_view radius = sim_view(sim, "radius");
    double radii[512];
    assert_true(radius.rows < 512);
    for (size_t g = 0; g < radius.rows; g++) {
        radii[g] = 1.002 * clod_sim_row(&radius, g)[0];
    }
    const clod_sim_view mass = sim_view(sim, "mass"), velocity = sim_view(sim, "velocity");
    clod_sim_row(&velocity, 2)[1] = 0.25;
    CHECK(clod_sim_set_radii(sim, radii, &status));
    assert_true(clod_sim_row(&radius, 4)[0] == radii[4]); // these views are still valid
    trace_numbers(trace, "mass", clod_sim_row(&mass, 4), 1);
    trace_all(trace, sim, "thicker");
    CHECK(clod_sim_set_adhesion(sim, 0.5, &status));
    trace_all(trace, sim, "less adhesion");
    advance(sim, 300);
    trace_all(trace, sim, "thicker, later");
}

static void grains_and_walls_come_and_go(void **state)
{
    (void)state;
    same_on_ranks((sim_life){.live = change, .text = SIM_BED, .threads = 1});
}

static void drive(sim_trace *trace, clod_sim *sim, const char *folder)
{
    (void)folder;
    const int32_t lid = clod_sim_wall_index(sim, "lid"),
                  post = clod_sim_wall_index(sim, "post");
    const int32_t floor = clod_sim_wall_index(sim, "floor");
    const clod_sim_belt belt = {.speed = 0.3, .direction = {1.0, 0.2, 0.0}};
    CHECK(clod_sim_open_ledger(sim, &status));
    advance(sim, 900);
    clod_sim_reset_wall_means(sim);
    CHECK(clod_sim_set_wall_velocity(sim, post, (double[]){0.05, 0.0, 0.02}, &status));
    CHECK(clod_sim_set_wall_load(sim, lid, 0.5, &status));
    advance(sim, 300);
    trace_all(trace, sim, "load and velocity");
    CHECK(clod_sim_set_belt(sim, floor, 0, &belt, &status));
    advance(sim, 300);
    trace_all(trace, sim, "belt");
    CHECK(clod_sim_set_wall_surface_velocity(sim, floor, (double[]){-0.1, 0.0, 0.0}, &status));
    CHECK(clod_sim_set_wall_position(sim, post, (double[]){0.5e-3, 0.0, -1e-3}, &status));
    CHECK(clod_sim_set_wall_orientation(sim, post, (double[]){1.0, 0.0, 0.0, 0.01}, &status));
    trace_all(trace, sim, "elsewhere");
    advance(sim, 300);
    CHECK(clod_sim_set_wall_angular_velocity(sim, post, (double[]){0.0, 30.0, 3.0},
                                             (double[]){9e-3, 0.0, 4e-3}, &status));
    advance(sim, 300);
    trace_all(trace, sim, "turning");
    CHECK(clod_sim_set_wall_spin(sim, post, -20.0, &status));
    advance(sim, 300);
    trace_all(trace, sim, "turning back");
    expect_refused(clod_sim_set_wall_load(sim, lid, 1e9, &status), "time.step");
    advance(sim, 100);
    trace_all(trace, sim, "as before");
}

static void walls_are_driven(void **state)
{
    (void)state;
    same_on_ranks((sim_life){.live = drive, .text = SIM_BED, .threads = 1});
}

// ---- files and series

static void store(sim_trace *trace, clod_sim *sim, const char *folder)
{
    char path[PATH_MAX + 64];
    CHECK(clod_sim_open_series(sim, &status));
    advance(sim, 1200);
    trace_row(trace, sim);
    clod_sim_view velocity = sim_view(sim, "velocity");
    clod_sim_row(&velocity, 1)[0] = 0.4; // in the file
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    snprintf(path, sizeof path, "%s/restart_a.h5", folder);
    trace_file(trace, path);
    advance(sim, 300);
    trace_row(trace, sim);
    CHECK(clod_sim_write_snapshot(sim, folder, true, &status));
    static const char *const PICTURES[] = {"snap", "contacts", "walls"};
    for (int k = 0; k < 3; k++) {
        snprintf(path, sizeof path, "%s/%s_001500.hdf", folder, PICTURES[k]);
        trace_file(trace, path);
    }
    trace_all(trace, sim, "after the checkpoint");
    CHECK(clod_sim_read_checkpoint(sim, folder, NULL, &status));
    trace_all(trace, sim, "back");
    advance(sim, 300);
    trace_row(trace, sim);
    trace_all(trace, sim, "again");
}

static void files_and_series_are_the_same(void **state)
{
    (void)state;
    same_on_ranks((sim_life){.live = store, .text = SIM_BED, .threads = 1});
}

static void pour(sim_trace *trace, clod_sim *sim, const char *folder)
{
    (void)folder;
    for (int k = 0; k < 3; k++) {
        advance(sim, 1900);
        trace_row(trace, sim);
        trace_all(trace, sim, "poured");
        clod_sim_view velocity = sim_view(sim, "velocity");
        assert_true(velocity.rows > 0);
        clod_sim_row(&velocity, 0)[1] += 0.2;
        add_grains(sim, 90000 + 100 * (uint64_t)k, 0.05);
    }
}

static void grains_come_from_inlets(void **state)
{
    (void)state;
    same_on_ranks((sim_life){.live = pour, .text = STREAM, .threads = 1});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_that_is_seen_is_the_same),
        cmocka_unit_test(what_is_written_counts),
        cmocka_unit_test(old_views_have_no_numbers),
        cmocka_unit_test(grains_and_walls_come_and_go),
        cmocka_unit_test(walls_are_driven),
        cmocka_unit_test(files_and_series_are_the_same),
        cmocka_unit_test(grains_come_from_inlets),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
