#include "report/figure_map.h"

#include <math.h>
#include <stdlib.h>

#include "report/figure_scale.h"

const char *const CLOD_FIGURE_MAP_COLOUR[CLOD_FIGURE_MAP_COLOURS] = {
    "#440154", "#46327e", "#365c8d", "#277f8e", "#1fa187", "#4ac16d", "#a0da39", "#fde725"};

void clod_figure_map_set(clod_figure *figure, const clod_figure_map *map)
{
    clod_figure_map *self = &figure->map;
    *self = *map;
    figure->equal = true;
    if (self->number == NULL) {
        figure->lost = true;
        return;
    }
    clod_figure_map_share(figure, 1);
}

void clod_figure_map_share(clod_figure *figures, size_t count)
{
    double least = 0.0, most = -HUGE_VAL;
    for (size_t f = 0; f < count; f++) {
        const clod_figure_map *map = &figures[f].map;
        for (size_t k = 0; map->number != NULL && k < map->columns * map->rows; k++) {
            if (isfinite(map->number[k])) {
                least = fmin(least, map->number[k]);
                most = fmax(most, map->number[k]);
            }
        }
    }
    most = fmax(most, least < 0.0 ? 0.0 : most);
    if (!(most > least)) {
        most = least + 1.0;
    }
    for (size_t f = 0; f < count; f++) {
        figures[f].map.least = least;
        figures[f].map.most = most;
    }
}

int clod_figure_map_shade(const clod_figure_map *self, double value)
{
    if (!isfinite(value)) {
        return -1;
    }
    const double at = (value - self->least) / (self->most - self->least);
    return (int)fmin(floor(at * CLOD_FIGURE_MAP_SHADES), CLOD_FIGURE_MAP_SHADES - 1);
}

void clod_figure_map_colour(int shade, char text[8])
{
    const double at = (CLOD_FIGURE_MAP_COLOURS - 1) * (shade + 0.5) / CLOD_FIGURE_MAP_SHADES;
    const int below = (int)at;
    const long from = strtol(CLOD_FIGURE_MAP_COLOUR[below] + 1, NULL, 16);
    const long to = strtol(CLOD_FIGURE_MAP_COLOUR[below + 1] + 1, NULL, 16);
    long colour = 0;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const double one = (double)(from >> shift & 255), other = (double)(to >> shift & 255);
        colour |= lround(one + (at - below) * (other - one)) << shift;
    }
    snprintf(text, 8, "#%06lx", (unsigned long)colour);
}

/** Cells of one shade, those beside each other in a row as one rectangle; whether there are any. */
static bool put_cells(FILE *out, const clod_figure_map *self, int shade, const char *begin)
{
    bool any = false;
    for (size_t r = 0; r < self->rows; r++) {
        const double *row = self->number + r * self->columns;
        for (size_t c = 0, end; c < self->columns; c = end) {
            end = c + 1;
            if (clod_figure_map_shade(self, row[c]) != shade) {
                continue;
            }
            while (end < self->columns && clod_figure_map_shade(self, row[end]) == shade) {
                end++;
            }
            fprintf(out, "%sM%zu %zuh%zuv1h-%zuz", any ? "" : begin, c, r, end - c, end - c);
            any = true;
        }
    }
    return any;
}

void clod_figure_map_svg(FILE *out, const clod_figure_map *self,
                         const clod_figure_map_place *place)
{
    // the stroke closes the gaps that viewers leave between neighbours
    fprintf(
        out,
        "<g class=\"map\" stroke-width=\"0.06\" transform=\"matrix(%.6g 0 0 %.6g %.1f %.1f)\">\n",
        (place->right - place->left) / (double)self->columns,
        (place->top - place->bottom) / (double)self->rows, place->left, place->bottom);
    for (int k = 0; k < CLOD_FIGURE_MAP_SHADES; k++) {
        char colour[8], begin[64];
        clod_figure_map_colour(k, colour);
        snprintf(begin, sizeof begin, "<path fill=\"%s\" stroke=\"%s\" d=\"", colour, colour);
        if (put_cells(out, self, k, begin)) {
            fputs("\"/>\n", out);
        }
    }
    fputs("</g>\n", out);
}

void clod_figure_map_bar(FILE *out, const char *name, const clod_figure_map *self,
                         const clod_figure_map_place *place)
{
    const double x = place->right + 16.0, height = place->bottom - place->top;
    fprintf(out, "<linearGradient id=\"bar-%s\" x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\">", name);
    for (int k = 0; k < CLOD_FIGURE_MAP_COLOURS; k++) {
        fprintf(out, "<stop offset=\"%.4f\" stop-color=\"%s\"/>",
                k / (CLOD_FIGURE_MAP_COLOURS - 1.0), CLOD_FIGURE_MAP_COLOUR[k]);
    }
    fprintf(out,
            "</linearGradient>\n<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"%.1f\" "
            "fill=\"url(#bar-%s)\"/>\n",
            x, place->top, height, name);
    clod_figure_scale scale;
    clod_figure_scale_colours(&scale, self);
    const int stride = clod_figure_scale_stride(&scale, height, 16.0);
    for (int k = 0; k < clod_figure_scale_ticks(&scale); k += stride) {
        char text[32];
        const double value = clod_figure_scale_tick(&scale, k, text);
        const double y = place->bottom - height * clod_figure_scale_at(&scale, value);
        fprintf(out,
                "<path d=\"M%.1f %.1fh4\" stroke=\"#1d2733\"/>\n"
                "<text x=\"%.1f\" y=\"%.1f\">%s</text>\n",
                x + 14.0, y, x + 21.0, y + 4.5, text);
    }
}
