/**
 * @file test_plan_shear.c
 * Shear points with a preshear each: prorating removes how specimens differ, and puts the error of the mean preshear into
 * all points alike. By hand, and by tables that are drawn: intervals of what all stresses are larger by.
 *
 * Points by hand: preshears of 39, 40, 41 and 40 kPa differ by s = sqrt(2/3) kPa, so their mean, 40 kPa, is known to
 * s/2 = 0.408 kPa, 1.02 %.
 */

#include "base/random.h"
#include "calibrate/misfit.h"
#include "plan_lab.h"
#include "support/check.h"
#include "support/sanitized.h"

#define HEAD "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]"
#define POINTS 4
#define MOST 12 ///< rows, targets

static const double SIGMA[POINTS] = {10.96, 21.92, 32.88, 43.84};
static const double TAU_PRE[POINTS] = {39.0, 40.0, 41.0, 40.0};

/** The line 5 kPa + 0.7 sigma, as far above it as the specimens are. */
static double raw(size_t k)
{
    return (5.0 + 0.7 * SIGMA[k]) * TAU_PRE[k] / 40.0;
}

/** The points with an error of 0.3 kPa, behind each a text; of the seeds from 1 to `seeds`, tau_sh so many times as
 *  large in the later ones. 0: no column seed. */
static void write_points(void **state, size_t seeds, double larger, const char *more_head,
                         const char *more)
{
    char text[2000];
    size_t used = (size_t)snprintf(text, sizeof text, "%s" HEAD ",tau_sh_error [kPa]%s\n",
                                   seeds > 0 ? "seed," : "", more_head);
    for (size_t k = 0; k < POINTS * (seeds > 0 ? seeds : 1); k++) {
        const size_t seed = k / POINTS, at = k % POINTS;
        if (seeds > 0) {
            used += (size_t)snprintf(text + used, sizeof text - used, "%zu,", seed + 1);
        }
        used +=
            (size_t)snprintf(text + used, sizeof text - used, "54.8,%.12g,%.12g,%.12g,0.3%s\n",
                             TAU_PRE[at], SIGMA[at], raw(at) * (seed > 0 ? larger : 1.0), more);
    }
    lab_write_file(state, "lab.csv", text);
}

/** What is to be calibrated, without runs: functions that are known. */
static clod_misfit *misfit_of(const clod_plan *plan)
{
    static const clod_surrogate *const NONE[MOST];
    double results[MOST];
    for (size_t t = 0; t < MOST; t++) {
        results[t] = (double)NAN;
    }
    const clod_misfit_runs runs = {plan, 1, results, NONE};
    clod_misfit *made = clod_misfit_create(&runs);
    assert_non_null(made);
    return made;
}

static void points_share_the_error_of_their_mean_preshear(void **state)
{
    clod_plan plan;
    write_points(state, 0, 1.0, "", "");
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    assert_int_equal(plan.target_count, POINTS);
    double share[POINTS];
    for (size_t k = 0; k < POINTS; k++) {
        const double value = 1e3 * (5.0 + 0.7 * SIGMA[k]);
        const double common = value * sqrt(2.0 / 3.0) / 2.0 / 40.0;
        const double own = 300.0 * 40.0 / TAU_PRE[k];
        check_relative(plan.targets[k].value, value, 1e-9);
        check_relative(plan.targets[k].common.error, common, 1e-9);
        check_relative(plan.targets[k].error, hypot(own, common), 1e-9);
        share[k] = common / hypot(own, common);
    }
    clod_misfit *misfit = misfit_of(&plan);
    double runs, laboratory;
    clod_misfit_correlation(misfit, 0, 3, &runs, &laboratory);
    check_relative(laboratory, share[0] * share[3], 1e-9);
    check_close(clod_misfit_degrees(misfit, 0), 3.0, 0.0); // four preshears
    clod_misfit_destroy(&misfit);
    clod_plan_fini(&plan);
}

