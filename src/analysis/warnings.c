#include "analysis/warnings.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "analysis/mohr.h"
#include "analysis/warnings_points.h"

#define KILO 1000.0
#define DEGREES (180.0 / 3.14159265358979323846)
#define RANGE_LOW 0.2 // of sigma_p, docs/theory/yield-locus.md
#define RANGE_HIGH 0.8
#define RANGE_SLACK CLOD_WARNINGS_SAME_STRESS
#define TOUCH_SLACK 0.1 // of sigma_p: 80 % often lies a little beyond, and does no harm
#define STORED 0.1      // of tau_p: peaks that are so much higher are no scatter
#define MORE " ..."
#define SAG_SLACK 0.02  // of the mean shear stress: less does not matter
#define FALL_SLACK 0.02 // the same for a fall, where points state no errors
/// Standard errors of the difference of two points that are no chance; c < 0 is judged alike.
#define FALL_ERRORS 2.0
/// deg; 35 +- 3 deg turned about points around sigma_p/2 moves c by 0.04 sigma_p, a fifth of
/// the cohesion of a cohesive solid (ffc 3), and sigma_c as much.
#define PHI_ERROR_MOST 3.0
/// Below it more than a fifth, sqrt(1 - r2), of what the shear stresses differ is not the line.
#define R2_LEAST 0.95

void clod_warnings_add(clod_locus *locus, const char *format, ...)
{
    if (locus->warning_count == CLOD_LOCUS_WARNINGS) {
        snprintf(locus->warnings[CLOD_LOCUS_WARNINGS - 1], CLOD_LOCUS_WARNING_TEXT,
                 "There are more warnings than these.");
        return;
    }
    va_list args;
    va_start(args, format);
    vsnprintf(locus->warnings[locus->warning_count], CLOD_LOCUS_WARNING_TEXT, format, args);
    va_end(args);
    locus->warning_count++;
}

/** Normal stresses that are complained about, as a text "2.000, 3.000 kPa". */
typedef struct stress_list {
    size_t count;
    char text[96];
} stress_list;

static void list_add(stress_list *self, double stress)
{
    const size_t used = strlen(self->text);
    if (used + 24 < sizeof self->text) {
        snprintf(self->text + used, sizeof self->text - used - sizeof MORE, "%s%.3f",
                 used > 0 ? ", " : "", stress / KILO);
    } else if (self->text[used - 1] != '.') {
        memcpy(self->text + used, MORE, sizeof MORE);
    }
    self->count++;
}

bool clod_warnings_is_usual(double phi_lin)
{
    return phi_lin * DEGREES >= CLOD_WARNINGS_PHI_LOW &&
           phi_lin * DEGREES <= CLOD_WARNINGS_PHI_HIGH;
}

static void check_line(clod_locus *locus, size_t count)
{
    if (count < 3) {
        clod_warnings_add(locus,
                          "Only %zu points: any two points lie on a line; measure at "
                          "least three.",
                          count);
    }
    const double phi = locus->phi_lin.value * DEGREES;
    if (phi < 0.0) {
        clod_warnings_add(
            locus,
            "The line falls (phi_lin = %.2f deg), so sigma_c and ffc are undefined: peak shear "
            "stress must rise with normal stress; check the columns and units.",
            phi);
    } else if (!clod_warnings_is_usual(locus->phi_lin.value)) {
        clod_warnings_add(
            locus,
            "phi_lin = %.2f deg is outside %.0f to %.0f deg; check the columns and "
            "units.",
            phi, CLOD_WARNINGS_PHI_LOW, CLOD_WARNINGS_PHI_HIGH);
    }
}

/** Whether what the points scatter about their line makes most of the error [deg] of its angle. */
static bool scatter(const clod_warnings_line *line, double error)
{
    const double slope = line->fit.slope;
    return line->count > 2 && clod_fit_slope_error(&line->fit, line->count) * DEGREES >
                                  sqrt(0.5) * error * (1.0 + slope * slope);
}

