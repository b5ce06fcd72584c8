// Time step of the copper ore (docs/theory/time-step.md, copper-ore.md) and of simple pairs,
// worked out by hand.

#include "law/law_cycle.h"
#include "setup/timestep.h"
#include "support/check.h"

#include <stdio.h>
#include <string.h>

enum { ORE, STEEL, MATERIALS };

static clod_case_material materials[MATERIALS] = {
    {.name = "ore", .density = 2481.3, .youngs_modulus = 119e9, .poissons_ratio = 0.34},
    {.name = "steel", .density = 7800.0, .youngs_modulus = 200e9, .poissons_ratio = 0.3},
};

/** Table 1, 5 % moisture, for every pair. */
static clod_case copper_ore(clod_case_contact pairs[MATERIALS * MATERIALS])
{
    for (int p = 0; p < MATERIALS * MATERIALS; p++) {
        pairs[p] = (clod_case_contact){.law = CLOD_LAW_MEPA,
                                       .exponent = 1.5,
                                       .k1 = 4.75e8,
                                       .k2 = 2.37e9,
                                       .k_adh = 3.56e8,
                                       .restitution = 0.5,
                                       .friction = 0.35,
                                       .tangential = CLOD_TANGENTIAL_TANGENT,
                                       .tangential_ratio = 1.0,
                                       .rolling = CLOD_ROLLING_EPSD2,
                                       .rolling_friction = 0.3};
    }
    return (clod_case){.materials = materials,
                       .material_count = MATERIALS,
                       .pairs = pairs,
                       .time = {.safety = 0.1, .rayleigh_limit = 0.15}};
}

/** Many grains of ore and none of steel; 1024, so that the mean is kept to the bit. */
#define ORE_OF(least, mean)                                                                    \
    (const clod_timestep_sizes[MATERIALS])                                                     \
    {                                                                                          \
        [ORE] = { 1024.0, least, 1024.0 * (mean) }                                             \
    }
static const bool NONE[MATERIALS] = {false, false};
static const bool ONLY_STEEL[MATERIALS] = {false, true};

// docs/theory/time-step.md: 2.27e-6 s for R = 2.85 mm, so that 1e-7 s is 4.4 %.
static void rayleigh_time_of_the_ore(void **state)
{
    (void)state;
    const double rayleigh = clod_timestep_rayleigh(&materials[ORE], 2.85e-3);
    check_close(rayleigh, 2.27e-6, 0.005e-6);
    check_close(1e-7 / rayleigh, 0.044, 0.0005);
    const clod_case_material unknown = {.density = 1000.0};
    assert_true(clod_timestep_rayleigh(&unknown, 1.0) == 0.0);
}

// docs/theory/time-step.md: at 54.8 kPa the normal period of the mean grain is 3.3e-5 s, auto
// is near 1e-6 s.
static void automatic_step_of_the_ore(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(3.175e-3, 3.175e-3), .is_wall = NONE, .stress = 54.8e3};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    check_close(t.force, 54.8e3 * 6.35e-3 * 6.35e-3, 1e-9); // on the square of a diameter
    check_close(t.overlap, 2.787e-6, 0.002e-6);             // (2.2097/4.75e8)^(2/3)
    check_close(t.period, 3.3e-5, 0.05e-5);
    assert_int_equal(t.reason, CLOD_TIMESTEP_UNLOADING);
    check_relative(t.step, 0.1 * t.period / 3.14159265358979, 1e-12);
    check_close(t.step, 1e-6, 0.1e-6);
    check_close(t.rayleigh_fraction, t.step / 2.53e-6, 0.005); // 2.27e-6 times 3.175/2.85
}

// The step goes with the lightest grain: mass of (2.85/3.175)^3 gives a period of its root.
static void lightest_grain_sets_the_step(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    clod_timestep_grains grains = {
        .sizes = ORE_OF(3.175e-3, 3.175e-3), .is_wall = NONE, .stress = 54.8e3};
    const double mean = clod_timestep_choose(&from, &grains).step;
    grains.sizes = ORE_OF(2.85e-3, 3.175e-3);
    const double light = clod_timestep_choose(&from, &grains).step;
    check_relative(light / mean, pow(2.85 / 3.175, 1.5), 1e-12);
}

