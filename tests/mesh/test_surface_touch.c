// Contacts of a grain with a mesh: each place once, whatever the tessellation.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/touching.h"
#include "support/dice.h"

#define SMOOTH (20.0 * M_PI / 180.0)

/** The surface of what was made. */
static clod_surface *surface_of(const maker *made)
{
    return maker_surface(made, SMOOTH);
}

/** Contacts of a grain; their hits. */
static int contacts_of(const clod_surface *surface, clod_vec3 p, double radius,
                       const clod_surface_hit *contact[8])
{
    static touching found;
    touching_near(&found, surface, p, 1.3 * radius);
    const int contacts = touching_find(&found, p, radius);
    assert_true(contacts <= 8);
    memcpy(contact, found.contact, (size_t)contacts * sizeof *contact);
    return contacts;
}

/** A quadrilateral of two facets. */
static void quad(maker *made, const float a[3], const float b[3], const float c[3],
                 const float d[3])
{
    maker_add(made, a, b, c);
    maker_add(made, a, c, d);
}

/** The square [-1, 1] x [-1, 1] at z = 0, in n by m pieces. */
static void square(maker *made, int n, int m)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < m; j++) {
            const float x0 = -1.0f + 2.0f * (float)i / (float)n;
            const float x1 = -1.0f + 2.0f * (float)(i + 1) / (float)n;
            const float y0 = -1.0f + 2.0f * (float)j / (float)m;
            const float y1 = -1.0f + 2.0f * (float)(j + 1) / (float)m;
            quad(made, (float[3]){x0, y0, 0}, (float[3]){x1, y0, 0}, (float[3]){x1, y1, 0},
                 (float[3]){x0, y1, 0});
        }
    }
}

/** One contact with direction z and the height as distance, wherever the grain is. */
static void expect_plane(const clod_surface *surface, double radius)
{
    for (int k = 0; k < 400; k++) {
        const double x = 0.6 * sin(0.37 * k), y = 0.6 * cos(0.71 * k);
        const double z = (k % 2 == 0 ? 0.999 : -0.99) * radius;
        const clod_surface_hit *contact[8];
        assert_int_equal(contacts_of(surface, (clod_vec3){x, y, z}, radius, contact), 1);
        check_close(contact[0]->at.distance, fabs(z), 1e-15);
        check_close(contact[0]->at.direction.z, z > 0.0 ? 1.0 : -1.0, 1e-15);
        check_close(contact[0]->at.direction.x, 0.0, 1e-15);
    }
}

static void a_plane_is_one_contact_however_it_is_cut(void **state)
{
    (void)state;
    static const int CUTS[][2] = {{1, 1}, {10, 10}, {3, 7}, {10000, 1}};
    for (size_t k = 0; k < 4; k++) {
        maker *made = maker_new();
        square(made, CUTS[k][0], CUTS[k][1]);
        clod_surface *surface = surface_of(made);
        assert_int_equal(surface->plane_count, 1);
        assert_int_equal(surface->patch_count, 1);
        expect_plane(surface, k < 3 ? 0.2 : 0.02);
        clod_surface_release(surface);
    }
}

/** A place of the square, turned about two axes, as floats have it. */
static void turned(const double axes[3][3], double x, double y, float to[3])
{
    for (int a = 0; a < 3; a++) {
        to[a] = (float)(x * axes[0][a] + y * axes[1][a]);
    }
}

/** The square of n x m parts, each of the columns of which may be cut at other places: T-junctions. */
static void turned_square(maker *made, const double axes[3][3], int n, int m, bool random)
{
    dice roll = {3};
    for (int i = 0; i < n; i++) {
        const double x[2] = {-1.0 + 2.0 * i / n, -1.0 + 2.0 * (i + 1) / n};
        double below = -1.0;
        for (int j = 0; j < m; j++) {
            const double step = random ? dice_real(&roll, 0.2, 0.8) : 0.0;
            const double above = j + 1 == m ? 1.0 : -1.0 + 2.0 * (j + 0.5 + step) / m;
            const double to = random ? above : -1.0 + 2.0 * (j + 1) / m;
            float corner[4][3];
            turned(axes, x[0], below, corner[0]);
            turned(axes, x[1], below, corner[1]);
            turned(axes, x[1], to, corner[2]);
            turned(axes, x[0], to, corner[3]);
            quad(made, corner[0], corner[1], corner[2], corner[3]);
            below = to;
        }
    }
}

