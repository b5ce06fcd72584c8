#include "report/field_slices.h"

#include <stdio.h>
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

bool clod_field_slices_put(clod_sheet *sheet, const clod_run_files *run, clod_status *status)
{
    bool good = true;
    bool any = false;
    const char *name;
    json_t *grid;
    double gravity[3];
    clod_run_files_gravity(run, gravity);
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
