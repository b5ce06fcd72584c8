/**
 * @file test_plan_conflicts.c
 * Targets that cannot be true together are refused, and those that errors allow are not: by hand.
 */

#include "plan_lab.h"

// 90/18 is 5. sqrt((0.2 18)^2 + (5.6 0.9)^2 + 3^2) = 6.88 kPa, and 5.6 18 - 90 = 10.8 kPa is 1.57 of them.
static void ffc_beside_its_stresses(void **state)
{
#define FFC(number)                                                                            \
    "number: sigma_1, value: 90 kPa, error: 3 kPa}, "                                          \
    "{test: lab, number: sigma_c, value: 18 kPa, error: 0.9 kPa}, "                            \
    "{test: lab, number: ffc, value: " number ", error: 0.2"
    clod_plan plan;
    lab_load_good(state, RING, FFC("5.6"), &plan);
    clod_plan_fini(&plan);
    lab_load_good(state, RING, FFC("4.4"), &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, RING, FFC("6.2"),
        "test lab: ffc 6.2 in targets.2 is not sigma_1/sigma_c = 90 kPa/18 kPa, of sigma_1 in targets.0 and "
        "sigma_c in targets.1, by 3.0 standard errors: they contradict each other");
    lab_refuse(state, RING, FFC("3.8"), "by 3.7 standard errors");
}

// 54.8 kPa, known to 2 %, over 11 kPa is 4.98. 11 (6.5 - 4.98) = 16.7 kPa is 3.5 of
// sqrt((0.3 11)^2 + (6.5 0.5)^2 + 1.096^2) = 4.76 kPa. That of 20 kPa is another consolidation.
static void ffc_beside_the_strength_of_its_consolidation(void **state)
{
#define OF(ffc, stress)                                                                        \
    "number: sigma_c, value: 11 kPa, error: 0.5 kPa, normal_stress: 54.8 kPa}, "               \
    "{test: lab, number: ffc, value: " ffc ", error: 0.3, normal_stress: " stress
    clod_plan plan;
    lab_load_good(state, UNIAXIAL, OF("5.2", "54.8 kPa"), &plan);
    clod_plan_fini(&plan);
    lab_load_good(state, UNIAXIAL, OF("6.5", "20 kPa"), &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, UNIAXIAL, OF("6.5", "54.8 kPa"),
        "test lab: ffc 6.5 in targets.1 is not sigma_1/sigma_c = 54.8 kPa/11 kPa, of the consolidation stress "
        "and sigma_c in targets.0, by 3.5 standard errors");
}

#define TWO(one, other) "number: " one "}, {test: lab, number: " other

static void load_both(void **state, const char *one, const char *other)
{
    clod_plan plan;
    char text[512];
    snprintf(text, sizeof text, TWO("%s", "%s"), one, other);
    lab_load_good(state, RING, text, &plan);
    clod_plan_fini(&plan);
}

// Apart by 2 sqrt(3^2 + 4^2) = 10 deg at most.
static void angles_that_follow_one_another(void **state)
{
    load_both(state, "phi_sf, value: 39.5 deg, error: 3 deg",
              "phi_e, value: 30 deg, error: 4 deg");
    lab_refuse(
        state, RING,
        TWO("phi_sf, value: 40.5 deg, error: 3 deg", "phi_e, value: 30 deg, error: 4 deg"),
        "test lab: phi_e 30.0 deg in targets.1 is below phi_sf 40.5 deg in targets.0, which is the "
        "steepest line through the origin that meets the circle of steady flow");
    load_both(state, "phi_e, value: 30 deg, error: 3 deg",
              "phi_lin, value: 39.5 deg, error: 4 deg");
    lab_refuse(
        state, RING,
        TWO("phi_e, value: 30 deg, error: 3 deg", "phi_lin, value: 40.5 deg, error: 4 deg"),
        "test lab: phi_e 30.0 deg in targets.0 is below phi_lin 40.5 deg in targets.1, which no yield "
        "locus with a cohesion of 0 or more can have");
}

