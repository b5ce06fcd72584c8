// The contact bench against closed forms by hand (docs/theory) and its check values.

#include "support/bench_path.h"

#define K1 4.75e8
#define K2 2.37e9
#define K5 3.56e8 // k_adh of Table 1, 5 %

#define MEPA(k_adh)                                                                            \
    "law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5, k_adh: " k_adh          \
    " N/m^1.5, restitution: 1, friction: 0.35"
#define LINEAR(k_adh)                                                                          \
    "law: mepa, exponent: 1, k1: 4.75e8 N/m, k2: 2.37e9 N/m, k_adh: " k_adh                    \
    " N/m, restitution: 1, friction: 0.35"
#define WALL "  material_2: light\n  wall: true\n  radius_1: 3 mm\n  legs:\n"

/** As a value printed with six decimals. */
static void printed(double value, double expected)
{
    if (!(fabs(value - expected) <= 5.1e-7)) {
        fail_msg("%.10g is not %.10g", value, expected);
    }
}

// Table of docs/theory/mepa.md, "check values", n = 3/2, d_max = 3e-6 m.
static void normal_force_has_the_check_values(void **state)
{
    (void)state;
    static const char *const LEGS = TWO "    - {overlap: 3 um, steps: 4}\n"
                                        "    - {overlap: 2.7 um, steps: 2}\n"
                                        "    - {overlap: 1.5 um, steps: 4}\n";
    static const double LOAD[] = {0.308522, 0.872631, 1.603125, 2.468172, 1.556200, 0.667921};
    const path *p = drive(MEPA("3.56e8"), LEGS);
    for (int r = 0; r < 6; r++) {
        printed(p->row[r].force, LOAD[r]);
        assert_int_equal(p->row[r].branch, r < 4 ? CLOD_BRANCH_LOADING : CLOD_BRANCH_UNLOADING);
    }
    near(p->row[3].plastic, 2.584413e-6, 1e-6);
    near(p->row[5].plastic, 2.584413e-6, 1e-6);
    printed(p->row[8].force, -0.859723); // on f3 at 0.60
    printed(p->row[9].force, -0.654014); // and at 0.50
    assert_int_equal(p->row[8].branch, CLOD_BRANCH_ADHESIVE);
    p = drive(MEPA("5.93e8"), LEGS);
    printed(p->row[8].force, -1.432067);
    printed(p->row[9].force, -1.089411);
}

// docs/theory/mepa.md: f3 down to 0.60, reload to 0.70, on to 1.10.
static void reloading_from_the_adhesive_branch(void **state)
{
    (void)state;
    static const char *const LEGS = TWO "    - {overlap: 3 um}\n    - {overlap: 1.8 um}\n"
                                        "    - {overlap: 2.1 um, steps: 1}\n"
                                        "    - {overlap: 3.3 um, steps: 100}\n";
    const path *p = drive(MEPA("3.56e8"), LEGS);
    printed(p->row[200].force, 0.629195);
    assert_int_equal(p->row[200].branch, CLOD_BRANCH_UNLOADING);
    near(p->row[300].force, K1 * pow(3.3e-6, 1.5), 1e-12); // f1 again: 2.847505
    assert_int_equal(p->row[300].branch, CLOD_BRANCH_LOADING);
    p = drive(MEPA("5.93e8"), LEGS);
    near(p->row[200].force, 0.0568512, 1e-6);
    p = drive(LINEAR("3.56e8"), TWO "    - {overlap: 1 um}\n    - {overlap: 0.6 um}\n"
                                    "    - {overlap: 0.7 um}\n");
    near(p->row[99].force, 475.0, 1e-12);
    near(p->row[299].force, 23.4, 1e-9);
}

