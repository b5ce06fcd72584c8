/**
 * @file doubts_curve.c
 * Whether the line of the flow function fits what was measured, and what rests on it.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hopper/doubts.h"
#include "hopper/fields.h"
#include "hopper/interval.h"
#include "hopper/line_fit.h"
#include "hopper/words.h"

#define CLOSE 1e-6 // of a stress

/** The first point without an error of f_c, where others have one. */
static void warn_unweighted(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.strength;
    const clod_curve_point *without = NULL;
    bool some = false;
    for (size_t i = 0; i < curve->count; i++) {
        const bool has = clod_curve_stated(&curve->points[i]) > 0.0;
        some = some || has;
        without = !has && without == NULL ? &curve->points[i] : without;
    }
    if (some && without != NULL && curve->misfit.stretch > 0.0) {
        clod_warning_list_add(
            &self->warnings,
            "Flow function: f_c at sigma_1 %.6g kPa has no error, others have one. So all points weigh alike in "
            "its line, and it is not known whether the line fits them. Give all of them, or none.",
            1e-3 * without->x);
    }
}

/** "133.0 mm": the outlet of a shape from a solid. */
static void put_outlet(const clod_hopper *self, int shape, const clod_solid *solid,
                       char text[48])
{
    clod_hopper_outcome outcome;
    double number[CLOD_HOPPER_NUMBERS];
    clod_interval_numbers(solid, &self->shape[shape], &outcome, number);
    const double outlet = number[CLOD_HOPPER_OUTLET];
    if (outlet == 0.0 || !isfinite(outlet)) {
        snprintf(text, 48, "%s",
                 outlet == 0.0   ? "0 (no arch)"
                 : isinf(outlet) ? "infinite"
                                 : "not known");
    } else {
        snprintf(text, 48, "%.1f mm", 1e3 * outlet);
    }
}

/** What the curve from point to point says; nothing where two points have nearly one stress. */
static void put_other(const clod_hopper *self, char text[256])
{
    const clod_curve *curve = &self->solid.strength;
    clod_solid other = self->solid;
    char cone[48], wedge[48];
    text[0] = '\0';
    for (size_t i = 1; i < curve->count; i++) {
        if (!clod_doubts_are_apart(&curve->points[i - 1], &curve->points[i])) {
            return;
        }
    }
    other.strength.way = CLOD_CURVE_EXTENDED;
    put_outlet(self, CLOD_RADIAL_CONE, &other, cone);
    put_outlet(self, CLOD_RADIAL_WEDGE, &other, wedge);
    snprintf(
        text, 256,
        " With flow_function.curve: points the critical outlet is %s (cone) and %s (wedge).",
        cone, wedge);
}

/** The point that the line of a misfit misses by most of its errors. */
static const clod_curve_point *worst_of(const clod_curve *curve, double *most)
{
    const clod_curve_line *line = &curve->misfit.line;
    const clod_curve_point *worst = &curve->points[0];
    *most = 0.0;
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        const double off = fabs(point->y - line->a - line->b * point->x) /
                           clod_line_fit_error(curve, point, line->b);
        worst = off > *most ? point : worst;
        *most = fmax(off, *most);
    }
    return worst;
}

/** The chance of a misfit, for print. */
static const char *chance_of(const clod_curve_misfit *misfit, char text[32])
{
    if (misfit->chance < 0.001) {
        return "below 0.001";
    }
    snprintf(text, 32, "%.3f", misfit->chance);
    return text;
}

static void warn_misfit(clod_hopper *self)
{
    const clod_curve *curve = &self->solid.strength;
    const clod_curve_misfit *misfit = &curve->misfit;
    if (!clod_line_fit_misses(misfit)) {
        return;
    }
    char other[256], chance[32];
    double most;
    const clod_curve_point *worst = worst_of(curve, &most);
    put_other(self, other);
    clod_warning_list_add(
        &self->warnings,
        "Flow function: the line misses its points by more than their errors tell, most at sigma_1 %.6g kPa, "
        "by %.1f of them: chi-square %.1f, degrees of freedom %zu, p %s. Either it is curved, or errors are larger "
        "than stated. Errors of the line are taken as %.1f times as large%s.%s",
        1e-3 * worst->x, most, misfit->chi_square, misfit->freedom, chance_of(misfit, chance),
        misfit->stretch,
        misfit->specimens == 0 ? ", and drawn from Student's t of these degrees" : "", other);
}

/** Errors that are stated for a wall, and smaller than its points scatter by: of a curved wall, or of a reading alone. */
static void warn_wall(clod_hopper *self)
{
    clod_curve line = self->solid.wall; // whose points have no weight in it
    line.way = CLOD_CURVE_LINE;
    clod_line_fit_weigh(&line);
    const clod_curve_misfit *misfit = &line.misfit;
    if (misfit->specimens > 0 || !clod_line_fit_misses(misfit)) {
        return;
    }
    char chance[32];
    double most;
    const clod_curve_point *worst = worst_of(&line, &most);
    clod_warning_list_add(
        &self->warnings,
        "Wall yield locus: its points lie further off a line than their errors tell, most at sigma_w %.6g kPa, by %.1f of "
        "them: chi-square %.1f, degrees of freedom %zu, p %s. Either the wall is curved, or the errors are too small, those "
        "of a reading for instance. Intervals take them as stated. If it is not curved, leave tau_w_error out: then the "
        "scatter of the points is their error.",
        1e-3 * worst->x, most, misfit->chi_square, misfit->freedom, chance_of(misfit, chance));
}

void clod_doubts_line(clod_hopper *self)
{
    warn_unweighted(self);
    warn_misfit(self);
    warn_wall(self);
}

/** Stress at which the strength has fallen to 0, below the smallest measured one; NAN: it has not. */
static double no_strength_at(const clod_curve *curve)
{
    double low = 0.0, high = curve->points[0].x;
    if (curve->count < 2 || clod_curve_at(curve, low) > 0.0 ||
        clod_curve_at(curve, high) <= 0.0) {
        return (double)NAN;
    }
    while (high - low > CLOSE * curve->points[0].x) {
        const double middle = 0.5 * (low + high);
        if (clod_curve_at(curve, middle) > 0.0) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return high;
}

void clod_doubts_no_arch(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const double share = clod_words_arched(found);
    if (found->design.outcome != CLOD_HOPPER_NO_ARCH) {
        return;
    }
    if (share > CLOD_WORDS_SOME) {
        char outlets[96] = "";
        if (!isnan(found->arched_low)) {
            snprintf(outlets, sizeof outlets,
                     "; the critical outlet of those is %.1f to %.1f mm",
                     1e3 * found->arched_low, 1e3 * found->arched_high);
        }
        clod_warning_list_add(
            &self->warnings,
            "%s: no arch is what the means say, but %.1f %% of the samples have one%s. Within "
            "the errors it is not known that there is none.",
            name, 100.0 * share, outlets);
    }
    const clod_curve *curve = &self->solid.strength;
    const double stress = no_strength_at(curve);
    if (!isnan(stress)) {
        clod_warning_list_add(
            &self->warnings,
            "%s: no arch rests on an extrapolation: f_c falls to 0 at sigma_1 %.3f kPa, below the smallest that "
            "was measured, %.3f kPa, where f_c is %.3f kPa. Measure at smaller stresses.",
            name, 1e-3 * stress, 1e-3 * curve->points[0].x,
            1e-3 * clod_curve_at(curve, curve->points[0].x));
    }
}
