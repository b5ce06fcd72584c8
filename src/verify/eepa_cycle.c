// EEPA along a path, on each branch of it: with a constant pull, with surface energy, with
// both.
#include <float.h>
#include <math.h>
#include <stdio.h>

#include "verify/cycle.h"
#include "verify/suite.h"

#define RADIUS 3.175e-3 ///< m, docs/theory/copper-ore.md; R* at a wall
#define STEP 2e-8       ///< s
#define BISECTIONS 60   ///< halvings of the search for P: to the last bit
#define LEGS 14
#define LEG_OF_MAXIMUM 2 ///< its end is at d_max
#define PULL_LEGS 8      ///< the largest pull is the one after the first loading
#define EQUATIONS                                                                              \
    "Thakur et al. 2014, eq. (5), and the patch of docs/theory/eepa.md, branch by branch"
#define BY_HAND "worked out by hand in src/verify/eepa_cycle.c"
#define CLOSED "largest pull: P - F(P)/k2, docs/theory/eepa.md"

/** The numbers of a contact. */
typedef struct numbers {
    double n;             ///< exponent
    double k1, k2, k_adh; ///< N/m^n
    double first;         ///< -f0 [N]
    double patch, pull; ///< a plastic overlap [m] and its pull [N], which say what the surface
                        ///< energy is; 0: k_adh counts
} numbers;

typedef struct point {
    double at;    ///< overlap^power at its end [m^power]; below 0: apart
    double force; ///< there, by hand [N]; NAN: not worked out
} point;

#define PULL 0.0 // in the place of an overlap: that of the largest pull

typedef struct cycle {
    const char *name;
    numbers law;
    double power; ///< of the overlaps of the path
    double off;   ///< the listed forces may be off by so much, being rounded [N]
    point path[LEGS];
} cycle;

/**
 * Each path loads to d_max, unloads, reloads on k2 and back, goes on to the largest pull and
 * down the pull-off line, reloads from there in part and past, comes far down that line, lets
 * go, and meets again with nothing remembered.
 *
 * eepa-cycle-pull: the ore with 5 % (n = 3/2) and f0 = -0.05 N. Forces are those that
 * docs/theory/mepa.md lists for mepa, less 0.05 N.
 *
 * eepa-cycle-energy-linear: n = 1, k2 = 4e6, k1 = 1e6 N/m, and 2 N for a plastic overlap dp of
 * 3 um, that of d_max = 4 um. Largest pull 2 N at dp - 2/k2 = 2.5 um. A quarter of dp has half
 * the pull: 1 N at 0.75 - 0.25 = 0.5 um; from there a k2 line from dp = 0.75 um, back on k1 at
 * 1 um. Far out dp = 3/64 um has 2/8 N, but at most k2 dp/2 = 3/32 N, at dp/2.
 *
 * eepa-cycle-energy: n = 3/2, k2 = 1e9, k1 = 2.5e8 N/m^1.5, and 2 N for dp = 4 um, P = 8e-9, so
 * d_max^1.5 = 8e-9/0.75; largest pull at P - 2e-9. dp = 2.25 um has 3/4 of the radius, 1.5 N,
 * and P = 3.375e-9, so 1.5 N at 1.875e-9; from there k2 (2.5e-9 - 3.375e-9) = -0.875 N at
 * 2.5e-9, back on k1 at 4.5e-9. dp = 0.04 um has 0.2 N, but at most k2 P/2 = 4e-3 N, at 4e-12.
 *
 * eepa-cycle-both: eepa-cycle-energy-linear with f0 = -0.25 N.
 */
