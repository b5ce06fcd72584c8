// Walls of a case made ready, numbers by hand.

#include <string.h>

#include "setup/walls.h"
#include "support/check.h"

static clod_case_material material = {.name = "steel", .density = 7800.0};

/** One wall named "w" at rest. */
static clod_case_wall make_wall(clod_case_shape *shapes, size_t count)
{
    return (clod_case_wall){.name = "w",
                            .material = "steel",
                            .shapes = shapes,
                            .shape_count = count,
                            .spin_axis = {0.0, 0.0, 2.0},
                            .load_axis = {0.0, 0.0, -1.0}};
}

static clod_case make_case(clod_case_wall *wall)
{
    return (clod_case){
        .materials = &material, .material_count = 1, .walls = wall, .wall_count = 1};
}

static void build(clod_case_wall *wall, clod_walls *walls)
{
    const clod_case from = make_case(wall);
    clod_status status = {0};
    if (!clod_setup_walls(&from, walls, &status)) {
        fail_msg("%s", status.text);
    }
}

static void check_vector(clod_vec3 v, double x, double y, double z)
{
    check_close(v.x, x, 1e-15);
    check_close(v.y, y, 1e-15);
    check_close(v.z, z, 1e-15);
}

/** The axes of a shape are a right-handed orthonormal frame. */
static void check_frame(const clod_shape *s)
{
    const clod_vec3 third = clod_vec3_cross(s->axis[0], s->axis[1]);
    check_vector(clod_vec3_sub(third, s->axis[2]), 0.0, 0.0, 0.0);
    check_close(clod_vec3_length(s->axis[0]), 1.0, 1e-15);
    check_close(clod_vec3_dot(s->axis[0], s->axis[1]), 0.0, 1e-15);
}

// By hand: from (1, 1, 1) to (1, 5, 4) the line is 5 long along (0, 0.8, 0.6); `up` = z without
// its part along the line is (0, -0.6, 0.8).
static void bar_becomes_a_box_along_its_line(void **state)
{
    (void)state;
    clod_case_shape bar = {.kind = CLOD_SHAPE_BAR,
                           .from = {1.0, 1.0, 1.0},
                           .to = {1.0, 5.0, 4.0},
                           .width = 0.5,
                           .height = 0.25,
                           .up = {0.0, 0.0, 3.0}};
    clod_case_wall wall = make_wall(&bar, 1);
    clod_walls walls;
    build(&wall, &walls);
    const clod_shape *s = &walls.wall[0].shapes[0];
    check_vector(s->center, 1.0, 3.0, 2.5);
    check_vector(s->axis[0], 0.0, 0.8, 0.6);
    check_vector(s->axis[2], 0.0, -0.6, 0.8);
    check_frame(s);
    check_close(s->half[0], 2.5, 1e-15);
    check_close(s->half[1], 0.25, 1e-15);
    check_close(s->half[2], 0.125, 1e-15);
    assert_false(s->symmetric);
    clod_walls_fini(&walls);
}

static void shapes_get_unit_axes_and_their_sizes(void **state)
{
    (void)state;
    clod_case_shape shapes[4] = {
        {.kind = CLOD_SHAPE_PLANE, .normal = {0.0, 3.0, 4.0}},
        {.kind = CLOD_SHAPE_CYLINDER,
         .axis = {0.0, 0.0, -2.0},
         .radius = 3.0,
         .length = 5.0,
         .side = CLOD_SIDE_OUTSIDE},
        {.kind = CLOD_SHAPE_ANNULUS,
         .normal = {1.0, 1.0, 0.0},
         .inner_radius = 1.0,
         .outer_radius = 2.0},
        {.kind = CLOD_SHAPE_BOX, .point = {1.0, 2.0, 3.0}, .size = {2.0, 4.0, 6.0}},
    };
    clod_case_wall wall = make_wall(shapes, 4);
    clod_walls walls;
    build(&wall, &walls);
    const clod_shape *s = walls.wall[0].shapes;
    check_vector(s[0].axis[2], 0.0, 0.6, 0.8);
    check_vector(s[1].axis[2], 0.0, 0.0, -1.0);
    assert_true(s[1].outer == 3.0 && s[1].half[2] == 2.5 && s[1].side == CLOD_SIDE_OUTSIDE);
    assert_true(s[2].inner == 1.0 && s[2].outer == 2.0);
    assert_true(s[3].half[0] == 1.0 && s[3].half[1] == 2.0 && s[3].half[2] == 3.0);
    for (int k = 0; k < 4; k++) {
        check_frame(&s[k]);
    }
    check_vector(walls.wall[0].spin_axis, 0.0, 0.0, 1.0);
    clod_walls_fini(&walls);
}

