#include "hopper/interval.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "hopper/critical.h"
#include "hopper/draw.h"
#include "hopper/samples.h"
#include "hopper/specimens.h"
#include "hopper/told.h"
#include "parallel/threads.h"

#define JOBS 64
#define SAMPLE_TOLERANCE 1e-6 // of the stress field: far below any error of measurement
#define COARSEST 1e-3         // what that tolerance changes at most, relatively

/** What one sample found. */
typedef struct sample {
    clod_hopper_outcome outcome[CLOD_HOPPER_SHAPES];
    double number[CLOD_HOPPER_SHAPES][CLOD_HOPPER_NUMBERS];
    bool flows[CLOD_HOPPER_SHAPES]; ///< through the planned outlet
    bool held[CLOD_HOPPER_SHAPES];  ///< at it, by the wall
    double hole[CLOD_HOPPER_HOLES];
    double slot;                                         ///< m: width in funnel flow
    double drawn[CLOD_HOPPER_SHAPES][CLOD_SOLID_CURVES]; ///< at the critical state as measured
} sample;

typedef struct task {
    const clod_hopper *hopper;
    sample *samples;
    size_t count;
    sample measured; ///< that of the values as they were measured
    bool lost[JOBS]; ///< no memory
} task;

/** To sort the samples in. */
typedef struct rooms {
    double *numbers;          ///< [(CLOD_SOLID_CURVES + 1) x samples]
    clod_samples_item *items; ///< [samples]
} rooms;

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
    const double angle = slides ? at.half_angle : 0.0;
    number[CLOD_HOPPER_HALF_ANGLE] =
        found->wish.half_angle > 0.0 ? found->wish.half_angle : angle;
    number[CLOD_HOPPER_OUTLET] = slides ? at.outlet : (double)INFINITY;
    number[CLOD_HOPPER_FLOW_FACTOR] = slides ? at.flow_factor : none;
    number[CLOD_HOPPER_SIGMA_1] = critical ? at.state.sigma_1 : none;
    number[CLOD_HOPPER_STRENGTH] = critical ? at.state.strength : none;
    number[CLOD_HOPPER_PHI_E] = critical ? at.state.phi_e : none;
    number[CLOD_HOPPER_PHI_W] = critical ? at.state.phi_w : none;
    number[CLOD_HOPPER_RHO] = critical ? at.state.rho : none;
    number[CLOD_HOPPER_ARCH] = slides ? at.arch : none;
    number[CLOD_HOPPER_DESIGN_PHI_W] = slides ? at.design_state.phi_w : none;
    number[CLOD_HOPPER_MARGIN] = none;
    if (asked_for_margin(found)) {
        clod_hopper_wish built =
            found->wish; // its angle is that of the design, not of a sample
        built.half_angle = found->design.half_angle;
        built.first = found->design.design_state.sigma_1;
        number[CLOD_HOPPER_MARGIN] = clod_hopper_margin_of(solid, &built, found->planned).ratio;
    }
}

/** Whether the planned outlet lets the solid flow: no arch over it, nor over wider parts of the hopper above. */
static bool flows_through(const clod_solid *solid, const clod_hopper_found *found,
                          const double number[CLOD_HOPPER_NUMBERS])
{
    if (!(number[CLOD_HOPPER_MARGIN] >= 1.0) || number[CLOD_HOPPER_OUTLET] <= found->planned) {
        return number[CLOD_HOPPER_MARGIN] >= 1.0;
    }
    clod_hopper_wish built = found->wish; // not the half angle of this sample
    built.half_angle = found->design.half_angle;
    const clod_hopper_design at = clod_critical_settle(solid, &built);
    return at.outcome != CLOD_HOPPER_ARCHES &&
           !(at.outcome == CLOD_HOPPER_FLOWS && at.outlet > found->planned);
}

/** @param limit  rad, those of the wishes in this sample; 0: a cone's */
static void design_sample(const task *self, const clod_solid *solid,
                          const double limit[CLOD_HOPPER_SHAPES], sample *to)
{
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_hopper_found found = self->hopper->shape[s];
        found.wish.limit = limit[s];
        found.wish.tolerance = SAMPLE_TOLERANCE;
        found.wish.first = found.design.state.sigma_1;
        clod_interval_numbers(solid, &found, &to->outcome[s], to->number[s]);
        double *margin = &to->number[s][CLOD_HOPPER_MARGIN];
        to->held[s] = asked_for_margin(&found) && isnan(*margin);
        if (to->held[s]) {
            *margin = 0.0; // what does not slide does not flow
        }
        to->flows[s] = flows_through(solid, &found, to->number[s]);
    }
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_samples_values(solid, &self->hopper->shape[s].design.state, to->drawn[s]);
    }
    const clod_rathole hole = clod_rathole_of(solid, &self->hopper->silo);
    to->hole[CLOD_HOPPER_EMPTYING] = hole.emptying;
    to->hole[CLOD_HOPPER_FILLING] = hole.filling;
    to->slot = clod_rathole_slot_of(solid).width;
}

