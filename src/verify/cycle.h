#pragma once
/**
 * @file cycle.h
 * A law along a path: a grain between two planes that come and go in step, so that it stays
 * where it is and both overlaps are those of the path.
 */

#include "verify/play.h"

#define CLOD_VERIFY_LEGS CLOD_VERIFY_STAGES
#define CLOD_VERIFY_LEG_STEPS 200 ///< steps of one leg

/**
 * Force of a law as its paper prints it, branch by branch; written apart from src/law.
 *
 * @param law      the numbers of the law
 * @param overlap  m; not above 0: nothing is remembered, no force
 * @param memory   [in,out] what the contact remembers; 0: new
 * @return         force [N], repulsion is positive
 */
typedef double clod_verify_branches(const void *law, double overlap, double *memory);

/** A straight piece of the path. */
typedef struct clod_verify_leg {
    double overlap;            ///< at its end [m]; not above 0: apart
    clod_verify_expect expect; ///< of the force there [N]; value NAN: nothing is expected
} clod_verify_leg;

typedef struct clod_verify_cycle {
    const char *name, *title;
    const char *contact;       ///< keys of the pair of materials, as YAML
    double radius, density;    ///< m, kg/m3
    double step;               ///< s
    double largest;            ///< d_max: overlaps are told as parts of it [m]
    double largest_force;      ///< f_max: differences are told as parts of it [N]
    clod_verify_branches *law; ///< what is expected at every step
    const void *law_data;
    const char *law_source;
    clod_verify_leg legs[CLOD_VERIFY_LEGS];
    int leg_count;
    int pull_legs; ///< the largest pull is looked for in so many legs from the first
} clod_verify_cycle;

/** What the run of a cycle has seen. */
typedef struct clod_verify_cycle_found {
    double end[CLOD_VERIFY_LEGS]; ///< force at the end of each leg [N]
    double pull, pull_overlap;    ///< largest pull (below 0) [N], and where [m]
} clod_verify_cycle_found;

/**
 * Run a cycle, write its curve, and check every step against the law, the motion of the grain,
 * and the end of each leg.
 *
 * @param found  [out]
 */
bool clod_verify_cycle_run(const clod_verify_bench *bench, const clod_verify_cycle *self,
                           clod_verify_cycle_found *found, clod_status *status);
