/**
 * @file nearest_solid.c
 * Least squares over the solids that are possible, with coordinates from 0 to 1 whose whole cube is possible:
 * docs/theory/calibration.md, "What targets cannot be".
 */

#include "calibrate/nearest_solid.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <string.h>

#include "analysis/mohr.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"

#define UNKNOWNS 3
#define ABOVE                                                                                  \
    1.25 ///< tau_p over the height of the locus, at most: a specimen of cases/lab-to-outlet has 1.15
#define STARTS 4         ///< along each coordinate
#define STEPS 80         ///< of one descent, at most
#define SETTLED 1e-9     ///< relative, of the angles
#define FLAT 1e-12       ///< relative, of the gradient
#define AT_END 1e-3      ///< derivative of a coordinate over its angle; 1 in the middle
#define INDEPENDENT 3e-4 ///< how far a direction must be from those of other numbers

/** A possible solid; SI. */
typedef struct solid {
    double c, t, phi_lin; ///< t = tan(phi_lin)
    double stress, tau_p; ///< of preshear
    double centre, radius;
} solid;

/** Measured numbers that a solid is sought for. */
typedef struct search {
    double preshear;
    bool above;  ///< preshear is on the locus or above it, else on it or below
    bool angled; ///< a number is phi_e, which a circle that reaches into tension has not
    clod_nearest_number *numbers;
    size_t count;
    double best[UNKNOWNS], least; ///< angles and chi-square of the nearest solid
} search;

/**
 * phi_lin and phi_sf from 0 to 80 deg, and with phi_e to where the circle that touches the locus in preshear begins at 0. Below the
 * locus the centre of the circle goes from that of the circle that touches it at a normal stress of 0, or with phi_e begins at 0, to that
 * of the one that touches in preshear, or whose locus has no cohesion; above it this last circle stays, and its locus falls.
 */
static solid make(const search *self, const double *at)
{
    const double most = CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE;
    const double stress = self->preshear;
    solid made = {.phi_lin = at[0] * most, .stress = stress};
    made.t = tan(made.phi_lin);
    const double length = sqrt(1.0 + made.t * made.t);
    const double steepest = tan(most);
    made.tau_p = at[1] * stress * (self->angled ? fmin(made.t + length, steepest) : steepest);
    const double first = self->angled
                             ? 0.5 * (stress + made.tau_p * made.tau_p / stress)
                             : made.t * (hypot(length * stress, made.tau_p) - made.t * stress);
    const double last = clod_mohr_steady(0.0, made.t, stress, made.tau_p).centre;
    made.centre = self->above ? last : first + at[2] * (last - first);
    made.radius = hypot(made.centre - stress, made.tau_p);
    made.c = fmax(made.radius * length - made.t * made.centre, 0.0);
    if (self->above) {
        const double least = fmax(made.tau_p / ABOVE - made.t * stress, 0.0);
        made.c -= at[2] * fmax(made.c - least, 0.0);
    }
    return made;
}

// ---- its numbers

static double cohesion(const solid *of, double stress)
{
    (void)stress;
    return of->c;
}

static double slope(const solid *of, double stress)
{
    (void)stress;
    return of->phi_lin;
}

static double line_at(const solid *of, double stress)
{
    return of->c + of->t * stress;
}

static double preshear_shear(const solid *of, double stress)
{
    (void)stress;
    return of->tau_p;
}

static double steady_slope(const solid *of, double stress)
{
    (void)stress;
    return atan2(of->tau_p, of->stress);
}

static double effective_slope(const solid *of, double stress)
{
    (void)stress;
    return asin(fmin(of->radius / of->centre, 1.0));
}

static double major(const solid *of, double stress)
{
    (void)stress;
    return of->centre + of->radius;
}

static double minor(const solid *of, double stress)
{
    (void)stress;
    return of->centre - of->radius;
}

static double strength(const solid *of, double stress)
{
    (void)stress;
    return clod_mohr_unconfined(of->c, of->t);
}

static double flowability(const solid *of, double stress)
{
    return major(of, stress) / strength(of, stress);
}

typedef double (*formula)(const solid *of, double stress);

static formula find(const char *key)
{
    static const struct {
        const char *key;
        formula of;
    } ALL[] = {{"c", cohesion},           {"phi_lin", slope},       {"tau", line_at},
               {"tau_p", preshear_shear}, {"phi_sf", steady_slope}, {"phi_e", effective_slope},
               {"sigma_1", major},        {"sigma_2", minor},       {"sigma_c", strength},
               {"ffc", flowability}};
    for (size_t k = 0; k < sizeof ALL / sizeof ALL[0]; k++) {
        if (strcmp(ALL[k].key, key) == 0) {
            return ALL[k].of;
        }
    }
    return NULL;
}

bool clod_nearest_has(const char *key)
{
    return find(key) != NULL;
}

static double number_of(const clod_nearest_number *number, const solid *of)
{
    return find(number->key)(of, number->stress);
}

// ---- least squares

/** The coordinates are squares of sines of angles, so that no step leaves the cube. */
static void place(const gsl_vector *angles, double *at)
{
    for (size_t k = 0; k < UNKNOWNS; k++) {
        at[k] = pow(sin(gsl_vector_get(angles, k)), 2.0);
    }
}

