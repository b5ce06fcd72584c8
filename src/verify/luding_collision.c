// Luding's law: collisions of two grains as MercuryDPM's test of the law publishes them.
#include <math.h>
#include <stdio.h>

#include "verify/luding.h"
#include "verify/play.h"
#include "verify/suite.h"

#define RADIUS 0.5 ///< m
#define MASS 1.0   ///< kg
#define STEPS 100
#define APART 3.0 ///< m from one pair to the next
#define TOLERANCE 1e-10
#define PUBLISHED "MercuryDPM, Drivers/UnitTests/PlasticForceUnitTest.cpp"
#define PRINTED "Luding 2008, taken branch by branch in src/verify/luding.c"

static const clod_verify_luding LAW = {
    .k1 = 100.0, .k2 = 500.0, .k_adh = 100.0, .depth = 0.05, .diameter = RADIUS};

/** A pair that begins at touch, at z = 1 m and 2 m, with speed chi sqrt(2 k1) d* together. */
typedef struct collision {
    double chi;
    double place, speed; ///< of the left grain after STEPS steps [m], [m/s]
    const char *what;
} collision;

static const collision COLLISIONS[] = {
    {0.34, 0.995546292935715, -0.032721738352012, "rebound"},
    {0.69, 1.00695193269955, -0.0138683231953154, "sticks on k2"},
    {1.1, 1.00840467123501, -0.0204655358555405, "sticks, from the limit branch"},
    {1.37, 0.969386085767181, -0.163049415300304, "rebound from the limit branch"},
};
#define COLLISION_COUNT ((int)(sizeof COLLISIONS / sizeof *COLLISIONS))

/** What the run has seen of a pair. */
typedef struct seen {
    clod_verify_curve *curve;
    double memory;       ///< of the law as printed
    double most_off;     ///< largest difference from it [N]
    double place, speed; ///< of the left grain, last
    double drift;        ///< largest sum of the two velocities [m/s]
} seen;

static bool look(void *context, const clod_verify_play *now, clod_status *status)
{
    seen *pairs = context;
    (void)status;
    for (int k = 0; k < COLLISION_COUNT; k++) {
        seen *pair = &pairs[k];
        const double left = clod_verify_play_place(now, 2 * k).z;
        const double right = clod_verify_play_place(now, 2 * k + 1).z;
        const double overlap = 2.0 * RADIUS - (right - left);
        const double force = -clod_verify_play_force(now, 2 * k).z;
        const double expected = clod_verify_luding_force(&LAW, overlap, &pair->memory);
        pair->most_off = clod_verify_larger(pair->most_off, fabs(force - expected));
        pair->place = left;
        pair->speed = clod_verify_play_velocity(now, 2 * k).z;
        pair->drift = clod_verify_larger(
            pair->drift, fabs(pair->speed + clod_verify_play_velocity(now, 2 * k + 1).z));
        const double row[] = {overlap, force, expected};
        clod_verify_curve_add(pair->curve, row, 3);
    }
    return true;
}

static void make_deck(clod_verify_deck *deck)
{
    const double density = MASS / (4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS);
    const double unit = sqrt(2.0 * LAW.k1) * clod_verify_luding_limit(&LAW);
    deck->step = 2.0 * 0.02 * M_PI / sqrt(LAW.k2 / (0.5 * MASS));
    clod_verify_deck_material(deck, "ore", density, 0.0, 0.0);
    clod_verify_deck_contact(deck, "default",
                             "law: luding, k1: %.17g N/m, k2: %.17g N/m, k_adh: %.17g N/m, "
                             "plasticity_depth: %.17g, restitution: 1, friction: 0, "
                             "rolling: none",
                             LAW.k1, LAW.k2, LAW.k_adh, LAW.depth);
    for (int k = 0; k < COLLISION_COUNT; k++) {
        for (int g = 0; g < 2; g++) {
            clod_verify_grain *grain = clod_verify_deck_grain(
                deck, "ore", RADIUS, (clod_vec3){0.0, APART * k, g == 0 ? 1.0 : 2.0});
            grain->velocity.z = (g == 0 ? 0.5 : -0.5) * COLLISIONS[k].chi * unit;
        }
    }
    clod_verify_deck_stage(deck, (clod_verify_stage){.duration = STEPS * deck->step});
}

static bool check(const clod_verify_bench *bench, const collision *c, const seen *pair,
                  clod_status *status)
{
    const clod_verify_expect place = {c->place, TOLERANCE, false, PUBLISHED};
    const clod_verify_expect speed = {c->speed, TOLERANCE, false, PUBLISHED};
    const clod_verify_expect printed = {0.0, TOLERANCE, false, PRINTED};
    const clod_verify_expect nothing = {0.0, 0.0, false, "equal and opposite forces"};
    return clod_verify_bench_check(bench, &place, pair->place, status,
                                   "chi %g (%s): left grain after %d steps [m]", c->chi,
                                   c->what, STEPS) &&
           clod_verify_bench_check(bench, &speed, pair->speed, status,
                                   "chi %g (%s): its velocity [m/s]", c->chi, c->what) &&
           clod_verify_bench_check(bench, &printed, pair->most_off, status,
                                   "chi %g: largest difference of the force [N], every step",
                                   c->chi) &&
           clod_verify_bench_check(bench, &nothing, pair->drift, status,
                                   "chi %g: sum of the two velocities [m/s]", c->chi);
}

static bool open_curves(const clod_verify_bench *bench, seen *pairs, clod_status *status)
{
    for (int k = 0; k < COLLISION_COUNT; k++) {
        char name[64];
        snprintf(name, sizeof name, "luding-collision-%g", COLLISIONS[k].chi);
        pairs[k].curve = clod_verify_curve_open(
            bench, name, "overlap [m],clod: force [N],closed form: force [N]", status);
        if (pairs[k].curve == NULL) {
            return false;
        }
    }
    return true;
}

bool clod_verify_luding_collision(const clod_verify_bench *bench, clod_status *status)
{
    clod_verify_deck deck = {.name = "luding-collision",
                             .title = "luding: collisions of two grains"};
    seen pairs[COLLISION_COUNT] = {{0}};
    const clod_verify_frame plain = clod_verify_frame_plain();
    make_deck(&deck);
    bool ok = open_curves(bench, pairs, status) &&
              clod_verify_play_run(bench, &deck, &plain, look, pairs, status);
    for (int k = 0; k < COLLISION_COUNT; k++) {
        ok = clod_verify_curve_close(&pairs[k].curve, status) && ok;
    }
    for (int k = 0; ok && k < COLLISION_COUNT; k++) {
        ok = check(bench, &COLLISIONS[k], &pairs[k], status);
    }
    return ok;
}
