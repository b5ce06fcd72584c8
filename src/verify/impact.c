#include "verify/impact.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "base/assert.h"

typedef struct watch {
    clod_verify_impact *impacts;
    int count;
} watch;

/** Overlap [m] of an impact's partners now, negative for a gap. */
static double overlap_of(const clod_verify_play *now, const clod_verify_impact *impact)
{
    const clod_verify_grain *a = &now->deck->grains[impact->a];
    const clod_vec3 at = clod_verify_play_place(now, impact->a);
    if (impact->b == CLOD_VERIFY_ON_WALL) {
        const clod_verify_wall *wall = &now->deck->walls[0];
        return a->radius - wall->side * (at.z - wall->height);
    }
    const clod_vec3 apart = clod_vec3_sub(at, clod_verify_play_place(now, impact->b));
    return a->radius + now->deck->grains[impact->b].radius - clod_vec3_length(apart);
}

/** Normal force [N] on a now; repulsion is positive. */
static double force_of(const clod_verify_play *now, const clod_verify_impact *impact)
{
    const clod_vec3 force = clod_verify_play_force(now, impact->a);
    if (impact->b == CLOD_VERIFY_ON_WALL) {
        return force.z * now->deck->walls[0].side;
    }
    const clod_vec3 apart = clod_vec3_sub(clod_verify_play_place(now, impact->a),
                                          clod_verify_play_place(now, impact->b));
    return clod_vec3_dot(force, clod_vec3_unit(apart));
}

/** Time at which the overlap was zero between the last step and now. */
static double crossing(const clod_verify_impact *impact, double overlap, double time)
{
    const double part = impact->last_overlap / (impact->last_overlap - overlap);
    return impact->last_time + part * (time - impact->last_time);
}

static void look_at(const clod_verify_play *now, clod_verify_impact *impact)
{
    const double time = now->state.time;
    const double overlap = overlap_of(now, impact);
    const bool first = now->state.step == 0;
    if (!first && overlap > 0.0 && impact->last_overlap <= 0.0) {
        impact->begin = crossing(impact, overlap, time);
    } else if (!first && overlap <= 0.0 && impact->last_overlap > 0.0) {
        impact->end = crossing(impact, overlap, time);
    }
    if (overlap > 0.0) {
        const double force = force_of(now, impact);
        impact->steps++;
        impact->a_first =
            impact->b != CLOD_VERIFY_ON_WALL && now->row[impact->a] < now->row[impact->b];
        impact->peak_force = fmax(impact->peak_force, force);
        impact->peak_overlap = fmax(impact->peak_overlap, overlap);
        if (impact->curve != NULL && impact->steps % 40 == 0) {
            const double row[] = {overlap, force, impact->hertz * overlap * sqrt(overlap)};
            clod_verify_curve_add(impact->curve, row, 3);
        }
    }
    impact->apart = overlap <= 0.0;
    impact->last_overlap = overlap;
    impact->last_time = time;
    impact->v[0] = clod_verify_play_velocity(now, impact->a);
    impact->w[0] = clod_verify_play_spin(now, impact->a);
    if (impact->b != CLOD_VERIFY_ON_WALL) {
        impact->v[1] = clod_verify_play_velocity(now, impact->b);
        impact->w[1] = clod_verify_play_spin(now, impact->b);
    }
}

static bool look(void *context, const clod_verify_play *now, clod_status *status)
{
    watch *self = context;
    (void)status;
    for (int k = 0; k < self->count; k++) {
        look_at(now, &self->impacts[k]);
    }
    return true;
}

static bool run(const clod_verify_bench *bench, const clod_verify_deck *deck,
                const clod_verify_frame *frame, watch *found, clod_status *status)
{
    for (int k = 0; k < found->count; k++) {
        clod_verify_impact *impact = &found->impacts[k];
        *impact = (clod_verify_impact){.a = impact->a,
                                       .b = impact->b,
                                       .curve = impact->curve,
                                       .hertz = impact->hertz,
                                       .begin = NAN,
                                       .end = NAN};
    }
    return clod_verify_play_run(bench, deck, frame, look, found, status);
}

bool clod_verify_impact_run(const clod_verify_bench *bench, const clod_verify_deck *deck,
                            const clod_verify_frame *frame, clod_verify_impact *impacts,
                            int count, clod_status *status)
{
    watch found = {.impacts = impacts, .count = count};
    return run(bench, deck, frame, &found, status);
}

/** Fastest motion that a partner begins with, the surface's of its spin included [m/s]. */
static double fastest(const clod_verify_deck *deck, const clod_verify_impact *impact)
{
    double speed = 0.0;
    for (int k = 0; k < (impact->b == CLOD_VERIFY_ON_WALL ? 1 : 2); k++) {
        const clod_verify_grain *grain = &deck->grains[k == 0 ? impact->a : impact->b];
        speed = fmax(speed, clod_vec3_length(grain->velocity));
        speed = fmax(speed, grain->radius * clod_vec3_length(grain->spin));
    }
    return speed;
}

