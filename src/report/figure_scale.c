#include "report/figure_scale.h"

#include <math.h>
#include <stdio.h>

static double place_of(const clod_figure_scale *self, double value)
{
    return self->log ? log10(value) : value;
}

static void widen(clod_figure_scale *self, double value)
{
    if (isfinite(value)) {
        self->min = fmin(self->min, value);
        self->max = fmax(self->max, value);
    }
}

/** A step that makes four to nine of them. */
static double choose_step(double range)
{
    const double power = pow(10.0, floor(log10(range / 4.0)));
    const double ratio = range / 4.0 / power;
    return power * (ratio >= 5.0 ? 5.0 : ratio >= 2.0 ? 2.0 : 1.0);
}

/** A range as it is. */
static clod_figure_scale scale_of(double min, double max)
{
    return (clod_figure_scale){.min = min, .max = max, .step = choose_step(max - min)};
}

void clod_figure_scale_colours(clod_figure_scale *self, const clod_figure_map *map)
{
    *self = scale_of(map->least * map->value.factor, map->most * map->value.factor);
}

void clod_figure_scale_make(clod_figure_scale *self, const clod_figure *of, bool y)
{
    const double factor = y ? of->y.factor : of->x.factor;
    if (of->map.number != NULL) {
        const size_t cells = y ? of->map.rows : of->map.columns;
        const double low = of->map.low[y];
        *self = scale_of(low * factor, (low + (double)cells * of->map.step[y]) * factor);
        return;
    }
    *self = (clod_figure_scale){.min = HUGE_VAL, .max = -HUGE_VAL, .log = !y && of->log_x};
    for (size_t c = 0; c < of->count; c++) {
        const clod_figure_curve *curve = &of->curves[c];
        for (size_t i = 0; i < curve->count; i++) {
            const double value = y ? curve->y[i] : curve->x[i];
            const double error =
                y && curve->error != NULL && isfinite(curve->error[i]) ? curve->error[i] : 0.0;
            widen(self, place_of(self, (value - error) * factor));
            widen(self, place_of(self, (value + error) * factor));
        }
    }
    if (of->from_zero || of->equal) {
        widen(self, 0.0);
    }
    if (!(self->max >= self->min)) {
        self->min = 0.0;
        self->max = 1.0;
    } else if (self->max - self->min <= 1e-9 * fabs(self->max)) {
        const double room = self->max != 0.0 ? 0.1 * fabs(self->max) : 1.0;
        self->min -= room;
        self->max += room;
    }
    self->step = self->log ? 1.0 : choose_step(self->max - self->min);
    self->min = self->step * floor(self->min / self->step + 1e-9);
    self->max = self->step * ceil(self->max / self->step - 1e-9);
}

double clod_figure_scale_at(const clod_figure_scale *self, double value)
{
    return (place_of(self, value) - self->min) / (self->max - self->min);
}

/** Number of the first tick, counted from 0. */
static double first_tick(const clod_figure_scale *self)
{
    return ceil(self->min / self->step - 1e-9);
}

int clod_figure_scale_ticks(const clod_figure_scale *self)
{
    return (int)(floor(self->max / self->step + 1e-9) - first_tick(self)) + 1;
}

int clod_figure_scale_stride(const clod_figure_scale *self, double length, double room)
{
    return (int)fmax(1.0, ceil(room * (self->max - self->min) / (self->step * length)));
}

double clod_figure_scale_tick(const clod_figure_scale *self, int k, char text[32])
{
    const double value = self->step * (first_tick(self) + k);
    if (self->log) {
        snprintf(text, 32, "%g", pow(10.0, value));
        return pow(10.0, value);
    }
    const double largest = fmax(fabs(self->min), fabs(self->max));
    if (largest >= 1e5 || largest < 1e-3) {
        snprintf(text, 32, "%.4g", value);
    } else {
        const double digits = -floor(log10(self->step) + 1e-9);
        snprintf(text, 32, "%.*f", digits > 0.0 ? (int)digits : 0, value == 0.0 ? 0.0 : value);
    }
    return value;
}
