#include "clod/locus.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/mean.h"
#include "analysis/preshear.h"
#include "analysis/spread.h"
#include "analysis/warnings.h"
#include "analysis/warnings_points.h"
#include "base/given.h"
#include "base/memory.h"

#define UNSURE CLOD_LOCUS_ONE_SPECIMEN ", " CLOD_LOCUS_UNLESS_JENIKE
#define HALF_PI 1.57079632679489661923
#define NO_ERROR 1e-9 ///< of tau_p: less is rounding of points that all have one tau_p
#define FAR_BELOW                                                                              \
    0.02 ///< of the preshear stress: no test shears there, but Pa read as kPa may be

void clod_locus_free(void *memory)
{
    clod_memory_free(memory);
}

void clod_locus_fini(clod_locus *self)
{
    CLOD_NEED(self);
    clod_memory_free(self->marks);
    self->marks = NULL;
    self->point_count = 0;
}

/** Whether points without a seed have preshears of their own: in one specimen, or in one each. */
static bool is_unsure(const clod_locus *self)
{
    return self->preshear_count > 1 && self->marks[0].seed == 0;
}

const char *clod_locus_specimen_note(const clod_locus *self)
{
    CLOD_NEED(self);
    return self->errors != CLOD_LOCUS_ERRORS_FIT ? NULL
           : is_unsure(self)                     ? UNSURE
                                                 : CLOD_LOCUS_ONE_SPECIMEN;
}

const char *clod_locus_errors_note(const clod_locus *self)
{
    CLOD_NEED(self);
    const char *specimen = clod_locus_specimen_note(self);
    if (specimen == NULL || !self->preshear_untold) {
        return self->preshear_untold ? CLOD_LOCUS_PRESHEAR_UNTOLD : specimen;
    }
    return is_unsure(self) ? UNSURE "; " CLOD_LOCUS_PRESHEAR_UNTOLD
                           : CLOD_LOCUS_ONE_SPECIMEN "; " CLOD_LOCUS_PRESHEAR_UNTOLD;
}

const char *clod_locus_flow(double ffc)
{
    static const struct {
        double below;
        const char *text;
    } CLASSES[] = {{1.0, "not flowing"},
                   {2.0, "very cohesive"},
                   {4.0, "cohesive"},
                   {10.0, "easy flowing"},
                   {INFINITY, "free flowing"}};
    if (isnan(ffc)) {
        return "undefined";
    }
    size_t at = 0;
    while (ffc >= CLASSES[at].below && at + 1 < sizeof CLASSES / sizeof CLASSES[0]) {
        at++;
    }
    return CLASSES[at].text;
}

static bool check_point(const clod_locus_point *p, size_t number, clod_status *status)
{
    const struct {
        const char *name;
        double value;
        bool positive; ///< 0 is not allowed
    } VALUES[] = {{"preshear normal stress", p->sigma_p, true},
                  {"preshear shear stress", p->tau_p, true},
                  {"normal stress", p->sigma_s, false},
                  {"peak shear stress", p->tau_s, false},
                  {"bulk density", p->rho_b, false},
                  {"error of the preshear shear stress", p->tau_p_error, false},
                  {"error of the peak shear stress", p->tau_s_error, false},
                  {"error of the bulk density", p->rho_b_error, false},
                  {"bulk density away from walls", p->rho_inside, false}};
    for (size_t i = 0; i < sizeof VALUES / sizeof VALUES[0]; i++) {
        const double value = VALUES[i].value;
        if (!isfinite(value) || value < 0.0 || (VALUES[i].positive && value == 0.0)) {
            return clod_status_fail(
                status, CLOD_USAGE, "Point %zu: the %s is %g; it must be %s.", number + 1,
                VALUES[i].name, value, VALUES[i].positive ? "above 0" : "0 or more");
        }
    }
    return true;
}

