// The dash-pot of a linear spring: collisions of two grains of hooke, slow and fast, against
// the damped oscillation.
#include <math.h>
#include <stdio.h>

#include "verify/hertz.h"
#include "verify/impact.h"
#include "verify/suite.h"

#define RADIUS 3.175e-3  ///< m, docs/theory/copper-ore.md
#define DENSITY 2481.3   ///< kg/m3, docs/theory/copper-ore.md
#define STIFFNESS 4.75e5 ///< k1 [N/m]
#define PERIOD_PARTS                                                                           \
    10000 ///< steps of a period without dash-pot: it is of first order in the step
#define TOLERANCE 1e-3
#define OSCILLATION "damped oscillation, half a period; src/verify/hooke_restitution.c"

static const double ASKED[] = {0.2, 0.4, 0.6, 0.8, 1.0};
static const double SPEED[] = {0.05, 0.5}; ///< of approach [m/s]
#define ASKED_COUNT ((int)(sizeof ASKED / sizeof *ASKED))
#define SPEED_COUNT ((int)(sizeof SPEED / sizeof *SPEED))
#define IMPACTS (ASKED_COUNT * SPEED_COUNT)

/** Frequency without dash-pot, sqrt(k1/m*) [rad/s]. */
static double frequency(void)
{
    return sqrt(STIFFNESS / (0.5 * clod_verify_hertz_sphere(DENSITY, RADIUS)));
}

/**
 * What m* d'' + 2 z w m* d' + k d = 0 gives from d = 0, d' = v to the next d = 0: d =
 * (v/W) exp(-z w t) sin(W t) with W = w sqrt(1 - z^2), so it takes pi/W and leaves exp(-z w
 * pi/W) of the speed. The overlap is at its most where tan(W t) = W/(z w).
 */
typedef struct oscillation {
    double duration;    ///< s
    double overlap;     ///< largest [m]
    double restitution; ///< 1
} oscillation;

static oscillation oscillate(double asked, double speed)
{
    const double w = frequency();
    const double z = -log(asked) / hypot(log(asked), M_PI); // from exp(-z pi/sqrt(1 - z^2))
    const double damped = w * sqrt(1.0 - z * z);
    const double top = atan2(damped, z * w) / damped;
    return (oscillation){.duration = M_PI / damped,
                         .overlap = speed / damped * exp(-z * w * top) * sin(damped * top),
                         .restitution = exp(-z * w * M_PI / damped)};
}

/** One pair of grains for each speed and restitution, each restitution a material, in a row. */
static void make_deck(clod_verify_deck *deck, clod_verify_impact *impacts)
{
    deck->step = 2.0 * M_PI / frequency() / PERIOD_PARTS;
    clod_verify_deck_stage(deck, (clod_verify_stage){.duration = PERIOD_PARTS * deck->step});
    clod_verify_deck_contact(
        deck, "default", "law: hooke, k1: %.17g N/m, friction: 0, rolling: none", STIFFNESS);
    for (int k = 0; k < IMPACTS; k++) {
        const int asked = k / SPEED_COUNT;
        const double speed = SPEED[k % SPEED_COUNT];
        char name[CLOD_VERIFY_NAME];
        snprintf(name, sizeof name, "e%.0f", 100.0 * ASKED[asked]);
        if (k % SPEED_COUNT == 0) {
            char pair[2 * CLOD_VERIFY_NAME];
            snprintf(pair, sizeof pair, "%s-%s", name, name);
            clod_verify_deck_material(deck, name, DENSITY, 0.0, 0.0);
            clod_verify_deck_contact(deck, pair, "restitution: %.17g", ASKED[asked]);
        }
        const double across = 4.0 * RADIUS * (k - 0.5 * (IMPACTS - 1));
        const double before = 0.5 * speed * 20.5 * deck->step;
        impacts[k] = (clod_verify_impact){.a = deck->grain_count, .b = deck->grain_count + 1};
        for (int side = -1; side <= 1; side += 2) {
            clod_verify_grain *grain = clod_verify_deck_grain(
                deck, name, RADIUS, (clod_vec3){0.0, across, side * (RADIUS + before)});
            grain->velocity.z = -0.5 * side * speed;
        }
    }
}

static bool check(const clod_verify_bench *bench, int k, const clod_verify_impact *impact,
                  clod_status *status)
{
    const double asked = ASKED[k / SPEED_COUNT];
    const double speed = SPEED[k % SPEED_COUNT];
    const oscillation o = oscillate(asked, speed);
    const double got = impact->apart ? (impact->v[1].z - impact->v[0].z) / speed : 0.0;
    const clod_verify_expect restitution = {o.restitution, TOLERANCE, true, OSCILLATION};
    const clod_verify_expect duration = {o.duration, TOLERANCE, true, OSCILLATION};
    const clod_verify_expect overlap = {o.overlap, TOLERANCE, true, OSCILLATION};
    return clod_verify_bench_check(bench, &restitution, got, status,
                                   "restitution at %g m/s, asked for %g, in %lld steps [1]",
                                   speed, asked, (long long)impact->steps) &&
           clod_verify_bench_check(bench, &duration, impact->end - impact->begin, status,
                                   "duration at %g m/s, restitution %g [s]", speed, asked) &&
           clod_verify_bench_check(bench, &overlap, impact->peak_overlap, status,
                                   "largest overlap at %g m/s, restitution %g [m]", speed,
                                   asked);
}

bool clod_verify_hooke_restitution(const clod_verify_bench *bench, clod_status *status)
{
    clod_verify_deck deck = {.name = "hooke-restitution",
                             .title = "hooke with its dash-pot: collisions of two grains"};
    clod_verify_impact impacts[IMPACTS];
    const clod_verify_frame plain = clod_verify_frame_plain();
    make_deck(&deck, impacts);
    if (!clod_verify_impact_run(bench, &deck, &plain, impacts, IMPACTS, status)) {
        return false;
    }
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, "hooke-restitution",
        "restitution asked for [1],clod: restitution obtained [1],closed form: the same [1]",
        status);
    bool ok = curve != NULL;
    for (int k = 0; ok && k < IMPACTS; k++) {
        const double asked = ASKED[k / SPEED_COUNT];
        const double got = (impacts[k].v[1].z - impacts[k].v[0].z) / SPEED[k % SPEED_COUNT];
        const double row[] = {asked, got, asked};
        clod_verify_curve_add(curve, row, 3);
        ok = check(bench, k, &impacts[k], status);
    }
    return clod_verify_curve_close(&curve, status) && ok;
}