// By hand: T = 2 pi sqrt(2/7 m*/k_t) with k_t = 4.75e8 N/m and half the mass of an ore grain,
// 0.5 * 3.32659e-4 kg: 1.98739e-6 s; sliding and turning are stiffest.
static void literal_tangential_stiffness_sets_the_step(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    pairs[0].tangential = CLOD_TANGENTIAL_LITERAL;
    pairs[0].rolling = CLOD_ROLLING_NONE;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(3.175e-3, 3.175e-3), .is_wall = NONE, .stress = 54.8e3};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_int_equal(t.reason, CLOD_TIMESTEP_TANGENTIAL);
    check_relative(t.period, 1.98739e-6, 2e-6);
    assert_true(t.stiffness == 4.75e8);
}

// By hand: hooke, k = 1e5 N/m, zeta = 1. Normal: k/m*. Slip: 3.5 k/m*. Rolling at a wall
// (epsd2): k/(0.4 m) = 2.5 k/m; so slip between grains sets the step, and at a wall (m* = m) it
// is slower.
static void hooke_is_set_by_the_turning_of_grains(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    for (int p = 0; p < MATERIALS * MATERIALS; p++) {
        pairs[p].law = CLOD_LAW_HOOKE;
        pairs[p].exponent = 1.0;
        pairs[p].k1 = pairs[p].k2 = 1e5;
    }
    clod_timestep_grains grains = {
        .sizes = ORE_OF(1e-3, 1e-3), .is_wall = ONLY_STEEL, .stress = 1e3};
    const double mass = 2481.3 * 4.0 / 3.0 * M_PI * 1e-9;
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_int_equal(t.reason, CLOD_TIMESTEP_TANGENTIAL);
    assert_false(t.wall);
    check_relative(t.period, 2.0 * M_PI * sqrt(0.5 * mass / 3.5e5), 1e-12);
    for (int p = 0; p < MATERIALS * MATERIALS; p++) {
        pairs[p].friction = 0.0;
        pairs[p].rolling = CLOD_ROLLING_NONE;
    }
    pairs[0 * MATERIALS + STEEL].k1 = pairs[0 * MATERIALS + STEEL].k2 = 1e6;
    pairs[STEEL * MATERIALS].k1 = pairs[STEEL * MATERIALS].k2 = 1e6;
    const clod_timestep wall = clod_timestep_choose(&from, &grains);
    assert_int_equal(wall.reason, CLOD_TIMESTEP_UNLOADING);
    assert_true(wall.wall && wall.material_a == ORE && wall.material_b == STEEL);
    check_relative(wall.period, 2.0 * M_PI * sqrt(mass / 1e6), 1e-12);
}

static void hertz_takes_its_fraction_of_the_rayleigh_time(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    pairs[0].law = CLOD_LAW_HERTZ;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(2.85e-3, 3e-3), .is_wall = NONE, .stress = 1e3};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_int_equal(t.reason, CLOD_TIMESTEP_RAYLEIGH);
    check_relative(t.rayleigh_fraction, 0.15, 1e-12);
    check_close(t.step, 0.15 * 2.27e-6, 0.001e-6);
}

// By hand: 1/2 m* v^2 = k1 d^2.5/2.5 with m* = 2e-4 kg, v = 1 m/s, k1 = 4.75e8: d = 1.21847e-5
// m.
static void impact_overlap_takes_all_energy(void **state)
{
    (void)state;
    const clod_law law = {.kind = CLOD_LAW_MEPA, .exponent = 1.5, .k1 = 4.75e8, .k2 = 4.75e8};
    const double d = clod_timestep_impact(&law, 1.0, 2e-4, 1.0);
    check_relative(d, 1.22602e-5, 5e-6);
    check_relative(clod_law_cycle_overlap(&law, 1.0, 4.75e8 * pow(d, 1.5)), d, 1e-12);
    check_relative(clod_timestep_unloading(&law, 1.0, d), 1.5 * 4.75e8 * sqrt(d), 1e-12);
}

/**
 * By hand: luding swings on its largest k2; at 4 N, beyond k1 d*, d* = 4/3 5e-4 1 mm, the
 * overlap is d* + (F - k1 d*)/k2.
 */