static bool check_points(const clod_locus_point *points, size_t count, clod_status *status)
{
    if (count < 2) {
        return clod_status_fail(
            status, CLOD_USAGE,
            "A yield locus needs at least two points, better four; there %s "
            "%zu.",
            count == 1 ? "is" : "are", count);
    }
    double low = INFINITY;
    double high = 0.0;
    double preshear = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (!check_point(&points[i], i, status)) {
            return false;
        }
        low = fmin(low, points[i].sigma_s);
        high = fmax(high, points[i].sigma_s);
        preshear = fmax(preshear, points[i].sigma_p);
    }
    char unit[128] = "";
    if (high < FAR_BELOW * preshear) {
        snprintf(unit, sizeof unit,
                 " The preshear stress is %.3f kPa; is the unit of sigma_sh another one?",
                 preshear / 1000.0);
    }
    return high - low > CLOD_WARNINGS_SAME_STRESS * preshear ||
           clod_status_fail(
               status, CLOD_USAGE,
               "All %zu points have the same normal stress, %.3f kPa to within 1 %% "
               "of the preshear stress: a line needs points at different normal "
               "stresses.%s",
               count, points[0].sigma_s / 1000.0, unit);
}

/** A mean of one and the same number, set or rounded, without stated errors: nothing tells how well it is known. */
static clod_locus_value forget_exact(clod_locus_value mean)
{
    mean.error = mean.error > NO_ERROR * mean.value ? mean.error : (double)NAN;
    return mean;
}

/** Bulk density away from the walls, over the preshears that tell it. */
static clod_locus_value mean_inside(const clod_locus_point *points, const size_t *first,
                                    size_t count, double *scratch)
{
    size_t known = 0;
    for (size_t i = 0; i < count; i++) {
        if (first[i] == i && points[i].rho_inside > 0.0) {
            scratch[known++] = points[i].rho_inside;
        }
    }
    return forget_exact(clod_mean_of(scratch, known, 0.0));
}

/** Normal stress of preshear over the points; bulk densities over the preshears that tell them. */
static void fill_means(clod_locus *self, const clod_locus_point *points, const size_t *first,
                       size_t count, double *scratch)
{
    for (size_t i = 0; i < count; i++) {
        scratch[i] = points[i].sigma_p;
    }
    self->sigma_p = forget_exact(clod_mean_of(scratch, count, 0.0));
    size_t known = 0;
    double stated = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (first[i] == i && points[i].rho_b > 0.0) {
            scratch[known++] = points[i].rho_b;
            stated += points[i].rho_b_error * points[i].rho_b_error;
        }
    }
    self->rho_b = forget_exact(clod_mean_of(scratch, known, stated));
    self->rho_inside = mean_inside(points, first, count, scratch);
    self->preshear_count = 0;
    for (size_t i = 0; i < count; i++) {
        self->preshear_count += first[i] == i ? 1 : 0;
    }
}

/** Whether errors can be told: three points scatter, or all of them state theirs. */
static bool errors_known(const clod_locus_point *points, size_t count)
{
    bool stated = true;
    for (size_t i = 0; i < count; i++) {
        stated = stated && points[i].tau_s_error > 0.0 && points[i].tau_p_error > 0.0;
    }
    return stated || count > 2;
}

/** An error of more than 90 deg says nothing of an angle, which lies within 90 deg of 0. */
static bool is_told(clod_field_index k, double error)
{
    return CLOD_FIELDS[k].kind != CLOD_FIELD_ANGLE || error <= HALF_PI;
}

