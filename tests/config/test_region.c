// Which regions of a case have space in common: cases drawn by hand.

#include <math.h>

#include "config/region.h"
#include "support/check.h"

static clod_case_region box(double x, double y, double z, double edge)
{
    return (clod_case_region){
        .kind = CLOD_REGION_BOX, .min = {x, y, z}, .max = {x + edge, y + edge, z + edge}};
}

static clod_case_region ring(double x, double z, double inner, double outer)
{
    return (clod_case_region){.kind = CLOD_REGION_ANNULUS,
                              .center = {x, 0.0, z},
                              .inner_radius = inner,
                              .outer_radius = outer,
                              .height = 1.0};
}

static void expect(bool common, clod_case_region a, clod_case_region b)
{
    assert_int_equal(clod_region_overlap(&a, &b), common);
    assert_int_equal(clod_region_overlap(&b, &a), common);
}

static void boxes(void **unused)
{
    (void)unused;
    expect(true, box(0, 0, 0, 1), box(0.9, 0.9, 0.9, 1));
    expect(true, box(0, 0, 0, 3), box(1, 1, 1, 1));  // one in the other
    expect(false, box(0, 0, 0, 1), box(1, 0, 0, 1)); // they touch
    expect(false, box(0, 0, 0, 1), box(0, 1.1, 0, 1));
    expect(false, box(0, 0, 0, 1), box(0, 0, -1.1, 1));
}

static void annuli(void **unused)
{
    (void)unused;
    expect(true, ring(0, 0, 1, 2), ring(0, 0.5, 1.5, 3));
    expect(false, ring(0, 0, 1, 2), ring(0, 0, 2, 3));     // one round the other
    expect(false, ring(0, 0, 1, 2), ring(0.2, 0, 0, 0.7)); // in its hole
    expect(true, ring(0, 0, 1, 2), ring(0.4, 0, 0, 0.7));
    expect(false, ring(0, 0, 0, 1), ring(2.1, 0, 0, 1)); // beside it
    expect(false, ring(0, 0, 0, 1), ring(0, 1, 0, 1));   // on it
}

static void a_box_and_an_annulus(void **unused)
{
    (void)unused;
    expect(true, box(1.5, 0, 0, 1), ring(0, 0, 1, 2));
    expect(false, box(2, 0, 0, 1), ring(0, 0, 1, 2));
}

/** A disc of radius 2 whose normal is half way between x and z, and grains go 0.5 along it. */
static void the_box_around_a_disc(void **unused)
{
    (void)unused;
    const clod_case_region disc = {.kind = CLOD_REGION_DISC,
                                   .center = {1.0, 2.0, 3.0},
                                   .outer_radius = 2.0,
                                   .normal = {3.0, 0.0, -3.0},
                                   .depth = 0.5};
    double low[3], high[3];
    clod_region_bounds(&disc, low, high);
    const double reach = 2.0 * sqrt(0.5), way = 0.5 * sqrt(0.5);
    const double from[3] = {1.0 - reach, 0.0, 3.0 - reach - way};
    const double to[3] = {1.0 + reach + way, 4.0, 3.0 + reach};
    for (int k = 0; k < 3; k++) {
        check_relative(low[k] + 10.0, from[k] + 10.0, 1e-15);
        check_relative(high[k] + 10.0, to[k] + 10.0, 1e-15);
    }
    check_relative(clod_region_area(&disc), 4.0 * M_PI, 1e-15);
}

/** Edges of 2 and 4 in the plane of x and y; the axes are right-handed. */
static void the_box_around_a_rectangle(void **unused)
{
    (void)unused;
    const double s = sqrt(0.5);
    const clod_case_region face = {.kind = CLOD_REGION_RECTANGLE,
                                   .edge_1 = {2.0 * s, 2.0 * s, 0.0},
                                   .edge_2 = {-4.0 * s, 4.0 * s, 0.0},
                                   .normal = {0.0, 0.0, -8.0},
                                   .depth = 0.5};
    double low[3], high[3], axis[3][3], half[2];
    clod_region_bounds(&face, low, high);
    for (int k = 0; k < 2; k++) {
        check_relative(high[k], 3.0 * s, 1e-15);
        check_relative(low[k], -3.0 * s, 1e-15);
    }
    assert_true(low[2] == -0.5 && high[2] == 0.0);
    check_relative(clod_region_area(&face), 8.0, 1e-15);
    clod_region_axes(&face, axis);
    clod_region_half(&face, half);
    check_relative(half[0], 1.0, 1e-15);
    check_relative(half[1], 2.0, 1e-15);
    const double expected[3][3] = {{s, s, 0.0}, {s, -s, 0.0}, {0.0, 0.0, -1.0}};
    for (int a = 0; a < 3; a++) {
        for (int k = 0; k < 3; k++) {
            assert_true(fabs(axis[a][k] - expected[a][k]) < 1e-15);
        }
    }
}

/** Every kind has what others ask of it: what is put into has sizes, a face has axes. */
static void every_kind_has_its_row(void **unused)
{
    (void)unused;
    static const char *const NAMES[] = {[CLOD_REGION_BOX] = "box",
                                        [CLOD_REGION_ANNULUS] = "annulus",
                                        [CLOD_REGION_DISC] = "disc",
                                        [CLOD_REGION_RECTANGLE] = "rectangle"};
    for (int k = CLOD_REGION_BOX; k <= CLOD_REGION_RECTANGLE; k++) {
        const clod_case_region region = {.kind = k};
        const clod_region_kind_row *row = clod_region_row(&region);
        assert_string_equal(row->name, NAMES[k]);
        assert_true(row->face == (k == CLOD_REGION_DISC || k == CLOD_REGION_RECTANGLE));
        assert_true(row->upright == (k == CLOD_REGION_ANNULUS));
        assert_non_null(row->area);
        assert_non_null(row->top);
        assert_non_null(row->bounds);
        assert_true((row->size == NULL) == row->face);
        assert_true((row->axis != NULL) == row->face);
        assert_true((row->half != NULL) == row->face);
    }
}

/** A box from 1 to 4 and an annulus from 1 on, 3 high; 0.25 before a face at a height of 1. */
static void heights_by_hand(void **unused)
{
    (void)unused;
    const clod_case_region box = {.max = {1.0, 1.0, 4.0}, .min = {0.0, 0.0, 1.0}};
    const clod_case_region ring = {.kind = CLOD_REGION_ANNULUS,
                                   .center = {0.0, 0.0, 1.0},
                                   .outer_radius = 2.0,
                                   .height = 3.0};
    const clod_case_region disc = {
        .kind = CLOD_REGION_DISC, .center = {0.0, 0.0, 1.0}, .depth = 0.25};
    assert_true(clod_region_height(&box) == 3.0 && clod_region_row(&box)->top(&box) == 4.0);
    assert_true(clod_region_height(&ring) == 3.0 && clod_region_row(&ring)->top(&ring) == 4.0);
    assert_true(clod_region_height(&disc) == 0.25 && clod_region_row(&disc)->top(&disc) == 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes),
        cmocka_unit_test(annuli),
        cmocka_unit_test(a_box_and_an_annulus),
        cmocka_unit_test(the_box_around_a_disc),
        cmocka_unit_test(the_box_around_a_rectangle),
        cmocka_unit_test(every_kind_has_its_row),
        cmocka_unit_test(heights_by_hand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