/** Points off the line, or on it with errors that leave its angle open. */
static void check_error(clod_locus *locus, const clod_locus_point *points,
                        const clod_warnings_line *line)
{
    const double error = locus->phi_lin.error * DEGREES; // NAN: too large to be told
    const bool off = locus->r_squared < R2_LEAST;
    const bool wide = locus->errors != CLOD_LOCUS_ERRORS_NONE && !(error <= PHI_ERROR_MOST);
    if (off || (wide && !clod_warnings_points_unmeasured(points, line->count))) {
        char bar[32] = "";
        if (isfinite(error)) {
            snprintf(bar, sizeof bar, " +- %.1f", error);
        } else if (wide) {
            snprintf(bar, sizeof bar, " +- more than 90");
        }
        clod_warnings_add(
            locus,
            "phi_lin = %.1f%s deg, r2 = %.3f: %s (at most "
            "+- %.0f deg, r2 at least %.2f); c, sigma_c and ffc are of little use. "
            "Add points or repeats.",
            locus->phi_lin.value * DEGREES, bar, locus->r_squared,
            off || scatter(line, error) ? "the points do not lie on a line"
                                        : "the errors stated leave the angle open",
            PHI_ERROR_MOST, R2_LEAST);
    }
}

void clod_warnings_check_seeds(clod_locus *locus)
{
    const double error = locus->phi_lin.error * DEGREES;
    if (error > PHI_ERROR_MOST) {
        clod_warnings_add(
            locus,
            "phi_lin = %.1f +- %.1f deg over %zu seeds: their lines differ too much "
            "(at most +- %.0f deg is good) for c, sigma_c and ffc. Add seeds.",
            locus->phi_lin.value * DEGREES, error, locus->seed_count, PHI_ERROR_MOST);
    }
}

/** How far the shear stress falls from one point to another beyond what errors may do. */
static double excess_fall(const clod_warnings_line *line, const clod_locus_point *points,
                          double slack, size_t low, size_t high)
{
    const double apart = line->x[high] - line->x[low];
    if (!(apart > RANGE_SLACK * points[low].sigma_p)) {
        return 0.0; // the same normal stress
    }
    const double errors = hypot(points[low].tau_s_error, points[high].tau_s_error);
    return line->y[low] - line->y[high] - fmax(FALL_ERRORS * errors, slack);
}

/** A locus rises: of the points that fall, the pair that falls most. */
static void check_fall(clod_locus *locus, const clod_locus_point *points,
                       const clod_warnings_line *line)
{
    const double middle = line->fit.intercept + line->fit.slope * line->fit.mean_x;
    double worst = 0.0;
    size_t at = 0;
    size_t to = 0;
    for (size_t i = 0; i < line->count; i++) {
        for (size_t k = 0; k < line->count; k++) {
            const double fall = excess_fall(line, points, FALL_SLACK * middle, i, k);
            if (fall > worst) {
                worst = fall;
                at = i;
                to = k;
            }
        }
    }
    if (worst > 0.0 && line->fit.slope >= 0.0) { // else the whole line falls
        clod_warnings_add(
            locus,
            "The shear stress falls from %.3f to %.3f kPa while the normal stress "
            "rises from %.3f to %.3f kPa: at least one of them is wrong. See "
            "whether its preshear was steady and its peak was reached.",
            line->y[at] / KILO, line->y[to] / KILO, line->x[at] / KILO, line->x[to] / KILO);
    }
}

static void check_cohesion(clod_locus *locus)
{
    const double c = locus->c.value;
    if (c < 0.0) {
        const bool near_zero = c + 2.0 * locus->c.error >= 0.0;
        const char *why =
            !near_zero && locus->tau_p.value > locus->sigma_p.value
                ? " The shear stress of preshear is above its normal stress too: have the columns "
                  "sigma and tau been exchanged, of preshear and of the points?"
            : !near_zero ? " Points at low normal stress bend down, or are wrong."
            : clod_warnings_is_usual(locus->phi_lin.value)
                ? " It is zero within two standard errors: the solid flows freely."
                : ""; // the angle has a warning of its own
        clod_warnings_add(locus,
                          "Cohesion is negative (%.3f kPa): sigma_c and ffc are undefined.%s",
                          c / KILO, why);
    }
}

