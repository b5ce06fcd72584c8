// Random insertion: every grain in its place by brute force, and the same bits for a seed.

#include <stdio.h>
#include <string.h>

#include "geometry/wall_gap.h"
#include "setup/insertion.h"
#include "setup/walls.h"
#include "support/check.h"

/** A group of grains and the state it goes into. */
typedef struct scene {
    clod_state state;
    clod_case_region region;
    clod_sizes sizes;
    clod_insertion what;
    clod_status status;
} scene;

static void scene_init(scene *s, size_t count, double radius_min, double radius_max)
{
    memset(s, 0, sizeof *s);
    const clod_case_grains from = {
        .sizes = CLOD_SIZE_UNIFORM, .radius_min = radius_min, .radius_max = radius_max};
    assert_true(clod_sizes_init(&s->sizes, &from, &s->status));
    s->what = (clod_insertion){.name = "grains[0]",
                               .region = &s->region,
                               .sizes = &s->sizes,
                               .seed = 1,
                               .first_id = 1,
                               .count = count,
                               .density = 2500.0,
                               .velocity = {0.0, 0.0, -0.5}};
}

static void scene_box(scene *s, double x, double y, double z)
{
    s->region.kind = CLOD_REGION_BOX;
    s->region.max[0] = x;
    s->region.max[1] = y;
    s->region.max[2] = z;
}

/** Shortest image of a distance along one axis. */
static double shortest(const clod_domain *domain, int axis, double d)
{
    const double period = domain->max[axis] - domain->min[axis];
    return domain->periodic[axis] ? d - period * round(d / period) : d;
}

/** No two grains overlap: every pair, minimum image. */
static void assert_apart(const clod_state *state)
{
    const clod_grains *g = &state->grains;
    for (size_t i = 0; i < g->count; i++) {
        for (size_t j = i + 1; j < g->count; j++) {
            double square = 0.0;
            for (int a = 0; a < 3; a++) {
                const double d =
                    shortest(&state->domain, a, g->position[i][a] - g->position[j][a]);
                square += d * d;
            }
            const double reach = g->position[i][3] + g->position[j][3];
            assert_true(square >= reach * reach);
        }
    }
}

static void assert_in_box(const scene *s)
{
    for (size_t i = 0; i < s->state.grains.count; i++) {
        const double *p = s->state.grains.position[i];
        for (int a = 0; a < 3; a++) {
            const double r = s->state.domain.periodic[a] ? 0.0 : p[3];
            assert_true(p[a] - r >= s->region.min[a] && p[a] + r <= s->region.max[a]);
        }
    }
}

static void assert_put(scene *s)
{
    if (!clod_insert_region(&s->state, &s->what, &s->status)) {
        fail_msg("%s", s->status.text);
    }
    assert_int_equal(s->state.grains.count, s->what.count);
}

static void box_holds_all_grains_apart(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 3000, 0.5e-3, 1.5e-3);
    scene_box(&s, 40e-3, 40e-3, 40e-3); // about 0.25 of it is solid
    assert_put(&s);
    assert_apart(&s.state);
    assert_in_box(&s);
    const clod_grains *g = &s.state.grains;
    for (size_t i = 0; i < g->count; i++) { // in order of id, with the radius of the id
        assert_int_equal(g->id[i], i + 1);
        assert_true(g->position[i][3] == clod_sizes_radius(&s.sizes, 1, i + 1));
        assert_true(g->velocity[i][2] == -0.5);
    }
    clod_state_fini(&s.state);
}

// Uniform in the box: the mean of each coordinate of N grains is within 4 sd of the middle, sd
// = width/sqrt(12 N), width about that of the box without the grains' radii.
static void places_are_uniform(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 2000, 0.1e-3, 0.1e-3);
    scene_box(&s, 40e-3, 20e-3, 30e-3);
    assert_put(&s);
    for (int a = 0; a < 3; a++) {
        double mean = 0.0;
        for (size_t i = 0; i < 2000; i++) {
            mean += s.state.grains.position[i][a] / 2000.0;
        }
        const double width = s.region.max[a];
        check_close(mean, 0.5 * width, 4.0 * width / sqrt(12.0 * 2000.0));
    }
    clod_state_fini(&s.state);
}

