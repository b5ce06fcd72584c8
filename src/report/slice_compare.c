#include "report/slice_compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "output/hdf_series.h"
#include "report/field_figure.h"
#include "report/html.h"

#define PATH 4096
#define MM 1e3

/** A run's grid of the field that is compared. */
typedef struct grid_run {
    const clod_run_files *run;
    const json_t *grid;  ///< its object in summary.json; NULL: left out
    char why[256];       ///< it is left out
    double end, step;    ///< s: of the run
    json_t *frames;      ///< owned: list of its moments; NULL: none
    const json_t *frame; ///< that is shown; NULL: the mean at the end
    clod_field_slice slice;
} grid_run;

/** A field and the runs. */
typedef struct comparison {
    const char *field;
    grid_run *of; ///< [count]
    size_t count, kept;
    const grid_run *first; ///< that has the field
} comparison;

/** What is shown of the runs. */
typedef enum moment { SAME_END, SAME_FRAME, OWN_END } moment;

static double number_of(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

static double number_at(const json_t *object, const char *key, size_t k)
{
    return json_number_value(json_array_get(json_object_get(object, key), k));
}

static void leave_out(comparison *self, grid_run *of, const char *why)
{
    snprintf(of->why, sizeof of->why, "%s", why);
    of->grid = NULL;
    self->kept--;
}

/** The plane that is shown of a grid. */
static void choose_plane(const grid_run *of, clod_field_slice *plane)
{
    long cells[3];
    double gravity[3];
    clod_run_files_gravity(of->run, gravity);
    for (size_t a = 0; a < 3; a++) {
        cells[a] = (long)fmax(1.0, number_at(of->grid, "cells", a));
    }
    clod_field_slice_choose(plane, cells, gravity);
}

/** "10 x 9 x 16 cells of 4 mm from (-4, 0, -12) mm". */
static void say_grid(const json_t *grid, char text[128])
{
    snprintf(text, 128, "%.0f x %.0f x %.0f cells of %.6g mm from (%.6g, %.6g, %.6g) mm",
             number_at(grid, "cells", 0), number_at(grid, "cells", 1),
             number_at(grid, "cells", 2), number_of(grid, "cell_m") * MM,
             number_at(grid, "corner_m", 0) * MM, number_at(grid, "corner_m", 1) * MM,
             number_at(grid, "corner_m", 2) * MM);
}

static bool is_same_grid(const json_t *one, const json_t *other)
{
    const double cell = number_of(one, "cell_m");
    bool same = fabs(number_of(other, "cell_m") - cell) <= 1e-9 * cell;
    for (size_t a = 0; a < 3; a++) {
        same = same && number_at(one, "cells", a) == number_at(other, "cells", a) &&
               fabs(number_at(one, "corner_m", a) - number_at(other, "corner_m", a)) <=
                   1e-6 * cell;
    }
    return same;
}

/** Leave out a run whose slice is not of the same cells as that of the first. */
static void check_grid(comparison *self, grid_run *of)
{
    clod_field_slice plane, first;
    choose_plane(of, &plane);
    choose_plane(self->first, &first);
    if (!is_same_grid(self->first->grid, of->grid)) {
        char grid[128], why[256];
        say_grid(of->grid, grid);
        snprintf(why, sizeof why, "its grid is another, %s", grid);
        leave_out(self, of, why);
    } else if (plane.across != first.across || plane.up != first.up) {
        leave_out(self, of, "its gravity leads to another plane");
    } else if (self->kept > CLOD_SLICE_COMPARE_MOST) {
        leave_out(self, of, "the first runs alone are shown");
    }
}

static const json_t *grid_of(const clod_run_files *run, const char *field)
{
    return json_object_get(json_object_get(run->summary, "fields"), field);
}

/** Find the field in all runs. @param self  with room in `of` */
static void gather(comparison *self, const clod_run_files *runs)
{
    self->kept = self->count;
    for (size_t k = 0; k < self->count; k++) {
        grid_run *of = &self->of[k];
        char path[PATH];
        *of = (grid_run){.run = &runs[k],
                         .grid = grid_of(&runs[k], self->field),
                         .end = number_of(runs[k].summary, "time_s"),
                         .step = number_of(runs[k].summary, "dt_s")};
        snprintf(path, sizeof path, "%s/field_%s.hdf", runs[k].folder, self->field);
        if (of->grid == NULL) {
            leave_out(self, of, "it has no field of this name");
        } else if (json_object_get(of->grid, "corner_m") == NULL) {
            leave_out(self, of, "it has no grid of this name");
        } else if (access(path, F_OK) != 0) {
            leave_out(self, of, "its file of the grid is not there");
        } else if (self->first == NULL) {
            self->first = of;
        }
    }
    for (size_t k = self->count; k > 0; k--) { // from the end, so that the first ones stay
        if (self->of[k - 1].grid != NULL && &self->of[k - 1] != self->first) {
            check_grid(self, &self->of[k - 1]);
        }
    }
}

/** Load the list of moments of a run's grid, if it has one. */
static bool load_frames(grid_run *of, const char *field, clod_status *status)
{
    char path[PATH];
    json_error_t error;
    snprintf(path, sizeof path, "%s/field_%s.hdf.series", of->run->folder, field);
    if (access(path, F_OK) != 0) {
        return true;
    }
    json_t *root = json_load_file(path, 0, &error);
    of->frames = json_incref(json_object_get(root, "files"));
    json_decref(root);
    return clod_hdf_series_is_list(of->frames) ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s is damaged: it is not the list of frames that clod writes.",
                            path);
}