/** Stated errors of 0.4 kPa leave sqrt(2/3 - 0.4^2) kPa to the specimens; each point has its own of them. */
static void stated_errors_of_preshears_are_of_their_points(void **state)
{
    clod_plan plan;
    write_points(state, 0, 1.0, ",tau_pre_error [kPa]", ",0.4");
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    for (size_t k = 0; k < POINTS; k++) {
        const double value = 1e3 * (5.0 + 0.7 * SIGMA[k]);
        const double common = value * sqrt(2.0 / 3.0 - 0.16) / 2.0 / 40.0;
        const double own = hypot(300.0 * 40.0, value * 0.4) / TAU_PRE[k];
        check_relative(plan.targets[k].common.error, common, 1e-9);
        check_relative(plan.targets[k].error, hypot(own, common), 1e-9);
    }
    clod_plan_fini(&plan);
}

/** With errors of 1 kPa, more than preshears differ by, specimens are held to be alike. */
static void preshears_that_differ_by_their_errors_share_none(void **state)
{
    clod_plan plan;
    write_points(state, 0, 1.0, ",tau_pre_error [kPa]", ",1");
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    check_close(plan.targets[0].common.error, 0.0, 0.0);
    clod_plan_fini(&plan);
}

/** Points without an error are asked for it, whatever their preshears tell. */
static void error_of_points_is_needed(void **state)
{
    lab_write_file(state, "lab.csv",
                   HEAD "\n54.8,39,10.96,12\n54.8,41,27.4,24\n54.8,40,43.84,36\n");
    lab_refuse(state, RING, "locus: lab.csv",
               "needs the key error: the table has no tau_sh_error");
}

/** One preshear for all points of a specimen: the table's tau_sh are not changed by it, whatever its error is. */
static void points_of_one_preshear_share_none_of_its_error(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv",
                   HEAD ",tau_pre_error [kPa],tau_sh_error [kPa]\n54.8,40,10.96,12.7,0.8,0.3\n"
                        "54.8,40,27.4,24.2,0.8,0.3\n54.8,40,43.84,35.7,0.8,0.3\n");
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    for (size_t k = 0; k < 3; k++) {
        check_close(plan.targets[k].common.error, 0.0, 0.0);
        check_relative(plan.targets[k].error, 300.0, 1e-12);
    }
    clod_plan_fini(&plan);
}

/** Prorated values of one seed that are 5 % above and below (5 + 0.7 sigma) at each stress: a mean of two is known to 5 %, and
 *  what six preshears share, sqrt(4/5/6) of 40 kPa, comes to it. */
static void rows_of_one_stress_have_it_beside_their_scatter(void **state)
{
    static const double PRE[] = {39.0, 40.0, 41.0, 40.0, 39.0, 41.0};
    char text[600];
    size_t used = (size_t)snprintf(text, sizeof text, HEAD ",tau_sh_error [kPa]\n");
    for (size_t k = 0; k < 6; k++) {
        const double factor = (k % 2 == 0 ? 1.05 : 0.95) * PRE[k] / 40.0;
        used +=
            (size_t)snprintf(text + used, sizeof text - used, "54.8,%.12g,%.12g,%.12g,0.3\n",
                             PRE[k], SIGMA[k / 2], factor * (5.0 + 0.7 * SIGMA[k / 2]));
    }
    clod_plan plan;
    lab_write_file(state, "lab.csv", text);
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    assert_int_equal(plan.target_count, 3);
    for (size_t k = 0; k < 3; k++) {
        const double value = 1e3 * (5.0 + 0.7 * SIGMA[k]);
        const double share = sqrt(0.8 / 6.0) / 40.0;
        check_relative(plan.targets[k].common.error, share * value, 1e-9);
        check_relative(plan.targets[k].error, hypot(0.05, share) * value, 1e-9);
    }
    clod_plan_fini(&plan);
}

/** Two seeds, each with four preshears, 1.02 % in common: of the mean of both 1/sqrt(2) of it. The scatter between the two
 *  has it already: prorated values of both are 5 + 0.7 sigma and 1.1 times it, so their mean 1.05 is known to 0.05. */
