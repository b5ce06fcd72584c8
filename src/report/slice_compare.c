#include "report/slice_compare.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "report/field_figure.h"
#include "report/field_slices.h"
#include "report/html.h"
#include "report/slice_runs.h"

static double number_of(const json_t *object, const char *key)
{
    return json_number_value(json_object_get(object, key));
}

/** "one at 2.5 s, two at 3 s". */
static void put_ends(FILE *out, const clod_slice_runs *self)
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

/** A text of a damaged summary may be missing. */
static const char *text_of(const char *text)
{
    return text != NULL ? text : "";
}

/** "preshear", or "seed-1-preshear of a, seed-2-preshear of b". */
static void put_parts(FILE *out, const clod_slice_runs *self)
{
    const char *before = "";
    bool same = true;
    for (size_t k = 0; k < self->count; k++) {
        same = same && (self->of[k].grid == NULL ||
                        strcmp(text_of(self->of[k].part), self->first->part) == 0);
    }
    for (size_t k = 0; k < (same ? 0 : self->count); k++) {
        if (self->of[k].grid != NULL) {
            fputs(before, out);
            clod_html_text(out, text_of(self->of[k].part));
            fputs(" of ", out);
            clod_html_text(out, self->of[k].run->name);
            before = ", ";
        }
    }
    if (same) {
        clod_html_text(out, self->first->part);
    }
}

static void put_moment(FILE *out, const clod_slice_runs *self, clod_slice_runs_moment chosen)
{
    if (chosen == CLOD_SLICE_RUNS_PART) {
        fputs("Means over the phase ", out);
        clod_html_text(out,
                       text_of(json_string_value(json_object_get(self->first->grid, "phase"))));
        fputs(", with which the part ends: ", out);
        put_parts(out, self);
        fputs(". ", out);
        return;
    }
    if (chosen == CLOD_SLICE_RUNS_SAME_END) {
        fprintf(out, "Means up to %.6g s, when all ended. ", self->first->end);
        return;
    }
    fputs(chosen == CLOD_SLICE_RUNS_SAME_FRAME
              ? "The runs ended at different times ("
              : "No common time: the runs ended at different times (",
          out);
    put_ends(out, self);
    if (chosen == CLOD_SLICE_RUNS_SAME_FRAME) {
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
static void put_note(FILE *out, const clod_slice_runs *self, clod_slice_runs_moment chosen)
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
static void put_value(clod_sheet *sheet, const clod_slice_runs *self, clod_figure *figures,
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
        const clod_slice_runs_one *of = &self->of[k];
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

static bool put_figures(clod_sheet *sheet, const clod_slice_runs *self, clod_status *status)
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
static bool put_field(clod_sheet *sheet, clod_slice_runs *self, bool *any, clod_status *status)
{
    clod_slice_runs_moment chosen = CLOD_SLICE_RUNS_SAME_END;
    bool good = true;
    if (self->first == NULL) { // means over regions alone
        return true;
    }
    if (!*any) {
        clod_html_section(sheet->body, "slices", "Slices of the fields");
        *any = true;
    }
    if (self->kept > 1) {
        good =
            clod_slice_runs_choose(self, &chosen, status) && clod_slice_runs_read(self, status);
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
        const char *part;
        earlier =
            earlier || json_object_get(clod_field_slices_grids(&runs[k], &part), field) != NULL;
    }
    return earlier;
}

bool clod_slice_compare_put(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                            clod_status *status)
{
    clod_slice_runs_one *all = clod_memory_alloc(count, sizeof *all);
    bool any = false;
    bool good =
        all != NULL || clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    for (size_t r = 0; good && r < count; r++) {
        const char *field, *part;
        json_t *grid;
        json_t *grids = clod_field_slices_grids(&runs[r], &part);
        json_object_foreach(grids, field, grid)
        {
            if (!good || is_earlier(runs, r, field)) {
                continue;
            }
            clod_slice_runs self = {.field = field, .of = all, .count = count};
            clod_slice_runs_gather(&self, runs);
            good = put_field(sheet, &self, &any, status);
            clod_slice_runs_fini(&self);
        }
    }
    clod_memory_free(all);
    return good;
}