/** A plane whose corners floats do not hold exactly is where it is, however it is cut: a sliver of 0.2 mm turns
 *  by 3e-4 with the last digit of a float, all of them together by 6e-8. */
static void a_plane_aslant_is_where_it_is_however_it_is_cut(void **state)
{
    (void)state;
    const double c = cos(35.0 * M_PI / 180.0), s = sin(35.0 * M_PI / 180.0);
    const double d = cos(19.0 * M_PI / 180.0), t = sin(19.0 * M_PI / 180.0);
    const double axes[3][3] = {{c, s * t, -s * d}, {0.0, d, t}, {s, -c * t, c * d}};
    static const int CUTS[][2] = {{1, 1}, {10, 10}, {10000, 1}, {1, 10000}, {20, 10}};
    for (size_t k = 0; k < sizeof CUTS / sizeof *CUTS; k++) {
        maker *made = maker_new();
        turned_square(made, axes, CUTS[k][0], CUTS[k][1], k == 4);
        clod_surface *surface = surface_of(made);
        assert_int_equal(surface->patch_count, 1);
        for (int g = 0; g < 400; g++) {
            const double x = 0.6 * sin(0.37 * g), y = 0.6 * cos(0.71 * g), z = 0.0199;
            const clod_vec3 p = {x * axes[0][0] + y * axes[1][0] + z * axes[2][0],
                                 x * axes[0][1] + y * axes[1][1] + z * axes[2][1],
                                 x * axes[0][2] + y * axes[1][2] + z * axes[2][2]};
            const clod_surface_hit *contact[8];
            assert_int_equal(contacts_of(surface, p, 0.02, contact), 1);
            check_close(contact[0]->at.distance, z, 1e-6);
            check_close(contact[0]->at.direction.x, axes[2][0], 1e-6);
            check_close(contact[0]->at.direction.y, axes[2][1], 1e-6);
            check_close(contact[0]->at.direction.z, axes[2][2], 1e-6);
        }
        clod_surface_release(surface);
    }
}

/** Left half in one column, right half in five: four T-junctions on the line x = 0. */
static void t_junctions_are_seams(void **state)
{
    (void)state;
    maker *made = maker_new();
    quad(made, (float[3]){-1, -1, 0}, (float[3]){0, -1, 0}, (float[3]){0, 1, 0},
         (float[3]){-1, 1, 0});
    for (int j = 0; j < 5; j++) {
        const float y0 = -1.0f + 0.4f * (float)j, y1 = -1.0f + 0.4f * (float)(j + 1);
        quad(made, (float[3]){0, y0, 0}, (float[3]){1, y0, 0}, (float[3]){1, y1, 0},
             (float[3]){0, y1, 0});
    }
    clod_surface *surface = surface_of(made);
    expect_plane(surface, 0.2);
    for (int k = 0; k <= 100; k++) { // along the line itself
        const clod_surface_hit *contact[8];
        const clod_vec3 p = {0.0, -0.7 + 0.014 * k, 0.19};
        assert_int_equal(contacts_of(surface, p, 0.2, contact), 1);
        check_close(contact[0]->at.distance, 0.19, 1e-15);
    }
    clod_surface_release(surface);
}

/** Two planes that meet at the y axis: z = -slope |x| (a ridge), or z = slope |x|. */
static clod_surface *roof(float slope)
{
    maker *made = maker_new();
    const float z = -slope;
    quad(made, (float[3]){-1, -1, z}, (float[3]){0, -1, 0}, (float[3]){0, 1, 0},
         (float[3]){-1, 1, z});
    quad(made, (float[3]){0, -1, 0}, (float[3]){1, -1, z}, (float[3]){1, 1, z},
         (float[3]){0, 1, 0});
    return surface_of(made);
}

/** Over a ridge of 90 deg there is one contact; its distance is that of the convex edge. */
static void a_ridge_pushes_once(void **state)
{
    (void)state;
    clod_surface *surface = roof(1.0f);
    assert_int_equal(surface->patch_count, 2);
    for (int k = 0; k <= 200; k++) {
        const double angle = (-80.0 + 0.8 * k) * M_PI / 180.0; // from straight above
        const clod_vec3 p = {0.19 * sin(angle), 0.013, 0.19 * cos(angle)};
        const double over = fabs(angle) - M_PI / 4.0;
        const double expected = over > 0.0 ? 0.19 * cos(over) : 0.19;
        const clod_surface_hit *contact[8];
        assert_int_equal(contacts_of(surface, p, 0.2, contact), 1);
        check_close(contact[0]->at.distance, expected, 1e-15);
    }
    clod_surface_release(surface);
}

