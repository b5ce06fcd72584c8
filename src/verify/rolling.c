// Rolling resistance: a ball that rolls out on a plane, and balls on an incline to both sides
// of the steepest one that holds them.
#include <math.h>
#include <stdio.h>

#include "verify/hertz.h"
#include "verify/play.h"
#include "verify/suite.h"

#define RADIUS 3.175e-3  ///< m, PHYSICS 6
#define DENSITY 2481.3   ///< kg/m3, PHYSICS 6
#define STIFFNESS 1e5    ///< k1 [N/m]: the ball sinks in by 1e-5 of its radius
#define GRAVITY 9.81     ///< m/s2
#define RESISTANCE 0.05  ///< mu_r
#define SPEED 0.1        ///< of the ball that rolls out, at first [m/s]
#define STEP 4e-6        ///< s
#define INCLINE_TIME 0.1 ///< s
#define HOLDS 0.95       ///< tan(alpha)/mu_r
#define ROLLS 1.05
#define EULER "a rigid ball that rolls: 7/5 m a = m g sin(alpha) - mu_r m g cos(alpha)"

static const char *const TYPES[] = {"cdt", "epsd", "epsd2"};
#define TYPE_COUNT ((int)(sizeof TYPES / sizeof *TYPES))
#define SPRING_TYPE 1 // from here on the types can hold a ball

/** What the run has seen of each ball; the spring of its type is at its limit before `from`. */
typedef struct seen {
    clod_verify_curve *curve; ///< or NULL
    double from, to;          ///< times between which the speed is compared [s]
    double speed[TYPE_COUNT]; ///< at `from` [m/s]
    double gain[TYPE_COUNT];  ///< of speed from then to `to` [m/s]
    double place[TYPE_COUNT]; ///< at `from` [m]
    double way[TYPE_COUNT];   ///< from then to `to` [m]
} seen;

/** Deceleration on the level by rolling resistance alone: (5/7) mu_r g [m/s2]. */
static double braking(void)
{
    return 5.0 / 7.0 * RESISTANCE * GRAVITY;
}

static bool look(void *context, const clod_verify_play *now, clod_status *status)
{
    seen *self = context;
    const double time = now->state.time;
    double row[TYPE_COUNT + 2] = {time};
    (void)status;
    for (int k = 0; k < TYPE_COUNT; k++) {
        const double speed = clod_verify_play_velocity(now, k).x;
        row[1 + k] = speed;
        const double place = clod_verify_play_place(now, k).x;
        if (time <= self->from) {
            self->speed[k] = speed;
            self->place[k] = place;
        } else if (time <= self->to) {
            self->gain[k] = speed - self->speed[k];
            self->way[k] = place - self->place[k];
        }
    }
    row[TYPE_COUNT + 1] = fmax(SPEED - braking() * time, 0.0);
    if (self->curve != NULL && now->state.step % 2000 == 0) {
        clod_verify_curve_add(self->curve, row, TYPE_COUNT + 2);
    }
    return true;
}

/** One ball of each type on a plane that is tilted by alpha along t. */
static void make_deck(clod_verify_deck *deck, double alpha, double speed, double duration)
{
    const double weight = GRAVITY * cos(alpha) * clod_verify_hertz_sphere(DENSITY, RADIUS);
    const double height = RADIUS - weight / STIFFNESS; // where the spring carries it
    deck->step = STEP;
    deck->gravity = (clod_vec3){GRAVITY * sin(alpha), 0.0, -GRAVITY * cos(alpha)};
    clod_verify_deck_material(deck, "floor", DENSITY, 0.0, 0.0);
    clod_verify_deck_wall(deck, "floor", "floor", 0.0, 1.0);
    clod_verify_deck_contact(deck, "default",
                             "law: hooke, k1: %.17g N/m, restitution: 0.5, friction: 0.5, "
                             "rolling_friction: %.17g, rolling: none",
                             STIFFNESS, RESISTANCE);
    for (int k = 0; k < TYPE_COUNT; k++) {
        char pair[2 * CLOD_VERIFY_NAME];
        snprintf(pair, sizeof pair, "%s-floor", TYPES[k]);
        clod_verify_deck_material(deck, TYPES[k], DENSITY, 0.0, 0.0);
        clod_verify_deck_contact(deck, pair, "rolling: %s", TYPES[k]);
        clod_verify_grain *ball = clod_verify_deck_grain(
            deck, TYPES[k], RADIUS, (clod_vec3){0.0, 4.0 * RADIUS * (k - 1), height});
        ball->velocity.x = speed;
        ball->spin.y = speed / height;
    }
    clod_verify_deck_stage(deck, (clod_verify_stage){.duration = duration});
}

