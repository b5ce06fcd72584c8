// Restitution of the hysteretic law of mepa alone: collisions of two grains without dash-pot,
// with k_adh from none to beyond the threshold at which they stick.
#include <math.h>
#include <stdio.h>

#include "verify/hertz.h"
#include "verify/impact.h"
#include "verify/suite.h"

#define RADIUS 3.175e-3 ///< m, docs/theory/copper-ore.md
#define DENSITY 2481.3  ///< kg/m3, docs/theory/copper-ore.md
#define SPEED 0.1       ///< of approach [m/s]; the restitution does not depend on it
#define RATIO 0.2       ///< k1/k2
#define LOADING 2000.0  ///< steps of loading
#define RUN_LENGTH 20.0 ///< times the loading: a slow grain takes long to get away
#define ENERGY "energy integral of eq. (1)-(3), by hand in src/verify/mepa_restitution.c"

/** k_adh over its threshold. */
static const double SHARES[] = {0.0, 0.25, 0.5, 0.75, 0.9, 0.95, 0.99, 1.01, 1.1, 1.5};
#define SHARE_COUNT ((int)(sizeof SHARES / sizeof *SHARES))

typedef struct family {
    const char *name;
    double exponent, k2; ///< N/m^n
    double threshold;    ///< k_adh/k2 at which the restitution is 0, for k1/k2 = 0.2
} family;

/**
 * n = 1: 1 + k_adh/k2 = s^2/(2 s - 1) with s = 1 - k1/k2, so 1/15. n = 3/2: the zero of the
 * energy integral below, found by hand: 0.0516273.
 */
static const family FAMILIES[] = {
    {"mepa-restitution-linear", 1.0, 2.37e6, 1.0 / 15.0},
    {"mepa-restitution", 1.5, 2.37e9, 0.0516273},
};

/**
 * e^2: work given back over work taken, both in units of k2 d_max^(n+1). With s = 1 - k1/k2 and
 * a = k_adh/k2, loading takes (1 - s)/(n + 1); the k2 line gives back int (x^n - s) dx from
 * d_min to 1, d_min = (s/(1 + a))^(1/n); the adhesive branch takes a d_min^(n+1)/(n + 1).
 */
static double squared_restitution(double n, double a)
{
    const double s = 1.0 - RATIO;
    const double low = pow(s / (1.0 + a), 1.0 / n);
    const double given = (1.0 - pow(low, n + 1.0)) / (n + 1.0) - s * (1.0 - low);
    const double taken = a * pow(low, n + 1.0) / (n + 1.0);
    return (given - taken) * (n + 1.0) / RATIO;
}

/** Time from touch to d_max on the virgin branch, k1 d^n: d_max/v int_0^1 dx/sqrt(1-x^(n+1)).
 */
static double loading_time(const family *f)
{
    const double p = f->exponent + 1.0;
    const double mass = 0.5 * clod_verify_hertz_sphere(DENSITY, RADIUS);
    const double d = pow(0.5 * p * mass * SPEED * SPEED / (RATIO * f->k2), 1.0 / p);
    return d / SPEED * sqrt(M_PI) * tgamma(1.0 + 1.0 / p) / tgamma(0.5 + 1.0 / p);
}

/** One pair of grains for each k_adh, each of a material of its own, in a row. */
static void make_deck(const family *f, clod_verify_deck *deck, clod_verify_impact *impacts)
{
    deck->step = loading_time(f) / LOADING;
    clod_verify_deck_stage(deck, (clod_verify_stage){.duration = RUN_LENGTH * loading_time(f)});
    clod_verify_deck_contact(deck, "default",
                             "law: mepa, exponent: %.17g, k1: %.17g N/m^%g, k2: %.17g N/m^%g, "
                             "restitution: 1, friction: 0, rolling: none",
                             f->exponent, RATIO * f->k2, f->exponent, f->k2, f->exponent);
    for (int k = 0; k < SHARE_COUNT; k++) {
        char name[CLOD_VERIFY_NAME];
        char pair[2 * CLOD_VERIFY_NAME];
        snprintf(name, sizeof name, "a%.0f", 100.0 * SHARES[k]);
        snprintf(pair, sizeof pair, "%s-%s", name, name);
        clod_verify_deck_material(deck, name, DENSITY, 0.0, 0.0);
        clod_verify_deck_contact(deck, pair, "k_adh: %.17g N/m^%g",
                                 SHARES[k] * f->threshold * f->k2, f->exponent);
        const double across = 4.0 * RADIUS * (k - 0.5 * (SHARE_COUNT - 1));
        const double before = 0.5 * SPEED * 20.5 * deck->step;
        impacts[k] = (clod_verify_impact){.a = deck->grain_count, .b = deck->grain_count + 1};
        for (int side = -1; side <= 1; side += 2) {
            clod_verify_grain *grain = clod_verify_deck_grain(
                deck, name, RADIUS, (clod_vec3){0.0, across, side * (RADIUS + before)});
            grain->velocity.z = -0.5 * side * SPEED;
        }
    }
}

static bool check_share(const clod_verify_bench *bench, const family *f, int k,
                        const clod_verify_impact *impact, clod_status *status)
{
    const bool sticks = SHARES[k] > 1.0;
    const double got = (impact->v[1].z - impact->v[0].z) / SPEED;
    const clod_verify_expect apart = {sticks ? 0.0 : 1.0, 0.0, false, ENERGY};
    const double squared = squared_restitution(f->exponent, SHARES[k] * f->threshold);
    const clod_verify_expect back = {sqrt(fmax(squared, 0.0)), 1e-3, true, ENERGY};
    return clod_verify_bench_check(bench, &apart, impact->apart ? 1.0 : 0.0, status,
                                   "%s: they part at k_adh = %g of the threshold (1: yes)",
                                   f->name, SHARES[k]) &&
           (sticks || clod_verify_bench_check(
                          bench, &back, got, status,
                          "%s: restitution at k_adh = %g of the threshold, in %lld steps [1]",
                          f->name, SHARES[k], (long long)impact->steps));
}

static bool run_family(const clod_verify_bench *bench, const family *f, clod_status *status)
{
    clod_verify_deck deck = {.name = f->name, .title = "mepa alone: collisions of two grains"};
    clod_verify_impact impacts[SHARE_COUNT];
    const clod_verify_frame plain = clod_verify_frame_plain();
    make_deck(f, &deck, impacts);
    if (!clod_verify_impact_run(bench, &deck, &plain, impacts, SHARE_COUNT, status)) {
        return false;
    }
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, f->name, "k_adh over k2 [1],clod: restitution [1],closed form: restitution [1]",
        status);
    bool ok = curve != NULL;
    for (int k = 0; ok && k < SHARE_COUNT; k++) {
        const double a = SHARES[k] * f->threshold;
        const double got =
            impacts[k].apart ? (impacts[k].v[1].z - impacts[k].v[0].z) / SPEED : 0.0;
        const double row[] = {a, got, sqrt(fmax(squared_restitution(f->exponent, a), 0.0))};
        clod_verify_curve_add(curve, row, 3);
        ok = check_share(bench, f, k, &impacts[k], status);
    }
    return clod_verify_curve_close(&curve, status) && ok;
}

bool clod_verify_mepa_restitution(const clod_verify_bench *bench, clod_status *status)
{
    return run_family(bench, &FAMILIES[0], status) && run_family(bench, &FAMILIES[1], status);
}