// 2 (5 +- 1) kPa is above sigma_c by 2 sqrt((2 1)^2 + 1.5^2) = 5 kPa at most.
static void strength_of_a_cohesion(void **state)
{
    load_both(state, "c, value: 5 kPa, error: 1 kPa",
              "sigma_c, value: 5.1 kPa, error: 1.5 kPa");
    lab_refuse(
        state, RING,
        TWO("c, value: 5 kPa, error: 1 kPa", "sigma_c, value: 4.9 kPa, error: 1.5 kPa"),
        "test lab: sigma_c 4.90 kPa in targets.1 is below twice the c 5.00 kPa in targets.0");
}

static void principal_stresses_in_order(void **state)
{
    load_both(state, "sigma_1, value: 60 kPa, error: 1 kPa",
              "sigma_2, value: 20 kPa, error: 1 kPa");
    lab_refuse(
        state, RING,
        TWO("sigma_1, value: 60 kPa, error: 1 kPa", "sigma_2, value: 63 kPa, error: 1 kPa"),
        "test lab: sigma_1 60.00 kPa in targets.0 is below sigma_2 63.00 kPa in targets.1");
}

// The case preshears at 54.8 kPa, and atan(37.4/54.8) is 34.31 deg; 3 kPa of tau_p are 54.8/(54.8^2 + 37.4^2)
// of a radian each, 2.14 deg in all: 4.40 deg are allowed.
static void results_beside_the_stress_of_preshear(void **state)
{
    clod_plan plan;
    lab_load_good(state, RING, "number: sigma_1, value: 53 kPa, error: 1 kPa", &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, RING, "number: sigma_1, value: 52 kPa, error: 1 kPa",
        "test lab: sigma_1 52 kPa in targets.0 is below the preshear stress of the case, 54.8 kPa");
    lab_load_good(state, RING, "number: sigma_2, value: 56.7 kPa, error: 1 kPa", &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, RING, "number: sigma_2, value: 56.9 kPa, error: 1 kPa",
        "test lab: sigma_2 56.9 kPa in targets.0 is above the preshear stress of the case, 54.8 kPa");
    load_both(state, "tau_p, value: 37.4 kPa, error: 3 kPa",
              "phi_sf, value: 30 deg, error: 0.5 deg");
    lab_refuse(
        state, RING,
        TWO("tau_p, value: 37.4 kPa, error: 3 kPa", "phi_sf, value: 29.8 deg, error: 0.5 deg"),
        "test lab: phi_sf 29.8 deg in targets.1 is not that of tau_p 37.4 kPa in targets.0 at the "
        "preshear stress of the case, 54.8 kPa: 34.3 deg");
    load_both(state, "tau_p, value: 37.4 kPa, error: 3 kPa",
              "phi_sf, value: 38.6 deg, error: 0.5 deg");
    lab_refuse(
        state, RING,
        TWO("tau_p, value: 37.4 kPa, error: 3 kPa", "phi_sf, value: 38.8 deg, error: 0.5 deg"),
        "phi_sf 38.8 deg");
}

// atan(310/54.8) is 79.97 deg and atan(330/54.8) 80.57; atan(0.97/54.8) is 1.01 deg and atan(0.9/54.8) 0.94.
static void a_tau_p_has_the_limits_of_its_angle(void **state)
{
    clod_plan plan;
    lab_load_good(state, RING, "number: tau_p, value: 310 kPa, error: 3 kPa", &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, RING, "number: tau_p, value: 330 kPa, error: 3 kPa",
        "test lab: tau_p 330 kPa in targets.0 is a phi_sf of 80.6 deg at the preshear stress of the case, "
        "54.8 kPa; it must be 1 to 80 deg");
    lab_load_good(state, RING, "number: tau_p, value: 0.97 kPa, error: 0.01 kPa", &plan);
    clod_plan_fini(&plan);
    lab_refuse(state, RING, "number: tau_p, value: 0.9 kPa, error: 0.01 kPa",
               "tau_p 0.9 kPa in targets.0 is a phi_sf of 0.9 deg");
}

