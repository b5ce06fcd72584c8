/**
 * @file test_camera.c
 * The camera against hand calculation: where points come to lie, and that all is in the picture.
 */

#include "picture/camera.h"

#include "support/check.h"

#define RIGHT_ANGLE (0.5 * M_PI)

/** 90 degrees from bottom to top: at distance 2 the picture reaches 2 up and, twice as wide, 4 to
 *  the sides. */
static void points_lie_where_rays_hit_the_picture(void **state)
{
    (void)state;
    const clod_camera camera = clod_camera_make((clod_vec3){1.0, -3.0, 2.0},
                                                (clod_vec3){0.0, 5.0, 0.0}, RIGHT_ANGLE, 2.0);
    double x, y;
    check_close(clod_camera_project(&camera, (clod_vec3){1.0, -1.0, 2.0}, &x, &y), 2.0, 1e-12);
    check_close(x, 0.0, 1e-12);
    check_close(y, 0.0, 1e-12);
    clod_camera_project(&camera, (clod_vec3){3.0, -1.0, 3.0}, &x, &y);
    check_close(x, 0.5, 1e-12); // 2 to the right of 4
    check_close(y, 0.5, 1e-12); // 1 up of 2
    assert_true(clod_camera_project(&camera, (clod_vec3){1.0, -4.0, 2.0}, &x, &y) < 0.0);
}

/** From above y points up in the picture and x to the right. */
static void from_above_y_is_up(void **state)
{
    (void)state;
    const clod_camera camera = clod_camera_make((clod_vec3){0.0, 0.0, 5.0},
                                                (clod_vec3){0.0, 0.0, -1.0}, RIGHT_ANGLE, 1.0);
    double x, y;
    clod_camera_project(&camera, (clod_vec3){1.0, 2.0, 0.0}, &x, &y);
    check_close(x, 0.2, 1e-12);
    check_close(y, 0.4, 1e-12);
}

/** Seen from -x (looking along +x), +y is at the left. */
static void axes_are_right_handed(void **state)
{
    (void)state;
    const clod_camera camera = clod_camera_make((clod_vec3){-5.0, 0.0, 0.0},
                                                (clod_vec3){1.0, 0.0, 0.0}, RIGHT_ANGLE, 1.0);
    double x, y;
    clod_camera_project(&camera, (clod_vec3){0.0, 1.0, 0.0}, &x, &y);
    check_close(x, -0.2, 1e-12);
}

/**
 * A sphere of radius 1 fills the picture of 60 degrees from a distance of 1 / sin 30 = 2: the
 * edge of the picture touches it.
 */
static void fit_touches_a_sphere(void **state)
{
    (void)state;
    clod_camera camera = clod_camera_make((clod_vec3){9.0, 9.0, 9.0},
                                          (clod_vec3){0.0, 1.0, 0.0}, M_PI / 3.0, 1.5);
    clod_camera_bounds bounds = CLOD_CAMERA_BOUNDS_NONE;
    clod_camera_bound(&camera, &bounds, (clod_vec3){0.3, 0.4, 0.5}, 1.0);
    clod_camera_fit(&camera, &bounds);
    check_close(camera.eye.x, 0.3, 1e-12);
    check_close(camera.eye.y, 0.4 - 2.0, 1e-12);
    check_close(camera.eye.z, 0.5, 1e-12);
}

/** Points: all inside, at least two edges reached, whatever the direction. */
static void fit_shows_all_points_and_wastes_nothing(void **state)
{
    (void)state;
    for (int turn = 0; turn < 24; turn++) {
        const double a = turn * M_PI / 12.0;
        clod_camera camera =
            clod_camera_make((clod_vec3){0.0, 0.0, 0.0}, (clod_vec3){cos(a), sin(a), -0.4},
                             0.4 + 0.05 * turn, turn % 2 == 0 ? 1.6 : 0.7);
        clod_camera_bounds bounds = CLOD_CAMERA_BOUNDS_NONE;
        for (int pass = 0; pass < 2; pass++) {
            double most = 0.0;
            for (int k = 0; k < 200; k++) { // points of a curve all over a box
                const clod_vec3 point = {sin(3.0 * k), 2.0 + 3.0 * sin(5.0 * k),
                                         0.5 * sin(7.0 * k + 1.0)};
                double x, y;
                if (pass == 0) {
                    clod_camera_bound(&camera, &bounds, point, 0.0);
                } else {
                    assert_true(clod_camera_project(&camera, point, &x, &y) > 0.0);
                    most = fmax(most, fmax(fabs(x), fabs(y)));
                }
            }
            if (pass == 0) {
                clod_camera_fit(&camera, &bounds);
            } else {
                check_close(most, 1.0, 1e-9);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_lie_where_rays_hit_the_picture),
        cmocka_unit_test(from_above_y_is_up),
        cmocka_unit_test(axes_are_right_handed),
        cmocka_unit_test(fit_touches_a_sphere),
        cmocka_unit_test(fit_shows_all_points_and_wastes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
