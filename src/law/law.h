#pragma once
/**
 * @file law.h
 * A contact law made ready for the kernels: the numbers of one pair of materials.
 *
 * All laws are one code path. mepa with k1 = k2 and k_adh = 0 is elastic: hooke, and hertz,
 * whose stiffness goes with sqrt(R*). eepa is mepa with a constant pull, and with a pull that
 * goes with the plastic contact patch; luding's k2 rises with the largest overlap.
 * Source: docs/theory.
 */

#include <stdbool.h>
#include <stdint.h>

#include "clod/case.h"

typedef enum clod_law_exponent {
    CLOD_EXPONENT_ONE,
    CLOD_EXPONENT_THREE_HALVES,
    CLOD_EXPONENT_ANY,
} clod_law_exponent;

typedef struct clod_law {
    clod_law_kind kind;
    clod_law_exponent exponent_kind;
    double exponent;    ///< n
    double k1, k2;      ///< N/m^n; hertz: times sqrt(R*), so here N/m^2; luding: k2 at most
    double k_adh_final; ///< N/m^n, when the case says 100 %
    double k_adh;       ///< N/m^n, now
    double virgin;      ///< 1 - k1/k2
    double pull_off;    ///< 1 + k_adh/k2
    double touch_final; ///< N, eepa: -f0, when the case says 100 %
    double touch;       ///< N, now: the pull of any contact
    double patch_final; ///< N/m, eepa: pull / sqrt(R* dp), when the case says 100 %
    double patch;       ///< N/m, now; 0: k_adh counts
    double patch_start; ///< 2^(1/(2 n)), where eepa's search of dp begins
    double flow;        ///< luding: d*/R*, from where on k2 is at its most
    double hardening;   ///< N/m, luding: k2 - k1 of a contact = hardening d_max/R*
    double damping;     ///< 2 z sqrt((n + 1)/(2 n)): gamma_n = damping sqrt(m* dk)
    double friction;    ///< mu
    clod_coulomb coulomb;
    clod_tangential tangential;
    double tangent_ratio;     ///< k_t = tangent_ratio dk (tangent)
    double root_ratio;        ///< sqrt(tangent_ratio)
    double literal_stiffness; ///< k_t [N/m] (literal)
    clod_rolling rolling;
    double rolling_friction; ///< mu_r
    double rolling_damping;  ///< fraction of critical (epsd)
    double epsd_ratio;       ///< 2.25 mu_r^2: k_r = epsd_ratio dk R*^2 (epsd)
} clod_law;

/**
 * Make the law of a pair of materials ready: with its stiffnesses divided by contact->soften.
 *
 * @param contact  checked parameters of the pair, SI, as the case gives them
 * @param a, b     the two materials (hertz takes E and nu of both)
 * @return         law with adhesion at its final value
 * Errors  none: the case loader has checked.   Threads  pure.
 * Source  docs/theory; damping: docs/theory/damping.md; soften: docs/theory/softening.md.
 * Test    tests/law/test_law_make.c, test_law_soften.c
 */
clod_law clod_law_make(const clod_case_contact *contact, const clod_case_material *a,
                       const clod_case_material *b);

/**
 * A material whose Young's modulus is divided by `soften`; 0 leaves it.
 *
 * Errors  none.   Threads  pure.   Source  docs/theory/softening.md.
 * Test    tests/law/test_law_soften.c
 */
clod_case_material clod_law_soften_material(const clod_case_material *from, double soften);

/** Set k_adh and eepa's pulls to a fraction of their final values; histories stay. */
void clod_law_set_adhesion(clod_law *self, double fraction);

/** Loading tangent dk = n k1 d^(n-1) [N/m] at overlap d [m]; R* [m] counts for laws with
 *  clod_law_root_radius (law_forms.h) only. */
double clod_law_tangent(const clod_law *self, double overlap, double r_star);

/** Stiffest tangent [N/m] of any branch up to overlap d [m]: what limits the time step. */
double clod_law_stiffest(const clod_law *self, double overlap, double r_star);

/** All laws of a case: one for each unordered pair of materials. */
typedef struct clod_laws {
    int32_t materials;
    int32_t count; ///< materials (materials + 1) / 2
    clod_law *law; ///< owned
} clod_laws;

/** Row of the law of materials a and b. */
static inline int32_t clod_laws_index(const clod_laws *self, int32_t a, int32_t b)
{
    const int32_t low = a < b ? a : b;
    const int32_t high = a < b ? b : a;
    return low * self->materials - low * (low - 1) / 2 + (high - low);
}

bool clod_laws_init(clod_laws *self, const clod_case *from, clod_status *status);
void clod_laws_set_adhesion(clod_laws *self, double fraction);
void clod_laws_fini(clod_laws *self);
