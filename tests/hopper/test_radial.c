// Jenike's radial stress field: against numbers of an independent solution, against published
// charts, against exact limits and the balance of forces of a whole hopper.

#include "hopper/radial.h"
#include "support/check.h"

#define DEGREE (M_PI / 180.0)

static clod_radial field(clod_radial_shape shape, double phi_e, double phi_w)
{
    return (clod_radial){shape, phi_e * DEGREE, phi_w * DEGREE, CLOD_RADIAL_TOLERANCE};
}

static clod_radial_wall solve(const clod_radial *of, double theta)
{
    clod_radial_wall wall;
    assert_true(clod_radial_solve(of, theta * DEGREE, &wall));
    return wall;
}

/** ff with H by Arnold and McLean's fit. */
static double flow_factor(const clod_radial *of, double theta)
{
    const double thickness =
        of->shape == CLOD_RADIAL_CONE ? (130.0 + theta) / 65.0 : (200.0 + theta) / 200.0;
    return thickness * solve(of, theta).sigma_1 / (2.0 * sin(theta * DEGREE));
}

static double limit(clod_radial_shape shape, double phi_e, double phi_w)
{
    const clod_radial of = field(shape, phi_e, phi_w);
    double theta;
    assert_true(clod_radial_limit(&of, &theta));
    return theta / DEGREE;
}

// Another solution of the same equations (fixed steps of a Runge-Kutta method of order 4), printed
// to four digits behind the point: half of the last one.
static void flow_factors_match_an_independent_solution(void **state)
{
    (void)state;
    static const struct {
        clod_radial_shape shape;
        double phi_e, phi_w, theta, flow_factor;
    } KNOWN[] = {
        {CLOD_RADIAL_CONE, 30, 15, 20, 1.7186},    {CLOD_RADIAL_CONE, 30, 19, 27.5, 1.8233},
        {CLOD_RADIAL_CONE, 40, 16, 29.5, 1.5075},  {CLOD_RADIAL_CONE, 40, 20, 20, 1.4176},
        {CLOD_RADIAL_CONE, 50, 22.93, 18, 1.2705}, {CLOD_RADIAL_WEDGE, 40, 20, 25, 1.3646},
        {CLOD_RADIAL_WEDGE, 40, 20, 35, 1.4158},   {CLOD_RADIAL_WEDGE, 50, 25, 30, 1.2303},
    };
    for (size_t k = 0; k < sizeof KNOWN / sizeof KNOWN[0]; k++) {
        const clod_radial of = field(KNOWN[k].shape, KNOWN[k].phi_e, KNOWN[k].phi_w);
        check_close(flow_factor(&of, KNOWN[k].theta), KNOWN[k].flow_factor, 0.00006);
    }
}

// Jenike's charts as textbooks read them: flow factors to 0.1, so within 0.05 and the line's own
// width, 0.02 (Rhodes, ch. 10: 1.8; a tutorial after it: 1.5; silo_design, after Schulze: 1.3);
// limits to half a degree, drawn with a line half a degree wide.
static void charts_are_met_within_their_reading(void **state)
{
    (void)state;
    const clod_radial a = field(CLOD_RADIAL_CONE, 30, 19);
    const clod_radial b = field(CLOD_RADIAL_CONE, 40, 16);
    const clod_radial c = field(CLOD_RADIAL_CONE, 50, 22.93);
    check_close(flow_factor(&a, 27.5), 1.8, 0.07);
    check_close(flow_factor(&b, 29.5), 1.5, 0.07);
    check_close(flow_factor(&c, 18.0), 1.3, 0.07);
    check_close(limit(CLOD_RADIAL_CONE, 30, 19), 30.5, 1.0);
    check_close(limit(CLOD_RADIAL_CONE, 40, 16), 32.5, 1.0);
}

