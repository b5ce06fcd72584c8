#pragma once
/**
 * @file silo.h
 * A column of grains in a cylinder of stacked shells, on a floor that sinks slowly, so that the
 * grains slip down the wall everywhere and the wall carries what it can; and the forces
 * on its walls.
 */

#include "verify/bench.h"

#define CLOD_VERIFY_SILO_DIAMETER 60e-3 ///< m: 10 grains
#define CLOD_VERIFY_SILO_SHELL 30e-3    ///< m, height of a shell: half a diameter
#define CLOD_VERIFY_SILO_SHELLS 14      ///< the column is about 7 diameters high

/** One silo: what is given, then means while the floor sinks. */
typedef struct clod_verify_silo {
    const char *name; ///< of its folder
    int seed;
    double friction; ///< of the contacts of grains with the wall
    double rolling;  ///< rolling friction of these contacts
    double floor;    ///< N, on the floor, downwards
    double weight;   ///< N, of all grains
    double inertia;  ///< N, rate of their upward momentum: the column sinks unevenly
    double
        above[CLOD_VERIFY_SILO_SHELLS]; ///< N, weight of the grains above the foot of a shell
    double shear[CLOD_VERIFY_SILO_SHELLS];  ///< N, on the shell, downwards
    double normal[CLOD_VERIFY_SILO_SHELLS]; ///< N, on the shell, outwards; from the overlaps
    double overlap;                         ///< largest, over the smaller radius
    // while it runs
    int looks;
    double time, momentum; ///< s, N s, upwards; at the last look before the measurement
} clod_verify_silo;

/** The joints below at least a shell of grains, from the top down; the last is the floor. */
typedef struct clod_verify_silo_profile {
    size_t count;
    double filled[CLOD_VERIFY_SILO_SHELLS];   ///< N, weight above
    double apparent[CLOD_VERIFY_SILO_SHELLS]; ///< N, what stands on the joint
} clod_verify_silo_profile;

/** Fill, sink and measure. Errors: those of a bed. Threads: one at a time. */
bool clod_verify_silo_run(clod_verify_silo *self, const clod_verify_bench *bench,
                          clod_status *status);

// ---- measures of a silo that has run. Threads: pure. Test: tests/verify/test_silo.c

/** What floor and wall carry together, less the inertia [N]: the weight. */
double clod_verify_silo_carried(const clod_verify_silo *self);

/** Coefficient of friction of the wall: shear over normal force of all shells. */
double clod_verify_silo_wall_friction(const clod_verify_silo *self);

/** rho_b g A, the weight of a metre of column, away from floor and top [N/m]. */
double clod_verify_silo_line_weight(const clod_verify_silo *self);

/** Weight that stands on the middle of a shell below the top one [N]. */
double clod_verify_silo_stands_on(const clod_verify_silo *self, int shell);

/** K: stress on the wall over the vertical stress, both away from floor and top. */
double clod_verify_silo_stress_ratio(const clod_verify_silo *self);

clod_verify_silo_profile clod_verify_silo_joints(const clod_verify_silo *self);

/** Shells CLOD_VERIFY_SILO_LOW <= s < CLOD_VERIFY_SILO_HIGH are full and away from floor and
 * top. */
enum { CLOD_VERIFY_SILO_LOW = 2, CLOD_VERIFY_SILO_HIGH = 11 };
