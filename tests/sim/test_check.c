// The preflight against hand calculations (docs/theory/mepa.md, time-step.md, ring-shear.md),
// and every warning once.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>
#include <jansson.h>

#include "clod/check.h"
#include "support/case_of.h"

#define K1 4.75e8
#define K2 2.37e9
#define K_ADH 3.56e8
#define DENSITY 2481.3
#define RADIUS 3e-3
#define STRESS 50e3

#define MATERIALS                                                                              \
    "materials:\n"                                                                             \
    "  ore: {density: 2481.3 kg/m3, youngs_modulus: 119 GPa, poissons_ratio: 0.34}\n"          \
    "  side: {}\n"                                                                             \
    "contacts:\n"                                                                              \
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"          \
    "    k_adh: 3.56e8 N/m^1.5, restitution: 0.3, friction: 0.35}\n"

// Radii differ by at most one part in 3000: all grains count as 3 mm. Full to 40 mm by hand:
// 0.6 of 942478 mm3 (ring) - 37643 mm3 (40 bars of 49.4 x 3 x 6.35 mm) is 4800 grains of 113.1
// mm3.
static const char RING[] =
    MATERIALS "gravity: [0, 0, -10 m/s2]\n"
              "ring_shear:\n"
              "  grain_material: ore\n"
              "  side_material: side\n"
              "  base_material: side\n"
              "  lid_material: side\n"
              "  radius: {mean: 3 mm, sd: 1 mm, min: 2.999 mm, max: 3.001 mm}\n"
              "  grain_count: 4800\n"
              "  preshear_stress: 50 kPa\n"
              "  shear_stresses: [12.5 kPa, 25 kPa, 40 kPa]\n";

static const char FREE[] =
    MATERIALS "grains:\n"
              "  - material: ore\n"
              "    count: 100\n"
              "    radius: {distribution: uniform, min: 2.999 mm, max: 3.001 mm}\n"
              "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm]}}\n"
              "domain: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm],\n"
              "  periodic: [true, true, true]}\n"
              "time: {step: 2e-7 s, design_stress: 50 kPa}\n"
              "stages:\n"
              "  - {name: one, duration: 0.1 s}\n"
              "  - {name: two, duration: 0.2 s}\n";

static const char HERTZ[] =
    "materials:\n"
    "  ore: {density: 2481.3 kg/m3, youngs_modulus: 119 GPa, poissons_ratio: 0.34}\n"
    "contacts: {default: {law: hertz}}\n"
    "grains:\n"
    "  - material: ore\n"
    "    count: 10\n"
    "    radius: {distribution: uniform, min: 2.85 mm, max: 2.8501 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm]}}\n"
    "stages: [{name: one, duration: 1 ms}]\n";

/** What the test looks at, with the case that it borrows from. */
typedef struct looked {
    clod_case *from;
    clod_check_report report;
} looked;

static int look(void **state, const char *text, const char *change, int threads,
                clod_status *status)
{
    looked *self = *state;
    const clod_check_options options = {.threads = threads, .directory = "."};
    clod_case_destroy(&self->from);
    self->from = case_of(text, change);
    return clod_check_report_make(self->from, &options, &self->report, status);
}

static const clod_check_report *check(void **state, const char *text, const char *change)
{
    clod_status status = {CLOD_OK, ""};
    if (!look(state, text, change, 1, &status)) {
        fail_msg("%s", status.text);
    }
    return &((looked *)*state)->report;
}

static void near(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected))) {
        fail_msg("%.10g is not %.10g", value, expected);
    }
}

static double mass(void)
{
    return 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS * DENSITY;
}

// F = stress (2R)^2 = 1.8 N, d = (F/k1)^(1/n), pull |f_min| = F (k_adh/k1)(k2-k1)/(k2+k_adh).
static void contact_at_the_target_stress(void **state)
{
    const clod_check_report *r = check(state, RING, NULL);
    const double overlap = pow(1.8 / K1, 2.0 / 3.0);
    const double pull = 1.8 * (K_ADH / K1) * (K2 - K1) / (K2 + K_ADH);
    assert_int_equal(r->kind, CLOD_CASE_RING_SHEAR);
    assert_int_equal(r->grains, 4800);
    near(r->mass, 4800.0 * mass(), 1e-3);
    near(r->solid_volume, 4800.0 * mass() / DENSITY, 1e-3);
    near(r->stress, STRESS, 1e-12);
    near(r->contact_force, 1.8, 1e-3);
    near(r->overlap, overlap, 1e-3);
    near(r->overlap_ratio, overlap / RADIUS, 1e-3);
    near(r->pull_off, pull, 1e-3);
    near(r->bond, pull / (mass() * 10.0), 2e-3);
}

