#include "report/calibration_figures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/html.h"
#include "report/shear_rows.h"
#include "report/table.h"

#define BINS 24     ///< of a histogram
#define CLOUD 400   ///< samples of a pair of parameters that are shown
#define TARGETS 128 ///< of a figure

/** A parameter and its samples. */
typedef struct parameter {
    const char *name, *unit;
    double from, to, mean, low, high;
    bool log;
    double *sample; ///< [count] owned; NULL: none
    size_t count;
} parameter;

static void take_parameter(parameter *self, const char *name, const json_t *about,
                           const clod_table *samples)
{
    const char *scale = json_string_value(json_object_get(about, "scale"));
    const char *unit = json_string_value(json_object_get(about, "unit"));
    const int at = clod_table_find(samples, name);
    *self = (parameter){.name = name,
                        .unit = unit != NULL ? unit : "",
                        .from = clod_shear_number(about, "from"),
                        .to = clod_shear_number(about, "to"),
                        .mean = clod_shear_number(about, "mean"),
                        .low = clod_shear_number(about, "low"),
                        .high = clod_shear_number(about, "high"),
                        .log = scale != NULL && strcmp(scale, "log") == 0,
                        .count = samples->rows};
    self->sample = at >= 0 ? clod_table_numbers(samples, at) : NULL;
}

/** A place on the scale of the prior, which is even there. */
static double on_scale(const parameter *self, double value)
{
    return self->log ? log(value) : value;
}

static double off_scale(const parameter *self, double place)
{
    return self->log ? exp(place) : place;
}

/** A line up to `height` at a value. */
static void add_upright(clod_figure *figure, const char *name, clod_figure_style style,
                        double value, double height)
{
    const double x[2] = {value, value}, y[2] = {0.0, height};
    if (isfinite(value)) {
        clod_figure_add(figure, name, style, 1, 2, x, y, NULL);
    }
}

/** The outline of the histogram of the samples, as a multiple of the prior's density. Returns its height. */
static double add_histogram(clod_figure *figure, const parameter *self)
{
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (size_t k = 0; k < self->count; k++) {
        const double place = on_scale(self, self->sample[k]);
        least = fmin(least, place);
        most = fmax(most, place);
    }
    const double prior = on_scale(self, self->to) - on_scale(self, self->from);
    const double step = (most - least) / BINS;
    double share[BINS] = {0.0}, x[2 * BINS + 2], y[2 * BINS + 2], highest = 1.0;
    if (!(step > 0.0) || !(prior > 0.0)) {
        return highest;
    }
    for (size_t k = 0; k < self->count; k++) {
        const double bin = floor((on_scale(self, self->sample[k]) - least) / step);
        share[bin < BINS ? (size_t)bin : BINS - 1] += 1.0 / (double)self->count;
    }
    for (size_t b = 0; b <= BINS; b++) {
        x[2 * b] = x[2 * b + 1] = off_scale(self, least + (double)b * step);
        y[2 * b] = b == 0 ? 0.0 : share[b - 1] * prior / step;
        y[2 * b + 1] = b == BINS ? 0.0 : share[b] * prior / step;
        highest = fmax(highest, y[2 * b]);
    }
    clod_figure_add(figure, "posterior", CLOD_FIGURE_LINE, 0, 2 * BINS + 2, x, y, NULL);
    return highest;
}

