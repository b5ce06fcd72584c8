#include "report/slice_runs.h"

#include <math.h>
#include <stdio.h>
#include <unistd.h>

#include "output/hdf_series.h"
#include "report/field_slices.h"

#define PATH 4096
#define MM 1e3

static double number_of(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

static double number_at(const json_t *object, const char *key, size_t k)
{
    return json_number_value(json_array_get(json_object_get(object, key), k));
}

static void leave_out(clod_slice_runs *self, clod_slice_runs_one *of, const char *why)
{
    snprintf(of->why, sizeof of->why, "%s", why);
    of->grid = NULL;
    self->kept--;
}

/** The plane that is shown of a grid. */
static void choose_plane(const clod_slice_runs_one *of, clod_field_slice *plane)
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
static void check_grid(clod_slice_runs *self, clod_slice_runs_one *of)
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
    } else if (self->kept > CLOD_SLICE_RUNS_MOST) {
        leave_out(self, of, "the first runs alone are shown");
    }
}

void clod_slice_runs_gather(clod_slice_runs *self, const clod_run_files *runs)
{
    self->kept = self->count;
    for (size_t k = 0; k < self->count; k++) {
        clod_slice_runs_one *of = &self->of[k];
        char path[PATH];
        *of = (clod_slice_runs_one){.run = &runs[k],
                                    .end = number_of(runs[k].summary, "time_s"),
                                    .step = number_of(runs[k].summary, "dt_s")};
        of->grid = json_object_get(clod_field_slices_grids(of->run, &of->part), self->field);
        clod_field_slices_path(of->run, of->part, self->field, path, sizeof path);
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
static bool load_frames(clod_slice_runs_one *of, const char *field, clod_status *status)
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
static const json_t *frame_at(const clod_slice_runs_one *of, double time, double step)
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
static bool take_frames(clod_slice_runs *self, double time)
{
    bool all = true;
    for (size_t k = 0; k < self->count; k++) {
        clod_slice_runs_one *of = &self->of[k];
        if (of->grid != NULL) {
            of->frame = frame_at(of, time, self->first->step);
            all = all && of->frame != NULL;
        }
    }
    return all;
}

static bool is_same_end(const clod_slice_runs *self)
{
    bool same = true;
    for (size_t k = 0; k < self->count; k++) {
        const clod_slice_runs_one *of = &self->of[k];
        same = same && (of->grid == NULL ||
                        fabs(of->end - self->first->end) <= fmax(of->step, self->first->step));
    }
    return same;
}

bool clod_slice_runs_choose(clod_slice_runs *self, clod_slice_runs_moment *chosen,
                            clod_status *status)
{
    if (self->first->part != NULL) {
        *chosen = CLOD_SLICE_RUNS_PART;
        return true;
    }
    *chosen = is_same_end(self) ? CLOD_SLICE_RUNS_SAME_END : CLOD_SLICE_RUNS_OWN_END;
    for (size_t k = 0; *chosen != CLOD_SLICE_RUNS_SAME_END && k < self->count; k++) {
        if (self->of[k].grid != NULL && !load_frames(&self->of[k], self->field, status)) {
            return false;
        }
    }
    for (size_t k = json_array_size(self->first->frames);
         k > 0 && *chosen == CLOD_SLICE_RUNS_OWN_END; k--) {
        if (take_frames(self, number_of(json_array_get(self->first->frames, k - 1), "time"))) {
            *chosen = CLOD_SLICE_RUNS_SAME_FRAME;
        }
    }
    for (size_t k = 0; *chosen == CLOD_SLICE_RUNS_OWN_END && k < self->count; k++) {
        self->of[k].frame = NULL;
    }
    return true;
}

bool clod_slice_runs_read(clod_slice_runs *self, clod_status *status)
{
    bool good = true;
    for (size_t k = 0; good && k < self->count; k++) {
        clod_slice_runs_one *of = &self->of[k];
        char path[PATH];
        double gravity[3];
        if (of->grid == NULL) {
            continue;
        }
        const char *frame = json_string_value(json_object_get(of->frame, "name"));
        if (frame != NULL) {
            snprintf(path, sizeof path, "%s/%s", of->run->folder, frame);
        } else {
            clod_field_slices_path(of->run, of->part, self->field, path, sizeof path);
        }
        clod_run_files_gravity(of->run, gravity);
        good = clod_field_slice_read(&of->slice, of->grid, gravity, path, status);
        if (good && !clod_field_slice_shows(&of->slice)) {
            leave_out(self, of, "no cell of its slice was reached by anything");
        }
    }
    return good;
}

void clod_slice_runs_fini(clod_slice_runs *self)
{
    for (size_t k = 0; k < self->count; k++) {
        clod_field_slice_fini(&self->of[k].slice);
        json_decref(self->of[k].frames);
    }
}
