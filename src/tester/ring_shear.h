#pragma once
/**
 * @file ring_shear.h
 * The procedure of a shear test, as a state machine that looks at the walls between steps and
 * tells them what to do next. It holds plain data only, so a checkpoint stores it as it is.
 *
 * It is that of the Schulze ring shear test (ASTM D6773; docs/theory/ring-shear.md) and of the
 * Jenike shear test (ASTM D6128), whose cell is sheared along x instead of about z. What
 * depends on the tester is its row (tester/shear_tester.h), which the procedure finds by
 * `kind`.
 *
 * One procedure prepares the specimen: fill, lower the lid, consolidate, preshear until steady,
 * for preshear_min at least and preshear_max at most. The shear stress of preshear is the mean
 * of the steady blocks; of a preshear that was not steady it is where a line through the last
 * blocks ends: the points start from there, and a mean would lag behind by half the blocks.
 * A second one goes on from there: reverse to zero shear stress. For each shear point another
 * one starts from that same state: reduce the load, shear to the peak and beyond.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"
#include "measure/peak.h"
#include "measure/steady.h"
#include "state/state.h"

/** The testers. */
typedef enum clod_ring_shear_kind {
    CLOD_RING_SHEAR_RING,
    CLOD_RING_SHEAR_JENIKE,
    CLOD_RING_SHEAR_KINDS,
} clod_ring_shear_kind;

typedef enum clod_ring_shear_phase {
    CLOD_RING_SHEAR_FILL,        ///< grains fall and come to rest, adhesion reduced
    CLOD_RING_SHEAR_LOWER,       ///< the lid comes down until it carries
    CLOD_RING_SHEAR_CONSOLIDATE, ///< load raised to the preshear stress, full adhesion
    CLOD_RING_SHEAR_PRESHEAR,    ///< shear at the preshear stress until steady
    CLOD_RING_SHEAR_REVERSE,     ///< shear back until the shear stress is zero
    CLOD_RING_SHEAR_REDUCE,      ///< load lowered to the point's normal stress
    CLOD_RING_SHEAR_SHEAR,       ///< shear to the peak and beyond
    CLOD_RING_SHEAR_DONE,
    CLOD_RING_SHEAR_TWIST, ///< Jenike: after consolidate, the lid is twisted to and fro
} clod_ring_shear_phase;

/** Things that went not as they should; bits, for the warning box. */
typedef enum clod_ring_shear_flag {
    CLOD_RING_SHEAR_NOT_SETTLED = 1, ///< fill, consolidate or reduce ran into its time limit
    CLOD_RING_SHEAR_NOT_STEADY = 2,  ///< preshear ended at preshear_max, tau still changing
    CLOD_RING_SHEAR_NO_REVERSAL = 4, ///< shear stress did not come down to zero
    CLOD_RING_SHEAR_NO_PEAK = 8,     ///< shear_max reached before the peak was passed
    CLOD_RING_SHEAR_NO_BED = 16,     ///< the lid came within a grain of the lower bars or ring
} clod_ring_shear_flag;

/** Columns of the test's series, in this order; texts in clod_ring_shear_columns. */
typedef enum clod_ring_shear_column {
    CLOD_RING_SHEAR_TIME,
    CLOD_RING_SHEAR_PHASE,
    CLOD_RING_SHEAR_DISPLACEMENT,
    CLOD_RING_SHEAR_NORMAL_STRESS,
    CLOD_RING_SHEAR_NORMAL_STRESS_BASE,
    CLOD_RING_SHEAR_SHEAR_STRESS,
    CLOD_RING_SHEAR_SHEAR_STRESS_BASE,
    CLOD_RING_SHEAR_HEIGHT,
    CLOD_RING_SHEAR_BULK_DENSITY,
    CLOD_RING_SHEAR_SPEED,
    CLOD_RING_SHEAR_POWER,
    CLOD_RING_SHEAR_COLUMNS,
} clod_ring_shear_column;

