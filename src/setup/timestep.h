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

/** Radii of the grains of one material. */
typedef struct clod_timestep_sizes {
    double count; ///< grains that there are or can come; 1: it cannot meet its like
    double least; ///< m, smallest of them
    double sum;   ///< m, of all: the mean is sum/count
} clod_timestep_sizes;

/** What is known of the grains before the step is chosen. */
typedef struct clod_timestep_grains {
    const clod_timestep_sizes *sizes; ///< [materials]
    const bool *is_wall;              ///< [materials] of which there are walls
    double stress;                    ///< Pa that grains carry, for the overlap
    double speed; ///< m/s at which grains meet, for the overlap; 0 = no impact
} clod_timestep_grains;

typedef struct clod_timestep {
    double step;                 ///< s, 0 without grains
    bool given;                  ///< the case says the step
    clod_timestep_reason reason; ///< what sets the automatic step
    const char *text;            ///< the reason in words; static
    // of the pair that sets the automatic step
    int material_a, material_b; ///< b may be a wall's
    bool wall;                  ///< b is a wall's
    double radius_a, radius_b;  ///< m, smallest grains of the two; b: 0 for a wall
    double stiffness;           ///< N/m, the stiffest tangent
    double mass;                ///< kg, effective mass that goes with it
    double period;              ///< s, 2 pi sqrt(mass/stiffness)
    double critical;            ///< s, period/pi: beyond it the integration blows up
    double collision;           ///< s, that a collision of the two takes at that load
    double automatic;           ///< s, the step that auto takes
    // of the same pair, at the estimated load
    double unloading;     ///< N/m, k2 tangent
    double radius;        ///< m, the smaller mean of the two: force = stress (2 radius)^2
    double force;         ///< N on a contact
    double overlap;       ///< m
    double overlap_ratio; ///< overlap / radius
    // of the pair with the smallest critical step, which with hertz need not be the same
    double limit;                          ///< s, that step; 0 without grains
    double limit_force;                    ///< N on its contact
    const char *limit_a, *limit_b;         ///< its materials, borrowed from the case
    bool limit_wall;                       ///< b is a wall's
    double limit_radius_a, limit_radius_b; ///< m, its smallest grains; b: 0 for a wall
    double bed; ///< s, estimate of the largest step that the bed bears; 0: no two grains meet
    // over all grain materials with a Young's modulus
    double rayleigh;          ///< s, smallest Rayleigh time; 0 = unknown
    double rayleigh_fraction; ///< step / rayleigh; 0 = unknown
} clod_timestep;

/**
 * Rayleigh time of a grain, pi R sqrt(rho/G)/(0.1631 nu + 0.8766), or 0 without E.
 * Source  docs/theory/time-step.md.   Test  tests/setup/test_setup_timestep.c
 */
double clod_timestep_rayleigh(const clod_case_material *material, double radius);

/** Overlap at which loading has taken up all energy of an impact at `speed` of a mass m* [m].
 */
double clod_timestep_impact(const clod_law *law, double r_star, double m_star, double speed);

/** Stiffest normal tangent n k2 d^(n-1) of a pair [N/m] at overlap d [m]. */
double clod_timestep_unloading(const clod_law *law, double r_star, double overlap);

/** Period 2 pi sqrt(mass/stiffness) [s]. */
double clod_timestep_period(double mass, double stiffness);

/** Note grains of one radius [m] that there are, or that can come, besides those before. */
void clod_timestep_add(clod_timestep_sizes *self, double count, double radius);

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
 * hertz it is rayleigh_limit times the smaller Rayleigh time of the pair. Springs: the k2
 * tangent, the tangential spring (effective mass 2/7 m*, since a slip also turns the grains)
 * and the rolling spring, on the masses of the smallest grains that each of the two materials
 * has, at the overlap of its mean grains under the larger of `stress` and an impact at `speed`
 * (all kinetic energy in virgin loading). A material with a single grain is no pair with
 * itself, unless that grain can meet nothing else.
 *
 * @return  the step with all numbers behind it; with `time.step` given, that step
 * Errors  none: the case is checked.   Threads  pure.
 * Source  docs/theory/time-step.md.   Test  tests/setup/test_setup_timestep.c
 */
clod_timestep clod_timestep_choose(const clod_case *from, const clod_timestep_grains *grains);

/**
 * Refuse a given step beyond the critical step of any pair: energy would grow without end, and
 * what comes out need not even look wrong.
 *
 * Errors  CLOD_USAGE with the largest stable step, its pair and the load.   Threads  pure.
 * Source  docs/theory/time-step.md.   Test  tests/setup/test_setup_timestep.c
 */
bool clod_timestep_accept(const clod_timestep *self, clod_status *status);