static void luding_is_set_by_its_largest_k2(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    pairs[0].law = CLOD_LAW_LUDING;
    pairs[0].exponent = 1.0;
    pairs[0].k1 = 1e5;
    pairs[0].k2 = 4e5;
    pairs[0].plasticity_depth = 5e-4;
    pairs[0].friction = 0.0;
    pairs[0].rolling = CLOD_ROLLING_NONE;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(1e-3, 1e-3), .is_wall = NONE, .stress = 1e6};
    const double mass = 2481.3 * 4.0 / 3.0 * M_PI * 1e-9;
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_int_equal(t.reason, CLOD_TIMESTEP_UNLOADING);
    check_relative(t.stiffness, 4e5, 1e-12);
    check_relative(t.period, 2.0 * M_PI * sqrt(0.5 * mass / 4e5), 1e-12);
    const double flow = 4.0 / 3.0 * 5e-4 * 1e-3; // 2 R* = 1 mm
    check_relative(t.force, 4.0, 1e-12);         // 1e6 (2e-3)^2
    check_relative(t.overlap, flow + (4.0 - 1e5 * flow) / 4e5, 1e-12);
}

/** By hand: eepa is pressed by the load and by its own pull, k1 d^n = F + 2 N. */
static void eepa_is_pressed_by_its_pull_too(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    pairs[0].law = CLOD_LAW_EEPA;
    pairs[0].pull_off_force = 2.0;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(1e-3, 1e-3), .is_wall = NONE, .stress = 1e6};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    const double d = cbrt(pow(6.0 / 4.75e8, 2.0));
    check_relative(t.force, 4.0, 1e-12);
    check_relative(t.overlap, d, 1e-12);
    check_relative(t.unloading, 1.5 * 2.37e9 * sqrt(d), 1e-12);
}

static void given_step_is_kept_and_auto_is_still_told(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    clod_case from = copper_ore(pairs);
    from.time.step = 1e-7;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(2.85e-3, 3.175e-3), .is_wall = NONE, .stress = 54.8e3};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_true(t.given && t.step == 1e-7 && t.automatic > 5e-7);
    check_close(t.rayleigh_fraction, 0.044, 0.0005); // docs/theory/time-step.md
}