static void copy_points(const clod_solid *from, clod_solid *to)
{
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        if (from->curves[k].count > 0) {
            memcpy(to->curves[k].points, from->curves[k].points,
                   from->curves[k].count * sizeof *from->curves[k].points);
        }
    }
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
        to->curves[k].points = at;
        at += from->curves[k].count;
    }
    if (*owned != NULL) {
        copy_points(from, to);
    }
    return *owned != NULL;
}

/** Put what a specimen alone says in place of the means; false: it is not in all points. */
static bool take_specimen(const clod_solid *measured, size_t specimen, clod_solid *to)
{
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const clod_curve *from = &measured->curves[k];
        const bool shear = from->specimens > 0 && from->test == CLOD_CURVE_SHEAR;
        for (size_t i = 0; i < from->count && shear; i++) {
            const clod_curve_point *point = &from->points[i];
            clod_curve_point *own = &to->curves[k].points[i];
            own->x =
                clod_specimens_value_of(point->x, point->x_spread, from->specimens, specimen);
            own->y =
                clod_specimens_value_of(point->y, point->spread, from->specimens, specimen);
            if (isnan(own->x) || isnan(own->y)) {
                return false;
            }
        }
        clod_curve_sort(&to->curves[k]);
    }
    return true;
}

static void design_specimen(const clod_hopper *self, const clod_solid *solid,
                            clod_hopper_specimen *to)
{
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_hopper_outcome outcome;
        double number[CLOD_HOPPER_NUMBERS];
        clod_interval_numbers(solid, &self->shape[s], &outcome, number);
        to->half_angle[s] = number[CLOD_HOPPER_HALF_ANGLE];
        to->outlet[s] = number[CLOD_HOPPER_OUTLET];
    }
}

bool clod_interval_specimens(clod_hopper *self, clod_status *status)
{
    const size_t specimens = self->solid.seeds != NULL ? self->solid.strength.specimens : 0;
    clod_solid solid;
    clod_curve_point *owned;
    bool good = copy_solid(&self->solid, &solid, &owned);
    solid.strength.misfit.stretch = 0.0; // the line of a specimen is that of its points
    self->specimens = clod_memory_alloc(specimens, sizeof *self->specimens);
    good = good && (self->specimens != NULL || specimens == 0);
    for (size_t s = 0; s < specimens && good; s++) {
        copy_points(&self->solid, &solid);
        if (take_specimen(&self->solid, s, &solid)) {
            clod_hopper_specimen *to = &self->specimens[self->specimen_count++];
            to->seed = self->solid.seeds[s];
            design_specimen(self, &solid, to);
        }
    }
    self->specimen_count = self->specimen_count > 1 ? self->specimen_count : 0;
    clod_memory_free(owned);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the specimens.");
}

static void run_job(void *context, int number)
{
    task *self = context;
    const clod_chunk chunk = clod_threads_chunk(self->count, number, JOBS);
    clod_solid solid;
    clod_curve_point *owned;
    clod_draw draw;
    const bool copied = copy_solid(&self->hopper->solid, &solid, &owned);
    const bool begun =
        clod_draw_init(&draw, &self->hopper->solid, (uint64_t)self->hopper->from.interval.seed);
    self->lost[number] = !copied || !begun;
    for (size_t i = chunk.begin; i < chunk.end && !self->lost[number]; i++) {
        double limit[CLOD_HOPPER_SHAPES];
        for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
            const clod_hopper_found *found = &self->hopper->shape[s];
            limit[s] = clod_draw_limit(&draw, i, found->wish.limit, found->limit_error);
        }
        clod_draw_solid(&draw, i, &solid);
        design_sample(self, &solid, limit, &self->samples[i]);
    }
    clod_draw_fini(&draw);
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
    clod_told_no_interval(value);
    if (count > 0 && !isnan(value->value)) {
        const double scale = finer(value->value, number_at(&self->measured, offset));
        const double tail = 0.5 * (1.0 - self->hopper->from.interval.level);
        value->low = scale * clod_samples_quantile(room, count, tail);
        value->high = scale * clod_samples_quantile(room, count, 1.0 - tail);
        value->low_error = scale * clod_samples_quantile_error(room, count, tail);
        value->high_error = scale * clod_samples_quantile_error(room, count, 1.0 - tail);
    }
    return (double)count / (double)self->count;
}

