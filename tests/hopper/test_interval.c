// Errors carried to results, where they can be worked out by hand.

#include "hopper/interval.h"
#include "hopper/line_fit.h"
#include "hopper/solid_made.h"

#define SAMPLES 500

/** A hopper of which only the shapes' values are known. Its half angle is given, so its wall needs an error: one too small
 *  to change any digit. */
static void begin(clod_hopper *self, const clod_solid *solid)
{
    clod_curve_point *wall = &solid->wall.points[0];
    wall->y_error = wall->y_error > 0.0 ? wall->y_error : 1e-30;
    *self = (clod_hopper){.solid = *solid,
                          .from = {.interval = {.level = 0.9, .samples = SAMPLES, .seed = 7}}};
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_hopper_found *found = &self->shape[s];
        found->wish = wish_of((clod_radial_shape)s, 15.0, CLOD_HOPPER_ARCH_ARNOLD);
        found->design = clod_hopper_design_shape(solid, &found->wish);
        clod_hopper_outcome outcome;
        double number[CLOD_HOPPER_NUMBERS];
        clod_interval_numbers(solid, found, &outcome, number);
        for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
            found->number[n].value = number[n];
        }
    }
}

static void fill(clod_hopper *self)
{
    clod_status status;
    assert_true(clod_interval_fill(self, &status));
}

/** At 2 and 10 kPa, with errors that are told, and lost in round-off. */
static void add_exact_strengths(made *of)
{
    add_strength(of, 2.0, 1.4);
    add_strength(of, 10.0, 3.0);
    of->strength[0].y_error = of->strength[1].y_error = 1e-20;
}

// A quantile at 5 % of n samples scatters by sqrt(0.05 x 0.95/n)/0.1031 standard deviations: 0.0945
// for 500. Three times that.
#define QUANTILE_ERROR 0.284

/** B goes with 1/rho: its 5 and 95 % are at rho +- 1.645 of its error. */
static void an_error_of_the_density_alone(void **state)
{
    (void)state;
    static made of;
    static clod_hopper hopper;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_exact_strengths(&of);
    of.rho.y_error = 60.0;
    begin(&hopper, &of.solid);
    fill(&hopper);
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        const clod_hopper_value *outlet = &hopper.shape[s].number[CLOD_HOPPER_OUTLET];
        const double at = hopper.shape[s].design.outlet;
        check_close(1500.0 * at / outlet->low, 1500.0 + 1.645 * 60.0, QUANTILE_ERROR * 60.0);
        check_close(1500.0 * at / outlet->high, 1500.0 - 1.645 * 60.0, QUANTILE_ERROR * 60.0);
        check_close(hopper.shape[s].share[CLOD_HOPPER_FLOWS], 1.0, 1e-12);
        const clod_hopper_value *factor = &hopper.shape[s].number[CLOD_HOPPER_FLOW_FACTOR];
        check_relative(factor->low, factor->high, 1e-12);
    }
}

/**
 * Flow function through two points: with equal relative errors e of f_c, independent, at 2 and 10
 * kPa (1.4 and 3.0), f_c where it meets sigma_1 = ff f_c is, for small e, linear in both:
 * f = f_1 (1 - p) + f_2 p with p = (sigma_1 - 2)/8, and d(f) = [d(f_1)(1 - p) + d(f_2) p]/
 * (1 - 0.2 ff).
 */
static void errors_of_the_flow_function(void **state)
{
    (void)state;
    static made of;
    static clod_hopper hopper;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_exact_strengths(&of);
    of.strength[0].y_error = 0.01 * 1400.0;
    of.strength[1].y_error = 0.01 * 3000.0;
    begin(&hopper, &of.solid);
    fill(&hopper);
    const clod_hopper_found *cone = &hopper.shape[CLOD_RADIAL_CONE];
    const double p = (1e-3 * cone->design.state.sigma_1 - 2.0) / 8.0;
    const double error =
        hypot(14.0 * (1.0 - p), 30.0 * p) / (1.0 - 0.2 * cone->design.flow_factor);
    const clod_hopper_value *strength = &cone->number[CLOD_HOPPER_STRENGTH];
    check_close(strength->high, cone->design.state.strength + 1.645 * error,
                QUANTILE_ERROR * error);
    check_close(strength->low, cone->design.state.strength - 1.645 * error,
                QUANTILE_ERROR * error);
}

/** Half the width of the interval of f_c at the critical state. */
static double half_width(const clod_solid *solid)
{
    static clod_hopper hopper;
    begin(&hopper, solid);
    fill(&hopper);
    const clod_hopper_value *strength =
        &hopper.shape[CLOD_RADIAL_CONE].number[CLOD_HOPPER_STRENGTH];
    return 0.5 * (strength->high - strength->low);
}

/** Points off a line by a contrast that the line does not see, +h, -2h, +h at equal distances: the line is the same,
 *  and so are the samples but for the width, which is that of the errors times sqrt(chi-square/1), 6 h^2/e^2. Where chance
 *  hardly makes that, p below 0.05, one degree of freedom tells its size: Student's t, whose 5 % lie above 6.314, not 1.645. */