/** Largest difference of velocity or surface speed of two runs, over the fastest motion. */
static double difference(const clod_verify_deck *deck, const clod_verify_impact *one,
                         const clod_verify_impact *other)
{
    double most = 0.0;
    for (int k = 0; k < (one->b == CLOD_VERIFY_ON_WALL ? 1 : 2); k++) {
        const double radius = deck->grains[k == 0 ? one->a : one->b].radius;
        const double v = clod_vec3_length(clod_vec3_sub(one->v[k], other->v[k]));
        const double w = clod_vec3_length(clod_vec3_sub(one->w[k], other->w[k]));
        most = clod_verify_larger(most, clod_verify_larger(v, radius * w));
    }
    return most / fastest(deck, one);
}

/**
 * What rounding can change, over the speed of impact. A step rounds each coordinate of a grain
 * of size up to L by at most u L, u = 2^-53: a jump of the overlap by at most 2 sqrt(3) u L for
 * two grains. A jump r at force F changes the energy by F r <= F_max r, and the energy of an
 * impact is (2/5) F_max d_max (Hertz; less sharp laws hold less), so N steps in contact change
 * the speed of parting by at most (5/4) N 2 sqrt(3) u L/d_max. What the normal force does
 * wrong, friction does to the slip, whose mass is 2/7 of the normal one: 7/2 of it.
 */
static double rounding(const clod_verify_deck *deck, const clod_verify_impact *impact)
{
    const double unit = 0.5 * DBL_EPSILON;
    const double amplified = 1.25 * 3.5 * 2.0 * sqrt(3.0) * (double)impact->steps;
    return amplified * unit * clod_verify_deck_reach(deck) / impact->peak_overlap;
}

#define ROUNDING_SOURCE                                                                        \
    "rigid motions change nothing; tolerance: (35/8) 2 sqrt(3) N u L/d_max, "                  \
    "src/verify/impact.c"

/** Compare a run in another frame with the plain one. */
static bool compare(const clod_verify_bench *bench, const clod_verify_deck *deck,
                    const clod_verify_frame *frame, const clod_verify_impact *plain,
                    const clod_verify_impact *other, int count, clod_status *status)
{
    double most = 0.0;
    double allowed = 0.0;
    int worst = 0;
    for (int k = 0; k < count; k++) {
        const double off = difference(deck, &plain[k], &other[k]);
        const double limit = rounding(deck, &plain[k]);
        if (k == 0 || (!(off / limit <= most / allowed) && !isnan(most))) {
            most = off;
            allowed = limit;
            worst = k;
        }
    }
    const clod_verify_expect nothing = {0.0, allowed, false, ROUNDING_SOURCE};
    return clod_verify_bench_check(
        bench, &nothing, most, status,
        "%s, %s: change of velocities over speed, worst of %d (no. %d)", deck->name,
        frame->name, count, worst + 1);
}

/** Did the swapped frame really turn the order in which the engine meets each pair? */
static bool check_order(const clod_verify_bench *bench, const clod_verify_deck *deck,
                        const clod_verify_impact *plain, const clod_verify_impact *swapped,
                        int count, clod_status *status)
{
    int turned = 0;
    for (int k = 0; k < count; k++) {
        turned += plain[k].a_first != swapped[k].a_first;
    }
    const clod_verify_expect all = {count, 0.0, false,
                                    "lower along n comes first (src/step/order.c)"};
    return clod_verify_bench_check(bench, &all, turned, status,
                                   "%s: pairs met in both orders [1]", deck->name);
}

bool clod_verify_impact_frames(const clod_verify_bench *bench, const clod_verify_deck *deck,
                               clod_verify_impact *impacts, int count, clod_status *status)
{
    CLOD_ASSERT(count <= CLOD_VERIFY_IMPACTS);
    const clod_verify_frame frames[] = {clod_verify_frame_swapped(),
                                        clod_verify_frame_turned()};
    clod_verify_impact other[CLOD_VERIFY_IMPACTS];
    const clod_verify_frame plain = clod_verify_frame_plain();
    watch first = {.impacts = impacts, .count = count};
    if (!run(bench, deck, &plain, &first, status)) {
        return false;
    }
    for (int f = 0; f < 2; f++) {
        for (int k = 0; k < count; k++) {
            other[k] = (clod_verify_impact){.a = impacts[k].a, .b = impacts[k].b};
        }
        watch again = {.impacts = other, .count = count};
        if (!run(bench, deck, &frames[f], &again, status) ||
            !compare(bench, deck, &frames[f], impacts, other, count, status)) {
            return false;
        }
        if (f == 0 && impacts[0].b != CLOD_VERIFY_ON_WALL &&
            !check_order(bench, deck, impacts, other, count, status)) {
            return false;
        }
    }
    return true;
}
