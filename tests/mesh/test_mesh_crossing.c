// Facets that cut through each other: which are named, and which only touch.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "support/dice.h"

#define SIX 6        ///< facets of a random heap
#define MERIDIANS 16 ///< of a sphere
#define BANDS 9

/** A rotation about an axis that is none of the mesh's, so that no height is exactly zero. */
static void turn(const double from[3], bool aslant, float to[3])
{
    static const double ROWS[3][3] = {
        {0.36, 0.48, -0.8}, {-0.8, 0.6, 0.0}, {0.48, 0.64, 0.6}}; // orthonormal
    for (int k = 0; k < 3; k++) {
        to[k] =
            (float)(aslant ? ROWS[k][0] * from[0] + ROWS[k][1] * from[1] + ROWS[k][2] * from[2]
                           : from[k]);
    }
}

/** A parallelogram of two facets from a corner with two sides. */
static void plate(maker *made, const double at[3], const double u[3], const double v[3],
                  bool aslant)
{
    float points[4][3];
    for (int c = 0; c < 4; c++) {
        double place[3];
        for (int k = 0; k < 3; k++) {
            place[k] = at[k] + (c == 1 || c == 2 ? u[k] : 0.0) + (c >= 2 ? v[k] : 0.0);
        }
        turn(place, aslant, points[c]);
    }
    static const int CUT[2][3] = {{0, 1, 2}, {0, 2, 3}};
    maker_add_all(made, (const float(*)[3])points, CUT, 2);
}

/** A ball of radius 1 about (x, 0, z), its poles along z. */
static void ball(maker *made, double x, double z, int bands, bool aslant)
{
    static float points[MERIDIANS * (BANDS + 2)][3];
    for (int i = 0; i <= bands; i++) {
        for (int j = 0; j < MERIDIANS; j++) {
            const double a = M_PI * i / bands, b = 2.0 * M_PI * j / MERIDIANS;
            const double high = 2 * i == bands ? 0.0 : cos(a); // the equator is level
            turn((double[3]){x + sin(a) * cos(b), sin(a) * sin(b), z + high}, aslant,
                 points[i * MERIDIANS + j]);
        }
    }
    for (int i = 0; i < bands; i++) {
        for (int j = 0; j < MERIDIANS; j++) {
            const int right = (j + 1) % MERIDIANS, up = i * MERIDIANS, down = up + MERIDIANS;
            const float *a = points[up + j], *b = points[up + right];
            const float *c = points[down + j], *d = points[down + right];
            if (i > 0) {
                maker_add(made, a, c, b);
            }
            if (i < bands - 1) {
                maker_add(made, b, c, d);
            }
        }
    }
}

/** How many facets another one cuts through. */
static size_t crossing(const maker *made)
{
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    clod_mesh_destroy(&mesh);
    return report.findings[CLOD_MESH_CROSSING].count;
}

/** By hand: the upright triangle goes through facet 1 of the floor and not through 2, along the line
 *  from (0.5, 0.1, 0) to (0.5, 0.4, 0). */
static void a_triangle_through_a_floor_is_told(void **state)
{
    (void)state;
    static const float UPRIGHT[3][3] = {{0.5f, 0.1f, -1}, {0.5f, 0.4f, -1}, {0.5f, 0.25f, 1}};
    maker *made = maker_new();
    plate(made, (double[3]){0, 0, 0}, (double[3]){1, 0, 0}, (double[3]){0, 1, 0}, false);
    maker_add(made, UPRIGHT[0], UPRIGHT[1], UPRIGHT[2]);
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_finding *found = &report.findings[CLOD_MESH_CROSSING];
    assert_int_equal(found->count, 2);
    for (uint32_t k = 0; k < 2; k++) {
        assert_int_equal(found->places[k].number, k == 0 ? 1 : 3);
        assert_int_equal(found->places[k].other, k == 0 ? 3 : 1);
        check_close(found->places[k].point[0], 0.5, 1e-12);
        check_close(found->places[k].point[1], 0.25, 1e-7); // half of that line, of a float
        check_close(found->places[k].point[2], 0.0, 1e-12);
    }
    for (int f = 0; f < 3; f++) {
        assert_int_equal(clod_mesh_look(mesh)->found[f] >> CLOD_MESH_CROSSING & 1, f != 1);
    }
    char *text = clod_mesh_text(mesh, &report);
    assert_non_null(strstr(text, "2 facets cut through by another: kept. Where they cross, "
                                 "grains feel a groove on every side"));
    assert_non_null(strstr(text, "facet 3 at (0.5, 0.25, 0) m, through facet 1\n"));
    clod_mesh_free(text);
    char *json = clod_mesh_json(mesh, &report);
    assert_non_null(strstr(json, "\"crossing_facets\""));
    assert_non_null(strstr(json, "\"through_facet\": 1"));
    assert_null(strstr(json, "\"over_facet\""));
    clod_mesh_free(json);
    clod_mesh_destroy(&mesh);
}

