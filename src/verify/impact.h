#pragma once
/**
 * @file impact.h
 * Impacts that a deck makes, measured step by step, and the same deck in other frames.
 */

#include "verify/play.h"

/** Number of impacts in a deck at most. */
#define CLOD_VERIFY_IMPACTS CLOD_VERIFY_GRAINS

/** One impact: grain a on grain b, or on the deck's first wall. */
typedef struct clod_verify_impact {
    int a, b;                 ///< grains of the deck; b = CLOD_VERIFY_ON_WALL
    clod_verify_curve *curve; ///< gets overlap, force, k overlap^1.5 while they touch; or NULL
    double hertz;             ///< this k [N/m^1.5]
    // found
    double peak_force, peak_overlap; ///< N, m
    double begin, end;               ///< s; overlap zero, between steps
    int64_t steps;                   ///< in contact
    bool a_first;                    ///< a comes before b in the engine's order
    bool apart;                      ///< at the end of the run
    clod_vec3 v[2], w[2];            ///< of a and b at the end [m/s], [rad/s]; a wall: 0
    // while it runs
    double last_overlap, last_time;
} clod_verify_impact;

#define CLOD_VERIFY_ON_WALL (-1)

/** Run a deck in a frame and measure its impacts; a and b are given. */
bool clod_verify_impact_run(const clod_verify_bench *bench, const clod_verify_deck *deck,
                            const clod_verify_frame *frame, clod_verify_impact *impacts,
                            int count, clod_status *status);

/**
 * Run a deck as it is, then with the other order of every pair and in a turned frame, and check
 * that velocities and spins agree to what rounding can do.
 *
 * @param impacts  [count, in,out] what was found in the plain frame
 */
bool clod_verify_impact_frames(const clod_verify_bench *bench, const clod_verify_deck *deck,
                               clod_verify_impact *impacts, int count, clod_status *status);
