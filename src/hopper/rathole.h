#pragma once
/**
 * @file rathole.h
 * Funnel flow: the largest stable rathole, and the width of a slot. Equations: docs/theory/hopper.md.
 */

#include "hopper/ranges.h"
#include "hopper/solid.h"

/** Angles for which Jenike's function G is known [rad]. */
#define CLOD_RATHOLE_LEAST 0.52359877559829882 // 30 degrees
#define CLOD_RATHOLE_MOST 1.2217304763960306   // 70 degrees

/** The silo above the hopper. */
typedef struct clod_rathole_silo {
    double diameter, height; ///< m; diameter 0: not given
    double stress_ratio;     ///< horizontal over vertical stress
} clod_rathole_silo;

typedef struct clod_rathole {
    double
        emptying; ///< m: lower bound, from the stresses around the hole: none larger stands; 0: none
                  ///< at all; INFINITY: any; NAN: not known
    double filling;         ///< m: upper bound, from the stresses after filling; NAN: not known
    double filling_stress;  ///< Pa: that of Janssen
    clod_solid_state state; ///< of the lower bound
} clod_rathole;

/**
 * Jenike's function G of the static angle of internal friction.
 *
 * @return NAN outside CLOD_RATHOLE_LEAST ... CLOD_RATHOLE_MOST
 * Errors  none.   Threads  pure.   Source  fit to Jenike, Bulletin 123, p. 67.
 * Test    tests/hopper/test_rathole.c
 */
double clod_rathole_function(double phi_t);

/**
 * Rathole diameters of a solid.
 *
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_rathole.c
 */
clod_rathole clod_rathole_of(const clod_solid *solid, const clod_rathole_silo *silo);

/** A slot in funnel flow. */
typedef struct clod_rathole_slot {
    double
        width; ///< m: no dome stands over wider ones; 0: over none at all; INFINITY: one over any
    clod_solid_state state; ///< where the width is neither 0 nor infinite
} clod_rathole_slot;

/**
 * Width of a slot in funnel flow from which on no dome stands over it: where the flow function meets a flow factor of
 * 1.7, with H = 1.15. The diagonal of the slot must be longer than the rathole's diameter besides.
 *
 * Errors  none.   Threads  pure.   Source  Schulze, Powders and bulk solids, 10.3.2.5, as retold in docs/theory/hopper.md
 * Test    tests/hopper/test_rathole.c
 */
clod_rathole_slot clod_rathole_slot_of(const clod_solid *solid);

/**
 * Diameters below the one of a hole that empties at which no rathole stands either.
 *
 * Errors  none.   Threads  pure.   Test  tests/hopper/test_ranges.c
 */
clod_ranges clod_rathole_ranges(const clod_solid *solid, const clod_rathole *hole);
