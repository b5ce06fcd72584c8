// Tests 1-3 of Chung & Ooi 2011: normal impacts, elastic and damped.
#include <math.h>
#include <stdio.h>

#include "verify/chung_ooi.h"
#include "verify/suite.h"

// Materials of tests 1, 2 and 3 as published (and repeated by the benchmark decks of Yade).
static const clod_verify_chung_material GLASS = {"glass", 2800.0, 48e9, 0.20};
static const clod_verify_chung_material LIMESTONE = {"limestone", 2500.0, 20e9, 0.25};
static const clod_verify_chung_material AL_ALLOY = {"al_alloy", 2699.0, 70e9, 0.30};
static const clod_verify_chung_material MG_ALLOY = {"mg_alloy", 1800.0, 40e9, 0.35};
static const clod_verify_chung_material AL_OXIDE = {"al_oxide", 4000.0, 380e9, 0.23};
static const clod_verify_chung_material CAST_IRON = {"cast_iron", 7000.0, 100e9, 0.25};

#define HERTZ "Hertz closed form, src/verify/hertz.h; " CLOD_VERIFY_CHUNG

/** Peak force, peak overlap, duration and speed of parting of one elastic impact. */
static bool check_elastic(const clod_verify_bench *bench, const clod_verify_pair *pair,
                          const clod_verify_impact *found, const char *name, double parting,
                          clod_status *status)
{
    const clod_verify_expect force = {clod_verify_hertz_force(pair), 1e-3, true, HERTZ};
    const clod_verify_expect overlap = {clod_verify_hertz_overlap(pair), 1e-3, true, HERTZ};
    const clod_verify_expect time = {clod_verify_hertz_duration(pair), 1e-3, true, HERTZ};
    const clod_verify_expect speed = {pair->speed, 1e-3, true, "energy is kept"};
    return clod_verify_bench_check(bench, &force, found->peak_force, status,
                                   "%s: peak force [N]", name) &&
           clod_verify_bench_check(bench, &overlap, found->peak_overlap, status,
                                   "%s: peak overlap [m]", name) &&
           clod_verify_bench_check(bench, &time, found->end - found->begin, status,
                                   "%s: duration [s]", name) &&
           clod_verify_bench_check(bench, &speed, parting, status, "%s: speed of parting [m/s]",
                                   name);
}

static bool elastic(const clod_verify_bench *bench, const clod_verify_chung *chung,
                    double speed, const char *title, clod_status *status)
{
    char name[64];
    snprintf(name, sizeof name, "%s-%s", bench->test, chung->a->name);
    clod_verify_deck deck = {.name = name, .title = title};
    clod_verify_impact impact;
    const clod_verify_chung_point point = {.normal = speed};
    const clod_verify_pair pair = clod_verify_chung_pair(chung, speed);
    clod_verify_chung_deck(chung, &point, 1, &deck, &impact);
    impact.curve = clod_verify_curve_open(
        bench, name, "overlap [m],clod: force [N],Hertz: force [N]", status);
    impact.hertz = clod_verify_hertz_stiffness(&pair);
    const clod_verify_frame plain = clod_verify_frame_plain();
    bool ok = impact.curve != NULL &&
              clod_verify_impact_run(bench, &deck, &plain, &impact, 1, status);
    ok = clod_verify_curve_close(&impact.curve, status) && ok;
    if (!ok || !clod_verify_impact_frames(bench, &deck, &impact, 1, status)) {
        return false;
    }
    const double v_b = chung->b != NULL ? impact.v[1].z : 0.0;
    return check_elastic(bench, &pair, &impact, chung->a->name, impact.v[0].z - v_b, status);
}

