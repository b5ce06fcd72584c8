// Grains, walls and whole states: growing, copying, wall kinematics.

#include <string.h>

#include "support/bed.h"
#include "support/bits.h"

/** Rows survive growth; two padding rows behind the last one touch nothing. */
static void grains_grow_and_stay(void **state)
{
    (void)state;
    clod_status status;
    clod_grains g = {0};
    for (uint64_t k = 0; k < 1000; k++) {
        const double x = (double)k;
        assert_true(clod_grains_add(&g, (double[4]){x, x + 0.25, -x, 0.5},
                                    (double[3]){2.0 * x, 1.0, 3.0}, (double[3]){x, 5.0, 6.0},
                                    1000.0, (uint16_t)(k % 7), 1000 + k, &status));
        assert_true(g.capacity >= g.count + 2);
        assert_int_equal((uintptr_t)g.position % 32, 0);
        for (size_t p = g.count; p < g.count + 2; p++) {
            assert_true(g.position[p][3] < 0.0 && g.velocity[p][3] > 0.0 &&
                        g.angular_velocity[p][3] > 0.0);
        }
        assert_true(g.position[g.count][0] !=
                    g.position[g.count + 1][0]); // no distance of zero
    }
    for (size_t k = 0; k < 1000; k++) {
        const double x = (double)k;
        assert_true(g.position[k][0] == x && g.position[k][1] == x + 0.25 &&
                    g.position[k][2] == -x);
        assert_true(g.velocity[k][0] == 2.0 * x && g.angular_velocity[k][0] == x);
        assert_true(g.id[k] == 1000 + k && g.material[k] == k % 7);
        check_relative(g.velocity[k][3], 1000.0 * M_PI / 6.0, 1e-15); // sphere of 1 m
    }
    clod_grains_fini(&g);
    assert_null(g.position);
    assert_int_equal(g.count, 0);
}

static void a_copy_is_deep(void **state)
{
    (void)state;
    clod_status status;
    scene s;
    clod_state copy = {0};
    bed_init(&s, BED_DRUM, 5);
    scene_start(&s);
    scene_run(&s, 1500);
    assert_true(clod_step_export(&s.step, &status));
    assert_true(s.state.contact_count > 0);
    assert_true(clod_state_copy(&copy, &s.state, &status));
    check_same_bits(&copy, &s.state);
    const size_t n = copy.grains.count;
    assert_memory_equal(copy.build_position, s.state.build_position,
                        n * sizeof *copy.build_position);
    assert_memory_equal(copy.build_walls, s.state.build_walls, 3 * sizeof *copy.build_walls);
    assert_string_equal(copy.walls.wall[2].name, "lid");
    assert_int_equal(copy.walls.wall[1].shape_count, 2);
    assert_true(copy.walls.wall[1].shapes != s.state.walls.wall[1].shapes);
    assert_memory_equal(copy.walls.wall[1].shapes, s.state.walls.wall[1].shapes,
                        2 * sizeof(clod_shape));
    const double x = copy.grains.position[3][0];
    scene_run(&s, 500); // the original goes on, the copy stays
    assert_true(copy.grains.position[3][0] == x && copy.step == 1500);
    scene_end(&s);
    assert_true(copy.grains.position[3][0] == x);
    clod_state_fini(&copy);
}

static void an_empty_state_can_be_copied(void **state)
{
    (void)state;
    clod_status status;
    const clod_state empty = {.dt = 2.0, .build_motion = -1.0};
    clod_state copy;
    assert_true(clod_state_copy(&copy, &empty, &status));
    assert_true(copy.dt == 2.0 && copy.grains.count == 0 && copy.contacts == NULL);
    clod_state_fini(&copy);
}

/** v = velocity + servo along its axis + spin x arm, by hand; belts are beside it. */
static void velocity_of_a_wall_at_a_point(void **state)
{
    (void)state;
    clod_wall wall = {.velocity = {1.0, 2.0, 3.0},
                      .surface_velocity = {0.5, 0.0, 0.0},
                      .spin = 2.0,
                      .spin_axis = {0.0, 0.0, 1.0},
                      .spin_point = {1.0, 0.0, 0.0},
                      .shift = {0.0, 1.0, 0.0},
                      .load_axis = {0.0, 0.0, -1.0},
                      .servo_velocity = 0.25};
    // arm (2, 3, 4) - (1, 1, 0) = (1, 2, 4); 2 z x arm = (-4, 2, 0)
    const clod_vec3 v = clod_wall_velocity_at(&wall, (clod_vec3){2.0, 3.0, 4.0});
    check_close(v.x, 1.0 - 4.0, 1e-15);
    check_close(v.y, 2.0 + 2.0, 1e-15);
    check_close(v.z, 3.0 - 0.25, 1e-15);
}

