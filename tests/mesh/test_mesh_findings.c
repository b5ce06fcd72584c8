// Meshes made by code: measures in closed form, and each fault found and repaired as promised.

#include <math.h>

#include "mesh/mesh_maker.h"

#define PI 3.14159265358979323846

static const float ORIGIN[3] = {0.0f, 0.0f, 0.0f};
static const float UNITS[3] = {1.0f, 1.0f, 1.0f};

// A box of a by b by c: 2 (ab + bc + ca), abc, 12 edges and a diagonal in each of 6 sides.
static void a_box_is_measured_exactly(void **state)
{
    (void)state;
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_box(made, (const float[3]){1.0f, -2.0f, 0.5f}, (const float[3]){2.0f, 0.5f, 0.25f});
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_true(report.closed);
    assert_true(report.area == 2.0 * (1.0 + 0.125 + 0.5));
    assert_true(report.volume == 0.25);
    assert_true(report.box[0][0] == 1.0 && report.box[1][0] == 3.0);
    assert_true(report.box[0][1] == -2.0 && report.box[1][1] == -1.5);
    assert_true(report.shortest == 0.25 && report.longest == sqrt(4.25));
    assert_int_equal(report.edges[CLOD_MESH_EDGE_FLAT], 6);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_CONVEX], 12);
    assert_int_equal(maker_found(&report), 0);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->vertex_count, 8);
    assert_int_equal(view->facet_count, 12);
    assert_int_equal(view->shell_count, 1);
    assert_int_equal(report.warning_count, 0);
    clod_mesh_destroy(&mesh);
}

// Corner tetrahedron: volume 1/6, three right triangles and one of side sqrt 2.
static void a_tetrahedron_is_measured(void **state)
{
    (void)state;
    static const float POINTS[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    static const int FACETS[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add_all(made, POINTS, FACETS, 4);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_true(report.closed);
    check_relative(report.volume, 1.0 / 6.0, 1e-15);
    check_relative(report.area, 1.5 + sqrt(3.0) / 2.0, 1e-15);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_CONVEX], 6);
    clod_mesh_destroy(&mesh);
}

/** A place on the unit sphere. */
static void place(double polar, double around, float at[3])
{
    at[0] = (float)(sin(polar) * cos(around));
    at[1] = (float)(sin(polar) * sin(around));
    at[2] = (float)cos(polar);
}

// A sphere of rings and sectors is a stack of frustums between regular polygons: a polygon of
// circumradius r has the area n/2 r^2 sin(2 pi/n), a frustum of height h between two of them the
// volume h/3 (A1 + A2 + sqrt(A1 A2)).
static void a_sphere_has_the_volume_of_its_polyhedron(void **state)
{
    (void)state;
    enum { RINGS = 32, SECTORS = 64 };
    maker *made = maker_new();
    double frustums = 0.0;
    for (int i = 0; i < RINGS; i++) {
        const double up = PI * i / RINGS, down = PI * (i + 1) / RINGS;
        const double unit = SECTORS / 2.0 * sin(2.0 * PI / SECTORS);
        const double a = sin(up), b = sin(down);
        frustums += unit * (cos(up) - cos(down)) / 3.0 * (a * a + b * b + a * b);
        for (int k = 0; k < SECTORS; k++) {
            const double left = 2.0 * PI * k / SECTORS;
            const double right = 2.0 * PI * ((k + 1) % SECTORS) / SECTORS;
            float p[4][3];
            place(up, left, p[0]);
            place(down, left, p[1]);
            place(down, right, p[2]);
            place(up, right, p[3]);
            if (i > 0) {
                maker_add(made, p[0], p[1], p[3]);
            }
            if (i < RINGS - 1) {
                maker_add(made, p[3], p[1], p[2]);
            }
        }
    }
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_true(report.closed);
    check_relative(report.volume, frustums, 1e-6); // coordinates are rounded to 6e-8
    // Euler: V - E + F = 2, and the poles are one vertex each, though sin(pi) is not 0
    assert_int_equal(view->vertex_count, 2 + (RINGS - 1) * SECTORS);
    assert_int_equal(view->facet_count, 2 * SECTORS * (RINGS - 1));
    assert_int_equal(report.edges[CLOD_MESH_EDGE_CONCAVE], 0);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_FLAT] + report.edges[CLOD_MESH_EDGE_CONVEX],
                     3 * SECTORS * (RINGS - 1));
    check_relative(report.area, 4.0 * PI, 5e-3); // from below: the polyhedron is inside
    assert_true(report.area < 4.0 * PI);
    clod_mesh_destroy(&mesh);
}

