#pragma once
/**
 * @file limits.h
 * Numbers of the testers that more than one file asks for: the programme of their procedures,
 * which `clod check` adds up to a duration, and the limits above which check and result warn.
 * None of them changes the physics of a contact.
 */

// The programme: the operator's hand. In a ring displacements are at the mean radius r_m.
#define CLOD_LIMITS_LOWER_SPEED 0.1        ///< m/s of the lid on its way down
#define CLOD_LIMITS_REVERSE_FRACTION 0.033 ///< speed of shearing back / speed of preshear
#define CLOD_LIMITS_REVERSE_MAX 2e-3       ///< m at most of shear back
enum { CLOD_LIMITS_COARSE_STEPS = 200 };   ///< per row of the series, at constant speed

// What is still good.
#define CLOD_LIMITS_INERTIA_GOOD                                                               \
    1e-3 ///< inertial number of quasi-static shear (docs/theory/time-step.md)
#define CLOD_LIMITS_INERTIA 1.2e-3    ///< warned of: docs/theory/time-step.md says "about"
#define CLOD_LIMITS_ACROSS 5.0        ///< fewest grain diameters across width and height
#define CLOD_LIMITS_WALL_GRAINS 3.0   ///< fewest across a specimen on a wall, in all directions
#define CLOD_LIMITS_BARS_GRAINS 2.0   ///< fewest between bars and plate: else grains roll there
#define CLOD_LIMITS_FREE_GRAINS 10.0  ///< fewest across a specimen that stands by itself
#define CLOD_LIMITS_OVERLAP_MEAN 0.01 ///< overlap / radius of a contact under the mean load
#define CLOD_LIMITS_OVERLAP_MOST 0.05 ///< overlap / radius of the deepest contact of a run
#define CLOD_LIMITS_STABLE 0.9        ///< time step / largest stable one of a bed
#define CLOD_LIMITS_STABLE_GRAINS 50000 ///< of beds asked for it, which takes 450 bytes each