/** Differences over their errors; zeros behind them, since GSL wants as many as there are unknowns. */
static int compare(const gsl_vector *angles, void *context, gsl_vector *off)
{
    const search *self = context;
    double at[UNKNOWNS];
    place(angles, at);
    const solid of = make(self, at);
    gsl_vector_set_zero(off);
    for (size_t k = 0; k < self->count; k++) {
        const clod_nearest_number *one = &self->numbers[k];
        gsl_vector_set(off, k, (number_of(one, &of) - one->value) / one->error);
    }
    return GSL_SUCCESS;
}

/** Levenberg and Marquardt from angles. @return chi-square where it ends */
static double descend(search *self, const double *angles, gsl_multifit_nlinear_workspace *by)
{
    gsl_multifit_nlinear_fdf of = {
        .f = compare, .n = by->f->size, .p = UNKNOWNS, .params = self};
    const gsl_vector_const_view from = gsl_vector_const_view_array(angles, UNKNOWNS);
    int why;
    double chi_square;
    gsl_multifit_nlinear_init(&from.vector, &of, by);
    gsl_multifit_nlinear_driver(STEPS, SETTLED, FLAT, 0.0, NULL, NULL, &why, by);
    gsl_blas_ddot(by->f, by->f, &chi_square);
    return chi_square;
}

/** Least chi-square from many places, and where it is. */
static void search_all(search *self, gsl_multifit_nlinear_workspace *by)
{
    self->least = HUGE_VAL;
    for (int k = 0; k < STARTS * STARTS * STARTS; k++) {
        double angles[UNKNOWNS];
        for (int m = 0, rest = k; m < UNKNOWNS; m++, rest /= STARTS) {
            angles[m] = (rest % STARTS + 0.5) / STARTS * M_PI_2;
        }
        const double found = descend(self, angles, by);
        if (k == 0 || found < self->least) {
            self->least = found;
            for (size_t m = 0; m < UNKNOWNS; m++) {
                self->best[m] = gsl_vector_get(by->x, m);
            }
        }
    }
}

/** Directions in which a fit can still move its numbers: those of their derivatives over the coordinates that are at no end of their
 *  range, of each number with a length of 1. The derivatives of the fit are lost. */
static size_t rank_of(gsl_multifit_nlinear_workspace *by)
{
    double other[UNKNOWNS * UNKNOWNS], values[UNKNOWNS];
    gsl_matrix_view turned = gsl_matrix_view_array(other, UNKNOWNS, UNKNOWNS);
    gsl_vector_view lengths = gsl_vector_view_array(values, UNKNOWNS);
    for (size_t k = 0; k < UNKNOWNS; k++) {
        const double rate = sin(2.0 * gsl_vector_get(by->x, k)); // of the coordinate, place()
        gsl_vector_view column = gsl_matrix_column(by->J, k);
        gsl_vector_scale(&column.vector, fabs(rate) > AT_END ? 1.0 / rate : 0.0);
    }
    for (size_t n = 0; n < by->J->size1; n++) {
        gsl_vector_view row = gsl_matrix_row(by->J, n);
        const double length = gsl_blas_dnrm2(&row.vector);
        gsl_vector_scale(&row.vector, length > 0.0 ? 1.0 / length : 0.0);
    }
    gsl_linalg_SV_decomp_jacobi(by->J, &turned.matrix, &lengths.vector);
    size_t rank = 0;
    for (size_t k = 0; k < UNKNOWNS; k++) {
        rank += values[k] > INDEPENDENT ? 1 : 0;
    }
    return rank;
}

clod_nearest clod_nearest_fit(double preshear, clod_nearest_number *numbers, size_t count)
{
    gsl_set_error_handler_off(); // GSL's own ends the program
    const gsl_multifit_nlinear_parameters usual = gsl_multifit_nlinear_default_parameters();
    gsl_multifit_nlinear_workspace *by = gsl_multifit_nlinear_alloc(
        gsl_multifit_nlinear_trust, &usual, count > UNKNOWNS ? count : UNKNOWNS, UNKNOWNS);
    if (by == NULL) {
        return (clod_nearest){(double)NAN, (double)NAN};
    }
    search below = {.preshear = preshear, .numbers = numbers, .count = count};
    for (size_t k = 0; k < count; k++) {
        below.angled = below.angled || strcmp(numbers[k].key, "phi_e") == 0;
    }
    search above = below;
    above.above = true;
    search_all(&below, by);
    search_all(&above, by);
    search *found = above.least < below.least ? &above : &below;
    descend(found, found->best, by); // for the derivatives there
    double at[UNKNOWNS];
    place(by->x, at);
    const solid nearest = make(found, at);
    for (size_t k = 0; k < count; k++) {
        numbers[k].nearest = number_of(&numbers[k], &nearest);
    }
    const double freedom = (double)count - (double)rank_of(by);
    gsl_multifit_nlinear_free(by);
    return (clod_nearest){found->least, freedom};
}

double clod_nearest_limit(double freedom)
{
    return gsl_cdf_chisq_Pinv(erf(CLOD_PLAN_FIRM_ERRORS / sqrt(2.0)), fmax(freedom, 1.0));
}
