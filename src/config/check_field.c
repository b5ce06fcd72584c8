// Rules for fields.

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "config/check.h"
#include "config/grid.h"
#include "config/region.h"

__attribute__((format(printf, 4, 5))) static void fail(clod_loader *loader,
                                                       const clod_case_field *field,
                                                       const char *key, const char *format, ...)
{
    char path[CLOD_LOAD_PATH], text[256];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    snprintf(path, sizeof path, "fields.%s%s%s", field->name, key[0] == '\0' ? "" : ".", key);
    clod_check_fail(loader, path, "%s", text);
}

/** End of a region's last cell along an axis [m]. */
static double end_of(const clod_case_field *field, int axis, double cell)
{
    const double low = field->region.min[axis], length = field->region.max[axis] - low;
    return low + cell * fmax(1.0, ceil(length / cell * (1.0 - 1e-12))); // as grid.c counts
}

/** First axis along which cells reach past a periodic side; 3: none. */
static int past_side(const clod_case *self, const clod_case_field *field, double cell)
{
    for (int a = 0; a < 3; a++) {
        const double period = self->domain_max[a] - self->domain_min[a];
        if (self->periodic[a] && end_of(field, a, cell) > self->domain_max[a] + 1e-9 * period) {
            return a;
        }
    }
    return 3;
}

/** The nearest cell of which a whole number is as long as the region along an axis, and that fits
 *  along the others too [m]; 0: none. */
static double nearest_fit(const clod_case *self, const clod_case_field *field, int axis)
{
    const double length = field->region.max[axis] - field->region.min[axis];
    const double most = fmin(CLOD_CASE_FIELD_CELLS, 4.0 * ceil(length / field->cell));
    double best = 0.0;
    for (double n = 1.0; n <= most; n += 1.0) {
        const double cell = length / n;
        if (fabs(cell - field->cell) < fabs(best - field->cell) &&
            past_side(self, field, cell) == 3) {
            best = cell;
        }
    }
    return best;
}

/** Cells must not reach past a periodic side, where they would see again what is at the other. */
static void check_fit(clod_loader *loader, const clod_case *self, const clod_case_field *field)
{
    const int a = self->has_domain ? past_side(self, field, field->cell) : 3;
    if (a == 3) {
        return;
    }
    const double end = end_of(field, a, field->cell), side = self->domain_max[a];
    const double fit = nearest_fit(self, field, a);
    char hint[48] = "";
    if (fit > 0.0) {
        snprintf(hint, sizeof hint, "make it %.13g m, or ", fit);
    }
    fail(
        loader, field, "cell",
        "the last cells end at %.6g m along %c, past the periodic side at %.6g m: grains would "
        "count twice in the sum over cells; %send the region where a cell ends",
        end, "xyz"[a], side, hint);
}

/** In periodic directions grains and contacts must count once. */
static void check_period(clod_loader *loader, const clod_case *self,
                         const clod_case_field *field)
{
    for (int a = 0; self->has_domain && a < 3; a++) {
        const double period = self->domain_max[a] - self->domain_min[a];
        if (self->periodic[a] && field->cell > 0.0 && field->width > 0.5 * period) {
            fail(loader, field, "width",
                 "is more than half of the period of %.6g m along %c: grains would count twice",
                 period, "xyz"[a]);
            return;
        }
    }
}

static bool check_grid(clod_loader *loader, const clod_case_field *field)
{
    if (field->region.kind != CLOD_REGION_BOX) {
        fail(loader, field, "region",
             "must be a box, which is cut into cells; or leave out cell");
        return false;
    }
    if (field->width == 0.0) {
        fail(loader, field, "cell",
             "a grid needs a width, the radius of the kernel, for instance width: %.3g m",
             2.0 * field->cell);
        return false;
    }
    const double least = CLOD_CASE_FIELD_LEAST * field->cell;
    const double most = CLOD_CASE_FIELD_REACH * field->cell;
    if (field->width < least * (1.0 - 1e-12)) {
        fail(loader, field, "width",
             "is less than %.3g cells: grains would be missed between the middles of cells; "
             "allowed are %.6g m to %.6g m",
             CLOD_CASE_FIELD_LEAST, least, most);
        return false;
    }
    if (field->width > most * (1.0 + 1e-12)) {
        fail(loader, field, "width",
             "reaches over more than %.0f cells: every grain would be spread over thousands; "
             "allowed are %.6g m to %.6g m, or make cell larger",
             CLOD_CASE_FIELD_REACH, least, most);
        return false;
    }
    return true;
}

static void check_field(clod_loader *loader, const clod_case *self,
                        const clod_case_field *field)
{
    char path[CLOD_LOAD_PATH];
    snprintf(path, sizeof path, "fields.%s", field->name);
    if (!clod_report_clean(loader->report, path) ||
        !clod_check_region(loader, path, &field->region)) {
        return;
    }
    if (field->cell == 0.0 && field->width > 0.0) {
        fail(
            loader, field, "width",
            "is that of a grid; give it a cell, for instance cell: %.3g m, or leave out width: "
            "a mean over a region has none",
            0.5 * field->width);
    } else if (field->cell == 0.0 && field->frames) {
        fail(loader, field, "frames", "are those of a grid; give it a cell, or leave them out");
    } else if ((field->cell == 0.0 || check_grid(loader, field)) &&
               clod_check_region_place(loader, self, path, &field->region)) {
        check_period(loader, self, field);
        if (field->cell > 0.0 && clod_report_clean(loader->report, path)) {
            check_fit(loader, self, field);
        }
    }
}

/** Cells of all grids together. */
static void check_cells(clod_loader *loader, const clod_case *self)
{
    double sum = 0.0;
    for (size_t k = 0; k < self->field_count; k++) {
        const clod_case_field *field = &self->fields[k];
        if (field->cell > 0.0) {
            const double cells =
                clod_grid_cells(field->region.min, field->region.max, field->cell);
            sum += cells;
            if (sum > CLOD_CASE_FIELD_CELLS) {
                const double left = fmax(1.0, CLOD_CASE_FIELD_CELLS - (sum - cells));
                fail(loader, field, "cell",
                     "makes %.3g cells, and the grids before it %.3g; at most %d are allowed "
                     "together: make it %.3g m or the region smaller",
                     cells, sum - cells, CLOD_CASE_FIELD_CELLS,
                     1.1 * field->cell * cbrt(cells / left));
                return;
            }
        }
    }
}

void clod_check_fields(clod_loader *loader, const clod_case *self)
{
    if (self->field_count > CLOD_CASE_FIELDS) {
        clod_check_fail(loader, "fields", "has %zu fields; at most %d", self->field_count,
                        CLOD_CASE_FIELDS);
        return;
    }
    for (size_t k = 0; k < self->field_count; k++) {
        check_field(loader, self, &self->fields[k]);
    }
    if (clod_report_clean(loader->report, "fields")) {
        check_cells(loader, self);
    }
}