// The closed limit 90 - acos((1 - s)/(2 s))/2 - beta is an approximation: the independent solution
// found it between 0.01 and 1.09 degrees below the field's. Above 1 degree only for phi_e = 30.
static void limits_lie_just_above_the_closed_form(void **state)
{
    (void)state;
    static const double PAIRS[][3] = {// phi_e, phi_w, most above; the last two walls are smooth
                                      {30, 19, 1.2}, {40, 16, 0.3}, {40, 20, 0.3},
                                      {50, 20, 0.1}, {40, 0, 1.2},  {50, 0, 1.2}};
    for (size_t k = 0; k < sizeof PAIRS / sizeof PAIRS[0]; k++) {
        const double s = sin(PAIRS[k][0] * DEGREE);
        const double beta = clod_radial_beta(PAIRS[k][0] * DEGREE, PAIRS[k][1] * DEGREE);
        const double closed = 90.0 - (0.5 * acos((1.0 - s) / (2.0 * s)) + beta) / DEGREE;
        const double found = limit(CLOD_RADIAL_CONE, PAIRS[k][0], PAIRS[k][1]);
        check_at_least(found, closed);
        check_at_most(found, closed + PAIRS[k][2]);
    }
}

// Expected: the equations in steps of 2.5e-4 rad (Runge-Kutta of order 4) from the axis with many q, the largest angle at which psi
// is that of the wall. A coarser solution, known before, has 31.28, 32.55, 27.15 and 26.14.
static void limits_are_those_of_an_independent_solution(void **state)
{
    (void)state;
    check_close(limit(CLOD_RADIAL_CONE, 30, 19), 31.3067, 0.002);
    check_close(limit(CLOD_RADIAL_CONE, 40, 16), 32.5642, 0.002);
    check_close(limit(CLOD_RADIAL_CONE, 40, 20), 27.1506, 0.002);
    check_close(limit(CLOD_RADIAL_CONE, 50, 20), 26.1618, 0.002);
}

// A solution is there up to the limit and none beyond it.
static void the_limit_parts_solutions_from_none(void **state)
{
    (void)state;
    static const double PAIRS[][2] = {{30, 19}, {40, 16}, {40, 20},
                                      {50, 20}, {60, 30}, {40, 30}};
    for (size_t k = 0; k < sizeof PAIRS / sizeof PAIRS[0]; k++) {
        const clod_radial of = field(CLOD_RADIAL_CONE, PAIRS[k][0], PAIRS[k][1]);
        double theta;
        clod_radial_wall wall;
        assert_true(clod_radial_limit(&of, &theta));
        assert_true(clod_radial_solve(&of, theta - 0.001 * DEGREE, &wall));
        assert_false(clod_radial_solve(&of, theta + 0.001 * DEGREE, &wall));
    }
}

// Expected: the equations in steps of 1e-3 rad (Runge-Kutta of order 4), q on the axis searched on a grid
// that closes in, psi's fall through that of the wall by a straight line: good to 0.02 deg.
static void a_plane_field_ends_only_on_rough_walls_and_far_behind_a_cone(void **state)
{
    (void)state;
    static const double ROUGH[][3] = {// phi_e, phi_w, limit
                                      {60, 25, 53.85},
                                      {60, 30, 46.79},
                                      {50, 30, 50.57},
                                      {70, 40, 29.85}};
    for (size_t k = 0; k < sizeof ROUGH / sizeof ROUGH[0]; k++) {
        const double found = limit(CLOD_RADIAL_WEDGE, ROUGH[k][0], ROUGH[k][1]);
        check_close(found, ROUGH[k][2], 0.03);
        check_at_least(found, limit(CLOD_RADIAL_CONE, ROUGH[k][0], ROUGH[k][1]) + 25.0);
    }
    static const double USUAL[][2] = {{30, 10}, {30, 25}, {40, 20}, {50, 20}, {60, 20}};
    for (size_t k = 0; k < sizeof USUAL / sizeof USUAL[0]; k++) {
        check_close(limit(CLOD_RADIAL_WEDGE, USUAL[k][0], USUAL[k][1]),
                    CLOD_RADIAL_WIDEST / DEGREE, 1e-9); // all that is looked at
    }
}

/** Derivatives of q and psi, solved by Cramer's rule from the equilibrium of a sphere or cylinder
 *  in its stresses: an own writing down of them. */
