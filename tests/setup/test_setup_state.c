// Whole free-run cases made into states.

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "setup/domain.h"
#include "setup/grains.h"
#include "setup/state.h"
#include "support/case_of.h"

#define HEAD                                                                                   \
    "title: state\n"                                                                           \
    "materials:\n"                                                                             \
    "  ore: {density: 2000 kg/m3}\n"                                                           \
    "  steel: {}\n"                                                                            \
    "contacts:\n"                                                                              \
    "  default: {law: hooke, k1: 1e5 N/m, friction: 0}\n"

#define STAGES                                                                                 \
    "stages:\n"                                                                                \
    "  - {name: settle, duration: 1 s, adhesion: 10 %}\n"

#define SIZES "    radius: {distribution: uniform, min: 1 mm, max: 1 mm}\n"
#define REGION "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 30 mm, 40 mm]}}\n"

static void build(const clod_case *from, clod_state *state)
{
    clod_status status = {0};
    if (!clod_setup_state(from, from->seed, state, &status)) {
        fail_msg("%s", status.text);
    }
}

// By hand: a grain of 1 mm has 8.37758e-6 kg; 1 g is nearest to 119 of them. 20 x 30 mm2, 10 mm
// high, 0.6 solid is 3.6e-6 m3 or 859.4 grains of 4.18879e-9 m3.
static void groups_by_count_mass_and_fill_height(void **state)
{
    (void)state;
    clod_case *from = case_of(HEAD "grains:\n"
                                   "  - material: ore\n    count: 7\n" SIZES REGION
                                   "  - material: ore\n    mass: 1 g\n" SIZES REGION
                                   "  - material: ore\n    fill_height: 10 mm\n" SIZES REGION
                                   "    velocity: 0 0 -1 m/s\n" STAGES,
                              NULL);
    clod_state s;
    build(from, &s);
    assert_int_equal(s.grains.count, 7 + 119 + 859);
    for (size_t g = 0; g < s.grains.count; g++) {
        assert_int_equal(s.grains.id[g], g + 1);
        check_relative(s.grains.velocity[g][3], 8.37758e-6, 1e-6);
        assert_true(s.grains.velocity[g][2] == (g < 126 ? 0.0 : -1.0));
    }
    assert_true(s.adhesion == 0.1);
    clod_setup_overlap worst;
    clod_status status = {0};
    assert_true(clod_setup_worst_overlap(&s, &worst, &status));
    assert_true(worst.overlap == 0.0);
    clod_state_fini(&s);
    clod_case_destroy(&from);
}

// By hand: grains and wall reach from -5 to 20 mm in x, 0 to 30 in y, 0 to 40 in z (nearly, as
// grains are at random); the largest extent is added on both sides.
static void domain_is_generous_when_not_given(void **state)
{
    (void)state;
    clod_case *from =
        case_of(HEAD "grains:\n"
                     "  - material: ore\n    count: 5\n" SIZES REGION "walls:\n"
                     "  post:\n"
                     "    material: steel\n"
                     "    shapes: [{cylinder: {foot: [0 mm, 15 mm, 0 mm], axis: [0, 0, 1],"
                     " radius: 5 mm, length: 50 mm, side: outside}}]\n" STAGES,
                NULL);
    clod_state s;
    build(from, &s);
    check_close(s.domain.min[2], -50e-3, 1e-12);
    check_close(s.domain.max[2], 100e-3, 1e-12);
    check_close(s.domain.min[0], -5e-3 - 50e-3, 1e-12);
    assert_false(s.domain.periodic[0]);
    clod_state_fini(&s);
    clod_case_destroy(&from);
}

static void given_domain_is_taken(void **state)
{
    (void)state;
    clod_case *from =
        case_of(HEAD "domain: {min: [0 mm, 0 mm, -1 mm], max: [20 mm, 30 mm, 90 mm],"
                     " periodic: [true, true, false]}\n"
                     "gravity: [1 m/s2, 0 m/s2, -9 m/s2]\n"
                     "grains:\n"
                     "  - material: ore\n    count: 50\n" SIZES REGION STAGES,
                NULL);
    clod_state s;
    build(from, &s);
    assert_true(s.domain.min[2] == -1e-3 && s.domain.max[1] == 30e-3);
    assert_true(s.domain.periodic[0] && s.domain.periodic[1] && !s.domain.periodic[2]);
    assert_true(s.gravity[0] == 1.0 && s.gravity[2] == -9.0);
    clod_state_fini(&s);
    clod_case_destroy(&from);
}