bool clod_verify_chung_ooi_1(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_chung_material *materials[] = {&GLASS, &LIMESTONE};
    for (int k = 0; k < 2; k++) {
        const clod_verify_chung chung = {.a = materials[k],
                                         .b = materials[k],
                                         .radius_a = 0.01,
                                         .radius_b = 0.01,
                                         .share = 0.5,
                                         .restitution = 1.0,
                                         .friction = 0.35};
        if (!elastic(bench, &chung, 20.0,
                     "Chung & Ooi 2011, test 1: two equal spheres, 10 m/s each", status)) {
            return false;
        }
    }
    return true;
}

bool clod_verify_chung_ooi_2(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_chung_material *materials[] = {&AL_ALLOY, &MG_ALLOY};
    for (int k = 0; k < 2; k++) {
        const clod_verify_chung chung = {
            .a = materials[k], .radius_a = 0.1, .restitution = 1.0, .friction = 0.0};
        if (!elastic(bench, &chung, 0.2, "Chung & Ooi 2011, test 2: sphere on a rigid plane",
                     status)) {
            return false;
        }
    }
    return true;
}

#define RESTITUTIONS 5

/** A deck whose spheres differ in their restitution: one material for each. */
static void damped_deck(const clod_verify_chung *chung, const double *asked,
                        clod_verify_deck *deck, clod_verify_impact *impacts)
{
    clod_verify_chung_point points[RESTITUTIONS];
    for (int k = 0; k < RESTITUTIONS; k++) {
        points[k] = (clod_verify_chung_point){.normal = 3.9};
    }
    clod_verify_chung_deck(chung, points, RESTITUTIONS, deck, impacts);
    const clod_verify_chung_material *m = chung->a;
    for (int k = 0; k < RESTITUTIONS; k++) {
        char name[CLOD_VERIFY_NAME];
        char pair[2 * CLOD_VERIFY_NAME];
        snprintf(name, sizeof name, "e%.0f", 100.0 * asked[k]);
        snprintf(pair, sizeof pair, "%s-%s", name, m->name);
        clod_verify_deck_material(deck, name, m->density, 2.0 * m->youngs_modulus,
                                  m->poissons_ratio);
        clod_verify_deck_contact(deck, pair, "restitution: %.17g", asked[k]);
        snprintf(deck->grains[k].material, CLOD_VERIFY_NAME, "%s", name);
    }
}

static bool damped(const clod_verify_bench *bench, const clod_verify_chung_material *sphere,
                   clod_status *status)
{
    const double asked[RESTITUTIONS] = {0.2, 0.4, 0.6, 0.8, 1.0};
    char name[64];
    snprintf(name, sizeof name, "%s-%s", bench->test, sphere->name);
    const clod_verify_chung chung = {.a = sphere, .radius_a = 2.5e-3, .restitution = 1.0};
    clod_verify_deck deck = {.name = name,
                             .title = "Chung & Ooi 2011, test 3: restitution on a rigid plane"};
    clod_verify_impact impacts[RESTITUTIONS];
    damped_deck(&chung, asked, &deck, impacts);
    if (!clod_verify_impact_frames(bench, &deck, impacts, RESTITUTIONS, status)) {
        return false;
    }
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, name,
        "restitution asked for [1],clod: restitution obtained [1],closed form: the same [1]",
        status);
    bool ok = curve != NULL;
    for (int k = 0; ok && k < RESTITUTIONS; k++) {
        const double got = impacts[k].v[0].z / 3.9;
        const double row[] = {asked[k], got, asked[k]};
        const clod_verify_expect same = {asked[k], 1e-3, true,
                                         "e_out = e_in; " CLOD_VERIFY_CHUNG};
        clod_verify_curve_add(curve, row, 3);
        ok = clod_verify_bench_check(bench, &same, impacts[k].apart ? got : 0.0, status,
                                     "%s: restitution in %lld steps [1]", sphere->name,
                                     (long long)impacts[k].steps);
    }
    return clod_verify_curve_close(&curve, status) && ok;
}

bool clod_verify_chung_ooi_3(const clod_verify_bench *bench, clod_status *status)
{
    return damped(bench, &AL_OXIDE, status) && damped(bench, &CAST_IRON, status);
}