// Critical step of a pair by hand: 2 sqrt(m*/k), ore on ore with m/2 and the k2 tangent. Auto
// is set by the Rayleigh time of hertz, ore on smooth steel, whose spring has 1.3e-5 s: E* 88
// GPa, overlap 0.43 um, 6.3e6 N/m, the grain's whole mass.
static void given_step_beyond_the_critical_one_is_refused(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    clod_case from = copper_ore(pairs);
    clod_case_contact *const smooth = &pairs[ORE * MATERIALS + STEEL];
    smooth->law = CLOD_LAW_HERTZ;
    smooth->friction = 0.0;
    smooth->rolling = CLOD_ROLLING_NONE;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(3e-3, 3e-3), .is_wall = ONLY_STEEL, .stress = 50e3};
    const double mass = 4.0 / 3.0 * 3.14159265358979 * 27e-9 * 2481.3;
    const double stiffness = 1.5 * 2.37e9 * cbrt(50e3 * 36e-6 / 4.75e8);
    const double critical = 2.0 * sqrt(0.5 * mass / stiffness);
    clod_status status = {CLOD_OK, ""};
    clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_int_equal(t.reason, CLOD_TIMESTEP_RAYLEIGH);
    check_relative(t.limit, critical, 1e-9);
    assert_true(clod_timestep_accept(&t, &status));
    from.time.step = 0.999 * critical;
    t = clod_timestep_choose(&from, &grains);
    assert_true(clod_timestep_accept(&t, &status));
    from.time.step = 1.001 * critical;
    t = clod_timestep_choose(&from, &grains);
    assert_false(clod_timestep_accept(&t, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    char most[64];
    snprintf(most, sizeof most, "at most %.4g s", critical);
    assert_non_null(strstr(status.text, most));
    // not the pair of the Rayleigh time, ore on steel; 50 kPa on (6 mm)^2
    assert_true(t.wall && !t.limit_wall);
    assert_non_null(strstr(status.text, "under 1.8 N between ore (radius 3 mm) and ore (radius "
                                        "3 mm) (time.design_stress"));
}

// With a stiffer steel wall, 8 k2: its period is the shorter one though the whole grain swings.
static void wall_of_the_critical_step_is_named(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    clod_case from = copper_ore(pairs);
    pairs[ORE * MATERIALS + STEEL].k2 *= 8.0;
    from.time.step = 1.0;
    const clod_timestep_grains grains = {
        .sizes = ORE_OF(3e-3, 3e-3), .is_wall = ONLY_STEEL, .stress = 50e3};
    clod_status status = {CLOD_OK, ""};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_false(clod_timestep_accept(&t, &status));
    assert_non_null(strstr(status.text,
                           "N between ore (radius 3 mm) and steel (wall) (time.design_stress"));
}

/** Issue 17, 1.2: a 10 mm steel ball among 1 mm soft grains, hertz. */
static clod_case ball_among_soft(clod_case_contact pairs[MATERIALS * MATERIALS])
{
    clod_case from = copper_ore(pairs);
    for (int p = 0; p < MATERIALS * MATERIALS; p++) {
        pairs[p].law = CLOD_LAW_HERTZ;
        pairs[p].rolling = CLOD_ROLLING_NONE;
    }
    return from;
}

static clod_case_material soft_and_steel[MATERIALS] = {
    {.name = "soft", .density = 2500.0, .youngs_modulus = 1e9, .poissons_ratio = 0.3},
    {.name = "steel", .density = 7800.0, .youngs_modulus = 200e9, .poissons_ratio = 0.3},
};

// By hand, Rayleigh times pi R sqrt(rho/G)/0.92553, G = E/2.6: soft of 1 mm 8.65403e-6 s, steel
// of 10 mm 1.08088e-5 s, so the soft grains set 0.15 * 8.65403e-6 = 1.29810e-6 s. A steel grain
// of 1 mm, which there is not, would set 0.15 * 1.08088e-6 = 1.62e-7 s.
static void big_ball_does_not_count_as_a_small_one(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    clod_case from = ball_among_soft(pairs);
    from.materials = soft_and_steel;
    clod_timestep_sizes sizes[MATERIALS] = {{0}};
    clod_timestep_add(&sizes[ORE], 500.0, 1e-3);
    clod_timestep_add(&sizes[STEEL], 1.0, 10e-3);
    const clod_timestep_grains grains = {.sizes = sizes, .is_wall = ONLY_STEEL, .speed = 1.0};
    clod_timestep t = clod_timestep_choose(&from, &grains);
    check_relative(t.step, 1.29810e-6, 1e-5);
    assert_true(t.material_a == ORE && t.radius_a == 1e-3);
    clod_status status = {CLOD_OK, ""};
    from.time.step = 1.25e-6;
    t = clod_timestep_choose(&from, &grains);
    assert_true(clod_timestep_accept(&t, &status));
    clod_timestep_add(&sizes[STEEL], 1.0, 1e-3); // now there is such a grain, or can come
    from.time.step = 0.0;
    t = clod_timestep_choose(&from, &grains);
    check_relative(t.step, 0.15 * 1.08088e-6, 1e-5);
    assert_true(t.material_a == STEEL || t.material_b == STEEL);
}

// By hand: hooke, k = 1e5 N/m, no friction, 1 mm ore (m = 1.03937e-5 kg) and a lone 10 mm steel
// ball (M = 3.26726e-2 kg): m* of the two is m M/(m + M), of ore on ore m/2. With 1e6 N/m of
// ore on steel that pair has the shorter period; steel on steel (1e12 N/m) cannot be with one
// ball, and with two it can.
static void pair_has_the_grains_that_it_has(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    const clod_case from = copper_ore(pairs);
    for (int p = 0; p < MATERIALS * MATERIALS; p++) {
        pairs[p].law = CLOD_LAW_HOOKE;
        pairs[p].exponent = 1.0;
        pairs[p].k1 = pairs[p].k2 = p == 0 ? 1e5 : 1e6;
        pairs[p].friction = 0.0;
        pairs[p].rolling = CLOD_ROLLING_NONE;
    }
    pairs[STEEL * MATERIALS + STEEL].k1 = pairs[STEEL * MATERIALS + STEEL].k2 = 1e12;
    clod_timestep_sizes sizes[MATERIALS] = {{100.0, 1e-3, 0.1}, {1.0, 10e-3, 10e-3}};
    const clod_timestep_grains grains = {.sizes = sizes, .is_wall = NONE, .stress = 1e6};
    const double m = 1.0393645e-5;
    const double ball = 3.2672564e-2;
    clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_true(t.material_a == ORE && t.material_b == STEEL && !t.wall);
    assert_true(t.radius_a == 1e-3 && t.radius_b == 10e-3);
    check_relative(t.period, 2.0 * M_PI * sqrt(m * ball / (m + ball) / 1e6), 1e-6);
    check_relative(t.force, 1e6 * 4e-6, 1e-12); // what the smaller grain carries
    check_relative(t.overlap, 4.0 / 1e6, 1e-12);
    check_relative(t.overlap_ratio, 4.0 / 1e6 / 1e-3, 1e-12);
    sizes[STEEL] = (clod_timestep_sizes){2.0, 10e-3, 20e-3};
    t = clod_timestep_choose(&from, &grains);
    assert_true(t.material_a == STEEL && t.material_b == STEEL);
    check_relative(t.period, 2.0 * M_PI * sqrt(0.5 * ball / 1e12), 1e-6);
}

// By hand, unequal grains of one material, masses 1 and 8, radii 1 and 2: I_a I_b/(I_a + I_b) =
// 0.4 * 32/33 and R* = 2/3, so 0.4 * 32/33 * 9/4 = 0.872727 is on the rolling spring.
static void rolling_mass_of_unequal_grains(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    clod_case from = copper_ore(pairs);
    clod_case_material alike[MATERIALS] = {{.name = "small", .density = 1.0},
                                           {.name = "large", .density = 1.0}};
    from.materials = alike;
    for (int p = 0; p < MATERIALS * MATERIALS; p++) {
        pairs[p].law = CLOD_LAW_HOOKE;
        pairs[p].exponent = 1.0;
        pairs[p].k1 = pairs[p].k2 = 1.0;
        pairs[p].friction = 0.0; // the tangential spring would be stiffer
        pairs[p].tangential = CLOD_TANGENTIAL_LITERAL;
    }
    pairs[1].k1 = pairs[1].k2 = pairs[2].k1 = pairs[2].k2 = 100.0;
    pairs[1].tangential = pairs[2].tangential = CLOD_TANGENTIAL_LITERAL;
    const double one = cbrt(3.0 / (4.0 * M_PI)); // a mass of 1
    const clod_timestep_sizes sizes[MATERIALS] = {{1.0, one, one}, {1.0, 2.0 * one, 2.0 * one}};
    const clod_timestep_grains grains = {.sizes = sizes, .is_wall = NONE, .stress = 1.0};
    const clod_timestep t = clod_timestep_choose(&from, &grains);
    assert_int_equal(t.reason, CLOD_TIMESTEP_ROLLING);
    check_relative(t.mass, 0.4 * 32.0 / 33.0 * 9.0 / 4.0, 1e-12);
}

// docs/theory/softening.md: under a stress the step of n = 3/2 goes with soften^(1/3), that of an
// impact with soften^(2/5), and hertz' Rayleigh time with soften^(1/2).
static void softening_makes_the_step_longer(void **state)
{
    (void)state;
    clod_case_contact pairs[MATERIALS * MATERIALS];
    clod_case from = copper_ore(pairs);
    clod_timestep_grains grains = {.sizes = ORE_OF(2.85e-3, 3.175e-3), .is_wall = NONE};
    for (int k = 0; k < 3; k++) {
        static const double POWER[] = {1.0 / 3.0, 2.0 / 5.0, 1.0 / 2.0};
        grains.stress = k == 1 ? 0.0 : 54.8e3;
        grains.speed = k == 1 ? 3.0 : 0.0;
        double step[2];
        for (int s = 0; s < 2; s++) {
            from.soften = s == 0 ? 1.0 : 100.0;
            for (int p = 0; p < MATERIALS * MATERIALS; p++) {
                pairs[p].soften = from.soften;
                pairs[p].law = k == 2 ? CLOD_LAW_HERTZ : CLOD_LAW_MEPA;
            }
            step[s] = clod_timestep_choose(&from, &grains).automatic;
        }
        check_relative(step[1] / step[0], pow(100.0, POWER[k]), 1e-12);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rayleigh_time_of_the_ore),
        cmocka_unit_test(automatic_step_of_the_ore),
        cmocka_unit_test(lightest_grain_sets_the_step),
        cmocka_unit_test(literal_tangential_stiffness_sets_the_step),
        cmocka_unit_test(hooke_is_set_by_the_turning_of_grains),
        cmocka_unit_test(hertz_takes_its_fraction_of_the_rayleigh_time),
        cmocka_unit_test(impact_overlap_takes_all_energy),
        cmocka_unit_test(luding_is_set_by_its_largest_k2),
        cmocka_unit_test(eepa_is_pressed_by_its_pull_too),
        cmocka_unit_test(given_step_is_kept_and_auto_is_still_told),
        cmocka_unit_test(given_step_beyond_the_critical_one_is_refused),
        cmocka_unit_test(wall_of_the_critical_step_is_named),
        cmocka_unit_test(big_ball_does_not_count_as_a_small_one),
        cmocka_unit_test(pair_has_the_grains_that_it_has),
        cmocka_unit_test(rolling_mass_of_unequal_grains),
        cmocka_unit_test(softening_makes_the_step_longer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