static bool check_gain(const clod_verify_bench *bench, const char *where, const seen *found,
                       double acceleration, int type, clod_status *status)
{
    const clod_verify_expect expect = {acceleration, 1e-3, true, EULER};
    return clod_verify_bench_check(bench, &expect,
                                   found->gain[type] / (found->to - found->from), status,
                                   "%s: acceleration %s [m/s2]", TYPES[type], where);
}

static bool roll_out(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_frame plain = clod_verify_frame_plain();
    const double rest = SPEED / braking();
    clod_verify_deck deck = {.name = "rolling-out", .title = "balls that roll out on a plane"};
    seen found = {.from = 0.25 * rest, .to = 0.75 * rest};
    make_deck(&deck, 0.0, SPEED, 1.25 * rest);
    found.curve = clod_verify_curve_open(bench, deck.name,
                                         "time [s],clod: speed with cdt [m/s],clod: speed with "
                                         "epsd [m/s],clod: speed with epsd2 "
                                         "[m/s],closed form: speed [m/s]",
                                         status);
    bool ok =
        found.curve != NULL && clod_verify_play_run(bench, &deck, &plain, look, &found, status);
    ok = clod_verify_curve_close(&found.curve, status) && ok;
    for (int k = 0; ok && k < TYPE_COUNT; k++) {
        ok = check_gain(bench, "on the level", &found, -braking(), k, status);
    }
    return ok;
}

/**
 * When the spring has given and the ball has come to rest, a ball that is held may still rock
 * by a thousandth of what the free one rolls.
 */
static bool incline(const clod_verify_bench *bench, const char *name, double share,
                    clod_status *status)
{
    const clod_verify_frame plain = clod_verify_frame_plain();
    const double alpha = atan(share * RESISTANCE);
    const double drive = 5.0 / 7.0 * GRAVITY * (sin(alpha) - RESISTANCE * cos(alpha));
    const double way = 0.5 * fabs(drive) * INCLINE_TIME * INCLINE_TIME;
    clod_verify_deck deck = {.name = name, .title = "balls on an incline"};
    seen found = {.from = 0.5 * INCLINE_TIME, .to = INCLINE_TIME};
    make_deck(&deck, alpha, 0.0, INCLINE_TIME);
    bool ok = clod_verify_play_run(bench, &deck, &plain, look, &found, status);
    for (int k = SPRING_TYPE; ok && k < TYPE_COUNT; k++) {
        const clod_verify_expect held = {0.0, 1e-3 * way, false, EULER};
        ok = share > 1.0
                 ? check_gain(bench, "at tan(alpha) = 1.05 mu_r", &found, drive, k, status)
                 : clod_verify_bench_check(bench, &held, found.way[k], status,
                                           "%s: way at tan(alpha) = %g mu_r, once at rest [m]",
                                           TYPES[k], share);
    }
    return ok;
}

bool clod_verify_rolling(const clod_verify_bench *bench, clod_status *status)
{
    return roll_out(bench, status) && incline(bench, "rolling-held", HOLDS, status) &&
           incline(bench, "rolling-down", ROLLS, status);
}
