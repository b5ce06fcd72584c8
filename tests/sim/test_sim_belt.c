// Grains on conveyor belts: carried, thrown off the pulley, started up; beside closed forms.

#include <math.h>
#include <string.h>

#include "output/temp_folder.h"
#include "output/wall_mesh.h"
#include "sim/sim.h"
#include "support/sim_made.h"

#define GRAVITY 9.81
#define RADIUS 0.005
#define STIFFNESS 2e4
#define STEP 1e-5

/** A belt of one level run of 1 m from x = 0, with a pulley of 0.2 m at its end. Grains hardly
 *  roll on it: `friction` and rolling resistance are as told. */
static clod_sim *belt_case(const char *speed, const char *start_up, const char *friction,
                           const char *restitution, int threads)
{
    char text[2048];
    snprintf(text, sizeof text,
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {law: hooke, k1: 2e4 N/m, restitution: %s, friction: %s,\n"
             "  rolling: epsd2, rolling_friction: 1}}\n"
             "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
             "domain: {min: [-1 m, -1 m, -2 m], max: [4 m, 1 m, 1 m]}\n"
             "walls:\n"
             "  feed:\n"
             "    material: ore\n%s"
             "    shapes:\n"
             "      - belt: {from: [0 m, 0 m, 0 m], runs: [{length: 0.5 m}, {length: 0.5 m}],\n"
             "               width: 400 mm, speed: %s, pulley: {radius: 200 mm}}\n"
             "stages: [{name: run, duration: 5 s}]\n"
             "output: {energy: true}\n"
             "time: {step: 1e-5 s, design_stress: 1 kPa}\n",
             restitution, friction, start_up, speed);
    return sim_made(text, threads);
}

static double mass(void)
{
    return 2500.0 * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS;
}

/** A grain at rest on the belt, with the overlap of its weight. */
static void add_resting(clod_sim *sim, uint64_t id, double x, double y, double velocity)
{
    const clod_sim_grain grain = {.id = id,
                                  .radius = RADIUS,
                                  .position = {x, y, RADIUS - mass() * GRAVITY / STIFFNESS},
                                  .velocity = {velocity, 0.0, 0.0}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
}

static const double *row(clod_sim *sim, const char *name, uint64_t id)
{
    const clod_sim_view view = sim_view(sim, name);
    return clod_sim_row(&view, clod_sim_row_of_id(sim, id));
}

static void advance(clod_sim *sim, double time)
{
    CHECK(clod_sim_advance(sim, (int64_t)lround(time / STEP), &status));
}

/** Above the critical speed sqrt(g r) a grain leaves where the pulley begins, and flies: r is that
 *  of its centre. Facets and the seam between two runs are not felt. */
static void a_fast_belt_throws_grains_off(void **state)
{
    (void)state;
    const double v = 2.0;
    assert_true(v * v > GRAVITY * (0.2 + RADIUS));
    clod_sim *sim = belt_case("2 m/s", "", "0.5", "0.2", 1);
    add_resting(sim, 1, 0.2, 0.03, v);
    advance(sim, 0.75);
    const double *at = row(sim, "position", 1), *velocity = row(sim, "velocity", 1);
    const double x = 0.2 + v * 0.75, flight = x - 1.0;
    assert_true(flight > 0.6);
    // it springs back from the overlap of its weight: at most by that, and with its speed; and
    // while it does the material of the pulley turns away beneath it
    const double spring = mass() * GRAVITY / STIFFNESS;
    const double kick = GRAVITY * sqrt(mass() / STIFFNESS);
    const double bounce = kick * flight / v;
    check_close(at[0], x, bounce);
    check_close(at[1], 0.03, 1e-9);
    check_close(at[2], RADIUS - 0.5 * GRAVITY * flight * flight / (v * v), spring + bounce);
    check_close(velocity[0], v, kick);
    clod_sim_destroy(&sim);
}

/** Seconds from look to look at a grain that goes round. */
#define LOOK 2e-4

/** Angle round the pulley at which a grain that is put on its top leaves it, spinning with it: it
 *  hardly rolls there. */
static double angle_at_which_it_leaves(const char *friction, double v)
{
    char speed[32];
    snprintf(speed, sizeof speed, "%g m/s", v);
    // hardly damped: the dash-pot's force is that of the velocity half a step before, which on
    // a curved way is one of zeta m v^2/r omega dt towards the wall (docs/belts.md)
    clod_sim *sim = belt_case(speed, "", friction, "0.9", 1);
    const double share = 1.0 - v * v / (0.04 * GRAVITY) * (0.2 + RADIUS); // of its weight
    const clod_sim_grain grain = {
        .id = 1,
        .radius = RADIUS,
        .position = {1.0 + 1e-9, 0.0, RADIUS - share * mass() * GRAVITY / STIFFNESS},
        .velocity = {v * (0.2 + RADIUS) / 0.2, 0.0, 0.0},
        .angular_velocity = {0.0, v / 0.2, 0.0}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    double last = -1.0;
    for (int k = 0; k < 1000; k++) {
        advance(sim, LOOK);
        const double *at = row(sim, "position", 1);
        if (hypot(at[0] - 1.0, at[2] + 0.2) < 0.2 + RADIUS) {
            last = atan2(at[0] - 1.0, at[2] + 0.2);
        }
    }
    clod_sim_destroy(&sim);
    return last;
}

/** v^2/(g r) of a grain that slips, from the angle `since` on where it was `then` (Booth 1934). */
static double booth(double mu, double since, double then, double a)
{
    const double square = 1.0 + 4.0 * mu * mu;
    const double at = ((4.0 * mu * mu - 2.0) * cos(since) - 6.0 * mu * sin(since)) / square;
    const double c = (then - at) * exp(-2.0 * mu * since);
    return ((4.0 * mu * mu - 2.0) * cos(a) - 6.0 * mu * sin(a)) / square +
           c * exp(2.0 * mu * a);
}

/** Slower than sqrt(g r) grains go round with the belt, slip where cos a - sin a/mu = v^2/(g r),
 *  get faster and leave where v^2/(g r) = cos a; v and r are those of the centre. */
static void a_slow_belt_takes_grains_round(void **state)
{
    (void)state;
    static const struct {
        const char *friction;
        double mu, speed;
    } CASES[] = {{"0.6", 0.6, 1.1}, {"0.3", 0.3, 0.8}};
    for (int k = 0; k < 2; k++) {
        const double r = 0.2 + RADIUS, mu = CASES[k].mu;
        const double v = CASES[k].speed * r / 0.2, share = v * v / (GRAVITY * r);
        double slips = 0.0;
        while (cos(slips) - sin(slips) / mu > share) {
            slips += 1e-5;
        }
        double leaves = slips;
        while (booth(mu, slips, share, leaves) < cos(leaves)) {
            leaves += 1e-5;
        }
        // seen up to a look late, with the swing of its contact: sqrt(m/k) is a quarter of that
        const double found = angle_at_which_it_leaves(CASES[k].friction, CASES[k].speed);
        check_close(found, leaves, 2.0 * LOOK * v / r);
        assert_true(found < acos(share) - 0.05); // without slip (CEMA)
    }
}

/** Where a grain is that has gone along the belt and some way round the pulley. */
static void place_on_pulley(const char *speed, double position[3])
{
    clod_sim *sim = belt_case(speed, "", "0.6", "0.9", 1);
    add_resting(sim, 1, 0.9, 0.03, 1.1);
    advance(sim, 0.16);
    memcpy(position, row(sim, "position", 1), 3 * sizeof(double));
    clod_sim_destroy(&sim);
}

/** Facets of 3 mm, shorter than those of the pulley: the grain takes the same way. */
static void fine_facets_are_not_felt(void **state)
{
    (void)state;
    double coarse[3], fine[3];
    place_on_pulley("1.1 m/s", coarse);
    place_on_pulley("1.1 m/s, facet: 3 mm", fine);
    assert_true(coarse[0] > 1.05 && hypot(coarse[0] - 1.0, coarse[2] + 0.2) < 0.2 + RADIUS);
    for (int axis = 0; axis < 3; axis++) {
        check_close(fine[axis], coarse[axis], 1e-9);
    }
}

/** A grain that slides and does not roll is carried off with the heat of half the belt's work. */
static void half_of_the_work_of_a_belt_is_heat(void **state)
{
    (void)state;
    const double v = 1.0, friction = 0.5;
    clod_sim *sim = belt_case("1 m/s", "", "0.5", "0.2", 1);
    add_resting(sim, 1, 0.1, 0.0, 0.0);
    CHECK(clod_sim_open_ledger(sim, &status));
    const double until = v / (friction * GRAVITY);
    advance(sim, 0.5 * until);
    check_close(row(sim, "velocity", 1)[0], 0.5 * v, 2e-3 * v);
    advance(sim, until);
    clod_sim_ledger ledger;
    CHECK(clod_sim_ledger_look(sim, &ledger, &status));
    const double joule = mass() * v * v;
    // less what the tangential spring and the rolling spring hold and damp: parts of a percent
    check_close(row(sim, "velocity", 1)[0], v, 2e-3 * v);
    check_close(ledger.wall_work, joule, 1e-2 * joule);
    check_close(ledger.friction, 0.5 * joule, 1e-2 * joule);
    check_close(row(sim, "position", 1)[0], 0.1 + 0.5 * v * until + v * 0.5 * until, 2e-3);
    clod_sim_destroy(&sim);
}

/** A belt that starts up takes along what does not slip: its speed at every time. */
static void a_belt_starts_up_linearly(void **state)
{
    (void)state;
    clod_sim *sim =
        belt_case("1 m/s", "    start_up: {at: 0.1 s, duration: 0.4 s}\n", "0.8", "0.2", 1);
    add_resting(sim, 1, 0.1, 0.0, 0.0);
    advance(sim, 0.1);
    check_close(row(sim, "position", 1)[0], 0.1, 1e-12); // it stood
    advance(sim, 0.2);
    check_close(row(sim, "velocity", 1)[0], 0.5, 5e-3); // the spring of the contact swings
    check_close(row(sim, "position", 1)[0], 0.1 + 0.5 * 2.5 * 0.04, 5e-4);
    advance(sim, 0.4);
    check_close(row(sim, "velocity", 1)[0], 1.0, 1e-3);
    check_close(row(sim, "position", 1)[0], 0.1 + 0.2 + 0.2, 5e-4);
    clod_sim_destroy(&sim);
}

/** Without a ramp: at rest, and from one moment on with its speed. */
static void a_belt_starts_at_once(void **state)
{
    (void)state;
    clod_sim *sim =
        belt_case("1 m/s", "    start_up: {at: 0.1 s, duration: 0 s}\n", "0.5", "0.2", 1);
    add_resting(sim, 1, 0.1, 0.0, 0.0);
    advance(sim, 0.1);
    check_close(row(sim, "position", 1)[0], 0.1, 1e-12);
    advance(sim, 0.1); // slips: mu g
    check_close(row(sim, "velocity", 1)[0], 0.5 * GRAVITY * 0.1, 5e-3);
    clod_sim_destroy(&sim);
}

/** Interrupted while it starts up, on other threads: the same bits. */
static void a_start_up_goes_on_from_a_checkpoint(void **temporary)
{
    const char *start_up = "    start_up: {duration: 0.02 s}\n";
    clod_sim *whole = belt_case("1 m/s", start_up, "0.5", "0.2", 1);
    clod_sim *first = belt_case("1 m/s", start_up, "0.5", "0.2", 2);
    for (uint64_t id = 1; id <= 8; id++) {
        add_resting(whole, id, 0.1 * (double)id, 0.0, 0.0);
        add_resting(first, id, 0.1 * (double)id, 0.0, 0.0);
    }
    CHECK(clod_sim_advance(whole, 3000, &status));
    CHECK(clod_sim_advance(first, 1100, &status));
    CHECK(clod_sim_write_checkpoint(first, *temporary, &status));
    clod_sim_destroy(&first);
    clod_sim *second = belt_case("1 m/s", start_up, "0.5", "0.2", 1);
    CHECK(clod_sim_read_checkpoint(second, *temporary, NULL, &status));
    CHECK(clod_sim_advance(second, 1900, &status));
    for (uint64_t id = 1; id <= 8; id++) {
        assert_memory_equal(row(whole, "position", id), row(second, "position", id),
                            3 * sizeof(double));
        assert_memory_equal(row(whole, "velocity", id), row(second, "velocity", id),
                            3 * sizeof(double));
    }
    clod_sim_destroy(&whole);
    clod_sim_destroy(&second);
}

/** A trough of 30 degrees that flattens over 100 mm, at the end of a run that rises. */
static clod_sim *trough_case(const char *speed, const char *start_up)
{
    char text[2048];
    snprintf(
        text, sizeof text,
        "materials: {ore: {density: 2500 kg/m3}}\n"
        "contacts: {default: {law: hooke, k1: 2e4 N/m, restitution: 0.2, friction: 2,\n"
        "  rolling: epsd2, rolling_friction: 1}}\n"
        "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
        "domain: {min: [-1 m, -1 m, -1 m], max: [2 m, 1 m, 1 m]}\n"
        "walls:\n"
        "  feed:\n"
        "    material: ore\n%s"
        "    shapes:\n"
        "      - belt: {from: [0 m, 0 m, 0 m], runs: [{length: 0.5 m}, {length: 0.5 m, rise: 8 deg}],\n"
        "               width: 300 mm, idler_angle: 30 deg, middle_roll: 100 mm, transition: 100 mm,\n"
        "               speed: %s, pulley: {radius: 100 mm, return: 200 mm},\n"
        "               skirts: {to: 0.3 m, distance: 160 mm, gap: 5 mm, height: 60 mm}}\n"
        "stages: [{name: run, duration: 5 s}]\n"
        "time: {step: 1e-5 s, design_stress: 1 kPa}\n",
        start_up, speed);
    return sim_made(text, 1);
}

/** Number of the part of a belt to which a triangle belongs, from its label; its length. */
static const char *part_of(const clod_wall_mesh *mesh, size_t triangle, int *length)
{
    const char *at = mesh->parts;
    for (int32_t k = 0; k < mesh->part[triangle]; k++) {
        at = strchr(at, '\n') + 1;
    }
    *length = (int)strcspn(at, "\n");
    return at;
}

/** All triangles of runs and return: the material goes with `speed` along them, on the slope of
 *  its run; skirts stand. */
static void check_speeds(clod_sim *sim, double speed)
{
    clod_wall_mesh mesh;
    CHECK(clod_wall_mesh_make(&mesh, &sim->state, &status));
    int leaning = 0, moving = 0;
    for (size_t t = 0; t < mesh.count; t++) {
        int length;
        const char *part = part_of(&mesh, t, &length);
        clod_vec3 p[3];
        memcpy(p, mesh.corner[t], sizeof p);
        const clod_vec3 normal = clod_vec3_unit(
            clod_vec3_cross(clod_vec3_sub(p[1], p[0]), clod_vec3_sub(p[2], p[0])));
        const clod_vec3 v = clod_vec3_of(mesh.velocity[t]);
        if (strncmp(part, "feed.skirts", (size_t)length) == 0) {
            check_close(clod_vec3_length(v), 0.0, 0.0);
        } else if (strncmp(part, "feed.pulley", (size_t)length) != 0) {
            const bool back = strncmp(part, "feed.return", (size_t)length) == 0;
            check_close(clod_vec3_length(v), fabs(speed), 1e-12);
            check_close(clod_vec3_dot(v, normal), 0.0, 1e-12);
            assert_true(v.x * speed > 0.0 || speed == 0.0 || back);
            moving++;
            leaning += fabs(normal.x) > 0.2 ? 1 : 0; // more than the slope of 8 degrees has
        }
    }
    assert_true(moving > 40 && leaning > 8);
    clod_wall_mesh_fini(&mesh);
}

/** On wings of a transition, which lean across the belt, the material is as fast as elsewhere:
 *  backwards too, and with the part of its speed that it has while it starts up. */
static void a_belt_has_its_speed_on_all_facets(void **state)
{
    (void)state;
    const struct {
        const char *speed, *start_up;
        double after, expected;
    } CASES[] = {{"2.5 m/s", "", 0.0, 2.5},
                 {"-2.5 m/s", "", 0.0, -2.5},
                 {"2.5 m/s", "    start_up: {at: 0.01 s, duration: 0.02 s}\n", 0.02, 1.25}};
    for (int k = 0; k < 3; k++) {
        clod_sim *sim = trough_case(CASES[k].speed, CASES[k].start_up);
        advance(sim, CASES[k].after);
        check_speeds(sim, CASES[k].expected);
        clod_sim_destroy(&sim);
    }
}

/** A grain that does not slip goes down the wing of a transition with the belt's speed, but for
 *  bumps from facet to facet; the run's velocity without what is normal to the wing is 5 % less. */
static void a_grain_rides_on_a_transition(void **state)
{
    (void)state;
    const double speed = 0.2, slope = 8.0 * M_PI / 180.0, wing = 30.0 * M_PI / 180.0;
    clod_sim *sim = trough_case("0.2 m/s", "");
    // above the middle of the left wing, 10 mm before the transition
    const double run = 0.39, y = 0.05 + 0.05 * cos(wing);
    const double up = 0.05 * sin(wing) + RADIUS / cos(wing) - 1e-6;
    const clod_sim_grain grain = {.id = 1,
                                  .radius = RADIUS,
                                  .position = {0.5 + run * cos(slope) - up * sin(slope), y,
                                               run * sin(slope) + up * cos(slope)},
                                  .velocity = {speed * cos(slope), 0.0, speed * sin(slope)}};
    CHECK(clod_sim_add_grain(sim, &grain, &status));
    const double begins = 0.5 + 0.4 * cos(slope);
    int down = 0, steady = 0;
    advance(sim, 2e-3); // a grain that was added has a row from the next step on
    while (row(sim, "position", 1)[0] < begins + 0.06) {
        advance(sim, 2e-3);
        const clod_vec3 v = clod_vec3_of(row(sim, "velocity", 1));
        if (row(sim, "position", 1)[0] > begins && v.z < -0.2 * speed) {
            down++;
            steady += fabs(clod_vec3_length(v) - speed) < 2e-3 * speed ? 1 : 0;
        }
    }
    assert_true(down > 50 && 2 * steady > down);
    clod_sim_destroy(&sim);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_fast_belt_throws_grains_off),
        cmocka_unit_test(a_slow_belt_takes_grains_round),
        cmocka_unit_test(fine_facets_are_not_felt),
        cmocka_unit_test(half_of_the_work_of_a_belt_is_heat),
        cmocka_unit_test(a_belt_starts_up_linearly),
        cmocka_unit_test(a_belt_starts_at_once),
        cmocka_unit_test(a_belt_has_its_speed_on_all_facets),
        cmocka_unit_test(a_grain_rides_on_a_transition),
        cmocka_unit_test_setup_teardown(a_start_up_goes_on_from_a_checkpoint, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
