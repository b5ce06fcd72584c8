#include "hopper/interval.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "hopper/samples.h"
#include "parallel/threads.h"

#define JOBS 64
#define SAMPLE_TOLERANCE 1e-6 // of the stress field: far below any error of measurement
#define COARSEST 1e-3         // what that tolerance changes at most, relatively
#define LEAST_ANGLE 0.02      // rad: what a drawn angle is kept within
#define MOST_ANGLE 1.5

/** What one sample found. */
typedef struct sample {
    clod_hopper_outcome outcome[CLOD_HOPPER_SHAPES];
    double number[CLOD_HOPPER_SHAPES][CLOD_HOPPER_NUMBERS];
    double hole[CLOD_HOPPER_HOLES];
    double drawn[CLOD_HOPPER_SHAPES][CLOD_SOLID_CURVES]; ///< at the critical state as measured
} sample;

typedef struct task {
    const clod_hopper *hopper;
    sample *samples;
    size_t count;
    sample measured; ///< that of the values as they were measured
    bool lost[JOBS]; ///< no memory
} task;

/** Whether there is an outlet, and a half angle above it. */
static bool asked_for_margin(const clod_hopper_found *found)
{
    return found->planned > 0.0 && found->design.outcome != CLOD_HOPPER_FUNNEL;
}

void clod_interval_numbers(const clod_solid *solid, const clod_hopper_found *found,
                           clod_hopper_outcome *outcome, double number[CLOD_HOPPER_NUMBERS])
{
    const clod_hopper_design at = clod_hopper_design_shape(solid, &found->wish);
    const bool slides = at.outcome != CLOD_HOPPER_FUNNEL;
    const bool critical = clod_hopper_is_critical(&at);
    const double none = (double)NAN;
    *outcome = at.outcome;
    number[CLOD_HOPPER_LIMIT] = at.limit;
    number[CLOD_HOPPER_HALF_ANGLE] = slides ? at.half_angle : 0.0;
    number[CLOD_HOPPER_OUTLET] = slides ? at.outlet : (double)INFINITY;
    number[CLOD_HOPPER_FLOW_FACTOR] = slides ? at.flow_factor : none;
    number[CLOD_HOPPER_SIGMA_1] = critical ? at.state.sigma_1 : none;
    number[CLOD_HOPPER_STRENGTH] = critical ? at.state.strength : none;
    number[CLOD_HOPPER_PHI_E] = critical ? at.state.phi_e : none;
    number[CLOD_HOPPER_PHI_W] = critical ? at.state.phi_w : none;
    number[CLOD_HOPPER_RHO] = critical ? at.state.rho : none;
    number[CLOD_HOPPER_ARCH] = slides ? at.arch : none;
    number[CLOD_HOPPER_MARGIN] = none;
    if (asked_for_margin(found)) {
        clod_hopper_wish built =
            found->wish; // its angle is that of the design, not of a sample
        built.half_angle = found->design.half_angle;
        number[CLOD_HOPPER_MARGIN] = clod_hopper_margin_of(solid, &built, found->planned).ratio;
    }
}

static double normal(const task *self, size_t item, uint64_t *draw)
{
    const uint64_t seed = (uint64_t)self->hopper->from.interval.seed;
    *draw += 2;
    return clod_random_normal(seed, CLOD_RANDOM_MEASURED, item, *draw - 2);
}

/** Draw the points of a curve: each for itself, and all of them with every specimen. */
static void draw_curve(const task *self, size_t item, const clod_curve *measured,
                       clod_curve *curve, uint64_t *draw)
{
    for (size_t i = 0; i < measured->count; i++) {
        const clod_curve_point *from = &measured->points[i];
        clod_curve_point *to = &curve->points[i];
        double shared = 0.0;
        for (size_t s = 0; from->spread != NULL && s < measured->specimens; s++) {
            shared += from->spread[s] * from->spread[s];
        }
        const double alone = sqrt(fmax(from->y_error * from->y_error - shared, 0.0));
        to->x = fmax(0.01 * from->x, from->x + from->x_error * normal(self, item, draw));
        to->y = from->y + alone * normal(self, item, draw);
    }
    for (size_t s = 0; s < measured->specimens; s++) {
        const double specimen = normal(self, item, draw);
        for (size_t i = 0; i < measured->count; i++) {
            const double *spread = measured->points[i].spread;
            curve->points[i].y += spread != NULL ? spread[s] * specimen : 0.0;
        }
    }
    for (size_t i = 0; i < measured->count; i++) {
        curve->points[i].y = fmax(0.0, curve->points[i].y);
    }
}