static void put_marginal(clod_sheet *sheet, const parameter *self, double level)
{
    char title[CLOD_FIGURE_TITLE], name[CLOD_FIGURE_NAME], interval[64];
    clod_figure figure;
    clod_text_fit(name, sizeof name, sizeof name, self->name, strlen(self->name));
    snprintf(title, sizeof title, "Posterior of %s", name);
    clod_figure_init(&figure, title, title);
    clod_figure_axis_set(&figure.x, self->name, self->unit, 1.0);
    clod_figure_axis_set(&figure.y, "density over that of the prior", "", 1.0);
    figure.log_x = self->log;
    if (self->sample != NULL && self->count > 0) {
        const double highest = add_histogram(&figure, self);
        const double x[4] = {self->from, self->from, self->to, self->to};
        const double y[4] = {0.0, 1.0, 1.0, 0.0};
        snprintf(interval, sizeof interval, "%.3g %% interval", 100.0 * level);
        clod_figure_add(&figure, "prior", CLOD_FIGURE_DASHED, CLOD_FIGURE_GREY, 4, x, y, NULL);
        add_upright(&figure, "mean", CLOD_FIGURE_LINE, self->mean, highest);
        add_upright(&figure, interval, CLOD_FIGURE_DOTTED, self->low, highest);
        add_upright(&figure, "", CLOD_FIGURE_DOTTED, self->high, highest);
    }
    clod_sheet_figure(sheet, &figure);
}

/** Samples of two parameters over each other. */
static void put_pair(clod_sheet *sheet, const parameter *a, const parameter *b)
{
    char title[CLOD_FIGURE_TITLE], first[CLOD_FIGURE_NAME / 2], second[CLOD_FIGURE_NAME / 2];
    double x[CLOUD], y[CLOUD];
    size_t count = 0;
    clod_figure figure;
    clod_text_fit(first, sizeof first, sizeof first, a->name, strlen(a->name));
    clod_text_fit(second, sizeof second, sizeof second, b->name, strlen(b->name));
    snprintf(title, sizeof title, "Posterior of %s and %s", first, second);
    clod_figure_init(&figure, title, title);
    clod_figure_axis_set(&figure.x, a->name, a->unit, 1.0);
    clod_figure_axis_set(&figure.y, b->name, b->unit, 1.0);
    figure.log_x = a->log;
    if (a->sample != NULL && b->sample != NULL) {
        const size_t stride = (a->count + CLOUD - 1) / CLOUD;
        for (size_t k = 0; k < a->count; k += stride) {
            x[count] = a->sample[k];
            y[count++] = b->sample[k];
        }
        const double side[5] = {a->from, a->to, a->to, a->from, a->from};
        const double up[5] = {b->from, b->from, b->to, b->to, b->from};
        clod_figure_add(&figure, "samples of the posterior", CLOD_FIGURE_DOTS, 0, count, x, y,
                        NULL);
        clod_figure_add(&figure, "mean", CLOD_FIGURE_HOLLOW, 1, 1, &a->mean, &b->mean, NULL);
        clod_figure_add(&figure, "prior", CLOD_FIGURE_DASHED, CLOD_FIGURE_GREY, 5, side, up,
                        NULL);
    }
    clod_sheet_figure(sheet, &figure);
}

/** Targets of one unit: those that were used, or those that were held back. */
typedef struct crowd {
    double x[TARGETS], y[TARGETS];                 ///< measured, predicted
    double bar_x[3 * TARGETS], bar_y[3 * TARGETS]; ///< intervals, with gaps between
    size_t count;
} crowd;

static const char *unit_of(const json_t *target)
{
    const char *unit = json_string_value(json_object_get(target, "unit"));
    return unit != NULL ? unit : "";
}

static void gather(crowd *self, const json_t *targets, const char *unit, bool held_back,
                   double range[2])
{
    size_t k;
    const json_t *target;
    self->count = 0;
    json_array_foreach(targets, k, target)
    {
        const bool back = json_is_true(json_object_get(target, "held_back"));
        const size_t n = self->count;
        if (strcmp(unit_of(target), unit) != 0 || back != held_back || n == TARGETS) {
            continue;
        }
        const double measured = clod_shear_number(target, "measured");
        const double low = clod_shear_number(target, "low");
        const double high = clod_shear_number(target, "high");
        self->x[n] = self->bar_x[3 * n] = self->bar_x[3 * n + 1] = measured;
        self->y[n] = clod_shear_number(target, "model");
        self->bar_y[3 * n] = low;
        self->bar_y[3 * n + 1] = high;
        self->bar_x[3 * n + 2] = self->bar_y[3 * n + 2] = (double)NAN;
        range[0] = fmin(range[0], fmin(measured, low));
        range[1] = fmax(range[1], fmax(measured, high));
        self->count++;
    }
}

