/**
 * @file repose.c
 * Angle of repose against friction and rolling friction: grains behind a gate on a ledge, 20
 * grains long and rough; the gate is lifted, what lies too steep drains over the edge, and the
 * slope that stays is measured by regression. Periodic across, so walls hold nothing; gate and
 * back wall are without friction.
 *
 * Both frictions raise the angle: Zhou, Xu, Yu & Zulli, Phys. Rev. E 64, 021301 (2001). Smooth
 * spheres stand at 23 degrees: Albert, Albert, Hornbaker, Schiffer & Barabasi, Phys. Rev. E 56,
 * R6271 (1997).
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "measure/contacts.h"
#include "verify/bed.h"
#include "verify/profile.h"
#include "verify/suite.h"

#define DIAMETER 5e-3            ///< m, mean of the grains: d
#define LENGTH (20.0 * DIAMETER) ///< m, of the ledge, along x
#define DEPTH (8.0 * DIAMETER)   ///< m, of the period, along y
#define COLUMN (30.0 * DIAMETER) ///< m, height up to which grains are put
#define PIT (16.0 * DIAMETER)    ///< m, how deep it is
#define WIDE (40.0 * DIAMETER)   ///< m, how wide the pit is
#define BAR (0.5 * DIAMETER)     ///< m, across the bars of the ledge, and their height
#define PITCH (1.5 * DIAMETER)   ///< m, from bar to bar
#define BARS 13
#define COLUMNS 15             ///< of the slope, one grain wide, from x = 2 d
#define LEAST (2.0 * DIAMETER) ///< m, lower columns are the foot of the heap
#define GRAINS 3100
#define LOOKS 11    ///< over 0.1 s
#define LIFT 0.5    ///< m/s, of the gate
#define FRICTIONS 3 ///< values
#define ROLLINGS 3  ///< values
#define SEEDS 2
#define SIGNIFICANT 2.0 ///< standard errors

static const double FRICTION[FRICTIONS] = {0.2, 0.4, 0.8};
static const double ROLLING[ROLLINGS] = {0.0, 0.05, 0.2};

/** Of smooth spheres: friction 0.4, no rolling friction. */
#define GLASS_FRICTION 1
#define GLASS_ROLLING 0

/** One heap at rest. */
typedef struct heap {
    double angle[LOOKS]; ///< degrees, of the last looks, the newest first
    double overlap;      ///< mean, over a radius
} heap;

/** All of them. */
typedef struct heaps {
    heap of[FRICTIONS][ROLLINGS][SEEDS];
    double angle[FRICTIONS][ROLLINGS]; ///< degrees, mean over seeds
    double error; ///< degrees, standard error of such a mean, from the scatter between seeds
} heaps;

/** Bars across the ledge, as shapes of a wall. */
static void put_bars(FILE *out)
{
    for (int b = 0; b < BARS; b++) {
        const double x = PITCH * (b + 0.5);
        fprintf(out,
                "      - bar: {from: [%g m, %g m, 0 m], to: [%g m, %g m, 0 m], width: %g m, "
                "height: %g m}\n",
                x, -DIAMETER, x, DEPTH + DIAMETER, BAR, 2.0 * BAR);
    }
}

static void put_walls(FILE *out)
{
    fprintf(out,
            "walls:\n"
            "  back:\n"
            "    material: smooth\n"
            "    shapes: [{plane: {point: [0 m, 0 m, 0 m], normal: [1, 0, 0]}}]\n"
            "  gate:\n"
            "    material: smooth\n"
            "    shapes: [{box: {center: [%g m, %g m, %g m], size: [%g m, %g m, %g m]}}]\n"
            "  pit:\n"
            "    material: rough\n"
            "    shapes:\n"
            "      - plane: {point: [0 m, 0 m, %g m], normal: [0, 0, 1]}\n"
            "      - plane: {point: [%g m, 0 m, 0 m], normal: [-1, 0, 0]}\n"
            "  ledge:\n"
            "    material: rough\n"
            "    shapes:\n"
            "      - box: {center: [%g m, %g m, %g m], size: [%g m, %g m, %g m]}\n",
            LENGTH + DIAMETER, 0.5 * DEPTH, 0.5 * COLUMN, 2.0 * DIAMETER, 2.0 * DEPTH, COLUMN,
            -PIT, LENGTH + WIDE, 0.5 * LENGTH, 0.5 * DEPTH, -DIAMETER, LENGTH, 2.0 * DEPTH,
            2.0 * DIAMETER);
    put_bars(out);
}

