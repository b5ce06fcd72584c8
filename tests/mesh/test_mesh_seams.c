// T-junctions: facets of different sizes along one line.

#include <math.h>

#include "mesh/mesh_maker.h"

/** A unit square whose lower side is one edge, above n triangles that share it, in the plane. */
static void add_seam(maker *made, int n, float tilt)
{
    const float left[3] = {0, 0, 0}, right[3] = {1, tilt, 0};
    const float below[3] = {0.5f, -1, 0}, above[3] = {0.5f, 1, 0};
    maker_add(made, right, left, below);
    for (int k = 0; k < n; k++) {
        const float x = (float)k / (float)n, next = (float)(k + 1) / (float)n;
        const float a[3] = {x, x * tilt, 0}, b[3] = {next, next * tilt, 0};
        maker_add(made, a, b, above);
    }
}

// The long edge and the n short ones know each other; two rims of two edges stay open.
static void short_edges_along_a_long_one(void **state)
{
    (void)state;
    for (int n = 2; n <= 64; n *= 2) {
        for (int t = 0; t < 2; t++) {
            clod_mesh *mesh;
            maker *made = maker_new();
            add_seam(made, n, t == 0 ? 0.0f : 0.3f); // tilted: on the line within rounding only
            const clod_mesh_report report = maker_finish(made, &mesh);
            const clod_mesh_view *view = clod_mesh_look(mesh);
            assert_int_equal(report.findings[CLOD_MESH_T].count, 1);
            assert_int_equal(report.findings[CLOD_MESH_T].places[0].number, 1);
            assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 4);
            assert_int_equal(report.edges[CLOD_MESH_EDGE_T], n + 1);
            assert_int_equal(report.edges[CLOD_MESH_EDGE_FLAT], n - 1);
            assert_int_equal(view->shell_count, 1);
            assert_int_equal(view->edges[0][0], CLOD_MESH_EDGE_T);
            assert_in_range(view->neighbours[0][0], 1, n);
            for (uint32_t f = 1; f <= (uint32_t)n; f++) {
                assert_int_equal(view->edges[f][0], CLOD_MESH_EDGE_T);
                assert_int_equal(view->neighbours[f][0], 0);
            }
            clod_mesh_destroy(&mesh);
        }
    }
}

// A cube whose one side is cut finer: closed, with the volume of the cube.
static void a_box_with_a_finer_side_is_closed(void **state)
{
    (void)state;
    enum { N = 8 };
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_box(made, (const float[3]){0, 0, 0}, (const float[3]){1, 1, 1});
    memmove(made->bytes + 84, made->bytes + 84 + 100, 500); // without the side z = 0
    made->count = 10;
    for (int i = 0; i < N; i++) {
        for (int j = 0; j < N; j++) {
            const float x = (float)i / N, y = (float)j / N, s = 1.0f / N;
            const float p[4][3] = {{x, y, 0}, {x, y + s, 0}, {x + s, y + s, 0}, {x + s, y, 0}};
            maker_add(made, p[0], p[1], p[2]);
            maker_add(made, p[0], p[2], p[3]);
        }
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_T].count, 4);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 0);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_T], 4 + 4 * N);
    assert_true(report.closed);
    check_relative(report.volume, 1.0, 1e-14);
    assert_int_equal(clod_mesh_look(mesh)->shell_count, 1);
    clod_mesh_destroy(&mesh);
}

// A vertex that is near the line, but not on it, makes no T: the gap is a gap.
static void a_vertex_beside_the_line_is_none(void **state)
{
    (void)state;
    const float left[3] = {0, 0, 0}, right[3] = {1, 0, 0}, below[3] = {0.5f, -1, 0};
    const float middle[3] = {0.5f, 1e-5f, 0}, above[3] = {0.5f, 1, 0};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add(made, right, left, below);
    maker_add(made, left, middle, above);
    maker_add(made, middle, right, above);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_T].count, 0);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 7);
    clod_mesh_destroy(&mesh);
}

// Only half of a long edge has a partner: it is a T, and the mesh is open.
static void half_a_partner_is_no_closed_seam(void **state)
{
    (void)state;
    const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const float half[3] = {0.5f, 0, 0};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add(made, p[0], p[2], p[1]);
    maker_add(made, p[0], half, p[3]); // where 0 1 3 would close the tetrahedron
    maker_add(made, p[0], p[3], p[2]);
    maker_add(made, p[1], p[2], p[3]);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_T].count, 1);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_T], 2);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 3); // the half, and the rim
    assert_int_equal(report.edges[CLOD_MESH_EDGE_OPEN], 2);
    assert_false(report.closed);
    clod_mesh_destroy(&mesh);
}

