// Sums of what grains do to the places of walls: closed forms of a slide and an impact, Finnie's
// function, and the same bits on any number of threads.

#include "base/memory.h"
#include "state/wear.h"
#include "step/kernel_rub.h"
#include "support/bed.h"

#define R 3e-3
#define G 9.81
#define MASS (2481.3 * 4.1887902047863905 * 27e-9)
#define K 2e4
#define DT 1e-5
#define MU 0.3

static clod_case_contact rough(double restitution)
{
    clod_case_contact contact = contact_elastic(1.0, K);
    contact.restitution = restitution;
    contact.friction = MU;
    return contact;
}

/** A floor with sums. */
static clod_wall *floor_with_sums(scene *s)
{
    clod_wall *wall = scene_wall(s, "floor", shape_floor(0.0));
    assert_true(clod_wear_begin(wall));
    assert_int_equal(wall->wear_places, 1);
    assert_int_equal(clod_wear_faces(wall), 1);
    return wall;
}

/** A grain too lazy to roll slides under its weight until friction has stopped it: v^2/(2 mu g). */
static void a_slide_wears_by_its_way(void **state)
{
    (void)state;
    scene s;
    const clod_case_contact contact = rough(0.3);
    scene_init(&s, DT, &contact);
    s.state.gravity[2] = -G;
    scene_grain(&s, 0.0, 0.0, R - MASS * G / K, R);
    s.state.grains.angular_velocity[0][3] = 1e-9; // 1/I: nothing turns it
    scene_move(&s, 0, 0.5, 0.0, 0.0);
    clod_wall *wall = floor_with_sums(&s);
    scene_start(&s);
    scene_run(&s, 10000); // 0.1 s, at 0.5 - 0.2943 m/s
    const double v = 0.5 - MU * G * 0.1, way = 0.5 * (0.5 + v) * 0.1;
    const double *sum = wall->wear[0];
    check_relative(sum[CLOD_WEAR_SLIDING], MASS * G * way, 1e-3);
    check_relative(sum[CLOD_WEAR_SHEAR], MU * MASS * G * way, 1e-3);
    check_relative(sum[CLOD_WEAR_SHEAR], 0.5 * MASS * (0.25 - v * v), 1e-3); // its energy
    check_relative(sum[CLOD_WEAR_IMPULSE], MASS * (0.5 - v), 1e-3);
    check_relative(sum[CLOD_WEAR_IMPULSE + 2], -MASS * G * 0.1, 1e-3);
    check_relative(sum[CLOD_WEAR_PRESS], MASS * G * 0.1, 1e-3);
    // the springs shorten and lengthen by what the overlap does; nothing comes down
    check_at_most(sum[CLOD_WEAR_CUTTING], 1e-3 * sum[CLOD_WEAR_SLIDING]);
    scene_end(&s);
}

/** An elastic grain without friction comes at 30 degrees: twice m v sin, one impact. */
static void an_impact_has_energy_and_angle(void **state)
{
    (void)state;
    scene s;
    clod_case_contact contact = rough(1.0);
    contact.friction = 0.0;
    scene_init(&s, 0.05 * DT, &contact); // forces meet velocities of half a step before
    scene_grain(&s, 0.0, 0.0, R + 1e-5, R);
    const double v = 0.4, angle = M_PI / 6.0;
    scene_move(&s, 0, v * cos(angle), 0.0, -v * sin(angle));
    clod_wall *wall = floor_with_sums(&s);
    scene_start(&s);
    scene_run(&s, 4000);
    const double *sum = wall->wear[0];
    const double mass = s.state.grains.velocity[0][3];
    const double energy = 0.5 * mass * pow(v * sin(angle), 2.0);
    check_at_least(s.state.grains.velocity[0][2], 0.0); // it is gone
    assert_true(sum[CLOD_WEAR_IMPACTS] == 1.0);
    check_relative(sum[CLOD_WEAR_ENERGY], energy, 1e-12);
    check_relative(sum[CLOD_WEAR_ANGLE], angle * energy, 1e-12);
    const double after = s.state.grains.velocity[0][2];
    check_relative(after, v * sin(angle), 1e-3);
    check_relative(sum[CLOD_WEAR_PRESS], mass * (v * sin(angle) + after), 1e-12);
    check_relative(sum[CLOD_WEAR_SQUEEZE], energy, 1e-2);
    // on the way in: 2 x integral F v f dt, where v falls from v sin to 0, along constant
    double cutting = 0.0;
    const int pieces = 100000;
    for (int k = 0; k < pieces; k++) { // F dt = m dv
        const double down = v * sin(angle) * (k + 0.5) / pieces, along = v * cos(angle);
        const double g = atan2(down, along);
        const double f =
            tan(g) < 1.0 / 3.0 ? sin(2.0 * g) - 3.0 * pow(sin(g), 2.0) : pow(cos(g), 2.0) / 3.0;
        cutting += 2.0 * mass * v * sin(angle) / pieces * hypot(down, along) * f;
    }
    check_relative(sum[CLOD_WEAR_CUTTING], cutting, 1e-2);
    scene_end(&s);
}

