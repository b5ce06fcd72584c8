#include "calibrate/plan_samples.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/mean.h"
#include "base/memory.h"

#define FEW 3         ///< specimens
#define ROUNDING 1e-9 ///< of a mean: a smaller scatter is that of one and the same number

typedef clod_plan_maker maker;
typedef clod_plan_sample sample;

bool clod_plan_samples_init(clod_plan_samples *self, maker *make, size_t room)
{
    *self = (clod_plan_samples){.items = clod_memory_alloc(room, sizeof *self->items),
                                .scratch = clod_memory_alloc(room, sizeof *self->scratch)};
    const bool good = self->items != NULL && self->scratch != NULL;
    make->loader->report->lost = make->loader->report->lost || !good;
    return good;
}

void clod_plan_samples_fini(clod_plan_samples *self)
{
    clod_memory_free(self->items);
    clod_memory_free(self->scratch);
}

bool clod_plan_samples_same(double stress, double other)
{
    return fabs(stress / other - 1.0) < CLOD_NUMBER_SAME_STRESS;
}

bool clod_plan_samples_common(maker *self, size_t test, const clod_number *kind,
                              clod_plan_target *to)
{
    *to = (clod_plan_target){
        .test = test, .held_back = self->wish->held_back, .measure = kind->measure};
    return clod_plan_targets_deviation(self, "error", self->wish->error, kind, false,
                                       &to->error) &&
           clod_plan_targets_deviation(self, "discrepancy", self->wish->discrepancy, kind,
                                       false, &to->discrepancy);
}

// ---- repeats

/** Move the points at the stress of the first to its side, all in their order; how many there are. */
static size_t gather(sample *points, size_t count)
{
    size_t same = 1;
    for (size_t k = 1; k < count; k++) {
        const sample one = points[k];
        if (clod_plan_samples_same(one.stress, points[0].stress)) {
            memmove(&points[same + 1], &points[same], (k - same) * sizeof *points);
            points[same++] = one;
        }
    }
    return same;
}

/** What the mean of points at one stress has in common with other stresses: points of one seed all the same, others
 *  each their own. */
static clod_plan_common common_of(const sample *points, size_t count)
{
    double squares = 0.0, degrees = 0.0;
    for (size_t k = 0; k < count; k++) {
        bool first = true;
        for (size_t m = 0; m < count; m++) {
            if (points[m].specimen == points[k].specimen) {
                squares += points[k].common.error * points[m].common.error;
                first = first && m >= k;
            }
        }
        degrees += first ? points[k].common.degrees : 0.0;
    }
    return (clod_plan_common){sqrt(squares) / (double)count, degrees};
}

/** That of points at one stress, with its stated error; 0: a point has none.
 *  @param scatter  [out] standard error of the mean by how they scatter; 0: there is one only */
static sample mean_of(const sample *points, size_t count, double slope, double *values,
                      double *scatter)
{
    sample mean = {0};
    double stated = 0.0;
    for (size_t k = 0; k < count; k++) {
        mean.stress += points[k].stress / (double)count;
        stated += points[k].error * points[k].error;
        mean.lacking += points[k].error > 0.0 ? 0 : 1;
    }
    for (size_t k = 0; k < count; k++) {
        values[k] = points[k].value + slope * (mean.stress - points[k].stress);
    }
    mean.value = clod_mean_of(values, count, stated).value;
    const bool known = mean.lacking == 0;
    mean.error = known ? sqrt(stated) / (double)count : 0.0;
    mean.common = known ? common_of(points, count) : (clod_plan_common){0};
    mean.repeats.count = count;
    for (size_t k = 0; k < mean.repeats.count && k < CLOD_PLAN_SPECIMENS; k++) {
        mean.repeats.differences[k] =
            (clod_plan_difference){points[k].specimen, values[k] - mean.value};
    }
    *scatter = count > 1 ? clod_mean_of(values, count, 0.0).error : 0.0;
    return mean;
}

