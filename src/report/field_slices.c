#include "report/field_slices.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "config/yaml.h"
#include "report/field_slice.h"
#include "report/figure_map.h"
#include "report/html.h"

#define MM 1e3
#define KILO 1e4        ///< Pa from which on kPa are shown
#define MOST_ARROWS 300 ///< of a figure
#define CORNERS 6       ///< points of an arrow: tail, tip, barb, tip, barb, gap
#define SHORTEST 0.02   ///< of the longest arrow: shorter ones are left out

/** What is shown of a field. */
static const struct {
    clod_field_slice_value value;
    const char *name, *title, *axis, *unit;
} SHOWN[] = {
    {CLOD_FIELD_SLICE_DENSITY, "density", "bulk density", "bulk density", "kg/m3"},
    {CLOD_FIELD_SLICE_PRESSURE, "pressure", "pressure", "pressure, contact + kinetic", "Pa"},
    {CLOD_FIELD_SLICE_SPEED, "speed", "speed", "speed", "m/s"},
    {CLOD_FIELD_SLICE_COORDINATION, "coordination", "coordination", "contacts of a grain", ""},
};

/** A field of the run. */
typedef struct subject {
    const char *name;
    const json_t *grid; ///< its object in the summary
    const clod_field_slice *slice;
} subject;

/** Gravity of the complete case [m/s2]; 0 where it says none. */
static void read_gravity(const clod_run_files *run, double gravity[3])
{
    clod_arena arena = {0};
    clod_report errors = {.name = "case-complete.yaml"};
    const clod_node *found = clod_tree_find(
        clod_yaml_read(&arena, run->complete, strlen(run->complete), 0, &errors), "gravity");
    for (size_t a = 0; a < 3; a++) {
        const bool there = found != NULL && found->kind == CLOD_NODE_LIST &&
                           found->count == 3 && found->items[a]->kind == CLOD_NODE_SCALAR;
        gravity[a] = there ? strtod(found->items[a]->text, NULL) : 0.0;
    }
    clod_report_fini(&errors);
    clod_arena_fini(&arena);
}

/** Where the plane is: "Plane y = 18 mm, the middle layer of cells (5 of 10) ...". */
static void say_plane(const subject *self, char *text, size_t size)
{
    const clod_field_slice *slice = self->slice;
    const char across = "xyz"[slice->across];
    snprintf(text, size, "Plane %c = %.6g mm: layer %ld of %ld of the grid's cells across %c%s",
             across, clod_field_slice_place(slice) * MM, slice->layer + 1,
             slice->cells[slice->across], across, slice->gravity ? "; gravity lies in it" : "");
}

/** The sentence below a figure. */
static void write_note(const subject *self, char *note, size_t size)
{
    char plane[160], thinned[96] = "";
    const clod_field_slice *slice = self->slice;
    say_plane(self, plane, sizeof plane);
    if (slice->stride > 1) {
        snprintf(thinned, sizeof thinned,
                 " One cell of each %ld x %ld is shown, as large as they.", slice->stride,
                 slice->stride);
    }
    snprintf(
        note, size,
        "%s. Mean of %ld samples from %.6g s on; cells of %.6g mm, kernel of %.6g mm. Blank: "
        "nothing reached the cell.%s",
        plane, (long)json_integer_value(json_object_get(self->grid, "samples")),
        json_number_value(json_object_get(self->grid, "since_s")), slice->cell * MM,
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

/** Velocities of some of the cells; the longest arrow reaches nearly from one of them to the next. */
static void add_arrows(clod_figure *figure, const clod_field_slice *slice)
{
    const size_t stride = arrow_stride(slice);
    const double edge = slice->cell * (double)slice->stride;
    const double *right = slice->value[CLOD_FIELD_SLICE_RIGHT];
    const double *up = slice->value[CLOD_FIELD_SLICE_UP];
    double x[CORNERS * MOST_ARROWS], y[CORNERS * MOST_ARROWS], most = 0.0;
    char name[96];
    size_t used = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t r = stride / 2; r < slice->rows; r += stride) {
            for (size_t c = stride / 2; c < slice->columns; c += stride) {
                const size_t k = r * slice->columns + c;
                const double speed = hypot(right[k], up[k]);
                const double scale = 0.45 * edge * (double)stride / most;
                if (pass == 0) {
                    most = fmax(most, speed); // of no number: as it is
                } else if (speed > SHORTEST * most) {
                    const double middle[2] = {figure->map.low[0] + edge * ((double)c + 0.5),
                                              figure->map.low[1] + edge * ((double)r + 0.5)};
                    draw_arrow(middle, (double[2]){scale * right[k], scale * up[k]}, x + used,
                               y + used);
                    used += CORNERS;
                }
            }
        }
    }
    snprintf(name, sizeof name, "velocity in the plane, longest arrow %.3g m/s", most);
    clod_figure_add(figure, name, CLOD_FIGURE_ARROWS, 6, used, x, y, NULL);
}

