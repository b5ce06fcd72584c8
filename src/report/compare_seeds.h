#pragma once
/**
 * @file compare_seeds.h
 * Runs that repeat one case with other seeds, and their means.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

#include "report/result_table.h"
#include "report/run_files.h"
#include "report/writer.h"

/** Groups of complete runs whose cases differ in nothing but `seed` (and `title`). */
typedef struct clod_compare_seeds {
    size_t *group; ///< [count] owned: number of the first run of the group; `count`: of none
    size_t *
        twin; ///< [count] owned: the earlier run of its case with a seed in common; `count`: none
    size_t count; ///< of runs
} clod_compare_seeds;

/**
 * Find the groups. A run that has a seed (a packing) in common with an earlier one of its group is left out: it tells
 * little that is new.
 *
 * @param self  [out] owned (clod_compare_seeds_fini), also after a failure
 * Errors  CLOD_FAILED: no memory.   Test  tests/report/test_compare.py
 */
bool clod_compare_seeds_find(clod_compare_seeds *self, const clod_run_files *runs, size_t count,
                             clod_status *status);

/** How many runs have this group. */
size_t clod_compare_seeds_size(const clod_compare_seeds *self, size_t group);

/**
 * Mean of each number: value, error (the standard error of the mean), scatter (the standard deviation)
 * and n, as many as are known.
 *
 * @param of  [count] objects of the same kind, borrowed
 * @return    owned; NULL without memory
 */
json_t *clod_compare_seeds_mean(const clod_result_row *rows, size_t row_count,
                                const json_t *const *of, size_t count);

/** Say what each mean is of. */
void clod_compare_seeds_note(clod_writer out, const clod_compare_seeds *self,
                             const clod_run_files *runs);

/** Say which runs have a packing in common: these are no repeats. */
void clod_compare_seeds_twins(clod_writer out, const clod_compare_seeds *self,
                              const clod_run_files *runs);

/** Whether two runs begin from the same grains: both from their case, or (`clod run --from`) from one run. */
bool clod_compare_seeds_origin(const clod_run_files *a, const clod_run_files *b);

/** How the mean of a group is called, in order of the groups. */
void clod_compare_seeds_name(const clod_compare_seeds *self, size_t group, char name[64]);

void clod_compare_seeds_fini(clod_compare_seeds *self);