// Critical step 2 sqrt(m*/k), m* = m/2, k = 1.5 k2 sqrt(d); auto is a tenth of it. Rayleigh
// time of docs/theory/time-step.md: 2.27e-6 s at R = 2.85 mm, in proportion to R.
static void step_and_what_sets_it(void **state)
{
    const clod_check_report *r = check(state, RING, NULL);
    const double stiffness = 1.5 * K2 * cbrt(1.8 / K1);
    near(r->stiffness, stiffness, 1e-3);
    near(r->critical, 2.0 * sqrt(0.5 * mass() / stiffness), 1e-3);
    near(r->automatic, 0.1 * r->critical, 1e-12);
    assert_false(r->step_given);
    assert_true(r->step == r->automatic);
    // quarter of a swing on k1 d^1.5: 1.47163 d/v, v^2 = 2 (2/5) k1 d^2.5/m*; back on k2
    const double deep = pow(1.8 / K1, 2.0 / 3.0);
    const double speed = sqrt(0.8 * K1 * pow(deep, 2.5) / (0.5 * mass()));
    near(r->collision_steps, 1.47163 * deep / speed * (1.0 + sqrt(K1 / K2)) / r->step, 2e-3);
    assert_true(r->restitution == 0.3);
    assert_true(r->restitution_least < 0.3 && r->restitution_most > 0.29);
    assert_true(r->restitution_least > 0.2 && r->restitution_most < 0.35);
    near(r->pair_radius_1, RADIUS, 1e-3);
    near(r->pair_radius_2, RADIUS, 1e-3);
    assert_non_null(strstr(r->reason, "k2"));
    assert_string_equal(r->pair_1, "ore");
    assert_string_equal(r->pair_2, "ore");
    assert_false(r->rayleigh_imposed);
    near(r->rayleigh, 2.27e-6 * 3.0 / 2.85, 3e-3);
    near(r->rayleigh_fraction, r->step / r->rayleigh, 1e-12);
}

// I = speed/height 2R sqrt(rho/sigma); points are sheared with the same I, so 1/2 speed at 1/4.
static void ring_numbers(void **state)
{
    const clod_check_report *r = check(state, RING, NULL);
    near(r->inertial_preshear, 30.0 / 40.0 * 6e-3 * sqrt(DENSITY / STRESS), 1e-3);
    near(r->inertial_lowest, r->inertial_preshear, 1e-12);
    near((double)r->full_grains, 4800.0, 1e-3);
    near(r->height_aimed, 40e-3, 1e-3);
    near(r->inertial_loose, 30e-3 / r->height_loose * 6e-3 * sqrt(DENSITY / STRESS), 1e-3);
    const double column = r->height_loose * M_PI * (100e-3 * 100e-3 - 50e-3 * 50e-3);
    assert_true(r->solid_volume < 0.6 * column && r->solid_volume > 0.1 * column);
    near(r->lowest_stress, 12.5e3, 1e-12);
    near(r->lowest_speed, 15e-3, 1e-12);
    near(r->across_width, 50.0 / 6.0, 1e-3);
    near(r->across_depth, 40.0 / 6.0, 1e-3);
    near(r->bar_diameters, 6.35 / 6.0, 1e-3);
    assert_true(r->time_likely > 0.0 && r->time_likely < r->time_most);
    near(r->steps_most, r->time_most / r->step, 1e-12);
    assert_true(r->clock_likely > 0.0 && r->clock_likely < r->clock_most);
}

// At most: preshear_max at 30 mm/s, shear_max at 15, 21.2 and 26.8 mm/s, and what is the same.
static void limits_of_shear_bound_the_time(void **state)
{
    const double usual = check(state, RING, NULL)->time_most;
    const double preshear = check(state, RING, "ring_shear.preshear_max=145 mm")->time_most;
    const double shear = check(state, RING, "ring_shear.shear_max=30 mm")->time_most;
    const double twice = check(state, RING, "ring_shear.seeds=2")->time_most;
    near(preshear - usual, 4.0, 1e-9);
    near(shear - usual, 1.0 + 0.5 * sqrt(2.0) + 0.5 / sqrt(0.8), 1e-9);
    near(twice, 2.0 * usual, 1e-9);
}

