// Cross-sections of burdens on belts, beside those of ISO 5048 and the geometry they stand for.

#include <math.h>

#include "analysis/burden.h"
#include "support/check.h"

#define DEGREE (M_PI / 180.0)

/** The example of ScottMcCormack/conveyance (ISO 5048): B 1.2 m, l3 436 mm, 45 and 20 degrees. */
static void a_published_example(void **state)
{
    (void)state;
    const clod_burden_belt belt = {1.2, 0.436, 45.0 * DEGREE};
    const double width = clod_burden_width(belt.width);
    check_close(width, 1.03, 1e-12);
    const clod_burden_section section = clod_burden_of(&belt, width, 20.0 * DEGREE);
    check_close(section.heap, 0.04445, 5e-6);
    check_close(section.trough, 0.13567, 5e-6);
    check_close(4.8 * (section.heap + section.trough), 0.865, 5e-4); // m3/s at 4.8 m/s
}

/** Worked out by hand from the formulas, 15 degrees: three rolls at 35 degrees, and flat. */
static void other_belts(void **state)
{
    (void)state;
    static const double BELTS[4][4] = {{0.65, 0.25, 0.040413, 0.012782},
                                       {0.8, 0.315, 0.063262, 0.020047},
                                       {1.0, 0.38, 0.103303, 0.032266},
                                       {1.2, 0.465, 0.151287, 0.047378}};
    for (int k = 0; k < 4; k++) {
        clod_burden_belt belt = {BELTS[k][0], BELTS[k][1], 35.0 * DEGREE};
        const double width = clod_burden_width(belt.width);
        clod_burden_section section = clod_burden_of(&belt, width, 15.0 * DEGREE);
        check_close(section.heap + section.trough, BELTS[k][2], 1e-6);
        belt.idler_angle = 0.0;
        section = clod_burden_of(&belt, width, 15.0 * DEGREE);
        check_close(section.heap + section.trough, BELTS[k][3], 1e-6);
    }
}

/** Area between the belt and a parabola that meets it at both edges, by small strips. */
static double area_by_strips(const clod_burden_belt *belt, double width, double surcharge)
{
    const double wing = 0.5 * (width - belt->middle_roll);
    const double flat = 0.5 * belt->middle_roll, edge = flat + wing * cos(belt->idler_angle);
    const double height = wing * sin(belt->idler_angle);
    const int strips = 100000;
    double area = 0.0;
    for (int k = 0; k < strips; k++) {
        const double y = edge * (2.0 * (k + 0.5) / strips - 1.0);
        const double below = fmax(fabs(y) - flat, 0.0) * tan(belt->idler_angle);
        const double above =
            height + 0.5 * tan(surcharge) * (edge * edge - y * y) / edge; // slope tan t there
        area += (above - below) * 2.0 * edge / strips;
    }
    return area;
}

/** Two and three rolls: the formula is that area. */
static void the_section_is_that_of_a_parabola_on_the_trough(void **state)
{
    (void)state;
    static const clod_burden_belt BELTS[] = {{0.8, 0.3, 0.6}, {0.8, 0.0, 0.4}, {2.4, 0.9, 0.8}};
    for (int k = 0; k < 3; k++) {
        const double width = clod_burden_width(BELTS[k].width);
        const clod_burden_section section = clod_burden_of(&BELTS[k], width, 0.3);
        const double area = area_by_strips(&BELTS[k], width, 0.3);
        check_relative(section.heap + section.trough, area, 1e-8);
    }
}

static void wide_and_narrow_belts(void **state)
{
    (void)state;
    check_close(clod_burden_width(2.0), 1.75, 1e-12); // both rules meet there
    check_close(clod_burden_width(2.4), 2.15, 1e-12);
    check_close(clod_burden_width(0.05), 0.0, 0.0);
    // a middle roll wider than the burden: flat
    const clod_burden_belt belt = {0.8, 2.0, 0.6};
    check_close(clod_burden_of(&belt, 0.5, 0.3).trough, 0.0, 0.0);
    check_close(clod_burden_of(&belt, 0.5, 0.3).heap, 0.25 * tan(0.3) / 6.0, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_published_example),
        cmocka_unit_test(other_belts),
        cmocka_unit_test(the_section_is_that_of_a_parabola_on_the_trough),
        cmocka_unit_test(wide_and_narrow_belts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