// 37.4 +- 3 kPa is 34.31 +- 2.14 deg, above phi_e by 2 sqrt(2.14^2 + 3^2) = 7.37 deg at most: from 26.94 deg on.
static void a_tau_p_beside_phi_e(void **state)
{
    load_both(state, "tau_p, value: 37.4 kPa, error: 3 kPa",
              "phi_e, value: 27 deg, error: 3 deg");
    lab_refuse(
        state, RING,
        TWO("tau_p, value: 37.4 kPa, error: 3 kPa", "phi_e, value: 26.8 deg, error: 3 deg"),
        "test lab: phi_e 26.8 deg in targets.1 is below phi_sf 34.3 deg, which tau_p 37.4 kPa in targets.0 is at the "
        "preshear stress of the case, 54.8 kPa");
}

// The circle from the origin through (54.8, 37.4) kPa has the radius (54.8^2 + 37.4^2)/(2 54.8) = 40.16 kPa, which
// changes by 37.4/54.8 3 = 2.05 kPa with tau_p: c is at most 40.16 + 2 sqrt(1^2 + 2.05^2) = 44.72 kPa. The same with phi_sf
// 34.31 +- 2.14 deg.
static void a_cohesion_beside_steady_flow(void **state)
{
    load_both(state, "c, value: 44.6 kPa, error: 1 kPa",
              "tau_p, value: 37.4 kPa, error: 3 kPa");
    lab_refuse(
        state, RING,
        TWO("c, value: 44.8 kPa, error: 1 kPa", "tau_p, value: 37.4 kPa, error: 3 kPa"),
        "test lab: c 44.8 kPa in targets.0 is too large for tau_p 37.4 kPa in targets.1: with the preshear stress of "
        "the case, 54.8 kPa, steady flow that does not reach into tension has a c of at most 40.16 kPa");
    load_both(state, "c, value: 44.6 kPa, error: 1 kPa",
              "phi_sf, value: 34.31 deg, error: 2.14 deg");
    lab_refuse(
        state, RING,
        TWO("c, value: 44.8 kPa, error: 1 kPa", "phi_sf, value: 34.31 deg, error: 2.14 deg"),
        "is too large for phi_sf 34.31 deg in targets.1");
}

// 2 (c +- 1) kPa is above sigma_1 by 2 sqrt((2 1)^2 + 1.5^2) = 5 kPa at most.
static void a_cohesion_beside_the_major_stress(void **state)
{
    load_both(state, "c, value: 32.4 kPa, error: 1 kPa",
              "sigma_1, value: 60 kPa, error: 1.5 kPa");
    lab_refuse(
        state, RING,
        TWO("c, value: 32.6 kPa, error: 1 kPa", "sigma_1, value: 60 kPa, error: 1.5 kPa"),
        "test lab: sigma_1 60.00 kPa in targets.1 is below twice the c 32.60 kPa in targets.0");
}

// 2 sqrt(1^2 + 1.5^2) = 3.606 kPa. A strength of a table is one of its own sigma_1.
static void a_strength_above_the_major_stress(void **state)
{
    clod_plan plan;
    load_both(state, "sigma_c, value: 63.5 kPa, error: 1 kPa",
              "sigma_1, value: 60 kPa, error: 1.5 kPa");
    lab_refuse(
        state, RING,
        TWO("sigma_c, value: 63.7 kPa, error: 1 kPa", "sigma_1, value: 60 kPa, error: 1.5 kPa"),
        "test lab: sigma_1 60.00 kPa in targets.1 is below sigma_c 63.70 kPa in targets.0, and a straight yield "
        "locus has a sigma_c of at most sigma_1 - sigma_2");
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],f_c [kPa],f_c_error [kPa]\n110,70,1\n");
    lab_load_good(state, RING,
                  "locus: lab.csv}, {test: lab, number: sigma_1, value: 60 kPa, error: 1.5 kPa",
                  &plan);
    assert_int_equal(plan.target_count, 2);
    clod_plan_fini(&plan);
}

