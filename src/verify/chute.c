// One grain that slides and does not roll on belts, chutes and a head pulley, beside the closed
// forms of a point of mass (docs/theory/belts-and-chutes.md).
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "setup/state.h"
#include "step/step.h"
#include "verify/case_file.h"
#include "verify/suite.h"

#define RADIUS 0.005 ///< m
#define DENSITY 2500.0
#define STIFFNESS 1e5 ///< N/m: the grain sinks in by 1e-5 of its radius or so
#define GRAVITY 9.81
#define STEP 1e-5
#define LOOK 10 ///< steps from look to look

/** What the case of a test has beside the material. */
typedef struct course {
    const char *name;
    const char *rolling; ///< keys of the contact
    double friction;
    const char *shape;  ///< of the wall
    double tilt;        ///< rad, of gravity about y: it points along x and -z
    double place[3];    ///< m, of the centre at the start
    double velocity[3]; ///< m/s
    double spin;        ///< rad/s about y
    double duration;    ///< s
} course;

/** Where the grain is. */
typedef struct sight {
    double time;
    clod_vec3 place, velocity;
} sight;

/** Look at a grain; false: it has been seen for long enough. */
typedef bool (*watch)(void *context, const sight *now);

static double mass(void)
{
    return DENSITY * 4.0 / 3.0 * M_PI * RADIUS * RADIUS * RADIUS;
}

static bool advance(clod_step *step, const course *self, watch look, void *context,
                    clod_status *status)
{
    clod_state *state = step->state;
    clod_new_grain grain = {
        .id = 1,
        .position = {self->place[0], self->place[1], self->place[2], RADIUS},
        .angular_velocity = {0.0, self->spin, 0.0},
        .density = DENSITY};
    memcpy(grain.velocity, self->velocity, sizeof self->velocity);
    clod_changes_add_grain(&state->changes, &grain);
    if (!clod_step_change(step, status)) {
        return false;
    }
    bool wanted = true;
    while (wanted && state->time < self->duration) {
        if (!clod_step_advance(step, LOOK, status)) {
            return false;
        }
        const sight now = {state->time, clod_vec3_of(state->grains.position[0]),
                           clod_vec3_of(state->grains.velocity[0])};
        wanted = look(context, &now);
    }
    return true;
}

/** Run a course from its case file on. */
static bool run(const clod_verify_bench *bench, const course *self, watch look, void *context,
                clod_status *status)
{
    char text[2048], path[4096];
    snprintf(text, sizeof text,
             "# Written by clod verify, which puts one grain of 5 mm at (%.9g, %.9g, %.9g) m\n"
             "# with the velocity (%.9g, %.9g, %.9g) m/s.\n"
             "title: \"%s\"\n"
             "materials: {ore: {density: 2500 kg/m3}}\n"
             "contacts: {default: {law: hooke, k1: 1e5 N/m, restitution: 1, friction: %.17g,\n"
             "  %s}}\n"
             "gravity: [%.17g m/s2, 0 m/s2, %.17g m/s2]\n"
             "domain: {min: [-20 m, -20 m, -20 m], max: [20 m, 20 m, 20 m]}\n"
             "time: {step: 1e-5 s, design_stress: 1 kPa}\n"
             "walls: {wall: {material: ore, shapes: [%s]}}\n"
             "stages: [{name: run, duration: %.17g s}]\n",
             self->place[0], self->place[1], self->place[2], self->velocity[0],
             self->velocity[1], self->velocity[2], self->name, self->friction, self->rolling,
             GRAVITY * sin(self->tilt), -GRAVITY * cos(self->tilt), self->shape,
             self->duration);
    if (!clod_verify_case_file(bench->directory, self->name, text, path, status)) {
        return false;
    }
    clod_case *from = clod_case_load(path, NULL, 0, status);
    clod_state state = {0};
    clod_laws laws = {0};
    clod_step step = {0};
    const clod_step_options options = {.threads = 1};
    const bool good = from != NULL && clod_setup_state(from, 1, &state, status) &&
                      clod_laws_init(&laws, from, status) &&
                      clod_step_init(&step, &state, &laws, &options, status) &&
                      advance(&step, self, look, context, status);
    clod_step_fini(&step);
    clod_laws_fini(&laws);
    clod_state_fini(&state);
    clod_case_destroy(&from);
    return good;
}

#define HELD "rolling: epsd2, rolling_friction: 1"
#define FREE "rolling: none"

static bool last_sight(void *context, const sight *now)
{
    *(sight *)context = *now;
    return true;
}

/** Height of a grain that lies on z = 0 under a force [m]. */
static double resting(double force)
{
    return RADIUS - force / STIFFNESS;
}

// ---- belts and a straight chute

#define BELT_SPEED 2.0
#define BELT_FRICTION 0.5
#define PICK_UP "point of mass: v/(mu g), v^2/(2 mu g)"
#define ROLLS_FREE "rigid ball: 2 v/7 when slip ends"
#define STRAIGHT "v^2 = v0^2 + 2 g (sin a - mu cos a) s"