// No contact, no walls: 0.3 s of 2e-7 s. Bond number without gravity has no meaning.
static void free_run_numbers(void **state)
{
    const clod_check_report *r = check(state, FREE, "gravity=[0, 0, 0 m/s2]");
    assert_int_equal(r->kind, CLOD_CASE_FREE);
    assert_int_equal(r->grains, 100);
    assert_true(r->step_given);
    assert_true(r->step == 2e-7);
    near(r->time_most, 0.3, 1e-12);
    near(r->steps_most, 1.5e6, 1e-12);
    near(r->steps_likely, 1.5e6, 1e-12);
    near(r->overlap, pow(1.8 / K1, 2.0 / 3.0), 1e-3);
    assert_true(r->bond == 0.0);
    assert_true(r->servo_period == 0.0);
    assert_int_equal(r->side_by_side, 1);
    // 300 rows of 4 columns; a number takes from 2 to 25 bytes
    assert_true(r->disk_series > 300 * 4 * 2 && r->disk_series < 300 * 4 * 25);
    assert_true(r->disk_free > 0.0);
    assert_true(r->rows_most == 300.0 && r->snapshots_most == 2.0);
    // rows of 13 doubles and 10 bytes are the least that a grain takes
    assert_true(r->memory > 100.0 * (13 * 8 + 10));
    assert_true(r->rate > 1e4 && r->rate < 1e10);
    near(r->clock_most, 1.5e6 * 100.0 / r->rate, 1.0); // within a factor of two
    assert_int_equal(r->warning_count, 0);
}

/** The change makes a warning with these words; without it there is none at all. */
static void warns(void **state, const char *text, const char *change, const char *words)
{
    const clod_check_report *r = check(state, text, change);
    for (size_t w = 0; w < r->warning_count; w++) {
        if (strstr(r->warning[w], words) != NULL) {
            return;
        }
    }
    fail_msg("%s: no warning says \"%s\"", change, words);
}

static void a_good_case_has_no_warning(void **state)
{
    const clod_check_report *r = check(state, RING, NULL);
    if (r->warning_count > 0) {
        fail_msg("%s", r->warning[0]);
    }
}

static void each_fault_has_its_warning(void **state)
{
    warns(state, RING, "time.step=1.2e-6 s", "above the safe step");
    warns(state, RING, "ring_shear.speed=150 mm/s", "even at the filling height: the grains'");
    warns(state, RING, "ring_shear.grain_count=2000",
          "2000 grains are 42 % of those that fill the depth (4");
    warns(state, RING, "ring_shear.grain_count=2000", "some 16.7 mm high, not 40 mm");
    warns(state, RING, "ring_shear.grain_count=7000", "7000 grains are 146 % of");
    warns(state, RING, "contacts.default.k1=4.75e6 N/m^1.5", "of their radius");
    warns(state, RING, "time.overlap_limit=0.05 %", "a run stops at 0.05 %");
    warns(state, RING, "ring_shear.grain_count=2900", "diameters across the depth");
    warns(state, RING, "ring_shear.outer_radius=75 mm", "diameters across the width");
    warns(state, RING, "ring_shear.bar_height=3 mm", "0.50 grain diameters high");
    warns(state, RING, "ring_shear.bar_count=0", "bar_count is 0");
    warns(state, RING, "ring_shear.lid_mass=1e-6 kg", "may be unstable");
    warns(state, RING, "ring_shear.shear_stresses=[4 kPa, 10 kPa, 20 kPa]", "8.0 %");
    warns(state, RING, "ring_shear.shear_stresses=[20 kPa, 30 kPa]", "three or more");
    warns(state, FREE, "output.series_interval=1e-13 s", "every step is written");
    warns(state, HERTZ, "time.rayleigh_limit=0.5", "50 % of the Rayleigh time");
}

// A row of four numbers at each of 5e12 steps.
static void a_disk_that_is_too_small_is_told(void **state)
{
    static char endless[sizeof FREE];
    memcpy(endless, FREE, sizeof FREE);
    memcpy(strstr(endless, "0.2 s"), "1e6 s", 5);
    warns(state, endless, "output.series_interval=1e-13 s", "would stop");
}

