#pragma once
/**
 * @file stock.h
 * Which grains a bed has: their sizes by material.
 */

#include "measure/survey.h"

/** Grains of one material. */
typedef struct clod_stock {
    double count;
    double least; ///< m, smallest radius; 0 of none
    double sum;   ///< m, of all radii
} clod_stock;

/**
 * Find out.
 *
 * @param stock  [materials] [out]
 * Errors  CLOD_FAILED: memory.   Threads  one per bed.   Test  tests/step/test_ranks_survey.c
 */
bool clod_stock_take(clod_stock *stock, size_t materials, const clod_survey *survey,
                     clod_status *status);

extern const clod_survey_way CLOD_STOCK_WAY;
