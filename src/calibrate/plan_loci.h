#pragma once
/**
 * @file plan_loci.h
 * Yield loci of the measured tables of a plan, and numbers of the plan that contradict them; for plan*.c alone.
 */

#include "analysis/fields.h"
#include "calibrate/plan_targets.h"

/** What the yield locus of a table tells. */
typedef struct clod_plan_locus {
    size_t test, entry; ///< of the plan's `targets`
    clod_locus_value values[CLOD_FIELD_COUNT];
    bool preshear_untold; ///< see clod/locus.h
    struct clod_plan_locus *next;
} clod_plan_locus;

/**
 * Keep the yield locus of a table whose shear points are targets, for the comparison with other targets.
 *
 * @param study   of the points, with the errors that the table states
 * @param group   of it, that of the test's preshear stress
 * @param points  [count] of the table
 * @param error   standard error of each point by the plan, which counts where the table's is smaller [Pa]; 0: none
 * Errors  lack of memory goes to the report.
 */
void clod_plan_loci_keep(clod_plan_maker *self, size_t test, const clod_locus_study *study,
                         size_t group, const clod_locus_point *points, size_t count,
                         double error);

/** Complain about numbers that contradict the yield locus of a table of their test. */
void clod_plan_loci_check(clod_loader *loader, const clod_plan *self);

/** Free all of a plan. */
void clod_plan_loci_free(clod_plan *self);
