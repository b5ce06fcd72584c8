#include "verify/cycle.h"

#include <math.h>

#define CURVE_STEPS 20 ///< steps between two points of the curve

typedef struct watch {
    const clod_verify_cycle *cycle;
    clod_verify_cycle_found *found;
    clod_verify_curve *curve;
    double memory;   ///< of the law as printed
    double most_off; ///< largest difference from it, over f_max
    double drift;    ///< m, how far the grain has moved
} watch;

static bool look(void *context, const clod_verify_play *now, clod_status *status)
{
    watch *self = context;
    const clod_verify_cycle *c = self->cycle;
    const clod_wall *top = &now->state.walls.wall[0];
    const clod_vec3 at = clod_verify_play_place(now, 0);
    (void)status;
    const double overlap = c->radius - (c->radius - (at.z - top->shift.z)); // as the engine
    const double force = top->force.z;
    const double expected = c->law(c->law_data, overlap, &self->memory);
    self->most_off =
        clod_verify_larger(self->most_off, fabs(force - expected) / c->largest_force);
    self->drift = clod_verify_larger(self->drift, clod_vec3_length(at));
    if (now->state.step > 0) { // the first look is before the first leg
        self->found->end[now->stage] = force;
    }
    if (now->stage < c->pull_legs && force < self->found->pull) {
        self->found->pull = force;
        self->found->pull_overlap = overlap;
    }
    if (now->state.step % CURVE_STEPS == 0) {
        const double row[] = {overlap / c->largest, force, expected};
        clod_verify_curve_add(self->curve, row, 3);
    }
    return true;
}

static void make_deck(const clod_verify_cycle *self, clod_verify_deck *deck)
{
    clod_verify_deck_material(deck, "ore", self->density, 0.0, 0.0);
    clod_verify_deck_contact(deck, "default", "%s", self->contact);
    clod_verify_deck_grain(deck, "ore", self->radius, (clod_vec3){0.0, 0.0, 0.0});
    clod_verify_deck_wall(deck, "top", "ore", self->radius, -1.0);
    clod_verify_deck_wall(deck, "bottom", "ore", -self->radius, 1.0);
    const double duration = CLOD_VERIFY_LEG_STEPS * self->step;
    double before = 0.0;
    for (int l = 0; l < self->leg_count; l++) {
        const double after = self->legs[l].overlap;
        const double speed = (after - before) / duration;
        clod_verify_deck_stage(deck, (clod_verify_stage){duration, {-speed, speed}});
        before = after;
    }
}

static bool check(const clod_verify_bench *bench, const clod_verify_cycle *self,
                  const watch *seen, clod_status *status)
{
    const clod_verify_expect printed = {0.0, 1e-12, false, self->law_source};
    const clod_verify_expect still = {0.0, 0.0, false, "both planes push alike"};
    bool ok = clod_verify_bench_check(
                  bench, &printed, seen->most_off, status,
                  "%s: largest difference of the force over f_max, every step", self->name) &&
              clod_verify_bench_check(bench, &still, seen->drift, status,
                                      "%s: motion of the grain [m]", self->name);
    for (int l = 0; ok && l < self->leg_count; l++) {
        const clod_verify_leg *leg = &self->legs[l];
        if (!isnan(leg->expect.value)) {
            ok = clod_verify_bench_check(bench, &leg->expect, seen->found->end[l], status,
                                         "%s: leg %d, force at %.4g d_max [N]", self->name,
                                         l + 1, leg->overlap / self->largest);
        }
    }
    return ok;
}

bool clod_verify_cycle_run(const clod_verify_bench *bench, const clod_verify_cycle *self,
                           clod_verify_cycle_found *found, clod_status *status)
{
    clod_verify_deck deck = {.name = self->name, .title = self->title, .step = self->step};
    const clod_verify_frame plain = clod_verify_frame_plain();
    *found = (clod_verify_cycle_found){0};
    watch seen = {.cycle = self, .found = found};
    make_deck(self, &deck);
    seen.curve = clod_verify_curve_open(
        bench, self->name, "overlap over d_max [1],clod: force [N],closed form: force [N]",
        status);
    bool ok =
        seen.curve != NULL && clod_verify_play_run(bench, &deck, &plain, look, &seen, status);
    ok = clod_verify_curve_close(&seen.curve, status) && ok;
    return ok && check(bench, self, &seen, status);
}
