// The errors of one yield locus, which go together: how they are split, and how often intervals from shear points
// hold the truth.

#include "hopper/joint.h"

#include <stdlib.h>

#include "base/random.h"
#include "clod/locus.h"
#include "hopper/draw.h"
#include "hopper/loci.h"
#include "hopper/samples.h"
#include "support/check.h"
#include "support/sanitized.h"

#define LOCI 4
#define MOST 8 ///< points of a locus
#define REPEATS 400
#define SAMPLES 400
#define FACTOR                                                                                 \
    1.3 ///< flow factor: 1/FACTOR is the slope of the ray that the flow function meets
#define DEGREE 0.017453292519943295

/** A solid: cohesion, slope of the locus and steady shear stress of preshear at each stress [Pa]. */
static const double SIGMA[LOCI] = {1500.0, 3000.0, 6000.0, 12000.0};
static const double COHESION[LOCI] = {350.0, 550.0, 950.0, 1750.0};
static const double PHI = 37.0 * DEGREE;

/** How points are measured. */
typedef struct scheme {
    size_t points;
    bool stated;    ///< errors stand in the table; else they are what the points scatter
    bool specimens; ///< each point is of a specimen of its own, stronger or weaker by 2 %
    bool apart;     ///< the values are drawn independently
} scheme;

static double normal(uint64_t item, uint64_t draw)
{
    return clod_random_normal(17, CLOD_RANDOM_TEST, item, 2 * draw);
}

/** sigma_1 and f_c of a locus by hand: docs/theory/yield-locus.md, (3) and (4). */
static void truth_of(size_t g, double *sigma_1, double *f_c)
{
    const double t = tan(PHI), root = sqrt(1.0 + t * t), line = COHESION[g] + SIGMA[g] * t;
    const double tau_p = 0.98 * line;
    const double centre =
        SIGMA[g] + t * line - sqrt((1.0 + t * t) * (line * line - tau_p * tau_p));
    *sigma_1 = centre + (COHESION[g] + t * centre) / root;
    *f_c = 2.0 * COHESION[g] * (t + root);
}

/** Points with 1 % of noise each, and so their preshears; what is shared by points of a specimen beside it. */
static clod_locus measure(const scheme *of, uint64_t repeat, size_t g)
{
    clod_locus_point points[MOST];
    const double t = tan(PHI);
    const double tau_p = 0.98 * (COHESION[g] + SIGMA[g] * t);
    for (size_t i = 0; i < of->points; i++) {
        const uint64_t at = 100 * g + 10 * i;
        const double sigma = SIGMA[g] * (0.25 + 0.45 * (double)i / (double)(of->points - 1));
        const double tau = COHESION[g] + sigma * t;
        const double factor = of->specimens ? 1.0 + 0.02 * normal(repeat, at) : 1.0;
        points[i] =
            (clod_locus_point){.sigma_p = SIGMA[g],
                               .tau_p = tau_p * (factor + 0.01 * normal(repeat, at + 1)),
                               .sigma_s = sigma,
                               .tau_s = tau * (factor + 0.01 * normal(repeat, at + 2)),
                               .rho_b = 1250.0,
                               .tau_p_error = of->stated ? 0.01 * tau_p : 0.0,
                               .tau_s_error = of->stated ? 0.01 * tau : 0.0};
    }
    clod_locus locus;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_locus_evaluate(points, of->points, &locus, &status));
    return locus;
}