/** The frame of a run at a time, to a time step; NULL: none. */
static const json_t *frame_at(const grid_run *of, double time, double step)
{
    size_t k;
    const json_t *frame;
    json_array_foreach(of->frames, k, frame)
    {
        if (fabs(number_of(frame, "time") - time) <= fmax(of->step, step)) {
            return frame;
        }
    }
    return NULL;
}

/** Give each run its frame of a time; false: not all have one. */
static bool take_frames(comparison *self, double time)
{
    bool all = true;
    for (size_t k = 0; k < self->count; k++) {
        grid_run *of = &self->of[k];
        if (of->grid != NULL) {
            of->frame = frame_at(of, time, self->first->step);
            all = all && of->frame != NULL;
        }
    }
    return all;
}

static bool is_same_end(const comparison *self)
{
    bool same = true;
    for (size_t k = 0; k < self->count; k++) {
        const grid_run *of = &self->of[k];
        same = same && (of->grid == NULL ||
                        fabs(of->end - self->first->end) <= fmax(of->step, self->first->step));
    }
    return same;
}

/** Choose what is shown of the runs. */
static bool choose_moment(comparison *self, moment *chosen, clod_status *status)
{
    *chosen = is_same_end(self) ? SAME_END : OWN_END;
    for (size_t k = 0; *chosen != SAME_END && k < self->count; k++) {
        if (self->of[k].grid != NULL && !load_frames(&self->of[k], self->field, status)) {
            return false;
        }
    }
    for (size_t k = json_array_size(self->first->frames); k > 0 && *chosen == OWN_END; k--) {
        if (take_frames(self, number_of(json_array_get(self->first->frames, k - 1), "time"))) {
            *chosen = SAME_FRAME;
        }
    }
    for (size_t k = 0; *chosen == OWN_END && k < self->count; k++) {
        self->of[k].frame = NULL;
    }
    return true;
}

static bool read_slices(comparison *self, clod_status *status)
{
    bool good = true;
    for (size_t k = 0; good && k < self->count; k++) {
        grid_run *of = &self->of[k];
        char path[PATH], name[320];
        double gravity[3];
        if (of->grid == NULL) {
            continue;
        }
        snprintf(name, sizeof name, "field_%.280s.hdf", self->field);
        const char *frame = json_string_value(json_object_get(of->frame, "name"));
        snprintf(path, sizeof path, "%s/%s", of->run->folder, frame != NULL ? frame : name);
        clod_run_files_gravity(of->run, gravity);
        good = clod_field_slice_read(&of->slice, of->grid, gravity, path, status);
        if (good && !clod_field_slice_shows(&of->slice)) {
            leave_out(self, of, "no cell of its slice was reached by anything");
        }
    }
    return good;
}

/** "one at 2.5 s, two at 3 s". */
static void put_ends(FILE *out, const comparison *self)
{
    const char *before = "";
    for (size_t k = 0; k < self->count; k++) {
        if (self->of[k].grid != NULL) {
            fputs(before, out);
            clod_html_text(out, self->of[k].run->name);
            fprintf(out, " at %.6g s", self->of[k].end);
            before = ", ";
        }
    }
}