static bool on_a_belt(const clod_verify_bench *bench, clod_status *status)
{
    const double until = BELT_SPEED / (BELT_FRICTION * GRAVITY);
    course self = {.name = "chute-pick-up",
                   .rolling = HELD,
                   .friction = BELT_FRICTION,
                   .shape =
                       "{plane: {point: [0 m, 0 m, 0 m], surface: {velocity: [2 m/s, 0 m/s, "
                       "0 m/s]}}}",
                   .place = {0.0, 0.0, resting(mass() * GRAVITY)},
                   .duration = 0.5 * until};
    sight half, end, ball;
    bool good = run(bench, &self, last_sight, &half, status);
    self.duration = 1.25 * until;
    good = good && run(bench, &self, last_sight, &end, status);
    const clod_verify_expect speed = {0.5 * BELT_SPEED, 1e-3, true, PICK_UP};
    const clod_verify_expect slip = {0.5 * BELT_SPEED * until, 1e-3, true, PICK_UP};
    good = good &&
           clod_verify_bench_check(bench, &speed, half.velocity.x * 0.5 * until / half.time,
                                   status, "picked up: speed at half of the time [m/s]") &&
           clod_verify_bench_check(bench, &slip, BELT_SPEED * end.time - end.place.x, status,
                                   "picked up: way of the belt beneath it [m]");
    self.name = "chute-ball";
    self.rolling = FREE;
    const clod_verify_expect rolls = {2.0 / 7.0 * BELT_SPEED, 1e-3, true, ROLLS_FREE};
    return good && run(bench, &self, last_sight, &ball, status) &&
           clod_verify_bench_check(bench, &rolls, ball.velocity.x, status,
                                   "ball without rolling resistance on a belt: speed [m/s]");
}

/** The speed where a way is over. */
typedef struct gate {
    double way;   ///< m along x
    double found; ///< m/s there
    sight before;
} gate;

static bool pass(void *context, const sight *now)
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
    const course self = {.name = "chute-straight",
                         .rolling = HELD,
                         .friction = mu,
                         .shape = "{plane: {point: [0 m, 0 m, 0 m]}}",
                         .tilt = tilt,
                         .place = {0.0, 0.0, resting(mass() * GRAVITY * cos(tilt))},
                         .velocity = {1.0, 0.0, 0.0},
                         .duration = 2.0};
    gate end = {.way = way};
    const double v = sqrt(1.0 + 2.0 * GRAVITY * (sin(tilt) - mu * cos(tilt)) * way); // 3.856609
    const clod_verify_expect expect = {v, 1e-3, true, STRAIGHT};
    return run(bench, &self, pass, &end, status) &&
           clod_verify_bench_check(bench, &expect, end.found, status,
                                   "straight chute of 45 deg: speed after 2 m [m/s]");
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

static bool look_round(void *context, const sight *now)
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
    const double press = mass() * (v0 * v0 / r - (hood ? GRAVITY : 0.0)) / STIFFNESS;
    course self = {.name = hood ? "chute-hood" : "chute-spoon",
                   .rolling = HELD,
                   .friction = mu,
                   .shape = shape,
                   .duration = 3.0};
    self.place[hood ? 2 : 0] = r + press;
    self.velocity[hood ? 0 : 2] = hood ? v0 : -v0;
    turn found = {.angle = angle, .from = hood ? 0.0 : 0.5 * M_PI, .radius = r};
    const clod_verify_expect expect = {expected, 1e-3, true, ROUND};
    return run(bench, &self, look_round, &found, status) &&
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

static bool round_a_pulley(const clod_verify_bench *bench, double mu, clod_status *status)
{
    const double r = 0.5, v = 1.0, wall = r - RADIUS; // r and v: of the grain's centre
    char shape[320];
    snprintf(
        shape, sizeof shape,
        "{cylinder: {foot: [0 m, -1 m, 0 m], axis: [0, 1, 0], radius: %.17g m, length: 2 m, "
        "side: outside, surface: {spin: %.17g rad/s, spin_axis: [0, 1, 0]}}}",
        wall, v / r);
    const double share = v * v / (GRAVITY * r);
    const course self = {.name = "chute-pulley",
                         .rolling = HELD,
                         .friction = mu,
                         .shape = shape,
                         .place = {0.0, 0.0, r - mass() * GRAVITY * (1.0 - share) / STIFFNESS},
                         .velocity = {v, 0.0, 0.0},
                         .spin = v / r,
                         .duration = 1.0};
    turn found = {.angle = 0.5 * M_PI, .radius = wall};
    const clod_verify_expect expect = {leaving_angle(mu, share) * 180.0 / M_PI, 0.2, false,
                                       "Booth 1934, one friction at rest and in motion"};
    return run(bench, &self, look_round, &found, status) &&
           clod_verify_bench_check(bench, &expect, found.leaves * 180.0 / M_PI, status,
                                   "head pulley of 0.5 m, 1 m/s, mu %g: leaves at [deg]", mu);
}

bool clod_verify_chute(const clod_verify_bench *bench, clod_status *status)
{
    return on_a_belt(bench, status) && down_a_chute(bench, status) &&
           in_a_circle(bench, false, 4.0, 3.0, 0.5, M_PI / 3.0,
                       spoon_speed(4.0, 3.0, 0.5, M_PI / 3.0), status) && // 4.993939
           in_a_circle(bench, false, 1.0, 1.0, 0.2, M_PI / 2.0,
                       spoon_speed(1.0, 1.0, 0.2, M_PI / 2.0), status) &&
           in_a_circle(bench, true, 5.0, 1.0, 0.3, 75.0 * M_PI / 180.0,
                       hood_speed(5.0, 1.0, 0.3, 75.0 * M_PI / 180.0), status) && // 5.125595
           round_a_pulley(bench, 0.5, status) &&
           round_a_pulley(bench, 0.3, status);
}