/** sin 2g - 3 sin2 g and cos2 g/3: at 10, 30 and 90 degrees, and where they meet. */
static void finnies_function(void **state)
{
    (void)state;
    const double ten = M_PI / 18.0;
    check_close(kernel_rub_finnie(sin(ten), cos(ten)),
                sin(2.0 * ten) - 3.0 * sin(ten) * sin(ten), 1e-15);
    check_close(kernel_rub_finnie(0.5, sqrt(0.75)), 0.25, 1e-15);
    check_close(kernel_rub_finnie(1.0, 0.0), 0.0, 0.0);
    check_close(kernel_rub_finnie(0.0, 1.0), 0.0, 0.0);
    check_close(kernel_rub_finnie(1.0 - 1e-12, 3.0), 0.3, 1e-11);
    check_close(kernel_rub_finnie(1.0 + 1e-12, 3.0), 0.3, 1e-11);
}

/** Two shapes are two surfaces; what they feel together is what the wall feels, with the same bits on any
 *  number of threads and in all vectors. */
static void places_add_up_to_the_wall(void **state)
{
    (void)state;
    static const char *const SETS[] = {"scalar", "avx2", "avx512", "neon"};
    double kept[2][CLOD_WEAR_SUMS];
    for (int run = 0; run < 8; run++) {
        const char *set = SETS[run / 2];
        if (clod_kernel_choose(set) == NULL) { // not on this processor
            continue;
        }
        scene s;
        const clod_case_contact contact = rough(0.3);
        scene_init(&s, DT, &contact);
        s.state.gravity[2] = -G;
        for (int g = 0; g < 40; g++) {
            const size_t row = scene_grain(&s, (g % 8 - 3.6) * 2.2 * R, g / 8 * 2.2 * R, R, R);
            scene_move(&s, row, 0.3 - 0.02 * g, 0.01 * g, 0.0);
        }
        clod_wall *wall =
            scene_wall(&s, "floor", shape_box((clod_vec3){-0.1, 0.0, -0.1}, 0.1, 0.1, 0.1));
        wall->shapes = clod_memory_grow(wall->shapes, 1, 2, sizeof *wall->shapes);
        wall->shapes[1] = shape_box((clod_vec3){0.1, 0.0, -0.1}, 0.1, 0.1, 0.1);
        wall->shape_count = 2;
        assert_true(clod_wear_begin(wall));
        scene_start_with(&s, (clod_step_options){.threads = 1 + run % 2, .simd = set});
        scene_run(&s, 4000);
        for (int k = 0; k < 3; k++) {
            const double together =
                wall->wear[0][CLOD_WEAR_IMPULSE + k] + wall->wear[1][CLOD_WEAR_IMPULSE + k];
            const double felt = DT * (&wall->sum_force.x)[k];
            check_close(together, felt, 1e-11);
        }
        check_at_least(wall->wear[0][CLOD_WEAR_SLIDING], 1e-6);
        check_at_least(wall->wear[1][CLOD_WEAR_SLIDING], 1e-6);
        check_at_least(wall->wear[0][CLOD_WEAR_CUTTING], 1e-9);
        if (run == 0) {
            memcpy(kept, wall->wear, sizeof kept);
        }
        assert_memory_equal(kept, wall->wear, sizeof kept);
        char name[64];
        clod_wear_name(wall, 1, name, sizeof name);
        assert_string_equal(name, "floor.2");
        scene_end(&s);
    }
}

static void areas(void **state)
{
    (void)state;
    clod_shape shapes[] = {shape_box((clod_vec3){0.0, 0.0, 0.0}, 0.5, 1.0, 1.5),
                           shape_drum(0.0, 0.2, 0.7), shape_hopper(0.0, 0.1, 0.4, 0.4),
                           shape_floor(0.0)};
    const clod_wall wall = {.shapes = shapes, .shape_count = 4};
    check_close(clod_wear_area(&wall, 0, 0), 2.0 * (2.0 + 6.0 + 3.0), 1e-14); // 1 x 2 x 3 m
    check_close(clod_wear_area(&wall, 1, 1), 2.0 * M_PI * 0.2 * 0.7, 1e-14);
    check_close(clod_wear_area(&wall, 2, 2), M_PI * 0.5 * 0.5, 1e-14); // slant of 3, 4, 5
    assert_true(clod_wear_area(&wall, 3, 3) == 0.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slide_wears_by_its_way),
        cmocka_unit_test(an_impact_has_energy_and_angle),
        cmocka_unit_test(finnies_function),
        cmocka_unit_test(places_add_up_to_the_wall),
        cmocka_unit_test(areas),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
