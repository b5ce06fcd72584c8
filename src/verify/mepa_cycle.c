// The hysteretic law of mepa along a path, on each branch of it.
#include <math.h>
#include <stdio.h>

#include "verify/cycle.h"
#include "verify/suite.h"

#define RADIUS 3.175e-3 ///< m, docs/theory/copper-ore.md
#define STEP 2e-8       ///< s
#define LEGS 16
#define LEG_OF_MAXIMUM 3 ///< its end is at d_max
#define LEG_OF_PULL 8    ///< its end is the largest pull after the first loading
#define BY_HAND "check values of docs/theory/mepa.md, worked out by hand"
#define EQUATIONS "Del Cid & Mustoe, eq. (1)-(4), taken branch by branch"
#define SHAPE "docs/theory/mepa.md, Consequences"

/** A law, and what docs/theory/mepa.md lists for it; NAN: not listed. */
typedef struct cycle {
    const char *name;
    double exponent, k1, k2, k_adh; ///< N/m^n
    double overlap;                 ///< d_max [m]
    double pull_overlap, pull;      ///< of the largest pull [m], [N]
    double force[LEGS];             ///< at the end of each leg [N]
} cycle;

/**
 * Overlap over d_max at the end of each leg: load, unload, reload on k2 and back, on to the
 * largest pull (put in for 0) and down f3, reload from there past the old maximum, pull off
 * over f3, and meet again with nothing remembered.
 */
static const double PATH[LEGS] = {0.25, 0.50, 0.75, 1.00, 0.95, 0.90,  0.97, 0.90,
                                  0.0,  0.60, 0.70, 1.10, 0.50, -0.10, 0.25, -0.10};

// Leg 12 is k1 (3.3e-6 m)^1.5 = 2.847505 N; docs/theory/mepa.md lists it with one digit less.
static const cycle CYCLES[] = {
    {"mepa-cycle-5",
     1.5,
     4.75e8,
     2.37e9,
     3.56e8,
     3e-6,
     2.354201e-6,
     -1.285924,
     {0.308522, 0.872631, 1.603125, 2.468172, 1.556200, 0.667921, NAN, 0.667921, -1.285924,
      -0.859723, 0.629195, 2.847505, -0.654014, 0.0, 0.308522, 0.0}},
    {"mepa-cycle-8",
     1.5,
     4.75e8,
     2.37e9,
     5.93e8,
     3e-6,
     2.226929e-6,
     -1.970671,
     {0.308522, 0.872631, 1.603125, 2.468172, 1.556200, 0.667921, NAN, 0.667921, -1.970671,
      -1.432067, 0.0568512, 2.847505, -1.089411, 0.0, 0.308522, 0.0}},
    {"mepa-cycle-linear-5",
     1.0,
     4.75e8,
     2.37e9,
     3.56e8,
     1e-6,
     NAN,
     -247.47616,
     {NAN, NAN, NAN, 475.0, NAN, NAN, NAN, NAN, -247.47616, NAN, 23.4, NAN, NAN, 0.0, NAN,
      0.0}},
    {"mepa-cycle-linear-8",
     1.0,
     4.75e8,
     2.37e9,
     5.93e8,
     1e-6,
     NAN,
     -379.25582,
     {NAN, NAN, NAN, 475.0, NAN, NAN, NAN, NAN, -379.25582, NAN, -118.8, NAN, NAN, 0.0, NAN,
      0.0}},
};
#define CYCLE_COUNT (sizeof CYCLES / sizeof *CYCLES)

/** d_min/d_max after loading to d_max. */
static double pull_off_ratio(const cycle *c)
{
    return pow((c->k2 - c->k1) / (c->k2 + c->k_adh), 1.0 / c->exponent);
}

static double path_overlap(const cycle *c, int leg)
{
    return c->overlap * (leg == LEG_OF_PULL ? pull_off_ratio(c) : PATH[leg]);
}

/** Eq. (1)-(4) as printed: three branches and a choice; no overlap: all is forgotten. */
static double printed_force(const void *law, double overlap, double *plastic)
{
    const cycle *c = law;
    if (overlap <= 0.0) {
        *plastic = 0.0;
        return 0.0;
    }
    const double x = pow(overlap, c->exponent);
    const double f1 = c->k1 * x;
    const double f2 = c->k2 * (x - *plastic);
    const double f3 = -c->k_adh * x;
    if (f2 >= f1) {
        *plastic = x - f1 / c->k2;
        return f1;
    }
    if (f3 >= f2) {
        *plastic = x - f3 / c->k2;
        return f3;
    }
    return f2;
}

static bool check_shape(const clod_verify_bench *bench, const cycle *c,
                        const clod_verify_cycle_found *found, clod_status *status)
{
    const double ratio = c->k_adh / c->k1 * (c->k2 - c->k1) / (c->k2 + c->k_adh);
    const clod_verify_expect overlap = {pull_off_ratio(c), 1e-6, true, SHAPE};
    const clod_verify_expect pull = {ratio, 1e-6, true, SHAPE};
    const clod_verify_expect listed = {c->pull_overlap, 1e-6, true, BY_HAND};
    return clod_verify_bench_check(bench, &overlap, found->pull_overlap / c->overlap, status,
                                   "%s: d_min/d_max of the largest pull [1]", c->name) &&
           clod_verify_bench_check(bench, &pull, -found->pull / found->end[LEG_OF_MAXIMUM],
                                   status, "%s: largest pull over f_max [1]", c->name) &&
           (isnan(c->pull_overlap) ||
            clod_verify_bench_check(bench, &listed, found->pull_overlap, status,
                                    "%s: overlap of the largest pull [m]", c->name));
}

static bool run_cycle(const clod_verify_bench *bench, const cycle *c, clod_status *status)
{
    char contact[256];
    snprintf(contact, sizeof contact,
             "law: mepa, exponent: %.17g, k1: %.17g N/m^%g, k2: %.17g N/m^%g, "
             "k_adh: %.17g N/m^%g, restitution: 1, friction: 0, rolling: none",
             c->exponent, c->k1, c->exponent, c->k2, c->exponent, c->k_adh, c->exponent);
    clod_verify_cycle run = {.name = c->name,
                             .title = "mepa along a path: a grain between two planes",
                             .contact = contact,
                             .radius = RADIUS,
                             .density = 2481.3,
                             .step = STEP,
                             .largest = c->overlap,
                             .largest_force = c->k1 * pow(c->overlap, c->exponent),
                             .law = printed_force,
                             .law_data = c,
                             .law_source = EQUATIONS,
                             .leg_count = LEGS,
                             .pull_legs = LEG_OF_PULL + 2};
    for (int l = 0; l < LEGS; l++) { // a listed digit may be rounded
        const double rounding = 1e-6 * fmax(1.0, fabs(c->force[l]));
        run.legs[l] =
            (clod_verify_leg){path_overlap(c, l), {c->force[l], rounding, false, BY_HAND}};
    }
    clod_verify_cycle_found found;
    return clod_verify_cycle_run(bench, &run, &found, status) &&
           check_shape(bench, c, &found, status);
}

bool clod_verify_mepa_cycle(const clod_verify_bench *bench, clod_status *status)
{
    bool ok = true;
    for (size_t k = 0; ok && k < CYCLE_COUNT; k++) {
        ok = run_cycle(bench, &CYCLES[k], status);
    }
    return ok;
}