// d_min/d_max = ((k2-k1)/(k2+k_adh))^(1/n), |f_min|/f_max = (k_adh/k1)(k2-k1)/(k2+k_adh).
static void summary_has_the_closed_forms(void **state)
{
    (void)state;
    const path *p = drive(MEPA("3.56e8"), TWO "    - {overlap: 3 um}\n"
                                              "    - {overlap: 0 um, steps: 3000}\n");
    const clod_contact_bench_summary *s = &p->summary;
    near(s->pull_off_overlap, 2.354201e-6 / 3e-6, 1e-6);
    near(s->pull_off_force, 1.285924 / 2.468172, 1e-6);
    near(s->d_max, 3e-6, 1e-14);
    near(s->f_max, K1 * pow(3e-6, 1.5), 1e-12);
    near(s->d_min, 2.354201e-6, 5e-4); // one step of the path is 1e-9 m
    near(s->f_min, -1.285924, 2e-3);
    near(s->f_before, s->f_max, 0.0);
    assert_int_equal(p->row[p->count - 1].branch, CLOD_BRANCH_OPEN);
    assert_true(p->row[p->count - 1].force == 0.0);
}

// n = 1, k_adh = 0: e = sqrt(k1/k2). n = 1 with adhesion: triangles of the loop by hand, below.
static void restitution_of_the_law(void **state)
{
    (void)state;
    const path *p = drive(LINEAR("0"), TWO "    - {overlap: 1 um}\n");
    near(p->summary.restitution_law, sqrt(K1 / K2), 1e-12);
    near(p->summary.restitution_both, sqrt(K1 / K2), 1e-12);
    // k1 1, k2 4, k_adh 1, D 1: in 1/2; out: P = 3/4, f2 from 3/4 to 1 gives 4/2 (1/4)^2 = 1/8;
    // m = 3/5, f2 from 3/4 to 3/5 takes 4/2 (3/20)^2 = 9/200, f3 takes (1/2)(9/25) = 9/50;
    // 1/8 - 9/200 - 9/50 < 0: sticks. With k_adh 0.2: m = 3/4.2 = 5/7, takes 2 (1/28)^2 = 1/392
    // and 0.1 (25/49) = 5/98; 1/8 - 1/392 - 20/392 = 28/392 = 1/14, e^2 = 1/7.
    p = drive("law: mepa, exponent: 1, k1: 1e6 N/m, k2: 4e6 N/m, k_adh: 1e6 N/m",
              TWO "    - {overlap: 1 um}\n");
    assert_true(p->summary.restitution_law == 0.0);
    assert_true(p->summary.restitution_both == 0.0);
    p = drive("law: mepa, exponent: 1, k1: 1e6 N/m, k2: 4e6 N/m, k_adh: 2e5 N/m",
              TWO "    - {overlap: 1 um}\n");
    near(p->summary.restitution_law, sqrt(1.0 / 7.0), 1e-12);
    assert_true(p->summary.restitution_both < p->summary.restitution_law);
}

// The impact is integrated, so it is compared with what is known in closed form: the elastic
// laws return the restitution that was asked for (Tsuji), and a law without dash-pot its own.
static void impact_returns_what_is_known(void **state)
{
    (void)state;
    const char *legs = TWO "    - {overlap: 1 um}\n";
    const path *p = drive("law: hooke, k1: 1e6 N/m, restitution: 0.6", legs);
    near(p->summary.restitution_both, 0.6, 1e-3);
    // z = -ln e/sqrt(ln^2 e + pi^2), gamma = 2 z sqrt(m* k1); m* of 3 and 6 mm: m1 8/9.
    const double m_star = 2481.3 * 4.0 / 3.0 * M_PI * 27e-9 * 8.0 / 9.0;
    const double z = -log(0.6) / sqrt(log(0.6) * log(0.6) + M_PI * M_PI);
    near(p->summary.damping_ratio, z, 1e-12);
    near(p->summary.damping_coefficient, 2.0 * z * sqrt(m_star * 1e6), 1e-12);
    p = drive("law: hertz, restitution: 0.4", legs);
    near(p->summary.restitution_both, 0.4, 5e-2); // Tsuji's formula is an approximation
    assert_true(p->summary.restitution_law == 1.0);
    const clod_law dry = {.exponent = 1.0,
                          .exponent_kind = CLOD_EXPONENT_ONE,
                          .k1 = 1e6,
                          .k2 = 4e6,
                          .k_adh = 2e5,
                          .virgin = 0.75,
                          .pull_off = 1.05};
    near(clod_contact_bench_impact(&dry, 1e-3, 1e-3, 1e-6), sqrt(1.0 / 7.0), 1e-3);
}