#define THREE(one, two, three) TWO(one, two) "}, {test: lab, number: " three

static void load_three(void **state, const char *one, const char *two, const char *three)
{
    clod_plan plan;
    char text[512];
    snprintf(text, sizeof text, THREE("%s", "%s", "%s"), one, two, three);
    lab_load_good(state, RING, text, &plan);
    clod_plan_fini(&plan);
}

// 90 - 40 = 50 kPa, and two of sqrt(2^2 + 2^2 + 1^2) = 3 kPa.
static void strength_above_the_difference_of_principal_stresses(void **state)
{
#define MAJOR "sigma_1, value: 90 kPa, error: 2 kPa"
#define MINOR "sigma_2, value: 40 kPa, error: 2 kPa"
    load_three(state, MAJOR, MINOR, "sigma_c, value: 55.9 kPa, error: 1 kPa");
    lab_refuse(
        state, RING, THREE(MAJOR, MINOR, "sigma_c, value: 56.1 kPa, error: 1 kPa"),
        "test lab: sigma_c 56.1 kPa in targets.2 is above sigma_1 - sigma_2 = 50 kPa, of targets.0 and "
        "targets.1, and no straight yield locus has more");
}

// sin 30 is 1/2, and 2 (1/2)/(3/2) of 90 kPa is 60 kPa. 3 deg of 90 2 cos 30/(3/2)^2 = 69.28 kPa/rad are 3.628 kPa;
// two of sqrt(2^2 + (3 2/3)^2 + 3.628^2) = 4.600 kPa are 9.20 kPa.
static void strength_above_that_of_an_effective_angle(void **state)
{
#define ANGLE "phi_e, value: 30 deg, error: 3 deg"
#define STRESS "sigma_1, value: 90 kPa, error: 3 kPa"
    load_three(state, ANGLE, STRESS, "sigma_c, value: 69.1 kPa, error: 2 kPa");
    lab_refuse(
        state, RING, THREE(ANGLE, STRESS, "sigma_c, value: 69.3 kPa, error: 2 kPa"),
        "test lab: sigma_c 69.3 kPa in targets.2 is above sigma_1 2 sin(phi_e)/(1 + sin(phi_e)) = 60 kPa, of "
        "sigma_1 90 kPa in targets.1 and phi_e 30.0 deg in targets.0, and no straight yield locus has more");
}

// sin 40 is 0.64279: 1.64279/1.28558 = 1.2779. 3 deg of cos 40/(2 sin^2 40) = 0.92702 are 0.04854; two of
// sqrt(0.1^2 + 0.04854^2) = 0.11116 are 0.2223: 1.0555.
static void ffc_below_that_of_an_effective_angle(void **state)
{
    load_both(state, "phi_e, value: 40 deg, error: 3 deg", "ffc, value: 1.06, error: 0.1");
    lab_refuse(
        state, RING, TWO("phi_e, value: 40 deg, error: 3 deg", "ffc, value: 1.05, error: 0.1"),
        "test lab: ffc 1.05 in targets.1 is below (1 + sin(phi_e))/(2 sin(phi_e)) = 1.278, of phi_e 40.0 deg in "
        "targets.0, and no straight yield locus has less");
}

// 1 less two of 0.1 is 0.8.
static void ffc_below_one(void **state)
{
    clod_plan plan;
    lab_load_good(state, RING, "number: ffc, value: 0.81, error: 0.1", &plan);
    clod_plan_fini(&plan);
    lab_refuse(state, RING, "number: ffc, value: 0.79, error: 0.1",
               "test lab: ffc 0.79 in targets.0 is below 1: sigma_c would be above sigma_1");
    lab_refuse(state, RING,
               TWO("phi_e, value: 40 deg, error: 3 deg", "ffc, value: 0.2, error: 0.01"),
               "test lab: ffc 0.2 in targets.1 is below 1");
}

