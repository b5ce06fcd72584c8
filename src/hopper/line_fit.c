#include "hopper/line_fit.h"

#include <math.h>

#include "hopper/chance.h"

#define ROUNDS 10 // until weights and slope fit; three would do

double clod_line_fit_error(const clod_curve *curve, const clod_curve_point *point, double slope)
{
    double both = point->joint ? point->part[0] * point->x_error : 0.0;
    for (size_t s = 0; s < curve->specimens && point->spread != NULL && point->x_spread != NULL;
         s++) {
        both += isnan(point->spread[s]) ? 0.0 : point->spread[s] * point->x_spread[s];
    }
    const double across = slope * point->x_error;
    return sqrt(
        fmax(0.0, point->y_error * point->y_error + across * across - 2.0 * slope * both));
}

/** Degrees of freedom of the errors, the fewest of all points. */
static size_t freedom_of(const clod_curve *curve)
{
    size_t least = 0;
    for (size_t i = 0; i < curve->count; i++) {
        const size_t freedom = curve->points[i].by_line > 0.0 ? 0 : curve->points[i].freedom;
        least = freedom > 0 && (least == 0 || freedom < least) ? freedom : least;
    }
    return least;
}

static bool all_have_errors(const clod_curve *curve, double slope)
{
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        if (!(clod_curve_stated(point) > 0.0 &&
              clod_line_fit_error(curve, point, slope) > 0.0)) {
            return false;
        }
    }
    return true;
}

/** Weights by the errors across the line, which has the slope that the weights make. */
static void weigh(clod_curve *curve)
{
    for (int round = 0; round < ROUNDS; round++) {
        const double slope = clod_curve_fit(curve).b;
        for (size_t i = 0; i < curve->count; i++) {
            const double error = clod_line_fit_error(curve, &curve->points[i], slope);
            curve->points[i].weight = 1.0 / (error * error);
        }
    }
}

static void compare(clod_curve *curve)
{
    clod_curve_misfit *self = &curve->misfit;
    self->chi_square = 0.0;
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        const double off = (point->y - self->line.a - self->line.b * point->x) /
                           clod_line_fit_error(curve, point, self->line.b);
        self->chi_square += off * off;
    }
    self->freedom = curve->count - 2;
    if (self->freedom > 0) {
        self->chance = clod_chance_above(self->chi_square, self->freedom, self->specimens);
        const bool further = self->specimens > 0 ? clod_line_fit_misses(self)
                                                 : self->chi_square > (double)self->freedom;
        self->stretch = further ? sqrt(self->chi_square / (double)self->freedom) : 1.0;
    }
}

void clod_line_fit_weigh(clod_curve *curve)
{
    clod_curve_misfit *self = &curve->misfit;
    *self = (clod_curve_misfit){.chi_square = (double)NAN, .chance = (double)NAN};
    for (size_t i = 0; i < curve->count; i++) {
        curve->points[i].weight = 0.0;
    }
    if (curve->way != CLOD_CURVE_LINE || curve->count < 2) {
        return;
    }
    const bool known = all_have_errors(curve, clod_curve_fit(curve).b);
    self->specimens = freedom_of(curve);
    for (size_t i = 0; i < curve->count; i++) {
        self->unsure = self->unsure || curve->points[i].unsure;
    }
    self->weighted = known && self->specimens == 0 && !self->unsure;
    if (self->weighted) {
        weigh(curve);
    }
    self->line = clod_curve_fit(curve);
    self->stretch = 1.0;
    if (known) {
        compare(curve);
    }
}

bool clod_line_fit_misses(const clod_curve_misfit *self)
{
    return self->freedom > 0 && self->chance < CLOD_LINE_FIT_RARE;
}
