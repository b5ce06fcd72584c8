// One grain that slides and does not roll on belts, chutes and a head pulley, beside the closed
// forms of a point of mass (docs/theory/belts-and-chutes.md).
#include <math.h>
#include <stdio.h>

#include "verify/course.h"
#include "verify/suite.h"

#define RADIUS CLOD_VERIFY_COURSE_RADIUS
#define GRAVITY CLOD_VERIFY_COURSE_GRAVITY
#define HELD CLOD_VERIFY_COURSE_HELD
#define WEIGHT (clod_verify_course_mass() * GRAVITY)
#define DEGREES (180.0 / M_PI)

static bool last_sight(void *context, const clod_verify_sight *now)
{
    *(clod_verify_sight *)context = *now;
    return true;
}

/** Height of a grain that lies on z = 0 under a force [m]. */
static double resting(double force)
{
    return RADIUS - clod_verify_course_overlap(force);
}

// ---- belts and a straight chute

#define BELT_SPEED 2.0
#define BELT_FRICTION 0.5
#define BELT "{plane: {point: [0 m, 0 m, 0 m], surface: {velocity: [2 m/s, 0 m/s, 0 m/s]}}}"
#define PICK_UP "point of mass: v/(mu g), v^2/(2 mu g)"
#define ROLLS_FREE "rigid ball: 2 v/7 when slip ends"
#define STRAIGHT "v^2 = v0^2 + 2 g (sin a - mu cos a) s"

static bool on_a_belt(const clod_verify_bench *bench, clod_status *status)
{
    const double until = BELT_SPEED / (BELT_FRICTION * GRAVITY);
    clod_verify_course self = {.name = "chute-pick-up",
                               .rolling = HELD,
                               .friction = BELT_FRICTION,
                               .shape = BELT,
                               .place = {0.0, 0.0, resting(WEIGHT)},
                               .duration = 0.5 * until};
    clod_verify_sight half, end;
    bool good = clod_verify_course_run(bench, &self, last_sight, &half, status);
    self.duration = 1.25 * until;
    good = good && clod_verify_course_run(bench, &self, last_sight, &end, status);
    const clod_verify_expect speed = {0.5 * BELT_SPEED, 1e-3, true, PICK_UP};
    const clod_verify_expect slip = {0.5 * BELT_SPEED * until, 1e-3, true, PICK_UP};
    good = good &&
           clod_verify_bench_check(bench, &speed, half.velocity.x * 0.5 * until / half.time,
                                   status, "picked up: speed at half of the time [m/s]") &&
           clod_verify_bench_check(bench, &slip, BELT_SPEED * end.time - end.place.x, status,
                                   "picked up: way of the belt beneath it [m]");
    return good;
}

/** The moment at which a grain on the belt stops to slip. */
typedef struct grip {
    double time; ///< s; 0: it slips
    double slip; ///< m/s, of the look before
    clod_verify_sight last;
} grip;

static bool wait_for_grip(void *context, const clod_verify_sight *now)
{
    grip *self = context;
    const double slip = BELT_SPEED - now->velocity.x + RADIUS * now->spin;
    if (self->time == 0.0 && slip <= 0.0) {
        const double share = self->slip / (self->slip - slip);
        self->time = self->last.time + share * (now->time - self->last.time);
    }
    self->slip = slip;
    self->last = *now;
    return true;
}

/** Without rolling resistance a ball comes to 2/7 of the belt's speed: 0.571 m/s after 0.1165 s. */
static bool ball_on_a_belt(const clod_verify_bench *bench, clod_status *status)
{
    const double until = 2.0 / 7.0 * BELT_SPEED / (BELT_FRICTION * GRAVITY);
    const clod_verify_course self = {.name = "chute-ball",
                                     .rolling = CLOD_VERIFY_COURSE_FREE,
                                     .friction = BELT_FRICTION,
                                     .shape = BELT,
                                     .place = {0.0, 0.0, resting(WEIGHT)},
                                     .duration = 4.0 * until};
    grip found = {.time = 0.0};
    const clod_verify_expect speed = {2.0 / 7.0 * BELT_SPEED, 1e-3, true, ROLLS_FREE};
    const clod_verify_expect time = {until, 1e-3, true, ROLLS_FREE};
    return clod_verify_course_run(bench, &self, wait_for_grip, &found, status) &&
           clod_verify_bench_check(bench, &speed, found.last.velocity.x, status,
                                   "ball without rolling resistance on a belt: speed [m/s]") &&
           clod_verify_bench_check(bench, &time, found.time, status,
                                   "ball without rolling resistance on a belt: slips for [s]");
}

/** The speed where a way is over. */
typedef struct gate {
    double way;   ///< m along x
    double found; ///< m/s there
    clod_verify_sight before;
} gate;

