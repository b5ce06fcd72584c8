#pragma once
/**
 * @file burden.h
 * The cross-section of a bulk solid on a conveyor belt, and what the belt carries.
 */

/** A belt with one, two or three rolls under it. */
typedef struct clod_burden_belt {
    double width;       ///< m, of the belt laid flat
    double middle_roll; ///< m; 0: two rolls; what is as wide as the burden or wider: one roll
    double idler_angle; ///< rad, of the wing rolls above the horizontal
} clod_burden_belt;

/** Areas of the burden's cross-section [m2]. */
typedef struct clod_burden_section {
    double heap;   ///< above the line between its edges, a parabola: S1
    double trough; ///< below it: S2
} clod_burden_section;

/**
 * Width of the belt, laid flat, on which the burden lies: b = 0.9 B - 50 mm up to B = 2 m, and B -
 * 250 mm beyond [m].
 *
 * Errors  none; 0 for a belt that is too narrow.   Threads  pure.
 * Source  ISO 5048; DIN 22101.   Test  tests/analysis/test_burden.c
 */
double clod_burden_width(double belt_width);

/**
 * Cross-section of a burden on `width` of a belt laid flat.
 *
 * @param width      m: clod_burden_width, or as found
 * @param surcharge  rad, slope of the heap at its edges: on a belt in motion some 5 to 15 degrees
 *                   less than the angle of repose
 * Errors  none.   Threads  pure.
 * Source  ISO 5048: S1 = [l3 + (b - l3) cos L]^2 tan(t)/6, S2 = [l3 + (b - l3)/2 cos L] (b - l3)/2
 *         sin L.   Test  tests/analysis/test_burden.c
 */
clod_burden_section clod_burden_of(const clod_burden_belt *belt, double width,
                                   double surcharge);