static void add_crowd(clod_figure *figure, const crowd *self, const char *name,
                      clod_figure_style style, int colour)
{
    clod_figure_add(figure, "", CLOD_FIGURE_LINE, colour, 3 * self->count, self->bar_x,
                    self->bar_y, NULL);
    clod_figure_add(figure, name, style, colour, self->count, self->x, self->y, NULL);
}

static void put_predicted(clod_sheet *sheet, const json_t *targets, const char *unit,
                          double level)
{
    crowd used, back;
    double range[2] = {HUGE_VAL, -HUGE_VAL};
    char title[CLOD_FIGURE_TITLE];
    clod_figure figure;
    gather(&used, targets, unit, false, range);
    gather(&back, targets, unit, true, range);
    snprintf(title, sizeof title, "Predicted over measured%s%.64s",
             unit[0] != '\0' ? ", in " : "", unit);
    clod_figure_init(&figure, "predicted", title);
    clod_figure_axis_set(&figure.x, "measured", unit, 1.0);
    clod_figure_axis_set(&figure.y, "predicted", unit, 1.0);
    clod_figure_add(&figure, "predicted as measured", CLOD_FIGURE_DASHED, CLOD_FIGURE_GREY, 2,
                    range, range, NULL);
    add_crowd(&figure, &used, "targets that were used", CLOD_FIGURE_POINTS, 0);
    add_crowd(&figure, &back, "held back", CLOD_FIGURE_HOLLOW, 1);
    snprintf(figure.note, sizeof figure.note,
             "Bars: %.3g %% intervals of what a laboratory would measure.", 100.0 * level);
    clod_sheet_figure(sheet, &figure);
}

/** One figure for each unit, in the order of the targets. */
static void put_all_predicted(clod_sheet *sheet, const json_t *targets, double level)
{
    size_t k;
    const json_t *target;
    json_array_foreach(targets, k, target)
    {
        bool seen = false;
        for (size_t j = 0; j < k; j++) {
            const char *earlier = unit_of(json_array_get(targets, j));
            seen = seen || strcmp(earlier, unit_of(target)) == 0;
        }
        if (!seen) {
            put_predicted(sheet, targets, unit_of(target), level);
        }
    }
}

bool clod_calibration_figures_posterior(clod_sheet *sheet, const char *folder,
                                        const json_t *result, clod_status *status)
{
    const double level = clod_shear_number(result, "level");
    json_t *all = json_object_get(result, "parameters");
    json_t *about;
    const char *name;
    size_t count = 0;
    clod_table samples;
    parameter *list = clod_memory_alloc(json_object_size(all) + 1, sizeof *list);
    bool good = clod_table_read(&samples, folder, "posterior.csv", status);
    if (good && list == NULL) {
        good = clod_status_fail(status, CLOD_FAILED, "No memory for the figures of the page.");
    }
    json_object_foreach(all, name, about)
    {
        if (good) {
            take_parameter(&list[count++], name, about, &samples);
        }
    }
    clod_html_section(sheet->body, "posterior", "Posterior and prediction");
    clod_sheet_columns(sheet, true);
    for (size_t k = 0; k < count; k++) {
        put_marginal(sheet, &list[k], level);
    }
    for (size_t k = 0; k < count; k++) {
        for (size_t j = k + 1; j < count; j++) {
            put_pair(sheet, &list[k], &list[j]);
        }
    }
    put_all_predicted(sheet, json_object_get(result, "targets"), level);
    clod_sheet_columns(sheet, false);
    for (size_t k = 0; k < count; k++) {
        clod_memory_free(list[k].sample);
    }
    clod_memory_free(list);
    clod_table_fini(&samples);
    return good;
}