// gamma_n = 2 z sqrt(5/6) sqrt(m* dk), dk = 1.5 k1 sqrt(d); closing at 3 um in 1 ms.
static void damping_follows_from_the_duration(void **state)
{
    (void)state;
    const char *law = "law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5, "
                      "restitution: 0.5";
    const path *p = drive(law, TWO "    - {overlap: 3 um, duration: 1 ms, steps: 10}\n"
                                   "    - {overlap: 1.5 um, duration: 1 ms, steps: 1}\n");
    const double m_star = 2481.3 * 4.0 / 3.0 * M_PI * 27e-9 * 8.0 / 9.0;
    const double z = log(2.0) / sqrt(log(2.0) * log(2.0) + M_PI * M_PI);
    const double gamma = 2.0 * z * sqrt(5.0 / 6.0) * sqrt(m_star * 1.5 * K1 * sqrt(3e-6));
    near(p->row[9].damping, gamma * 3e-6 / 1e-3, 1e-12);
    near(p->row[9].time, 1e-3, 1e-12);
    assert_true(p->row[10].damping < 0.0); // parting: the dash-pot pulls
    p = drive(law, WALL "    - {overlap: 3 um, duration: 1 ms}\n"); // m* is the grain's mass
    near(p->row[99].damping, gamma * sqrt(9.0 / 8.0) * 3e-6 / 1e-3, 1e-12);
}

// Held at 3 um: k_t = dk = 1.5 k1 sqrt(d), F_t = -k_t xi up to mu (f + k_adh x), then constant.
static void friction_is_a_spring_up_to_its_limit(void **state)
{
    (void)state;
    const path *p = drive(MEPA("3.56e8"), TWO "    - {overlap: 3 um}\n"
                                              "    - {overlap: 3 um, slip: [0.3 um, -0.4 um]}\n"
                                              "    - {overlap: 3 um, slip: [6 um, -8 um]}\n");
    const double k_t = 1.5 * K1 * sqrt(3e-6);
    const double limit = 0.35 * (K1 + K5) * pow(3e-6, 1.5);
    const clod_contact_bench_row *stick = &p->row[199];
    near(stick->friction[0], -k_t * 0.3e-6, 1e-9);
    near(stick->friction[1], k_t * 0.4e-6, 1e-9);
    near(stick->spring[0], 0.3e-6, 1e-9);
    near(stick->limit, limit, 1e-12);
    assert_false(stick->sliding);
    // torque about the centre of 1: arm (-R' n) x F_t = R' (F_t2, -F_t1), R' = R - d/2
    const double arm = 3e-3 - 1.5e-6;
    near(stick->torque[0], arm * k_t * 0.4e-6, 1e-9);
    near(stick->torque[1], arm * k_t * 0.3e-6, 1e-9);
    assert_true(stick->torque[2] == 0.0);
    const clod_contact_bench_row *slide = &p->row[299];
    assert_true(slide->sliding);
    near(slide->friction[0], -0.6 * limit, 1e-9);
    near(slide->friction[1], 0.8 * limit, 1e-9);
    near(slide->spring[0], 0.6 * limit / k_t, 1e-9);
    near(slide->slip[0], 6.3e-6, 1e-12);
}

// epsd2: k_r = k_t R*^2, M = -k_r angle about t2, R* = 3*6/9 = 2 mm; no friction from rolling.
static void rolling_resists_without_slip(void **state)
{
    (void)state;
    const path *p = drive(MEPA("3.56e8") ", rolling: epsd2, rolling_friction: 0.3",
                          TWO "    - {overlap: 3 um}\n    - {overlap: 3 um, roll: 1e-4 rad}\n"
                              "    - {overlap: 3 um, roll: 1e-1 rad}\n");
    const double k_r = 1.5 * K1 * sqrt(3e-6) * 2e-3 * 2e-3;
    near(p->row[199].roll_torque[1], -k_r * 1e-4, 1e-9);
    near(p->row[199].torque[1], -k_r * 1e-4, 1e-6);
    near(p->row[199].roll_spring[1], 1e-4, 1e-9);
    assert_true(fabs(p->row[199].friction[0]) < 1e-9);
    const double cap = 0.3 * (K1 + K5) * pow(3e-6, 1.5) * 2e-3; // mu_r N R*
    near(p->row[299].roll_torque[1], -cap, 1e-9);
    p = drive(MEPA("3.56e8") ", rolling: epsd2, rolling_friction: 0.3",
              WALL "    - {overlap: 3 um}\n    - {overlap: 3 um, roll: 1e-4 rad}\n");
    near(p->row[199].roll_torque[1], -k_r * 1e-4 * 9.0 / 4.0, 1e-9); // R* = R = 3 mm
    assert_true(fabs(p->row[199].friction[0]) < 1e-9);
}

