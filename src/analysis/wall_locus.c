#include "clod/wall_locus.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/fit.h"
#include "analysis/warnings.h"
#include "base/given.h"
#include "base/memory.h"

#define R2_LEAST 0.95               ///< as of a yield locus
#define BELOW_SLACK 0.02            ///< of the largest shear stress: less does not matter
#define STEEP (50.0 * M_PI / 180.0) ///< of the line: solids hardly have more, walls not at all
#define FLAT (2.0 * M_PI / 180.0)   ///< ice on a wall has more
#define ADHESION_ERRORS 2.0         ///< standard errors below 0 that are no chance

typedef clod_wall_locus_point point;

void clod_wall_locus_fini(clod_wall_locus *self)
{
    CLOD_NEED(self);
    clod_memory_free(self->marks);
    self->marks = NULL;
    self->point_count = 0;
}

bool clod_wall_locus_one_specimen(const clod_wall_locus *self)
{
    CLOD_NEED(self);
    bool repeats = false; // at one stress: of several specimens, or of one, nobody knows
    for (size_t i = 1; i < self->point_count; i++) {
        const double before = self->marks[i - 1].point.sigma;
        repeats = repeats ||
                  before - self->marks[i].point.sigma <= CLOD_WARNINGS_SAME_STRESS * before;
    }
    return self->errors == CLOD_LOCUS_ERRORS_FIT && self->seed_count == 1 && !repeats;
}

static void __attribute__((format(printf, 2, 3)))
warn(clod_wall_locus *self, const char *format, ...)
{
    if (self->warning_count < CLOD_WALL_LOCUS_WARNINGS) {
        va_list args;
        va_start(args, format);
        vsnprintf(self->warnings[self->warning_count++], CLOD_LOCUS_WARNING_TEXT, format, args);
        va_end(args);
    }
}

// ---- what comes in

static bool check_point(const point *p, size_t number, clod_status *status)
{
    const bool good = isfinite(p->sigma) && p->sigma > 0.0 && isfinite(p->tau) &&
                      isfinite(p->sigma_error) && p->sigma_error >= 0.0 &&
                      isfinite(p->tau_error) && p->tau_error >= 0.0;
    return good || clod_status_fail(status, CLOD_USAGE,
                                    "Point %zu: a wall normal stress of %g Pa with a shear "
                                    "stress of %g Pa: the first must be above 0, and errors 0 "
                                    "or more.",
                                    number + 1, p->sigma, p->tau);
}

/** By seed, then in descending order of sigma. */
static int in_order(const void *first, const void *second)
{
    const point *a = first;
    const point *b = second;
    return a->seed != b->seed ? (a->seed > b->seed) - (a->seed < b->seed)
                              : (a->sigma < b->sigma) - (a->sigma > b->sigma);
}

/** Sorted points of one seed make a line. */
static bool check_seed(const point *points, size_t count, bool seeds, clod_status *status)
{
    char of[48] = "";
    if (seeds) {
        snprintf(of, sizeof of, " of seed %lld", (long long)points[0].seed);
    }
    if (count < 2) {
        return clod_status_fail(status, CLOD_USAGE,
                                "A wall yield locus needs at least two points, better five; "
                                "there is %zu%s.",
                                count, of);
    }
    const double most = points[0].sigma;
    return most - points[count - 1].sigma > CLOD_WARNINGS_SAME_STRESS * most ||
           clod_status_fail(status, CLOD_USAGE,
                            "All %zu points%s have the same wall normal stress, "
                            "%.3f kPa to within 1 %%: a line needs points at different ones.",
                            count, of, 1e-3 * most);
}

// ---- one seed

/** Line through the points of one seed, with the standard errors of what is read off it. */
typedef struct line {
    clod_fit fit;
    clod_locus_value phi_w, tau_ad;
    bool known; ///< whether the errors are
} line;

/** Square of what is stated for a point, as the line sees it [Pa^2]. */
static double stated(const point *p, double slope)
{
    const double across = slope * p->sigma_error;
    return p->tau_error * p->tau_error + across * across;
}

static line line_of(const point *points, size_t count, double *work)
{
    double *x = work, *y = work + count;
    for (size_t i = 0; i < count; i++) {
        x[i] = points[i].sigma;
        y[i] = points[i].tau;
    }
    line self = {.fit = clod_fit_line(x, y, count)};
    const double slope = self.fit.slope;
    double *variance = y; // the line has taken y
    for (size_t i = 0; i < count; i++) {
        variance[i] = stated(&points[i], slope);
    }
    const clod_fit_error error = clod_fit_errors(&self.fit, x, variance, count);
    self.known = error.known;
    self.phi_w =
        (clod_locus_value){atan(slope), error.slope / (1.0 + slope * slope), (double)NAN};
    self.tau_ad = (clod_locus_value){self.fit.intercept, error.intercept, (double)NAN};
    return self;
}