static void put_moment(FILE *out, const comparison *self, moment chosen)
{
    if (chosen == SAME_END) {
        fprintf(out, "Means up to %.6g s, when all ended. ", self->first->end);
        return;
    }
    fputs(chosen == SAME_FRAME ? "The runs ended at different times ("
                               : "No common time: the runs ended at different times (",
          out);
    put_ends(out, self);
    if (chosen == SAME_FRAME) {
        fprintf(out, "); this is %.6g s, the last moment of which all have a frame. ",
                number_of(self->first->frame, "time"));
    } else {
        fputs(
            "), and each is shown as its mean at its own end. With frames: true and the same snapshots all "
            "would have frames of a common time. ",
            out);
    }
}

/** What is shown, and what is left out. */
static void put_note(FILE *out, const comparison *self, moment chosen)
{
    fputs("<p class=\"note\"><strong>Field ", out);
    clod_html_text(out, self->field);
    fputs(".</strong> ", out);
    if (self->kept > 1) {
        put_moment(out, self, chosen);
        fputs("All runs have one scale of colours for each value, and one of arrows. ", out);
    } else {
        fputs("There are no two runs to compare. ", out);
    }
    for (size_t k = 0; k < self->count; k++) {
        if (self->of[k].grid == NULL) {
            fputs("Left out: ", out);
            clod_html_text(out, self->of[k].run->name);
            fprintf(out, " (%s). ", self->of[k].why);
        }
    }
    fputs("</p>\n", out);
}

/** The figures of one value, one for each run. @param figures  [kept] */
static void put_value(clod_sheet *sheet, const comparison *self, clod_figure *figures,
                      size_t number)
{
    double fastest = 0.0;
    size_t made = 0;
    for (size_t k = 0; k < self->count; k++) {
        if (self->of[k].grid != NULL) {
            fastest = fmax(fastest, clod_field_figure_fastest(&self->of[k].slice));
        }
    }
    for (size_t k = 0; k < self->count; k++) {
        const grid_run *of = &self->of[k];
        if (of->grid != NULL) {
            const double time = number_of(of->frame, "time");
            const clod_field_figure one = {.field = self->field,
                                           .run = of->run->name,
                                           .grid = of->grid,
                                           .slice = &of->slice,
                                           .moment = of->frame != NULL ? &time : NULL,
                                           .fastest = fastest};
            clod_field_figure_make(&figures[made++], &one, number);
        }
    }
    clod_field_figure_finish(figures, made, number);
    clod_sheet_columns(sheet, true);
    for (size_t f = 0; f < made; f++) {
        clod_sheet_figure(sheet, &figures[f]);
    }
    clod_sheet_columns(sheet, false);
}

static bool put_figures(clod_sheet *sheet, const comparison *self, clod_status *status)
{
    clod_figure *figures = clod_memory_alloc(self->kept, sizeof *figures);
    for (size_t number = 0; figures != NULL && number < CLOD_FIELD_FIGURES; number++) {
        put_value(sheet, self, figures, number);
    }
    const bool good = figures != NULL;
    clod_memory_free(figures);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
}

/** Compare a field. @param any  [in,out] whether the section has begun */
static bool put_field(clod_sheet *sheet, comparison *self, bool *any, clod_status *status)
{
    moment chosen = SAME_END;
    bool good = true;
    if (self->first == NULL) { // means over regions alone
        return true;
    }
    if (!*any) {
        clod_html_section(sheet->body, "slices", "Slices of the fields");
        *any = true;
    }
    if (self->kept > 1) {
        good = choose_moment(self, &chosen, status) && read_slices(self, status);
    }
    if (good) {
        put_note(sheet->body, self, chosen);
    }
    return good && (self->kept < 2 || put_figures(sheet, self, status));
}

/** Whether an earlier run has the field, too. */
static bool is_earlier(const clod_run_files *runs, size_t run, const char *field)
{
    bool earlier = false;
    for (size_t k = 0; k < run; k++) {
        earlier = earlier || grid_of(&runs[k], field) != NULL;
    }
    return earlier;
}

bool clod_slice_compare_put(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                            clod_status *status)
{
    grid_run *all = clod_memory_alloc(count, sizeof *all);
    bool any = false;
    bool good =
        all != NULL || clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    for (size_t r = 0; good && r < count; r++) {
        const char *field;
        json_t *grid;
        json_object_foreach(json_object_get(runs[r].summary, "fields"), field, grid)
        {
            if (!good || is_earlier(runs, r, field)) {
                continue;
            }
            comparison self = {.field = field, .of = all, .count = count};
            gather(&self, runs);
            good = put_field(sheet, &self, &any, status);
            for (size_t k = 0; k < count; k++) {
                clod_field_slice_fini(&all[k].slice);
                json_decref(all[k].frames);
            }
        }
    }
    clod_memory_free(all);
    return good;
}
