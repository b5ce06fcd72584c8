#include "report/grain_view.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "base/memory.h"
#include "base/text.h"
#include "picture/field.h"
#include "picture/film.h"
#include "picture/vtkhdf.h"
#include "report/figure_json.h"
#include "report/html.h"
#include "report/packed.h"
#include "report/run_damage.h"
#include "report/scripts.h"

/** Whether a part has snapshots. */
static bool has_film(const clod_run_files *run, const char *part)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.hdf.series", run->folder, part);
    return access(path, R_OK) == 0;
}

/** The part whose last snapshot is shown; NULL: none. */
static const char *choose_part(const clod_run_files *run)
{
    static const char *const FIRST[] = {"run", "preshear", "fill"}; // while there is no summary
    const char *chosen = NULL;
    const char *part;
    for (size_t k = 0; (part = clod_run_files_part(run, k)) != NULL; k++) {
        chosen = has_film(run, part) ? part : chosen;
    }
    for (size_t k = 0; chosen == NULL && k < sizeof FIRST / sizeof *FIRST; k++) {
        chosen = has_film(run, FIRST[k]) ? FIRST[k] : NULL;
    }
    return chosen;
}

/** Three coordinates of points, each packed. */
static bool put_points(FILE *out, const double (*point)[3], size_t count, size_t stride)
{
    bool good = true;
    fputs("[", out);
    for (int axis = 0; axis < 3; axis++) {
        fputs(axis > 0 ? "," : "", out);
        good = clod_packed_numbers(out, &point[0][axis], count, 3 * stride) && good;
    }
    fputs("]", out);
    return good;
}

/** The named field of every stride-th grain. */
static bool put_field(FILE *out, const clod_vtkhdf *file, const char *name, size_t count,
                      size_t stride, clod_status *status)
{
    clod_field field;
    bool good = clod_field_read(&field, file, CLOD_VTKHDF_POINTS, name, status);
    if (good) {
        fputs("{\"name\":", out);
        clod_figure_json_text(out, strcmp(name, "velocity") == 0 ? "speed" : field.title);
        fputs(",\"units\":", out);
        clod_figure_json_text(out, field.units);
        fputs(",\"values\":", out);
        good = clod_packed_numbers(out, field.value, count, stride) ||
               clod_status_fail(status, CLOD_FAILED, "No memory for the 3-D view.");
        fputs("}", out);
    }
    clod_field_fini(&field);
    return good;
}

/** All fields but the numbers of grains; speed first. */
static bool put_fields(FILE *out, const clod_vtkhdf *file, size_t count, size_t stride,
                       clod_status *status)
{
    bool good = true;
    bool any = false;
    fputs("[", out);
    if (clod_vtkhdf_find(file, CLOD_VTKHDF_POINTS, "velocity") != NULL) {
        good = put_field(out, file, "velocity", count, stride, status);
        any = true;
    }
    for (size_t k = 0; good && k < file->column_count[CLOD_VTKHDF_POINTS]; k++) {
        const char *name = file->columns[CLOD_VTKHDF_POINTS][k].name;
        if (strcmp(name, "id") != 0 && strcmp(name, "velocity") != 0) {
            fputs(any ? ",\n" : "", out);
            good = put_field(out, file, name, count, stride, status);
            any = true;
        }
    }
    fputs("]", out);
    return good;
}

static bool put_grains(FILE *out, const char *path, size_t *total, size_t *shown,
                       clod_status *status)
{
    clod_vtkhdf *file = clod_vtkhdf_open(path, status);
    if (file == NULL) {
        return false;
    }
    const size_t rows = file->rows[CLOD_VTKHDF_POINTS];
    const size_t stride = (rows + CLOD_GRAIN_VIEW_MOST - 1) / CLOD_GRAIN_VIEW_MOST;
    const size_t count = rows == 0 ? 0 : (rows - 1) / stride + 1;
    *total = rows;
    *shown = count;
    double(*point)[3] = clod_vtkhdf_points(file, status);
    bool good = point != NULL;
    fprintf(out, "{\"count\":%zu,\"position\":", count);
    if (good) {
        good = put_points(out, (const double(*)[3])point, count, stride) ||
               clod_status_fail(status, CLOD_FAILED, "No memory for the 3-D view.");
    }
    fputs(",\"radius\":", out);
    good = good && put_field(out, file, "radius", count, stride, status);
    fputs(",\"fields\":", out);
    good = good && put_fields(out, file, count, stride, status);
    fputs("}", out);
    clod_memory_free(point);
    clod_vtkhdf_close(&file);
    return good;
}