// 2 tan 85 = 22.860 without phi_lin: two of sqrt(1.5^2 + (0.1 22.860)^2) = 2.734 kPa above it are 28.33 kPa.
static void cohesion_too_small_for_a_strength(void **state)
{
#define COHESION "c, value: 1 kPa, error: 0.1 kPa"
    load_both(state, COHESION, "sigma_c, value: 28.2 kPa, error: 1.5 kPa");
    lab_refuse(
        state, RING, TWO(COHESION, "sigma_c, value: 28.5 kPa, error: 1.5 kPa"),
        "test lab: sigma_c 28.5 kPa in targets.1 is too large for c 1 kPa in targets.0: sigma_c = 2 c "
        "cos(phi_lin)/(1 - sin(phi_lin)) is 22.86 kPa with phi_lin 80 deg, the largest that clod locus takes");
}

// Of 27.4 and 40 kPa of normal stress: two of sqrt(1 + 1) kPa are 2.83 kPa.
static void shear_stresses_that_fall_with_the_normal_stress(void **state)
{
#define POINT(stress, value)                                                                   \
    "tau, normal_stress: " stress ", value: " value " kPa, error: 1 kPa"
    load_both(state, POINT("27.4 kPa", "20"), POINT("40 kPa", "17.2"));
    load_both(state, POINT("40 kPa", "17.2"), POINT("27.4 kPa", "20"));
    load_both(state, POINT("27.4 kPa", "20"), POINT("40 kPa", "40"));
    lab_refuse(
        state, RING, TWO(POINT("27.4 kPa", "20"), POINT("40 kPa", "17.1")),
        "test lab: tau falls from 20 kPa at 27.4 kPa in targets.0 to 17.1 kPa at 40 kPa in targets.1, and a "
        "yield locus rises with the normal stress");
    lab_refuse(
        state, RING, TWO(POINT("40 kPa", "17.1"), POINT("27.4 kPa", "20")),
        "test lab: tau falls from 20 kPa at 27.4 kPa in targets.1 to 17.1 kPa at 40 kPa in targets.0");
}

#define LINE_LAB                                                                               \
    "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa],rho_b [kg/m3]\n"                \
    "54.8,37,10.96,15.48,1500\n54.8,37,27.4,23.7,1510\n54.8,37,43.84,31.92,1505\n"
#define AGAIN "}, {test: lab, "

// Its densities are another measurement than its shear stresses.
static void shear_points_of_one_table_twice(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", LINE_LAB);
    lab_write_file(state, "other.csv", LINE_LAB);
    lab_load_good(state, RING,
                  "locus: lab.csv, error: 0.5 kPa" AGAIN
                  "locus: lab.csv, number: rho_b, error: 15 kg/m3",
                  &plan);
    clod_plan_fini(&plan);
    lab_load_good(state, RING,
                  "locus: lab.csv, error: 0.5 kPa" AGAIN "locus: other.csv, error: 0.5 kPa",
                  &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, RING, "locus: lab.csv, error: 0.5 kPa" AGAIN "locus: lab.csv, error: 0.5 kPa",
        "targets.1.locus: is the table of targets.0, and lab: tau at 10.96 kPa is in both: one measurement "
        "would count as two");
    lab_refuse(
        state, RING,
        "locus: lab.csv, error: 0.5 kPa" AGAIN
        "locus: ./lab.csv, number: tau, error: 1 kPa, held_back: true",
        "targets.1.locus: is the table of targets.0, and lab: tau at 10.96 kPa is in both");
}

static void rows_of_one_table_twice(void **state)
{
#define ROW(stress) "locus: lab.csv, error: 15 kg/m3, normal_stress: " stress " kPa"
    clod_plan plan;
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n20,1500\n54.8,1600\n");
    lab_load_good(state, UNIAXIAL, ROW("20") AGAIN ROW("54.8"), &plan);
    clod_plan_fini(&plan);
    lab_refuse(
        state, UNIAXIAL, ROW("20") AGAIN ROW("20"),
        "targets.1.locus: is the table of targets.0, and lab: rho_b at 20 kPa is in both");
    lab_refuse(
        state, UNIAXIAL, ROW("54.8") AGAIN "locus: lab.csv, error: 15 kg/m3",
        "targets.1.locus: is the table of targets.0, and lab: rho_b at 54.8 kPa is in both");
}

