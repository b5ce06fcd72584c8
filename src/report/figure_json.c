#include "report/figure_json.h"

#include <math.h>

#include "output/series.h"
#include "report/figure_map.h"

void clod_figure_json_text(FILE *out, const char *text)
{
    fputs("\"", out);
    for (const char *at = text; *at != '\0'; at++) {
        const unsigned char c = (unsigned char)*at;
        if (c < 0x20 || c == '<' || c == '"' || c == '\\') {
            fprintf(out, "\\u%04x", c);
        } else {
            fputc(c, out);
        }
    }
    fputs("\"", out);
}

void clod_figure_json_number(FILE *out, double value)
{
    char text[CLOD_SERIES_NUMBER];
    if (!isfinite(value)) {
        fputs("null", out);
        return;
    }
    clod_series_number(text, value);
    fputs(text, out);
}

static void put_numbers(FILE *out, const char *name, const double *value, size_t count)
{
    if (value == NULL) {
        return;
    }
    fprintf(out, ",\"%s\":[", name);
    for (size_t i = 0; i < count; i++) {
        fputs(i > 0 ? "," : "", out);
        clod_figure_json_number(out, value[i]);
    }
    fputs("]", out);
}

static void put_axis(FILE *out, const char *name, const clod_figure_axis *axis)
{
    fprintf(out, ",\"%s\":{\"text\":", name);
    clod_figure_json_text(out, axis->text);
    fputs(",\"unit\":", out);
    clod_figure_json_text(out, axis->unit);
    fputs(",\"factor\":", out);
    clod_figure_json_number(out, axis->factor);
    fputs("}", out);
}

/** Numbers of a map to seven digits: colours need no more. */
static void put_map(FILE *out, const clod_figure_map *map)
{
    fputs(",\"map\":{\"colours\":[", out);
    for (int k = 0; k < CLOD_FIGURE_MAP_COLOURS; k++) {
        fprintf(out, "%s\"%s\"", k > 0 ? "," : "", CLOD_FIGURE_MAP_COLOUR[k]);
    }
    fputs("]", out);
    put_axis(out, "value", &map->value);
    put_numbers(out, "low", map->low, 2);
    put_numbers(out, "step", map->step, 2);
    put_numbers(out, "range", (const double[2]){map->least, map->most}, 2);
    fprintf(out, ",\"columns\":%zu,\"rows\":%zu,\"numbers\":[", map->columns, map->rows);
    for (size_t k = 0; k < map->columns * map->rows; k++) {
        fputs(k > 0 ? "," : "", out);
        if (isfinite(map->number[k])) {
            fprintf(out, "%.7g", map->number[k]);
        } else {
            fputs("null", out);
        }
    }
    fputs("]}", out);
}

void clod_figure_json(FILE *out, const clod_figure *figure)
{
    static const char *const STYLES[CLOD_FIGURE_STYLES] = {
        "line", "dashed", "dotted", "dashdot", "points", "hollow",
        "dots", "read",   "vague",  "thin",    "arrows"};
    fputs("{\"name\":", out);
    clod_figure_json_text(out, figure->name);
    fputs(",\"title\":", out);
    clod_figure_json_text(out, figure->title);
    fprintf(out, ",\"equal\":%s,\"from_zero\":%s,\"log_x\":%s",
            figure->equal ? "true" : "false", figure->from_zero ? "true" : "false",
            figure->log_x ? "true" : "false");
    put_axis(out, "x", &figure->x);
    put_axis(out, "y", &figure->y);
    if (figure->map.number != NULL) {
        put_map(out, &figure->map);
    }
    fputs(",\"curves\":[", out);
    for (size_t c = 0; c < figure->count; c++) {
        const clod_figure_curve *curve = &figure->curves[c];
        fputs(c > 0 ? ",\n{\"name\":" : "\n{\"name\":", out);
        clod_figure_json_text(out, curve->name);
        fprintf(out, ",\"style\":\"%s\",\"colour\":\"%s\"", STYLES[curve->style],
                curve->colour < 0 ? CLOD_FIGURE_GREY_COLOUR
                                  : CLOD_FIGURE_COLOUR[curve->colour]);
        fprintf(out, ",\"round\":%d,\"dashes\":\"%s\"", curve->round,
                clod_figure_dashes(curve));
        put_numbers(out, "x", curve->x, curve->count);
        put_numbers(out, "y", curve->y, curve->count);
        put_numbers(out, "error", curve->error, curve->count);
        fputs("}", out);
    }
    fputs("]}", out);
}