/** The outlets of the samples that have a critical one. */
static void put_arched(const task *self, int s, double *room, clod_hopper_found *found)
{
    const double tail = 0.5 * (1.0 - self->hopper->from.interval.level);
    size_t count = 0;
    for (size_t i = 0; i < self->count; i++) {
        const double outlet = self->samples[i].number[s][CLOD_HOPPER_OUTLET];
        if (isfinite(outlet) && outlet > 0.0) {
            room[count++] = outlet;
        }
    }
    qsort(room, count, sizeof *room, by_size);
    found->arched_low = count > 0 ? clod_samples_quantile(room, count, tail) : (double)NAN;
    found->arched_high =
        count > 0 ? clod_samples_quantile(room, count, 1.0 - tail) : (double)NAN;
}

/** All outlets of a shape. */
static void put_quantiles(const task *self, int s, double *room, clod_hopper_found *found)
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
}

/** Of which measured curves the spread of the outlets comes. */
static void put_causes(const task *self, int s, const rooms *room, clod_hopper_found *found)
{
    const bool critical = clod_hopper_is_critical(&found->design);
    double *column[CLOD_SOLID_CURVES] = {NULL};
    double *outlet = room->numbers;
    size_t count = 0;
    for (size_t k = 0; k < CLOD_SOLID_CURVES && critical; k++) {
        const bool told =
            k != CLOD_SOLID_WALL || clod_curve_has_errors(&self->hopper->solid.wall);
        if (k != CLOD_SOLID_PHI_T && told) { // phi_t: which only the rathole needs
            column[k] = room->numbers + (k + 1) * self->count;
        }
    }
    for (size_t i = 0; i < self->count; i++) {
        const sample *from = &self->samples[i];
        if (isnan(from->number[s][CLOD_HOPPER_OUTLET])) {
            continue;
        }
        outlet[count] = from->number[s][CLOD_HOPPER_OUTLET];
        for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
            if (column[k] != NULL) {
                column[k][count] = from->drawn[s][k];
            }
        }
        count++;
    }
    found->untold =
        clod_samples_shares(column, outlet, critical ? count : 0, room->items, found->cause);
}

/** Shares of outcomes, and of samples in which the planned outlet does not let the solid flow. */
static void put_shares(const task *self, int s, clod_hopper_found *found)
{
    size_t of[CLOD_HOPPER_OUTCOMES] = {0};
    size_t arching = 0, held = 0;
    for (size_t i = 0; i < self->count; i++) {
        of[self->samples[i].outcome[s]]++;
        arching += self->samples[i].flows[s] ? 0 : 1;
        held += self->samples[i].held[s] ? 1 : 0;
    }
    for (int k = 0; k < CLOD_HOPPER_OUTCOMES; k++) {
        found->share[k] = (double)of[k] / (double)self->count;
    }
    found->arching = (double)arching / (double)self->count;
    found->held = (double)held / (double)self->count;
}

static void collect(const task *self, const rooms *all, clod_hopper *to)
{
    double *room = all->numbers;
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
            const size_t place = (size_t)(s * CLOD_HOPPER_NUMBERS + n) * sizeof(double);
            put_interval(self, offsetof(sample, number) + place, room, &to->shape[s].number[n]);
        }
        put_shares(self, s, &to->shape[s]);
        put_arched(self, s, room, &to->shape[s]);
        put_quantiles(self, s, room, &to->shape[s]);
        put_causes(self, s, all, &to->shape[s]);
        clod_told_forget(to, &to->shape[s]);
    }
    for (size_t h = 0; h < CLOD_HOPPER_HOLES; h++) {
        to->holed[h] = put_interval(self, offsetof(sample, hole) + h * sizeof(double), room,
                                    &to->rathole[h]);
    }
    put_interval(self, offsetof(sample, slot), room, &to->slot_width);
    if (!clod_told_strength(to)) {
        clod_told_no_interval(&to->rathole[CLOD_HOPPER_EMPTYING]);
        clod_told_no_interval(&to->rathole[CLOD_HOPPER_FILLING]);
        clod_told_no_interval(&to->slot_width);
    }
}

bool clod_interval_fill(clod_hopper *self, clod_status *status)
{
    task all = {.hopper = self, .count = (size_t)self->from.interval.samples};
    all.samples = clod_memory_alloc(all.count, sizeof *all.samples);
    rooms room = {clod_memory_alloc((CLOD_SOLID_CURVES + 1) * all.count, sizeof *room.numbers),
                  clod_memory_alloc(all.count, sizeof *room.items)};
    bool good = all.samples != NULL && room.numbers != NULL && room.items != NULL;
    if (good) {
        double limit[CLOD_HOPPER_SHAPES];
        for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
            limit[s] = self->shape[s].wish.limit;
        }
        design_sample(&all, &self->solid, limit, &all.measured);
        clod_threads_run(JOBS, clod_threads_available(), run_job, &all);
        for (int job = 0; job < JOBS; job++) {
            good = good && !all.lost[job];
        }
    }
    if (good) {
        collect(&all, &room, self);
    }
    clod_memory_free(room.items);
    clod_memory_free(room.numbers);
    clod_memory_free(all.samples);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the samples.");
}
