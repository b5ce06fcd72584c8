#pragma once
/**
 * @file testers.h
 * Testers as the case file sees them: one row for each clod_case_kind. How each begins is in
 * src/setup/begin.c, how it is tried, checked and run in src/sim/testers.c.
 */

#include "config/load.h"

/** Materials that a tester names: of its grains, and of side, base and lid; NULL: none. */
typedef struct clod_tester_materials {
    const char *grain, *wall[3];
} clod_tester_materials;

typedef struct clod_config_tester {
    const char *key; ///< of its section; NULL: a free run
    bool cell;       ///< makes its own grains, walls and stages, and is all that runs
    bool (*present)(const clod_case *from);
    clod_tester_materials (*materials)(const clod_case *from);
    /** Programme of a shear test; NULL: it shears nothing. */
    const clod_case_programme *(*programme)(const clod_case *from);
    double (*stress)(const clod_case *from);      ///< Pa, the largest normal stress; of a cell
    double (*lid_damping)(const clod_case *from); ///< fraction of critical; of a cell
    void (*check)(clod_loader *loader, const clod_case *from);
} clod_config_tester;

/** Rows in the order of clod_case_kind; that of CLOD_CASE_FREE is empty. */
extern const clod_config_tester CLOD_CONFIG_TESTER[CLOD_CASE_KINDS];

/** Row of a case's tester; empty for a free run. Threads: pure. Test tests/config/test_config_testers.c
 */
const clod_config_tester *clod_config_tester_of(const clod_case *from);

/** A free run without grains, to which a program of the user's adds them. Threads: pure. */
bool clod_config_begins_empty(const clod_case *self);

#define CLOD_CONFIG_TESTER_KEYS 256

/** "ring_shear, jenike, uniaxial, wall_friction": keys of all that make a cell, for messages. */
void clod_config_tester_keys(char text[CLOD_CONFIG_TESTER_KEYS]);
