#pragma once
/**
 * @file part_measures.h
 * What a test measures beside its tester: fields (docs/fields.md) and mixing indices
 * (docs/mixing.md), those of free runs. Their columns stand behind those of the tester. A part looks
 * at its bed at its rows: a field is sampled at the first one since each interval, a mixing index
 * at all.
 *
 * A grid is the mean over the samples of one phase of the part: its sums begin anew with each phase,
 * so that at the end they are those of the last one, the shear of a shear test.
 */

#include <jansson.h>

#include "sim/job.h"

/** What the parts of a batch have in common; nothing without such measures. */
typedef struct clod_part_measures {
    const clod_case *from;
    const clod_procedure *tester;
    const char **columns; ///< [count] owned, of the tester and then of the measures
    char *text;           ///< owned, header texts of the measures
    size_t count;         ///< 0: nothing is measured
} clod_part_measures;

/** Bytes that the measures of a part remember. Threads: pure. */
size_t clod_part_measures_size(const clod_case *from);

/**
 * @param tester  procedure without measures; borrowed, as the case
 * Errors  CLOD_FAILED: no memory.
 */
bool clod_part_measures_init(clod_part_measures *self, const clod_case *from,
                             const clod_procedure *tester, clod_status *status);

void clod_part_measures_fini(clod_part_measures *self);

/**
 * Give a part's procedure the measures.
 *
 * @param self       borrowed by the procedure
 * @param procedure  that of the tester; its data has clod_part_measures_size bytes behind it, zero
 *                   at the beginning
 * Threads  several may share `self`.
 * Test     tests/cli/test_fields_testers.py, tests/cli/test_grids_testers.py
 */
void clod_part_measures_join(const clod_part_measures *self, clod_procedure *procedure);

/** A part begins, perhaps with what the one before it remembers behind the tester's `data`. */
void clod_part_measures_begin(const clod_part_measures *self, void *data,
                              const clod_state *state);

/**
 * Put what the summary of a part has of them, `fields` and `mixing`; nothing when there are none. Means
 * over regions and of indices are those of part_means.h.
 *
 * @param tester  without measures
 * @param folder  where the series of the part is
 * @param part    name of the part, which is finished
 * @param memory  behind the data of its tester
 * Errors  CLOD_FAILED: its series cannot be read; no memory.
 * Test    tests/python/test_part_measures.py
 */
bool clod_part_measures_put(json_t *object, const clod_case *from, const clod_procedure *tester,
                            const clod_folder *folder, const char *part, const void *memory,
                            clod_status *status);
