// A stream of grains from an inlet onto a belt that brings it to its speed
// (docs/theory/belts-and-chutes.md).
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "verify/bed.h"
#include "verify/rate.h"
#include "verify/suite.h"

#define GRAVITY 9.81
#define LOOKS 1024
/** Two-sided 99 % of Student's t with CLOD_VERIFY_BLOCKS - 1 degrees of freedom. */
#define STUDENT 3.5

/** What adds up while the stream is steady, by looks of 5 ms. */
typedef struct stream {
    double steady; ///< s, from when on
    size_t count;
    double time[LOOKS];
    double along[LOOKS];             ///< N s, onto the belt along x
    double work[LOOKS], heat[LOOKS]; ///< J, by the wall; lost in contacts
    double gap[LOOKS];               ///< J, energy that the ledger has too much
    double far;                      ///< m, x from where on grains are looked at
    double momentum, flux; ///< sums of m v_x^2 and of m v_x beyond: their ratio is the speed
} stream;

/** Energy that contacts took, with the lag: at the automatic step that is 0.9 % of an impact with e
 *  0.3 (docs/theory/energy.md), more than this stream scatters. */
static double heat_of(const clod_ledger *ledger)
{
    return ledger->plastic + ledger->dash_pot + ledger->friction + ledger->rolling +
           ledger->lag;
}

static void look_beyond(stream *self, const clod_grains *grains)
{
    for (size_t g = 0; g < grains->count; g++) {
        const double *v = grains->velocity[g];
        if (grains->position[g][0] > self->far) {
            self->momentum += v[3] * v[0] * v[0];
            self->flux += v[3] * v[0];
        }
    }
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    stream *self = context;
    const clod_wall *wall = &now->state.walls.wall[0];
    if (now->state.step == 0) {
        return clod_step_open_ledger(&now->step, status);
    }
    if (now->state.time < self->steady || self->count == LOOKS) {
        return true;
    }
    const size_t k = self->count++;
    const double last = k > 0 ? self->along[k - 1] : 0.0;
    const clod_ledger *ledger = &now->state.ledger;
    const clod_energies energies = clod_step_energies(&now->step);
    self->time[k] = now->state.time;
    self->along[k] = last + wall->sum_force.x * now->state.dt;
    self->work[k] = ledger->wall_work;
    self->heat[k] = heat_of(ledger);
    self->gap[k] = clod_ledger_residual(ledger, &energies);
    look_beyond(self, &now->state.grains);
    return true;
}

/** Rate of a sum while the stream is steady, with what 99 % of such rates are within. */
static double rate_of(const stream *self, const double *sum, double *interval)
{
    double error;
    const double rate = clod_verify_rate_of(self->time, sum, self->count, &error);
    *interval = STUDENT * error;
    return rate;
}

#define FLOW 0.5  ///< kg/s
#define BELT 2.0  ///< m/s
#define COMES 0.3 ///< m/s along the belt
#define FALLS 1.0 ///< m/s down
#define DROP 0.03 ///< m, from the middle of the inlet to where grains lie
#define LAW                                                                                    \
    "law: hooke, k1: 1e4 N/m, restitution: 0.3, friction: 0.5, rolling: epsd2, "               \
    "rolling_friction: 0.5"

static const char ON_A_BELT[] =
    "# Written by clod verify.\n"
    "title: A stream that a belt takes along\n"
    "materials: {ore: {density: 2500 kg/m3}}\n"
    "contacts: {default: {" LAW "}}\n"
    "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
    "domain: {min: [-0.5 m, -0.3 m, -0.1 m], max: [1.4 m, 0.3 m, 0.4 m], open: delete}\n"
    "time: {design_stress: 5 kPa}\n"
    "grains:\n"
    "  - material: ore\n"
    "    radius: {distribution: uniform, min: 4.5 mm, max: 5.5 mm}\n"
    "    inlet: {mass_flow: %g kg/s}\n"
    "    region: {box: {min: [-0.1 m, -50 mm, 25 mm], max: [0 m, 50 mm, 45 mm]}}\n"
    "    velocity: [%g m/s, 0 m/s, %g m/s]\n"
    "walls:\n"
    "  belt:\n"
    "    material: ore\n"
    "    shapes: [{belt: {from: [-0.4 m, 0 m, 0 m], runs: [{length: 1.6 m}], width: 500 mm, "
    "speed: %g m/s}}]\n"
    "stages: [{name: run, duration: 3.5 s}]\n"
    "output: {series_interval: 5 ms, energy: true}\n";

#define MOMENTUM "momentum: F = Q (v - v0)"
#define POWER "power = F v"
#define HEAT "energy: Q (v - v0)^2/2, half of the power for v0 = 0"

bool clod_verify_stream_belt(const clod_verify_bench *bench, clod_status *status)
{
    static stream self;
    char text[4096];
    self = (stream){.steady = 1.2, .far = 0.8};
    snprintf(text, sizeof text, ON_A_BELT, FLOW, COMES, -FALLS, BELT);
    if (!clod_verify_bed_run(bench, "stream-belt", text, look, &self, status)) {
        return false;
    }
    double of[4];
    const double pull = -rate_of(&self, self.along, &of[0]);
    const double power = rate_of(&self, self.work, &of[1]);
    const double heat = rate_of(&self, self.heat, &of[2]);
    const double gap = rate_of(&self, self.gap, &of[3]);
    const double slip = BELT - COMES;
    const double fall = FLOW * (0.5 * FALLS * FALLS + GRAVITY * DROP); // is heat too
    const clod_verify_expect speed = {BELT, 1e-3, true, "grains that do not roll"};
    const clod_verify_expect force = {FLOW * slip, of[0], false, MOMENTUM};
    const clod_verify_expect work = {FLOW * slip * BELT, of[1], false, POWER};
    const clod_verify_expect lost = {0.5 * FLOW * slip * slip + fall, of[2], false, HEAT};
    const clod_verify_expect none = {0.0, 1e-3 * FLOW * slip * BELT, false,
                                     "docs/theory/energy.md; a thousandth of the power"};
    return clod_verify_bench_check(bench, &speed, self.momentum / self.flux, status,
                                   "stream on a belt: its speed at the end [m/s]") &&
           clod_verify_bench_check(bench, &force, pull, status,
                                   "stream on a belt: pull of the belt [N], 99 %% interval") &&
           clod_verify_bench_check(bench, &work, power, status,
                                   "stream on a belt: power [W], 99 %% interval") &&
           clod_verify_bench_check(
               bench, &lost, heat, status,
               "stream on a belt: heat and lag, with those of the fall [W]") &&
           clod_verify_bench_check(bench, &none, gap, status,
                                   "stream on a belt: what the ledger lacks [W]");
}