static void fill_values(clod_locus *self, const clod_spread_result *best,
                        const clod_spread_told *told)
{
    const bool known = self->errors != CLOD_LOCUS_ERRORS_NONE;
    for (clod_field_index k = CLOD_FIELD_TAU_P; k < CLOD_FIELD_RHO_B; k++) {
        const double value = best->field[k];
        const bool has = known && isfinite(value) && is_told(k, told->error[k]);
        *clod_field_of(self, k) =
            (clod_locus_value){value, has ? told->error[k] : (double)NAN, NAN};
    }
    if (self->phi_lin.value < 0.0) { // no solid: what its circles touch is no strength
        self->sigma_c = self->ffc = (clod_locus_value){NAN, NAN, NAN};
    }
    for (size_t k = 0; k < CLOD_LOCUS_PAIRS; k++) {
        const bool both = !isnan(clod_field_get(self, CLOD_FIELD_PAIRS[k].a).error) &&
                          !isnan(clod_field_get(self, CLOD_FIELD_PAIRS[k].b).error);
        self->correlation[k] = both ? told->correlation[k] : (double)NAN;
    }
    const double half = 0.5 * self->sigma_c.value;
    self->r_squared = best->fit.r_squared;
    self->parallel = best->steady.parallel;
    self->flow = clod_locus_flow(self->ffc.value);
    self->steady = (clod_locus_circle){best->steady.centre, best->steady.radius};
    self->unconfined = (clod_locus_circle){half, half};
}

/** One tau_p for all points, and no error stated: nothing tells how well it is known, so it is not exact. */
static void forget_preshear(clod_locus *self)
{
    self->preshear_untold = self->errors != CLOD_LOCUS_ERRORS_NONE &&
                            self->tau_p.error <= NO_ERROR * self->tau_p.value;
    if (self->preshear_untold) {
        self->tau_p.error = (double)NAN;
        self->phi_sf.error = (double)NAN;
    }
}

static void fill_marks(clod_locus *self, const clod_locus_point *points, const clod_fit *fit,
                       const double *prorated)
{
    for (size_t i = 0; i < self->point_count; i++) {
        const double sigma = points[i].sigma_s;
        self->marks[i] = (clod_locus_mark){.seed = points[i].seed,
                                           .sigma = sigma,
                                           .measured = points[i].tau_s,
                                           .error = points[i].tau_s_error,
                                           .prorated = prorated[i],
                                           .line = fit->intercept + fit->slope * sigma,
                                           .index = i};
    }
}

bool clod_locus_evaluate(const clod_locus_point *points, size_t count, clod_locus *locus,
                         clod_status *status)
{
    if (!CLOD_GIVEN(locus, status) || (count > 0 && !CLOD_GIVEN(points, status))) {
        return false;
    }
    memset(locus, 0, sizeof *locus);
    if (!check_points(points, count, status)) {
        return false;
    }
    double *work = clod_memory_alloc(4 * count, sizeof *work);
    size_t *first = clod_memory_alloc(count, sizeof *first);
    clod_locus_point *changed = clod_memory_alloc(count, sizeof *changed);
    locus->marks = clod_memory_alloc(count, sizeof *locus->marks);
    const bool done = work != NULL && first != NULL && changed != NULL && locus->marks != NULL;
    if (done) {
        clod_spread_told told;
        const double *prorated = work + count;
        const clod_spread_result best = clod_spread_evaluate(points, count, work, work + count);
        clod_preshear_find(points, count, first);
        clod_spread_errors(points, first, count, &best, work + 2 * count, changed, &told);
        locus->errors =
            errors_known(points, count) ? CLOD_LOCUS_ERRORS_FIT : CLOD_LOCUS_ERRORS_NONE;
        locus->seed_count = 1;
        locus->point_count = count;
        fill_values(locus, &best, &told);
        forget_preshear(locus);
        fill_means(locus, points, first, count, work + 2 * count);
        fill_marks(locus, points, &best.fit, prorated);
        const clod_warnings_line line = {best.fit, work, prorated, count};
        clod_warnings_check(locus, points, count, &line);
    } else {
        clod_locus_fini(locus);
    }
    clod_memory_free(work);
    clod_memory_free(first);
    clod_memory_free(changed);
    return done || clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
}

/** Mean over the seeds; NAN when one of them is, so that nothing is left out unseen. But rho_inside is the mean of those that
 *  tell it: whether a cell is wide enough for an inside can depend on the packing. */