static void check_circles(clod_locus *locus)
{
    const double t = tan(locus->phi_lin.value);
    const double at = locus->c.value + t * locus->sigma_p.value;
    const double least = clod_mohr_share_least(t);
    if (locus->parallel) {
        clod_warnings_add(locus,
                          "The preshear point (%.3f, %.3f) kPa lies above the line (%.3f kPa "
                          "there): sigma_1 is from the parallel line through it.",
                          locus->sigma_p.value / KILO, locus->tau_p.value / KILO, at / KILO);
    } else if (clod_mohr_share(locus->c.value, t, locus->sigma_p.value, locus->tau_p.value) <
               least) {
        clod_warnings_add(
            locus,
            "The preshear point (%.3f, %.3f) kPa lies far below the line (%.3f kPa there; "
            "steady flow has %.2f of it or more): sigma_1 and ffc do not hold. Did preshear "
            "end before steady flow, or has sigma_pre or tau_pre another unit or column?",
            locus->sigma_p.value / KILO, locus->tau_p.value / KILO, at / KILO, least);
    }
    if (isnan(locus->phi_e.value)) {
        const double touch = clod_mohr_touch(locus->steady.centre, locus->steady.radius, t);
        clod_warnings_add(locus, "sigma_2 = %.3f kPa is tension: phi_e is undefined.%s",
                          locus->sigma_2.value / KILO,
                          touch < 0.0 ? " The circle of steady flow touches the line in "
                                        "tension too: sigma_1 and ffc do not hold."
                                      : "");
    }
}

/** A specimen bears no more below the preshear stress than preshear did, unless it gained strength in between. */
static void check_stored(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    stress_list beyond = {0};
    for (size_t i = 0; i < count; i++) {
        const clod_locus_point *p = &points[i];
        const double errors = FALL_ERRORS * hypot(p->tau_s_error, p->tau_p_error);
        if (p->sigma_s < p->sigma_p && p->tau_s - p->tau_p > fmax(errors, STORED * p->tau_p)) {
            list_add(&beyond, p->sigma_s);
        }
    }
    if (beyond.count > 0) {
        clod_warnings_add(
            locus,
            "Shear at %s kPa has a higher peak than preshear. After storage? Then sigma_c and "
            "phi_lin hold, but sigma_1 and phi_e are those of the locus without it "
            "(docs/howto/hopper.md).",
            beyond.text);
    }
}

static void check_preshear(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    double low = INFINITY;
    double high = 0.0;
    for (size_t i = 0; i < count; i++) {
        low = fmin(low, points[i].sigma_p);
        high = fmax(high, points[i].sigma_p);
    }
    if (high > (1.0 + CLOD_WARNINGS_SAME_PRESHEAR) * low) {
        clod_warnings_add(
            locus,
            "Preshear stresses from %.3f to %.3f kPa are more than %.0f %% apart: "
            "the points do not belong to one consolidation.",
            low / KILO, high / KILO, 100.0 * CLOD_WARNINGS_SAME_PRESHEAR);
    }
}

static void check_range(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    stress_list over = {0};
    stress_list outside = {0};
    for (size_t i = 0; i < count; i++) {
        const double ratio = points[i].sigma_s / points[i].sigma_p;
        if (ratio > 1.0) {
            list_add(&over, points[i].sigma_s);
        } else if (ratio < RANGE_LOW - RANGE_SLACK || ratio > RANGE_HIGH + RANGE_SLACK) {
            list_add(&outside, points[i].sigma_s);
        }
    }
    if (over.count > 0) {
        clod_warnings_add(
            locus,
            "Shear at %s kPa is above the preshear stress: it consolidates anew and "
            "does not belong to this locus.",
            over.text);
    }
    if (outside.count > 0) {
        clod_warnings_add(locus,
                          "Shear at %s kPa is outside %.0f to %.0f %% of the preshear "
                          "stress.",
                          outside.text, 100.0 * RANGE_LOW, 100.0 * RANGE_HIGH);
    }
}

/**
 * No point between the circles, and no normal stress to send one to: advice to shear at a
 * higher or a lower one would lead nowhere.
 */
static bool no_window(clod_locus *locus, const stress_list *below, const stress_list *above,
                      size_t count, double left, double right)
{
    const bool closed = left >= right || left >= locus->sigma_p.value;
    const bool astride =
        below->count > 0 && above->count > 0 && below->count + above->count == count;
    const bool outside = below->count == 0 || below->count == count;
    if (closed || astride) {
        clod_warnings_add(
            locus,
            "No point of this line lies between the circles (the unconfined one "
            "touches it at %.3f kPa, the steady-state one at %.3f kPa, preshear is "
            "at %.3f kPa): sigma_c is %s.",
            left / KILO, right / KILO, locus->sigma_p.value / KILO,
            outside ? "an extrapolation" : "a rough estimate");
    }
    return closed || astride;
}

