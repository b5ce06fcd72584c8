// Edges between two facets: a hinge at any angle, seen from both sides; sheets that meet.

#include <math.h>

#include "mesh/mesh_maker.h"

#define PI 3.14159265358979323846

/** A hinge along x: the second wing is bent by an angle out of the plane of the first. */
static void add_hinge(maker *made, double angle, double length, bool upside_down)
{
    const float a[3] = {0, 0, 0}, b[3] = {1, 0, 0}, c[3] = {0.5f, 1, 0};
    const float d[3] = {0.5f, (float)(-length * cos(angle)), (float)(length * sin(angle))};
    if (upside_down) {
        maker_add(made, a, c, b);
        maker_add(made, a, b, d);
    } else {
        maker_add(made, a, b, c); // normal (0, 0, 1)
        maker_add(made, b, a, d);
    }
}

/** The class of the hinge, the same for both wings. */
static int class_of(double angle, double length, bool upside_down)
{
    clod_mesh *mesh;
    maker *made = maker_new();
    add_hinge(made, angle, length, upside_down);
    maker_finish(made, &mesh);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    int kinds[2] = {-1, -1};
    for (int f = 0; f < 2; f++) {
        for (int e = 0; e < 3; e++) {
            if (view->neighbours[f][e] != CLOD_MESH_NONE) {
                assert_int_equal(view->neighbours[f][e], 1 - f);
                kinds[f] = view->edges[f][e];
            } else {
                assert_int_equal(view->edges[f][e], CLOD_MESH_EDGE_OPEN);
            }
        }
    }
    assert_int_equal(kinds[0], kinds[1]);
    clod_mesh_destroy(&mesh);
    return kinds[0];
}

// The limit is a sine of 1/1000, whatever the size of the wing.
static void hinges_are_classed_by_their_angle(void **state)
{
    (void)state;
    for (double length = 0.01; length < 200.0; length *= 10.0) {
        for (int degrees = 1; degrees < 180; degrees++) {
            const double angle = PI * degrees / 180.0;
            assert_int_equal(class_of(angle, length, false), CLOD_MESH_EDGE_CONCAVE);
            assert_int_equal(class_of(-angle, length, false), CLOD_MESH_EDGE_CONVEX);
            assert_int_equal(class_of(angle, length, true), CLOD_MESH_EDGE_CONVEX);
            assert_int_equal(class_of(-angle, length, true), CLOD_MESH_EDGE_CONCAVE);
        }
        assert_int_equal(class_of(0.0, length, false), CLOD_MESH_EDGE_FLAT);
    }
    for (int sign = -1; sign <= 1; sign += 2) {
        assert_int_equal(class_of(sign * 0.00095, 1.0, false), CLOD_MESH_EDGE_FLAT);
        assert_int_equal(class_of(sign * 0.00105, 1.0, false),
                         sign > 0 ? CLOD_MESH_EDGE_CONCAVE : CLOD_MESH_EDGE_CONVEX);
    }
}

// At 1001 m a float has steps of 6e-5 m, four of which rounding explains: a small wing that is
// out of the plane by 1.2e-4 is flat, by 1e-3 it is not.
static void rounding_bends_nothing(void **state)
{
    (void)state;
    for (int k = 0; k < 2; k++) {
        const float a[3] = {1000, 0, 0}, b[3] = {1001, 0, 0}, c[3] = {1000.5f, 1, 0};
        const float d[3] = {1000.5f, -0.01f, k == 0 ? 1.2e-4f : 1e-3f};
        clod_mesh *mesh;
        maker *made = maker_new();
        maker_add(made, a, b, c);
        maker_add(made, b, a, d);
        maker_finish(made, &mesh);
        assert_int_equal(clod_mesh_look(mesh)->edges[0][0],
                         k == 0 ? CLOD_MESH_EDGE_FLAT : CLOD_MESH_EDGE_CONCAVE);
        clod_mesh_destroy(&mesh);
    }
}

// A wing folded back onto the other is an edge of a thin sheet, from either side.
static void folded_back_is_convex(void **state)
{
    (void)state;
    assert_int_equal(class_of(PI, 0.5, false), CLOD_MESH_EDGE_CONVEX);
    assert_int_equal(class_of(PI, 0.5, true), CLOD_MESH_EDGE_CONVEX);
}

// Three wings on one edge: one finding, every wing knows another, one piece.
static void three_sheets_meet(void **state)
{
    (void)state;
    const float a[3] = {0, 0, 0}, b[3] = {1, 0, 0};
    const float tips[3][3] = {{0.5f, 1, 0}, {0.5f, -1, 0}, {0.5f, 0, 1}};
    clod_mesh *mesh;
    maker *made = maker_new();
    for (int t = 0; t < 3; t++) {
        maker_add(made, a, b, tips[t]);
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(report.findings[CLOD_MESH_NONMANIFOLD].count, 1);
    check_close(report.findings[CLOD_MESH_NONMANIFOLD].places[0].point[0], 0.5, 0.0);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 6);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_NONMANIFOLD], 1);
    assert_int_equal(view->shell_count, 1);
    for (uint32_t f = 0; f < 3; f++) {
        assert_int_equal(view->edges[f][0], CLOD_MESH_EDGE_NONMANIFOLD);
        assert_int_equal(view->neighbours[f][0], (f + 1) % 3);
    }
    clod_mesh_destroy(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hinges_are_classed_by_their_angle),
        cmocka_unit_test(rounding_bends_nothing),
        cmocka_unit_test(folded_back_is_convex),
        cmocka_unit_test(three_sheets_meet),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