static void same_seed_gives_the_same_bits_and_another_does_not(void **state)
{
    (void)state;
    scene s[3];
    for (int k = 0; k < 3; k++) {
        scene_init(&s[k], 500, 0.5e-3, 1.5e-3);
        scene_box(&s[k], 30e-3, 30e-3, 30e-3);
        s[k].what.seed = k < 2 ? 11 : 12;
        assert_put(&s[k]);
    }
    const size_t bytes = 500 * sizeof *s[0].state.grains.position;
    assert_memory_equal(s[0].state.grains.position, s[1].state.grains.position, bytes);
    assert_true(memcmp(s[0].state.grains.position, s[2].state.grains.position, bytes) != 0);
    for (int k = 0; k < 3; k++) {
        clod_state_fini(&s[k].state);
    }
}

static void periodic_box_uses_the_room_at_its_border(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 600, 1e-3, 1.5e-3);
    scene_box(&s, 20e-3, 20e-3, 60e-3);
    s.state.domain =
        (clod_domain){.max = {20e-3, 20e-3, 60e-3}, .periodic = {true, true, false}};
    assert_put(&s);
    assert_apart(&s.state);
    assert_in_box(&s);
    int at_border = 0;
    for (size_t i = 0; i < 600; i++) {
        at_border += s.state.grains.position[i][0] < s.state.grains.position[i][3];
    }
    assert_true(at_border > 10);
    clod_state_fini(&s.state);
}

// Too dense for random places: 0.42 of the box is solid.
static void dense_box_is_filled_in_layers(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 800, 0.95e-3, 1e-3);
    scene_box(&s, 20e-3, 20e-3, 18e-3);
    assert_put(&s);
    assert_apart(&s.state);
    assert_in_box(&s);
    clod_state_fini(&s.state);
}

static void dense_cylinder_and_annulus_are_filled_in_layers(void **state)
{
    (void)state;
    for (int hole = 0; hole < 2; hole++) {
        scene s;
        scene_init(&s, hole ? 900 : 1000, 0.95e-3, 1e-3);
        s.region = (clod_case_region){.kind = CLOD_REGION_ANNULUS,
                                      .center = {1e-3, 2e-3, 3e-3},
                                      .inner_radius = hole ? 4e-3 : 0.0,
                                      .outer_radius = 12e-3,
                                      .height = 24e-3};
        assert_put(&s);
        assert_apart(&s.state);
        for (size_t i = 0; i < s.what.count; i++) {
            const double *p = s.state.grains.position[i];
            const double rho = hypot(p[0] - 1e-3, p[1] - 2e-3);
            assert_true(rho + p[3] <= 12e-3 && (!hole || rho - p[3] >= 4e-3));
            assert_true(p[2] - p[3] >= 3e-3 && p[2] + p[3] <= 27e-3);
        }
        clod_state_fini(&s.state);
    }
}

static void too_many_grains_are_refused_with_counts(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 1001, 1e-3, 1e-3);
    scene_box(&s, 20e-3, 20e-3, 20.1e-3); // 10 x 10 x 10 touching spheres, not one more
    assert_false(clod_insert_region(&s.state, &s.what, &s.status));
    assert_int_equal(s.status.code, CLOD_USAGE);
    assert_non_null(strstr(s.status.text, "grains[0]: only "));
    assert_non_null(strstr(s.status.text, " of 1001 grains fit into the region (box"));
    assert_int_equal(s.state.grains.count, 0);
    clod_state_fini(&s.state);
}