/** phi_x = atan(tau/sigma), with the errors of both. */
static clod_locus_value angle_of(const point *p)
{
    const double ratio = p->tau / p->sigma;
    const double error = sqrt(stated(p, ratio)) / p->sigma / (1.0 + ratio * ratio);
    return (clod_locus_value){atan(ratio), error > 0.0 ? error : (double)NAN, (double)NAN};
}

static void put_marks(clod_wall_locus *self, const point *points, size_t count,
                      const clod_fit *fit)
{
    for (size_t i = 0; i < count; i++) {
        self->marks[self->point_count++] = (clod_wall_locus_mark){
            points[i], angle_of(&points[i]), fit->intercept + fit->slope * points[i].sigma};
    }
}

// ---- all seeds

/** Add a value of one more seed; `value` and `scatter` are running mean and sum of squares. */
static void add_seed(clod_locus_value *all, clod_locus_value one, size_t number)
{
    const double step = one.value - all->value;
    all->value += step / (double)number;
    all->scatter += step * (one.value - all->value);
    all->error = one.error;
}

/** From the sums to mean, standard error of the mean and scatter. */
static void end_seeds(clod_locus_value *all, size_t seeds)
{
    if (seeds > 1) {
        all->scatter = sqrt(all->scatter / ((double)seeds - 1.0));
        all->error = all->scatter / sqrt((double)seeds);
    } else {
        all->scatter = (double)NAN;
    }
}

/** Whether all points tell which stress was asked for, as those of a simulation do: its columns and units are right. */
static bool is_simulated(const clod_wall_locus *self)
{
    bool all = true;
    for (size_t i = 0; i < self->point_count; i++) {
        all = all && self->marks[i].point.wall_stress > 0.0;
    }
    return all;
}

/** An angle that no wall has, in a simulation. */
static void look_at_simulated_angle(clod_wall_locus *self, const point *end)
{
    const double angle = self->phi_w.value;
    if (angle < 0.0) {
        warn(self,
             "The shear stress falls while the normal stress rises: no wall friction has "
             "a negative angle. Was shear steady at each point? Else the points scatter by "
             "more than they rise: give more shear, more grains or more seeds.");
    } else if (angle > STEEP && end->tau > end->sigma) {
        warn(
            self,
            "phi_w = %.1f deg, and the shear stress is above the normal stress even at the "
            "largest: no wall is as rough. Look at the plate, and whether grains jam between it and the cell.",
            angle / M_PI * 180.0);
    } else if (angle < FLAT && end->tau < tan(FLAT) * end->sigma) {
        warn(
            self,
            "phi_w = %.2g deg: no wall is as smooth. Has the plate a friction, or does a single "
            "layer of grains roll on it?",
            angle / M_PI * 180.0);
    }
}

/** The same of a table, from which it comes. `end` is the point at the largest stress. */
static void look_at_angle(clod_wall_locus *self, const point *end)
{
    const double angle = self->phi_w.value;
    const bool of_angle = end->of_angle;
    if (is_simulated(self)) {
        look_at_simulated_angle(self, end);
    } else if (angle < 0.0) {
        warn(self, "The shear stress falls while the normal stress rises: no wall friction has "
                   "a negative angle. Look at the points: their columns, their units, whether "
                   "shear was steady.");
    } else if (angle > STEEP && end->tau > end->sigma) {
        warn(
            self,
            "phi_w = %.1f deg, and the shear stress is above the normal stress even at the "
            "largest: no wall is as rough. %s",
            angle / M_PI * 180.0,
            of_angle
                ? "Has phi_x another unit, or is it the angle of something else?"
                : "Have the columns sigma_w and tau_w been exchanged, or has one another unit?");
    } else if (angle < FLAT && end->tau < tan(FLAT) * end->sigma) {
        warn(
            self,
            "phi_w = %.2g deg: no wall is as smooth. Has %s, or does a single layer of grains roll on the plate?",
            angle / M_PI * 180.0,
            of_angle ? "phi_x another unit, rad under a header in deg for instance"
                     : "the column sigma_w or tau_w another unit");
    }
}

/** Points that are no steady shear, in a line that takes them as such. */
static void look_at_steadiness(clod_wall_locus *self)
{
    size_t count = 0;
    for (size_t i = 0; i < self->point_count; i++) {
        count += self->marks[i].point.unsteady ? 1 : 0;
    }
    if (count > 0) {
        warn(self,
             "%zu of %zu points %s not steady: the shear stress still changed, and phi_x there "
             "is none of steady shear. Shear on, or leave %s out.",
             count, self->point_count, count == 1 ? "was" : "were", count == 1 ? "it" : "them");
    }
}