// At a wall the lever arm is R - d, and epsd's dash-pot 2 z_r sqrt(I k_r) with I = 7/5 m R^2
// about the contact, k_r = 2.25 mu_r^2 dk R^2; the grain rolls 1e-6 rad in 1 us steps of 1e-7
// rad.
static void a_wall_has_the_whole_overlap(void **state)
{
    (void)state;
    const path *p =
        drive(MEPA("3.56e8") ", rolling: epsd, rolling_friction: 0.3, "
                             "rolling_damping: 0.25",
              WALL "    - {overlap: 3 um}\n"
                   "    - {overlap: 3 um, roll: 1e-6 rad, duration: 10 us, steps: 10}\n"
                   "    - {overlap: 3 um, slip: [0.3 um, 0 um]}\n");
    const double tangent = 1.5 * K1 * sqrt(3e-6);
    const double mass = 2481.3 * 4.0 / 3.0 * M_PI * 27e-9;
    const double k_r = 2.25 * 0.09 * tangent * 9e-6;
    const double dash_pot = 2.0 * 0.25 * sqrt(1.4 * mass * 9e-6 * k_r) * 1e-6 / 10e-6;
    near(p->row[109].roll_torque[1], -k_r * 1e-6 - dash_pot, 1e-9);
    const clod_contact_bench_row *slip = &p->row[209];
    const double arm = 3e-3 - 3e-6; // its torque about t2 is -arm F_t1, the rest is rolling
    near(slip->friction[0], -tangent * 0.3e-6, 1e-9);
    near(slip->torque[1] - slip->roll_torque[1], arm * tangent * 0.3e-6, 1e-9);
}

// Twist turns grain 1 alone, the pair by half of it: 180 deg carry the spring from t1 to t2.
static void twist_carries_the_spring_along(void **state)
{
    (void)state;
    const path *p =
        drive(MEPA("0"), TWO "    - {overlap: 3 um}\n"
                             "    - {overlap: 3 um, slip: [0.3 um, 0 um]}\n"
                             "    - {overlap: 3 um, twist: 180 deg, steps: 3000}\n");
    const clod_contact_bench_row *end = &p->row[p->count - 1];
    const double force = 1.5 * K1 * sqrt(3e-6) * 0.3e-6;
    assert_true(fabs(end->friction[0]) < 1e-3 * force);
    near(end->friction[1], -force, 1e-6); // n x t1 = t2
    near(end->twist, M_PI, 1e-12);
}

// Adhesion at 10 %: f3 = -0.1 k_adh d^n, P is bounded by (1 + 0.1 k_adh/k2) x.
static void adhesion_is_a_fraction_of_its_value(void **state)
{
    (void)state;
    const path *p = drive(MEPA("3.56e8"), "  adhesion: 10 %\n" TWO "    - {overlap: 3 um}\n"
                                          "    - {overlap: 1 um}\n");
    near(p->row[199].force, -0.1 * K5 * pow(1e-6, 1.5), 1e-9);
    near(p->row[199].plastic, pow((1.0 + 0.1 * K5 / K2) * pow(1e-6, 1.5), 2.0 / 3.0), 1e-9);
}

