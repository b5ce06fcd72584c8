#pragma once
/**
 * @file twin.h
 * A bed beside analytic walls, and the same beside triangle meshes: means of what was measured
 * agree within the scatter between seeds.
 */

#include <stdio.h>

#include "verify/bed.h"

#define CLOD_VERIFY_TWIN_SEEDS 3
#define CLOD_VERIFY_TWIN_QUANTITIES 4 ///< at most
#define CLOD_VERIFY_TWIN_OWN 8

/** Sums of one run; a quantity is sum/weight. */
typedef struct clod_verify_twin_run {
    double sum[CLOD_VERIFY_TWIN_QUANTITIES], weight[CLOD_VERIFY_TWIN_QUANTITIES];
    double begin; ///< s, for looks: of what is measured; 0: not yet
    double *last; ///< [grains, by id] m, for looks: heights at the look before; NULL at first
    double looks; ///< how many there were, for such as need it
    double own[CLOD_VERIFY_TWIN_OWN]; ///< numbers of the test's own, for look and check
} clod_verify_twin_run;

/** Add a value of a quantity. Threads: pure. */
void clod_verify_twin_add(clod_verify_twin_run *self, int quantity, double value);

typedef struct clod_verify_twin {
    const char *name; ///< of the folders of its cases
    const char *const *quantities;
    int count;
    void (*put_case)(FILE *out, bool mesh, int seed);
    bool (*put_meshes)(const char *folder, clod_status *status);
    clod_verify_bed_look look; ///< its context is a clod_verify_twin_run
    /** Check runs of one kind of wall against a law; NULL: none. @param runs  [SEEDS] */
    bool (*check)(const clod_verify_bench *bench, bool mesh, const clod_verify_twin_run *runs,
                  clod_status *status);
} clod_verify_twin;

/**
 * Run both with the same seeds and compare.
 *
 * Errors  those of a bed.   Threads  one at a time.   Source  Student's t: the 99 % interval of the
 * difference of two means of three.
 */
bool clod_verify_twin_compare(const clod_verify_twin *self, const clod_verify_bench *bench,
                              clod_status *status);