/** Draw every point of every curve; stresses stay positive, angles below a right one. */
static void draw_solid(const task *self, size_t item, clod_solid *solid)
{
    const clod_solid *measured = &self->hopper->solid;
    uint64_t draw = 0;
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        draw_curve(self, item, &measured->curves[k], &solid->curves[k], &draw);
    }
    for (size_t i = 0; i < solid->phi_e.count; i++) {
        clod_curve_point *point = &solid->phi_e.points[i];
        point->y = fmin(MOST_ANGLE, fmax(LEAST_ANGLE, point->y));
    }
    for (size_t i = 0; i < solid->rho.count; i++) {
        clod_curve_point *point = &solid->rho.points[i];
        point->y = fmax(0.01 * measured->rho.points[i].y, point->y);
    }
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        clod_curve_sort(&solid->curves[k]);
    }
}

static void design_sample(const task *self, const clod_solid *solid, sample *to)
{
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_hopper_found found = self->hopper->shape[s];
        found.wish.tolerance = SAMPLE_TOLERANCE;
        found.wish.first = found.design.state.sigma_1;
        clod_interval_numbers(solid, &found, &to->outcome[s], to->number[s]);
        double *margin = &to->number[s][CLOD_HOPPER_MARGIN];
        if (asked_for_margin(&found) && isnan(*margin)) {
            *margin = 0.0; // what does not slide does not flow
        }
    }
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_samples_values(solid, &self->hopper->shape[s].design.state, to->drawn[s]);
    }
    const clod_rathole hole = clod_rathole_of(solid, &self->hopper->silo);
    to->hole[CLOD_HOPPER_EMPTYING] = hole.emptying;
    to->hole[CLOD_HOPPER_FILLING] = hole.filling;
}

static void run_sample(const task *self, size_t item, clod_solid *solid)
{
    draw_solid(self, item, solid);
    design_sample(self, solid, &self->samples[item]);
}

/** Copies of all points, in one piece of memory, which the first curve owns. */
static bool copy_solid(const clod_solid *from, clod_solid *to, clod_curve_point **owned)
{
    size_t count = 0;
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        count += from->curves[k].count;
    }
    *to = *from;
    *owned = clod_memory_alloc(count, sizeof **owned);
    clod_curve_point *at = *owned;
    for (size_t k = 0; k < CLOD_SOLID_CURVES && *owned != NULL; k++) {
        if (from->curves[k].count > 0) {
            memcpy(at, from->curves[k].points, from->curves[k].count * sizeof *at);
        }
        to->curves[k].points = at;
        at += from->curves[k].count;
    }
    return *owned != NULL;
}

static void run_job(void *context, int number)
{
    task *self = context;
    const clod_chunk chunk = clod_threads_chunk(self->count, number, JOBS);
    clod_solid solid;
    clod_curve_point *owned;
    self->lost[number] = !copy_solid(&self->hopper->solid, &solid, &owned);
    for (size_t i = chunk.begin; i < chunk.end && !self->lost[number]; i++) {
        run_sample(self, i, &solid);
    }
    clod_memory_free(owned);
}

static int by_size(const void *left, const void *right)
{
    const double a = *(const double *)left;
    const double b = *(const double *)right;
    return (a > b) - (a < b);
}

/** The number that lies `offset` bytes into a sample. */
static double number_at(const sample *of, size_t offset)
{
    double number;
    memcpy(&number, (const char *)of + offset, sizeof number);
    return number;
}

/** By what a value differs from the same one at the tolerance of the samples. */
static double finer(double value, double coarse)
{
    const double ratio = value / coarse;
    return fabs(ratio - 1.0) < COARSEST ? ratio : 1.0; // not of other outcomes
}

/** The numbers that lie `offset` bytes into each sample, sorted; those that are NAN left out. */
static size_t sort_numbers(const task *self, size_t offset, double *room)
{
    size_t count = 0;
    for (size_t i = 0; i < self->count; i++) {
        const double number = number_at(&self->samples[i], offset);
        if (!isnan(number)) {
            room[count++] = number;
        }
    }
    qsort(room, count, sizeof *room, by_size);
    return count;
}

