// Contacts with two sheets of one mesh that cut through each other where neither has an edge: what the
// doctor says of them (CLOD_MESH_CROSSING) is what a grain feels.

#include <math.h>

#include "mesh/mesh_maker.h"
#include "mesh/touching.h"
#include "support/dice.h"

#define SMOOTH (20.0 * M_PI / 180.0)
#define RADIUS 0.2 ///< m, of the grain
#define DEGREE (M_PI / 180.0)

static touching found;

/** How many contacts a grain has. */
static int contacts_of(const clod_surface *surface, clod_vec3 p)
{
    touching_near(&found, surface, p, 1.3 * RADIUS);
    return touching_find(&found, p, RADIUS);
}

/** A sheet from -1 to 1.3 through the y axis, at an angle about it. */
static void sheet(maker *made, double angle)
{
    const float c = (float)cos(angle), s = (float)sin(angle);
    const float points[4][3] = {
        {-c, -2, -s}, {1.3f * c, -2, 1.3f * s}, {1.3f * c, 2, 1.3f * s}, {-c, 2, -s}};
    static const int CUT[2][3] = {{0, 1, 2}, {0, 2, 3}};
    maker_add_all(made, points, CUT, 2);
}

/** Two sheets that cross in the y axis, where neither has an edge. */
static clod_surface *cross_at(double angle)
{
    maker *made = maker_new();
    sheet(made, 0.0);
    sheet(made, angle);
    clod_mesh *mesh;
    const clod_mesh_report report = maker_finish(made, &mesh);
    assert_int_equal(report.findings[CLOD_MESH_CROSSING].count, 4); // the doctor says so
    clod_mesh_destroy(&mesh);
    return maker_surface(made, SMOOTH);
}

/** How a grain sees the sheets: distances, the nearer one first, and whether the closest point of the
 *  other one lies behind the nearer. */
typedef struct sight {
    double distance[2];
    clod_vec3 direction[2]; ///< from the sheet to the centre
    bool behind;
} sight;

static sight by_hand(double angle, clod_vec3 p)
{
    const clod_vec3 normals[2] = {{0.0, 0.0, 1.0}, {-sin(angle), 0.0, cos(angle)}};
    const double heights[2] = {clod_vec3_dot(p, normals[0]), clod_vec3_dot(p, normals[1])};
    const int first = fabs(heights[1]) < fabs(heights[0]);
    sight seen;
    for (int k = 0; k < 2; k++) {
        const int of = k == 0 ? first : 1 - first;
        seen.distance[k] = fabs(heights[of]);
        seen.direction[k] = clod_vec3_scale(normals[of], heights[of] < 0.0 ? -1.0 : 1.0);
    }
    const clod_vec3 foot = clod_vec3_axpy(p, -seen.distance[1], seen.direction[1]);
    seen.behind = clod_vec3_dot(foot, seen.direction[0]) < 0.0;
    return seen;
}

/** In all four sectors a grain is in a groove: each sheet pushes with its full overlap, straight away
 *  from it, but not what of it lies behind the other. So no ridge pushes. */
static void crossing_sheets_push_as_sides_of_grooves(void **state)
{
    (void)state;
    dice roll = {4};
    for (int tens = 3; tens <= 9; tens++) {
        const double angle = 10.0 * tens * DEGREE;
        clod_surface *cross = cross_at(angle);
        size_t grooves = 0, hidden = 0;
        for (int k = 0; k < 20000; k++) {
            const clod_vec3 p = {dice_real(&roll, -0.6, 0.6), dice_real(&roll, -0.6, 0.6),
                                 dice_real(&roll, -0.6, 0.6)};
            const sight seen = by_hand(angle, p);
            const bool second = seen.distance[1] < RADIUS && !seen.behind;
            const int expected = seen.distance[0] >= RADIUS ? 0 : 1 + second;
            assert_int_equal(contacts_of(cross, p), expected);
            for (int c = 0; c < expected; c++) {
                check_close(found.contact[c]->at.distance, seen.distance[c],
                            1e-6); // places are floats
                check_close(clod_vec3_dot(found.contact[c]->at.direction, seen.direction[c]),
                            1.0, 1e-9);
            }
            grooves += expected == 2;
            hidden += seen.distance[1] < RADIUS && seen.behind;
        }
        assert_true(grooves > 500 && (tens == 9 || hidden > 100));
        clod_surface_release(cross);
    }
}

/** At less than 20 degrees directions differ so little that rule 5 of adr/0033 takes one for the
 *  other's: the nearer sheet pushes, as on one that bends. From 12 degrees on both do in a strip beside the
 *  line: that is less than a groove has, more than a bend. */
static void at_small_angles_the_nearer_sheet_pushes(void **state)
{
    (void)state;
    dice roll = {6};
    for (int degrees = 2; degrees < 20; degrees++) {
        const double angle = degrees * DEGREE;
        clod_surface *cross = cross_at(angle);
        size_t touched = 0, twice = 0;
        for (int k = 0; k < 20000; k++) {
            const clod_vec3 p = {dice_real(&roll, -0.4, 0.4), dice_real(&roll, -0.4, 0.4),
                                 dice_real(&roll, 0.1, 0.3)};
            const sight seen = by_hand(angle, p);
            const double overlap = RADIUS - seen.distance[0];
            if (overlap <= 0.0 || overlap > 0.1 * RADIUS ||
                clod_vec3_dot(seen.direction[0], seen.direction[1]) < 0.0) {
                continue; // the wedge has no room for a grain
            }
            const int count = contacts_of(cross, p);
            assert_in_range(count, 1, degrees <= 10 ? 1 : 2);
            check_close(found.contact[0]->at.distance, seen.distance[0], 1e-6);
            touched++;
            twice += count == 2;
        }
        assert_true(touched > 1000 && 20 * twice < touched);
        assert_true(degrees < 19 || twice > 0);
        clod_surface_release(cross);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossing_sheets_push_as_sides_of_grooves),
        cmocka_unit_test(at_small_angles_the_nearer_sheet_pushes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