/** Points belong between the places where the two Mohr circles touch the locus. */
static void check_touch(clod_locus *locus, const clod_locus_point *points, size_t count)
{
    const double t = tan(locus->phi_lin.value);
    const double left = // a comparison with NAN is false: no circle, no complaint
        clod_mohr_touch(locus->unconfined.centre, locus->unconfined.radius, t);
    const double right = clod_mohr_touch(locus->steady.centre, locus->steady.radius, t);
    stress_list below = {0};
    stress_list above = {0};
    for (size_t i = 0; i < count; i++) {
        if (points[i].sigma_s < left) {
            list_add(&below, points[i].sigma_s);
        } else if (points[i].sigma_s > right + TOUCH_SLACK * points[i].sigma_p) {
            list_add(&above, points[i].sigma_s);
        }
    }
    if (no_window(locus, &below, &above, count, left, right)) {
        return;
    }
    if (below.count > 0) {
        clod_warnings_add(locus,
                          "Shear at %s kPa is left of where the unconfined circle touches the "
                          "line (%.3f kPa); shear at higher normal stress.",
                          below.text, left / KILO);
    }
    if (above.count > 0) {
        clod_warnings_add(
            locus,
            "Shear at %s kPa is far right of where the steady-state circle touches the "
            "line (%.3f kPa); shear at lower normal stress.",
            above.text, right / KILO);
    }
}

static void check_bend(clod_locus *locus, const clod_warnings_line *line)
{
    double error;
    const double sag = clod_fit_sag(&line->fit, line->x, line->y, line->count, &error);
    const double middle = line->fit.intercept + line->fit.slope * line->fit.mean_x;
    if (fabs(sag) > error && fabs(sag) > SAG_SLACK * fabs(middle)) {
        clod_warnings_add(locus,
                          "The points bend: ends lie %.3f kPa %s the line against the middle; "
                          "cohesion and sigma_c of a straight line are too %s.",
                          fabs(sag) / KILO, sag > 0.0 ? "below" : "above",
                          sag > 0.0 ? "high" : "low");
    }
}

void clod_warnings_check(clod_locus *locus, const clod_locus_point *points, size_t count,
                         const clod_warnings_line *line)
{
    check_line(locus, count);
    check_error(locus, points, line);
    clod_warnings_points_check(locus, points, count);
    check_fall(locus, points, line);
    check_preshear(locus, points, count);
    check_stored(locus, points, count);
    check_range(locus, points, count);
    check_cohesion(locus);
    check_circles(locus);
    check_touch(locus, points, count);
    check_bend(locus, line);
}

void clod_warnings_strength_falls(const clod_warnings_strength *points, size_t count,
                                  char text[CLOD_LOCUS_WARNING_TEXT])
{
    const clod_warnings_strength *from = NULL;
    const clod_warnings_strength *to = NULL;
    double worst = 0.0;
    for (size_t i = 0; i < count; i++) {
        for (size_t k = 0; k < count; k++) {
            const double fall = points[i].strength - points[k].strength; // NAN is no fall
            if (points[k].stress > points[i].stress && fall > worst &&
                fall > FALL_SLACK * points[i].strength) {
                worst = fall;
                from = &points[i];
                to = &points[k];
            }
        }
    }
    text[0] = '\0';
    if (from != NULL) {
        const double errors = hypot(from->error, to->error);
        const char *chance = isnan(errors) ? ""
                             : worst > FALL_ERRORS * errors
                                 ? ", more than twice the standard errors explain"
                                 : ", which is within twice the standard errors";
        snprintf(
            text, CLOD_LOCUS_WARNING_TEXT,
            "sigma_c falls from %.3f to %.3f kPa while the consolidation stress rises from "
            "%.3f to %.3f kPa%s: a solid gains strength with consolidation. See the "
            "warnings of both, and repeat them with other specimens.",
            from->strength / KILO, to->strength / KILO, from->stress / KILO, to->stress / KILO,
            chance);
    }
}
