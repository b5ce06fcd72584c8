#pragma once
/**
 * @file mean.h
 * Mean of measurements of one quantity, with its standard error.
 */

#include "clod/locus.h"

/**
 * Mean of independent values, all with the same weight. Its standard error is the larger of two:
 *
 * - what follows from the stated errors e_i, sqrt(sum e_i^2)/n,
 * - what follows from the scatter, s/sqrt(n), s the standard deviation (n - 1) of the values.
 *
 * They are not added: the values scatter by what is stated, too.
 *
 * @param value   [count]
 * @param stated  sum of e_i^2; 0: nothing is stated
 * @return        NAN for what nothing tells: all of no value, the error of a single one without a
 *                stated one; the scatter is always NAN
 * Errors  none.   Threads  pure.
 * Source  JCGM 100:2008 (GUM), 4.2.3 and 5.1.2; the larger: R. T. Birge, Phys. Rev. 40 (1932) 207
 * Test    tests/analysis/test_mean.c
 */
clod_locus_value clod_mean_of(const double *value, size_t count, double stated);