/** A stated error as large as its value, in a table. */
static void look_at_stated(clod_wall_locus *self)
{
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->marks[i].point;
        const bool tau = p->tau_error > 0.0 && p->tau_error >= fabs(p->tau);
        if (tau || p->sigma_error >= p->sigma) {
            warn(
                self,
                "%s is %.3f kPa with a stated standard error of %.3f kPa: nothing was measured "
                "then; check the column of errors and its unit.",
                tau ? "tau_w" : "sigma_w", 1e-3 * (tau ? p->tau : p->sigma),
                1e-3 * (tau ? p->tau_error : p->sigma_error));
            return;
        }
    }
}

static void look(clod_wall_locus *self)
{
    double largest = 0.0;
    const point *end = &self->marks[0].point;
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->marks[i].point;
        largest = fmax(largest, p->tau);
        end = p->sigma > end->sigma ? p : end;
    }
    look_at_angle(self, end);
    look_at_steadiness(self);
    if (!is_simulated(self)) {
        look_at_stated(self);
    }
    if (self->tau_ad.value < -BELOW_SLACK * largest &&
        !(self->tau_ad.value > -ADHESION_ERRORS * self->tau_ad.error)) {
        warn(self,
             "The line meets the axis below 0, at %.3f kPa: the wall yield locus bends. Use "
             "phi_x near the stresses at hand, not the line.",
             1e-3 * self->tau_ad.value);
    }
    if (self->r_squared < R2_LEAST) {
        warn(self, "The points do not lie on a line (r2 = %.3f): use phi_x at each stress.",
             self->r_squared);
    }
}

static bool evaluate(const point *points, size_t count, double *work, clod_wall_locus *self,
                     clod_status *status)
{
    bool known = true;
    const bool seeds = points[0].seed != points[count - 1].seed; // sorted by them
    self->r_squared = 1.0;
    for (size_t first = 0, next; first < count; first = next) {
        next = first + 1;
        while (next < count && points[next].seed == points[first].seed) {
            next++;
        }
        if (!check_seed(points + first, next - first, seeds, status)) {
            return false;
        }
        const line one = line_of(points + first, next - first, work);
        self->seed_count++;
        add_seed(&self->phi_w, one.phi_w, self->seed_count);
        add_seed(&self->tau_ad, one.tau_ad, self->seed_count);
        self->r_squared = fmin(self->r_squared, one.fit.r_squared);
        known = known && one.known;
        put_marks(self, points + first, next - first, &one.fit);
    }
    end_seeds(&self->phi_w, self->seed_count);
    end_seeds(&self->tau_ad, self->seed_count);
    self->errors = self->seed_count > 1 ? CLOD_LOCUS_ERRORS_SEEDS
                   : known              ? CLOD_LOCUS_ERRORS_FIT
                                        : CLOD_LOCUS_ERRORS_NONE;
    look(self);
    return true;
}

bool clod_wall_locus_evaluate(const clod_wall_locus_point *points, size_t count,
                              clod_wall_locus *locus, clod_status *status)
{
    if (!CLOD_GIVEN(locus, status) || (count > 0 && !CLOD_GIVEN(points, status))) {
        return false;
    }
    memset(locus, 0, sizeof *locus);
    if (count == 0) {
        return clod_status_fail(status, CLOD_USAGE,
                                "There are no points of a wall yield locus.");
    }
    for (size_t i = 0; i < count; i++) {
        if (!check_point(&points[i], i, status)) {
            return false;
        }
    }
    point *sorted = clod_memory_alloc(count, sizeof *sorted);
    double *work = clod_memory_alloc(2 * count, sizeof *work);
    locus->marks = clod_memory_alloc(count, sizeof *locus->marks);
    bool good = sorted != NULL && work != NULL && locus->marks != NULL;
    if (good) {
        memcpy(sorted, points, count * sizeof *sorted);
        qsort(sorted, count, sizeof *sorted, in_order);
        good = evaluate(sorted, count, work, locus, status);
    } else {
        clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
    }
    if (!good) {
        clod_wall_locus_fini(locus);
    }
    clod_memory_free(sorted);
    clod_memory_free(work);
    return good;
}

bool clod_wall_locus_of_table(const clod_wall_locus_point *points, size_t count,
                              clod_wall_locus *locus, clod_status *status)
{
    if (!CLOD_GIVEN(locus, status) || (count > 0 && !CLOD_GIVEN(points, status))) {
        return false;
    }
    if (!clod_wall_locus_evaluate(points, count, locus, status)) {
        return false;
    }
    const double angle = locus->phi_w.value;
    if (angle >= 0.0 || is_simulated(locus)) {
        return true;
    }
    clod_wall_locus_fini(locus);
    return clod_status_fail(
        status, CLOD_USAGE,
        "the wall yield locus falls: its line has phi_w = %.1f deg. No wall bears less shear "
        "stress under more load. Look at the points: their columns, their units, whether shear "
        "was steady.",
        angle / M_PI * 180.0);
}