static const cycle CYCLES[] = {
    {"eepa-cycle-pull",
     {1.5, 4.75e8, 2.37e9, 3.56e8, 0.05, 0.0, 0.0},
     1.0,
     1e-6,
     {{0.75e-6, 0.258522},
      {1.50e-6, 0.822631},
      {3.00e-6, 2.418172},
      {2.85e-6, 1.506200},
      {2.91e-6, NAN},
      {2.70e-6, 0.617921},
      {PULL, -1.335924},
      {1.80e-6, -0.909723},
      {2.10e-6, 0.579195},
      {3.30e-6, 2.797505},
      {1.50e-6, -0.704014},
      {-0.3e-6, 0.0},
      {0.75e-6, 0.258522},
      {-0.3e-6, 0.0}}},
    {"eepa-cycle-energy-linear",
     {1.0, 1e6, 4e6, 0.0, 0.0, 3e-6, 2.0},
     1.0,
     0.0,
     {{1e-6, 1.0},
      {2e-6, 2.0},
      {4e-6, 4.0},
      {3.5e-6, 2.0},
      {3.75e-6, 3.0},
      {2.75e-6, -1.0},
      {PULL, -2.0},
      {0.5e-6, -1.0},
      {0.6e-6, -0.6},
      {1.2e-6, 1.2},
      {1.5e-6 / 64.0, -3.0 / 32.0},
      {-0.3e-6, 0.0},
      {1e-6, 1.0},
      {-0.3e-6, 0.0}}},
    {"eepa-cycle-energy",
     {1.5, 2.5e8, 1e9, 0.0, 0.0, 4e-6, 2.0},
     1.5,
     0.0,
     {{1e-9, 0.25},
      {4e-9, 1.0},
      {8e-9 / 0.75, 8.0 / 3.0},
      {9e-9, 1.0},
      {10e-9, 2.0},
      {7e-9, -1.0},
      {PULL, -2.0},
      {1.875e-9, -1.5},
      {2.5e-9, -0.875},
      {5e-9, 1.25},
      {4e-12, -4e-3},
      {-1e-9, 0.0},
      {1e-9, 0.25},
      {-1e-9, 0.0}}},
    {"eepa-cycle-both",
     {1.0, 1e6, 4e6, 0.0, 0.25, 3e-6, 2.0},
     1.0,
     0.0,
     {{1e-6, 0.75},
      {2e-6, 1.75},
      {4e-6, 3.75},
      {3.5e-6, 1.75},
      {3.75e-6, 2.75},
      {2.75e-6, -1.25},
      {PULL, -2.25},
      {0.5e-6, -1.25},
      {0.6e-6, -0.85},
      {1.2e-6, 0.95},
      {1.5e-6 / 64.0, -11.0 / 32.0},
      {-0.3e-6, 0.0},
      {1e-6, 0.75},
      {-0.3e-6, 0.0}}},
};
#define CYCLE_COUNT (sizeof CYCLES / sizeof *CYCLES)

/** Pull of the patch of a contact, beyond f0 [N]; it goes with the root of dp. */
static double patch_pull(const numbers *law, double plastic)
{
    const double overlap = pow(plastic, 1.0 / law->n);
    return fmin(law->pull * sqrt(overlap / law->patch), 0.5 * law->k2 * plastic);
}

/** The pull-off line at x = overlap^n: F of the P with P - F(P)/k2 = x, found by halving. */
static double pull_off(const numbers *law, double x)
{
    if (law->pull == 0.0) {
        return law->k_adh * x;
    }
    double low = x;
    double high = 2.0 * x;
    for (int k = 0; k < BISECTIONS; k++) {
        const double middle = 0.5 * (low + high);
        const bool below = middle - patch_pull(law, middle) / law->k2 < x;
        low = below ? middle : low;
        high = below ? high : middle;
    }
    return patch_pull(law, 0.5 * (low + high));
}

/** Thakur's eq. (5): three branches and a choice, all less the first pull. */
static double printed_force(const void *data, double overlap, double *plastic)
{
    const numbers *law = data;
    if (overlap <= 0.0) {
        *plastic = 0.0;
        return 0.0;
    }
    const double x = pow(overlap, law->n);
    const double f1 = law->k1 * x;
    const double f2 = law->k2 * (x - *plastic);
    const double f3 = -pull_off(law, x);
    if (f2 >= f1) {
        *plastic = x - f1 / law->k2;
        return f1 - law->first;
    }
    if (f3 >= f2) {
        *plastic = x - f3 / law->k2;
        return f3 - law->first;
    }
    return f2 - law->first;
}

/** Overlap of the largest pull after d_max [m], and that pull, f0 with it [N]. */
static double largest_pull(const numbers *law, double largest, double *pull)
{
    const double plastic = (1.0 - law->k1 / law->k2) * pow(largest, law->n);
    const double x = law->pull > 0.0 ? plastic - patch_pull(law, plastic) / law->k2
                                     : plastic / (1.0 + law->k_adh / law->k2);
    *pull = law->k2 * (plastic - x) + law->first;
    return pow(x, 1.0 / law->n);
}