// Every facet has corners of its own, moved by one step of a float at random: all join again.
static void vertices_that_differ_in_the_last_bit_join(void **state)
{
    (void)state;
    static const float LOW[3] = {1.1f, 2.3f, 3.7f};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_box(made, LOW, UNITS);
    uint32_t dice = 1;
    for (uint32_t f = 0; f < made->count; f++) {
        float values[9];
        char *at = made->bytes + 84 + 50 * (size_t)f + 12;
        memcpy(values, at, sizeof values);
        for (int k = 0; k < 9; k++) {
            dice = dice * 1664525u + 1013904223u;
            const float step = (dice >> 16) % 3 == 0   ? 0.0f
                               : (dice >> 16) % 3 == 1 ? 9.0f
                                                       : -9.0f;
            values[k] = step == 0.0f ? values[k] : nextafterf(values[k], step);
        }
        memcpy(at, values, sizeof values);
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_true(report.closed);
    assert_int_equal(clod_mesh_look(mesh)->vertex_count, 8);
    assert_true(report.findings[CLOD_MESH_WELDED].count > 8);
    assert_int_equal(maker_found(&report), report.findings[CLOD_MESH_WELDED].count);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_FLAT], 6);
    // four steps of a float at the farthest coordinate
    check_relative(report.weld, 4.7 * 4.0 * 0x1p-23, 1e-6);
    clod_mesh_destroy(&mesh);
}

// An edge of ten steps is a part of the shape; a gap of ten steps stays one.
static void what_is_farther_apart_is_left(void **state)
{
    (void)state;
    const float gap = 10.0f * 0x1p-23f;
    const float a[3] = {1.0f, 0.0f, 0.0f}, b[3] = {0.0f, 1.0f, 0.0f}, c[3] = {0.0f, 0.0f, 0.0f};
    const float d[3] = {-1.0f, 0.0f, 0.0f}, far_c[3] = {-gap, 0.0f, 0.0f};
    const float far_b[3] = {-gap, 1.0f, 0.0f};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add(made, a, b, c);
    maker_add(made, far_b, d, far_c);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(clod_mesh_look(mesh)->vertex_count, 6);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 6);
    assert_int_equal(clod_mesh_look(mesh)->shell_count, 2);
    clod_mesh_destroy(&mesh);
}

static void duplicates_are_dropped_whatever_their_order(void **state)
{
    (void)state;
    static const float POINTS[3][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    static const int AGAIN[3][3] = {
        {0, 2, 1}, {2, 1, 0}, {2, 0, 1}}; // of the box's first facet
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_box(made, ORIGIN, UNITS);
    maker_add_all(made, POINTS, AGAIN, 3);
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_finding *found = &report.findings[CLOD_MESH_DUPLICATE];
    assert_int_equal(found->count, 3);
    assert_int_equal(found->places[0].number, 13); // the first of them is kept
    assert_int_equal(found->places[2].number, 15);
    check_close(found->places[0].point[0], 2.0 / 3.0, 1e-15);
    assert_int_equal(maker_found(&report), 3);
    assert_int_equal(report.read_facets, 15);
    assert_int_equal(clod_mesh_look(mesh)->facet_count, 12);
    assert_true(report.closed && report.volume == 1.0);
    clod_mesh_destroy(&mesh);
}

static void facets_without_area_are_dropped(void **state)
{
    (void)state;
    static const float POINTS[5][3] = {
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5f, 0.5f, 0}, {9, 9, 9}};
    // the second and third on a line, the fourth again
    static const int WITHOUT[4][3] = {{0, 0, 1}, {0, 2, 3}, {4, 4, 4}, {3, 2, 0}};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add_all(made, POINTS, WITHOUT, 4);
    // beside a line by less than four steps of a float at 9, 4.3e-6: no area but for rounding
    maker_add(made, POINTS[0], POINTS[2], (const float[3]){0.25f, 0.250002f, 0});
    maker_box(made, ORIGIN, UNITS);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_DEGENERATE].count, 5);
    assert_int_equal(report.findings[CLOD_MESH_DEGENERATE].places[1].number, 2);
    assert_int_equal(maker_found(&report), 5);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->vertex_count, 8); // those that only dropped facets had are gone
    assert_int_equal(view->number[0], 6);
    assert_true(report.box[1][0] == 1.0);
    clod_mesh_destroy(&mesh);
}