/** The corners of all triangles, one after the other. */
static double (*read_corners(const clod_vtkhdf *file, size_t count, clod_status *status))[3]
{
    double(*point)[3] = clod_vtkhdf_points(file, status);
    size_t(*triangle)[3] = point != NULL ? clod_vtkhdf_triangles(file, status) : NULL;
    double(*corner)[3] =
        triangle != NULL ? clod_memory_alloc(3 * count + 1, sizeof *corner) : NULL;
    if (triangle != NULL && corner == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the 3-D view.");
    }
    for (size_t k = 0; corner != NULL && k < 3 * count; k++) {
        memcpy(corner[k], point[triangle[k / 3][k % 3]], sizeof corner[k]);
    }
    clod_memory_free(triangle);
    clod_memory_free(point);
    return corner;
}

/** The first triangles of the walls, and how many there are. */
static bool put_walls(FILE *out, const char *path, size_t *total, size_t *shown,
                      clod_status *status)
{
    clod_vtkhdf *file = clod_vtkhdf_open(path, status);
    if (file == NULL) {
        return false;
    }
    *total = file->rows[CLOD_VTKHDF_CELLS];
    const size_t count = *total < CLOD_GRAIN_VIEW_MOST ? *total : CLOD_GRAIN_VIEW_MOST;
    *shown = count;
    double(*corner)[3] = read_corners(file, count, status);
    bool good = corner != NULL;
    fprintf(out, "{\"triangles\":%zu,\"corner\":", count);
    if (good) {
        good = put_points(out, (const double(*)[3])corner, 3 * count, 1) ||
               clod_status_fail(status, CLOD_FAILED, "No memory for the 3-D view.");
    }
    fputs("}", out);
    clod_memory_free(corner);
    clod_vtkhdf_close(&file);
    return good;
}

/** What the view shows, in words. */
static void put_note(FILE *out, const char *part, double time, const size_t grains[2],
                     const size_t triangles[2])
{
    fputs("<p class=\"note\">", out);
    if (strcmp(part, "run") != 0) {
        fputs("Part ", out);
        clod_html_text(out, part);
        fputs(", ", out);
    }
    fprintf(out, "%.6g s, %zu grains", time, grains[0]);
    if (grains[1] < grains[0]) {
        fprintf(out, ", of which %zu, evenly chosen, are shown", grains[1]);
    }
    if (triangles[1] < triangles[0]) {
        fprintf(out, "; of %zu triangles of walls the first %zu are shown", triangles[0],
                triangles[1]);
    }
    fputs(". Drag to turn, wheel or two fingers to zoom.</p>\n", out);
}

/** The last frame, and what it shows. */
static bool put_frame(FILE *out, FILE *note, const clod_film *film, const char *part,
                      clod_status *status)
{
    const clod_film_frame *last = &film->frames[film->count - 1];
    size_t grains[2] = {0, 0}; // there are, and are shown
    size_t triangles[2] = {0, 0};
    fputs("{\"time\":", out);
    clod_figure_json_number(out, last->time);
    fputs(",\"grains\":", out);
    bool good = put_grains(out, last->grains, &grains[0], &grains[1], status);
    if (good && last->walls != NULL) {
        fputs(",\"walls\":", out);
        good = put_walls(out, last->walls, &triangles[0], &triangles[1], status);
    }
    fputs("}", out);
    put_note(note, part, last->time, grains, triangles);
    return good;
}

/** The last snapshot of a part as texts. */
static bool make(clod_grain_view *self, const clod_run_files *run, const char *part,
                 clod_status *status)
{
    clod_film film;
    clod_text data, note;
    FILE *const out = clod_text_open(&data);
    FILE *const words = clod_text_open(&note);
    const bool room = out != NULL && words != NULL;
    bool good = clod_film_open(&film, run->folder, part, status) && room &&
                put_frame(out, words, &film, part, status);
    clod_film_fini(&film);
    self->data = out != NULL ? clod_text_close(&data) : NULL;
    self->note = words != NULL ? clod_text_close(&note) : NULL;
    if (self->data == NULL || self->note == NULL) {
        good = clod_status_fail(status, CLOD_FAILED, "No memory for the 3-D view.");
    }
    if (!good) {
        clod_grain_view_fini(self);
    }
    return good;
}

bool clod_grain_view_make(clod_grain_view *self, clod_run_files *run, clod_status *status)
{
    const char *part = choose_part(run);
    clod_status why = {0};
    *self = (clod_grain_view){0};
    if (part == NULL || clod_scripts_bundle() == NULL || make(self, run, part, &why)) {
        return true;
    }
    return why.code == CLOD_USAGE
               ? clod_run_damage_add(run, status,
                                     "There is no 3-D view of the last snapshot: %s", why.text)
               : clod_status_fail(status, why.code, "%s", why.text);
}

void clod_grain_view_put(clod_sheet *sheet, const clod_grain_view *self)
{
    if (self->data != NULL) {
        clod_html_section(sheet->body, "view", "The last snapshot");
        fputs(self->data, clod_sheet_view(sheet));
        fputs(self->note, sheet->body);
    }
}

void clod_grain_view_fini(clod_grain_view *self)
{
    clod_memory_free(self->data);
    clod_memory_free(self->note);
    *self = (clod_grain_view){0};
}
