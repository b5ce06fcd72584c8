#pragma once
/**
 * @file rebound.h
 * A sphere of hertz that meets a plane at an angle, integrated on its own: the limit of small
 * steps of the friction rule of docs/theory/tangential.md, from the equations and not from
 * clod's laws.
 *
 *   m d'' = -k_n d^(3/2) - g_n d',   k_n = 4/3 E* sqrt(R),  k_t = 8 G* sqrt(R d)
 *   g = 2 z sqrt(5/6) sqrt(m S),     S_n = 2 E* sqrt(R d),  S_t = k_t
 *   xi' = s - xi k_t'/k_t where k_t grows, xi' = s where it does not; |k_t xi| <= mu k_n
 * d^(3/2) F = -k_t xi - g_t s, cut to mu k_n d^(3/2);  s = v_t - (R - d) w
 */

typedef struct clod_verify_rebound {
    double radius, mass;           ///< m, kg
    double young_star, shear_star; ///< E*, G* [Pa]
    double restitution, friction;  ///< 1
    double normal, slip;           ///< speeds before [m/s]
} clod_verify_rebound;

/**
 * Kinetic energy along the plane after the impact, spin included, over that before.
 *
 * @param steps  of the elastic duration; the error falls with 1/steps
 * Source  Hertz; Tsuji 1992; docs/theory/damping.md.   Test  tests/verify/test_closed_forms.c
 */
double clod_verify_rebound_energy(const clod_verify_rebound *self, int steps);
