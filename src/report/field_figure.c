#include "report/field_figure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/figure_map.h"

#define MM 1e3
#define KILO 1e4        ///< Pa from which on kPa are shown
#define MOST_ARROWS 300 ///< of a figure
#define CORNERS 6       ///< points of an arrow: tail, tip, barb, tip, barb, gap
#define SHORTEST 0.02   ///< of the longest arrow: shorter ones are left out

/** What is shown of a field. */
static const struct {
    clod_field_slice_value value;
    const char *name, *title, *axis, *unit;
} SHOWN[CLOD_FIELD_FIGURES] = {
    {CLOD_FIELD_SLICE_DENSITY, "density", "bulk density", "bulk density", "kg/m3"},
    {CLOD_FIELD_SLICE_PRESSURE, "pressure", "pressure", "pressure, contact + kinetic", "Pa"},
    {CLOD_FIELD_SLICE_SPEED, "speed", "speed", "speed", "m/s"},
    {CLOD_FIELD_SLICE_COORDINATION, "coordination", "coordination", "contacts of a grain", ""},
};

void clod_field_figure_plane(const clod_field_slice *slice, char *text, size_t size)
{
    const char across = "xyz"[slice->across];
    snprintf(text, size, "Plane %c = %.6g mm: layer %ld of %ld of the grid's cells across %c%s",
             across, clod_field_slice_place(slice) * MM, slice->layer + 1,
             slice->cells[slice->across], across, slice->gravity ? "; gravity lies in it" : "");
}

/** The sentences below a figure. */
static void write_note(const clod_field_figure *self, char *note, size_t size)
{
    char plane[160], when[96], thinned[96] = "";
    const clod_field_slice *slice = self->slice;
    clod_field_figure_plane(slice, plane, sizeof plane);
    if (slice->stride > 1) {
        snprintf(thinned, sizeof thinned,
                 " One cell of each %ld x %ld is shown, as large as they.", slice->stride,
                 slice->stride);
    }
    if (self->moment != NULL) {
        snprintf(when, sizeof when, "The moment %.6g s", *self->moment);
    } else {
        snprintf(when, sizeof when, "Mean of %ld samples from %.6g s on",
                 (long)json_integer_value(json_object_get(self->grid, "samples")),
                 json_number_value(json_object_get(self->grid, "since_s")));
    }
    snprintf(note, size,
             "%s. %s; cells of %.6g mm, kernel of %.6g mm. Blank: nothing reached the cell.%s",
             plane, when, slice->cell * MM,
             json_number_value(json_object_get(self->grid, "width_m")) * MM, thinned);
}

/** A map of one value of the slice. */
static clod_figure_map map_of(const clod_field_slice *slice, clod_field_slice_value value)
{
    const double edge = slice->cell * (double)slice->stride;
    const size_t count = slice->columns * slice->rows;
    clod_figure_map map = {.columns = slice->columns,
                           .rows = slice->rows,
                           .low = {slice->corner[slice->right], slice->corner[slice->up]},
                           .step = {edge, edge},
                           .number = clod_memory_alloc(count, sizeof *map.number)};
    if (map.number != NULL) {
        memcpy(map.number, slice->value[value], count * sizeof *map.number);
    }
    return map;
}

/** One arrow in the plane, its middle at a place, its tip and tail `half` from it. */
static void draw_arrow(const double middle[2], const double half[2], double *x, double *y)
{
    const double tip[2] = {middle[0] + half[0], middle[1] + half[1]};
    x[0] = middle[0] - half[0];
    y[0] = middle[1] - half[1];
    x[1] = x[3] = tip[0];
    y[1] = y[3] = tip[1];
    for (int side = 0; side < 2; side++) {
        const double turn = side == 0 ? 0.35 : -0.35; // of the length, either side
        x[2 + 2 * side] = tip[0] - 0.6 * half[0] - turn * half[1];
        y[2 + 2 * side] = tip[1] - 0.6 * half[1] + turn * half[0];
    }
    x[5] = y[5] = (double)NAN;
}

/** Every how manieth cell has an arrow. */
static size_t arrow_stride(const clod_field_slice *slice)
{
    size_t stride = 1;
    while (((slice->columns + stride - 1) / stride) * ((slice->rows + stride - 1) / stride) >
           MOST_ARROWS) {
        stride++;
    }
    return stride;
}

