#pragma once
/**
 * @file hertz.h
 * Closed forms of an impact, worked out from the literature and not from clod's laws.
 *
 * Elastic (Hertz 1882; Johnson, Contact Mechanics, 1985, sections 4.2 and 11.4), with
 * k = 4/3 E* sqrt(R*) and m* d'' = -k d^(3/2):
 *   largest overlap  d = (5 m* v^2/(4 k))^(2/5)
 *   duration         T = 2 (d/v) I,  I = int_0^1 dx/sqrt(1 - x^(5/2)) = G(7/5) G(1/2)/G(9/10)
 *   mean overlap, weighted with the force: from int F d dt = m* int v^2 dt,
 *                    <d> = d J,  J = int_0^1 sqrt(1 - x^(5/2)) dx = G(7/5) G(3/2)/G(19/10)
 * where G is the gamma function.
 *
 * Sliding throughout (rigid body impulses; Chung & Ooi 2011, eqs. of tests 4-8): the impulses
 * are m* (1 + e) v along the normal and mu times that across, against the slip. Spheres have
 * 1/m + R^2/I = 7/(2 m), so the slip changes by (7/2) mu (1 + e) v, and sliding lasts to the
 * end when the slip was larger than that.
 */

/** Two spheres, or a sphere (b with mass 0) on a rigid plane. SI. */
typedef struct clod_verify_pair {
    double radius_a, radius_b; ///< m; radius_b 0: a plane
    double mass_a, mass_b;     ///< kg; mass_b 0: a plane, which cannot move
    double young_star;         ///< E* [Pa]
    double speed;              ///< of approach along the normal [m/s]
} clod_verify_pair;

double clod_verify_hertz_mass(const clod_verify_pair *self);      ///< m* [kg]
double clod_verify_hertz_radius(const clod_verify_pair *self);    ///< R* [m]
double clod_verify_hertz_stiffness(const clod_verify_pair *self); ///< k [N/m^1.5]
double clod_verify_hertz_overlap(const clod_verify_pair *self);   ///< largest [m]
double clod_verify_hertz_force(const clod_verify_pair *self);     ///< largest [N]
double clod_verify_hertz_duration(const clod_verify_pair *self);  ///< s

/** Mean overlap of the elastic impact, weighted with the force [m]. */
double clod_verify_hertz_mean_overlap(const clod_verify_pair *self);

/** Mass of a sphere [kg]. */
double clod_verify_hertz_sphere(double density, double radius);
