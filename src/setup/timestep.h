#pragma once
/**
 * @file timestep.h
 * The automatic time step and the numbers behind it, for the run and for `clod check`.
 */

#include "clod/case.h"
#include "law/law.h"

/** What sets the automatic step. */
typedef enum clod_timestep_reason {
    CLOD_TIMESTEP_UNLOADING,  ///< normal stiffness of unloading, k2
    CLOD_TIMESTEP_TANGENTIAL, ///< tangential stiffness (with the grain's turning)
    CLOD_TIMESTEP_ROLLING,    ///< rolling stiffness
    CLOD_TIMESTEP_RAYLEIGH,   ///< Rayleigh time (hertz)
} clod_timestep_reason;

/** What is known of the grains before the step is chosen. */
typedef struct clod_timestep_grains {
    double radius_min;    ///< m, lightest grain
    double radius_mean;   ///< m
    double stress;        ///< Pa that grains carry, for the overlap
    double speed;         ///< m/s at which grains meet, for the overlap; 0 = no impact
    const bool *is_grain; ///< [materials] of which there are grains
    const bool *is_wall;  ///< [materials] of which there are walls
} clod_timestep_grains;

typedef struct clod_timestep {
    double step;                 ///< s, 0 without grains
    bool given;                  ///< the case says the step
    clod_timestep_reason reason; ///< what sets the automatic step
    const char *text;            ///< the reason in words; static
    // of the pair that sets the automatic step
    int material_a, material_b; ///< b may be a wall's
    bool wall;                  ///< b is a wall's
    double stiffness;           ///< N/m, the stiffest tangent
    double mass;                ///< kg, effective mass that goes with it
    double period;              ///< s, 2 pi sqrt(mass/stiffness)
    double critical;            ///< s, period/pi: beyond it the integration blows up
    double automatic;           ///< s, the step that auto takes
    // of the same pair, at the estimated load
    double unloading;     ///< N/m, k2 tangent
    double force;         ///< N on a contact
    double overlap;       ///< m
    double overlap_ratio; ///< overlap / mean radius
    // of the pair with the smallest critical step, which with hertz need not be the same
    double limit;                  ///< s, that step; 0 without grains
    double limit_force;            ///< N on its contact
    const char *limit_a, *limit_b; ///< its materials, borrowed from the case
    bool limit_wall;               ///< b is a wall's
    // over all grain materials with a Young's modulus
    double rayleigh;          ///< s, smallest Rayleigh time; 0 = unknown
    double rayleigh_fraction; ///< step / rayleigh; 0 = unknown
} clod_timestep;

/**
 * Rayleigh time of a grain, pi R sqrt(rho/G)/(0.1631 nu + 0.8766), or 0 without E.
 * Source  PHYSICS 5.   Test  tests/setup/test_setup_timestep.c
 */
double clod_timestep_rayleigh(const clod_case_material *material, double radius);

/** Overlap at which loading has taken up all energy of an impact at `speed` of a mass m* [m].
 */
double clod_timestep_impact(const clod_law *law, double r_star, double m_star, double speed);

/** Stiffest normal tangent n k2 d^(n-1) of a pair [N/m] at overlap d [m]. */
double clod_timestep_unloading(const clod_law *law, double r_star, double overlap);

/** Period 2 pi sqrt(mass/stiffness) [s]. */
double clod_timestep_period(double mass, double stiffness);

/**
 * Force of one contact in a bed under stress: stress (2R)^2, as if each grain carried what acts
 * on its square. [N]
 */
double clod_timestep_force(double stress, double radius);

/**
 * Choose the time step of a case.
 *
 * A step is safety * T/pi of the stiffest spring of any pair that can meet, T/pi being the
 * limit of stability of a single spring; the safety covers several contacts on one grain. For
 * hertz it is rayleigh_limit times the Rayleigh time. Springs: the k2 tangent, the tangential
 * spring (effective mass 2/7 m*, since a slip also turns the grains) and the rolling spring,
 * all at the overlap under the larger of `stress` and an impact at `speed` (all kinetic energy
 * in virgin loading), for the lightest grain.
 *
 * @return  the step with all numbers behind it; with `time.step` given, that step
 * Errors  none: the case is checked.   Threads  pure.
 * Source  PHYSICS 5.   Test  tests/setup/test_setup_timestep.c
 */
clod_timestep clod_timestep_choose(const clod_case *from, const clod_timestep_grains *grains);

/**
 * Refuse a given step beyond the critical step of any pair: energy would grow without end, and
 * what comes out need not even look wrong.
 *
 * Errors  CLOD_USAGE with the largest stable step, its pair and the load.   Threads  pure.
 * Source  PHYSICS 5.   Test  tests/setup/test_setup_timestep.c
 */
bool clod_timestep_accept(const clod_timestep *self, clod_status *status);
