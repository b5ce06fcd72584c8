#pragma once
/**
 * @file testers.h
 * Testers as the case file sees them: one row for each clod_case_kind that has one. Its cell
 * is in src/setup/begin.c, how it runs in tables of src/sim: run.c, trial.c, check.c and
 * check_cost.c.
 */

#include "config/load.h"

/** Materials that a tester names: of its grains, and of side, base and lid. */
typedef struct clod_tester_materials {
    const char *grain, *wall[3];
} clod_tester_materials;

typedef struct clod_config_tester {
    const char *key; ///< of its section; NULL: no tester
    bool (*present)(const clod_case *from);
    clod_tester_materials (*materials)(const clod_case *from);
    /** Programme of a shear test; NULL: it shears nothing. */
    const clod_case_programme *(*programme)(const clod_case *from);
    double (*stress)(const clod_case *from);      ///< Pa, the largest normal stress
    double (*lid_damping)(const clod_case *from); ///< fraction of critical
    void (*check)(clod_loader *loader, const clod_case *from);
} clod_config_tester;

/** Rows in the order of clod_case_kind; that of CLOD_CASE_FREE is empty. */
extern const clod_config_tester CLOD_CONFIG_TESTER[CLOD_CASE_KINDS];

/** Row of a case's tester; empty for a free run. Threads: pure. Test tests/config/test_case.c
 */
const clod_config_tester *clod_config_tester_of(const clod_case *from);