/** What the hopper makes of a table of these loci. */
static void tabulate(const scheme *of, uint64_t repeat, clod_curve_point *strength,
                     clod_curve_point *phi_t, clod_solid *solid)
{
    *solid = (clod_solid){0};
    for (size_t g = 0; g < LOCI; g++) {
        clod_locus locus = measure(of, repeat, g);
        clod_loci_row row = {0};
        row.strength = (clod_curve_point){.x = locus.sigma_1.value,
                                          .x_error = locus.sigma_1.error,
                                          .y = locus.sigma_c.value,
                                          .y_error = locus.sigma_c.error};
        row.phi_e = (clod_curve_point){.y = locus.phi_e.value, .y_error = locus.phi_e.error};
        row.phi_t =
            (clod_curve_point){.y = locus.phi_lin.value, .y_error = locus.phi_lin.error};
        for (size_t k = 0; k < CLOD_JOINT_PAIRS; k++) {
            row.correlation[k] = of->apart ? (double)NAN : locus.correlation[k];
        }
        assert_true(clod_loci_join(&row));
        assert_int_equal(row.strength.joint, !of->apart);
        strength[g] = row.strength;
        phi_t[g] = row.phi_t;
        phi_t[g].x = row.strength.x;
        phi_t[g].x_error = row.strength.x_error;
        strength[g].row = phi_t[g].row = g + 1;
        clod_locus_fini(&locus);
    }
    solid->strength = (clod_curve){.way = CLOD_CURVE_LINE, .points = strength, .count = LOCI};
    solid->phi_t = (clod_curve){.way = CLOD_CURVE_HELD, .points = phi_t, .count = LOCI};
}

/** f_c at the critical state, to which an outlet is proportional, and f_c tan(phi_t) at 5 kPa, as a rathole. */
static void look(const clod_solid *solid, double found[2])
{
    double x = 0.0;
    const clod_curve_meeting how =
        clod_curve_meet(&solid->strength, 1.0 / FACTOR, (double)INFINITY, &x);
    found[0] = how == CLOD_CURVE_MEETS   ? x / FACTOR
               : how == CLOD_CURVE_BELOW ? 0.0
                                         : (double)INFINITY;
    found[1] = clod_curve_at(&solid->strength, 5e3) * tan(clod_curve_at(&solid->phi_t, 5e3));
}

/** Those of the solid itself: the line of least squares through its flow function, which is straight to 1 %. */
static void truth(double found[2])
{
    clod_curve_point points[LOCI] = {{0}};
    clod_curve_point angle = {.x = 1.0, .y = PHI};
    clod_solid solid = {0};
    for (size_t g = 0; g < LOCI; g++) {
        truth_of(g, &points[g].x, &points[g].y);
    }
    solid.strength = (clod_curve){.way = CLOD_CURVE_LINE, .points = points, .count = LOCI};
    solid.phi_t = (clod_curve){.way = CLOD_CURVE_HELD, .points = &angle, .count = 1};
    look(&solid, found);
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left;
    const double b = *(const double *)right;
    return (a > b) - (a < b);
}

/** Shares of the laboratories whose 90 % intervals hold the truth, and mean widths over the truth. */
static void cover(const scheme *of, double share[2], double width[2])
{
    static double found[2][SAMPLES];
    double true_[2];
    truth(true_);
    share[0] = share[1] = width[0] = width[1] = 0.0;
    for (uint64_t repeat = 0; repeat < REPEATS; repeat++) {
        clod_curve_point strength[LOCI], phi_t[LOCI], drawn_strength[LOCI], drawn_phi_t[LOCI];
        clod_solid solid;
        tabulate(of, repeat, strength, phi_t, &solid);
        clod_solid drawn = solid;
        drawn.strength.points = drawn_strength;
        drawn.phi_t.points = drawn_phi_t;
        clod_draw draw;
        assert_true(clod_draw_init(&draw, &solid, repeat + 1));
        for (uint64_t i = 0; i < SAMPLES; i++) {
            double both[2];
            clod_draw_solid(&draw, i, &drawn);
            look(&drawn, both);
            found[0][i] = both[0];
            found[1][i] = both[1];
        }
        clod_draw_fini(&draw);
        for (int k = 0; k < 2; k++) {
            qsort(found[k], SAMPLES, sizeof *found[k], by_size);
            const double low = clod_samples_quantile(found[k], SAMPLES, 0.05);
            const double high = clod_samples_quantile(found[k], SAMPLES, 0.95);
            share[k] += low <= true_[k] && true_[k] <= high ? 1.0 / REPEATS : 0.0;
            width[k] += (high - low) / true_[k] / REPEATS;
        }
    }
    print_message(
        "%zu points, errors %s%s, drawn %s: outlet %.1f %% (width %.2f), rathole %.1f %% (%.2f)\n",
        of->points, of->stated ? "stated" : "from scatter", of->specimens ? ", specimens" : "",
        of->apart ? "apart" : "together", 100.0 * share[0], width[0], 100.0 * share[1],
        width[1]);
}