static bool pass(void *context, const clod_verify_sight *now)
{
    gate *self = context;
    if (now->place.x < self->way) {
        self->before = *now;
        return true;
    }
    const double share =
        (self->way - self->before.place.x) / (now->place.x - self->before.place.x);
    const double a = clod_vec3_length(self->before.velocity);
    self->found = a + share * (clod_vec3_length(now->velocity) - a);
    return false;
}

static bool down_a_chute(const clod_verify_bench *bench, clod_status *status)
{
    const double tilt = M_PI / 4.0, way = 2.0, mu = 0.5;
    const clod_verify_course self = {.name = "chute-straight",
                                     .rolling = HELD,
                                     .friction = mu,
                                     .shape = "{plane: {point: [0 m, 0 m, 0 m]}}",
                                     .tilt = tilt,
                                     .place = {0.0, 0.0, resting(WEIGHT * cos(tilt))},
                                     .velocity = {1.0, 0.0, 0.0},
                                     .duration = 2.0};
    gate end = {.way = way};
    const double v = sqrt(1.0 + 2.0 * GRAVITY * (sin(tilt) - mu * cos(tilt)) * way); // 3.856609
    const clod_verify_expect expect = {v, 1e-3, true, STRAIGHT};
    return clod_verify_course_run(bench, &self, pass, &end, status) &&
           clod_verify_bench_check(bench, &expect, end.found, status,
                                   "straight chute of 45 deg: speed after 2 m [m/s]");
}

/** Half of the speed across the plate comes back or so, without a dash-pot: that would end within
 *  a step or so of the contact, and with it some impulse. */
#define PLASTIC "mepa, exponent: 1, k1: 1e5 N/m, k2: 5e5 N/m, k_adh: 0 N/m"
#define KEPT "V2/V1 = cos t - sin t tan phi: nothing of the speed across the plate is left"

/**
 * A grain flies onto a plate at the angle t and slides on. On a plate that is tilted by the angle
 * of friction phi nothing drives or brakes a grain that slides, and however often it hops,
 * friction takes tan phi times all that it loses across the plate.
 */
static bool onto_a_plate(const clod_verify_bench *bench, clod_status *status)
{
    const double v1 = 4.0, t = 40.0 / DEGREES, phi = 25.0 / DEGREES;
    const clod_verify_course self = {.name = "chute-plate",
                                     .law = PLASTIC,
                                     .rolling = HELD,
                                     .friction = tan(phi),
                                     .shape = "{plane: {point: [0 m, 0 m, 0 m]}}",
                                     .tilt = phi,
                                     .place = {0.0, 0.0, RADIUS},
                                     .velocity = {v1 * cos(t), 0.0, -v1 * sin(t)},
                                     .duration = 1.0};
    clod_verify_sight end;
    const clod_verify_expect expect = {cos(t) - sin(t) * tan(phi), 1e-3, true,
                                       KEPT}; // 0.466308
    return clod_verify_course_run(bench, &self, last_sight, &end, status) &&
           clod_verify_bench_check(bench, &expect, end.velocity.x / v1, status,
                                   "grain onto a plate at 40 deg, phi 25 deg: V2/V1 [1]");
}

// ---- round a cylinder about y through the origin

/** The speed at a turn from where it began. */
typedef struct turn {
    double angle;  ///< rad, where it is asked for; clockwise from the start
    double from;   ///< rad, of the start, clockwise from the top
    double radius; ///< m, of the wall
    double found;  ///< m/s there
    double leaves; ///< rad, the last angle at which the grain touched the wall from outside
    double last, speed; ///< of the look before
} turn;

/** Angle clockwise from the top, beyond the start [rad]. */
static double angle_of(const turn *self, clod_vec3 place)
{
    const double a = atan2(place.x, place.z) - self->from;
    return a < -0.5 ? a + 2.0 * M_PI : a;
}

static bool look_round(void *context, const clod_verify_sight *now)
{
    turn *self = context;
    const double a = angle_of(self, now->place);
    const double v = clod_vec3_length(now->velocity);
    if (hypot(now->place.x, now->place.z) < self->radius + RADIUS) {
        self->leaves = a;
    }
    if (a >= self->angle) {
        const double share = (self->angle - self->last) / (a - self->last);
        self->found = self->speed + share * (v - self->speed);
        return false;
    }
    self->last = a;
    self->speed = v;
    return true;
}

/** v^2 on the inside of a circle after a turn t from where the way is straight down (spoon). */
static double spoon_speed(double v0, double r, double mu, double t)
{
    const double square = 1.0 + 4.0 * mu * mu;
    const double k = v0 * v0 - 6.0 * mu * GRAVITY * r / square;
    return sqrt(2.0 * GRAVITY * r / square *
                    ((1.0 - 2.0 * mu * mu) * sin(t) + 3.0 * mu * cos(t)) +
                k * exp(-2.0 * mu * t));
}

