#pragma once
/**
 * @file uniaxial.h
 * The procedure of the uniaxial test, as a state machine that looks at the walls between steps
 * and tells them what to do next. It holds plain data only, so a checkpoint stores it as it is.
 *
 * One procedure fills the mould. For each consolidation stress another one starts from that
 * same state: lower the lid, consolidate, unload, take the mould away, crush.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"
#include "measure/peak.h"
#include "state/state.h"

typedef enum clod_uniaxial_phase {
    CLOD_UNIAXIAL_FILL,        ///< grains fall and come to rest, adhesion reduced
    CLOD_UNIAXIAL_LOWER,       ///< the lid comes down until it carries
    CLOD_UNIAXIAL_CONSOLIDATE, ///< load raised to the consolidation stress, full adhesion
    CLOD_UNIAXIAL_UNLOAD,      ///< the lid goes up until it carries nothing
    CLOD_UNIAXIAL_FREE,        ///< without the mould until at rest
    CLOD_UNIAXIAL_CRUSH,       ///< the lid comes down to the peak and beyond
    CLOD_UNIAXIAL_DONE,
} clod_uniaxial_phase;

/** Things that went not as they should; bits, for the warning box. */
typedef enum clod_uniaxial_flag {
    CLOD_UNIAXIAL_NOT_SETTLED = 1, ///< filling or consolidation ran into its time limit
    CLOD_UNIAXIAL_NOT_FREE = 2,    ///< not at rest when it was crushed
    CLOD_UNIAXIAL_NO_PEAK = 4,     ///< crush_max reached before the peak was passed
    CLOD_UNIAXIAL_COLLAPSED = 8,   ///< without the mould it carried nothing: strength 0
    CLOD_UNIAXIAL_NO_BED = 16,     ///< the lid came within a grain of the base
} clod_uniaxial_flag;

/** Columns of the test's series, in this order; texts in clod_uniaxial_columns. */
typedef enum clod_uniaxial_column {
    CLOD_UNIAXIAL_TIME,
    CLOD_UNIAXIAL_PHASE,
    CLOD_UNIAXIAL_STRAIN,      ///< since the specimen was unloaded; 0 before
    CLOD_UNIAXIAL_STRESS,      ///< of the lid
    CLOD_UNIAXIAL_STRESS_BASE, ///< with the weight of the solid
    CLOD_UNIAXIAL_MOULD_FORCE, ///< of the solid on the mould, downwards
    CLOD_UNIAXIAL_HEIGHT,
    CLOD_UNIAXIAL_BULK_DENSITY, ///< mass over the mould's area and the height
    CLOD_UNIAXIAL_SOLID_FRACTION,
    CLOD_UNIAXIAL_SPEED, ///< of the lid, downwards
    CLOD_UNIAXIAL_COLUMNS,
} clod_uniaxial_column;

typedef struct clod_uniaxial {
    // the cell
    double area;         ///< m2, of the mould
    double grain_mass;   ///< kg, all grains
    double solid_volume; ///< m3, all grains
    double lid_start;    ///< m, height of the lid's plane at shift 0
    double lowest_lid;   ///< m: below it no grain fits between lid and base
    // the programme
    double stress;                 ///< Pa, consolidation
    double speed;                  ///< m/s
    double crush_max, beyond_peak; ///< strain
    double fill_max, settle_max;   ///< s at most until the grains, and the lid, rest
    // where it is
    int64_t phase;       ///< clod_uniaxial_phase
    double phase_start;  ///< s
    double start_stress; ///< Pa, from which the load is ramped
    int64_t calm;        ///< looks in a row in which nothing moved
    double last_height;  ///< m
    int64_t flags;       ///< clod_uniaxial_flag
    int64_t touched;     ///< 1 from when the lid carries the free specimen
    clod_peak peak;
    // results
    double sigma_1, sigma_base;      ///< Pa, at the end of consolidation: lid, base
    double density, solid_fraction;  ///< kg/m3; 1; at the end of consolidation
    double inside;                   ///< kg/m3 away from the walls then; NAN: too narrow
    double height;                   ///< m, at the end of consolidation
    double unloaded_height;          ///< m, from which strain counts
    double strength, strength_error; ///< Pa, peak stress of the lid
    double strength_base;            ///< Pa, of the base at the peak
    double peak_strain;              ///< 1
} clod_uniaxial;

/** Header texts of the series. */
extern const char *const clod_uniaxial_columns[CLOD_UNIAXIAL_COLUMNS];

/** Name of a phase, for logs. */
const char *clod_uniaxial_phase_name(clod_uniaxial_phase phase);

/** Begin with the filling of a fresh cell (setup/uniaxial_cell.h). */
void clod_uniaxial_begin(clod_uniaxial *self, const clod_case *from, clod_state *state);

/** Begin a consolidation from the filled mould: `self` is the copy of the filling one. */
void clod_uniaxial_branch(clod_uniaxial *self, double stress, clod_state *state);

/** Steps until the next look. */
int64_t clod_uniaxial_plan(const clod_uniaxial *self, const clod_state *state);

/**
 * Look at the walls after the planned steps: fill a row of the series, and move on.
 *
 * @param row  [out] [CLOD_UNIAXIAL_COLUMNS] means over the steps since the last look
 * @return     true when the filling or the test is finished, or cannot go on
 * Errors  none: what is not right is noted in flags; after NO_BED nothing more can come.
 * Threads  one per state.
 * Source  docs/theory/uniaxial.md.   Test  tests/tester/test_uniaxial.c
 */
bool clod_uniaxial_sample(clod_uniaxial *self, clod_state *state, double *row);

/** Why the procedure cannot go on and what to do, in `text`; false when it can. */
bool clod_uniaxial_trouble(const clod_uniaxial *self, char *text, size_t size);

/** Part of the crushing that is done, 0 to 1, at most. */
double clod_uniaxial_progress(const clod_uniaxial *self);