static void derive(const clod_radial *of, double t, double q, double psi, double *dq,
                   double *dpsi)
{
    const double s = sin(of->phi_e);
    const double cone = of->shape == CLOD_RADIAL_CONE ? 1.0 : 0.0;
    const double r = q * (1.0 + s * cos(2.0 * psi));
    const double across = q * (1.0 - s * cos(2.0 * psi));
    const double hoop = q * (1.0 + s);
    const double shear = q * s * sin(2.0 * psi);
    // d(stress)/d(ln r) is the stress, for it grows with r; x cot(t) -> dx/dt on the axis
    const double cot = t > 0.0 ? 1.0 / tan(t) : 0.0;
    const double radial = r + (r - across) + cone * (r - hoop + shear * cot) + cos(t);
    const double turned = shear + 2.0 * shear + cone * (shear + (across - hoop) * cot) - sin(t);
    // shear' = a dq + b dpsi, across' = c dq + d dpsi; -radial = shear', -turned = across'
    const double axis = t > 0.0 ? 1.0 : 1.0 + cone; // the limit of shear cot(t) is shear'
    const double a = s * sin(2.0 * psi) * axis;
    const double b = 2.0 * q * s * cos(2.0 * psi) * axis;
    const double c = 1.0 - s * cos(2.0 * psi);
    const double d = 2.0 * q * s * sin(2.0 * psi);
    *dq = (-radial * d + turned * b) / (a * d - b * c);
    *dpsi = (-turned * a + radial * c) / (a * d - b * c);
}

/** Vertical force on a cap of the hopper per theta: what its stresses carry. */
static double carried(const clod_radial *of, double t, double q, double psi)
{
    const double s = sin(of->phi_e);
    const double force =
        q * s * sin(2.0 * psi) * sin(t) - q * (1.0 + s * cos(2.0 * psi)) * cos(t);
    return of->shape == CLOD_RADIAL_CONE ? 3.0 * force * sin(t) : 2.0 * force;
}

/**
 * From the axis on with fixed steps; the weight of the solid between two caps must be what the
 * cap's growth and the wall carry. Returns what is missing, relative to the weight.
 */
static double unbalance(const clod_radial *of, double theta, const clod_radial_wall *wall)
{
    enum { STEPS = 4000 };
    const double h = theta * DEGREE / STEPS;
    double q = wall->axis;
    double psi = M_PI_2;
    double sum = 0.0;
    for (int k = 0; k < STEPS; k++) {
        double dq[4];
        double dp[4];
        const double t = k * h;
        derive(of, t, q, psi, &dq[0], &dp[0]);
        derive(of, t + 0.5 * h, q + 0.5 * h * dq[0], psi + 0.5 * h * dp[0], &dq[1], &dp[1]);
        derive(of, t + 0.5 * h, q + 0.5 * h * dq[1], psi + 0.5 * h * dp[1], &dq[2], &dp[2]);
        derive(of, t + h, q + h * dq[2], psi + h * dp[2], &dq[3], &dp[3]);
        const double before = carried(of, t, q, psi);
        q += h / 6.0 * (dq[0] + 2.0 * dq[1] + 2.0 * dq[2] + dq[3]);
        psi += h / 6.0 * (dp[0] + 2.0 * dp[1] + 2.0 * dp[2] + dp[3]);
        sum += 0.5 * h * (before + carried(of, t + h, q, psi));
    }
    const double beta = clod_radial_beta(of->phi_e, of->phi_w);
    check_close(psi, M_PI_2 + beta, 1e-6);
    check_relative(wall->q, q, 1e-6);
    const double end = theta * DEGREE;
    const bool cone = of->shape == CLOD_RADIAL_CONE;
    const double weight = cone ? 1.0 - cos(end) : end;
    const double lift = wall->sigma_w * (sin(end) + tan(of->phi_w) * cos(end));
    return (sum + lift * (cone ? sin(end) : 1.0) - weight) / weight;
}

// Trapezoids of 4000 steps: 1e-7 of the whole, and the wall's stresses to 1e-6.
static void a_hopper_carries_its_weight(void **state)
{
    (void)state;
    static const double CASES[][3] = {
        {30, 19, 27.5}, {40, 20, 20}, {50, 20, 10}, {60, 30, 12}, {40, 5, 30}};
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        for (int shape = CLOD_RADIAL_WEDGE; shape <= CLOD_RADIAL_CONE; shape++) {
            const clod_radial of = field((clod_radial_shape)shape, CASES[k][0], CASES[k][1]);
            const clod_radial_wall wall = solve(&of, CASES[k][2]);
            check_close(unbalance(&of, CASES[k][2], &wall), 0.0, 1e-5);
        }
    }
}

