#pragma once
/**
 * @file check.h
 * The preflight: what a case will be like and what it will cost, without running it.
 * A NULL where an argument is needed: see clod/status.h.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CLOD_CHECK_WARNINGS 24
#define CLOD_CHECK_NOTES 6
#define CLOD_CHECK_WARNING_TEXT 512 ///< of a note too
#define CLOD_CHECK_TEXT 32768       ///< enough for either form of the report

#define CLOD_CHECK_RANKS 1000000 ///< most

typedef struct clod_check_options {
    int threads;      ///< 0 = all processors; with ranks, of each: 1
    int ranks;        ///< what so many ranks would cost, 1 to CLOD_CHECK_RANKS; 0: not asked
    const char *simd; ///< instruction set; NULL = the best
    const char *directory; ///< results folder, for the disk space; NULL = as clod_run
} clod_check_options;

/** A contact of two mean grains with one stiffness: under the target stress, and in an impact. */
typedef struct clod_check_contact {
    double automatic;     ///< s, step
    double overlap_ratio; ///< overlap / mean radius under the stress
    double pull_off;      ///< N, largest pull after it
    double wave_speed;    ///< m/s, of a chain of mean grains under it
    double impact_ratio;  ///< overlap / mean radius of an impact; 0, as the next: none known
    double impact_time;   ///< s that it lasts
    double impact_force;  ///< N, largest
    double impact_pull;   ///< N, largest pull after it
} clod_check_contact;

/** What ranks would cost, by the model of docs/scaling.md, to two digits; all 0: not asked. */
typedef struct clod_check_ranks {
    int ranks, groups;  ///< of all; groups that step parts of a test side by side, at most
    int node;           ///< ranks that this machine holds
    double own, ghosts; ///< grains of the rank that has most
    double begin_0,
        begin; ///< bytes of rank 0 and of another (0: none), while the bed is made and dealt
    double steps_0, steps;           ///< bytes in steps, with a rebuild
    double all, machine;             ///< bytes of all ranks together, and that this machine has
    double step;                     ///< s on the clock
    double clock_likely, clock_most; ///< s on the clock, of the steps
    double
        making; ///< s in which rank 0 makes the bed of a free run, in one process; 0: not known
    double writing; ///< s of each of its checkpoints; 0: not known
} clod_check_ranks;

