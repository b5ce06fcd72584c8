// Which regions of a case have space in common: cases drawn by hand.

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(boxes),
        cmocka_unit_test(annuli),
        cmocka_unit_test(a_box_and_an_annulus),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