static clod_locus_value combine_field(const clod_locus *loci, size_t count,
                                      clod_field_index index)
{
    const bool some = index == CLOD_FIELD_RHO_INSIDE;
    double n = 0.0;
    for (size_t i = 0; i < count; i++) {
        n += some && isnan(clod_field_get(&loci[i], index).value) ? 0.0 : 1.0;
    }
    double mean = n > 0.0 ? 0.0 : (double)NAN;
    for (size_t i = 0; i < count; i++) {
        const double part = clod_field_get(&loci[i], index).value / n;
        mean += some && isnan(part) ? 0.0 : part;
    }
    double squares = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double off = clod_field_get(&loci[i], index).value - mean;
        squares += some && isnan(off) ? 0.0 : off * off;
    }
    const double scatter = n > 1.0 ? sqrt(squares / (n - 1.0)) : (double)NAN;
    return (clod_locus_value){mean, scatter / sqrt(n), scatter};
}

static void combine_warnings(const clod_locus *loci, size_t count, clod_locus *self)
{
    size_t undefined = 0;
    for (size_t i = 0; i < count; i++) {
        undefined += isnan(loci[i].sigma_c.value) ? 1 : 0;
    }
    if (undefined > 0) {
        clod_warnings_add(self,
                          "sigma_c and ffc are undefined in %zu of %zu seeds, so they have no "
                          "mean.%s",
                          undefined, count,
                          fabs(self->c.value) <= 2.0 * self->c.error &&
                                  clod_warnings_is_usual(self->phi_lin.value)
                              ? " Cohesion is zero within two standard errors: the solid flows "
                                "freely."
                              : "");
    }
    clod_warnings_check_seeds(self);
    clod_warnings_points_check_seeds(self, loci, count);
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < loci[i].warning_count; k++) {
            clod_warnings_add(self, "Seed %lld: %s", (long long)loci[i].marks[0].seed,
                              loci[i].warnings[k]);
        }
    }
}

static void combine_values(const clod_locus *loci, size_t count, clod_locus *self)
{
    self->errors = CLOD_LOCUS_ERRORS_SEEDS;
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        *clod_field_of(self, k) = combine_field(loci, count, k);
    }
    forget_preshear(self);
    self->sigma_p = forget_exact(self->sigma_p);
    self->rho_b = forget_exact(self->rho_b);
    self->rho_inside = forget_exact(self->rho_inside);
    for (size_t k = 0; k < CLOD_LOCUS_PAIRS; k++) {
        self->correlation[k] = (double)NAN; // as few seeds as there are tell none
    }
    self->r_squared = loci[0].r_squared;
    for (size_t i = 0; i < count; i++) {
        self->r_squared = fmin(self->r_squared, loci[i].r_squared);
        self->parallel = self->parallel || loci[i].parallel;
        self->preshear_count += loci[i].preshear_count;
    }
    const double half = 0.5 * self->sigma_c.value;
    self->flow = clod_locus_flow(self->ffc.value);
    self->steady = (clod_locus_circle){0.5 * (self->sigma_1.value + self->sigma_2.value),
                                       0.5 * (self->sigma_1.value - self->sigma_2.value)};
    self->unconfined = (clod_locus_circle){half, half};
    combine_warnings(loci, count, self);
}

bool clod_locus_combine(const clod_locus *loci, size_t count, clod_locus *locus,
                        clod_status *status)
{
    if (!CLOD_GIVEN(locus, status) || (count > 0 && !CLOD_GIVEN(loci, status))) {
        return false;
    }
    memset(locus, 0, sizeof *locus);
    if (count == 0) {
        return clod_status_fail(status, CLOD_USAGE, "There is no yield locus to combine.");
    }
    size_t points = 0;
    for (size_t i = 0; i < count; i++) {
        points += loci[i].point_count;
    }
    clod_locus_mark *marks = clod_memory_alloc(points, sizeof *marks);
    if (marks == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", points);
    }
    if (count == 1) {
        *locus = loci[0];
    } else {
        locus->seed_count = count;
        combine_values(loci, count, locus);
    }
    locus->marks = marks;
    locus->point_count = 0;
    for (size_t i = 0; i < count; i++) {
        memcpy(marks + locus->point_count, loci[i].marks, loci[i].point_count * sizeof *marks);
        locus->point_count += loci[i].point_count;
    }
    return true;
}