static bool is_twice_in(const clod_plan_repeats *of)
{
    for (size_t k = 0; k < of->count && k < CLOD_PLAN_SPECIMENS; k++) {
        for (size_t m = 0; m < k; m++) {
            if (of->differences[m].specimen == of->differences[k].specimen) {
                return true;
            }
        }
    }
    return false;
}

/** An error without the part that a point has in common. */
static double without(double error, double common)
{
    return common > 0.0 ? sqrt(fmax(error * error - common * common, 0.0)) : error;
}

/** Errors from the scatter of all points together, where that is larger than what is stated. A point of one
 *  specimen scatters as the others do. What the points of each seed have in common is in the scatter between seeds, and not in
 *  that of rows of one. */
static void pool(clod_plan_samples *self, const double *scatter)
{
    double squares = 0.0, degrees = 0.0;
    bool between = true;
    bool relative = true; // a coefficient of variation needs values above 0
    for (size_t k = 0; k < self->count; k++) {
        const sample *one = &self->items[k];
        const double weight = (double)one->repeats.count - 1.0;
        relative = relative && one->value > 0.0;
        between = between && !is_twice_in(&one->repeats);
        // s^2 of a specimen over the square of the value
        squares += weight * (double)one->repeats.count * pow(scatter[k] / one->value, 2.0);
        degrees += weight;
    }
    for (size_t k = 0; k < self->count; k++) {
        sample *one = &self->items[k];
        if (degrees == 0.0) {
            continue;
        }
        const double all =
            relative ? one->value * sqrt(squares / degrees / (double)one->repeats.count)
                     : scatter[k];
        const double error = without(all, between ? one->common.error : 0.0);
        if (one->error <= 0.0 && !(self->scatter_alone && error > ROUNDING * one->value)) {
            continue; // without a stated error it is asked for
        }
        one->repeats.pooled = relative;
        one->repeats.estimate = error > one->error;
        one->error = fmax(one->error, error);
    }
}

double clod_plan_samples_largest(const clod_plan_samples *self)
{
    double most = 0.0;
    for (size_t k = 0; k < self->count; k++) {
        most = fmax(most, self->items[k].error);
    }
    return most;
}

void clod_plan_samples_merge(clod_plan_samples *self, double error)
{
    size_t merged = 0;
    for (size_t k = 0; k < self->count; k++) {
        sample *one = &self->items[k];
        one->error = fmax(one->error, error);
    }
    for (size_t first = 0, same; first < self->count; first += same) {
        sample *points = &self->items[first];
        same = gather(points, self->count - first);
        self->items[merged] =
            mean_of(points, same, self->slope, self->scratch + first, &self->scratch[merged]);
        merged++;
    }
    self->count = merged;
    pool(self, self->scratch);
}

void clod_plan_samples_warn(maker *self, const char *warning)
{
    clod_warning_list *list = &self->plan->warnings;
    clod_warning_list_add(list, "%s: %s", self->wish->locus, warning);
    const char *last = list->text[list->count - 1];
    for (size_t k = 0; k + 1 < list->count; k++) {
        if (strcmp(list->text[k], last) == 0) {
            list->count--; // another entry of the same table has told it
        }
    }
}

void clod_plan_samples_warn_one(maker *self, const clod_plan_target *common, double stated,
                                const char *what)
{
    if (common->error > stated) {
        return;
    }
    char text[CLOD_WARNING_LIST_TEXT];
    snprintf(
        text, sizeof text,
        "%s. Intervals are too narrow without it: measure several, or give what they differ by as error in the plan, "
        "which counts where it is larger than the table's.",
        what);
    clod_plan_samples_warn(self, text);
}

