#include "report/field_slices.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "report/field_figure.h"
#include "report/html.h"

static void put_field(clod_sheet *sheet, const clod_field_figure *self)
{
    if (clod_field_slice_shows(self->slice)) {
        clod_sheet_columns(sheet, true);
        for (size_t k = 0; k < CLOD_FIELD_FIGURES; k++) {
            clod_figure figure;
            clod_field_figure_make(&figure, self, k);
            clod_field_figure_finish(&figure, 1, k);
            clod_sheet_figure(sheet, &figure);
        }
        clod_sheet_columns(sheet, false);
    } else {
        char plane[160];
        clod_field_figure_plane(self->slice, plane, sizeof plane);
        fputs("<p class=\"note\">Field ", sheet->body);
        clod_html_text(sheet->body, self->field);
        fprintf(sheet->body, ": no cell of its slice was reached by anything. %s.</p>\n",
                plane);
    }
}

/** Whether the solid is sheared or crushed in a phase. */
static bool is_main(const char *phase)
{
    return phase != NULL && (strcmp(phase, "preshear") == 0 || strcmp(phase, "shear") == 0 ||
                             strcmp(phase, "crush") == 0);
}

json_t *clod_field_slices_grids(const clod_run_files *run, const char **part)
{
    size_t k;
    json_t *one;
    *part = NULL;
    json_array_foreach(json_object_get(run->summary, "parts"), k, one)
    {
        json_t *grids = json_object_get(one, "fields");
        const json_t *first = json_object_iter_value(json_object_iter(grids));
        const char *name = json_string_value(json_object_get(one, "part"));
        if (name != NULL && is_main(json_string_value(json_object_get(first, "phase")))) {
            *part = name;
            return grids;
        }
    }
    return json_object_get(run->summary, "fields");
}

void clod_field_slices_path(const clod_run_files *run, const char *part, const char *field,
                            char *path, size_t size)
{
    snprintf(path, size, "%s/%s%sfield_%s.hdf", run->folder, part != NULL ? part : "",
             part != NULL ? "_" : "", field);
}

bool clod_field_slices_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    bool good = true;
    bool any = false;
    const char *name, *part;
    json_t *grid;
    double gravity[3];
    json_t *grids = clod_field_slices_grids(run, &part);
    clod_run_files_gravity(run, gravity);
    json_object_foreach(grids, name, grid)
    {
        char path[4096];
        clod_field_slices_path(run, part, name, path, sizeof path);
        // a mean over a region has no grid; without its corner it is of an older clod
        if (!good || json_object_get(grid, "corner_m") == NULL || access(path, F_OK) != 0) {
            continue;
        }
        if (!any) {
            char heading[128];
            snprintf(heading, sizeof heading, "Slices of the fields%s%s",
                     part != NULL ? ", " : "", part != NULL ? part : "");
            clod_html_section(sheet->body, "slices", heading);
            any = true;
        }
        clod_field_slice slice;
        good = clod_field_slice_read(&slice, grid, gravity, path, status);
        if (good) {
            const clod_field_figure self = {.field = name,
                                            .grid = grid,
                                            .slice = &slice,
                                            .fastest = clod_field_figure_fastest(&slice)};
            put_field(sheet, &self);
        }
        clod_field_slice_fini(&slice);
    }
    return good;
}