/** The bound holds for points all over shapes that turn, and is not wasteful for boxes. */
static void the_speed_bound_holds_for_every_point(void **state)
{
    (void)state;
    dice roll = {2};
    for (int k = 0; k < 200; k++) {
        double axis[3], normal[3];
        dice_direction(&roll, axis);
        dice_direction(&roll, normal);
        clod_shape shape = shape_along(CLOD_SHAPE_BOX, (clod_vec3){0.3, -0.2, 0.1},
                                       (clod_vec3){normal[0], normal[1], normal[2]});
        const clod_shape_kind kinds[] = {CLOD_SHAPE_BOX, CLOD_SHAPE_DISC, CLOD_SHAPE_CYLINDER};
        shape.kind = kinds[k % 3];
        shape.outer = 0.2;
        memcpy(shape.half, (double[3]){0.1, 0.2, 0.3}, sizeof shape.half);
        clod_wall wall = {.velocity = {0.1, 0.0, 0.2},
                          .spin = dice_real(&roll, -3.0, 3.0),
                          .spin_axis = {axis[0], axis[1], axis[2]},
                          .spin_point = {0.5, 0.5, 0.0},
                          .load_axis = {0.0, 0.0, 1.0},
                          .servo_velocity = -0.3,
                          .shape_count = 1,
                          .shapes = &shape};
        const double bound = clod_wall_speed_bound(&wall);
        double most = 0.0;
        for (int p = 0; p < 500; p++) {
            double l[3] = {dice_real(&roll, -0.1, 0.1), dice_real(&roll, -0.2, 0.2),
                           dice_real(&roll, -0.3, 0.3)};
            if (shape.kind != CLOD_SHAPE_BOX) { // the rim; a cylinder stands on its foot
                const double turn = dice_real(&roll, -M_PI, M_PI);
                l[0] = 0.2 * cos(turn);
                l[1] = 0.2 * sin(turn);
                l[2] = shape.kind == CLOD_SHAPE_DISC ? 0.0 : dice_real(&roll, 0.0, 0.6);
            }
            clod_vec3 point = shape.center;
            for (int a = 0; a < 3; a++) {
                point = clod_vec3_axpy(point, l[a], shape.axis[a]);
            }
            most = fmax(most, clod_vec3_length(clod_wall_velocity_at(&wall, point)));
        }
        check_at_least(bound, most);
        check_at_most(bound, 0.53 + fabs(wall.spin) * 1.5); // nothing is 1.5 m off the axis
    }
}

/** A symmetric shape goes nowhere by turning; a belt's surface does not move the shape. */
static void what_does_not_move_does_not_count(void **state)
{
    (void)state;
    clod_shape drum = shape_drum(0.0, 1.0, 1.0);
    const clod_wall wall = {.spin = 100.0,
                            .spin_axis = {0.0, 0.0, 1.0},
                            .surface_velocity = {9.0, 0.0, 0.0},
                            .shape_count = 1,
                            .shapes = &drum};
    check_close(clod_wall_speed_bound(&wall), 0.0, 0.0);
}

static void sums_start_anew(void **state)
{
    (void)state;
    clod_wall wall = {.force = {1.0, 2.0, 3.0},
                      .sum_steps = 9,
                      .sum_force = {1.0, 1.0, 1.0},
                      .sum_torque = {1.0, 1.0, 1.0},
                      .sum_power = 4.0};
    clod_walls walls = {1, &wall};
    clod_walls_reset_sums(&walls);
    assert_int_equal(wall.sum_steps, 0);
    check_close(clod_vec3_length(wall.sum_force), 0.0, 0.0);
    check_close(clod_vec3_length(wall.sum_torque), 0.0, 0.0);
    check_close(wall.sum_power, 0.0, 0.0);
    check_close(wall.force.z, 3.0, 0.0); // the last step's force stays
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grains_grow_and_stay),
        cmocka_unit_test(a_copy_is_deep),
        cmocka_unit_test(an_empty_state_can_be_copied),
        cmocka_unit_test(velocity_of_a_wall_at_a_point),
        cmocka_unit_test(the_speed_bound_holds_for_every_point),
        cmocka_unit_test(what_does_not_move_does_not_count),
        cmocka_unit_test(sums_start_anew),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
