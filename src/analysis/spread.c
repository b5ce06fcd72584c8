#include "analysis/spread.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/** Cohesion below this part of the shear stress is rounding, not cohesion. */
#define ROUNDING 1e-12

clod_spread_result clod_spread_evaluate(const clod_locus_point *points, size_t count,
                                        double *sigma, double *prorated)
{
    double sigma_p = 0.0;
    double tau_p = 0.0;
    for (size_t i = 0; i < count; i++) {
        sigma_p += points[i].sigma_p / (double)count;
        tau_p += points[i].tau_p / (double)count;
    }
    for (size_t i = 0; i < count; i++) {
        sigma[i] = points[i].sigma_s;
        prorated[i] = points[i].tau_s * (tau_p / points[i].tau_p);
    }
    clod_spread_result self = {.fit = clod_fit_line(sigma, prorated, count)};
    if (fabs(self.fit.intercept) < ROUNDING * tau_p) {
        self.fit.intercept = 0.0;
    }
    const double c = self.fit.intercept;
    self.steady = clod_mohr_steady(c, self.fit.slope, sigma_p, tau_p);
    self.sigma_c = clod_mohr_unconfined(c, self.fit.slope);
    const double centre = self.steady.centre;
    const double radius = self.steady.radius;
    const double sigma_1 = centre + radius;
    double *field = self.field;
    field[CLOD_FIELD_SIGMA_P] = sigma_p;
    field[CLOD_FIELD_TAU_P] = tau_p;
    field[CLOD_FIELD_C] = c;
    field[CLOD_FIELD_PHI_LIN] = atan(self.fit.slope);
    field[CLOD_FIELD_PHI_E] = radius <= centre ? asin(radius / centre) : (double)NAN;
    field[CLOD_FIELD_PHI_SF] = atan(tau_p / sigma_p);
    field[CLOD_FIELD_SIGMA_1] = sigma_1;
    field[CLOD_FIELD_SIGMA_2] = centre - radius;
    field[CLOD_FIELD_SIGMA_C] = c >= 0.0 ? self.sigma_c : (double)NAN;
    field[CLOD_FIELD_FFC] = c >= 0.0 ? sigma_1 / self.sigma_c : (double)NAN; // c = 0: infinite
    return self;
}

/** Standard deviations of what is wrong with the points beyond their stated errors. */
typedef struct excess {
    double preshear; ///< relative, of tau_p and tau_s together
    double line;     ///< of the prorated shear stress
} excess;

double clod_spread_preshears(const clod_locus_point *points, const size_t *first, size_t count,
                             double tau_p)
{
    double preshears = 0.0;
    double mean = 0.0;
    double stated = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (first[i] == i) {
            preshears += 1.0;
            mean += points[i].tau_p;
            stated += points[i].tau_p_error * points[i].tau_p_error;
        }
    }
    if (preshears < 2.0) {
        return 0.0; // one preshear does not tell how preshears differ
    }
    mean /= preshears;
    double squares = 0.0;
    for (size_t i = 0; i < count; i++) {
        squares += first[i] == i ? pow(points[i].tau_p - mean, 2.0) : 0.0;
    }
    return sqrt(fmax(squares / (preshears - 1.0) - stated / preshears, 0.0)) / tau_p;
}

/** What the stated error of one preshear adds to the sum of squares about the line. */
static double expect_preshear(const clod_locus_point *points, const size_t *first, size_t count,
                              size_t preshear, const clod_spread_result *best)
{
    const clod_fit *fit = &best->fit;
    double sum = 0.0;
    double moment = 0.0;
    double squares = 0.0;
    for (size_t k = preshear; k < count; k++) {
        if (first[k] == preshear) {
            const clod_locus_point *p = &points[k];
            const double prorated = p->tau_s * best->field[CLOD_FIELD_TAU_P] / p->tau_p;
            const double off = prorated * p->tau_p_error / p->tau_p;
            sum += off;
            moment += off * (p->sigma_s - fit->mean_x);
            squares += off * off;
        }
    }
    // less what the line follows
    return squares - sum * sum / (double)count - moment * moment / fit->sxx;
}

static excess find_excess(const clod_locus_point *points, const size_t *first, size_t count,
                          const clod_spread_result *best)
{
    const clod_fit *fit = &best->fit;
    const double n = (double)count;
    const double tau_p = best->field[CLOD_FIELD_TAU_P];
    double expected = 0.0; // of the sum of squares about the line, from stated errors
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        const double of_s = tau_p / p->tau_p * p->tau_s_error;
        const double leverage = 1.0 / n + pow(p->sigma_s - fit->mean_x, 2.0) / fit->sxx;
        expected += of_s * of_s * (1.0 - leverage);
        expected += first[i] == i ? expect_preshear(points, first, count, i, best) : 0.0;
    }
    excess self = {clod_spread_preshears(points, first, count, tau_p), 0.0};
    if (count > 2) {
        self.line = sqrt(fmax(fit->residual - expected, 0.0) / (n - 2.0));
    }
    return self;
}