// A hopper in the box: grains only inside of the cone, whose radius at z is 8 mm + z/2, and
// with the other side only outside. Written as half spaces of the plane through axis and grain.
static void grains_stay_on_their_side_of_a_cone(void **state)
{
    (void)state;
    for (int side = 0; side < 2; side++) {
        scene s;
        scene_init(&s, 200, 0.5e-3, 1.5e-3);
        scene_box(&s, 40e-3, 40e-3, 40e-3);
        clod_shape cone = {.kind = CLOD_SHAPE_CONE,
                           .center = {20e-3, 20e-3, -2e-3},
                           .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                           .outer = 7e-3,
                           .inner = 29e-3,
                           .half = {0.0, 0.0, 22e-3},
                           .side = (clod_side)side};
        clod_wall wall = {.spin_axis = {0.0, 0.0, 1.0}, .shape_count = 1, .shapes = &cone};
        s.state.walls = (clod_walls){.count = 1, .wall = &wall};
        assert_put(&s);
        assert_int_equal(s.state.grains.count, 200);
        const double outwards = side == CLOD_SIDE_INSIDE ? -1.0 : 1.0;
        for (size_t i = 0; i < 200; i++) {
            const double *p = s.state.grains.position[i];
            const double rho = hypot(p[0] - 20e-3, p[1] - 20e-3);
            const double across = (rho - 8e-3 - 0.5 * p[2]) / sqrt(1.25);
            assert_true(outwards * across >= p[3] - 1e-15);
        }
        s.state.walls = (clod_walls){0};
        clod_state_fini(&s.state);
    }
}

// A second group, among walls: a box in the middle, a shell whose inside counts, and the grains
// of the first group.
static void groups_keep_clear_of_walls_and_of_each_other(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 400, 0.5e-3, 1.5e-3);
    scene_box(&s, 40e-3, 40e-3, 40e-3);
    clod_shape shapes[2] = {
        {.kind = CLOD_SHAPE_BOX,
         .center = {20e-3, 20e-3, 20e-3},
         .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
         .half = {6e-3, 6e-3, 6e-3}},
        {.kind = CLOD_SHAPE_CYLINDER,
         .center = {20e-3, 20e-3, -1e-3},
         .axis = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
         .outer = 18e-3,
         .half = {0.0, 0.0, 25e-3},
         .side = CLOD_SIDE_INSIDE},
    };
    clod_wall wall = {.spin_axis = {0.0, 0.0, 1.0}, .shape_count = 2, .shapes = shapes};
    s.state.walls = (clod_walls){.count = 1, .wall = &wall};
    assert_put(&s);
    s.what.first_id = 401;
    assert_true(clod_insert_region(&s.state, &s.what, &s.status));
    assert_int_equal(s.state.grains.count, 800);
    assert_apart(&s.state);
    for (size_t i = 0; i < 800; i++) {
        const double *p = s.state.grains.position[i];
        const clod_vec3 at = {p[0], p[1], p[2]};
        assert_true(clod_wall_gap(&shapes[0], at).distance >= p[3]);
        assert_true(hypot(p[0] - 20e-3, p[1] - 20e-3) + p[3] <= 18e-3);
    }
    s.state.walls = (clod_walls){0};
    clod_state_fini(&s.state);
}

// Radii 1 : 20; large grains find room since they are put first.
static void very_different_sizes_fit(void **state)
{
    (void)state;
    scene s;
    clod_case_sieve rows[] = {{0.4e-3, 0.0}, {1e-3, 0.3}, {8e-3, 1.0}};
    scene_init(&s, 3000, 1e-3, 1e-3);
    const clod_case_grains from = {.sizes = CLOD_SIZE_SIEVE, .sieve = rows, .sieve_count = 3};
    assert_true(clod_sizes_init(&s.sizes, &from, &s.status));
    scene_box(&s, 17e-3, 17e-3, 17e-3);
    assert_put(&s);
    assert_apart(&s.state);
    assert_in_box(&s);
    clod_sizes_fini(&s.sizes);
    clod_state_fini(&s.state);
}

