#include <math.h>
#include <time.h>

#include "base/random.h"
#include "sim/check.h"
#include "step/step.h"

// The packing on which the step is timed is the preflight's own: a periodic cubic lattice of
// grains of the mean size that just touch, six contacts for each as in a dense bed, stirred a
// little, without adhesion, weight or walls. Nothing of a case can make it go wrong.
#define SIDE_MIN 6 ///< grains along an edge, twice what the period needs for the skins
#define SIDE_MAX 32
#define OVERLAP 1e-4      ///< of a radius
#define STEP_FRACTION 0.1 ///< of the smallest critical step of any pair
#define SPEED 3e-3        ///< m/s at most along each axis, as between neighbours in slow shear
#define WAY 1e-5          ///< radii in a step at most

#define WARM_UP 20         ///< steps
#define CHUNK_TIME 1.5e-3  ///< s; the best of many is free of other work on the machine
#define CHUNK_STEPS 1000   ///< at most
#define MEASURE_TIME 0.03  ///< s on the clock, of one measurement
enum { MEASUREMENTS = 5 }; ///< their spread is told

#define BUSY 0.9       ///< part of a processor below which other programs have the rest
#define DISTURBED 0.7  ///< part of the gain that is expected below which the threads had none
#define WAIT_TIME 3e-6 ///< s of a step in which threads wait for each other, at barriers

/** What a number of threads did with the packing. */
typedef struct timing {
    double steps, processor, clock; ///< s of this thread's processor, s on the clock
    double best;                    ///< s on the clock for a step, of the quickest chunk
    double slowest;                 ///< grain-steps/s of the slowest measurement
} timing;