static void scatter_between_seeds_has_it_already(void **state)
{
    clod_plan plan;
    write_points(state, 2, 1.1, "", "");
    lab_load_good(state, RING, "locus: lab.csv", &plan);
    for (size_t k = 0; k < POINTS; k++) {
        const clod_plan_target *of = &plan.targets[k];
        const double value = 1e3 * (5.0 + 0.7 * SIGMA[k]);
        const double part = value * sqrt(2.0 / 3.0) / 2.0 / 40.0 / 2.0;
        check_relative(of->value, 1.05 * value, 1e-9);
        check_relative(of->common.error, hypot(part, 1.1 * part), 1e-9);
        check_relative(of->error, 0.05 * value, 1e-9);
        check_close(of->common.degrees, 6.0, 0.0);
    }
    clod_plan_fini(&plan);
}

/** tau_p is the mean preshear, so its error is what the points share: the correlation is what they have of it. */
static void preshear_is_a_target_beside_its_points(void **state)
{
    clod_plan plan;
    write_points(state, 0, 1.0, "", "");
    lab_load_good(state, RING, "locus: lab.csv}, {test: lab, locus: lab.csv, number: tau_p",
                  &plan);
    assert_int_equal(plan.target_count, POINTS + 1);
    const clod_plan_target *tau_p = &plan.targets[POINTS];
    assert_string_equal(tau_p->name, "lab: tau_p");
    check_relative(tau_p->value, 40e3, 1e-12);
    check_relative(tau_p->error, 1e3 * sqrt(2.0 / 3.0) / 2.0, 1e-6);
    clod_misfit *misfit = misfit_of(&plan);
    double runs, laboratory;
    clod_misfit_correlation(misfit, 0, POINTS, &runs, &laboratory);
    check_relative(laboratory, plan.targets[0].common.error / plan.targets[0].error, 1e-6);
    clod_misfit_destroy(&misfit);
    clod_plan_fini(&plan);
}

/** Of one preshear its error is what the table states, or the plan; of three seeds their scatter, 1 kPa/sqrt(3). */
static void error_of_a_preshear(void **state)
{
    clod_plan plan;
    lab_write_file(state, "lab.csv", HEAD "\n54.8,40,10.96,12.7\n54.8,40,43.84,35.7\n");
    lab_refuse(state, RING, "locus: lab.csv, number: tau_p",
               "needs the key error: the table has no tau_pre_error");
    lab_load_good(state, RING, "locus: lab.csv, number: tau_p, error: 0.9 kPa", &plan);
    check_relative(plan.targets[0].error, 900.0, 1e-12);
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv",
                   "seed," HEAD "\n1,54.8,39,10.96,12.7\n1,54.8,39,43.84,35.7\n"
                   "2,54.8,40,10.96,12.7\n2,54.8,40,43.84,35.7\n"
                   "3,54.8,41,10.96,12.7\n3,54.8,41,43.84,35.7\n");
    lab_load_good(state, RING, "locus: lab.csv, number: tau_p, error: 0.1 kPa", &plan);
    check_relative(plan.targets[0].value, 40e3, 1e-12);
    check_relative(plan.targets[0].error, 1e3 / sqrt(3.0), 1e-9);
    assert_true(plan.targets[0].repeats.estimate);
    check_close(plan.targets[0].repeats.differences[0].value, -1e3, 1e-6);
    clod_plan_fini(&plan);
    // errors of 1, 2 and 2 kPa: of their mean 3 kPa/3 = 1 kPa, more than the 0.577 of the scatter
    lab_write_file(state, "lab.csv",
                   "seed," HEAD
                   ",tau_pre_error [kPa]\n1,54.8,39,10.96,12.7,1\n1,54.8,39,43.84,35.7,1\n"
                   "2,54.8,40,10.96,12.7,2\n2,54.8,40,43.84,35.7,2\n"
                   "3,54.8,41,10.96,12.7,2\n3,54.8,41,43.84,35.7,2\n");
    lab_load_good(state, RING, "locus: lab.csv, number: tau_p", &plan);
    check_relative(plan.targets[0].error, 1e3, 1e-9);
    assert_false(plan.targets[0].repeats.estimate);
    clod_plan_fini(&plan);
    lab_refuse(state, RING, "locus: lab.csv, number: phi_e",
               "of such a table it is tau, rho_b or tau_p");
}