static void put_one(clod_sheet *sheet, const subject *self, size_t shown)
{
    const clod_field_slice *slice = self->slice;
    char name[128], title[160];
    clod_figure figure;
    snprintf(name, sizeof name, "field-%.64s-%s", self->name, SHOWN[shown].name);
    snprintf(title, sizeof title, "Field %.96s: %s", self->name, SHOWN[shown].title);
    clod_figure_init(&figure, name, title);
    clod_figure_map map = map_of(slice, SHOWN[shown].value);
    clod_figure_axis_set(&figure.x, (char[2]){"xyz"[slice->right], '\0'}, "mm", MM);
    clod_figure_axis_set(&figure.y, (char[2]){"xyz"[slice->up], '\0'}, "mm", MM);
    clod_figure_axis_set(&map.value, SHOWN[shown].axis, SHOWN[shown].unit, 1.0);
    clod_figure_map_set(&figure, &map);
    if (strcmp(SHOWN[shown].unit, "Pa") == 0 &&
        fmax(figure.map.most, -figure.map.least) >= KILO) {
        clod_figure_axis_set(&figure.map.value, SHOWN[shown].axis, "kPa", 1e-3);
    }
    if (SHOWN[shown].value == CLOD_FIELD_SLICE_SPEED) {
        add_arrows(&figure, slice);
    }
    write_note(self, figure.note, sizeof figure.note);
    clod_sheet_figure(sheet, &figure);
}

static void put_field(clod_sheet *sheet, const subject *self)
{
    if (clod_field_slice_shows(self->slice)) {
        clod_sheet_columns(sheet, true);
        for (size_t k = 0; k < sizeof SHOWN / sizeof *SHOWN; k++) {
            put_one(sheet, self, k);
        }
        clod_sheet_columns(sheet, false);
    } else {
        char plane[160];
        say_plane(self, plane, sizeof plane);
        fputs("<p class=\"note\">Field ", sheet->body);
        clod_html_text(sheet->body, self->name);
        fprintf(sheet->body, ": no cell of its slice was reached by anything. %s.</p>\n",
                plane);
    }
}

bool clod_field_slices_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    bool good = true;
    bool any = false;
    const char *name;
    json_t *grid;
    double gravity[3];
    read_gravity(run, gravity);
    json_object_foreach(json_object_get(run->summary, "fields"), name, grid)
    {
        char path[4096];
        snprintf(path, sizeof path, "%s/field_%s.hdf", run->folder, name);
        // a mean over a region has no grid; without its corner it is of an older clod
        if (!good || json_object_get(grid, "corner_m") == NULL || access(path, F_OK) != 0) {
            continue;
        }
        if (!any) {
            clod_html_section(sheet->body, "slices", "Slices of the fields");
            any = true;
        }
        clod_field_slice slice;
        const subject self = {name, grid, &slice};
        good = clod_field_slice_read(&slice, grid, gravity, path, status);
        if (good) {
            put_field(sheet, &self);
        }
        clod_field_slice_fini(&slice);
    }
    return good;
}