static double overlap_of(const cycle *c, int leg)
{
    const double at = c->path[leg].at;
    return copysign(pow(fabs(at), 1.0 / c->power), at);
}

/**
 * Legs of the path. The overlap is a difference of lengths of the size of R, rounded twice, and
 * the way of the planes a sum with a rounding in each step: the tolerance is what that does on
 * the steepest line.
 */
static void make_legs(const cycle *c, clod_verify_cycle *run)
{
    const double unit = 0.5 * DBL_EPSILON;
    const double steps = LEGS * CLOD_VERIFY_LEG_STEPS;
    const double rounding = unit * (2.0 * RADIUS + steps * run->largest);
    const double steepest = c->law.n * c->law.k2 * pow(run->largest, c->law.n - 1.0);
    for (int l = 0; l < LEGS; l++) {
        double pull;
        const double at = c->path[l].at == PULL ? largest_pull(&c->law, run->largest, &pull)
                                                : overlap_of(c, l);
        const double off = at > 0.0 ? steepest * rounding + c->off : 0.0;
        run->legs[l] = (clod_verify_leg){at, {c->path[l].force, off, false, BY_HAND}};
    }
    run->leg_count = LEGS;
}

static bool check_pull(const clod_verify_bench *bench, const cycle *c,
                       const clod_verify_cycle *run, const clod_verify_cycle_found *found,
                       clod_status *status)
{
    double pull;
    const clod_verify_expect at = {largest_pull(&c->law, run->largest, &pull), 1e-9, true,
                                   CLOSED};
    const clod_verify_expect most = {-pull, 1e-9, true, CLOSED};
    return clod_verify_bench_check(bench, &at, found->pull_overlap, status,
                                   "%s: overlap of the largest pull [m]", c->name) &&
           clod_verify_bench_check(bench, &most, found->pull, status, "%s: largest pull [N]",
                                   c->name);
}

/** The keys of the pair; 3/2 pi gamma sqrt(2 R* dp) is the pull of the patch. */
static void put_contact(const numbers *law, char *text, size_t size)
{
    char adhesion[128];
    if (law->pull > 0.0) {
        snprintf(adhesion, sizeof adhesion, "surface_energy: %.17g J/m2",
                 law->pull / (1.5 * M_PI * sqrt(2.0 * RADIUS * law->patch)));
    } else {
        snprintf(adhesion, sizeof adhesion, "k_adh: %.17g N/m^%g", law->k_adh, law->n);
    }
    snprintf(text, size,
             "law: eepa, exponent: %.17g, k1: %.17g N/m^%g, k2: %.17g N/m^%g, %s, "
             "pull_off_force: %.17g N, restitution: 1, friction: 0, rolling: none",
             law->n, law->k1, law->n, law->k2, law->n, adhesion, law->first);
}

static bool run_cycle(const clod_verify_bench *bench, const cycle *c, clod_status *status)
{
    char contact[512];
    put_contact(&c->law, contact, sizeof contact);
    const double largest = overlap_of(c, LEG_OF_MAXIMUM);
    clod_verify_cycle run = {.name = c->name,
                             .title = "eepa along a path: a grain between two planes",
                             .contact = contact,
                             .radius = RADIUS,
                             .density = 2481.3,
                             .step = STEP,
                             .largest = largest,
                             .largest_force = c->law.k1 * pow(largest, c->law.n),
                             .law = printed_force,
                             .law_data = &c->law,
                             .law_source = EQUATIONS,
                             .pull_legs = PULL_LEGS};
    make_legs(c, &run);
    clod_verify_cycle_found found;
    return clod_verify_cycle_run(bench, &run, &found, status) &&
           check_pull(bench, c, &run, &found, status);
}

bool clod_verify_eepa_cycle(const clod_verify_bench *bench, clod_status *status)
{
    bool ok = true;
    for (size_t k = 0; ok && k < CYCLE_COUNT; k++) {
        ok = run_cycle(bench, &CYCLES[k], status);
    }
    return ok;
}
