#pragma once
/**
 * @file domain.h
 * The part of space that is simulated.
 */

#include <stdbool.h>

typedef struct clod_domain {
    double min[3], max[3]; ///< m; a grain that leaves an open side stops the run
    bool periodic[3];
} clod_domain;
