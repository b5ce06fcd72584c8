// Luding's law along a path, on each branch of it, below and beyond the limit overlap.
#include <math.h>
#include <stdio.h>

#include "verify/cycle.h"
#include "verify/luding.h"
#include "verify/suite.h"

#define RADIUS 0.5 ///< m; 2 R* at a wall is 1 m
#define STEP 1e-4  ///< s
#define FORMS "Luding 2008, closed forms in src/verify/luding.c"
#define PRINTED "Luding 2008, taken branch by branch in src/verify/luding.c"

/** k1, k2, k_adh and phi_f of MercuryDPM's test of the law; d* is 1/16 m. */
static const clod_verify_luding LAW = {
    .k1 = 100.0, .k2 = 500.0, .k_adh = 100.0, .depth = 0.05, .diameter = 2.0 * RADIUS};

/** A first maximum. */
typedef struct cycle {
    const char *name;
    double largest; ///< d_max over d*
} cycle;

static const cycle CYCLES[] = {{"luding-cycle", 0.6}, {"luding-cycle-limit", 1.4}};

/** Where a leg ends. */
typedef enum branch {
    LOADING,  ///< on k1, or beyond d* on the limit branch
    HALF,     ///< on the k2 line of half of d_max
    FULL,     ///< on the k2 line of d_max
    PULL,     ///< where that meets the adhesive branch
    ADHESIVE, ///< on the adhesive branch
    RELOAD,   ///< on the k2 line that begins where the leg before ended
    APART,
} branch;

typedef struct leg {
    double overlap; ///< at its end, over d_max
    branch on;
} leg;

static const leg PATH[] = {{0.50, LOADING},  {0.40, HALF},    {0.75, LOADING}, {1.00, LOADING},
                           {0.90, FULL},     {0.97, FULL},    {0.85, FULL},    {0.0, PULL},
                           {0.30, ADHESIVE}, {0.50, RELOAD},  {1.10, LOADING}, {0.45, ADHESIVE},
                           {-0.10, APART},   {0.25, LOADING}, {-0.10, APART}};
#define LEGS ((int)(sizeof PATH / sizeof *PATH))
#define PULL_LEGS 9 ///< the largest pull is the one after the first loading

static clod_verify_expect within(double force, double tolerance)
{
    return (clod_verify_expect){force, fabs(tolerance), false, FORMS};
}

/**
 * Force at the end of a leg. Down the adhesive branch the law goes by steps, and may be late
 * by one: the tolerance is what that changes.
 *
 * @param at       the overlap there [m]
 * @param reached  the overlap at the end of the leg before [m]
 * @param step     change of the overlap in a step: ADHESIVE in this leg, RELOAD in that
 */
static clod_verify_expect expect(branch on, double at, double reached, double step,
                                 double largest)
{
    const double rounding = 1e-12 * LAW.k2 * at;
    const double limit = clod_verify_luding_limit(&LAW);
    double force = 0.0;
    double late = 0.0;
    switch (on) {
    case LOADING:
        force = at > limit ? clod_verify_luding_elastic(&LAW, at, limit) : LAW.k1 * at;
        return within(force, rounding);
    case HALF:
        return within(clod_verify_luding_elastic(&LAW, at, 0.5 * largest), rounding);
    case FULL:
        return within(clod_verify_luding_elastic(&LAW, at, largest), rounding);
    case PULL:
        return within(-LAW.k_adh * at, rounding);
    case ADHESIVE:
        return within(-LAW.k_adh * at, (LAW.k2 + LAW.k_adh) * step);
    case RELOAD:
        late = clod_verify_luding_left(&LAW, reached + step);
        force = clod_verify_luding_elastic(&LAW, at, clod_verify_luding_left(&LAW, reached));
        return within(force, clod_verify_luding_elastic(&LAW, at, late) - force);
    default:
        return within(0.0, 0.0);
    }
}

static void make_legs(clod_verify_cycle *run)
{
    double before = 0.0;
    double step = 0.0;
    for (int l = 0; l < LEGS; l++) {
        const branch on = PATH[l].on;
        const double at = on == PULL ? clod_verify_luding_pull(&LAW, run->largest)
                                     : PATH[l].overlap * run->largest;
        step = on == RELOAD ? step : (at - before) / CLOD_VERIFY_LEG_STEPS;
        run->legs[l] = (clod_verify_leg){at, expect(on, at, before, step, run->largest)};
        before = at;
    }
    run->leg_count = LEGS;
}

static bool check_pull(const clod_verify_bench *bench, const clod_verify_cycle *run,
                       const clod_verify_cycle_found *found, clod_status *status)
{
    const double at = clod_verify_luding_pull(&LAW, run->largest);
    const clod_verify_expect overlap = {at, 1e-12, true, FORMS};
    const clod_verify_expect pull = {-LAW.k_adh * at, 1e-12, true, FORMS};
    return clod_verify_bench_check(bench, &overlap, found->pull_overlap, status,
                                   "%s: overlap of the largest pull [m]", run->name) &&
           clod_verify_bench_check(bench, &pull, found->pull, status, "%s: largest pull [N]",
                                   run->name);
}

static bool run_cycle(const clod_verify_bench *bench, const cycle *c, clod_status *status)
{
    char contact[256];
    snprintf(contact, sizeof contact,
             "law: luding, k1: %.17g N/m, k2: %.17g N/m, k_adh: %.17g N/m, plasticity_depth: "
             "%.17g, restitution: 1, friction: 0, rolling: none",
             LAW.k1, LAW.k2, LAW.k_adh, LAW.depth);
    const double largest = c->largest * clod_verify_luding_limit(&LAW);
    clod_verify_cycle run = {.name = c->name,
                             .title = "luding along a path: a grain between two planes",
                             .contact = contact,
                             .radius = RADIUS,
                             .density = 2000.0,
                             .step = STEP,
                             .largest = largest,
                             .largest_force = LAW.k2 * largest,
                             .law = clod_verify_luding_force,
                             .law_data = &LAW,
                             .law_source = PRINTED,
                             .pull_legs = PULL_LEGS};
    make_legs(&run);
    clod_verify_cycle_found found;
    return clod_verify_cycle_run(bench, &run, &found, status) &&
           check_pull(bench, &run, &found, status);
}

bool clod_verify_luding_cycle(const clod_verify_bench *bench, clod_status *status)
{
    return run_cycle(bench, &CYCLES[0], status) && run_cycle(bench, &CYCLES[1], status);
}
