#pragma once
/**
 * @file law_kinds.h
 * Contact laws as everything outside the hot loop sees them: one row for each clod_law_kind.
 * Which keys a law has is in src/config/law_keys.c; what the kernels ask of it in law_forms.h,
 * the force itself in law_normal.h.
 */

#include "law/law_cycle.h"

typedef struct clod_law_kind_row {
    /** Numbers of the law from its keys; exponent, k1, k2 and tangent_ratio hold the keys. */
    void (*make)(clod_law *self, const clod_case_contact *contact, const clod_case_material *a,
                 const clod_case_material *b);
    bool elastic;    ///< remembers nothing of its normal force; `tangential` does not count
    bool rayleigh;   ///< the automatic time step is a fraction of the Rayleigh time
    bool speed_free; ///< restitution without dash-pot is the same at any speed
    /** Steepest rise df/dd [N/m] of a contact that was never pressed beyond this overlap [m]. */
    double (*stiffest)(const clod_law *self, double overlap, double r_star);
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
