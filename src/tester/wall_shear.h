#pragma once
/**
 * @file wall_shear.h
 * The procedure of the wall friction test, as a state machine that looks at the walls between
 * steps and tells them what to do next. It holds plain data only, so a checkpoint stores it as
 * it is.
 *
 * One procedure fills the cell. Another one goes on from there: lower the lid, consolidate at
 * the largest wall normal stress, then move the plate and never stop it: run in, shear until
 * the wall shear stress is steady, lower the load, run in again, and so on down to the lowest
 * stress (docs/theory/wall-friction.md).
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"
#include "measure/steady.h"
#include "state/state.h"

typedef enum clod_wall_shear_phase {
    CLOD_WALL_SHEAR_FILL,        ///< grains fall and come to rest, adhesion reduced
    CLOD_WALL_SHEAR_LOWER,       ///< the lid comes down until it carries
    CLOD_WALL_SHEAR_CONSOLIDATE, ///< load raised to the largest stress, full adhesion
    CLOD_WALL_SHEAR_RUN_IN,      ///< plate moves, load goes to the next stress
    CLOD_WALL_SHEAR_SHEAR,       ///< plate moves until the shear stress is steady
    CLOD_WALL_SHEAR_DONE,
} clod_wall_shear_phase;

/** Things that went not as they should; bits, for the warning box. */
typedef enum clod_wall_shear_flag {
    CLOD_WALL_SHEAR_NOT_SETTLED = 1, ///< fill or consolidate ran into its time limit
    CLOD_WALL_SHEAR_NOT_STEADY = 2,  ///< at least one stress ended at shear_max, not steady
    CLOD_WALL_SHEAR_NO_BED = 4,      ///< the lid came within a grain of the plate
} clod_wall_shear_flag;

/** Columns of the test's series, in this order; texts in clod_wall_shear_columns. */
typedef enum clod_wall_shear_column {
    CLOD_WALL_SHEAR_TIME,
    CLOD_WALL_SHEAR_PHASE,
    CLOD_WALL_SHEAR_DISPLACEMENT,      ///< of the plate since it began to move
    CLOD_WALL_SHEAR_NORMAL_STRESS,     ///< on the plate
    CLOD_WALL_SHEAR_SHEAR_STRESS,      ///< on the plate
    CLOD_WALL_SHEAR_NORMAL_STRESS_LID, ///< with the weight of the solid
    CLOD_WALL_SHEAR_SHEAR_STRESS_HELD, ///< by lid and sides, which hold the solid
    CLOD_WALL_SHEAR_HEIGHT,
    CLOD_WALL_SHEAR_BULK_DENSITY,
    CLOD_WALL_SHEAR_SPEED,
    CLOD_WALL_SHEAR_POWER,
    CLOD_WALL_SHEAR_COLUMNS,
} clod_wall_shear_column;

/** What was found at one wall normal stress. */
typedef struct clod_wall_shear_point {
    double normal, normal_error; ///< Pa, on the plate; standard error of the mean
    double shear, shear_error;   ///< Pa
    double rate, rate_error;     ///< Pa/m: of the shear stress over the blocks of the mean
    double height, density;      ///< m, kg/m3
    double displacement;         ///< m sheared at this stress, without the run-in
    int64_t steady;              ///< 1: it was
} clod_wall_shear_point;

typedef struct clod_wall_shear {
    // the cell
    double area;        ///< m2
    double mean_radius; ///< r_m [m]; 0: straight, the plate moves along x
    double grain_mass;  ///< kg, all grains
    double bars_volume; ///< m3, of the lid's bars and the plate's ridges
    double bar_height;  ///< m
    double lid_start;   ///< m, height of the lid's plane at shift 0
    double lowest_lid;  ///< m: below it no grain fits between bars and plate
    // the programme
    double stresses[CLOD_CASE_WALL_STRESSES]; ///< Pa, descending
    int64_t stress_count;
    double speed;                ///< m/s at the largest stress
    double block_displacement;   ///< m
    int64_t steady_blocks;       ///< that must agree
    double steady_tolerance;     ///< relative
    double shear_min, shear_max; ///< m, at each stress
    double fill_max, settle_max; ///< s at most until the grains, and the lid, rest
    // where it is
    int64_t phase;       ///< clod_wall_shear_phase
    double phase_start;  ///< s
    double in_phase;     ///< m of shear since the phase began
    double displacement; ///< m of shear since the plate began to move
    int64_t at;          ///< which of the stresses
    double start_stress; ///< Pa, from which the load is ramped
    double target_speed; ///< m/s
    int64_t calm;        ///< samples in a row in which nothing moved
    double last_height;  ///< m
    int64_t flags;       ///< clod_wall_shear_flag
    clod_steady steady;
    // results
    clod_wall_shear_point point[CLOD_CASE_WALL_STRESSES]; ///< the first `at` are there
} clod_wall_shear;

/** Header texts of the series. */
extern const char *const clod_wall_shear_columns[CLOD_WALL_SHEAR_COLUMNS];

/** Name of a phase, for logs. */
const char *clod_wall_shear_phase_name(clod_wall_shear_phase phase);

/** Begin with the filling of a fresh cell (setup/wall_friction_cell.h). */
void clod_wall_shear_begin(clod_wall_shear *self, const clod_case *from, clod_state *state);

/** Take the programme of shear from the case: stresses, blocks, ways. */
void clod_wall_shear_programme(clod_wall_shear *self, const clod_case *from);

/** Begin to shear from the filled cell: `self` is the copy of the filling one. */
void clod_wall_shear_branch(clod_wall_shear *self, clod_state *state);

/** Steps until the next look. */
int64_t clod_wall_shear_plan(const clod_wall_shear *self, const clod_state *state);

/**
 * Look at the walls after the planned steps: fill a row of the series, and move on.
 *
 *     sigma_w = -F_z(plate)/A
 *     tau_w   = -T_z(plate)/(A r_m)    ring, plate turning about +z
 *     tau_w   = -F_x(plate)/A          straight, plate moving along +x
 *
 * with the forces and torques of the grains on the plate.
 *
 * @param row  [out] [CLOD_WALL_SHEAR_COLUMNS] means over the steps since the last look
 * @return     true when the filling or the test is finished, or cannot go on
 * Errors  none: what is not right is noted in flags; after NO_BED nothing more can come.
 * Threads  one per state.
 * Source  docs/theory/wall-friction.md.   Test  tests/tester/test_wall_shear.c
 */
bool clod_wall_shear_sample(clod_wall_shear *self, clod_state *state, double *row);

/** Why the procedure cannot go on and what to do, in `text`; false when it can. */
bool clod_wall_shear_trouble(const clod_wall_shear *self, char *text, size_t size);

/** Part of the shear displacement that is done, 0 to 1, at most. */
double clod_wall_shear_progress(const clod_wall_shear *self);