static void a_gap_forgets_everything(void **state)
{
    (void)state;
    const path *p =
        drive(MEPA("3.56e8"), TWO "    - {overlap: 3 um}\n"
                                  "    - {overlap: 3 um, slip: [0.3 um, 0 um]}\n"
                                  "    - {overlap: -1 um}\n    - {overlap: 1 um, steps: 1}\n");
    assert_int_equal(p->row[299].branch, CLOD_BRANCH_OPEN);
    near(p->row[299].overlap, -1e-6, 1e-12);
    const clod_contact_bench_row *again = &p->row[300];
    near(again->force, K1 * 1e-9, 1e-12); // virgin again: 4.75e8 (1e-6)^1.5
    assert_int_equal(again->branch, CLOD_BRANCH_LOADING);
    assert_true(again->friction[0] == 0.0 && again->spring[0] == 0.0);
}

static void line_and_header_have_the_same_columns(void **state)
{
    (void)state;
    const clod_contact_bench_row row = {.time = 0.1,
                                        .overlap = -1.0 / 3.0,
                                        .branch = CLOD_BRANCH_ADHESIVE,
                                        .limit = 1e-300,
                                        .sliding = true};
    char line[CLOD_CONTACT_BENCH_LINE];
    clod_contact_bench_line(&row, line);
    size_t commas = 0;
    size_t heads = 0;
    for (const char *c = line; *c != '\0'; c++) {
        commas += *c == ',';
    }
    for (const char *c = clod_contact_bench_header(); *c != '\0'; c++) {
        heads += *c == ',';
    }
    assert_int_equal(commas, 22);
    assert_int_equal(heads, 22);
    char *next;
    assert_true(strtod(line, &next) == 0.1);
    assert_true(strtod(next + 1, NULL) == -1.0 / 3.0);
    assert_non_null(strstr(line, ",adhesive,"));
    assert_string_equal(line + strlen(line) - 2, ",1");
}

static void longest_line_fits(void **state)
{
    (void)state;
    const double w = -1.2345678901234567e-300; // 24 characters
    const clod_contact_bench_row row = {
        w, w,      {w, w}, w, w,   w, w, {w, w}, {w, w, w}, {w, w}, CLOD_BRANCH_UNLOADING,
        w, {w, w}, {w, w}, w, true};
    char line[CLOD_CONTACT_BENCH_LINE];
    clod_contact_bench_line(&row, line);
    assert_string_equal(line + strlen(line) - 2, ",1");
    assert_true(strlen(line) < CLOD_CONTACT_BENCH_LINE);
}

static bool refuse(void *context, const clod_contact_bench_row *row, clod_status *status)
{
    (void)context;
    (void)row;
    return clod_status_fail(status, CLOD_FAILED, "disk full");
}

static void failures_are_told(void **state)
{
    (void)state;
    clod_contact_bench_summary summary;
    clod_status status = {CLOD_OK, ""};
    clod_case *from = parse(MEPA("0"), TWO "    - {overlap: 1 um}\n");
    assert_false(clod_contact_bench_run(from, refuse, NULL, &summary, &status));
    assert_string_equal(status.text, "disk full");
    clod_case_destroy(&from);
    from = parse("law: hooke, k1: 1e6 N/m, restitution: 0.5",
                 "  material_2: light\n  radius_1: 3 mm\n  radius_2: 3 mm\n"
                 "  legs: [{overlap: 1 um}]\n");
    assert_false(clod_contact_bench_run(from, refuse, NULL, &summary, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "material light has no density"));
    clod_case_destroy(&from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(normal_force_has_the_check_values),
        cmocka_unit_test(reloading_from_the_adhesive_branch),
        cmocka_unit_test(summary_has_the_closed_forms),
        cmocka_unit_test(restitution_of_the_law),
        cmocka_unit_test(impact_returns_what_is_known),
        cmocka_unit_test(damping_follows_from_the_duration),
        cmocka_unit_test(friction_is_a_spring_up_to_its_limit),
        cmocka_unit_test(rolling_resists_without_slip),
        cmocka_unit_test(a_wall_has_the_whole_overlap),
        cmocka_unit_test(twist_carries_the_spring_along),
        cmocka_unit_test(adhesion_is_a_fraction_of_its_value),
        cmocka_unit_test(a_gap_forgets_everything),
        cmocka_unit_test(line_and_header_have_the_same_columns),
        cmocka_unit_test(longest_line_fits),
        cmocka_unit_test(failures_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
