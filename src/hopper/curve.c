#include "hopper/curve.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"

#define PARALLEL 1e-9 // of slopes: closer ones do not meet

/** y = a + b x from x = `from` on. */
typedef struct piece {
    double from, a, b;
} piece;

static int by_x(const void *left, const void *right)
{
    const double a = ((const clod_curve_point *)left)->x;
    const double b = ((const clod_curve_point *)right)->x;
    return (a > b) - (a < b);
}

bool clod_curve_has_errors(const clod_curve *self)
{
    bool all = self->count > 0;
    for (size_t i = 0; i < self->count; i++) {
        const clod_curve_point *point = &self->points[i];
        all = all && (point->y_error > 0.0 || point->spread != NULL);
    }
    return all;
}

double clod_curve_stated(const clod_curve_point *point)
{
    return point->by_line > 0.0 ? 0.0 : point->y_error;
}

void clod_curve_sort(clod_curve *self)
{
    if (self->count > 1) {
        qsort(self->points, self->count, sizeof *self->points, by_x);
    }
}

void clod_curve_fini(clod_curve *self)
{
    clod_memory_free(self->points);
    clod_memory_free(self->spread);
    *self = (clod_curve){0};
}

static piece through(const clod_curve_point *p, const clod_curve_point *q, double from)
{
    const double b = (q->y - p->y) / (q->x - p->x);
    return (piece){from, p->y - b * p->x, b};
}

clod_curve_line clod_curve_fit(const clod_curve *self)
{
    double all = 0.0, x = 0.0, y = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        all += self->points[i].weight;
    }
    const double alike = all > 0.0 ? 0.0 : 1.0 / (double)self->count;
    const double unit = all > 0.0 ? 1.0 / all : 0.0;
    for (size_t i = 0; i < self->count; i++) {
        const double share = alike + unit * self->points[i].weight;
        x += share * self->points[i].x;
        y += share * self->points[i].y;
    }
    double sxx = 0.0, sxy = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        const double share = alike + unit * self->points[i].weight;
        const double dx = self->points[i].x - x;
        sxx += share * dx * dx;
        sxy += share * dx * (self->points[i].y - y);
    }
    const clod_curve_line line = {y - sxy / sxx * x, sxy / sxx};
    const clod_curve_misfit *misfit = &self->misfit;
    if (misfit->stretch <= 1.0) {
        return line;
    }
    return (clod_curve_line){misfit->line.a + misfit->stretch * (line.a - misfit->line.a),
                             misfit->line.b + misfit->stretch * (line.b - misfit->line.b)};
}

static size_t piece_count(const clod_curve *self)
{
    if (self->way == CLOD_CURVE_LINE || self->count == 1) {
        return 1;
    }
    return self->way == CLOD_CURVE_EXTENDED ? self->count - 1 : self->count + 1;
}

/** Piece k of the curve, in ascending order; the first begins at 0. */
static piece piece_at(const clod_curve *self, size_t k)
{
    const clod_curve_point *p = self->points;
    const size_t n = self->count;
    if (self->way == CLOD_CURVE_HELD) {
        if (k == 0 || k == n) {
            return (piece){k == 0 ? 0.0 : p[n - 1].x, k == 0 ? p[0].y : p[n - 1].y, 0.0};
        }
        return through(&p[k - 1], &p[k], p[k - 1].x);
    }
    if (n == 1) {
        return (piece){0.0, 0.0, p[0].y / p[0].x};
    }
    if (self->way == CLOD_CURVE_LINE) {
        const clod_curve_line line = clod_curve_fit(self);
        return (piece){0.0, line.a, line.b};
    }
    return through(&p[k], &p[k + 1], k == 0 ? 0.0 : p[k].x);
}

double clod_curve_at(const clod_curve *self, double x)
{
    if (self->count == 0) {
        return (double)NAN;
    }
    size_t k = piece_count(self) - 1;
    piece at = piece_at(self, k);
    while (k > 0 && x < at.from) {
        at = piece_at(self, --k);
    }
    return fmax(0.0, at.a + at.b * x);
}

clod_curve_meeting clod_curve_meet(const clod_curve *self, double slope, double most, double *x)
{
    double end = most;
    for (size_t k = piece_count(self); k-- > 0;) {
        const piece at = piece_at(self, k);
        const double fall = slope - at.b;
        const bool above = at.a - fall * at.from > 0.0; // where the piece begins
        if (at.from >= end) {
            continue;
        }
        if (isinf(end) && (fall < 0.0 || (above && fall <= PARALLEL * slope))) {
            return CLOD_CURVE_ABOVE;
        }
        if (isfinite(end) && at.a - fall * end > 0.0) {
            *x = end;
            return CLOD_CURVE_MEETS;
        }
        if (above) {
            *x = at.a / fall;
            return CLOD_CURVE_MEETS;
        }
        end = at.from;
    }
    return CLOD_CURVE_BELOW;
}