// At 60 mm/s and 40 mm I is 2.0e-3; the cohesive bed may be looser, the dry one is not.
static void a_dry_bed_is_judged_at_the_height_aimed_at(void **state)
{
    static char dry[sizeof RING];
    memcpy(dry, RING, sizeof RING);
    memcpy(strstr(dry, "3.56e8"), "0.00e8", 6);
    warns(state, dry, "ring_shear.speed=60 mm/s", "Lower ring_shear.speed to 30 mm/s");
    assert_int_equal(check(state, dry, "ring_shear.speed=30 mm/s")->warning_count, 0);
    assert_int_equal(check(state, RING, "ring_shear.speed=40 mm/s")->warning_count, 0);
}

// I = speed/height 2R sqrt(rho/sigma) = 0.04/0.04 * 6e-3 * sqrt(2481.3/50e3) = 1.3366e-3 at 40
// mm: 1.2e-3 at 44.6 mm, between the height aimed at and the loose one, and 1e-3 at 29.9 mm/s.
static void a_cohesive_bed_that_may_settle_too_low_is_noted(void **state)
{
    const clod_check_report *r = check(state, RING, "ring_shear.speed=40 mm/s");
    assert_true(r->inertial_loose < 1.2e-3 && r->height_loose > 44.6e-3);
    assert_int_equal(r->warning_count, 0);
    assert_int_equal(r->note_count, 1);
    assert_non_null(strstr(r->note[0],
                           "40 mm/s may be too fast if the bed settles below 44.6 mm "
                           "(inertial number above 0.0012)"));
    assert_non_null(strstr(r->note[0], "30 mm/s is slow enough at any height"));
    assert_int_equal(check(state, RING, "ring_shear.speed=35 mm/s")->note_count, 0);
    r = check(state, RING, "ring_shear.speed=150 mm/s"); // a warning takes its place
    assert_int_equal(r->note_count, 0);
}

// 29.93 mm/s at 40 mm has 1e-3, whatever the height at which it was warned of; what is advised is not warned or noted again.
static void the_speed_advised_is_slow_enough_at_once(void **state)
{
    warns(state, RING, "ring_shear.speed=150 mm/s",
          "Lower ring_shear.speed to 30 mm/s, slow enough wherever the bed settles");
    const clod_check_report *r = check(state, RING, "ring_shear.speed=30 mm/s");
    assert_int_equal(r->warning_count + r->note_count, 0);
}

// By hand: 40 kg under 10 m/s2 on pi (0.1^2 - 0.05^2) m2 press with 16.98 kPa, more than the
// lowest point of 12.5 kPa; 29 kg with 12.31 kPa. The run's servo knows no weight of the lid.
static void a_lid_heavier_than_the_lowest_point_is_noted(void **state)
{
    const clod_check_report *r = check(state, RING, "ring_shear.lid_mass=40 kg");
    assert_int_equal(r->warning_count, 0);
    assert_int_equal(r->note_count, 1);
    assert_non_null(strstr(r->note[0], "would press with 17 kPa by its weight"));
    assert_non_null(strstr(r->note[0], "the run holds that stress all the same"));
    assert_int_equal(check(state, RING, "ring_shear.lid_mass=29 kg")->note_count, 0);
}

static void notes_are_in_json_and_text(void **state)
{
    static char text[CLOD_CHECK_TEXT];
    const clod_check_report *r = check(state, RING, "ring_shear.speed=40 mm/s");
    clod_check_report_text(r, text);
    assert_non_null(strstr(text, "warnings           none\nnote               40 mm/s may be"));
    assert_true(clod_check_report_json(r, text));
    json_t *json = json_loads(text, 0, NULL);
    assert_non_null(json);
    const json_t *notes = json_object_get(json, "notes");
    assert_int_equal(json_array_size(notes), 1);
    assert_string_equal(json_string_value(json_array_get(notes, 0)), r->note[0]);
    json_decref(json);
}