/** A sphere of 9 bands about the origin is cut by a plane through its middle band: all 32 facets
 *  of that, and both of the plane; the diagonal of the plane goes across. */
static void a_sphere_cut_by_a_plane(void **state)
{
    (void)state;
    for (int aslant = 0; aslant < 2; aslant++) {
        maker *made = maker_new();
        ball(made, 0.0, 0.0, BANDS, aslant);
        plate(made, (double[3]){-2, -2, 0.01}, (double[3]){4, 0, 0}, (double[3]){0, 4, 0},
              aslant);
        assert_int_equal(crossing(made), 2 * MERIDIANS + 2);
    }
}

/** One of 8 bands has its equator in the plane, which no facet passes: the 16 above it and the 16 below
 *  that have an edge there are told, since over it the surface goes on. Half a ball only stands there. */
static void a_sphere_cut_along_its_equator(void **state)
{
    (void)state;
    for (int aslant = 0; aslant < 2; aslant++) {
        maker *made = maker_new();
        ball(made, 0.0, 0.0, 8, aslant);
        plate(made, (double[3]){-2, -2, 0}, (double[3]){4, 0, 0}, (double[3]){0, 4, 0}, aslant);
        assert_int_equal(crossing(made), 2 * MERIDIANS + 2);
        made->count = 14 * MERIDIANS / 2; // facets of the upper half
        plate(made, (double[3]){-2, -2, 0}, (double[3]){4, 0, 0}, (double[3]){0, 4, 0}, aslant);
        assert_int_equal(crossing(made), 0);
    }
}

/** Edges and corners that touch, sheets in one plane, T-junctions, needles, bodies side by side. */
static void what_touches_does_not_cross(void **state)
{
    (void)state;
    for (int aslant = 0; aslant < 2; aslant++) {
        maker *made = maker_new();
        const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, up[3] = {0, 0, 1};
        plate(made, (double[3]){0, 0, 0}, x, y, aslant);
        plate(made, (double[3]){1, 0, 0}, x, (double[3]){0, 1, 1}, aslant);    // a common edge
        plate(made, (double[3]){-1, -1, 0}, x, (double[3]){0, 1, 2}, aslant);  // a corner
        plate(made, (double[3]){0, 1, 0}, (double[3]){0.4, 0, 0}, up, aslant); // a T
        plate(made, (double[3]){0.4, 1, 0}, (double[3]){0.6, 0, 0}, up, aslant);
        plate(made, (double[3]){0.2, 0.3, 0}, (double[3]){0.7, 0.2, 0}, up, aslant); // stands
        plate(made, (double[3]){0.25, 0.6, 0}, (double[3]){0.3, 0.1, 0},
              (double[3]){0.2, 0.1, 1}, aslant);                                 // leans
        plate(made, (double[3]){0.3, 0.1, 0}, x, (double[3]){0, 0, -1}, aslant); // hangs
        plate(made, (double[3]){-0.2, -0.1, 0}, x, y, aslant);                   // in one plane
        plate(made, (double[3]){-0.5, -0.5, 0.7}, (double[3]){2, 0, 0},
              (double[3]){0, 0.001, 0},
              aslant); // above a needle
        plate(made, (double[3]){0.5, 0.5, -0.001}, (double[3]){0.001, 0, -1},
              (double[3]){0, 1e-4, 0}, aslant); // a needle below
        assert_int_equal(crossing(made), 0);
    }
    maker *made = maker_new();
    maker_box(made, (float[3]){0, 0, 0}, (float[3]){1, 1, 1});
    maker_box(made, (float[3]){0.25f, 0.5f, 1}, (float[3]){1, 1, 1});  // on it
    maker_box(made, (float[3]){0.25f, 0.5f, -1}, (float[3]){1, 1, 1}); // below
    maker_box(made, (float[3]){1, 0, 0}, (float[3]){1, 0.5f, 1});      // beside
    assert_int_equal(crossing(made), 0);
}

/** A place, off by a step of a float in each direction. */
static void jitter(dice *roll, const double at[3], float to[3])
{
    turn(at, true, to);
    for (int c = 0; c < 3; c++) {
        to[c] += (float)(0x1p-23 * floor(dice_real(roll, -1.0, 2.0)));
    }
}

/** Needles of two sheets that meet along a line, which each cuts at other places; corners are off by
 *  rounding, to either side of the other sheet. */
static void needles_that_rounding_moves_do_not_cross(void **state)
{
    (void)state;
    dice roll = {3};
    for (int round = 0; round < 20; round++) {
        maker *made = maker_new();
        for (int sheet = 0; sheet < 2; sheet++) {
            float near[2][3], far[2][3];
            for (int k = 0; k <= 200; k++) {
                const double along = 1e-3 * (k + dice_real(&roll, -0.4, 0.4));
                const double off[2][3] = {{along, 1, 0}, {along, -0.6, 0.1 * round}};
                jitter(&roll, (double[3]){along, 0, 0}, near[k % 2]);
                jitter(&roll, off[sheet], far[k % 2]);
                if (k > 0) {
                    maker_add(made, near[0], far[0], near[1]);
                    maker_add(made, far[0], far[1], near[1]);
                }
            }
        }
        assert_int_equal(crossing(made), 0);
    }
}

