/**
 * @file plan_repose.c
 * A target of a plan from measured angles of repose: their mean.
 */

#include "base/input.h"
#include "base/memory.h"
#include "calibrate/plan_samples.h"
#include "clod/repose_angles.h"

#define ONE_STRESS 1.0 ///< of all heaps: so they are repeats of one measurement

/** Repeats without a stress, joined to their mean; the largest error that the table states. */
static double take_heaps(const clod_repose_heap *heaps, size_t count, double error,
                         clod_plan_samples *to)
{
    for (size_t k = 0; k < count; k++) {
        to->items[to->count++] = (clod_plan_sample){.stress = ONE_STRESS,
                                                    .value = heaps[k].angle,
                                                    .error = heaps[k].error,
                                                    .specimen = (int64_t)k + 1};
    }
    const double stated = clod_plan_samples_largest(to);
    clod_plan_samples_merge(to, error);
    to->items[0].stress = 0.0;
    return stated;
}

static void make_mean(clod_plan_maker *self, size_t test, const clod_number *kind,
                      const clod_repose_heap *heaps, size_t count)
{
    clod_plan_target common;
    clod_plan_samples list;
    if (!clod_plan_samples_common(self, test, kind, &common)) {
        return;
    }
    if (clod_plan_samples_init(&list, self, count)) {
        list.error_column = "angle_of_repose_error";
        list.scatter_alone = true;
        const double stated = take_heaps(heaps, count, common.error, &list);
        if (count == 1) {
            clod_plan_samples_warn_one(self, &common, stated,
                                       "one heap: scatter between heaps not included");
        }
        clod_plan_samples_make(self, kind, &common, &list, 0.0);
    }
    clod_plan_samples_fini(&list);
}

static bool make_repose(clod_plan_maker *self, size_t test, const clod_number *kind,
                        clod_status *status)
{
    const char *path = self->wish->locus;
    char *text;
    size_t length;
    if (!clod_input_read(path, SIZE_MAX, &text, &length, status)) {
        return false;
    }
    clod_repose_heap *heaps;
    size_t count;
    const bool good = clod_repose_angles_parse(path, text, length, &heaps, &count, status);
    if (good) {
        make_mean(self, test, kind, heaps, count);
        clod_locus_free(heaps);
    }
    clod_memory_free(text);
    return good;
}

const clod_plan_table CLOD_PLAN_TABLE_REPOSE = {
    .is = CLOD_PLAN_IS_REPOSE, .any_angle = true, .make = make_repose};