// Critical step 2 sqrt(m*/k) as in step_and_what_sets_it: 8.8e-6 s.
static void a_step_beyond_the_critical_one_is_wrong_use(void **state)
{
    const double critical = 2.0 * sqrt(0.5 * mass() / (1.5 * K2 * cbrt(1.8 / K1)));
    char step[48];
    clod_status status = {CLOD_OK, ""};
    snprintf(step, sizeof step, "time.step=%.6g s", 1.01 * critical);
    assert_false(look(state, RING, step, 1, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "beyond the critical step"));
    snprintf(step, sizeof step, "time.step=%.6g s", 0.99 * critical);
    warns(state, RING, step, "more than nine tenths");
}

static void the_rayleigh_limit_sets_the_step_of_hertz(void **state)
{
    const clod_check_report *r = check(state, HERTZ, NULL);
    assert_true(r->rayleigh_imposed);
    near(r->step, 0.15 * 2.27e-6, 3e-3); // docs/theory/time-step.md
}

static void json_and_text_say_the_same(void **state)
{
    static char text[CLOD_CHECK_TEXT];
    const clod_check_report *r = check(state, RING, "ring_shear.bar_height=3 mm");
    assert_true(clod_check_report_json(r, text));
    json_t *json = json_loads(text, 0, NULL);
    assert_non_null(json);
    assert_int_equal(json_integer_value(json_object_get(json, "grains")), 4800);
    assert_string_equal(json_string_value(json_object_get(json, "kind")), "ring_shear");
    assert_true(json_real_value(json_object_get(json, "step_s")) == r->step);
    assert_true(json_real_value(json_object_get(json, "overlap_m")) == r->overlap);
    assert_true(json_real_value(json_object_get(json, "bar_height_diameters")) ==
                r->bar_diameters);
    const json_t *warnings = json_object_get(json, "warnings");
    assert_int_equal(json_array_size(warnings), r->warning_count);
    assert_string_equal(json_string_value(json_array_get(warnings, 0)), r->warning[0]);
    json_decref(json);
    clod_check_report_text(r, text);
    assert_non_null(strstr(text, "grains             4800, radius 2.999"));
    assert_non_null(strstr(text, r->warning[0]));
}

static void a_contact_bench_needs_no_estimate(void **state)
{
    static char text[CLOD_CHECK_TEXT];
    static const char BENCH[] = MATERIALS "contact_bench:\n"
                                          "  material_1: ore\n  material_2: ore\n"
                                          "  radius_1: 3 mm\n  radius_2: 3 mm\n"
                                          "  legs: [{overlap: 1 um}]\n";
    const clod_check_report *r = check(state, BENCH, NULL);
    assert_int_equal(r->kind, CLOD_CASE_CONTACT_BENCH);
    clod_check_report_text(r, text);
    assert_non_null(strstr(text, "clod contact"));
    assert_true(clod_check_report_json(r, text));
}

static void grains_that_do_not_fit_are_wrong_use(void **state)
{
    clod_status status = {CLOD_OK, ""};
    assert_false(look(state, FREE, "grains.0.count=100000", 1, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_true(strlen(status.text) > 0);
}

static int begin(void **state)
{
    static looked self;
    *state = &self;
    return 0;
}

static int end(void **state)
{
    clod_case_destroy(&((looked *)*state)->from);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contact_at_the_target_stress),
        cmocka_unit_test(step_and_what_sets_it),
        cmocka_unit_test(ring_numbers),
        cmocka_unit_test(limits_of_shear_bound_the_time),
        cmocka_unit_test(free_run_numbers),
        cmocka_unit_test(a_good_case_has_no_warning),
        cmocka_unit_test(each_fault_has_its_warning),
        cmocka_unit_test(a_disk_that_is_too_small_is_told),
        cmocka_unit_test(a_dry_bed_is_judged_at_the_height_aimed_at),
        cmocka_unit_test(a_cohesive_bed_that_may_settle_too_low_is_noted),
        cmocka_unit_test(the_speed_advised_is_slow_enough_at_once),
        cmocka_unit_test(a_lid_heavier_than_the_lowest_point_is_noted),
        cmocka_unit_test(notes_are_in_json_and_text),
        cmocka_unit_test(a_step_beyond_the_critical_one_is_wrong_use),
        cmocka_unit_test(the_rayleigh_limit_sets_the_step_of_hertz),
        cmocka_unit_test(json_and_text_say_the_same),
        cmocka_unit_test(a_contact_bench_needs_no_estimate),
        cmocka_unit_test(grains_that_do_not_fit_are_wrong_use),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