// The column of the ring shear cell without bars. Its solid fraction is that of grains put at
// random quickly, 0.25 to 0.35.
static void column_rises_until_all_grains_are_in(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 3000, 2.85e-3, 3.49e-3);
    s.region = (clod_case_region){
        .kind = CLOD_REGION_ANNULUS, .inner_radius = 50e-3, .outer_radius = 100e-3};
    double height = 0.0;
    assert_true(clod_insert_annulus_column(&s.state, &s.what, &height, &s.status));
    assert_int_equal(s.state.grains.count, 3000);
    assert_apart(&s.state);
    double top = 0.0;
    double volume = 0.0;
    for (size_t i = 0; i < 3000; i++) {
        const double *p = s.state.grains.position[i];
        const double rho = hypot(p[0], p[1]);
        assert_true(rho - p[3] >= 50e-3 && rho + p[3] <= 100e-3 && p[2] >= p[3]);
        top = fmax(top, p[2] + p[3]);
        volume += 4.0 / 3.0 * M_PI * p[3] * p[3] * p[3];
    }
    assert_true(height == top);
    const double fraction = volume / (M_PI * (0.01 - 0.0025) * height);
    check_at_least(fraction, 0.25);
    check_at_most(fraction, 0.35);
    clod_state_fini(&s.state);
}

static void column_without_room_is_refused(void **state)
{
    (void)state;
    scene s;
    scene_init(&s, 10, 30e-3, 30e-3);
    s.region = (clod_case_region){
        .kind = CLOD_REGION_ANNULUS, .inner_radius = 50e-3, .outer_radius = 100e-3};
    double height = 0.0;
    assert_false(clod_insert_annulus_column(&s.state, &s.what, &height, &s.status));
    // grains of 60 mm between circles that are 50 mm apart
    assert_non_null(strstr(
        s.status.text,
        "is 50 mm thick, no thicker than a grain with its clearance: the largest has 60 mm"));
    clod_state_fini(&s.state);
}

/**
 * A slab of 20.1 mm takes grains of 20 mm. One of 19.9 mm takes none, nor does one of 20 mm, where a
 * grain would touch both faces: places are chosen for grains larger by their clearance of 1e-6.
 */
static void a_region_no_thicker_than_a_grain_is_named(void **state)
{
    (void)state;
    const double thick[] = {19.9, 20.0, 20.1};
    for (int t = 0; t < 3; t++) {
        scene s;
        scene_init(&s, 3, 10e-3, 10e-3);
        s.what.name = "grains.0";
        scene_box(&s, 0.1, 0.1, 1e-3 * thick[t]);
        assert_int_equal(clod_insert_region(&s.state, &s.what, &s.status), t == 2);
        if (t < 2) {
            char told[256];
            snprintf(told, sizeof told,
                     "grains.0.region: is %g mm thick, no thicker than a grain with its "
                     "clearance: the largest has 20 mm, and grains lie whole in it. Make it "
                     "thicker, as a rule several grains",
                     thick[t]);
            assert_string_equal(s.status.text, told);
        }
        clod_state_fini(&s.state);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_holds_all_grains_apart),
        cmocka_unit_test(places_are_uniform),
        cmocka_unit_test(same_seed_gives_the_same_bits_and_another_does_not),
        cmocka_unit_test(periodic_box_uses_the_room_at_its_border),
        cmocka_unit_test(dense_box_is_filled_in_layers),
        cmocka_unit_test(dense_cylinder_and_annulus_are_filled_in_layers),
        cmocka_unit_test(too_many_grains_are_refused_with_counts),
        cmocka_unit_test(grains_stay_on_their_side_of_a_cone),
        cmocka_unit_test(groups_keep_clear_of_walls_and_of_each_other),
        cmocka_unit_test(very_different_sizes_fit),
        cmocka_unit_test(column_rises_until_all_grains_are_in),
        cmocka_unit_test(column_without_room_is_refused),
        cmocka_unit_test(a_region_no_thicker_than_a_grain_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