/** In a V each side pushes with its own full overlap; the same facets seen from below. */
static void a_groove_pushes_from_each_side(void **state)
{
    (void)state;
    clod_surface *surface = roof(-1.0f);
    for (int k = 0; k <= 100; k++) {
        const double x = 1e-4 * (k - 50);
        const double z = 0.198 * sqrt(2.0);
        const clod_surface_hit *contact[8];
        const int sides = 0.198 + fabs(x) / sqrt(2.0) < 0.2 ? 2 : 1;
        assert_int_equal(contacts_of(surface, (clod_vec3){x, 0.3, z}, 0.2, contact), sides);
        check_close(contact[0]->at.distance, (z - fabs(x)) / sqrt(2.0), 1e-15);
    }
    clod_surface_release(surface);
}

/** A box with the corners (0, 0, 0) and (1, 1, t). */
static clod_surface *box(float t)
{
    maker *made = maker_new();
    const float p[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                           {0, 0, t}, {1, 0, t}, {1, 1, t}, {0, 1, t}};
    static const int FACES[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                    {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
    for (int f = 0; f < 6; f++) {
        quad(made, p[FACES[f][0]], p[FACES[f][1]], p[FACES[f][2]], p[FACES[f][3]]);
    }
    return surface_of(made);
}

static void corners_of_a_box(void **state)
{
    (void)state;
    clod_surface *surface = box(1.0f);
    const clod_surface_hit *contact[8];
    // within: three faces
    assert_int_equal(contacts_of(surface, (clod_vec3){0.19, 0.195, 0.18}, 0.2, contact), 3);
    check_close(contact[0]->at.distance, 0.18, 1e-15);
    check_close(contact[1]->at.distance, 0.19, 1e-15);
    check_close(contact[2]->at.distance, 0.195, 1e-15);
    // outside: the corner
    assert_int_equal(contacts_of(surface, (clod_vec3){-0.1, -0.11, -0.12}, 0.2, contact), 1);
    check_close(contact[0]->at.distance, sqrt(0.01 + 0.0121 + 0.0144), 1e-15);
    // outside: an edge
    assert_int_equal(contacts_of(surface, (clod_vec3){-0.1, 0.5, -0.12}, 0.2, contact), 1);
    check_close(contact[0]->at.distance, sqrt(0.01 + 0.0144), 1e-15);
    clod_surface_release(surface);
}

/** The far side of a plate thinner than the overlap does not count. */
static void a_thin_plate_pushes_once(void **state)
{
    (void)state;
    clod_surface *surface = box(0.001f);
    const clod_surface_hit *contact[8];
    for (int side = 0; side < 2; side++) {
        const double z = side == 0 ? 0.001 + 0.195 : -0.195;
        assert_int_equal(contacts_of(surface, (clod_vec3){0.5, 0.4, z}, 0.2, contact), 1);
        check_close(contact[0]->at.distance, 0.195, 1e-9); // 0.001 is a float
    }
    clod_surface_release(surface);
}

/** A grain over a slit rests on both rims, although they are of one plane. */
static void a_slit_pushes_from_both_rims(void **state)
{
    (void)state;
    maker *made = maker_new();
    quad(made, (float[3]){-1, -1, 0}, (float[3]){-0.125, -1, 0}, (float[3]){-0.125, 1, 0},
         (float[3]){-1, 1, 0});
    quad(made, (float[3]){0.125, -1, 0}, (float[3]){1, -1, 0}, (float[3]){1, 1, 0},
         (float[3]){0.125, 1, 0});
    quad(made, (float[3]){-1, 1, 0}, (float[3]){-0.125, 1, 0}, (float[3]){-0.125, 2, 0},
         (float[3]){-1, 2, 0});
    quad(made, (float[3]){-0.125, 1, 0}, (float[3]){0.125, 1, 0}, (float[3]){0.125, 2, 0},
         (float[3]){-0.125, 2, 0});
    quad(made, (float[3]){0.125, 1, 0}, (float[3]){1, 1, 0}, (float[3]){1, 2, 0},
         (float[3]){0.125, 2, 0});
    clod_surface *surface = surface_of(made);
    assert_int_equal(surface->patch_count, 1);
    const clod_surface_hit *contact[8];
    assert_int_equal(contacts_of(surface, (clod_vec3){0.001, 0.0, 0.15}, 0.2, contact), 2);
    assert_int_not_equal(contact[0]->slot, contact[1]->slot);
    check_close(contact[0]->at.distance, hypot(0.124, 0.15), 1e-15);
    check_close(contact[1]->at.distance, hypot(0.126, 0.15), 1e-15);
    clod_surface_release(surface);
}

/** Over a hole of six sides: of those seen in one quarter of the plane the nearest pushes, so four
 *  do (adr/0033, slots). */
static void a_hole_pushes_from_each_quarter(void **state)
{
    (void)state;
    maker *made = maker_new();
    for (int k = 0; k < 6; k++) {
        const double a = M_PI / 3.0 * k, b = M_PI / 3.0 * (k + 1);
        const float xa = (float)cos(a), ya = (float)sin(a), xb = (float)cos(b),
                    yb = (float)sin(b);
        quad(made, (float[3]){0.1f * xa, 0.1f * ya, 0}, (float[3]){xa, ya, 0},
             (float[3]){xb, yb, 0}, (float[3]){0.1f * xb, 0.1f * yb, 0});
    }
    clod_surface *surface = surface_of(made);
    assert_int_equal(surface->patch_count, 1);
    const clod_surface_hit *contact[8];
    const clod_vec3 p = {0.0011, 0.0007, 0.15};
    assert_int_equal(contacts_of(surface, p, 0.2, contact), 4);
    for (int k = 0; k < 4; k++) {
        const double x = contact[k]->at.point.x, y = contact[k]->at.point.y;
        check_close(contact[k]->at.distance, hypot(hypot(x - p.x, y - p.y), p.z), 1e-12);
        for (int other = 0; other < k; other++) {
            assert_int_not_equal(contact[k]->slot, contact[other]->slot);
        }
    }
    clod_surface_release(surface);
}

/** In a pipe of 36 sides one contact, deepest at the nearest side; around it one too. */
static void a_pipe_is_smooth(void **state)
{
    (void)state;
    maker *made = maker_new();
    for (int k = 0; k < 36; k++) {
        const double a = 2.0 * M_PI * k / 36, b = 2.0 * M_PI * (k + 1) / 36;
        const float xa = (float)cos(a), ya = (float)sin(a);
        const float xb = (float)cos(b), yb = (float)sin(b);
        quad(made, (float[3]){xa, ya, 0}, (float[3]){xb, yb, 0}, (float[3]){xb, yb, 1},
             (float[3]){xa, ya, 1});
    }
    clod_surface *surface = surface_of(made);
    for (int k = 0; k < 1000; k++) {
        const double angle = 2.0 * M_PI * k / 1000;
        for (int out = 0; out < 2; out++) {
            const double rho = out ? 1.19 : 0.81;
            const clod_vec3 p = {rho * cos(angle), rho * sin(angle), 0.5};
            const clod_surface_hit *contact[8];
            assert_int_equal(contacts_of(surface, p, 0.2, contact), 1);
            const double side = 2.0 * M_PI / 36; // distance from the polygon's nearest side
            const double off = fabs(fmod(angle, side) - 0.5 * side);
            const double height = fabs(rho * cos(off) - cos(0.5 * side));
            if (out == 0) {
                check_close(contact[0]->at.distance, height, 1e-6);
            } else {
                assert_true(contact[0]->at.distance >= height - 1e-6);
            }
        }
    }
    clod_surface_release(surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_is_one_contact_however_it_is_cut),
        cmocka_unit_test(a_plane_aslant_is_where_it_is_however_it_is_cut),
        cmocka_unit_test(t_junctions_are_seams),
        cmocka_unit_test(a_ridge_pushes_once),
        cmocka_unit_test(a_groove_pushes_from_each_side),
        cmocka_unit_test(corners_of_a_box),
        cmocka_unit_test(a_thin_plate_pushes_once),
        cmocka_unit_test(a_slit_pushes_from_both_rims),
        cmocka_unit_test(a_hole_pushes_from_each_quarter),
        cmocka_unit_test(a_pipe_is_smooth),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