/** Numbers in SI; 0 = not known or not meant for this kind of case. */
typedef struct clod_check_report {
    clod_case_kind kind; ///< CLOD_CASE_CONTACT_BENCH: nothing to estimate, all numbers are 0
    const char *path, *title; ///< borrowed from the case; title may be NULL
    // grains
    size_t grains;
    size_t
        sampled; ///< so many of them were made for the estimates; 0: all, and they were tried
    double radius_min, radius_mean, radius_max; ///< m
    double mass, solid_volume;                  ///< kg, m3
    // time step
    double step, automatic, critical; ///< s; critical: of the stiffest pair
    double
        stable;   ///< s, estimate of the largest step that the bed bears; 0: no two grains meet
    bool sheared; ///< it is that of a shear test
    bool step_given;
    const char *reason;            ///< what sets the automatic step; static
    const char *pair_1, *pair_2;   ///< materials of the stiffest pair, borrowed
    bool pair_wall;                ///< the second one is a wall's
    double pair_radius_1;          ///< m, smallest grain of the first material
    double pair_radius_2;          ///< m, of the second; 0 for a wall
    double stiffness, spring_mass; ///< N/m, kg
    double collision_steps;        ///< that a collision of the two takes at its load
    double restitution;            ///< that their dash-pot is asked for
    double restitution_least;      ///< that it returns in so many steps, by where between two
    double restitution_most;       ///< steps they touch
    double rayleigh;               ///< s
    double rayleigh_fraction;      ///< step / rayleigh
    bool rayleigh_imposed;         ///< hertz: it sets the automatic step
    // a contact at the target stress
    double stress;        ///< Pa
    double contact_force; ///< N, stress (2R)^2
    double overlap;       ///< m
    double overlap_ratio; ///< overlap / mean radius
    double pull_off;      ///< N, largest pull after that force
    double weight;        ///< N, of a mean grain
    double bond;          ///< pull_off / weight
    // softening; all 0 when the case has none
    double soften;                 ///< stiffnesses are divided by it
    double rest_stress;            ///< Pa, without impacts
    double impact_speed;           ///< m/s, most of a free run
    clod_check_contact soft, hard; ///< with the stiffness of the run, and of the case
    // shear tests; the uniaxial test has all but those of preshear and points; bars: ring
    size_t full_grains;       ///< that fill depth or height with fill_fraction
    double height_aimed;      ///< m, of the specimen when it settles to fill_fraction
    double height_loose;      ///< m, when filled, before it settles
    double inertial_preshear; ///< inertial number at height_aimed
    double inertial_loose;    ///< at height_loose
    double inertial_lowest, lowest_stress; ///< at the lowest stress of the test, Pa
    double lowest_speed;                   ///< m/s, shear at that stress
    double across_width, across_depth;     ///< grain diameters
    double bar_diameters;                  ///< bar height in grain diameters
    // ridges on the plate of a wall friction test; all 0: it is flat
    int64_t plate_ridges;    ///< number of them
    double ridge_spacing;    ///< m, from crest to crest
    double ridge_flank;      ///< rad above the floor
    double ridge_sink_depth; ///< m that a mean grain sinks between two crests
    double plate_roughness;  ///< Rmax(L = d)/d, d the mean diameter of the grains
    // loaded walls: the lid, or the one with the shortest period
    double servo_period; ///< s, of the wall on the stiffness of the bed
    // meshes and belts
    size_t facets, patches; ///< of all walls; patches: pieces of the smooth surface
    double memory_facets;   ///< bytes of their surfaces and shapes
    // fields
    double fields_clock;  ///< s of one thread for all samples at most; in the clock times below
    double fields_memory; ///< bytes
    // run
    double time_likely, time_most;   ///< s simulated, all parts one after the other
    double steps_likely, steps_most; ///< of all parts together
    int processors, threads;         ///< available, used
    int side_by_side;                ///< parts that run at the same time, at most
    const char *simd;                ///< instruction set; static
    size_t timed_grains;             ///< of the packing on which the rate was measured
    double rate_one, rate;  ///< grain-steps/s with one and with all threads, of a quiet machine
    double rate_slowest;    ///< of the slowest measurement with all threads
    double processor_share; ///< part of a processor that one thread got meanwhile; 1: all of it
    bool busy;              ///< other programs are at work: what more threads gain is assumed
    double clock_likely, clock_most;    ///< s on the clock
    double memory;                      ///< bytes
    double rows_most, snapshots_most;   ///< that will be written; a free run writes just these
                                        ///< when no stage ends early
    double disk_series, disk_snapshots; ///< bytes
    double disk_checkpoints, disk;      ///< bytes; all together
    double disk_free;                   ///< bytes
    clod_check_ranks of_ranks;          ///< the same case on ranks
    size_t warning_count;
    char warning[CLOD_CHECK_WARNINGS][CLOD_CHECK_WARNING_TEXT];
    size_t note_count; ///< what to look at in the results; nothing is wrong
    char note[CLOD_CHECK_NOTES][CLOD_CHECK_WARNING_TEXT];
} clod_check_report;

/**
 * Look at a case before it runs: its first 100 steps are tried as a run does them, unless it
 * has very many grains, and the step is timed for a moment on a small packing. Nothing is
 * written.
 *
 * @param from     checked case; the report borrows texts from it
 * @param options  how; all zero: the defaults
 * @param report   [out]
 * Errors  CLOD_USAGE: a NULL, a case that cannot be built, an unknown instruction set, more ranks than
 *         CLOD_CHECK_RANKS; CLOD_FAILED: one whose first steps go wrong.
 * Threads one per report.   Source  docs/theory/mepa.md, time-step.md, ring-shear.md, docs/scaling.md.
 * Test    tests/sim/test_check.c
 */
bool clod_check_report_make(const clod_case *from, const clod_check_options *options,
                            clod_check_report *report, clod_status *status);

/** The report for people. */
void clod_check_report_text(const clod_check_report *report, char text[CLOD_CHECK_TEXT]);

/** The report as one JSON object, keys with their units; false without memory. */
bool clod_check_report_json(const clod_check_report *report, char text[CLOD_CHECK_TEXT]);

#ifdef __cplusplus
}
#endif
