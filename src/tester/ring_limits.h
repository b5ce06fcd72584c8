#pragma once
/**
 * @file ring_limits.h
 * Numbers of the ring shear test that more than one file asks for: the programme of the
 * procedure, which `clod check` adds up to a duration, and the limits above which check and
 * result warn. None of them changes the physics of a contact.
 */

// The programme: the operator's hand. Displacements are at the mean radius r_m.
#define CLOD_RING_FILL_TIME 0.6          ///< s at most, until the grains rest
#define CLOD_RING_LOWER_SPEED 0.1        ///< m/s of the lid on its way down
#define CLOD_RING_SETTLE_TIME 0.3        ///< s at most, consolidation and reduction
#define CLOD_RING_REVERSE_FRACTION 0.033 ///< speed of shearing back / speed of preshear
#define CLOD_RING_REVERSE_MAX 2e-3       ///< m at most of shear back
enum { CLOD_RING_COARSE_STEPS = 200 };   ///< per row of the series, at constant speed

// What is still good.
#define CLOD_RING_INERTIA_GOOD 1e-3       ///< inertial number of quasi-static shear (PHYSICS 5)
#define CLOD_RING_INERTIA_LIMIT 1.2e-3    ///< warned of: PHYSICS 5 says "about"
#define CLOD_RING_GRAINS_LIMIT 5.0        ///< fewest grain diameters across width and height
#define CLOD_RING_OVERLAP_MEAN_LIMIT 0.01 ///< overlap / radius of a contact under the mean load
#define CLOD_RING_OVERLAP_MOST_LIMIT 0.05 ///< overlap / radius of the deepest contact of a run
