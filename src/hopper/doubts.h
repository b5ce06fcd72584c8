#pragma once
/**
 * @file doubts.h
 * Whether what was measured makes sense together: what is impossible is refused, what is doubtful
 * becomes a warning beside the results.
 */

#include "hopper/result.h"
#include "hopper/tables.h"

#define CLOD_DOUBTS_APART 0.01 ///< relative distance below which two stresses count as the same
#define CLOD_DOUBTS_SLOPE                                                                      \
    1.1 ///< ratio below which two stresses tell no slope: scatter hides it

/**
 * Refuse what cannot be.
 *
 * Errors  CLOD_USAGE: a property is missing, two points at one stress, phi_e below phi_t, a wall yield locus that falls
 *         or has below 1 deg.
 * Threads  pure.   Test  tests/hopper/test_refusals.py
 */
bool clod_doubts_check(const clod_hopper_case *from, const char *path, const clod_solid *solid,
                       clod_status *status);

/** Whether a curve can go from one point to the next: the stress of q is clearly above that of p. */
bool clod_doubts_are_apart(const clod_curve_point *p, const clod_curve_point *q);

/** Note what is doubtful about a finished design in its warnings. */
void clod_doubts_warn(clod_hopper *self, const clod_tables_notes *notes);

/**
 * Note properties that no solid has, strengths and angles that contradict each other, strength or density that
 * falls with consolidation: other units or columns, as a rule; and densities of narrow cells.
 *
 * Test  tests/hopper/test_doubts.py
 */
void clod_doubts_measured(clod_hopper *self);

/**
 * Note how the line of the flow function fits its points: which have no errors to weigh by, and where it misses them, with
 * the outlets by the other curve; and where points of a wall lie off a line by more than their errors.
 *
 * Test  tests/hopper/test_line.py, test_untold.py
 */
void clod_doubts_line(clod_hopper *self);

/**
 * Note on what "no arch" rests: samples that have one, and a strength that is followed below what was measured.
 *
 * Test  tests/hopper/test_line.py
 */
void clod_doubts_no_arch(clod_hopper *self, const char *name, const clod_hopper_found *found);

/**
 * Note outlets below the critical one over which no arch stands, and why they are not large enough; likewise
 * ratholes.
 *
 * Test  tests/hopper/test_kinked.py
 */
void clod_doubts_ranges(clod_hopper *self, const char *name, const clod_hopper_found *found);
void clod_doubts_holes(clod_hopper *self);

/**
 * Note stresses of the design outside what was measured: at the critical outlet, at the one that is built and the one
 * that is given; and of an outlet of so large a stress that its length may be in another unit.
 *
 * Test  tests/hopper/test_beyond.py
 */
void clod_doubts_beyond(clod_hopper *self, const char *name, const clod_hopper_found *found);

/** The same of ratholes. */
void clod_doubts_beyond_holes(clod_hopper *self);

/** Note outlets at stresses below those of the bulk density, which is held constant there: too large for them. */
void clod_doubts_looser(clod_hopper *self);

/**
 * Note what the samples say of mass flow, and of the outlet that is given beside the critical one, the particles and
 * the silo.
 *
 * Test  tests/hopper/test_outlet.py, test_doubts.py
 */
void clod_doubts_outlet(clod_hopper *self, const char *name, const clod_hopper_found *found);

/**
 * Note where the wall decides by what was not measured, or another stress asks for another angle.
 *
 * Test  tests/hopper/test_wall_decides.py
 */
void clod_doubts_wall(clod_hopper *self, const char *name, const clod_hopper_found *found);