static void only_shapes_about_the_spin_axis_are_symmetric(void **state)
{
    (void)state;
    clod_case_shape shapes[6] = {
        {.kind = CLOD_SHAPE_ANNULUS,
         .point = {1.0, 2.0, 9.0},
         .normal = {0.0, 0.0, -1.0},
         .outer_radius = 1.0},
        {.kind = CLOD_SHAPE_ANNULUS,
         .point = {1.1, 2.0, 9.0},
         .normal = {0.0, 0.0, 1.0},
         .outer_radius = 1.0},
        {.kind = CLOD_SHAPE_DISC,
         .point = {1.0, 2.0, 9.0},
         .normal = {0.0, 0.1, 1.0},
         .radius = 1.0},
        {.kind = CLOD_SHAPE_PLANE, .point = {7.0, 7.0, 7.0}, .normal = {0.0, 0.0, 1.0}},
        {.kind = CLOD_SHAPE_CYLINDER,
         .point = {1.0, 2.0, -5.0},
         .axis = {0.0, 0.0, 1.0},
         .radius = 1.0,
         .length = 1.0},
        {.kind = CLOD_SHAPE_BOX, .point = {1.0, 2.0, 0.0}, .size = {1.0, 1.0, 1.0}},
    };
    clod_case_wall wall = make_wall(shapes, 6);
    wall.spin_point[0] = 1.0;
    wall.spin_point[1] = 2.0;
    clod_walls walls;
    build(&wall, &walls);
    const bool expected[6] = {true, false, false, true, true, false};
    for (int k = 0; k < 6; k++) {
        assert_int_equal(walls.wall[0].shapes[k].symmetric, expected[k]);
    }
    clod_walls_fini(&walls);
}

// By hand: 2 kPa on 3 m2 is 6 kN; a disc of radius 2 seen along its normal has 4 pi m2.
static void loads_become_newtons(void **state)
{
    (void)state;
    clod_case_shape disc = {.kind = CLOD_SHAPE_DISC, .normal = {0.0, 0.0, -1.0}, .radius = 2.0};
    clod_case_wall wall = make_wall(&disc, 1);
    wall.load = CLOD_LOAD_STRESS;
    wall.stress = 2e3;
    wall.area = 3.0;
    wall.mass = 5.0;
    clod_walls walls;
    build(&wall, &walls);
    assert_true(walls.wall[0].load_force == 6e3 && walls.wall[0].mass == 5.0);
    clod_walls_fini(&walls);
    wall.load = CLOD_LOAD_FORCE;
    wall.force = 7.0;
    wall.area = 0.0;
    build(&wall, &walls);
    assert_true(walls.wall[0].load_force == 7.0);
    check_relative(walls.wall[0].area, 4.0 * M_PI, 1e-15);
    clod_walls_fini(&walls);
}

// By hand: z = 0.5, k = 8 N/m, m = 2 kg: 2 * 0.5 * sqrt(16) = 4 N s/m. Bed: 1 m2 over grains of
// diameter 0.1 m has 100 columns; 2 m high, 20 contacts each: 5 times one contact.
static void damping_and_bed_stiffness_by_hand(void **state)
{
    (void)state;
    clod_wall wall = {.mass = 2.0, .damping_fraction = 0.5};
    clod_setup_wall_damping(&wall, 8.0);
    check_close(wall.damping, 4.0, 1e-15);
    check_close(clod_setup_bed_stiffness(3.0, 1.0, 2.0, 0.05), 15.0, 1e-13);
}

static void plane_that_would_leave_itself_is_refused(void **state)
{
    (void)state;
    clod_case_shape plane = {.kind = CLOD_SHAPE_PLANE, .normal = {1.0, 0.0, 0.0}};
    clod_case_wall wall = make_wall(&plane, 1);
    clod_case_wall_change change = {.name = "w", .has_spin = true, .spin = 1.0};
    clod_case_stage stage = {.name = "turn", .walls = &change, .wall_count = 1};
    clod_case from = make_case(&wall);
    from.stages = &stage;
    from.stage_count = 1;
    clod_walls walls;
    clod_status status = {0};
    assert_false(clod_setup_walls(&from, &walls, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "walls.w.shapes.0: an endless plane can turn only"));
    clod_walls_fini(&walls);
    change.spin = 0.0;
    assert_true(clod_setup_walls(&from, &walls, &status));
    clod_walls_fini(&walls);
}

