/**
 * @file points.c
 * Shear points from a CSV file, simulated or measured, with units in its header.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/bulk_density.h"
#include "analysis/csv.h"
#include "analysis/warnings.h"
#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/locus.h"
#include "config/unit.h"

enum { SEED, SIGMA_PRE, TAU_PRE, SIGMA_SH, TAU_SH, COLUMN_COUNT = 10 };

#define POINT(field) .offset = offsetof(clod_locus_point, field)

static const clod_csv_column COLUMNS[COLUMN_COUNT] = {
    [SEED] = {.names = {"seed"}, .unit = "", POINT(seed)},
    [SIGMA_PRE] = {.names = {"sigma_pre", "sigma_p"},
                   .unit = "Pa",
                   .positive = true,
                   POINT(sigma_p)},
    [TAU_PRE] = {.names = {"tau_pre", "tau_p"}, .unit = "Pa", .positive = true, POINT(tau_p)},
    [SIGMA_SH] = {.names = {"sigma_sh", "sigma_s", "sigma"},
                  .unit = "Pa",
                  .required = true,
                  POINT(sigma_s)},
    [TAU_SH] = {.names = {"tau_sh", "tau_s", "tau"},
                .unit = "Pa",
                .required = true,
                POINT(tau_s)},
    {.names = {"rho_b", "rho"}, .unit = "kg/m3", .positive = true, POINT(rho_b)},
    {.names = {"tau_pre_error"}, .unit = "Pa", POINT(tau_p_error)},
    {.names = {"tau_sh_error"}, .unit = "Pa", POINT(tau_s_error)},
    {.names = {"rho_b_error"}, .unit = "kg/m3", POINT(rho_b_error)},
    {.names = {"rho_inside"}, .unit = "kg/m3", .positive = true, POINT(rho_inside)},
};

/** The option of `clod locus`, which alone has defaults, for a column's value in all rows. */
static const char *option_of(size_t index)
{
    return index == SIGMA_PRE ? "sigma-pre" : "tau-pre";
}

static bool check_header(const clod_csv *self)
{
    const clod_locus_point *first = self->first;
    const double defaults[] = {[SIGMA_PRE] = first != NULL ? first->sigma_p : 0.0,
                               [TAU_PRE] = first != NULL ? first->tau_p : 0.0};
    for (size_t i = SIGMA_PRE; i <= TAU_PRE; i++) {
        if (!clod_csv_has(self, i) && first == NULL) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s:%zu: the header has no column %s; add it.", self->path,
                                    self->line, COLUMNS[i].names[0]);
        }
        if (!clod_csv_has(self, i) && defaults[i] == 0.0) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s:%zu: the header has no column %s and no value for all "
                                    "rows was given; add the column, or give --%s.",
                                    self->path, self->line, COLUMNS[i].names[0], option_of(i));
        }
    }
    return true;
}

#define FACTOR 2.0 ///< between their bulk densities: no specimens differ as much

static bool check_row(const clod_csv *self, const void *row)
{
    const clod_locus_point *point = row;
    if ((point->rho_b != 0.0 && // 0: not there
         !clod_bulk_density_check(self, "rho_b", point->rho_b)) ||
        (point->rho_inside != 0.0 &&
         !clod_bulk_density_check(self, "rho_inside", point->rho_inside))) {
        return false;
    }
    return true;
}

static const size_t LINE = offsetof(clod_locus_point, row);

static const clod_csv_kind POINTS = {
    .columns = COLUMNS,
    .count = COLUMN_COUNT,
    .row = sizeof(clod_locus_point),
    .known =
        "sigma_sh (or sigma_s, sigma), tau_sh (or tau_s, tau), sigma_pre (or sigma_p), "
        "tau_pre (or tau_p), seed, rho_b (or rho), tau_pre_error, tau_sh_error, rho_b_error, "
        "rho_inside",
    .example = "sigma_pre [kPa],tau_pre [kPa],sigma_sh [kPa],tau_sh [kPa]",
    .item = "shear point",
    .line = &LINE,
    .check_header = check_header,
    .check_row = check_row,
};

/** Whether two rows of one consolidation have densities of no one solid. */
static bool contradict(const clod_locus_point *a, const clod_locus_point *b)
{
    return fabs(a->sigma_p - b->sigma_p) <=
               CLOD_WARNINGS_SAME_PRESHEAR * fmin(a->sigma_p, b->sigma_p) &&
           a->rho_b > 0.0 && b->rho_b > 0.0 &&
           fmax(a->rho_b, b->rho_b) > FACTOR * fmin(a->rho_b, b->rho_b);
}