/** A case whose grains are in a file, with what follows the grains. */
static clod_case *load_with_file(const char *rows, const char *rest)
{
    char path[] = P_tmpdir "/clod-state-XXXXXX";
    const int file = mkstemp(path);
    assert_true(file >= 0);
    assert_true(write(file, rows, strlen(rows)) == (ssize_t)strlen(rows));
    close(file);
    char text[2048];
    snprintf(text, sizeof text, "%sgrains:\n  - {material: ore, file: %s}\n%s%s", HEAD, path,
             rest, STAGES);
    return case_of(text, NULL);
}

static void end_with_file(clod_case **from)
{
    remove((*from)->grains[0].file);
    clod_case_destroy(from);
}

// By hand: hooke, m = 8.37758e-6 kg, k = 1e5 N/m; two grains swing on half their mass: T = 2 pi
// sqrt(4.18879e-6/1e5) = 4.06653e-5 s; the step is 0.1 T/pi.
static void step_of_free_grains_by_hand(void **state)
{
    (void)state;
    clod_case *from = load_with_file("x [m],y [m],z [m],r [m]\n0,0,0.5,1e-3\n", "");
    clod_state s;
    build(from, &s);
    check_relative(s.dt, 0.1 * 4.06653e-5 / 3.14159265358979, 1e-5);
    clod_timestep t;
    clod_status status = {0};
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    assert_true(t.step == s.dt && t.rayleigh == 0.0);
    clod_state_fini(&s);
    end_with_file(&from);
}

// By hand: hooke, k = 1e5 N/m, 1 mm ore of m = 8.37758e-6 kg, one steel ball of 5 mm and 8000
// kg/m3, M = 4.18879e-3 kg. No pair is shorter than ore on ore, m/2: 4.06653e-5 s. With 1000
// times k between ore and steel that pair is: m M/(m + M) = 8.36086e-6 kg, T = 1.81679e-6 s.
static void each_material_has_its_own_grains(void **state)
{
    (void)state;
    clod_case *from = case_of(
        "materials:\n"
        "  ore: {density: 2000 kg/m3}\n"
        "  steel: {density: 8000 kg/m3}\n"
        "contacts:\n"
        "  default: {law: hooke, k1: 1e5 N/m, friction: 0}\n"
        "  ore-steel: {k1: 1e8 N/m}\n"
        "  steel-steel: {k1: 1e12 N/m}\n" // only one ball: it meets none like it
        "grains:\n"
        "  - material: ore\n    count: 50\n" SIZES REGION "  - material: steel\n    count: 1\n"
        "    radius: {distribution: uniform, min: 5 mm, max: 5 mm}\n" REGION STAGES,
        NULL);
    clod_state s;
    build(from, &s);
    check_relative(s.dt, 0.1 * 1.81679e-6 / 3.14159265358979, 1e-5);
    from->pairs[1].k1 = from->pairs[1].k2 = from->pairs[2].k1 = from->pairs[2].k2 = 1e5;
    clod_timestep t;
    clod_status status = {0};
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    check_relative(t.period, 4.06653e-5, 1e-5);
    assert_true(t.radius_a == 1e-3 && t.radius_b == 1e-3);
    clod_state_fini(&s);
    clod_case_destroy(&from);
}

// By hand: a grain 0.5 m above a floor, g = 9.80665, moving at 1 m/s sideways: it meets the
// floor at most at 1 + sqrt(2 g 0.5) = 4.13156 m/s; with hooke all energy of m/2 v^2 goes into
// k d^2/2: d = v sqrt(m/k) = 4.13156 * 9.15291e-6 = 3.78158e-5 m.
static void impact_of_a_fall_by_hand(void **state)
{
    (void)state;
    clod_case *from = load_with_file(
        "x [m],y [m],z [m],r [m],vx [m/s]\n0,0,0.5,1e-3,1\n",
        "gravity: [0 m/s2, 0 m/s2, -9.80665 m/s2]\n"
        "walls: {floor: {material: steel, shapes: [{plane: {point: [0 m, 0 m, 0 m]}}]}}\n");
    clod_state s;
    build(from, &s);
    clod_timestep t;
    clod_status status = {0};
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    assert_true(t.wall);
    check_relative(t.overlap, 3.78158e-5, 1e-5);
    clod_state_fini(&s);
    end_with_file(&from);
}

