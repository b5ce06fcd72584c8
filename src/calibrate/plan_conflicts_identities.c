/**
 * @file plan_conflicts_identities.c
 * Targets of one shear test of which one follows from the others: docs/theory/yield-locus.md, equations 2 to 7.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/angles.h"
#include "analysis/mohr.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"

#define INPUTS 3

/** A number from others, SI, with the preshear stress of the case, or of tau with its normal stress. */
typedef double (*formula)(const double *from, double stress);

/** @param from  c, phi_lin */
static double strength_of(const double *from, double stress)
{
    (void)stress;
    return clod_mohr_unconfined(from[0], tan(from[1]));
}

/** @param from  sigma_1, phi_e */
static double minor_of(const double *from, double stress)
{
    (void)stress;
    const double s = sin(from[1]);
    return from[0] * (1.0 - s) / (1.0 + s);
}

/** The circle of steady flow goes through preshear.   @param from  sigma_1, sigma_2 */
static double shear_of(const double *from, double stress)
{
    return sqrt(fmax((from[0] - stress) * (stress - from[1]), 0.0));
}

/** @param from  sigma_1, phi_e */
static double shear_by_angle(const double *from, double stress)
{
    const double ends[] = {from[0], minor_of(from, stress)};
    return shear_of(ends, stress);
}

static double slope_of(const double *from, double stress)
{
    return atan2(shear_of(from, stress), stress);
}

static double slope_by_angle(const double *from, double stress)
{
    return atan2(shear_by_angle(from, stress), stress);
}

/** @param from  c, phi_lin, tau_p */
static double major_of(const double *from, double stress)
{
    const clod_mohr steady = clod_mohr_steady(from[0], tan(from[1]), stress, from[2]);
    return steady.centre + steady.radius;
}

/** NAN: steady flow reaches into tension. */
static double effective_of(const double *from, double stress)
{
    const clod_mohr steady = clod_mohr_steady(from[0], tan(from[1]), stress, from[2]);
    return steady.radius < steady.centre ? asin(steady.radius / steady.centre) : (double)NAN;
}

/** @param from  c, phi_lin, phi_sf */
static double major_by_slope(const double *from, double stress)
{
    const double at[] = {from[0], from[1], stress * tan(from[2])};
    return major_of(at, stress);
}

static double effective_by_slope(const double *from, double stress)
{
    const double at[] = {from[0], from[1], stress * tan(from[2])};
    return effective_of(at, stress);
}

/** @param from  ffc, c, phi_lin */
static double major_of_ratio(const double *from, double stress)
{
    return from[0] * strength_of(from + 1, stress);
}

/** @param from  c, phi_lin */
static double line_at(const double *from, double stress)
{
    return from[0] + stress * tan(from[1]);
}

/** A target that follows from others. */
typedef struct identity {
    const char *number;
    const char *from[INPUTS]; ///< fewer: NULL behind them
    formula of;
    const char *text;
} identity;

#define CIRCLE "(sigma_1 - sp)(sp - sigma_2) = tau_p^2, sp the preshear stress"
#define EFFECTIVE "sin(phi_e) = (sigma_1 - sigma_2)/(sigma_1 + sigma_2)"
#define TOUCHING "its circle through preshear"

static const identity IDENTITIES[] = {
    {"sigma_c", {"c", "phi_lin"}, strength_of, "sigma_c = 2 c cos(phi_lin)/(1 - sin(phi_lin))"},
    {"tau", {"c", "phi_lin"}, line_at, "tau = c + sigma tan(phi_lin)"},
    {"sigma_1",
     {"ffc", "c", "phi_lin"},
     major_of_ratio,
     "sigma_1 = ffc 2 c cos(phi_lin)/(1 - sin(phi_lin))"},
    {"sigma_2", {"sigma_1", "phi_e"}, minor_of, EFFECTIVE},
    {"tau_p", {"sigma_1", "sigma_2"}, shear_of, CIRCLE},
    {"phi_sf", {"sigma_1", "sigma_2"}, slope_of, CIRCLE},
    {"tau_p", {"sigma_1", "phi_e"}, shear_by_angle, CIRCLE "; " EFFECTIVE},
    {"phi_sf", {"sigma_1", "phi_e"}, slope_by_angle, CIRCLE "; " EFFECTIVE},
    {"sigma_1", {"c", "phi_lin", "tau_p"}, major_of, TOUCHING},
    {"sigma_1", {"c", "phi_lin", "phi_sf"}, major_by_slope, TOUCHING},
    {"phi_e", {"c", "phi_lin", "tau_p"}, effective_of, TOUCHING},
    {"phi_e", {"c", "phi_lin", "phi_sf"}, effective_by_slope, TOUCHING},
};

/** Targets that a number follows from; how many, 0: the plan lacks one. */
static size_t find_inputs(const clod_plan *self, size_t test, const identity *of,
                          const clod_plan_target **inputs)
{
    size_t count = 0;
    while (count < INPUTS && of->from[count] != NULL) {
        inputs[count] = clod_plan_conflicts_target(self, test, of->from[count]);
        if (inputs[count++] == NULL) {
            return 0;
        }
    }
    return count;
}

/** What follows from targets, with the standard error that theirs make of it, by differences. Angles do not leave 1 to
 *  80 deg: beyond, strengths grow without bound. */
