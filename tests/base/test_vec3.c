// Vectors and rotations by their defining properties.

#include "base/vec3.h"
#include "support/check.h"
#include "support/dice.h"

static clod_vec3 random_vector(dice *roll)
{
    return (clod_vec3){dice_real(roll, -3.0, 3.0), dice_real(roll, -3.0, 3.0),
                       dice_real(roll, -3.0, 3.0)};
}

static void check_same(clod_vec3 a, double x, double y, double z)
{
    check_close(a.x, x, 1e-14);
    check_close(a.y, y, 1e-14);
    check_close(a.z, z, 1e-14);
}

static void sums_and_products(void **state)
{
    (void)state;
    const clod_vec3 a = {1.0, 2.0, 3.0};
    const clod_vec3 b = {4.0, -5.0, 6.0};
    check_same(clod_vec3_add(a, b), 5.0, -3.0, 9.0);
    check_same(clod_vec3_sub(a, b), -3.0, 7.0, -3.0);
    check_same(clod_vec3_scale(a, -2.0), -2.0, -4.0, -6.0);
    check_same(clod_vec3_axpy(a, 2.0, b), 9.0, -8.0, 15.0);
    check_same(clod_vec3_cross(a, b), 27.0, 6.0, -13.0);
    check_close(clod_vec3_dot(a, b), 12.0, 0.0);
    check_close(clod_vec3_length((clod_vec3){2.0, 3.0, 6.0}), 7.0, 1e-15);
    check_same(clod_vec3_unit((clod_vec3){0.0, -2.0, 0.0}), 0.0, -1.0, 0.0);
}

static void a_quarter_turn_about_each_axis(void **state)
{
    (void)state;
    const clod_vec3 x = {1.0, 0.0, 0.0}, y = {0.0, 1.0, 0.0}, z = {0.0, 0.0, 1.0};
    check_same(clod_vec3_rotate(y, x, 0.5 * M_PI), 0.0, 0.0, 1.0);
    check_same(clod_vec3_rotate(z, y, 0.5 * M_PI), 1.0, 0.0, 0.0);
    check_same(clod_vec3_rotate(x, z, 0.5 * M_PI), 0.0, 1.0, 0.0);
    check_same(clod_vec3_rotate(x, z, -0.5 * M_PI), 0.0, -1.0, 0.0);
}

/** Lengths, angles and the axis stay; two turns add up. */
static void rotations_are_rigid(void **state)
{
    (void)state;
    dice roll = {1};
    for (int k = 0; k < 1000; k++) {
        const clod_vec3 axis = clod_vec3_unit(random_vector(&roll));
        const clod_vec3 a = random_vector(&roll);
        const clod_vec3 b = random_vector(&roll);
        const double angle = dice_real(&roll, -4.0, 4.0);
        const double more = dice_real(&roll, -4.0, 4.0);
        const clod_vec3 ra = clod_vec3_rotate(a, axis, angle);
        const clod_vec3 rb = clod_vec3_rotate(b, axis, angle);
        check_close(clod_vec3_dot(ra, rb), clod_vec3_dot(a, b), 1e-13);
        check_close(clod_vec3_dot(ra, axis), clod_vec3_dot(a, axis), 1e-13);
        const clod_vec3 twice = clod_vec3_rotate(ra, axis, more);
        const clod_vec3 once = clod_vec3_rotate(a, axis, angle + more);
        check_same(clod_vec3_sub(twice, once), 0.0, 0.0, 0.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_and_products),
        cmocka_unit_test(a_quarter_turn_about_each_axis),
        cmocka_unit_test(rotations_are_rigid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