// ---- tables that are drawn

#define SPECIMENS 0.02
#define PEAKS 0.01
#define REPEATS 400
#define FEW 20 ///< with sanitizers
#define STEPS 500
#define LEAST 342
#define USUAL 378

/** A table whose specimens, one a row, differ by 2 % and peaks by 1 %; `rows` at each stress, of one seed or of a seed each. */
static void draw_table(void **state, uint64_t repeat, size_t rows, bool seeds)
{
    char text[4000];
    size_t used = (size_t)snprintf(text, sizeof text, "seed," HEAD ",tau_sh_error [kPa]\n");
    for (size_t k = 0; k < POINTS * rows; k++) {
        const double tau = 5.0 + 0.7 * SIGMA[k / rows];
        const double specimen =
            1.0 + SPECIMENS * clod_random_normal(repeat, CLOD_RANDOM_TEST, k, 0);
        const double peak = 1.0 + PEAKS * clod_random_normal(repeat, CLOD_RANDOM_TEST, k, 2);
        used +=
            (size_t)snprintf(text + used, sizeof text - used, "%zu,54.8,%.9g,%.9g,%.9g,%.9g\n",
                             seeds ? 1 + k % rows : 1, 40.0 * specimen, SIGMA[k / rows],
                             tau * specimen * peak, PEAKS * tau);
    }
    lab_write_file(state, "lab.csv", text);
}

/** Whether the 90 % interval of a factor of all stresses holds 1, the truth; adds its width. */
static bool holds(const clod_plan *plan, double *width)
{
    static double density[STEPS], room[2 * MOST * MOST + 64];
    clod_misfit *misfit = misfit_of(plan);
    assert_true(clod_misfit_room(misfit) <= sizeof room / sizeof room[0]);
    double sum = 0.0;
    for (size_t i = 0; i < STEPS; i++) {
        const double factor = 0.85 + 0.3 * ((double)i + 0.5) / STEPS;
        clod_surrogate_value told[MOST];
        for (size_t t = 0; t < plan->target_count; t++) {
            const double sigma = plan->targets[t].normal_stress; // 0: of preshear
            const double tau = sigma > 0.0 ? 5e3 + 0.7 * sigma : 40e3;
            told[t] = (clod_surrogate_value){factor * tau, 0.0};
        }
        density[i] = exp(clod_misfit_density(misfit, told, room) + 40.0);
        sum += density[i];
    }
    clod_misfit_destroy(&misfit);
    double below = 0.0, part = 0.0;
    for (size_t i = 0; i < STEPS; i++) {
        below += i < STEPS / 2 ? density[i] / sum : 0.0;
        const double reached = part + density[i] / sum;
        *width += part < 0.95 && reached >= 0.05 ? 0.3 / STEPS : 0.0;
        part = reached;
    }
    return below > 0.05 && below < 0.95;
}

/** Of 400 intervals of 90 % 360 hold the truth, with a deviation of 6: within three of it, or up to `most`. */
static void check_coverage(void **state, size_t rows, bool seeds, const char *target,
                           size_t most, double widest)
{
    const uint64_t repeats = sanitized() ? FEW : REPEATS;
    size_t inside = 0;
    double width = 0.0;
    for (uint64_t repeat = 1; repeat <= repeats; repeat++) {
        clod_plan plan;
        draw_table(state, repeat, rows, seeds);
        lab_load_good(state, RING, target, &plan);
        inside += holds(&plan, &width) ? 1 : 0;
        clod_plan_fini(&plan);
    }
    if (sanitized()) {
        return; // a share does not depend on the build
    }
    print_message("%zu of %d intervals hold the truth, mean width %.4f\n", inside, REPEATS,
                  width / REPEATS);
    assert_in_range(inside, LEAST, most);
    assert_true(width / REPEATS < widest);
}