/** Warn where errors are estimated from few specimens, from few rows that may be of one, or from few preshears. */
static void warn_few(maker *self, const clod_plan_samples *from)
{
    const char *what = "";
    size_t fewest = 0;
    for (size_t k = 0; k < from->count; k++) {
        const clod_plan_repeats *of = &from->items[k].repeats;
        const clod_plan_common *common = &from->items[k].common;
        if (of->estimate && of->count > 1 && (fewest == 0 || of->count < fewest)) {
            fewest = of->count;
            what = is_twice_in(of) ? "rows" : "specimens";
        }
        const size_t preshears = common->error > 0.0 ? (size_t)common->degrees + 1 : 0;
        if (preshears > 0 && (fewest == 0 || preshears < fewest)) {
            fewest = preshears;
            what = "preshears";
        }
    }
    if (fewest == 0 || fewest > FEW) {
        return;
    }
    clod_warning_list_add(
        &self->plan->warnings,
        "%s: errors are estimated from %zu %s, whose scatter at one stress is uncertain by %.0f %%. "
        "Intervals are wider for it (Student's t); more %s make them narrower.",
        self->wish->locus, fewest, what, 100.0 / sqrt(2.0 * ((double)fewest - 1.0)), what);
}

void clod_plan_samples_warn_alike(clod_plan_maker *self, const clod_plan_samples *from)
{
    bool twice = false;
    for (size_t k = 0; k < from->count && from->count > 1; k++) {
        twice = twice || is_twice_in(&from->items[k].repeats);
    }
    if (twice) {
        clod_warning_list_add(
            &self->plan->warnings,
            "%s: the rows of one stress have one seed, so nothing tells which rows of several "
            "stresses are of one specimen: their errors count as independent, and intervals are too "
            "narrow if they are not. Number the specimens in the column seed.",
            self->wish->locus);
    }
}

// ---- targets

/** A point has no error: why. */
static void lack_error(maker *self, const clod_plan_samples *from, const sample *point,
                       const char *at)
{
    const size_t rows = point->repeats.count;
    char what[64] = "the table has";
    if (point->lacking > 0 && point->lacking < rows) {
        snprintf(what, sizeof what, "%zu of %zu rows have", point->lacking, rows);
    }
    clod_check_fail(self->loader, clod_plan_targets_at(self, ""),
                    "needs the key error: %s no %s%s%s", what, from->error_column, at,
                    from->scatter_alone && rows > 1 ? ", and all rows have one value" : "");
}

/** A measured point, or the mean of those at one stress, as a target. */
static void make_point(maker *self, const clod_number *kind, const clod_plan_target *common,
                       const clod_plan_samples *from, sample point)
{
    clod_plan_target made = *common;
    const char *name = clod_number_is_path(kind) ? self->wish->number : kind->key;
    char at[40] = "";
    if (point.stress > 0.0) {
        snprintf(at, sizeof at, " at %.6g kPa", 1e-3 * point.stress);
    }
    made.normal_stress = point.stress;
    made.curve = from->curve;
    made.value = point.value;
    made.error = hypot(point.error, point.common.error);
    made.common = point.common;
    made.repeats = point.repeats;
    if (made.error <= 0.0) {
        lack_error(self, from, &point, at);
    } else if (made.value < kind->least || made.value > kind->most) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has a %s of %.6g %s%s; allowed is %.6g to %.6g %s", name,
                        kind->measure.factor * made.value, kind->measure.unit, at,
                        kind->measure.factor * kind->least, kind->measure.factor * kind->most,
                        kind->measure.unit);
    } else if ((made.curve != NULL && !kind->at_stress) ||
               clod_plan_targets_check_stress(self, made.test, kind, name, point.stress)) {
        clod_plan_targets_add(self, &made, name);
    }
}

void clod_plan_samples_make(clod_plan_maker *self, const clod_number *kind,
                            const clod_plan_target *common, const clod_plan_samples *from,
                            double stress)
{
    warn_few(self, from);
    for (size_t k = 0; k < from->count; k++) {
        if (stress <= 0.0 || clod_plan_samples_same(from->items[k].stress, stress)) {
            make_point(self, kind, common, from, from->items[k]);
        }
    }
}