/** Three standard deviations of a share of 0.9 of 400 laboratories, 0.045, and 0.01 for 400 samples. Above it the
 *  errors of a locus, which are never made smaller than stated ones (docs/theory/yield-locus.md), are a little large.
 */
static void drawn_together_they_hold_the_truth(void **state)
{
    (void)state;
    if (sanitized()) {
        skip(); // a share of hundreds of repeats
    }
    for (int k = 0; k < 8; k++) {
        const scheme of = {
            .points = k / 4 == 0 ? 4 : 6, .stated = k / 2 % 2 == 1, .specimens = k % 2 == 1};
        double share[2], width[2];
        cover(&of, share, width);
        for (int n = 0; n < 2; n++) {
            assert_true(share[n] > 0.9 - 0.055 && share[n] < 0.975);
        }
    }
}

/** Drawn apart they are too wide: of 400 laboratories of a true share of 0.9 no more than 0.9 + 3 x 0.015 = 0.945
 *  hold it, and f_c tan(phi_t) of a locus is known better than f_c, which falls where phi_t rises. */
static void drawn_apart_they_are_too_wide(void **state)
{
    (void)state;
    if (sanitized()) {
        skip(); // a share of hundreds of repeats
    }
    for (int k = 0; k < 4; k++) {
        scheme of = {.points = 4, .stated = k / 2 == 1, .specimens = k % 2 == 1};
        double share[2], width[2], apart[2], wide[2];
        cover(&of, share, width);
        of.apart = true;
        cover(&of, apart, wide);
        for (int n = 0; n < 2; n++) {
            assert_true(apart[n] > 0.945);
            assert_true(wide[n] > 1.3 * width[n]);
        }
    }
}

/** The scatter of three points about a line has one degree of freedom. */
static void three_points_tell_little(void **state)
{
    (void)state;
    if (sanitized()) {
        skip(); // a share of hundreds of repeats
    }
    const scheme of = {.points = 3};
    double share[2], width[2];
    cover(&of, share, width);
    assert_true(share[0] > 0.8 && share[1] > 0.8);
}

/** L L' is the covariance: r s s' of each pair, and the first value moves with the first number alone. */
static void a_covariance_is_split(void **state)
{
    (void)state;
    const double error[] = {50.0, 30.0, 0.02, 0.04};
    const double r[] = {0.5, -0.4, -0.3, 0.1, -0.2, 0.6};
    const double all[4][4] = {{1.0, 0.5, -0.4, -0.3},
                              {0.5, 1.0, 0.1, -0.2},
                              {-0.4, 0.1, 1.0, 0.6},
                              {-0.3, -0.2, 0.6, 1.0}};
    double part[4][4];
    assert_true(clod_joint_factor(error, r, part));
    for (int a = 0; a < 4; a++) {
        for (int b = 0; b < 4; b++) {
            double sum = 0.0;
            for (int k = 0; k < 4; k++) {
                sum += part[a][k] * part[b][k];
            }
            check_close(sum / (error[a] * error[b]), all[a][b], 1e-12);
        }
    }
    check_close(part[0][0], 50.0, 1e-12);
    assert_true(part[0][1] == 0.0 && part[0][2] == 0.0 && part[0][3] == 0.0);
}

/** Two that move as one leave a rank of three; the third may then not tell them apart. */
static void values_may_move_as_one(void **state)
{
    (void)state;
    const double error[] = {50.0, 30.0, 0.02, 0.04};
    const double one[] = {1.0, 0.5, 0.2, 0.5, 0.2, 0.1};
    const double two[] = {1.0, 0.5, 0.2, 0.4, 0.2, 0.1};
    const double none[] = {0.9,  0.9, 0.0,
                           -0.9, 0.0, 0.0}; // 1 and 2 alike, 1 and 3, and 2 against 3
    double part[4][4];
    assert_true(clod_joint_factor(error, one, part));
    check_close(part[1][0], 30.0, 1e-12);
    assert_true(part[1][1] == 0.0 && part[2][1] == 0.0);
    assert_false(clod_joint_factor(error, two, part));
    assert_false(clod_joint_factor(error, none, part));
}

