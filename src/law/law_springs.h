#pragma once
/**
 * @file law_springs.h
 * Models of the tangential stiffness and of rolling resistance as everything outside the hot
 * loop sees them: one row for each clod_tangential and clod_rolling. What the kernels compute
 * of them is in law_tangential.h.
 */

#include "law/law.h"

typedef struct clod_law_springs_tangential_row {
    bool takes_k1; ///< the number k1 is the stiffness; else the key tangential_ratio counts
    double (*stiffness)(const clod_law *law, double loading); ///< k_t [N/m]
} clod_law_springs_tangential_row;

typedef struct clod_law_springs_rolling_row {
    bool resists;                                             ///< has the key rolling_friction
    bool dash_pot;                                            ///< has the key rolling_damping
    double (*stiffness)(const clod_law *law, double loading); ///< k_r/R*^2 [N/m]; NULL: none
} clod_law_springs_rolling_row;

/** Names in the case file in the order of clod_tangential and clod_rolling, ended by NULL. */
extern const char *const CLOD_LAW_SPRINGS_TANGENTIAL[];
extern const char *const CLOD_LAW_SPRINGS_ROLLING[];

/**
 * Row of a model.
 *
 * @param model  clod_tangential; clod_rolling
 * Errors  none.   Threads  pure.   Test  tests/law/test_law_springs.c
 */
const clod_law_springs_tangential_row *clod_law_springs_tangential_row_of(int model);
const clod_law_springs_rolling_row *clod_law_springs_rolling_row_of(int model);

/**
 * Stiffness k_t [N/m] of a contact's tangential spring.
 *
 * @param loading  tangent dk of its loading branch [N/m] (clod_law_tangent)
 * Errors  none.   Threads  pure.   Source  docs/theory/tangential.md.
 * Test    tests/law/test_law_springs.c
 */
double clod_law_springs_tangential(const clod_law *law, double loading);

/**
 * Stiffness of a contact's rolling spring over R*^2, k_r/R*^2 [N/m]; 0: the model has none.
 *
 * @param loading  as above
 * Errors  none.   Threads  pure.   Source  docs/theory/rolling.md.
 * Test    tests/law/test_law_springs.c
 */
double clod_law_springs_rolling(const clod_law *law, double loading);