/** One error: of a preshear, with all of its points, or of a single point. */
typedef struct cause {
    size_t at;    ///< the point, or the first of the preshear
    double tau_p; ///< of the preshear [Pa]
    bool factor;  ///< whether tau_s of all points of the preshear change by the same factor
    double tau_s; ///< of the point [Pa]
} cause;

typedef struct propagation {
    const clod_locus_point *points;
    const size_t *first;
    size_t count;
    const clod_spread_result *best;
    double *scratch;
    clod_locus_point *changed;
    double variance[CLOD_FIELD_COUNT];
    double covariance[CLOD_LOCUS_PAIRS];
} propagation;

/** Put `times` of a cause into the points it concerns; 0 restores them. */
static void change_points(const propagation *self, const cause *by, double times)
{
    self->changed[by->at] = self->points[by->at];
    for (size_t k = by->at; k < self->count; k++) {
        if (self->first[k] == by->at) {
            const clod_locus_point *p = &self->points[k];
            const double tau_p = times * by->tau_p;
            self->changed[k].tau_p = p->tau_p + tau_p;
            self->changed[k].tau_s = p->tau_s * (by->factor ? 1.0 + tau_p / p->tau_p : 1.0);
        }
    }
    self->changed[by->at].tau_s += times * by->tau_s;
}

static void add_effect(propagation *self, cause by)
{
    if (by.tau_p == 0.0 && by.tau_s == 0.0) {
        return;
    }
    clod_spread_result side[2];
    for (int k = 0; k < 2; k++) {
        change_points(self, &by, k == 0 ? 1.0 : -1.0);
        side[k] = clod_spread_evaluate(self->changed, self->count, self->scratch,
                                       self->scratch + self->count);
        side[k].field[CLOD_FIELD_SIGMA_C] = side[k].sigma_c;
    }
    change_points(self, &by, 0.0);
    double change[CLOD_FIELD_COUNT];
    for (int k = 0; k < CLOD_FIELD_COUNT; k++) {
        change[k] = 0.5 * (side[0].field[k] - side[1].field[k]);
    }
    // a quotient whose denominator may come near zero: by its relative change
    const double *best = self->best->field;
    change[CLOD_FIELD_FFC] =
        best[CLOD_FIELD_FFC] * (change[CLOD_FIELD_SIGMA_1] / best[CLOD_FIELD_SIGMA_1] -
                                change[CLOD_FIELD_SIGMA_C] / self->best->sigma_c);
    for (int k = 0; k < CLOD_FIELD_COUNT; k++) {
        self->variance[k] += change[k] * change[k];
    }
    for (int k = 0; k < CLOD_LOCUS_PAIRS; k++) {
        self->covariance[k] += change[CLOD_FIELD_PAIRS[k].a] * change[CLOD_FIELD_PAIRS[k].b];
    }
}

static void tell(const propagation *self, clod_spread_told *told)
{
    for (int k = 0; k < CLOD_FIELD_COUNT; k++) {
        told->error[k] = sqrt(self->variance[k]);
    }
    for (int k = 0; k < CLOD_LOCUS_PAIRS; k++) {
        const double a = told->error[CLOD_FIELD_PAIRS[k].a];
        const double b = told->error[CLOD_FIELD_PAIRS[k].b];
        const bool both = a != 0.0 && b != 0.0; // a NAN stays one
        told->correlation[k] = both ? self->covariance[k] / (a * b) : 0.0;
    }
}

void clod_spread_errors(const clod_locus_point *points, const size_t *first, size_t count,
                        const clod_spread_result *best, double *scratch,
                        clod_locus_point *changed, clod_spread_told *told)
{
    propagation self = {points, first, count, best, scratch, changed, {0}, {0}};
    memcpy(changed, points, count * sizeof *points);
    const excess more = find_excess(points, first, count, best);
    const double tau_p = best->field[CLOD_FIELD_TAU_P];
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        add_effect(&self, (cause){.at = i, .tau_s = p->tau_s_error});
        add_effect(&self, (cause){.at = i, .tau_s = more.line * p->tau_p / tau_p});
        if (first[i] == i) {
            add_effect(&self, (cause){.at = i, .tau_p = p->tau_p_error});
            add_effect(&self, (cause){.at = i, .tau_p = more.preshear * tau_p, .factor = true});
        }
    }
    tell(&self, told);
}