/** The same beneath the top, p from where the way is level (hood). */
static double hood_speed(double v0, double r, double mu, double p)
{
    const double square = 1.0 + 4.0 * mu * mu;
    const double k = v0 * v0 - 2.0 * GRAVITY * r * (2.0 * mu * mu - 1.0) / square;
    return sqrt(2.0 * GRAVITY * r / square *
                    (3.0 * mu * sin(p) + (2.0 * mu * mu - 1.0) * cos(p)) +
                k * exp(-2.0 * mu * p));
}

#define ROUND "point of mass on an arc, docs/theory/belts-and-chutes.md"

/** A spoon from straight down, or a hood from level; both turn from the top towards x. */
static bool in_a_circle(const clod_verify_bench *bench, bool hood, double v0, double r,
                        double mu, double angle, double expected, clod_status *status)
{
    char shape[256];
    snprintf(
        shape, sizeof shape,
        "{cylinder: {foot: [0 m, -1 m, 0 m], axis: [0, 1, 0], radius: %.17g m, length: 2 m, "
        "side: inside}}",
        r + RADIUS);
    const double press = clod_verify_course_overlap(clod_verify_course_mass() *
                                                    (v0 * v0 / r - (hood ? GRAVITY : 0.0)));
    clod_verify_course self = {.name = hood ? "chute-hood" : "chute-spoon",
                               .rolling = HELD,
                               .friction = mu,
                               .shape = shape,
                               .duration = 3.0};
    self.place[hood ? 2 : 0] = r + press;
    self.velocity[hood ? 0 : 2] = hood ? v0 : -v0;
    turn found = {.angle = angle, .from = hood ? 0.0 : 0.5 * M_PI, .radius = r};
    const clod_verify_expect expect = {expected, 1e-3, true, ROUND};
    return clod_verify_course_run(bench, &self, look_round, &found, status) &&
           clod_verify_bench_check(bench, &expect, found.found, status,
                                   "%s of %g m, mu %g, from %g m/s: speed after %g deg [m/s]",
                                   hood ? "hood" : "spoon", r, mu, v0, angle * 180.0 / M_PI);
}

/** v^2/(g r) of a grain that slips on a pulley, from `since` on, where it was `then`. */
static double booth(double mu, double since, double then, double a)
{
    const double square = 1.0 + 4.0 * mu * mu;
    const double at = ((4.0 * mu * mu - 2.0) * cos(since) - 6.0 * mu * sin(since)) / square;
    const double c = (then - at) * exp(-2.0 * mu * since);
    return ((4.0 * mu * mu - 2.0) * cos(a) - 6.0 * mu * sin(a)) / square +
           c * exp(2.0 * mu * a);
}

/** The angle at which a grain leaves: it slips where cos a - sin a/mu = share of v^2/(g r). */
static double leaving_angle(double mu, double share)
{
    double slips = 0.0;
    while (cos(slips) - sin(slips) / mu > share) {
        slips += 1e-6;
    }
    double leaves = slips;
    while (booth(mu, slips, share, leaves) < cos(leaves)) {
        leaves += 1e-6;
    }
    return leaves;
}

#define PULLEY_RADIUS 0.5 ///< m, of the way of the grain's centre
#define PULLEY_SPEED 1.0  ///< m/s, of the grain's centre
#define BOOTH "Booth 1934, one friction at rest and in motion"

/** The angle at which a grain leaves a head pulley [deg], found and by Booth's theory. */
static bool round_a_pulley(const clod_verify_bench *bench, double mu, double *angle,
                           clod_status *status)
{
    const double r = PULLEY_RADIUS, v = PULLEY_SPEED, wall = r - RADIUS;
    char shape[320], rolling[64];
    snprintf(
        shape, sizeof shape,
        "{cylinder: {foot: [0 m, -1 m, 0 m], axis: [0, 1, 0], radius: %.17g m, length: 2 m, "
        "side: outside, surface: {spin: %.17g rad/s, spin_axis: [0, 1, 0]}}}",
        wall, v / r);
    snprintf(rolling, sizeof rolling, "rolling: epsd2, rolling_friction: %g", fmax(mu, 1.0));
    const double share = v * v / (GRAVITY * r);
    const clod_verify_course self = {
        .name = "chute-pulley",
        .rolling = rolling,
        .friction = mu,
        .shape = shape,
        .place = {0.0, 0.0, r - clod_verify_course_overlap(WEIGHT * (1.0 - share))},
        .velocity = {v, 0.0, 0.0},
        .spin = v / r,
        .duration = 1.0};
    turn found = {.angle = 0.5 * M_PI, .radius = wall};
    const clod_verify_expect expect = {leaving_angle(mu, share) * DEGREES, 0.2, false, BOOTH};
    const bool good = clod_verify_course_run(bench, &self, look_round, &found, status);
    *angle = found.leaves * DEGREES;
    return good &&
           clod_verify_bench_check(bench, &expect, *angle, status,
                                   "head pulley of 0.5 m, 1 m/s, mu %g: leaves at [deg]", mu);
}