typedef struct clod_ring_shear {
    // the cell
    double area;        ///< m2
    double mean_radius; ///< r_m [m]
    double grain_mass;  ///< kg, all grains
    double bars_volume; ///< m3, of all bars
    double bar_height;  ///< m
    double lid_start;   ///< m, height of the lid's plane at shift 0
    double lid_mass;    ///< kg
    double lowest_lid;  ///< m: below it no grain fits between the bars of lid and trough
    int64_t kind;       ///< clod_ring_shear_kind; what the other tester has is 0
    double base_height; ///< m, Jenike: the shear plane above the base
    double twist_angle; ///< rad, Jenike: of the lid to each side
    int64_t twists;     ///< Jenike: how often to and fro
    // the programme
    double preshear_stress, shear_stress;                             ///< Pa
    double speed, shear_speed;                                        ///< m/s at r_m
    double block_displacement, preshear_min, preshear_max, shear_max; ///< m
    double fill_max, settle_max; ///< s at most until the grains, and the lid, rest
    // where it is
    int64_t phase;        ///< clod_ring_shear_phase
    double phase_start;   ///< s
    double displacement;  ///< m at r_m since the phase began
    double target_stress; ///< Pa, at the shear plane
    double start_stress;  ///< Pa, from which the load is ramped
    double target_speed;  ///< m/s at r_m
    int64_t calm;         ///< samples in a row in which nothing moved
    int64_t turns;        ///< of the twisted lid, done
    double last_height;   ///< m
    int64_t flags;        ///< clod_ring_shear_flag
    clod_steady steady;
    clod_peak peak;
    // results
    double hanger_force; ///< N on the lid in the main phase, beside its weight and the solid's
    double preshear_normal, preshear_shear, preshear_error; ///< Pa; see below
    double preshear_rate, preshear_rate_error; ///< Pa/m: of the shear stress at the end
    double preshear_height, preshear_density;
    double preshear_inside;       ///< kg/m3 away from the walls; NAN: the cell is too narrow
    double preshear_displacement; ///< m
    double preshear_dilation;     ///< change of height per shear displacement, steady blocks
    double point_normal, point_shear, point_error; ///< Pa, at the peak
    double point_displacement;                     ///< m, from the start of shear to the peak
    double point_density;                          ///< kg/m3 at the peak
} clod_ring_shear;

/** Header texts of the series. */
extern const char *const clod_ring_shear_columns[CLOD_RING_SHEAR_COLUMNS];

/** Name of a phase, for logs. */
const char *clod_ring_shear_phase_name(clod_ring_shear_phase phase);

/**
 * Begin with the filling of a fresh cell (setup/ring_cell.h, setup/jenike_cell.h), that of the
 * case's shear test.
 */
void clod_ring_shear_begin(clod_ring_shear *self, const clod_case *from, clod_state *state);

/** Begin to shear back from the presheared state: `self` is the copy of the preparing one. */
void clod_ring_shear_reverse(clod_ring_shear *self, clod_state *state);

/** Begin a shear point from the reversed state: `self` is the copy of the reversing one. */
void clod_ring_shear_branch(clod_ring_shear *self, double shear_stress, clod_state *state);

/** Steps until the next look. */
int64_t clod_ring_shear_plan(const clod_ring_shear *self, const clod_state *state);

/**
 * Look at the walls after the planned steps: fill a row of the series, and move on.
 *
 * @param row  [out] [CLOD_RING_SHEAR_COLUMNS] means over the steps since the last look
 * @return     true when preparation, reversal or point is finished, or cannot go on
 * Errors  none: what is not right is noted in flags; after NO_BED nothing more can come.
 * Threads  one per state.
 * Source  docs/theory/ring-shear.md.   Test  tests/tester/test_ring_shear.c
 */
bool clod_ring_shear_sample(clod_ring_shear *self, clod_state *state, double *row);

/** Why the procedure cannot go on and what to do, in `text`; false when it can. */
bool clod_ring_shear_trouble(const clod_ring_shear *self, char *text, size_t size);

/** Part of the shear displacement of this procedure that is done, 0 to 1, at most. */
double clod_ring_shear_progress(const clod_ring_shear *self);