/**
 * Interval of a number that lies `offset` bytes into each sample; those that are NAN left out. A
 * number that is not known has none.
 *
 * @return  share of the samples that have the number
 */
static double put_interval(const task *self, size_t offset, double *room,
                           clod_hopper_value *value)
{
    const size_t count = sort_numbers(self, offset, room);
    value->low = value->high = (double)NAN;
    if (count > 0 && !isnan(value->value)) {
        const double scale = finer(value->value, number_at(&self->measured, offset));
        const double tail = 0.5 * (1.0 - self->hopper->from.interval.level);
        value->low = scale * clod_samples_quantile(room, count, tail);
        value->high = scale * clod_samples_quantile(room, count, 1.0 - tail);
    }
    return (double)count / (double)self->count;
}

/** All outlets of a shape, and of which measured curves their spread comes. */
static void put_spread(const task *self, int s, double *room, clod_hopper_found *found)
{
    const size_t offset =
        offsetof(sample, number) +
        (size_t)(s * CLOD_HOPPER_NUMBERS + CLOD_HOPPER_OUTLET) * sizeof(double);
    const size_t count = sort_numbers(self, offset, room);
    const double scale =
        finer(found->number[CLOD_HOPPER_OUTLET].value, number_at(&self->measured, offset));
    for (int q = 0; q < CLOD_HOPPER_QUANTILES; q++) {
        const double share = (double)q / (CLOD_HOPPER_QUANTILES - 1);
        found->quantile[q] =
            count > 0 ? scale * clod_samples_quantile(room, count, share) : (double)NAN;
    }
    double *drawn = room + self->count;
    for (size_t i = 0; i < self->count; i++) {
        room[i] = self->samples[i].number[s][CLOD_HOPPER_OUTLET];
    }
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        for (size_t i = 0; i < self->count; i++) {
            drawn[i] = self->samples[i].drawn[s][k];
        }
        found->cause[k] = clod_hopper_is_critical(&found->design)
                              ? clod_samples_share(drawn, room, self->count)
                              : (double)NAN;
    }
}

/** Shares of outcomes, and of samples in which the planned outlet does not let the solid flow. */
static void put_shares(const task *self, int s, clod_hopper_found *found)
{
    size_t of[CLOD_HOPPER_OUTCOMES] = {0};
    size_t arching = 0;
    for (size_t i = 0; i < self->count; i++) {
        of[self->samples[i].outcome[s]]++;
        arching += self->samples[i].number[s][CLOD_HOPPER_MARGIN] >= 1.0 ? 0 : 1;
    }
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        found->share[k] = (double)of[k] / (double)self->count;
    }
    found->arching = (double)arching / (double)self->count;
}

static void collect(const task *self, double *room, clod_hopper *to)
{
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
            const size_t place = (size_t)(s * CLOD_HOPPER_NUMBERS + n) * sizeof(double);
            put_interval(self, offsetof(sample, number) + place, room, &to->shape[s].number[n]);
        }
        put_shares(self, s, &to->shape[s]);
        put_spread(self, s, room, &to->shape[s]);
    }
    for (size_t h = 0; h < CLOD_HOPPER_HOLES; h++) {
        to->holed[h] = put_interval(self, offsetof(sample, hole) + h * sizeof(double), room,
                                    &to->rathole[h]);
    }
}

bool clod_interval_fill(clod_hopper *self, clod_status *status)
{
    task all = {.hopper = self, .count = (size_t)self->from.interval.samples};
    all.samples = clod_memory_alloc(all.count, sizeof *all.samples);
    double *room = clod_memory_alloc(2 * all.count, sizeof *room);
    bool good = all.samples != NULL && room != NULL;
    if (good) {
        design_sample(&all, &self->solid, &all.measured);
        clod_threads_run(JOBS, clod_threads_available(), run_job, &all);
        for (int job = 0; job < JOBS; job++) {
            good = good && !all.lost[job];
        }
    }
    if (good) {
        collect(&all, room, self);
    }
    clod_memory_free(room);
    clod_memory_free(all.samples);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the samples.");
}
