#pragma once
/**
 * @file contact_bench.h
 * Parts of the contact bench that its tests look at.
 */

#include "clod/contact_bench.h"
#include "law/law.h"

/**
 * Restitution of the normal law alone, from the energy of the loop of docs/theory/mepa.md.
 *
 * With D the largest overlap, m = D ((k2 - k1)/(k2 + k_adh))^(1/n) the overlap of the largest
 * pull and P = (1 - k1/k2) D^n, loading stores k1 D^(n+1)/(n+1), and the way out gives back
 *   k2 ((D^(n+1) - m^(n+1))/(n+1) - P (D - m)) - k_adh m^(n+1)/(n+1),
 * whatever D. For luding and eepa D counts, and the impact is computed instead.
 *
 * @param d_max  D [m]
 * @return  e; 0 when the contact keeps more than it gives back, so that the grains stick
 * Errors  none.   Threads  pure.   Source  docs/theory/mepa.md.
 * Test    tests/tester/test_contact_bench.c
 */
double clod_contact_bench_restitution(const clod_law *law, double r_star, double d_max);

/**
 * Restitution of law and dash-pot together: two grains meet, symplectic Euler with a fixed
 * step.
 * @param d_max  overlap [m] that the impact would reach without dash-pot
 * @return  e; 0 when they stick
 */
double clod_contact_bench_impact(const clod_law *law, double m_star, double r_star,
                                 double d_max);
