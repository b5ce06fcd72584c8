#include "report/figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"

#define ARC 91 ///< points of half a circle

const char *const CLOD_FIGURE_COLOUR[CLOD_FIGURE_COLOURS] = {
    "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};

const char *const CLOD_FIGURE_GREY_COLOUR = "#6b7078";

/** Copy a text into an array, the end of one that is too long. */
#define COPY(to, from) clod_text_fit(to, sizeof(to), sizeof(to), from, strlen(from))

void clod_figure_init(clod_figure *self, const char *name, const char *title)
{
    *self = (clod_figure){.x.factor = 1.0, .y.factor = 1.0};
    snprintf(self->name, sizeof self->name, "%s", name);
    for (char *at = self->name; *at != '\0'; at++) {
        const bool plain = (*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z') ||
                           (*at >= '0' && *at <= '9');
        if (!plain) {
            *at = '-';
        }
    }
    COPY(self->title, title);
}

void clod_figure_axis_set(clod_figure_axis *self, const char *text, const char *unit,
                          double factor)
{
    COPY(self->text, text);
    snprintf(self->unit, sizeof self->unit, "%s", strcmp(unit, "1") == 0 ? "" : unit);
    self->factor = factor;
}

/** The points that are kept: [most] numbers of them, rising; how many. */
static size_t choose_points(size_t count, const double *y, size_t *kept)
{
    const size_t groups = CLOD_FIGURE_MOST / 2 - 1;
    size_t used = 0;
    for (size_t g = 0; g < groups; g++) {
        const size_t from = g * count / groups;
        const size_t end = (g + 1) * count / groups;
        size_t least = from;
        size_t most = from;
        for (size_t i = from; i < end; i++) {
            least = isnan(y[least]) || y[i] < y[least] ? i : least;
            most = isnan(y[most]) || y[i] > y[most] ? i : most;
        }
        if (g == 0 && least > 0 && most > 0) {
            kept[used++] = 0;
        }
        kept[used++] = least < most ? least : most;
        if (least != most) {
            kept[used++] = least < most ? most : least;
        }
    }
    if (kept[used - 1] != count - 1) {
        kept[used++] = count - 1;
    }
    return used;
}

/** Owned copy of some of the numbers; NULL of none. */
static double *pick(const double *from, const size_t *kept, size_t count, bool *lost)
{
    double *to = from != NULL ? clod_memory_alloc(count, sizeof *to) : NULL;
    *lost = *lost || (from != NULL && to == NULL);
    for (size_t i = 0; to != NULL && i < count; i++) {
        to[i] = from[kept != NULL ? kept[i] : i];
    }
    return to;
}

void clod_figure_add(clod_figure *self, const char *name, clod_figure_style style, int number,
                     size_t count, const double *x, const double *y, const double *error)
{
    if (count == 0) {
        return;
    }
    clod_figure_curve *grown =
        clod_memory_grow(self->curves, self->count, self->count + 1, sizeof *grown);
    size_t kept[CLOD_FIGURE_MOST];
    if (grown == NULL) {
        self->lost = true;
        return;
    }
    self->curves = grown;
    clod_figure_curve *curve = &self->curves[self->count++];
    *curve = (clod_figure_curve){.style = style, .colour = number, .count = count};
    if (number >= 0) {
        curve->colour = number % CLOD_FIGURE_COLOURS;
        curve->round = number / CLOD_FIGURE_COLOURS % CLOD_FIGURE_ROUNDS;
    }
    COPY(curve->name, name);
    if (number >= CLOD_FIGURE_COLOURS * CLOD_FIGURE_ROUNDS && self->again[0] == '\0') {
        COPY(self->again, name);
    }
    const bool thin = count > CLOD_FIGURE_MOST;
    curve->count = thin ? choose_points(count, y, kept) : count;
    curve->x = pick(x, thin ? kept : NULL, curve->count, &self->lost);
    curve->y = pick(y, thin ? kept : NULL, curve->count, &self->lost);
    curve->error = pick(error, thin ? kept : NULL, curve->count, &self->lost);
    curve->count = self->lost ? 0 : curve->count;
}

void clod_figure_circle(clod_figure *self, const char *name, clod_figure_style style,
                        int number, double centre, double radius)
{
    double x[ARC], y[ARC];
    if (!isfinite(centre) || !isfinite(radius) || radius <= 0.0) {
        return;
    }
    for (int k = 0; k < ARC; k++) {
        const double angle = M_PI * (1.0 - k / (ARC - 1.0));
        x[k] = centre + radius * cos(angle);
        y[k] = k == 0 || k == ARC - 1 ? 0.0 : radius * sin(angle);
    }
    clod_figure_add(self, name, style, number, ARC, x, y, NULL);
}

const char *clod_figure_dashes(const clod_figure_curve *curve)
{
    static const char *const DASHES[CLOD_FIGURE_STYLES][CLOD_FIGURE_ROUNDS] = {
        [CLOD_FIGURE_LINE] = {"", "7 3 2 3", "14 4", "14 3 2 3"},
        [CLOD_FIGURE_THIN] = {"", "7 3 2 3", "14 4", "14 3 2 3"},
        [CLOD_FIGURE_DASHED] = {"7 4", "7 3 2 3 2 3", "4 2", "14 3 6 3"},
        [CLOD_FIGURE_DOTTED] = {"2 4", "2 3 2 8", "2 8", "2 3 2 3 2 8"},
        [CLOD_FIGURE_DASH_DOT] = {"7 3 2 3", "7 3 2 3", "7 3 2 3", "7 3 2 3"}};
    const char *found = DASHES[curve->style][curve->round];
    return found != NULL ? found : "";
}

bool clod_figure_alike(const clod_figure *self, char text[256])
{
    if (self->again[0] != '\0') {
        char again[64];
        COPY(again, self->again);
        snprintf(text, 256, "From %s on, curves look like earlier ones.", again);
    }
    return self->again[0] != '\0';
}

size_t clod_figure_begin(const double *x, size_t rows)
{
    size_t first = 0;
    while (first + 1 < rows && x[first + 1] == 0.0) {
        first++;
    }
    return first;
}

bool clod_figure_shows(const clod_figure *self)
{
    for (size_t c = 0; c < self->count; c++) {
        for (size_t i = 0; i < self->curves[c].count; i++) {
            if (isfinite(self->curves[c].x[i]) && isfinite(self->curves[c].y[i])) {
                return true;
            }
        }
    }
    const size_t cells = self->map.number != NULL ? self->map.columns * self->map.rows : 0;
    for (size_t k = 0; k < cells; k++) {
        if (isfinite(self->map.number[k])) {
            return true;
        }
    }
    return false;
}

void clod_figure_fini(clod_figure *self)
{
    for (size_t c = 0; c < self->count; c++) {
        clod_memory_free(self->curves[c].x);
        clod_memory_free(self->curves[c].y);
        clod_memory_free(self->curves[c].error);
    }
    clod_memory_free(self->curves);
    clod_memory_free(self->map.number);
    *self = (clod_figure){0};
}
