// Facets that stand for a cylinder: the closest points of a half tube, by its closed form.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/touching.h"
#include "support/dice.h"

#define SIDES 40 ///< over half the circle
#define LENGTH 2.0

/** The upper half of a tube of radius 1 about the x axis, from x = 0 to 2.
 */
static clod_surface *half_tube(void)
{
    maker *made = maker_new();
    for (int k = 0; k < SIDES; k++) {
        float corner[4][3];
        for (int c = 0; c < 4; c++) {
            const double a = M_PI * (k + (c == 1 || c == 2)) / SIDES;
            corner[c][0] = c < 2 ? 0.0f : (float)LENGTH;
            corner[c][1] = (float)cos(a);
            corner[c][2] = (float)sin(a);
        }
        maker_add(made, corner[0], corner[2], corner[1]);
        maker_add(made, corner[0], corner[3], corner[2]);
    }
    clod_surface *surface = maker_surface(made, 0.35);
    const clod_surface_cylinder cylinder = {{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}, 1.0};
    assert_true(clod_surface_make_round(surface, 0, &cylinder));
    return surface;
}

/** Distance from the half tube [m]: to its round, or to one of its two straight edges. */
static double distance_of(const double p[3])
{
    const double x = fmin(fmax(p[0], 0.0), LENGTH) - p[0];
    const double round = hypot(p[1], p[2]) - 1.0;
    const double edge = hypot(fabs(p[1]) - 1.0, p[2]);
    return hypot(x, p[2] >= 0.0 ? round : edge);
}

/** Corners are numbers of single precision. */
#define ROUNDING 2e-7

static void the_closest_point_is_on_the_circle(void **state)
{
    (void)state;
    clod_surface *surface = half_tube();
    dice roll = {3};
    int inside = 0, beyond = 0;
    for (int k = 0; k < 20000; k++) {
        const double a = dice_real(&roll, -0.3, M_PI + 0.3), r = dice_real(&roll, 0.8, 1.2);
        const double p[3] = {dice_real(&roll, -0.2, 2.2), r * cos(a), r * sin(a)};
        double found = INFINITY;
        for (uint32_t patch = 0; patch < surface->patch_count; patch++) {
            const clod_surface_closest at =
                clod_surface_patch_closest(surface, patch, clod_vec3_of(p), 1.0);
            if (at.distance < found) {
                found = at.distance;
                const clod_vec3 way = clod_vec3_sub(clod_vec3_of(p), at.point);
                check_close(clod_vec3_length(way), at.distance, 1e-12);
                check_close(clod_vec3_dot(way, at.direction), at.distance, 1e-12);
            }
        }
        check_close(found, distance_of(p), ROUNDING);
        inside += r < 1.0;
        beyond += p[0] < 0.0 || p[0] > LENGTH || p[2] < 0.0;
    }
    assert_true(inside > 5000 && beyond > 5000);
    clod_surface_release(surface);
}

/** A grain on it, outside or inside, has one contact, along the radius. */
static void a_grain_has_one_contact_along_the_radius(void **state)
{
    (void)state;
    clod_surface *surface = half_tube();
    dice roll = {4};
    for (int k = 0; k < 5000; k++) {
        const double radius = 0.1, overlap = 1e-6 * dice_real(&roll, 1.0, 1000.0);
        const double a = dice_real(&roll, 0.2, M_PI - 0.2);
        const double side = dice_pick(&roll, 2) == 0 ? 1.0 : -1.0;
        const double r = 1.0 + side * (radius - overlap);
        const clod_vec3 out = {0.0, cos(a), sin(a)};
        const clod_vec3 p = clod_vec3_axpy((clod_vec3){1.0, 0.0, 0.0}, r, out);
        static touching found;
        touching_near(&found, surface, p, radius);
        assert_int_equal(touching_find(&found, p, radius), 1);
        const clod_surface_closest *at = &found.contact[0]->at;
        check_close(at->distance, radius - overlap, ROUNDING);
        // where a corner stands out by its rounding, it is nearer than the circle beside it
        check_close(side * clod_vec3_dot(at->direction, out), 1.0, ROUNDING / radius);
    }
    clod_surface_release(surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_closest_point_is_on_the_circle),
        cmocka_unit_test(a_grain_has_one_contact_along_the_radius),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