/** A value that is not there has no part, whatever its correlations. */
static void values_may_be_missing(void **state)
{
    (void)state;
    const double error[] = {0.0, 30.0, 0.0, 0.04};
    const double r[] = {0.6, (double)NAN, (double)NAN, (double)NAN, -0.8, (double)NAN};
    double part[4][4];
    assert_true(clod_joint_factor(error, r, part));
    for (int k = 0; k < 4; k++) {
        assert_true(part[0][k] == 0.0 && part[2][k] == 0.0);
    }
    check_close(part[1][1], 30.0, 1e-12);
    check_close(part[3][1], -0.8 * 0.04, 1e-12);
    check_close(part[3][3], 0.6 * 0.04, 1e-12);
}

/** Drawn values have the means, errors and correlations of the table: 4000 samples tell a correlation to
 *  1/sqrt(4000) = 0.016, an error to 0.011 of itself. */
static void drawn_values_have_their_correlations(void **state)
{
    (void)state;
    enum { MANY = 4000 };
    clod_loci_row row = {.correlation = {0.5, -0.4, -0.3, 0.1, -0.2, 0.6}};
    row.strength = (clod_curve_point){.x = 3e3, .x_error = 50.0, .y = 1400.0, .y_error = 30.0};
    row.phi_e = (clod_curve_point){.y = 0.8, .y_error = 0.02};
    row.phi_t = (clod_curve_point){.y = 0.6, .y_error = 0.04};
    assert_true(clod_loci_join(&row));
    clod_curve_point points[3] = {row.strength, row.phi_e, row.phi_t};
    clod_curve_point drawn_points[3];
    clod_solid solid = {0};
    clod_solid drawn = {0};
    for (int k = 0; k < 3; k++) {
        points[k].row = 1;
        points[k].x = 3e3;
        points[k].x_error = 50.0;
        solid.curves[k] = drawn.curves[k] = (clod_curve){.points = &points[k], .count = 1};
        drawn.curves[k].points = &drawn_points[k];
    }
    const double mean[] = {3e3, 1400.0, 0.8, 0.6};
    const double error[] = {50.0, 30.0, 0.02, 0.04};
    const double all[4][4] = {{1.0, 0.5, -0.4, -0.3},
                              {0.5, 1.0, 0.1, -0.2},
                              {-0.4, 0.1, 1.0, 0.6},
                              {-0.3, -0.2, 0.6, 1.0}};
    double sum[4][4] = {{0.0}};
    clod_draw draw;
    assert_true(clod_draw_init(&draw, &solid, 3));
    for (uint64_t i = 0; i < MANY; i++) {
        clod_draw_solid(&draw, i, &drawn);
        const double off[] = {drawn_points[0].x, drawn_points[0].y, drawn_points[1].y,
                              drawn_points[2].y};
        assert_true(drawn_points[1].x == off[0] && drawn_points[2].x == off[0]);
        for (int a = 0; a < 4; a++) {
            for (int b = 0; b < 4; b++) {
                sum[a][b] +=
                    (off[a] - mean[a]) / error[a] * (off[b] - mean[b]) / error[b] / MANY;
            }
        }
    }
    clod_draw_fini(&draw);
    for (int a = 0; a < 4; a++) {
        for (int b = 0; b < 4; b++) {
            check_close(sum[a][b], all[a][b], a == b ? 4.0 * 0.022 : 4.0 * 0.018);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_covariance_is_split),
        cmocka_unit_test(values_may_move_as_one),
        cmocka_unit_test(values_may_be_missing),
        cmocka_unit_test(drawn_values_have_their_correlations),
        cmocka_unit_test(drawn_together_they_hold_the_truth),
        cmocka_unit_test(drawn_apart_they_are_too_wide),
        cmocka_unit_test(three_points_tell_little),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
