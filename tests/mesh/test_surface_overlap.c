// Contacts with facets of one plane that lie over each other, or end beside others: those of the
// one plane that they make, beside its edges too.

#include <math.h>

#include "mesh/surface_contacts.h"
#include "support/dice.h"

/** A rectangle at z = 0, from `low` to `high`; its diagonal goes up or down. */
static void rectangle(maker *made, float x0, float y0, float x1, float y1, bool down)
{
    const float points[4][3] = {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
    static const int CUTS[2][2][3] = {{{0, 1, 2}, {0, 2, 3}}, {{1, 3, 2}, {1, 0, 3}}};
    maker_add_all(made, points, CUTS[down ? 1 : 0], 2);
}

/** Distance from a rectangle at z = 0, by hand. */
static double from_rectangle(clod_vec3 p, double x0, double y0, double x1, double y1)
{
    const double x = fmax(0.0, fmax(x0 - p.x, p.x - x1));
    const double y = fmax(0.0, fmax(y0 - p.y, p.y - y1));
    return hypot(hypot(x, y), p.z);
}

/** A grain near the rectangle from -1 to 1 has one contact, at its distance from it, or none;
 *  and where it is beside it a rim is near. */
static void expect_rectangle(const clod_surface *surface)
{
    dice roll = {5};
    assert_int_equal(surface->plane_count, 1);
    assert_int_equal(surface->patch_count, 1);
    for (int k = 0; k < 20000; k++) {
        const clod_vec3 p = {dice_real(&roll, -1.2, 1.2), dice_real(&roll, -1.2, 1.2),
                             dice_real(&roll, -0.2, 0.2)};
        const double distance = from_rectangle(p, -1.0, -1.0, 1.0, 1.0);
        clod_surface_closest contact[MOST];
        const int count = contacts_of(surface, p, contact);
        assert_int_equal(count, distance < RADIUS);
        if (count == 1) {
            check_close(contact[0].distance, distance, 1e-15);
            check_close(contact[0].direction.z, p.z / distance, 1e-12);
        }
        if (distance > fabs(p.z) && distance < RADIUS) {
            assert_true(clod_surface_rim_is_near(surface, 0, p, RADIUS));
        }
    }
}

/** Front and back of a sheet of no thickness, which are cut along other diagonals. */
static void two_sides_of_a_sheet(void **state)
{
    (void)state;
    maker *made = maker_new();
    rectangle(made, -1, -1, 1, 1, false);
    rectangle(made, -1, -1, 1, 1, true);
    clod_surface *surface = surface_of(made);
    expect_rectangle(surface);
    clod_surface_release(surface);
}

/** Plates that were drawn one over the other: no edge of one is an edge of another. */
static void plates_over_each_other(void **state)
{
    (void)state;
    maker *made = maker_new();
    rectangle(made, -1, -1, 0.5f, 1, false);
    rectangle(made, -0.25f, -1, 1, 1, true);
    rectangle(made, -0.75f, -0.6f, 0.9f, 0.7f, false);
    clod_surface *surface = surface_of(made);
    expect_rectangle(surface);
    clod_surface_release(surface);
}

#define TURN 0.5 ///< rad, of the cross: no rim along an axis, where a slot ends (adr/0033)

/** A rectangle of the cross. */
static void arm(maker *made, const double low[2], const double high[2], bool down)
{
    const double x[4] = {low[0], high[0], high[0], low[0]};
    const double y[4] = {low[1], low[1], high[1], high[1]};
    static const int CUTS[2][2][3] = {{{0, 1, 2}, {0, 2, 3}}, {{1, 2, 3}, {1, 3, 0}}};
    float points[4][3] = {{0}};
    for (int c = 0; c < 4; c++) {
        points[c][0] = (float)(x[c] * cos(TURN) - y[c] * sin(TURN));
        points[c][1] = (float)(x[c] * sin(TURN) + y[c] * cos(TURN));
    }
    maker_add_all(made, (const float(*)[3])points, CUTS[down ? 1 : 0], 2);
}

/** Half its width. */
#define W 0.125

static clod_surface *cross_of_two(void)
{
    maker *made = maker_new();
    arm(made, (double[2]){-1, -W}, (double[2]){1, W}, false);
    arm(made, (double[2]){-W, -1}, (double[2]){W, 1}, true);
    return surface_of(made);
}

static clod_surface *cross_of_five(void)
{
    maker *made = maker_new();
    arm(made, (double[2]){-W, -W}, (double[2]){W, W}, false);
    arm(made, (double[2]){-1, -W}, (double[2]){-W, W}, false);
    arm(made, (double[2]){W, -W}, (double[2]){1, W}, false);
    arm(made, (double[2]){-W, -1}, (double[2]){W, -W}, true);
    arm(made, (double[2]){-W, W}, (double[2]){W, 1}, true);
    return surface_of(made);
}

/** A cross of two plates one over the other has the contacts of one of five plates side by side: on it
 *  one, in its corners those of both rims where they are in other directions. Its places are those of single precision. */
static void a_cross_of_two_plates(void **state)
{
    (void)state;
    clod_surface *over = cross_of_two(), *beside = cross_of_five();
    dice roll = {8};
    int both = 0;
    for (int k = 0; k < 20000; k++) {
        const clod_vec3 q = {dice_real(&roll, -0.6, 0.6), dice_real(&roll, -0.6, 0.6),
                             dice_real(&roll, -0.2, 0.2)};
        const clod_vec3 p = {q.x * cos(TURN) - q.y * sin(TURN),
                             q.x * sin(TURN) + q.y * cos(TURN), q.z};
        const double first = from_rectangle(q, -1, -W, 1, W);
        const double second = from_rectangle(q, -W, -1, W, 1);
        const bool beyond = first > fabs(q.z) && second > fabs(q.z); // in a corner
        const double cosine = q.z * q.z / (first * second);          // of the ways to both rims
        const bool apart = beyond && cosine < cos(SMOOTH);
        const int expected =
            fmin(first, second) >= RADIUS ? 0 : 1 + (apart && fmax(first, second) < RADIUS);
        clod_surface_closest found[MOST], twin[MOST];
        assert_int_equal(contacts_of(over, p, found), expected);
        assert_int_equal(contacts_of(beside, p, twin), expected);
        for (int c = 0; c < expected; c++) {
            check_close(found[c].distance, c == 0 ? fmin(first, second) : fmax(first, second),
                        1e-6);
            check_close(found[c].direction.x, twin[c].direction.x, 1e-5);
            check_close(found[c].direction.y, twin[c].direction.y, 1e-5);
        }
        both += expected == 2;
    }
    assert_true(both > 100);
    clod_surface_release(over);
    clod_surface_release(beside);
}

/** A long edge that has a neighbour along half of it ends along the other half. */
static void half_an_edge_on_a_t_is_a_rim(void **state)
{
    (void)state;
    maker *made = maker_new();
    rectangle(made, 0, 0, 2, 2, false);
    rectangle(made, 2, 0, 3, 1, false);
    clod_surface *surface = surface_of(made);
    assert_int_equal(surface->patch_count, 1);
    clod_surface_closest contact[MOST];
    for (int k = 1; k < 10; k++) {
        const clod_vec3 p = {2.0 + 0.019 * k, 1.7, 0.1};
        assert_true(clod_surface_rim_is_near(surface, 0, p, RADIUS));
        assert_int_equal(contacts_of(surface, p, contact), hypot(0.019 * k, 0.1) < RADIUS);
        check_close(contact[0].distance, hypot(0.019 * k, 0.1), 1e-15);
    }
    clod_surface_release(surface);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_sides_of_a_sheet),
        cmocka_unit_test(plates_over_each_other),
        cmocka_unit_test(a_cross_of_two_plates),
        cmocka_unit_test(half_an_edge_on_a_t_is_a_rim),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