// The volume is right only when all normals agree; edges are flat and convex as before.
static void flipped_facets_are_turned(void **state)
{
    (void)state;
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_box(made, ORIGIN, UNITS);
    for (size_t f = 0; f < 12; f += 5) { // facets 1, 6, 11: swap two corners
        char *at = made->bytes + 84 + 50 * f, kept[12];
        memcpy(kept, at + 24, 12);
        memmove(at + 24, at + 36, 12);
        memcpy(at + 36, kept, 12);
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_finding *found = &report.findings[CLOD_MESH_TURNED];
    assert_int_equal(found->count, 3);
    assert_int_equal(found->places[0].number, 1);
    assert_int_equal(found->places[1].number, 6);
    assert_int_equal(found->places[2].number, 11);
    assert_int_equal(maker_found(&report), 3);
    assert_true(report.closed && report.volume == 1.0);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_FLAT], 6);
    assert_int_equal(report.edges[CLOD_MESH_EDGE_CONVEX], 12);
    clod_mesh_destroy(&mesh);
}

// A strip of n squares, closed with half a turn: one edge remains where normals disagree.
static void a_moebius_strip_is_told(void **state)
{
    (void)state;
    enum { N = 24 };
    clod_mesh *mesh;
    maker *made = maker_new();
    float rim[2][N + 1][3];
    for (int k = 0; k <= N; k++) {
        const double t = 2.0 * PI * (k % N) / N;
        for (int side = 0; side < 2; side++) {
            const int own = k == N ? 1 - side : side;
            const double r = 1.0 + (own == 0 ? -0.2 : 0.2) * cos(t / 2.0);
            rim[side][k][0] = (float)(r * cos(t));
            rim[side][k][1] = (float)(r * sin(t));
            rim[side][k][2] = (float)((own == 0 ? -0.2 : 0.2) * sin(t / 2.0));
        }
    }
    for (int k = 0; k < N; k++) {
        maker_add(made, rim[0][k], rim[0][k + 1], rim[1][k + 1]);
        maker_add(made, rim[0][k], rim[1][k + 1], rim[1][k]);
    }
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_TWISTED].count, 1);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 2 * N);
    assert_false(report.closed);
    assert_true(isnan(report.volume));
    clod_mesh_destroy(&mesh);
}

/** Convex for one facet is so for its neighbour, but concave where their normals disagree. */
static void check_classes(const clod_mesh_view *view)
{
    size_t mirrored = 0;
    for (uint32_t f = 0; f < view->facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const uint32_t *own = view->facets[f], other = view->neighbours[f][e];
            const uint32_t *there = view->facets[other];
            for (int k = 0; k < 3; k++) {
                const uint32_t from = there[k], to = there[(k + 1) % 3];
                if (from == own[(e + 1) % 3] && to == own[e]) {
                    assert_int_equal(view->edges[other][k], view->edges[f][e]);
                } else if (from == own[e] && to == own[(e + 1) % 3]) {
                    assert_int_equal(view->edges[other][k] + view->edges[f][e],
                                     CLOD_MESH_EDGE_CONVEX + CLOD_MESH_EDGE_CONCAVE);
                    mirrored++;
                }
            }
        }
    }
    assert_true(mirrored > 0);
}

// The projective plane on six vertices: every edge has two facets, and yet it has no inside.
static void a_closed_surface_without_inside_has_no_volume(void **state)
{
    (void)state;
    static const float POINTS[6][3] = {{0, 0, 1},        {1, 0, 0.3f},         {0.3f, 1, 0},
                                       {-0.8f, 0.6f, 0}, {-0.8f, -0.6f, 0.1f}, {0.3f, -1, 0}};
    static const int FACETS[10][3] = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                                      {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add_all(made, POINTS, FACETS, 10);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_OPEN].count, 0);
    assert_true(report.findings[CLOD_MESH_TWISTED].count > 0);
    assert_false(report.closed);
    check_classes(clod_mesh_look(mesh));
    clod_mesh_destroy(&mesh);
}