// A steep hopper is a channel: its wall carries all, sigma_w tan(phi_w) 4/D = rho g, 2/D for a slot
// of width D = 2 r sin(theta). What differs falls with theta: a tenth for a tenth.
static void steep_hoppers_become_channels(void **state)
{
    (void)state;
    for (int shape = CLOD_RADIAL_WEDGE; shape <= CLOD_RADIAL_CONE; shape++) {
        const clod_radial of = field((clod_radial_shape)shape, 40, 20);
        const double sides = shape == CLOD_RADIAL_CONE ? 4.0 : 2.0;
        double off[2];
        for (int k = 0; k < 2; k++) {
            const double theta = k == 0 ? 0.5 : 0.05;
            const double width = 2.0 * sin(theta * DEGREE);
            off[k] = 1.0 - solve(&of, theta).sigma_w * tan(20.0 * DEGREE) * sides / width;
        }
        check_close(off[1], 0.0, 0.002);
        check_relative(off[0] / off[1], 10.0, 0.05);
    }
}

static void tighter_steps_change_nothing(void **state)
{
    (void)state;
    static const double CASES[][3] = {{30, 19, 27.5}, {40, 20, 20}, {60, 30, 10}, {70, 30, 10}};
    for (size_t k = 0; k < sizeof CASES / sizeof CASES[0]; k++) {
        clod_radial of = field(CLOD_RADIAL_CONE, CASES[k][0], CASES[k][1]);
        const double flow = flow_factor(&of, CASES[k][2]);
        double wide;
        double tight;
        assert_true(clod_radial_limit(&of, &wide));
        of.tolerance *= 0.5;
        check_relative(flow_factor(&of, CASES[k][2]), flow, 1e-7);
        assert_true(clod_radial_limit(&of, &tight));
        check_close(tight, wide, 1e-6);
        of.tolerance *= 0.02;
        check_relative(flow_factor(&of, CASES[k][2]), flow, 1e-6);
    }
}

// Until no half angle is small enough, and from there on.
static void rougher_walls_need_steeper_hoppers(void **state)
{
    (void)state;
    for (double phi_e = 30.0; phi_e <= 70.0; phi_e += 10.0) {
        double last = 61.0;
        int found = 0;
        for (double phi_w = 1.0; phi_w < phi_e; phi_w += 3.0) {
            const clod_radial of = field(CLOD_RADIAL_CONE, phi_e, phi_w);
            double theta;
            const bool slides = clod_radial_limit(&of, &theta);
            assert_true(!slides || last > 0.0);
            assert_true(theta < last || (theta == 0.0 && last == 0.0));
            found += slides;
            last = theta;
        }
        assert_true(found >= 8);
    }
}

// tan(phi_w) = tau/sigma on the wall: s sin(2 beta)/(1 + s cos(2 beta)).
static void the_wall_has_its_friction(void **state)
{
    (void)state;
    const double s = sin(40.0 * DEGREE);
    const double beta = clod_radial_beta(40.0 * DEGREE, 20.0 * DEGREE);
    check_relative(s * sin(2.0 * beta) / (1.0 + s * cos(2.0 * beta)), tan(20.0 * DEGREE),
                   1e-12);
    check_close(clod_radial_beta(40.0 * DEGREE, 0.0), 0.0, 1e-15);
}

// Rough is rough: phi_w of phi_e and more, and where the velocity at the wall is zero.
static void no_solid_slides_along_a_rough_wall(void **state)
{
    (void)state;
    clod_radial_wall wall;
    double theta;
    static const double ROUGH[] = {36.0, 40.0, 45.0, 89.0};
    for (size_t k = 0; k < sizeof ROUGH / sizeof ROUGH[0]; k++) {
        for (int shape = CLOD_RADIAL_WEDGE; shape <= CLOD_RADIAL_CONE; shape++) {
            const clod_radial of = field((clod_radial_shape)shape, 40, ROUGH[k]);
            assert_true(isnan(clod_radial_beta(of.phi_e, of.phi_w)));
            assert_false(clod_radial_limit(&of, &theta));
            assert_false(clod_radial_solve(&of, 5.0 * DEGREE, &wall));
        }
    }
}