/** Speed in the plane of a cell. */
static double speed_of(const clod_field_slice *slice, size_t cell)
{
    return hypot(slice->value[CLOD_FIELD_SLICE_RIGHT][cell],
                 slice->value[CLOD_FIELD_SLICE_UP][cell]);
}

double clod_field_figure_fastest(const clod_field_slice *slice)
{
    const size_t stride = arrow_stride(slice);
    double most = 0.0;
    for (size_t r = stride / 2; r < slice->rows; r += stride) {
        for (size_t c = stride / 2; c < slice->columns; c += stride) {
            most =
                fmax(most, speed_of(slice, r * slice->columns + c)); // of no number: as it is
        }
    }
    return most;
}

/** Velocities of some of the cells; the arrow of `fastest` reaches nearly from one of them to the next. */
static void add_arrows(clod_figure *figure, const clod_field_slice *slice, double fastest)
{
    const size_t stride = arrow_stride(slice);
    const double edge = slice->cell * (double)slice->stride;
    const double scale = 0.45 * edge * (double)stride / fastest;
    double x[CORNERS * MOST_ARROWS], y[CORNERS * MOST_ARROWS];
    char name[96];
    size_t used = 0;
    for (size_t r = stride / 2; r < slice->rows; r += stride) {
        for (size_t c = stride / 2; c < slice->columns; c += stride) {
            const size_t k = r * slice->columns + c;
            if (speed_of(slice, k) > SHORTEST * fastest) {
                const double middle[2] = {figure->map.low[0] + edge * ((double)c + 0.5),
                                          figure->map.low[1] + edge * ((double)r + 0.5)};
                const double half[2] = {scale * slice->value[CLOD_FIELD_SLICE_RIGHT][k],
                                        scale * slice->value[CLOD_FIELD_SLICE_UP][k]};
                draw_arrow(middle, half, x + used, y + used);
                used += CORNERS;
            }
        }
    }
    snprintf(name, sizeof name, "velocity in the plane, longest arrow %.3g m/s",
             clod_field_figure_fastest(slice));
    clod_figure_add(figure, name, CLOD_FIGURE_ARROWS, 6, used, x, y, NULL);
}

/** Name and title. */
static void begin(clod_figure *figure, const clod_field_figure *self, size_t number)
{
    char name[sizeof figure->name], title[CLOD_FIGURE_TITLE], run[CLOD_FIGURE_NAME];
    if (self->run == NULL) {
        snprintf(name, sizeof name, "field-%.64s-%s", self->field, SHOWN[number].name);
        snprintf(title, sizeof title, "Field %.96s: %s", self->field, SHOWN[number].title);
    } else {
        clod_text_fit(run, sizeof run, sizeof run, self->run, strlen(self->run));
        snprintf(name, sizeof name, "field-%.40s-%s-%.40s", self->field, SHOWN[number].name,
                 run);
        snprintf(title, sizeof title, "%s: %s in %.40s", run, SHOWN[number].title, self->field);
    }
    clod_figure_init(figure, name, title);
}

void clod_field_figure_make(clod_figure *figure, const clod_field_figure *self, size_t number)
{
    const clod_field_slice *slice = self->slice;
    begin(figure, self, number);
    clod_figure_map map = map_of(slice, SHOWN[number].value);
    clod_figure_axis_set(&figure->x, (char[2]){"xyz"[slice->right], '\0'}, "mm", MM);
    clod_figure_axis_set(&figure->y, (char[2]){"xyz"[slice->up], '\0'}, "mm", MM);
    clod_figure_axis_set(&map.value, SHOWN[number].axis, SHOWN[number].unit, 1.0);
    clod_figure_map_set(figure, &map);
    if (SHOWN[number].value == CLOD_FIELD_SLICE_SPEED) {
        add_arrows(figure, slice, self->fastest);
    }
    write_note(self, figure->note, sizeof figure->note);
}

void clod_field_figure_finish(clod_figure *figures, size_t count, size_t number)
{
    clod_figure_map_share(figures, count);
    for (size_t f = 0; f < count; f++) {
        clod_figure_map *map = &figures[f].map;
        if (strcmp(SHOWN[number].unit, "Pa") == 0 && fmax(map->most, -map->least) >= KILO) {
            clod_figure_axis_set(&map->value, SHOWN[number].axis, "kPa", 1e-3);
        }
    }
}
