#pragma once
/**
 * @file ode.h
 * Two ordinary differential equations, integrated with steps whose error is controlled: the
 * explicit Runge-Kutta pair of orders 5 and 4 by Dormand and Prince.
 */

#include <stdbool.h>

typedef struct clod_ode_pair {
    double a, b;
} clod_ode_pair;

/** Derivatives at x. */
typedef clod_ode_pair (*clod_ode_rates)(const void *context, double x, clod_ode_pair y);

typedef struct clod_ode {
    clod_ode_rates rates;
    const void *context;
    double tolerance; ///< of a step, relative to 1 + |y|
    double x;
    clod_ode_pair y;
    double step; ///< that the next call tries first
    bool
        begun; ///< clod_ode_advance has made a step, which ended with the rates that the next begins with
    clod_ode_pair rate; ///< these
} clod_ode;

/**
 * One step of a given size from x, without control of its error.
 *
 * @param error  [out] difference of the two orders, the larger of both equations; NULL: not asked
 * Errors  none.   Threads  pure.   Source  Dormand and Prince, J. Comp. Appl. Math. 6 (1980) 19.
 * Test    tests/hopper/test_ode.c
 */
clod_ode_pair clod_ode_try(const clod_ode *self, double size, double *error);

/**
 * Advance by one step that keeps to the tolerance and does not go beyond `end`.
 *
 * @return  false: no step is small enough; a rate is not finite
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_ode.c
 */
bool clod_ode_advance(clod_ode *self, double end);