static double seconds(clockid_t clock)
{
    struct timespec t;
    clock_gettime(clock, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static bool add_grain(const clod_check_subject *subject, double radius, int side, int number,
                      clod_state *state, clod_status *status)
{
    const double spacing = (2.0 - OVERLAP) * radius;
    const double density = subject->from->materials[subject->material].density;
    const int cell[3] = {number % side, number / side % side, number / (side * side)};
    const double most = fmin(SPEED, WAY * radius / state->dt);
    double place[4] = {0.0, 0.0, 0.0, radius};
    double speed[3];
    for (int a = 0; a < 3; a++) {
        const double u =
            clod_random_uniform(1, CLOD_RANDOM_VELOCITY, (uint64_t)number, (uint64_t)a);
        place[a] = (0.5 + cell[a]) * spacing;
        speed[a] = (2.0 * u - 1.0) * most;
    }
    return clod_grains_add(&state->grains, place, speed, (double[3]){0.0}, density,
                           (uint16_t)subject->material, (uint64_t)number + 1, status);
}

static bool make_packing(const clod_check_subject *subject, const clod_check_report *report,
                         clod_state *state, clod_status *status)
{
    const double edge = round(cbrt((double)report->grains));
    const int side = (int)fmin(fmax(edge, SIDE_MIN), SIDE_MAX);
    const double period = side * (2.0 - OVERLAP) * report->radius_mean;
    *state = (clod_state){.dt = STEP_FRACTION * subject->timestep.limit, .build_motion = -1.0};
    for (int a = 0; a < 3; a++) {
        state->domain.max[a] = period;
        state->domain.periodic[a] = true;
    }
    bool good = true;
    for (int n = 0; good && n < side * side * side; n++) {
        good = add_grain(subject, report->radius_mean, side, n, state, status);
    }
    return good;
}

/** What state and step take; room that is never used takes none. */
static clod_check_bytes count_bytes(const clod_step *step)
{
    const clod_neighbour *near = &step->neighbour;
    const clod_near *list = &step->near;
    const clod_state *state = step->state;
    const double grains = (double)state->grains.capacity;
    const double rows = grains * ((3 * 4 + 8 + 2 + 4) * sizeof(double) + sizeof(uint16_t) +
                                  4 * sizeof(float)); // with build_position, skin and origin
    const double contacts = (double)state->contact_count * (double)sizeof(clod_contact);
    const double candidates =
        (double)near->pairs.count * sizeof(clod_partner) + grains * sizeof(uint32_t);
    const double sorting = 2.0 * (double)near->sort_capacity * sizeof(clod_sort_item) +
                           (double)near->grain_capacity * 3 * sizeof(int32_t);
    const double blocks = (double)list->pairs.count * (double)sizeof(clod_contact_block) +
                          (double)list->between.share_capacity * 8 * sizeof(double);
    const double ledger =
        list->ledger ? grains * (8 + 4) * sizeof(double) +
                           (double)list->pairs.count * (double)sizeof(clod_dissipation_block)
                     : 0.0;
    const double count = (double)state->grains.count;
    return (clod_check_bytes){contacts / count, blocks / count, sorting / count,
                              (rows + candidates + ledger) / count};
}

/** One measurement: chunks of steps for a while. */
static bool measure_once(clod_step *step, int64_t chunk, timing *self, clod_status *status)
{
    const double begin = seconds(CLOCK_MONOTONIC);
    double now = begin;
    double steps = 0.0;
    while (now - begin < MEASURE_TIME) {
        const double before = now;
        if (!clod_step_advance(step, chunk, status)) {
            return false;
        }
        now = seconds(CLOCK_MONOTONIC);
        steps += (double)chunk;
        self->best = fmin(self->best, (now - before) / (double)chunk);
    }
    self->steps += steps;
    self->slowest =
        fmin(self->slowest, steps * (double)step->state->grains.count / (now - begin));
    return true;
}

static bool measure(clod_step *step, timing *self, clod_status *status)
{
    *self = (timing){.best = HUGE_VAL, .slowest = HUGE_VAL};
    const double warm = seconds(CLOCK_MONOTONIC);
    if (!clod_step_advance(step, WARM_UP, status)) {
        return false;
    }
    const double each = (seconds(CLOCK_MONOTONIC) - warm) / WARM_UP;
    const int64_t chunk = (int64_t)fmin(fmax(CHUNK_TIME / each, 1.0), CHUNK_STEPS);
    const double clock = seconds(CLOCK_MONOTONIC);
    const double processor = seconds(CLOCK_THREAD_CPUTIME_ID);
    bool good = true;
    for (int m = 0; good && m < MEASUREMENTS; m++) {
        good = measure_once(step, chunk, self, status);
    }
    self->clock = seconds(CLOCK_MONOTONIC) - clock;
    self->processor = seconds(CLOCK_THREAD_CPUTIME_ID) - processor;
    return good;
}

/** Time the step on a copy of the packing. */
static bool time_step(const clod_check_subject *subject, const clod_state *packing, int threads,
                      const clod_laws *laws, clod_check_report *report, clod_check_bytes *bytes,
                      timing *timed, clod_status *status)
{
    clod_state state = {0};
    clod_step step = {0};
    const clod_step_options options = {.threads = threads, .simd = subject->options->simd};
    bool good = clod_state_copy(&state, packing, status) &&
                clod_step_init(&step, &state, laws, &options, status) &&
                (!subject->from->output.energy || clod_step_open_ledger(&step, status)) &&
                measure(&step, timed, status) && clod_step_export(&step, status);
    if (good) {
        *bytes = count_bytes(&step);
        report->simd = step.kernel->name;
    }
    clod_step_fini(&step);
    clod_state_fini(&state);
    return good;
}

/**
 * What more threads gain: the ratio of the quickest chunks, in which all had their processors.
 * On a busy machine there may be no such chunk, though one thread had its processor all the
 * time: then what equal parts of the work and the waiting for each other let expect.
 */
static double gain_of(const timing *one, const timing *all, clod_check_report *report)
{
    const double threads = report->threads;
    const double measured = fmin(one->best / all->best, threads);
    const double step = one->processor / one->steps;
    const double expected = step / (step / threads + WAIT_TIME);
    report->busy = report->busy || measured < DISTURBED * expected;
    return report->busy ? fmax(measured, expected) : measured;
}

/** The rate of one thread is that of its processor, whatever else runs there. */
static bool measure_rates(const clod_check_subject *subject, const clod_state *packing,
                          const clod_laws *laws, clod_check_report *report,
                          clod_check_bytes *bytes, clod_status *status)
{
    timing one, all;
    if (!time_step(subject, packing, 1, laws, report, bytes, &one, status)) {
        return false;
    }
    const double grains = (double)packing->grains.count;
    const double rate = one.steps * grains / one.processor;
    double gain = 1.0;
    report->processor_share = fmin(1.0, one.processor / one.clock);
    report->busy = report->processor_share < BUSY;
    all = one;
    if (report->threads > 1) {
        if (!time_step(subject, packing, report->threads, laws, report, bytes, &all, status)) {
            return false;
        }
        gain = gain_of(&one, &all, report);
    }
    report->rate_one = rate;
    report->rate = gain * rate;
    report->rate_slowest = fmin(all.slowest, report->rate);
    return true;
}

bool clod_check_rate(const clod_check_subject *subject, clod_check_report *report,
                     clod_check_bytes *bytes, clod_status *status)
{
    clod_state packing = {0};
    clod_laws laws = {0};
    bool good = clod_laws_init(&laws, subject->from, status);
    if (good) {
        clod_laws_set_adhesion(&laws, 0.0);
        good = make_packing(subject, report, &packing, status) &&
               measure_rates(subject, &packing, &laws, report, bytes, status);
    }
    report->timed_grains = packing.grains.count;
    clod_state_fini(&packing);
    clod_laws_fini(&laws);
    if (!good && status->code != CLOD_USAGE) { // no fault of the case: do without
        clod_check_note(report,
                        "time on the clock and memory are not estimated: the step could not be "
                        "timed on the preflight's own packing (%s)",
                        status->text);
        *status = (clod_status){CLOD_OK, ""};
        good = true;
    }
    return good;
}