static void put_case(double friction, double rolling, int seed, FILE *out)
{
    fprintf(out,
            "# Written by clod verify.\n"
            "title: Angle of repose, friction %g, rolling friction %g\n"
            "seed: %d\n"
            "domain: {min: [%g m, 0 m, %g m], max: [%g m, %g m, %g m],\n"
            "         periodic: [false, true, false]}\n"
            "materials:\n"
            "  grain: {density: 2500 kg/m3, youngs_modulus: 5 MPa, poissons_ratio: 0.25}\n"
            "  rough: {youngs_modulus: 5 MPa, poissons_ratio: 0.25}\n"
            "  smooth: {youngs_modulus: 5 MPa, poissons_ratio: 0.25}\n"
            "contacts:\n"
            "  default: {law: hertz, restitution: 0.5, friction: %g, rolling: epsd2, "
            "rolling_friction: %g}\n"
            "  grain-rough: {friction: 1, rolling_friction: 0.2}\n"
            "  grain-smooth: {friction: 0, rolling_friction: 0}\n"
            "grains:\n"
            "  - material: grain\n"
            "    count: %d\n"
            "    radius: {distribution: uniform, min: %g m, max: %g m}\n"
            "    region: {box: {min: [0 m, 0 m, 0 m], max: [%g m, %g m, %g m]}}\n",
            friction, rolling, seed, -DIAMETER, -PIT - DIAMETER, LENGTH + WIDE + DIAMETER,
            DEPTH, 3.0 * COLUMN, friction, rolling, GRAINS, 0.45 * DIAMETER, 0.55 * DIAMETER,
            LENGTH, DEPTH, COLUMN);
    put_walls(out);
    fprintf(out,
            "stages:\n"
            "  - {name: fill, duration: 0.3 s, rest: 20 mm/s}\n"
            "  - {name: lift, duration: %g s, walls: {gate: {velocity: [0 m/s, 0 m/s, "
            "%g m/s]}}}\n"
            "  - {name: rest, duration: 4 s, rest: 20 mm/s, walls: {gate: {velocity: [0 m/s, "
            "0 m/s, 0 m/s]}}}\n"
            "output: {series_interval: 10 ms, snapshot_interval: 0.1 s}\n",
            COLUMN / LIFT, LIFT);
}

/** Slope and overlap now; the last look counts. */
static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    double error; // of the line; the seeds tell more
    heap *self = context;
    const clod_grains *grains = &now->state.grains;
    clod_verify_profile profile = {
        .begin = 2.0 * DIAMETER, .width = DIAMETER, .depth = DEPTH, .count = COLUMNS};
    if (!clod_verify_bed_is_in(now, "rest")) {
        return true;
    }
    clod_verify_profile_find(&profile, (const double(*)[4])grains->position, grains->count);
    memmove(self->angle + 1, self->angle, (LOOKS - 1) * sizeof *self->angle);
    self->angle[0] = clod_verify_profile_angle(&profile, LEAST, &error);
    const bool ok = clod_step_export(&now->step, status);
    self->overlap = clod_measure_contacts_of(&now->state).mean_overlap;
    return ok;
}

static bool run_heap(const clod_verify_bench *bench, double friction, double rolling, int seed,
                     heap *self, clod_status *status)
{
    char name[64];
    clod_text whole;
    FILE *out = clod_text_open(&whole);
    if (out == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for a case");
    }
    put_case(friction, rolling, seed, out);
    snprintf(name, sizeof name, "repose-%g-%g-%d", friction, rolling, seed);
    char *text = clod_text_close(&whole);
    const bool ok = text != NULL
                        ? clod_verify_bed_run(bench, name, text, look, self, status)
                        : clod_status_fail(status, CLOD_FAILED, "no memory for a case");
    clod_memory_free(text);
    return ok;
}

/** Means over the seeds; their error from the scatter between seeds, the same for all heaps. */
static void average(heaps *self)
{
    double variance = 0.0; // of one heap
    for (int f = 0; f < FRICTIONS; f++) {
        for (int r = 0; r < ROLLINGS; r++) {
            const heap *of = self->of[f][r];
            const double half = 0.5 * (of[0].angle[0] - of[1].angle[0]);
            self->angle[f][r] = 0.5 * (of[0].angle[0] + of[1].angle[0]);
            variance += 2.0 * half * half / (FRICTIONS * ROLLINGS);
        }
    }
    self->error = sqrt(variance / SEEDS);
}

/** What does not rise as it should along one friction while the other stays. */
typedef struct faults {
    int falls; ///< neighbours of which the second is lower by more than two errors
    int flat;  ///< rows whose end is not higher than their start by more than two errors
} faults;