// 0 and -0 are one place; of two vertices within reach the first in the file is taken.
static void the_first_vertex_in_reach_is_taken(void **state)
{
    (void)state;
    const float step = 0x1p-23f; // at 1; four of them are in reach
    const float far_off[3] = {-1, 0, 0}, up[3] = {0, 1, 0}, down[3] = {0, -1, 0};
    const float places[3][3] = {
        {1 - 3 * step, 0, 0}, {1 + 3 * step, 0, 0}, {1, -0.0f, 0}}; // 6, 3 and 3 steps apart
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add(made, places[0], up, far_off);
    maker_add(made, places[1], down, up);
    maker_add(made, places[2], far_off, down);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_WELDED].count, 1);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->vertex_count, 5);
    uint32_t turned = 0;
    for (uint32_t f = 0; f < 3; f++) {
        turned += view->facets[f][0] == view->facets[0][0];
    }
    assert_int_equal(turned, 2); // the first and the third facet
    clod_mesh_destroy(&mesh);
    made = maker_new();
    maker_add(made, (const float[3]){0.0f, 1, 0}, up, far_off);
    maker_add(made, (const float[3]){-0.0f, 1, -0.0f}, down, far_off);
    maker_add(made, (const float[3]){1, 0, 0}, down, far_off);
    const clod_mesh_report zeros = maker_finish(made, &mesh);
    assert_int_equal(zeros.findings[CLOD_MESH_WELDED].count, 0);
    clod_mesh_destroy(&mesh);
}

static void needles_and_slivers_are_told_apart(void **state)
{
    (void)state;
    static const float POINTS[5][3] = {
        {0, 0, 0}, {1, 0, 0}, {1, 0.0099f, 0}, {0.5f, -0.0099f, 0}, {0.5f, 0.011f, 0.0f}};
    static const int NEEDLE[1][3] = {{0, 1, 2}}, SLIVER[1][3] = {{0, 3, 1}};
    static const int NEITHER[1][3] = {{0, 1, 4}}; // its height is 0.011
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_add_all(made, POINTS, NEEDLE, 1);
    maker_add_all(made, POINTS, SLIVER, 1);
    maker_add_all(made, POINTS, NEITHER, 1);
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_NEEDLE].count, 1);
    assert_int_equal(report.findings[CLOD_MESH_NEEDLE].places[0].number, 1);
    assert_int_equal(report.findings[CLOD_MESH_SLIVER].count, 1);
    assert_int_equal(report.findings[CLOD_MESH_SLIVER].places[0].number, 2);
    assert_int_equal(clod_mesh_look(mesh)->facet_count, 3);
    clod_mesh_destroy(&mesh);
}

static void unconnected_pieces_are_numbered(void **state)
{
    (void)state;
    clod_mesh *mesh;
    maker *made = maker_new();
    maker_box(made, ORIGIN, UNITS);
    maker_box(made, (const float[3]){3.0f, 0.0f, 0.0f}, UNITS);
    maker_box(made, (const float[3]){1.0f, 1.0f, 1.0f}, UNITS); // touches the first in a corner
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_view *view = clod_mesh_look(mesh);
    assert_int_equal(view->shell_count, 3);
    for (uint32_t f = 0; f < 36; f++) {
        assert_int_equal(view->shell[f], f / 12);
    }
    assert_true(report.closed && report.volume == 3.0);
    clod_mesh_destroy(&mesh);
}

static void a_mesh_without_area_is_refused(void **state)
{
    (void)state;
    static const float POINTS[3][3] = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}};
    static const int FACETS[2][3] = {{0, 1, 2}, {0, 0, 0}};
    clod_status status = {CLOD_OK, ""};
    maker *made = maker_new();
    maker_add_all(made, POINTS, FACETS, 2);
    assert_null(clod_mesh_parse("made.stl", made->bytes, maker_length(made), &METRES, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "made.stl: none of the 2 facets has an area"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_box_is_measured_exactly),
        cmocka_unit_test(a_tetrahedron_is_measured),
        cmocka_unit_test(a_sphere_has_the_volume_of_its_polyhedron),
        cmocka_unit_test(vertices_that_differ_in_the_last_bit_join),
        cmocka_unit_test(what_is_farther_apart_is_left),
        cmocka_unit_test(duplicates_are_dropped_whatever_their_order),
        cmocka_unit_test(facets_without_area_are_dropped),
        cmocka_unit_test(flipped_facets_are_turned),
        cmocka_unit_test(a_moebius_strip_is_told),
        cmocka_unit_test(a_closed_surface_without_inside_has_no_volume),
        cmocka_unit_test(the_first_vertex_in_reach_is_taken),
        cmocka_unit_test(needles_and_slivers_are_told_apart),
        cmocka_unit_test(unconnected_pieces_are_numbered),
        cmocka_unit_test(a_mesh_without_area_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
