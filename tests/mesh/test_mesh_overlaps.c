// Facets of one plane that lie over each other: which are named, and which are not.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "support/dice.h"

#define SEVEN 7 ///< facets of a random pile

static void square(maker *made, const float at[2], float size, float z, bool other_diagonal)
{
    const float x0 = at[0], y0 = at[1], x1 = x0 + size, y1 = y0 + size;
    const float points[4][3] = {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
    static const int CUTS[2][2][3] = {{{0, 1, 2}, {0, 2, 3}}, {{1, 3, 2}, {1, 0, 3}}};
    maker_add_all(made, points, CUTS[other_diagonal ? 1 : 0], 2);
}

/** Facets 3 and 4 both lie over 1 and over 2: the earliest is named. */
static void both_sides_of_a_sheet_cut_along_other_diagonals(void **state)
{
    (void)state;
    clod_mesh *mesh;
    maker *made = maker_new();
    square(made, (float[2]){0, 0}, 1.0f, 0.0f, false);
    square(made, (float[2]){0, 0}, 1.0f, 0.0f, true);
    const clod_mesh_report report = maker_finish(made, &mesh);
    const clod_mesh_finding *found = &report.findings[CLOD_MESH_OVERLAP];
    assert_int_equal(found->count, 2);
    for (uint32_t k = 0; k < 2; k++) {
        assert_int_equal(found->places[k].number, 3 + k);
        assert_int_equal(found->places[k].other, 1);
    }
    assert_int_equal(maker_found(&report), 2);
    for (int f = 0; f < 4; f++) { // facet 2 is under them too, but is not the earliest
        assert_int_equal(clod_mesh_look(mesh)->found[f] >> CLOD_MESH_OVERLAP & 1, f != 1);
    }
    char *text = clod_mesh_text(mesh, &report);
    assert_non_null(strstr(text, "2 facets over an earlier one in one plane: kept"));
    assert_non_null(strstr(text, "facet 4 at (0.333333, 0.333333, 0) m, over facet 1"));
    clod_mesh_free(text);
    char *json = clod_mesh_json(mesh, &report);
    assert_non_null(strstr(json, "\"overlapping_facets\""));
    assert_non_null(strstr(json, "\"over_facet\": 1"));
    clod_mesh_free(json);
    clod_mesh_destroy(&mesh);
}

/** How many facets lie over an earlier one. */
static size_t over(const maker *made)
{
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    clod_mesh_destroy(&mesh);
    return report.findings[CLOD_MESH_OVERLAP].count;
}

/** What only has corners or lines in common, or crosses, or is another plane, is none. */
static void neighbours_and_sheets_that_cross_do_not_count(void **state)
{
    (void)state;
    static const float UPRIGHT[3][3] = {{0.5f, -1, -1}, {0.5f, 2, -1}, {0.5f, 0.5f, 1}};
    maker *made = maker_new();
    square(made, (float[2]){0, 0}, 1.0f, 0.0f, false);
    square(made, (float[2]){1, 0}, 1.0f, 0.0f, true);
    square(made, (float[2]){-0.5f, 1}, 3.0f, 0.0f, true); // T-junctions
    square(made, (float[2]){0, 0}, 1.0f, 0.25f, true);    // above
    maker_add(made, UPRIGHT[0], UPRIGHT[1], UPRIGHT[2]);
    maker_box(made, (float[3]){0, 0, 1}, (float[3]){1, 1, 1});
    assert_int_equal(over(made), 0);
}

/** Sheets are one plane up to the weld distance: 2^-21 of the farthest coordinate, 1.907e-6 at 4. */
static void sheets_within_rounding_are_one_plane(void **state)
{
    (void)state;
    for (int apart = 0; apart < 2; apart++) {
        maker *made = maker_new();
        square(made, (float[2]){0, 0}, 4.0f, 0.0f, false);
        square(made, (float[2]){1, 1}, 1.0f, apart == 1 ? 2.0e-6f : 1.8e-6f, false);
        assert_int_equal(over(made), apart == 1 ? 0 : 2);
    }
}

typedef double triangle[3][2];

/** Area that two triangles have in common, by clipping one at the sides of the other (Sutherland and
 *  Hodgman 1974). */
static double common_area(const triangle a, const triangle b)
{
    double poly[12][2];
    int count = 3;
    memcpy(poly, a, sizeof(triangle));
    const double turn =
        (b[1][0] - b[0][0]) * (b[2][1] - b[0][1]) - (b[1][1] - b[0][1]) * (b[2][0] - b[0][0]);
    for (int e = 0; e < 3; e++) {
        const double *p = b[e], *q = b[(e + 1) % 3];
        double next[12][2], side[12];
        int kept = 0;
        for (int k = 0; k < count; k++) {
            side[k] = (q[0] - p[0]) * (poly[k][1] - p[1]) - (q[1] - p[1]) * (poly[k][0] - p[0]);
            side[k] *= turn;
        }
        for (int k = 0; k < count; k++) {
            const int to = (k + 1) % count;
            if (side[k] >= 0.0) {
                memcpy(next[kept++], poly[k], sizeof *next);
            }
            if (side[k] * side[to] < 0.0) {
                const double share = side[k] / (side[k] - side[to]);
                for (int c = 0; c < 2; c++) {
                    next[kept][c] = poly[k][c] + share * (poly[to][c] - poly[k][c]);
                }
                kept++;
            }
        }
        count = kept;
        memcpy(poly, next, sizeof poly);
    }
    double twice = 0.0;
    for (int k = 0; k < count; k++) {
        const double *p = poly[k], *q = poly[(k + 1) % count];
        twice += p[0] * q[1] - p[1] * q[0];
    }
    return 0.5 * fabs(twice);
}

/** Numbers from 1 to `SEVEN` of the facets over others, and of the earliest below; how many. */
static size_t expected_of(const triangle *all, uint32_t (*pairs)[2])
{
    size_t count = 0;
    for (uint32_t g = 1; g < SEVEN; g++) {
        for (uint32_t f = 0; f < g; f++) {
            if (common_area(all[f], all[g]) > 0.0) {
                pairs[count][0] = g + 1;
                pairs[count++][1] = f + 1;
                break;
            }
        }
    }
    return count;
}

/** A triangle at random whose plane is known well: its height is a fifth of its longest side or more. */
static void throw(dice * roll, triangle to)
{
    const double x = dice_real(roll, 0.0, 2.0), y = dice_real(roll, 0.0, 2.0);
    double twice = 0.0, longest = 1.0;
    while (fabs(twice) < 0.2 * longest * longest) {
        longest = 0.0;
        for (int c = 0; c < 3; c++) {
            to[c][0] = x + dice_real(roll, 0.0, 0.7);
            to[c][1] = y + dice_real(roll, 0.0, 0.7);
        }
        for (int c = 0; c < 3; c++) {
            const double *p = to[c], *q = to[(c + 1) % 3];
            longest = fmax(longest, hypot(q[0] - p[0], q[1] - p[1]));
        }
        twice = (to[1][0] - to[0][0]) * (to[2][1] - to[0][1]) -
                (to[1][1] - to[0][1]) * (to[2][0] - to[0][0]);
    }
}

/** Triangles at random in a plane aslant: the pairs are those whose common area is not zero. */
static void random_facets_as_by_clipping(void **state)
{
    (void)state;
    const double u[3] = {0.8, 0.36, 0.48}, v[3] = {-0.6, 0.48, 0.64}; // orthonormal
    dice roll = {11};
    size_t all = 0, bare = 0;
    for (int turn = 0; turn < 2000; turn++) {
        triangle made_of[SEVEN];
        maker *made = maker_new();
        for (int f = 0; f < SEVEN; f++) {
            float corner[3][3];
            throw(&roll, made_of[f]);
            for (int c = 0; c < 3; c++) {
                for (int k = 0; k < 3; k++) {
                    corner[c][k] = (float)(made_of[f][c][0] * u[k] + made_of[f][c][1] * v[k]);
                }
            }
            maker_add(made, corner[0], corner[1], corner[2]);
        }
        clod_mesh *mesh;
        uint32_t pairs[SEVEN][2];
        const clod_mesh_report report = maker_finish(made, &mesh);
        const clod_mesh_finding *found = &report.findings[CLOD_MESH_OVERLAP];
        const size_t expected = expected_of((const triangle *)made_of, pairs);
        assert_int_equal(found->count, expected);
        for (size_t k = 0; k < expected && k < CLOD_MESH_PLACES; k++) {
            assert_int_equal(found->places[k].number, pairs[k][0]);
            assert_int_equal(found->places[k].other, pairs[k][1]);
        }
        all += expected;
        bare += SEVEN - expected;
        clod_mesh_destroy(&mesh);
    }
    assert_true(all > 2000 && bare > 2500); // of 14 000, 2000 of which are the first
}

/** 20 000 slivers aslant, whose boxes all meet: the search ends and says so. */
static void a_search_that_would_not_end_is_told(void **state)
{
    (void)state;
    maker *made = maker_new();
    for (int k = 0; k < 20000; k++) {
        const float a = (float)k * 0x1p-15f, b = (float)(k + 1) * 0x1p-15f;
        maker_add(made, (float[3]){a, a, 0}, (float[3]){b, b, 0}, (float[3]){1 + a, a - 1, 0});
    }
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_OVERLAP].count, 0);
    assert_int_equal(report.warning_count, 1);
    assert_non_null(strstr(report.warnings[0], "of 20000 facets only"));
    clod_mesh_destroy(&mesh);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_sides_of_a_sheet_cut_along_other_diagonals),
        cmocka_unit_test(neighbours_and_sheets_that_cross_do_not_count),
        cmocka_unit_test(sheets_within_rounding_are_one_plane),
        cmocka_unit_test(random_facets_as_by_clipping),
        cmocka_unit_test(a_search_that_would_not_end_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
