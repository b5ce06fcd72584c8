#pragma once
/**
 * @file law_keys.h
 * Contact laws as the case file sees them: one row for each clod_law_kind with its name and
 * what it demands of the keys of its section. Loading, checks, echo and help read these rows.
 * What a law computes is in src/law/law_kinds.c.
 */

#include "clod/case.h"

/** A key that a law needs is named by an example of its value; without one the law has none. */
typedef struct clod_law_keys {
    double exponent;              ///< n that the law always has; 0: the key exponent says it
    const char *k1, *k2;          ///< N/m^n, examples; NULL: the law refuses the key
    const char *plasticity_depth; ///< example; NULL: the law refuses the key
    bool k_adh;                   ///< has the key k_adh
    bool pull_off_force;          ///< has this key
    bool surface_energy;          ///< has this key, in place of k_adh
    bool k2_above;                ///< k2 is more than k1; else it may be the same
    bool elastic_moduli; ///< stiffness from youngs_modulus and poissons_ratio of the materials
} clod_law_keys;

/** Names in the case file in the order of clod_law_kind, ended by NULL. */
extern const char *const CLOD_LAW_NAMES[CLOD_LAW_KINDS + 1];

/**
 * Row of a law.
 *
 * @param law  clod_law_kind
 * @return     never NULL
 * Errors  none.   Threads  pure.   Test  tests/law/test_law_kinds.c
 */
const clod_law_keys *clod_law_keys_of(int law);

#define CLOD_LAW_KEYS_TEXT 128

/**
 * Names of the laws that have a key, as "law eepa" or "the laws mepa, luding and eepa".
 *
 * @param has   whether the law of a row has the key
 * @param text  [out]
 * @return      how many have it
 * Errors  none.   Threads  pure.   Test  tests/config/test_wrong.c
 */
int clod_law_keys_list(bool (*has)(const clod_law_keys *law), char text[CLOD_LAW_KEYS_TEXT]);

/** Exponent that the law of this name always has; 0 when it is free or there is no such law. */
double clod_law_keys_exponent(const char *name);
