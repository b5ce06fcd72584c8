#pragma once
/**
 * @file law_kinds.h
 * Contact laws as everything outside the hot loop sees them, the case file too: one row for
 * each clod_law_kind. What the kernels ask of it is in law_forms.h, the force itself in
 * law_normal.h.
 */

#include "law/law_cycle.h"

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

typedef struct clod_law_kind_row {
    clod_law_keys keys; ///< what it demands of its section in the case file
    const char *about;  ///< what it is, in a few words
    /** Numbers of the law from its keys; exponent, k1, k2 and tangent_ratio hold the keys. */
    void (*make)(clod_law *self, const clod_case_contact *contact, const clod_case_material *a,
                 const clod_case_material *b);
    bool elastic;    ///< remembers nothing of its normal force; `tangential` does not count
    bool rayleigh;   ///< the automatic time step is a fraction of the Rayleigh time
    bool speed_free; ///< restitution without dash-pot is the same at any speed
    /** Steepest rise df/dd [N/m] of a contact that was never pressed beyond this overlap [m]. */
    double (*stiffest)(const clod_law *self, double overlap, double r_star);
    /** Slope df/dd [N/m] with which a contact is unloaded at an overlap [m], from what it
     *  remembers. */
    double (*unloading)(const clod_law *self, double overlap, double r_star, double memory);
    /** Overlap [m] from which on virgin loading follows k2; NULL: none. */
    double (*flow)(const clod_law *self, double r_star);
    /** Largest pull after this overlap [m]. */
    clod_law_pull (*pull)(const clod_law *self, double r_star, double overlap);
    /** Plastic overlap [m] from what the contact remembers. */
    double (*plastic)(const clod_law *self, double r_star, double memory);
    /** Overlap [m] of virgin loading that leaves this memory; 0: it remembers nothing. */
    double (*pressed)(const clod_law *self, double memory);
    const char *stiffness_keys; ///< what the user raises when grains are too soft
} clod_law_kind_row;

/**
 * Row of a law.
 *
 * Errors  none.   Threads  pure.   Test  tests/law/test_law_kinds.c
 */
const clod_law_kind_row *clod_law_kinds_row(clod_law_kind kind);
