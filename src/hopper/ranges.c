#include "hopper/ranges.h"

#include <math.h>

#include "hopper/critical.h"

#define NO_STRESS 1e-6 // of a measured one
#define ANY_STRESS 1e6 // of a measured one
#define CLOSE 1e-6     // relative distance of bounds of a stress

/** What is looked through. */
typedef struct search {
    clod_ranges_probe is_clear;
    const void *context;
    clod_ranges found;
    bool clear;         // at the last stress
    double last, begin; // Pa; m: where the range began
} search;

/** The stress between two at which the probe changes its mind, and its size. */
static double change_of(const search *self, double low, double high, double *size)
{
    while (high > low * (1.0 + CLOSE)) {
        const double middle = sqrt(low * high);
        if (self->is_clear(self->context, middle, size) == self->clear) {
            low = middle;
        } else {
            high = middle;
        }
    }
    self->is_clear(self->context, self->clear ? low : high, size);
    return low;
}

/** Put a range before the others; the smallest is lost where there are too many. */
static void add(clod_ranges *self, clod_range range)
{
    self->count = self->count < CLOD_RANGES_MOST ? self->count + 1 : CLOD_RANGES_MOST;
    for (size_t k = self->count; k-- > 1;) {
        self->of[k] = self->of[k - 1];
    }
    self->of[0] = range;
}

/** Go on to a stress. */
static void go_to(search *self, double sigma_1, bool clear)
{
    double size = 0.0;
    if (clear != self->clear) {
        change_of(self, self->last, sigma_1, &size);
        if (clear) {
            self->begin = size;
        } else {
            add(&self->found, (clod_range){self->begin, size});
        }
    }
    self->clear = clear;
    self->last = sigma_1;
}

clod_ranges clod_ranges_find(const clod_curve *strength, double critical,
                             clod_ranges_probe is_clear, const void *context)
{
    const clod_curve_point *points = strength->points;
    const size_t count = strength->count;
    double size = 0.0;
    search self = {.is_clear = is_clear, .context = context};
    self.last = NO_STRESS * fmin(points[0].x, critical);
    self.clear = is_clear(context, self.last, &size);
    for (size_t k = 0; k < count && points[k].x < critical; k++) {
        go_to(&self, points[k].x, is_clear(context, points[k].x, &size));
    }
    go_to(&self, isfinite(critical) ? critical : ANY_STRESS * points[count - 1].x, false);
    return self.found;
}

/** A hopper. */
typedef struct hopper {
    const clod_solid *solid;
    clod_hopper_wish wish;
} hopper;

static bool no_arch_at(const void *context, double sigma_1, double *size)
{
    const hopper *self = context;
    clod_hopper_design at = {0};
    if (!clod_critical_shape(self->solid, &self->wish, sigma_1, &at)) {
        return false;
    }
    *size = clod_critical_outlet(&at);
    return at.state.strength * at.flow_factor <= sigma_1;
}

clod_ranges clod_ranges_of_outlets(const clod_solid *solid, const clod_hopper_wish *wish,
                                   const clod_hopper_design *design)
{
    const bool arches = design->outcome == CLOD_HOPPER_ARCHES;
    hopper of = {solid, *wish};
    of.wish.half_angle = design->half_angle;
    return (arches || clod_hopper_is_critical(design)) && design->half_angle > 0.0
               ? clod_ranges_find(&solid->strength,
                                  arches ? (double)INFINITY : design->state.sigma_1, no_arch_at,
                                  &of)
               : (clod_ranges){0};
}

bool clod_ranges_hold(const clod_ranges *self, double size)
{
    bool holds = false;
    for (size_t k = 0; k < self->count; k++) {
        holds = holds || (size >= self->of[k].from && size <= self->of[k].to);
    }
    return holds;
}