// By hand: the load goes from 10 to 3600 N/m2 in a later stage; on 0.01 m2 with 2000 kg and g =
// 10 that is 36 N + 20000 N, and a contact carries 2.0036e6 Pa * (2 mm)^2 = 8.0144 N: d
// = 8.0144e-5 m. A fall through 2 mm at 0.2 m/s has d = 0.2 * 9.15291e-6 m, as above.
static void largest_load_of_all_stages_counts(void **state)
{
    (void)state;
    clod_case *from =
        load_with_file("x [m],y [m],z [m],r [m]\n0,0,1e-3,1e-3\n",
                       "gravity: [0 m/s2, 0 m/s2, -10 m/s2]\n"
                       "walls: {lid: {material: steel,"
                       " shapes: [{disc: {center: [0 m, 0 m, 2 mm], radius: 1 mm}}],"
                       " load: {stress: 10 Pa, area: 0.01 m2, mass: 2000 kg}}}\n");
    clod_case_wall_change change = {.name = "lid", .has_stress = true, .stress = 3600.0};
    from->stages[0].walls = &change;
    from->stages[0].wall_count = 1;
    clod_state s;
    build(from, &s);
    clod_timestep t;
    clod_status status = {0};
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    check_relative(t.overlap, 8.0144e-5, 1e-12);
    s.walls.wall[0].mass = 0.0;
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    check_relative(t.overlap, 0.2 * 9.15291e-6, 1e-5);
    from->time.design_stress = 5600.0; // takes the place of loads and falls
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    check_relative(t.overlap, 5600.0 * 4e-6 / 1e5, 1e-12);
    s.gravity[2] = 0.0; // no fall, no weight: 3600 Pa
    from->time.design_stress = 0.0;
    assert_true(clod_setup_timestep(from, &s, &t, &status));
    check_relative(t.overlap, 3600.0 * 4e-6 / 1e5, 1e-12);
    assert_true(s.walls.wall[0].damping > 0.0);
    clod_state_fini(&s);
    from->stages[0].walls = NULL;
    from->stages[0].wall_count = 0;
    end_with_file(&from);
}

// By hand: 1-2 overlap by 0.1 mm directly, 2-3 by 0.5 mm through the period of 10 mm in x.
static void worst_overlap_is_named_with_its_pair(void **state)
{
    (void)state;
    clod_case *from = load_with_file(
        "id,x [m],y [m],z [m],r [m]\n11,7.6e-3,5e-3,5e-3,1e-3\n12,9.5e-3,5e-3,5e-3,1e-3\n13,2e-"
        "3,5e-3,5e-3,2e-3\n",
        "domain: {min: [0 m, 0 m, 0 m], max: [10 mm, 10 mm, 10 mm],"
        " periodic: [true, false, false]}\n");
    clod_state s;
    build(from, &s);
    clod_setup_overlap worst;
    clod_status status = {0};
    assert_true(clod_setup_worst_overlap(&s, &worst, &status));
    assert_int_equal(worst.id_a, 12);
    assert_int_equal(worst.id_b, 13);
    check_close(worst.overlap, 0.5e-3, 1e-15);
    check_close(worst.ratio, 0.5, 1e-12);
    clod_state_fini(&s);
    end_with_file(&from);
}

static void id_twice_is_refused(void **state)
{
    (void)state;
    clod_case *from = load_with_file(
        "id,x [m],y [m],z [m],r [m]\n4,0,0,0,1e-3\n5,1,0,0,1e-3\n4,2,0,0,1e-3\n", "");
    clod_state s;
    clod_status status = {0};
    assert_false(clod_setup_state(from, 1, &s, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "grains: the id 4 belongs to two grains"));
    clod_state_fini(&s);
    end_with_file(&from);
}

// By hand: a disc tilted by atan(3/4) about y reaches 2 * 0.8 in x, 2 in y and 2 * 0.6 in z.
static void bounds_of_a_tilted_disc(void **state)
{
    (void)state;
    clod_shape disc = {.kind = CLOD_SHAPE_DISC,
                       .center = {1.0, 1.0, 1.0},
                       .axis = {{0.8, 0.0, -0.6}, {0.0, 1.0, 0.0}, {0.6, 0.0, 0.8}},
                       .outer = 2.0};
    clod_wall wall = {.shape_count = 1, .shapes = &disc};
    const clod_state s = {.walls = {.count = 1, .wall = &wall}};
    double low[3], high[3];
    assert_true(clod_setup_bounds(&s, low, high));
    check_close(low[0], 1.0 - 1.6, 1e-14);
    check_close(high[1], 3.0, 1e-14);
    check_close(high[2], 1.0 + 1.2, 1e-14);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_by_count_mass_and_fill_height),
        cmocka_unit_test(domain_is_generous_when_not_given),
        cmocka_unit_test(given_domain_is_taken),
        cmocka_unit_test(step_of_free_grains_by_hand),
        cmocka_unit_test(each_material_has_its_own_grains),
        cmocka_unit_test(impact_of_a_fall_by_hand),
        cmocka_unit_test(largest_load_of_all_stages_counts),
        cmocka_unit_test(worst_overlap_is_named_with_its_pair),
        cmocka_unit_test(id_twice_is_refused),
        cmocka_unit_test(bounds_of_a_tilted_disc),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
