#pragma once
/**
 * @file contact_bench.h
 * The contact bench: one contact driven along a given path, with the law of the simulations.
 *
 * Grain 1 touches a partner, a grain or a flat wall. The normal points from the partner to
 * grain 1 and stays where it is, as do the two tangents t1 and t2; t1 x t2 = normal. A leg of
 * the path is linear in time, so all speeds are constant on it:
 *   overlap  grain 1 comes nearer;
 *   slip     grain 1 moves across, without rotation;
 *   roll     turns grain 1 against its partner about t2, without slip at the contact: two
 * grains turn in opposite directions, on a wall the grain moves along; twist    turns grain 1
 * about the normal while its partner is held. On slow legs the dash-pots vanish and what is
 * left is the law alone.
 *
 * A NULL where an argument is needed: see clod/status.h.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/case.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Branch of the normal force, as in eq. (4): f1, f2, f3, or no contact. */
typedef enum clod_contact_branch {
    CLOD_BRANCH_OPEN,      ///< no overlap
    CLOD_BRANCH_LOADING,   ///< f1 = k1 d^n
    CLOD_BRANCH_UNLOADING, ///< f2 = k2 (d^n - dp^n), reloading too
    CLOD_BRANCH_ADHESIVE,  ///< f3 = -k_adh d^n
} clod_contact_branch;

/** The contact at the end of one step; forces and torques act on grain 1. */
typedef struct clod_contact_bench_row {
    double time;           ///< s
    double overlap;        ///< m, negative for a gap
    double slip[2];        ///< m so far, along t1 and t2
    double roll, twist;    ///< rad so far
    double force;          ///< N, hysteretic normal force, repulsion is positive
    double damping;        ///< N, normal dash-pot
    double friction[2];    ///< N along t1 and t2
    double torque[3];      ///< N m about the centre of grain 1, along t1, t2, normal; all parts
    double roll_torque[2]; ///< N m, the part of rolling resistance, along t1 and t2
    clod_contact_branch branch;
    double plastic;        ///< m, plastic overlap dp = P^(1/n)
    double spring[2];      ///< m, tangential spring along t1 and t2
    double roll_spring[2]; ///< rad, rolling spring along t1 and t2
    double limit;          ///< N, Coulomb limit
    bool sliding;          ///< friction is at its limit
} clod_contact_bench_row;

/** The path beside the closed forms of docs/theory/mepa.md, damping.md. */
typedef struct clod_contact_bench_summary {
    double d_max, f_max;        ///< largest force of the path [N], and its overlap [m]
    double d_min, f_min;        ///< largest pull of the path [m], [N]; 0, 0 without pull
    double d_before, f_before;  ///< largest force before that pull [m], [N]
    double pull_off_overlap;    ///< closed form d_min/d_max
    double pull_off_force;      ///< closed form |f_min|/f_max
    double restitution_asked;   ///< e of the dash-pot
    double restitution_law;     ///< closed form, the law without dash-pot; 0: no parting
    double restitution_both;    ///< an impact with law and dash-pot, integrated; 0: no parting
    double damping_ratio;       ///< z of docs/theory/damping.md
    double damping_coefficient; ///< gamma_n at d_max [N s/m]
} clod_contact_bench_summary;

/** Takes one row; false stops the bench, with the reason in *status. */
typedef bool (*clod_contact_bench_sink)(void *context, const clod_contact_bench_row *row,
                                        clod_status *status);

/**
 * Drive the contact of a case's contact_bench along its path.
 *
 * @param from     case with contact_bench
 * @param sink     gets one row for each step, in order
 * @param context  handed to every call of sink; may be NULL
 * @param summary  [out]
 * @return         false: no contact_bench in the case, a grain without the density that its
 *                 dash-pot needs, or the sink's own failure
 * Errors  CLOD_USAGE, of a NULL too; what the sink says.   Threads  pure but for the sink.
 * Source  docs/theory.   Test  tests/tester/test_contact_bench.c
 */
bool clod_contact_bench_run(const clod_case *from, clod_contact_bench_sink sink, void *context,
                            clod_contact_bench_summary *summary, clod_status *status);

/** Head of the CSV table, with units and without a line end; static text. */
const char *clod_contact_bench_header(void);

/** Longest line of clod_contact_bench_line, end included. */
#define CLOD_CONTACT_BENCH_LINE 768

/** A row as a line of the CSV table, without a line end; numbers read back exactly. */
void clod_contact_bench_line(const clod_contact_bench_row *row,
                             char line[CLOD_CONTACT_BENCH_LINE]);

#ifdef __cplusplus
}
#endif