typedef struct triangle {
    double at[3][3];
} triangle;

/** Six times the volume of a tetrahedron. */
static double six(const double a[3], const double b[3], const double c[3], const double d[3])
{
    double m[3][3];
    for (int k = 0; k < 3; k++) {
        m[0][k] = b[k] - a[k];
        m[1][k] = c[k] - a[k];
        m[2][k] = d[k] - a[k];
    }
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/** Whether an edge of one passes the inside of the other: five volumes (Segura and Feito 2001). */
static bool pierces(const triangle *own, const triangle *other)
{
    const double(*a)[3] = own->at, (*b)[3] = other->at;
    for (int e = 0; e < 3; e++) {
        const double *p = a[e], *q = a[(e + 1) % 3];
        const double first = six(b[0], b[1], b[2], p), second = six(b[0], b[1], b[2], q);
        const double r = six(p, q, b[0], b[1]), s = six(p, q, b[1], b[2]);
        const double t = six(p, q, b[2], b[0]);
        if (first * second < 0.0 && ((r > 0 && s > 0 && t > 0) || (r < 0 && s < 0 && t < 0))) {
            return true;
        }
    }
    return false;
}

/** Triangles at random: those cross of which an edge of one pierces the other, by their volumes. */
static void random_facets_as_by_volumes(void **state)
{
    (void)state;
    dice roll = {12};
    size_t all = 0, bare = 0;
    for (int round = 0; round < 4000; round++) {
        triangle heap[SIX];
        maker *made = maker_new();
        for (int f = 0; f < SIX; f++) {
            float corner[3][3];
            for (int c = 0; c < 9; c++) {
                corner[c / 3][c % 3] = (float)dice_real(&roll, 0.0, 1.0);
                heap[f].at[c / 3][c % 3] = (double)corner[c / 3][c % 3];
            }
            maker_add(made, corner[0], corner[1], corner[2]);
        }
        uint32_t pairs[SIX][2];
        size_t expected = 0;
        for (uint32_t f = 0; f < SIX; f++) {
            uint32_t g = 0;
            while (g < SIX &&
                   (g == f || !(pierces(&heap[f], &heap[g]) || pierces(&heap[g], &heap[f])))) {
                g++;
            }
            if (g < SIX) {
                pairs[expected][0] = f + 1;
                pairs[expected++][1] = g + 1;
            }
        }
        clod_mesh *mesh;
        const clod_mesh_report report = maker_finish(made, &mesh);
        const clod_mesh_finding *found = &report.findings[CLOD_MESH_CROSSING];
        assert_int_equal(found->count, expected);
        for (size_t k = 0; k < expected && k < CLOD_MESH_PLACES; k++) {
            assert_int_equal(found->places[k].number, pairs[k][0]);
            assert_int_equal(found->places[k].other, pairs[k][1]);
        }
        all += expected;
        bare += SIX - expected;
        clod_mesh_destroy(&mesh);
    }
    assert_true(all > 4000 && bare > 4000);
}

/** Two boxes pushed into each other along the diagonal: of each, the three faces at the other's corner.
 *  By volumes as above, facet by facet. */
static void two_boxes_pushed_into_each_other(void **state)
{
    (void)state;
    maker *made = maker_new();
    maker_box(made, (float[3]){0, 0, 0}, (float[3]){1, 1, 1});
    maker_box(made, (float[3]){0.5f, 0.625f, 0.6875f}, (float[3]){1, 1, 1});
    triangle all[24];
    for (int f = 0; f < 24; f++) {
        float corner[3][3];
        memcpy(corner, made->bytes + 84 + 50 * f + 12, 36);
        for (int c = 0; c < 9; c++) {
            all[f].at[c / 3][c % 3] = (double)corner[c / 3][c % 3];
        }
    }
    size_t expected = 0;
    for (int f = 0; f < 24; f++) {
        bool cut = false;
        for (int g = 0; g < 24; g++) {
            cut = cut || (f / 12 != g / 12 &&
                          (pierces(&all[f], &all[g]) || pierces(&all[g], &all[f])));
        }
        expected += cut;
    }
    assert_true(expected >= 6);
    assert_int_equal(crossing(made), expected);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_triangle_through_a_floor_is_told),
        cmocka_unit_test(a_sphere_cut_by_a_plane),
        cmocka_unit_test(a_sphere_cut_along_its_equator),
        cmocka_unit_test(what_touches_does_not_cross),
        cmocka_unit_test(needles_that_rounding_moves_do_not_cross),
        cmocka_unit_test(random_facets_as_by_volumes),
        cmocka_unit_test(two_boxes_pushed_into_each_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
