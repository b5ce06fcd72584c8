#pragma once
/**
 * @file lucy.h
 * Lucy's polynomial, the kernel of coarse-graining: how a grain's mass is spread over space.
 *
 *     W(r) = 105/(16 pi w^3) (1 + 3 r/w) (1 - r/w)^3   for r < w, 0 beyond;   its integral is 1
 *
 * It ends at r = w, so nothing is cut off; its first two derivatives are zero there; its line
 * integral, which spreads the force of a contact along the branch vector, has a closed form.
 *
 * Source  L. B. Lucy, Astron. J. 82 (1977) 1013, doi:10.1086/112164; Weinhart et al., Granular
 *         Matter 14 (2012) 289, doi:10.1007/s10035-012-0317-4; docs/theory/fields.md.
 * Test    tests/measure/test_lucy.c
 */

/**
 * The kernel at a distance.
 *
 * @param width   w [m], > 0
 * @param square  r^2 [m2]
 * @return        1/m3
 * Threads  pure.
 */
double clod_lucy(double width, double square);

/** A straight line between two points. */
typedef struct clod_lucy_line {
    double from[3];      ///< m
    double direction[3]; ///< unit; 0 where the line has no length
    double length;       ///< m
} clod_lucy_line;

/** The line from a point to another [m]. Threads: pure. */
clod_lucy_line clod_lucy_line_of(const double from[3], const double to[3]);

/**
 * Mean of the kernel about `at` over a line: the integral of W(|at - from - s (to - from)|) over
 * s from 0 to 1, exactly. Of a line without length the kernel at its point.
 *
 * @param width  w [m], > 0
 * @return       1/m3
 * Threads  pure.
 */
double clod_lucy_along(double width, const clod_lucy_line *line, const double at[3]);
