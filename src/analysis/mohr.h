#pragma once
/**
 * @file mohr.h
 * Mohr circles of a yield locus tau = c + t sigma, t = tan(phi_lin).
 */

#include <stdbool.h>

/** The circle of steady flow. */
typedef struct clod_mohr {
    double centre, radius;
    bool parallel; ///< the preshear point lies above the locus
} clod_mohr;

/**
 * The circle through the preshear point that touches the locus; the smaller of the two. With
 * the preshear point above the locus, the one that touches the line parallel to the locus in
 * that point.
 *
 * With L = c + t sigma_p, the height of the locus at sigma_p, docs/theory/yield-locus.md
 * becomes centre = sigma_p + t L - sqrt((1 + t^2)(L^2 - tau_p^2)): the same circle without
 * c/tan phi, so that it holds for t = 0 and c = 0 as well.
 *
 * Errors  none.   Threads  pure.
 * Source  docs/theory/yield-locus.md; Schulze, Powders and Bulk Solids (2008), ch. 3.
 * Test    tests/analysis/test_locus.c
 */
clod_mohr clod_mohr_steady(double c, double t, double sigma_p, double tau_p);

/** Diameter sigma_c = 2 c (1 + sin phi)/cos phi of the circle from the origin. */
double clod_mohr_unconfined(double c, double t);

/** Normal stress at which a circle touches a line of slope t. */
double clod_mohr_touch(double centre, double radius, double t);

/** tau_p over the height of the locus at sigma_p; infinite where the locus has none. */
double clod_mohr_share(double c, double t, double sigma_p, double tau_p);

/**
 * The least such share of a preshear that came to steady flow: 0.75, and less for steep loci,
 * 0.9 cos phi.
 *
 * At the top of the circle, where the planes of shear are those of the largest shear stress, it
 * is cos phi whatever the cohesion is; a preshear point further right has not turned the
 * principal stresses as far as steady flow does. The tenth is for curved loci and scatter.
 *
 * Errors  none.   Threads  pure.   Source  docs/theory/yield-locus.md.
 * Test    tests/analysis/test_far_below.c
 */
double clod_mohr_share_least(double t);
