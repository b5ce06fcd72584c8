#pragma once
/**
 * @file radial.h
 * Jenike's radial stress field: stresses near the outlet of a hopper in steady flow.
 *
 * The mean stress is r rho g q(theta), with r from the apex and theta from the vertical axis, and
 * the major principal stress lies at psi(theta) to r. Both follow from two differential equations
 * (docs/theory/hopper.md); on the axis psi is 90 degrees, at the wall the friction angle of the
 * wall gives it. Angles in rad.
 */

#include <stdbool.h>

typedef enum clod_radial_shape {
    CLOD_RADIAL_WEDGE = 0,
    CLOD_RADIAL_CONE = 1
} clod_radial_shape;

/** Tolerance of a step, relative and absolute; a hundredth of it changes no printed digit. */
#define CLOD_RADIAL_TOLERANCE 1e-8

/** Half angles above this are not looked at. */
#define CLOD_RADIAL_WIDEST 1.0471975511965976 // 60 degrees

/** What is solved. */
typedef struct clod_radial {
    clod_radial_shape shape;
    double phi_e;     ///< effective angle of internal friction, 0 ... pi/2
    double phi_w;     ///< wall friction angle, >= 0
    double tolerance; ///< CLOD_RADIAL_TOLERANCE
} clod_radial;

/** The field at the wall. */
typedef struct clod_radial_wall {
    double axis;    ///< mean stress over r rho g on the axis
    double q;       ///< the same at the wall
    double sigma_1; ///< major principal stress over r rho g
    double sigma_w; ///< normal stress on the wall over r rho g
} clod_radial_wall;

/**
 * Angle of the major principal stress at the wall beyond 90 degrees.
 *
 * @return NAN where the solid does not slide along such a wall: phi_w is phi_e or more, or the
 *         angle would be 45 degrees or more, where the velocity at the wall is zero
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_radial.c
 */
double clod_radial_beta(double phi_e, double phi_w);

/**
 * Largest half angle for which the field has a solution in which the whole cross-section moves
 * (psi below 135 degrees).
 *
 * @param theta  [out] at most CLOD_RADIAL_WIDEST
 * @return       false: there is none for any half angle
 * Errors  none.   Threads  pure.   Source  Jenike, Bulletin 123 (1964); docs/theory/hopper.md.
 * Test    tests/hopper/test_radial.c
 */
bool clod_radial_limit(const clod_radial *self, double *theta);

/**
 * Solve the field for one half angle.
 *
 * @param theta  half angle, 0 < theta <= CLOD_RADIAL_WIDEST
 * @param wall   [out]
 * @return       false: no solution, the solid does not slide along this wall
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_radial.c
 */
bool clod_radial_solve(const clod_radial *self, double theta, clod_radial_wall *wall);

/**
 * The same, sooner where a field close to it is known.
 *
 * @param guess  mean stress over r rho g on the axis of that field; 0: not known
 */
bool clod_radial_solve_near(const clod_radial *self, double theta, double guess,
                            clod_radial_wall *wall);