// By hand; the cone's foot is on the axis, the widest radius is that of its top.
static void cone_gets_its_radii(void **state)
{
    (void)state;
    clod_case_shape cone = {.kind = CLOD_SHAPE_CONE,
                            .point = {1.0, 2.0, 3.0},
                            .axis = {0.0, 0.0, -2.0},
                            .foot_radius = 0.0,
                            .top_radius = 3.0,
                            .length = 5.0,
                            .side = CLOD_SIDE_OUTSIDE};
    clod_case_wall wall = make_wall(&cone, 1);
    wall.spin_point[0] = 1.0;
    wall.spin_point[1] = 2.0;
    clod_walls walls;
    build(&wall, &walls);
    const clod_shape *s = &walls.wall[0].shapes[0];
    check_vector(s->center, 1.0, 2.0, 3.0);
    check_vector(s->axis[2], 0.0, 0.0, -1.0);
    check_frame(s);
    assert_true(s->outer == 0.0 && s->inner == 3.0 && s->half[2] == 2.5);
    assert_true(s->side == CLOD_SIDE_OUTSIDE && s->symmetric);
    clod_walls_fini(&walls);
}

// By hand: direction (0.6, 0, 0.8), amplitude 2 mm and 0.1 rad at 30 degrees: half of each; 25
// Hz is resolved by 0.8 ms, a 50th of 40 ms, and not by more.
static void oscillation_starts_at_its_phase(void **state)
{
    (void)state;
    clod_case_shape disc = {.kind = CLOD_SHAPE_DISC, .normal = {0.0, 0.0, 1.0}, .radius = 2.0};
    clod_case_wall wall = make_wall(&disc, 1);
    wall.oscillation = (clod_case_oscillation){.direction = {3.0, 0.0, 4.0},
                                               .amplitude = 2e-3,
                                               .angle = 0.1,
                                               .frequency = 25.0,
                                               .phase = M_PI / 6.0};
    clod_walls walls;
    build(&wall, &walls);
    check_vector(walls.wall[0].shift, 0.6e-3, 0.0, 0.8e-3);
    check_close(walls.wall[0].angle, 0.05, 1e-16);
    clod_status status = {0};
    assert_true(clod_setup_wall_pace(&walls, 0.79999e-3, &status));
    assert_false(clod_setup_wall_pace(&walls, 0.80001e-3, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "walls.w.oscillation.frequency: 25 Hz is too fast"));
    clod_walls_fini(&walls);
    wall.oscillation.frequency = 0.0;
    build(&wall, &walls);
    check_vector(walls.wall[0].shift, 0.0, 0.0, 0.0);
    assert_true(clod_setup_wall_pace(&walls, 1e9, &status));
    clod_walls_fini(&walls);
}

// A plane across the spin axis may swing about it, one along it would leave itself.
static void plane_that_would_swing_out_of_itself_is_refused(void **state)
{
    (void)state;
    clod_case_shape plane = {.kind = CLOD_SHAPE_PLANE, .normal = {1.0, 0.0, 0.0}};
    clod_case_wall wall = make_wall(&plane, 1);
    wall.oscillation = (clod_case_oscillation){.angle = 0.1, .frequency = 25.0};
    const clod_case from = make_case(&wall);
    clod_walls walls;
    clod_status status = {0};
    assert_false(clod_setup_walls(&from, &walls, &status));
    assert_non_null(strstr(status.text, "walls.w.shapes.0: an endless plane can turn only"));
    clod_walls_fini(&walls);
    plane.normal[0] = 0.0;
    plane.normal[2] = 1.0;
    assert_true(clod_setup_walls(&from, &walls, &status));
    clod_walls_fini(&walls);
}

static void long_name_is_refused(void **state)
{
    (void)state;
    clod_case_shape plane = {.kind = CLOD_SHAPE_PLANE, .normal = {1.0, 0.0, 0.0}};
    clod_case_wall wall = make_wall(&plane, 1);
    wall.name = "a_name_of_thirty_two_characters_";
    const clod_case from = make_case(&wall);
    clod_walls walls;
    clod_status status = {0};
    assert_false(clod_setup_walls(&from, &walls, &status));
    assert_non_null(strstr(status.text, "at most 31 characters"));
    clod_walls_fini(&walls);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bar_becomes_a_box_along_its_line),
        cmocka_unit_test(shapes_get_unit_axes_and_their_sizes),
        cmocka_unit_test(only_shapes_about_the_spin_axis_are_symmetric),
        cmocka_unit_test(loads_become_newtons),
        cmocka_unit_test(damping_and_bed_stiffness_by_hand),
        cmocka_unit_test(plane_that_would_leave_itself_is_refused),
        cmocka_unit_test(cone_gets_its_radii),
        cmocka_unit_test(oscillation_starts_at_its_phase),
        cmocka_unit_test(plane_that_would_swing_out_of_itself_is_refused),
        cmocka_unit_test(long_name_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
