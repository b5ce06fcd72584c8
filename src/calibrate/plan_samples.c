#include "calibrate/plan_samples.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/mean.h"
#include "base/memory.h"

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

/** That of points at one stress; error 0: a point has none. */
static sample mean_of(const sample *points, size_t count, double slope, double *values)
{
    sample mean = {0};
    double stated = 0.0;
    bool known = true;
    for (size_t k = 0; k < count; k++) {
        mean.stress += points[k].stress / (double)count;
        stated += points[k].error * points[k].error;
        known = known && points[k].error > 0.0;
    }
    for (size_t k = 0; k < count; k++) {
        values[k] = points[k].value + slope * (mean.stress - points[k].stress);
    }
    const clod_locus_value of = clod_mean_of(values, count, stated);
    mean.value = of.value;
    mean.error = known ? of.error : 0.0;
    return mean;
}

void clod_plan_samples_merge(clod_plan_samples *self, double error)
{
    size_t merged = 0;
    for (size_t k = 0; k < self->count; k++) {
        sample *one = &self->items[k];
        one->error = one->error > 0.0 ? one->error : error;
    }
    for (size_t first = 0, same; first < self->count; first += same) {
        sample *points = &self->items[first];
        same = gather(points, self->count - first);
        self->items[merged++] = mean_of(points, same, self->slope, self->scratch);
    }
    self->count = merged;
}

// ---- targets

/** A measured point, or the mean of those at one stress, as a target. */
static void make_point(maker *self, const clod_number *kind, const clod_plan_target *common,
                       const clod_plan_samples *from, sample point)
{
    clod_plan_target made = *common;
    char at[40] = "";
    if (point.stress > 0.0) {
        snprintf(at, sizeof at, " at %.6g kPa", 1e-3 * point.stress);
    }
    made.normal_stress = point.stress;
    made.curve = from->curve;
    made.value = point.value;
    made.error = point.error;
    if (made.error <= 0.0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, ""),
                        "needs the key error: the table has no %s%s", from->error_column, at);
    } else if (made.value < kind->least || made.value > kind->most) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "locus"),
                        "has a %s of %.6g %s%s; allowed is %.6g to %.6g %s", kind->key,
                        kind->measure.factor * made.value, kind->measure.unit, at,
                        kind->measure.factor * kind->least, kind->measure.factor * kind->most,
                        kind->measure.unit);
    } else if ((made.curve != NULL && !kind->at_stress) ||
               clod_plan_targets_check_stress(self, made.test, kind, kind->key, point.stress)) {
        clod_plan_targets_add(self, &made, kind->key);
    }
}

void clod_plan_samples_make(clod_plan_maker *self, const clod_number *kind,
                            const clod_plan_target *common, const clod_plan_samples *from,
                            double stress)
{
    for (size_t k = 0; k < from->count; k++) {
        if (stress <= 0.0 || clod_plan_samples_same(from->items[k].stress, stress)) {
            make_point(self, kind, common, from, from->items[k]);
        }
    }
}