// Both sides of a line are divided, into halves and into thirds: each edge has a neighbour.
static void both_sides_may_be_divided(void **state)
{
    (void)state;
    const float top[3] = {0.5f, 1, 0.25f}, bottom[3] = {0.5f, -1, 0.5f};
    float thirds[4][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1.5f, 0.5f, 0}};
    float halves[3][3] = {{0, 0, 0}, {0.75f, 0.25f, 0}, {1.5f, 0.5f, 0}};
    for (int k = 1; k < 3; k++) {
        thirds[k][0] = 1.5f * (float)k / 3.0f;
        thirds[k][1] = 0.5f * (float)k / 3.0f;
    }
    clod_mesh *mesh;
    maker *made = maker_new();
    for (int k = 0; k < 3; k++) {
        maker_add(made, thirds[k], thirds[k + 1], top);
    }
    for (int k = 0; k < 2; k++) {
        maker_add(made, halves[k + 1], halves[k], bottom);
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(report.findings[CLOD_MESH_T].count, 3); // both halves, the middle third
    assert_int_equal(report.edges[CLOD_MESH_EDGE_T], 5);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 4);
    assert_int_equal(view->shell_count, 1);
    for (uint32_t f = 0; f < 5; f++) {
        assert_int_equal(view->edges[f][0], CLOD_MESH_EDGE_T);
        assert_in_range(view->neighbours[f][0], f < 3 ? 3 : 0, f < 3 ? 4 : 2);
    }
    assert_int_equal(view->neighbours[0][0], 3);
    assert_int_equal(view->neighbours[2][0], 4);
    clod_mesh_destroy(&mesh);
}

// A hole whose three sides are parts of longer edges: no edge is open, but the mesh is.
static void a_hole_between_long_edges_is_found(void **state)
{
    (void)state;
    // p: the hole; the edge from p[i] through p[i+1] ends in q[i+1]
    const float p[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const float q[3][3] = {{0, -1, 0}, {2, 0, 0}, {-1, 2, 0}}, apex[3] = {0, 0, -3};
    clod_mesh *mesh;
    maker *made = maker_new();
    for (int i = 0; i < 3; i++) {
        const int next = (i + 1) % 3;
        maker_add(made, p[i], q[next], q[i]);
        maker_add(made, q[i], q[next], apex);
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_OPEN], 0);
    assert_int_equal(report.findings[CLOD_MESH_T].count, 3);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 3);
    check_close(report.findings[CLOD_MESH_OPEN].places[0].point[0], 0.5, 0.5);
    assert_false(report.closed);
    clod_mesh_destroy(&mesh);
}

// Three sheets meet along a line, one of them in two pieces: two pieces of three.
static void three_sheets_meet_on_a_divided_line(void **state)
{
    (void)state;
    const float left[3] = {0, 0, 0}, right[3] = {1, 0, 0}, half[3] = {0.5f, 0, 0};
    const float one[3] = {0.5f, 1, 0}, two[3] = {0.5f, -1, 0}, three[3] = {0.5f, 0, 1};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add(made, left, half, one);
    maker_add(made, half, right, one);
    maker_add(made, left, right, two);
    clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_NONMANIFOLD].count, 0);
    clod_mesh_destroy(&mesh);
    maker_add(made, left, (const float[3]){0.25f, 0, 0}, three);
    maker_add(made, (const float[3]){0.25f, 0, 0}, right, three);
    report = maker_finish(made, &mesh);
    // pieces 0 to 1/4, 1/4 to 1/2 and 1/2 to 1
    assert_int_equal(report.findings[CLOD_MESH_NONMANIFOLD].count, 3);
    assert_int_equal(clod_mesh_look(mesh)->shell_count, 1);
    assert_false(report.closed);
    clod_mesh_destroy(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(short_edges_along_a_long_one),
        cmocka_unit_test(a_box_with_a_finer_side_is_closed),
        cmocka_unit_test(a_vertex_beside_the_line_is_none),
        cmocka_unit_test(both_sides_may_be_divided),
        cmocka_unit_test(a_hole_between_long_edges_is_found),
        cmocka_unit_test(three_sheets_meet_on_a_divided_line),
        cmocka_unit_test(half_a_partner_is_no_closed_seam),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