static void a_misfit_widens_the_interval(void **state)
{
    (void)state;
    static made of;
    const double error = 10.0, off[] = {0.0, 4.0, 7.0, 10.0};
    double width[4];
    for (int k = 0; k < 4; k++) {
        make_solid(&of, 45.0, 20.0, 1500.0);
        for (int i = 0; i < 3; i++) {
            add_strength(&of, 2.0 + 4.0 * i,
                         1.4 + 0.8 * i + 1e-3 * off[k] * (i == 1 ? -2.0 : 1.0));
            of.strength[i].y_error = error;
        }
        of.solid.strength.way = CLOD_CURVE_LINE;
        clod_line_fit_weigh(&of.solid.strength);
        check_relative(of.solid.strength.misfit.line.b, 0.2, 1e-12);
        width[k] = half_width(&of.solid);
    }
    check_relative(width[1], width[0], 1e-6);              // chi-square 0.96
    check_relative(width[2], sqrt(2.94) * width[0], 0.02); // p 0.09
    check_relative(width[3], sqrt(6.0) * 6.314 / 1.645 * width[0],
                   0.4); // p 0.014; of 500 samples it is known to 14 %
}

/** Three specimens off by -4, 0 and 4 % along the whole wall yield locus: tan(phi_w) = 0.3 has the
 *  standard error 4 %/sqrt(3) at any stress, also below the points, where errors drawn for each of
 *  them would be larger. */
static void specimens_of_a_wall_move_all_its_points(void **state)
{
    (void)state;
    static made of;
    static clod_hopper hopper;
    const double error = 0.04 / sqrt(3.0);
    double spread[2][3];
    clod_curve_point wall[2];
    for (int i = 0; i < 2; i++) {
        wall[i] = (clod_curve_point){.x = 10e3 * (i + 1), .y = 3e3 * (i + 1)};
        wall[i].y_error = error * wall[i].y;
        wall[i].spread = spread[i];
        for (int s = 0; s < 3; s++) {
            spread[i][s] = (s - 1) * 0.04 * wall[i].y / sqrt(6.0);
        }
    }
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_exact_strengths(&of);
    of.solid.wall =
        (clod_curve){.way = CLOD_CURVE_EXTENDED, .points = wall, .count = 2, .specimens = 3};
    begin(&hopper, &of.solid);
    fill(&hopper);
    const clod_hopper_value *angle = &hopper.shape[CLOD_RADIAL_CONE].number[CLOD_HOPPER_PHI_W];
    check_close(tan(angle->high), 0.3 * (1.0 + 1.645 * error), QUANTILE_ERROR * 0.3 * error);
    check_close(tan(angle->low), 0.3 * (1.0 - 1.645 * error), QUANTILE_ERROR * 0.3 * error);
}

/** With errors of nothing every sample is the design itself, to its last digit: samples are solved less finely. */
static void no_errors_no_width(void **state)
{
    (void)state;
    static made of;
    static clod_hopper hopper;
    make_solid(&of, 45.0, 20.0, 1500.0);
    add_exact_strengths(&of);
    begin(&hopper, &of.solid);
    hopper.from.interval.samples = 100;
    fill(&hopper);
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        const clod_hopper_value *outlet = &hopper.shape[s].number[CLOD_HOPPER_OUTLET];
        assert_true(outlet->low == outlet->high);
        check_relative(outlet->low, hopper.shape[s].design.outlet, 1e-14);
    }
}

/** A wall so rough that some samples are funnel flow: they count as no outlet large enough. */
static void funnel_flow_counts(void **state)
{
    (void)state;
    static made of;
    static clod_hopper hopper;
    make_solid(&of, 45.0, 34.0, 1500.0);
    add_exact_strengths(&of);
    of.wall.y_error = 0.1;
    begin(&hopper, &of.solid);
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_hopper_found *found = &hopper.shape[s];
        found->wish.half_angle = 5.0 * DEGREE;
        found->design = clod_hopper_design_shape(&of.solid, &found->wish);
        found->planned = 1e3 * found->design.outlet;
        found->number[CLOD_HOPPER_MARGIN].value = 1e3;
    }
    fill(&hopper);
    const clod_hopper_found *cone = &hopper.shape[CLOD_RADIAL_CONE];
    const double share = cone->share[CLOD_HOPPER_FUNNEL];
    assert_true(share > 0.1 && share < 0.9);
    check_close(share + cone->share[CLOD_HOPPER_FLOWS], 1.0, 1e-9);
    assert_true(isinf(cone->number[CLOD_HOPPER_OUTLET].high));
    assert_true(isfinite(cone->number[CLOD_HOPPER_OUTLET].low));
    assert_true(isfinite(cone->arched_high)); // that of the others
    check_relative(cone->arched_low, cone->number[CLOD_HOPPER_OUTLET].low, 0.02);
    check_close(cone->number[CLOD_HOPPER_HALF_ANGLE].low, 5.0 * DEGREE, 1e-12); // as given
    check_close(cone->number[CLOD_HOPPER_HALF_ANGLE].high, 5.0 * DEGREE, 1e-12);
    // with a wall angle that does not depend on stress they are in funnel flow at any outlet
    assert_true(cone->number[CLOD_HOPPER_MARGIN].low == 0.0);
    assert_true(cone->number[CLOD_HOPPER_MARGIN].high > 1.0);
    check_close(cone->arching, share, 1e-9);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_error_of_the_density_alone),
        cmocka_unit_test(errors_of_the_flow_function),
        cmocka_unit_test(a_misfit_widens_the_interval),
        cmocka_unit_test(specimens_of_a_wall_move_all_its_points),
        cmocka_unit_test(no_errors_no_width),
        cmocka_unit_test(funnel_flow_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