/** Booth's angle goes as 1/mu to that without slip, cos a = v^2/(g r). */
static bool round_pulleys(const clod_verify_bench *bench, clod_status *status)
{
    const double share = PULLEY_SPEED * PULLEY_SPEED / (GRAVITY * PULLEY_RADIUS);
    const clod_verify_expect cema = {acos(share) * DEGREES, 0.5, false, // 78.236
                                     "CEMA: cos a = v^2/(g r)"};
    double angle, five, ten;
    return round_a_pulley(bench, 0.5, &angle, status) &&
           round_a_pulley(bench, 0.3, &angle, status) &&
           round_a_pulley(bench, 5.0, &five, status) &&
           round_a_pulley(bench, 10.0, &ten, status) &&
           clod_verify_bench_check(
               bench, &cema, 2.0 * ten - five, status,
               "head pulley without slip, from mu 5 and 10: leaves at [deg]");
}

// ---- off a belt

/** Heights of a grain where it is above places. */
typedef struct flight {
    double way[3], height[3]; ///< m
    int passed;
    clod_verify_sight before;
} flight;

static bool fly(void *context, const clod_verify_sight *now)
{
    flight *self = context;
    if (now->place.x >= self->way[self->passed]) {
        const double share = (self->way[self->passed] - self->before.place.x) /
                             (now->place.x - self->before.place.x);
        self->height[self->passed++] =
            self->before.place.z + share * (now->place.z - self->before.place.z);
    }
    self->before = *now;
    return self->passed < 3;
}

/** Faster than sqrt(g r), 2.215 m/s, a grain flies from where the belt meets the pulley. */
static bool off_a_belt(const clod_verify_bench *bench, clod_status *status)
{
    const double v = 4.0;
    const clod_verify_course self = {
        .name = "chute-flight",
        .rolling = HELD,
        .friction = 0.5,
        .shape = "{belt: {from: [-0.4 m, 0 m, 0 m], runs: [{length: 0.4 m}], width: 400 mm, "
                 "speed: 4 m/s, pulley: {radius: 495 mm}}}",
        .place = {-0.3, 0.0, resting(WEIGHT)},
        .velocity = {v, 0.0, 0.0},
        .duration = 1.5};
    flight found = {.way = {1.0, 2.0, 3.0}};
    bool good = clod_verify_course_run(bench, &self, fly, &found, status);
    for (int k = 0; good && k < 3; k++) { // -0.306563, -1.22625, -2.759063 m
        const double time = found.way[k] / v;
        // as the weight goes the contact springs back, with this speed at most
        const double spring = sqrt(GRAVITY * clod_verify_course_overlap(WEIGHT)) * time + 1e-6;
        const clod_verify_expect expect = {-0.5 * GRAVITY * time * time, spring, false,
                                           "parabola; what the weight's spring gives"};
        good =
            clod_verify_bench_check(bench, &expect, found.height[k] - RADIUS, status,
                                    "off a belt of 4 m/s: height after %g m [m]", found.way[k]);
    }
    return good;
}

bool clod_verify_chute(const clod_verify_bench *bench, clod_status *status)
{
    return on_a_belt(bench, status) && ball_on_a_belt(bench, status) &&
           down_a_chute(bench, status) && onto_a_plate(bench, status) &&
           in_a_circle(bench, false, 4.0, 3.0, 0.5, M_PI / 3.0,
                       spoon_speed(4.0, 3.0, 0.5, M_PI / 3.0), status) && // 4.993939
           in_a_circle(bench, false, 1.0, 1.0, 0.2, M_PI / 2.0,
                       spoon_speed(1.0, 1.0, 0.2, M_PI / 2.0), status) &&
           in_a_circle(bench, false, 0.0, 1.0, 0.2, M_PI / 2.0,
                       spoon_speed(0.0, 1.0, 0.2, M_PI / 2.0), status) && // 3.185389
           in_a_circle(bench, true, 5.0, 1.0, 0.3, 75.0 * M_PI / 180.0,
                       hood_speed(5.0, 1.0, 0.3, 75.0 * M_PI / 180.0), status) && // 5.125595
           round_pulleys(bench, status) &&
           off_a_belt(bench, status);
}