static clod_locus_value follow(const clod_plan_target *const *inputs, size_t count, formula of,
                               double stress)
{
    double at[INPUTS] = {0.0};
    for (size_t k = 0; k < count; k++) {
        at[k] = inputs[k]->value;
    }
    clod_locus_value made = {.value = of(at, stress)};
    for (size_t k = 0; k < count; k++) {
        const double value = inputs[k]->value, error = clod_plan_conflicts_error(inputs[k]);
        double least = value - error, most = value + error;
        if (strncmp(inputs[k]->number, "phi_", 4) == 0) {
            least = fmax(least, CLOD_ANGLES_LEAST * CLOD_NUMBER_DEGREE);
            most = fmin(most, fmax(CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE, value));
        }
        at[k] = most;
        const double above = of(at, stress);
        at[k] = least;
        made.error = hypot(made.error, error * (above - of(at, stress)) / (most - least));
        at[k] = value;
    }
    return made;
}

/** "c 0.2 kPa in targets.0 and phi_lin 40 deg in targets.1" */
static const char *list_inputs(const clod_plan_target *const *inputs, size_t count, char *text,
                               size_t size)
{
    size_t used = 0;
    for (size_t k = 0; k < count && used < size; k++) {
        const clod_plan_target *one = inputs[k];
        const char *before = k == 0 ? "" : k + 1 == count ? " and " : ", ";
        used += (size_t)snprintf(text + used, size - used, "%s%s %.4g%s%s in targets.%zu",
                                 before, one->number, one->measure.factor * one->value,
                                 one->measure.unit[0] != '\0' ? " " : "", one->measure.unit,
                                 one->entry);
    }
    return text;
}

/** A target beside what follows from others. */
typedef struct conflict {
    const clod_plan_target *one, *inputs[INPUTS];
    const identity *of;
    size_t count;
    clod_locus_value made;
    double apart; ///< standard errors
} conflict;

/** Whether a target is not what follows from others. */
static bool find_conflict(const clod_plan *self, const clod_plan_target *one,
                          const identity *of, conflict *to)
{
    *to = (conflict){.one = one, .of = of};
    to->count = find_inputs(self, one->test, of, to->inputs);
    if (to->count == 0) {
        return false;
    }
    const double preshear = clod_case_shear(self->tests[one->test].middle)->preshear_stress;
    to->made = follow(to->inputs, to->count, of->of,
                      one->normal_stress > 0.0 ? one->normal_stress : preshear);
    to->apart = fabs(one->value - to->made.value) /
                hypot(clod_plan_conflicts_error(one), to->made.error);
    return to->apart > CLOD_PLAN_FIRM_ERRORS; // NAN: it is not defined within the errors
}

static bool is_held_back(const conflict *self)
{
    bool held = self->one->held_back;
    for (size_t k = 0; k < self->count; k++) {
        held = held || self->inputs[k]->held_back;
    }
    return held;
}

/** Whether it follows from c and phi_lin, which belong to one line, and a curved locus has many. */
static bool is_of_line(const conflict *self)
{
    bool line = false;
    for (size_t k = 0; k < self->count; k++) {
        line = line || strcmp(self->inputs[k]->number, "phi_lin") == 0;
    }
    return line;
}

/** "sigma_c 1 kPa in targets.2 does not go with c 1 kPa in targets.0 and ..." */
static const char *describe(const conflict *self, char *text, size_t size)
{
    char list[240];
    const clod_plan_target *one = self->one;
    const clod_plan_measure *unit = &one->measure;
    snprintf(
        text, size,
        "%s %.4g %s in targets.%zu does not go with %s: with these a straight yield locus has %.4g %s (%s), %.1f "
        "standard errors away",
        one->number, unit->factor * one->value, unit->unit, one->entry,
        list_inputs(self->inputs, self->count, list, sizeof list),
        unit->factor * self->made.value, unit->unit, self->of->text, self->apart);
    return text;
}

static void refuse(clod_loader *loader, const clod_plan *self, const conflict *of)
{
    char text[600];
    clod_check_fail(
        loader, "targets", "test %s: %s; %s", self->tests[of->one->test].name,
        describe(of, text, sizeof text),
        is_of_line(of)
            ? "c or phi_lin of a curved locus? Then leave it out, hold it back, or state a discrepancy; else correct "
              "one of them"
            : "correct or leave out one of them");
}

static void warn(clod_plan *self, const conflict *of)
{
    char text[600];
    clod_warning_list_add(
        &self->warnings,
        "test %s: %s. No parameters give all of them, so what is held back will likely be missed%s.",
        self->tests[of->one->test].name, describe(of, text, sizeof text),
        is_of_line(of) ? " (c or phi_lin of a curved locus?)" : "");
}

/** A number that was given, not that of a table, whose line has been looked at (clod locus). */
static bool is_given(const clod_plan *self, const clod_plan_target *one, size_t test)
{
    return one->test == test && self->wishes[one->entry].locus == NULL;
}

void clod_plan_conflicts_identities(clod_loader *loader, clod_plan *self, size_t test)
{
    conflict held = {0}, found;
    for (size_t i = 0; i < sizeof IDENTITIES / sizeof IDENTITIES[0]; i++) {
        for (size_t k = 0; k < self->target_count; k++) {
            const clod_plan_target *one = &self->targets[k];
            if (!is_given(self, one, test) || strcmp(one->number, IDENTITIES[i].number) != 0 ||
                !find_conflict(self, one, &IDENTITIES[i], &found)) {
                continue;
            }
            if (!is_held_back(&found)) {
                refuse(loader, self, &found);
                return; // others would say it again
            }
            held = held.one == NULL ? found : held;
        }
    }
    if (held.one != NULL) {
        warn(self, &held);
    }
}
