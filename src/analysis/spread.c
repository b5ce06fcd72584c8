#include "analysis/spread.h"

#include <math.h>
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
    double specimen; ///< relative, of tau_p and tau_s together
    double line;     ///< of the prorated shear stress
} excess;

static excess find_excess(const clod_locus_point *points, size_t count,
                          const clod_spread_result *best)
{
    const clod_fit *fit = &best->fit;
    const double n = (double)count;
    const double tau_p = best->field[CLOD_FIELD_TAU_P];
    double between = 0.0; // variance of tau_p between the points
    double stated_p = 0.0;
    double expected = 0.0; // of the sum of squares about the line, from stated errors
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        between += pow(p->tau_p - tau_p, 2.0) / (n - 1.0);
        stated_p += p->tau_p_error * p->tau_p_error / n;
        const double scale = tau_p / p->tau_p;
        const double of_s = scale * p->tau_s_error;
        const double of_p = scale * p->tau_s * p->tau_p_error / p->tau_p;
        const double leverage = 1.0 / n + pow(p->sigma_s - fit->mean_x, 2.0) / fit->sxx;
        expected += (of_s * of_s + of_p * of_p) * (1.0 - leverage);
    }
    excess self = {sqrt(fmax(between - stated_p, 0.0)) / tau_p, 0.0};
    if (count > 2) {
        self.line = sqrt(fmax(fit->residual - expected, 0.0) / (n - 2.0));
    }
    return self;
}

typedef struct propagation {
    const clod_locus_point *points;
    size_t count;
    const clod_spread_result *best;
    double *scratch;
    clod_locus_point *changed;
    double variance[CLOD_FIELD_COUNT];
} propagation;

/** Add the effect of changing one point's tau_p and tau_s by plus and minus this much. */
static void add_effect(propagation *self, size_t at, double tau_p, double tau_s)
{
    if (tau_p == 0.0 && tau_s == 0.0) {
        return;
    }
    clod_spread_result side[2];
    for (int k = 0; k < 2; k++) {
        const double sign = k == 0 ? 1.0 : -1.0;
        self->changed[at] = self->points[at];
        self->changed[at].tau_p += sign * tau_p;
        self->changed[at].tau_s += sign * tau_s;
        side[k] = clod_spread_evaluate(self->changed, self->count, self->scratch,
                                       self->scratch + self->count);
        side[k].field[CLOD_FIELD_SIGMA_C] = side[k].sigma_c;
    }
    self->changed[at] = self->points[at];
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
}

void clod_spread_errors(const clod_locus_point *points, size_t count,
                        const clod_spread_result *best, double *scratch,
                        clod_locus_point *changed, double error[CLOD_FIELD_COUNT])
{
    propagation self = {points, count, best, scratch, changed, {0}};
    memcpy(changed, points, count * sizeof *points);
    const excess more = find_excess(points, count, best);
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        const double tau_p = best->field[CLOD_FIELD_TAU_P];
        const double scale = p->tau_p / tau_p;
        add_effect(&self, i, p->tau_p_error, 0.0);
        add_effect(&self, i, 0.0, p->tau_s_error);
        add_effect(&self, i, 0.0, more.line * scale);
        add_effect(&self, i, more.specimen * tau_p, more.specimen * p->tau_s / scale);
    }
    for (int k = 0; k < CLOD_FIELD_COUNT; k++) {
        error[k] = sqrt(self.variance[k]);
    }
}