static bool check_densities(const clod_csv *self)
{
    const clod_locus_point *points = self->rows;
    for (size_t i = 0; i < self->count; i++) {
        for (size_t k = 0; k < i; k++) {
            if (contradict(&points[k], &points[i])) {
                return clod_status_fail(
                    self->status, CLOD_USAGE,
                    "%s:%zu: column rho_b: %.6g kg/m3, but line %zu has %.6g kg/m3 at the same "
                    "preshear stress, %.3f kPa: one consolidation has one bulk density. Correct "
                    "the one that is wrong, or leave it empty.",
                    self->path, points[i].row, points[i].rho_b, points[k].row, points[k].rho_b,
                    points[i].sigma_p / 1000.0);
            }
        }
    }
    return true;
}

/** sigma_pre or tau_pre of a point. */
static double preshear_of(const clod_locus_point *point, size_t column)
{
    return column == SIGMA_PRE ? point->sigma_p : point->tau_p;
}

/** Whether rows have different values of a column, so that no one value is that of the empty cells. */
static bool differ(const clod_csv *self, size_t column)
{
    const clod_locus_point *points = self->rows;
    double first = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        const double value = preshear_of(&points[i], column);
        if (value > 0.0 && first > 0.0 && value != first) {
            return true;
        }
        first = first > 0.0 ? first : value;
    }
    return false;
}

/** Every row has a preshear. */
static bool check_preshears(clod_csv *self)
{
    const clod_locus_point *points = self->rows;
    for (size_t i = 0; i < self->count; i++) {
        for (size_t c = SIGMA_PRE; c <= TAU_PRE; c++) {
            if (preshear_of(&points[i], c) > 0.0) {
                continue;
            }
            char fault[96] = "is empty; fill it in.";
            if (differ(self, c)) {
                snprintf(fault, sizeof fault,
                         "is empty; fill it in. (Of merged cells a file has the first alone.)");
            } else if (self->first != NULL) {
                snprintf(fault, sizeof fault, "is empty; fill it in, or give --%s.",
                         option_of(c));
            }
            self->line = points[i].row;
            return clod_csv_fail(self, &COLUMNS[c], "", fault);
        }
    }
    return true;
}

/** A default that no row needs is a mistake: the column would silently win. */
static bool check_defaults(const clod_csv *self, const clod_locus_defaults *defaults)
{
    const char *const given[] = {
        [SIGMA_PRE] = defaults->sigma_pre, [TAU_PRE] = defaults->tau_pre};
    for (size_t i = SIGMA_PRE; i <= TAU_PRE; i++) {
        if (given[i] != NULL && clod_csv_has(self, i) && !self->gap[i]) {
            return clod_status_fail(self->status, CLOD_USAGE,
                                    "%s: column %s has a value in every row, so --%s=\"%.64s\" "
                                    "would change nothing; leave the option out, or remove the "
                                    "column.",
                                    self->path, COLUMNS[i].names[0], option_of(i), given[i]);
        }
    }
    return true;
}

/** A default such as "54.8 kPa"; NULL gives 0. */
static bool read_default(const char *text, size_t index, double *value, clod_status *status)
{
    *value = 0.0;
    if (text == NULL) {
        return true;
    }
    char message[CLOD_UNIT_MESSAGE] = "is not a number with a unit, such as 54.8 kPa";
    const char *unit = clod_unit_number(text, value);
    if (unit == NULL || !clod_unit_convert(unit, "Pa", value, message)) {
        return clod_status_fail(status, CLOD_USAGE, "%s for all rows, \"%.64s\": %s%s",
                                COLUMNS[index].names[0], text, message, clod_csv_stop(message));
    }
    return *value > 0.0 ||
           clod_status_fail(status, CLOD_USAGE, "%s for all rows, \"%.64s\": must be above 0.",
                            COLUMNS[index].names[0], text);
}

bool clod_locus_parse(const char *path, const char *text, size_t length,
                      const clod_locus_defaults *defaults, clod_locus_point **points,
                      size_t *count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(text, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    const clod_locus_defaults given = defaults != NULL ? *defaults : (clod_locus_defaults){0};
    *points = NULL;
    *count = 0;
    clod_locus_point first = {0};
    clod_csv self = {.kind = &POINTS,
                     .first = defaults != NULL ? &first : NULL,
                     .path = path,
                     .status = status};
    if (!read_default(given.sigma_pre, SIGMA_PRE, &first.sigma_p, status) ||
        !read_default(given.tau_pre, TAU_PRE, &first.tau_p, status) ||
        !clod_csv_parse(&self, text, length)) {
        return false;
    }
    if (!check_preshears(&self) || !check_defaults(&self, &given) || !check_densities(&self)) {
        clod_memory_free(self.rows);
        return false;
    }
    *points = self.rows;
    *count = self.count;
    return true;
}

bool clod_locus_read(const char *path, const clod_locus_defaults *defaults,
                     clod_locus_point **points, size_t *count, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    *points = NULL;
    *count = 0;
    char *text;
    size_t size;
    if (!clod_input_read_named(&path, &text, &size, status)) {
        return false;
    }
    const bool done = clod_locus_parse(path, text, size, defaults, points, count, status);
    clod_memory_free(text);
    return done;
}