static void judge_row(const double *angle, int count, double error, faults *found)
{
    const double limit = SIGNIFICANT * M_SQRT2 * error; // of a difference
    for (int k = 0; k + 1 < count; k++) {
        found->falls += !(angle[k + 1] - angle[k] > -limit);
    }
    found->flat += !(angle[count - 1] - angle[0] > limit);
}

static bool check_rise(const clod_verify_bench *bench, const faults *found, const char *along,
                       const char *beside, double error, clod_status *status)
{
    const clod_verify_expect none = {0.0, 0.0, false, "Zhou et al. 2001: both raise it"};
    return clod_verify_bench_check(bench, &none, found->falls, status,
                                   "neighbours that fall by %.2g deg, two errors of their "
                                   "difference, along %s, any %s",
                                   SIGNIFICANT * M_SQRT2 * error, along, beside) &&
           clod_verify_bench_check(bench, &none, found->flat, status,
                                   "ends that do not rise by two errors, along %s, any %s",
                                   along, beside);
}

static bool check_monotone(const clod_verify_bench *bench, const heaps *self,
                           clod_status *status)
{
    faults friction = {0};
    faults rolling = {0};
    for (int r = 0; r < ROLLINGS; r++) {
        double angle[FRICTIONS];
        for (int f = 0; f < FRICTIONS; f++) {
            angle[f] = self->angle[f][r];
        }
        judge_row(angle, FRICTIONS, self->error, &friction);
    }
    for (int f = 0; f < FRICTIONS; f++) {
        judge_row(self->angle[f], ROLLINGS, self->error, &rolling);
    }
    return check_rise(bench, &friction, "friction", "rolling friction", self->error, status) &&
           check_rise(bench, &rolling, "rolling friction", "friction", self->error, status);
}

/** That heaps are at rest, and grains hard. */
static bool check_rest(const clod_verify_bench *bench, const heaps *self, clod_status *status)
{
    double overlap = 0.0;
    double change = 0.0;
    for (int f = 0; f < FRICTIONS; f++) {
        for (int k = 0; k < ROLLINGS * SEEDS; k++) {
            const heap *of = &self->of[f][k / SEEDS][k % SEEDS];
            overlap = clod_verify_larger(overlap, of->overlap);
            change = clod_verify_larger(change, fabs(of->angle[0] - of->angle[LOOKS - 1]));
        }
    }
    const clod_verify_expect none = {0.0, 0.5, false, "heaps at rest"};
    const clod_verify_expect hard = {0.0, 0.01, false, "hard grains"};
    return clod_verify_bench_check(bench, &none, change, status,
                                   "largest change of an angle in the last 0.1 s [deg]") &&
           clod_verify_bench_check(bench, &hard, overlap, status,
                                   "mean overlap of a heap at rest, over a radius");
}

static bool check_glass(const clod_verify_bench *bench, const heaps *self, clod_status *status)
{
    const clod_verify_expect glass = {23.0, 3.0, false, "smooth spheres: Albert et al. 1997"};
    if (!clod_verify_bench_check(bench, &glass, self->angle[GLASS_FRICTION][GLASS_ROLLING],
                                 status, "angle at friction %g, rolling friction %g [deg]",
                                 FRICTION[GLASS_FRICTION], ROLLING[GLASS_ROLLING])) {
        return false;
    }
    clod_verify_bench_record_miss(bench, "small heaps, two of them, whose mean has a standard "
                                         "error of 0.6 deg and more: 25.0 and 26.1 deg with "
                                         "two sets of last bits");
    return true;
}

static bool write_angles(const clod_verify_bench *bench, const heaps *self, clod_status *status)
{
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, "repose-angles",
        "friction,clod: angle [deg] at rolling friction 0,clod: angle [deg] at rolling "
        "friction 0.05,clod: angle [deg] at rolling friction 0.2",
        status);
    for (int f = 0; curve != NULL && f < FRICTIONS; f++) {
        const double row[] = {FRICTION[f], self->angle[f][0], self->angle[f][1],
                              self->angle[f][2]};
        clod_verify_curve_add(curve, row, 1 + ROLLINGS);
    }
    return curve != NULL && clod_verify_curve_close(&curve, status);
}

bool clod_verify_repose(const clod_verify_bench *bench, clod_status *status)
{
    heaps self = {0};
    for (int f = 0; f < FRICTIONS; f++) {
        for (int r = 0; r < ROLLINGS; r++) {
            for (int s = 0; s < SEEDS; s++) {
                if (!run_heap(bench, FRICTION[f], ROLLING[r], s + 1, &self.of[f][r][s],
                              status)) {
                    return false;
                }
            }
        }
    }
    average(&self);
    return check_monotone(bench, &self, status) && check_glass(bench, &self, status) &&
           check_rest(bench, &self, status) && write_angles(bench, &self, status);
}