/** The mean of four prorated points is known to sqrt(2^2/4 + 1^2/4) = 1.12 %, nearly all of it by four preshears: Student's
 *  t of 3 degrees, 2.35 for 1.64, makes 2 2.35 1.12 0.92 = 4.8 % of it (0.92: mean of an estimated deviation). */
static void strength_of_prorated_points(void **state)
{
    check_coverage(state, 1, false, "locus: lab.csv", USUAL, 0.055);
}

/** Beside tau_p points tell a factor of all stresses no better than tau_p does. */
static void strength_of_prorated_points_and_their_preshear(void **state)
{
    check_coverage(state, 1, false,
                   "locus: lab.csv}, {test: lab, locus: lab.csv, number: tau_p", USUAL, 0.055);
}

/** Three rows at each stress, of twelve specimens: their scatter there is that of the peaks alone. With 11 degrees
 *  2 1.80 sqrt(2^2/12 + 1^2/12) = 2.3 %. */
static void strength_of_repeated_points(void **state)
{
    check_coverage(state, 3, false, "locus: lab.csv", USUAL, 0.028);
}

// The case shears at 10.96 to 43.84 kPa: these are its stresses, under tau_sh. Points that lie lower are told one by one.
static void exchanged_columns(void **state)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    lab_write_file(state, "lab.csv", HEAD "\n54.8,40,9,30\n54.8,40,15,35\n54.8,40,20,43.84\n");
    assert_false(
        lab_load(state, RING, ROLLING, "locus: lab.csv, error: 0.5 kPa", &plan, &status));
    assert_non_null(strstr(status.text,
                           "targets.0.locus: has normal stresses outside the "
                           "shear_stresses of test lab, and all of its shear stresses "
                           "within: are the columns sigma_sh and tau_sh exchanged?"));
    assert_null(strstr(status.text, "give it there"));
    clod_plan_fini(&plan);
    lab_write_file(state, "lab.csv",
                   HEAD "\n54.8,40,9,10.96\n54.8,40,30,27.4\n54.8,40,40,33\n");
    lab_refuse(state, RING, "locus: lab.csv, error: 0.5 kPa",
               "9 kPa is outside the shear_stresses of test lab; give it there");
}

// A slip, 60.28 for 30.28 kPa: the line is that of the row.
static void a_point_above_its_preshear(void **state)
{
    lab_write_file(state, "lab.csv", HEAD "\n54.8,40,11,12\n54.8,40,60.28,24\n54.8,40,43,33\n");
    lab_refuse(state, RING, "locus: lab.csv, error: 0.5 kPa",
               "lab.csv:3: shear at 60.280 kPa after a preshear at 54.800 kPa");
}

/** Three seeds of four specimens each: the mean of twelve points, as above, by 9 degrees of the preshears and 2 to 8 of the
 *  scatter between seeds, of which the fewest count. More than 90 % hold the truth. */
static void strength_of_seeds(void **state)
{
    check_coverage(state, 3, true, "locus: lab.csv", REPEATS, 0.031);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(points_share_the_error_of_their_mean_preshear),
        TEST(stated_errors_of_preshears_are_of_their_points),
        TEST(preshears_that_differ_by_their_errors_share_none),
        TEST(error_of_points_is_needed),
        TEST(a_point_above_its_preshear),
        TEST(points_of_one_preshear_share_none_of_its_error),
        TEST(rows_of_one_stress_have_it_beside_their_scatter),
        TEST(scatter_between_seeds_has_it_already),
        TEST(preshear_is_a_target_beside_its_points),
        TEST(error_of_a_preshear),
        TEST(exchanged_columns),
        TEST(strength_of_prorated_points),
        TEST(strength_of_prorated_points_and_their_preshear),
        TEST(strength_of_repeated_points),
        TEST(strength_of_seeds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
