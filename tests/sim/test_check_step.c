// The preflight of the time step: what the bed is estimated to bear, by hand (docs/theory/stability.md).

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "support/preflight.h"

#define K1 4.75e8
#define K2 2.37e9
#define RADIUS 3e-3
#define MASS (2481.3 * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS)

#define MATERIALS                                                                              \
    "materials:\n"                                                                             \
    "  ore: {density: 2481.3 kg/m3}\n"                                                         \
    "  side: {}\n"                                                                             \
    "contacts:\n"                                                                              \
    "  default: {law: mepa, exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5,\n"          \
    "    k_adh: 3.56e8 N/m^1.5, restitution: 0.3, friction: 0.35, rolling: none}\n"

// Radii differ by at most one part in 3000: all grains count as 3 mm.
static const char RING[] =
    MATERIALS "gravity: [0, 0, -10 m/s2]\n"
              "ring_shear:\n"
              "  grain_material: ore\n"
              "  side_material: side\n"
              "  base_material: side\n"
              "  lid_material: side\n"
              "  radius: {mean: 3 mm, sd: 1 mm, min: 2.999 mm, max: 3.001 mm}\n"
              "  preshear_stress: 50 kPa\n"
              "  speed: 20 mm/s\n"
              "  shear_stresses: [12.5 kPa, 25 kPa, 40 kPa]\n";

static const char FREE[] =
    MATERIALS "grains:\n"
              "  - material: ore\n"
              "    count: 100\n"
              "    radius: {distribution: uniform, min: 2.999 mm, max: 3.001 mm}\n"
              "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm]}}\n"
              "domain: {min: [0 mm, 0 mm, 0 mm], max: [60 mm, 60 mm, 60 mm],\n"
              "  periodic: [true, true, true]}\n"
              "time: {design_stress: 50 kPa}\n"
              "stages: [{name: one, duration: 10 ms}]\n";

/** All grains of a cubic lattice turning alike, the first mode to go here: 8 k_t a^2 by I = 0.4 m R^2 and the dash-pot
 *  gamma_t = 2 z sqrt(5/6) sqrt(m/2 k_t), k_t = 3/2 k1 sqrt(d). 50 kPa put 1.8 N on a contact. */
static double lattice(double deep)
{
    const double overlap = deep * pow(1.8 / K1, 2.0 / 3.0);
    const double slip = 1.5 * K1 * sqrt(overlap);
    const double arm = 1.0 - 0.5 * overlap / RADIUS;
    const double l = log(0.3), z = -l / sqrt(l * l + M_PI * M_PI);
    const double dash_pot = 2.0 * z * sqrt(5.0 / 6.0) * sqrt(0.5 * MASS * slip);
    const double omega = sqrt(20.0 * slip / MASS) * arm;
    const double zeta = 20.0 * dash_pot / MASS * arm * arm / (2.0 * omega);
    return 2.0 / omega * (sqrt(1.0 + zeta * zeta) - zeta);
}

static void a_sheared_bed_by_hand(void **state)
{
    (void)state;
    static char text[CLOD_CHECK_TEXT];
    char line[128];
    preflight(RING, NULL);
    check_relative(report.stable, lattice(17.0), 1e-3);
    assert_int_equal(report.warning_count, 0);
    clod_check_report_text(&report, text);
    snprintf(line, sizeof line,
             "stable step        some %.3g s by an estimate for the bed when sheared",
             report.stable);
    assert_non_null(strstr(text, line));
    assert_true(clod_check_report_json(&report, text));
    assert_non_null(strstr(text, "\"stable_step_estimate_s\""));
}

static void a_bed_at_rest_by_hand(void **state)
{
    (void)state;
    static char text[CLOD_CHECK_TEXT];
    preflight(FREE, NULL);
    check_relative(report.stable, lattice(1.0), 1e-3);
    assert_int_equal(report.warning_count, 0);
    clod_check_report_text(&report, text);
    assert_non_null(strstr(text, "s by an estimate for the bed under its mean load;"));
}

/** A step of nine tenths of the estimate is taken, one a little larger is not, whether the case gives it or how it is
 *  chosen; what is advised is taken. */
static void a_step_beyond_it_is_warned_of(void **state)
{
    (void)state;
    static const char *const KEYS[] = {"time.safety", "time.step"};
    preflight(RING, NULL);
    const double bound = 0.9 * report.stable, critical = report.critical;
    for (int k = 0; k < 2; k++) {
        const double whole = k == 0 ? bound / critical : bound;
        const char *unit = k == 0 ? "" : " s";
        char change[64], words[64];
        snprintf(change, sizeof change, "%s=%.6g%s", KEYS[k], 0.999 * whole, unit);
        assert_false(preflight_warns(RING, change, "nine tenths"));
        snprintf(change, sizeof change, "%s=%.6g%s", KEYS[k], 1.001 * whole, unit);
        snprintf(words, sizeof words, "nothing stops the run. Lower %s to ", KEYS[k]);
        assert_true(preflight_warns(RING, change, words));
        const double advised = strtod(strstr(report.warning[0], words) + strlen(words), NULL);
        assert_true(advised > 0.98 * whole);
        snprintf(change, sizeof change, "%s=%.6g%s", KEYS[k], advised, unit);
        assert_false(preflight_warns(RING, change, "nine tenths"));
    }
    assert_true(preflight_warns(RING, "time.safety=0.2", "for the bed when sheared: beyond"));
    assert_true(preflight_warns(RING, "time.step=2e-6 s", " s, or write auto"));
    assert_true(preflight_warns(FREE, "time.safety=0.3", "for the bed: beyond it"));
}

/** At the critical step a swing has pi steps: collisions that begin between two of them gain energy. Without a dash-pot 16
 *  steps return up to 1.001 of the speed, by the order of the scheme, which is no fault. */
static void a_collision_that_gains_energy_is_warned_of(void **state)
{
    (void)state;
    assert_true(preflight_warns(RING, "time.safety=1", "a collision may return 1."));
    assert_false(preflight_warns(RING, "time.safety=0.5", "a collision may return"));
    assert_false(
        preflight_warns(RING, "contacts.default.restitution=1", "a collision may return"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_sheared_bed_by_hand),
        cmocka_unit_test(a_bed_at_rest_by_hand),
        cmocka_unit_test(a_step_beyond_it_is_warned_of),
        cmocka_unit_test(a_collision_that_gains_energy_is_warned_of),
    };
    return cmocka_run_group_tests(tests, NULL, preflight_end);
}