// The ore of both cases has 2481.3 kg/m3.
static void bulk_density_above_that_of_the_grains(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    static const char *const DENSE = "number: rho_b, value: 2500 kg/m3, error: 15 kg/m3";
    static const char *const WORDS =
        "test lab: rho_b 2500 kg/m3 in targets.0 is above the density of its grains, 2481 kg/m3, which no "
        "packing of them reaches";
    lab_refuse(state, RING, DENSE, WORDS);
    lab_refuse(
        state, RING, "number: rho_inside, value: 2500 kg/m3, error: 15 kg/m3",
        "test lab: rho_inside 2500 kg/m3 in targets.0 is above the density of its grains");
    lab_load_good(state, RING, "number: rho_b, value: 2450 kg/m3, error: 15 kg/m3", &plan);
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv", "sigma_1 [kPa],rho_b [kg/m3]\n54.8,2500\n");
    lab_refuse(state, UNIAXIAL, "locus: lab.csv, error: 15 kg/m3", WORDS);

    // grains that may be as dense as 2600 kg/m3
    assert_true(lab_load_range(state, RING, "materials.ore.density", "2400 kg/m3", "2600 kg/m3",
                               DENSE, &plan, &status));
    clod_plan_fini(&plan);
    assert_false(lab_load_range(state, RING, "materials.ore.density", "2400 kg/m3",
                                "2490 kg/m3", DENSE, &plan, &status));
    assert_non_null(strstr(status.text, "above the density of its grains, 2490 kg/m3"));
    clod_plan_fini(&plan);
}

// A discrepancy of 4 deg beside an error of 3 is 5 deg: apart by 2 sqrt(5^2 + 12^2) = 26 deg. With ffc 5.9 it is 16.2 kPa, 2.29 of
// sqrt((0.2 18)^2 + (5.9 0.9)^2 + 3^2) = 7.08 kPa, and 1.93 with hypot(0.2, 0.25) in place of 0.2.
static void discrepancies_beside_errors(void **state)
{
    load_both(state, "phi_sf, value: 55.9 deg, error: 3 deg, discrepancy: 4 deg",
              "phi_e, value: 30 deg, error: 12 deg");
    lab_refuse(state, RING,
               TWO("phi_sf, value: 56.1 deg, error: 3 deg, discrepancy: 4 deg",
                   "phi_e, value: 30 deg, error: 12 deg"),
               "phi_e 30.0 deg in targets.1 is below phi_sf 56.1 deg");
    clod_plan plan;
    lab_load_good(state, RING, FFC("5.9") ", discrepancy: 0.25", &plan);
    clod_plan_fini(&plan);
    lab_refuse(state, RING, FFC("5.9"),
               "test lab: ffc 5.9 in targets.2 is not sigma_1/sigma_c");
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(ffc_beside_its_stresses),
        TEST(ffc_beside_the_strength_of_its_consolidation),
        TEST(angles_that_follow_one_another),
        TEST(strength_of_a_cohesion),
        TEST(principal_stresses_in_order),
        TEST(results_beside_the_stress_of_preshear),
        TEST(a_tau_p_has_the_limits_of_its_angle),
        TEST(a_tau_p_beside_phi_e),
        TEST(a_cohesion_beside_steady_flow),
        TEST(a_cohesion_beside_the_major_stress),
        TEST(a_strength_above_the_major_stress),
        TEST(strength_above_the_difference_of_principal_stresses),
        TEST(strength_above_that_of_an_effective_angle),
        TEST(ffc_below_one),
        TEST(ffc_below_that_of_an_effective_angle),
        TEST(cohesion_too_small_for_a_strength),
        TEST(shear_stresses_that_fall_with_the_normal_stress),
        TEST(shear_points_of_one_table_twice),
        TEST(rows_of_one_table_twice),
        TEST(bulk_density_above_that_of_the_grains),
        TEST(discrepancies_beside_errors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