/** Psi at theta [rad] from a q on the axis, in fixed steps; 135 degrees from where the solid stands still. */
static double psi_from(const clod_radial *of, double theta, double q)
{
    enum { STEPS = 200 };
    const double h = theta / STEPS;
    double psi = M_PI_2;
    for (int k = 0; k < STEPS; k++) {
        double dq[2];
        double dp[2];
        derive(of, k * h, q, psi, &dq[0], &dp[0]);
        derive(of, (k + 0.5) * h, q + 0.5 * h * dq[0], psi + 0.5 * h * dp[0], &dq[1], &dp[1]);
        q += h * dq[1];
        psi += h * dp[1];
        if (psi < M_PI_2 || psi >= 0.75 * M_PI) {
            return psi < M_PI_2 ? psi : 0.75 * M_PI;
        }
    }
    return psi;
}

/** The largest q on the axis that fits the wall, looked for at each hundredth of q from above; 0: none. */
static double axis_by_looking(const clod_radial *of, double theta)
{
    const double psi_w = M_PI_2 + clod_radial_beta(of->phi_e, of->phi_w);
    for (double q = 2.0; q > 1e-3; q *= 0.99) {
        const double psi = psi_from(of, theta, q);
        if (psi >= psi_w) {
            return psi < 0.75 * M_PI ? q : 0.0;
        }
    }
    return 0.0;
}

// Expected: the equations in fixed steps at each hundredth of q. Far enough off the limit that neither steps nor hundredths
// decide whether there is a solution, and the axis to two of them. A guess may be too small for any
// solution, or so that the solid stands still.
static void the_largest_q_is_found_from_any_guess(void **state)
{
    (void)state;
    static const double PAIRS[][2] = {{30, 19}, {40, 16}, {42, 24}, {50, 20},
                                      {60, 30}, {35, 2},  {50, 3}};
    static const double BELOW[] = {15.0, 8.0, 3.0, 1.0, 0.05, -1.0}; // the limit, degrees
    static const double GUESSES[] = {0.0, 1e-4, 0.003, 0.01, 0.014, 0.02, 0.05, 0.1, 0.4, 3.0};
    for (size_t k = 0; k < sizeof PAIRS / sizeof PAIRS[0]; k++) {
        const clod_radial of = field(CLOD_RADIAL_CONE, PAIRS[k][0], PAIRS[k][1]);
        const double widest = limit(CLOD_RADIAL_CONE, PAIRS[k][0], PAIRS[k][1]);
        for (size_t at = 0; at < sizeof BELOW / sizeof BELOW[0]; at++) {
            const double theta = fmax(1.0, widest - BELOW[at]) * DEGREE;
            const double axis = axis_by_looking(&of, theta);
            assert_true((axis > 0.0) == (BELOW[at] > 0.0));
            for (size_t g = 0; g < sizeof GUESSES / sizeof GUESSES[0]; g++) {
                clod_radial_wall wall;
                const bool found = clod_radial_solve_near(&of, theta, GUESSES[g], &wall);
                assert_true(found == (BELOW[at] > 0.0));
                assert_true(!found || fabs(wall.axis / axis - 1.0) < 0.02);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flow_factors_match_an_independent_solution),
        cmocka_unit_test(charts_are_met_within_their_reading),
        cmocka_unit_test(limits_lie_just_above_the_closed_form),
        cmocka_unit_test(limits_are_those_of_an_independent_solution),
        cmocka_unit_test(the_limit_parts_solutions_from_none),
        cmocka_unit_test(a_plane_field_ends_only_on_rough_walls_and_far_behind_a_cone),
        cmocka_unit_test(a_hopper_carries_its_weight),
        cmocka_unit_test(steep_hoppers_become_channels),
        cmocka_unit_test(tighter_steps_change_nothing),
        cmocka_unit_test(rougher_walls_need_steeper_hoppers),
        cmocka_unit_test(the_wall_has_its_friction),
        cmocka_unit_test(no_solid_slides_along_a_rough_wall),
        cmocka_unit_test(the_largest_q_is_found_from_any_guess),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
