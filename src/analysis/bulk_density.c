#include "analysis/bulk_density.h"

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/cells.h"
#include "analysis/fit.h"
#include "analysis/prose.h"
#include "base/given.h"
#include "base/json.h"
#include "base/memory.h"
#include "base/text.h"
#include "clod/bulk_density.h"

#define KILO 1000.0
#define CHANCE 2.0    ///< standard errors that may be chance
#define BETA_MOST 0.5 ///< at four times the stress twice the density
#define POUND_FOOT3 (0.45359237 / (0.3048 * 0.3048 * 0.3048)) ///< kg/m3
#define OFF 0.05 ///< of a density from the law, relative; docs/theory/yield-locus.md

typedef clod_bulk_density_point point;

// ---- reading

#define POINT(field) .offset = offsetof(clod_bulk_density_point, field)

static const clod_csv_column COLUMNS[] = {
    {.names = {"sigma_1"}, .unit = "Pa", .required = true, POINT(sigma_1)},
    {.names = {"sigma_1_error"}, .unit = "Pa", POINT(sigma_1_error)},
    {.names = {"rho_b", "rho"},
     .unit = "kg/m3",
     .positive = true,
     .required = true,
     POINT(rho_b)},
    {.names = {"rho_b_error"}, .unit = "kg/m3", POINT(rho_b_error)},
};

bool clod_bulk_density_is_usual(double rho)
{
    return rho >= CLOD_BULK_DENSITY_LEAST && rho <= CLOD_BULK_DENSITY_MOST;
}

bool clod_bulk_density_warn(double rho, char text[CLOD_LOCUS_WARNING_TEXT])
{
    text[0] = '\0';
    if (rho < CLOD_BULK_DENSITY_LIGHT) {
        snprintf(
            text, CLOD_LOCUS_WARNING_TEXT,
            "rho_b is %.1f kg/m3, as light as perlite, foam or aerogel. Is it in lb/ft3? %.1f "
            "lb/ft3 are %.0f kg/m3.",
            rho, rho, POUND_FOOT3 * rho);
    }
    return text[0] != '\0';
}

bool clod_bulk_density_check(const clod_csv *self, const char *column, double rho)
{
    return clod_bulk_density_is_usual(rho) ||
           clod_status_fail(self->status, CLOD_USAGE,
                            "%s:%zu: column %s: %.6g kg/m3 is outside %g to %g kg/m3; is its "
                            "unit another one, [g/cm3]?",
                            self->path, self->line, column, rho, CLOD_BULK_DENSITY_LEAST,
                            CLOD_BULK_DENSITY_MOST);
}

bool clod_bulk_density_consolidated(const char *path, double sigma_1, clod_status *status)
{
    return sigma_1 > 0.0 ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: a row has sigma_1 = 0, that of a loose density. Only clod hopper takes it: leave "
               "the row out here, or give the small stress under which it was measured.",
               path);
}

static bool check_row(const clod_csv *self, const void *row)
{
    return clod_bulk_density_check(self, "rho_b", ((const point *)row)->rho_b);
}

static const clod_csv_kind POINTS = {
    .columns = COLUMNS,
    .count = sizeof COLUMNS / sizeof COLUMNS[0],
    .row = sizeof(point),
    .known = "sigma_1, rho_b, sigma_1_error, rho_b_error",
    .example = "sigma_1 [kPa],rho_b [kg/m3]",
    .item = "bulk density point",
    .check_row = check_row,
};

bool clod_bulk_density_parse(const char *path, const char *text, size_t length,
                             clod_bulk_density_point **points, size_t *count,
                             clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(text, status) || !CLOD_GIVEN(points, status) ||
        !CLOD_GIVEN(count, status)) {
        return false;
    }
    clod_csv self = {.kind = &POINTS, .path = path, .status = status};
    const bool good = clod_csv_parse(&self, text, length);
    *points = good ? self.rows : NULL;
    *count = good ? self.count : 0;
    return good;
}

// ---- the power law

static int ascending(const void *first, const void *second)
{
    const double a = ((const point *)first)->sigma_1;
    const double b = ((const point *)second)->sigma_1;
    return (a > b) - (a < b);
}

/** Square of what is stated for a point, as the line through the logarithms sees it. */
static double stated(const point *p, double slope)
{
    const double of_density = p->rho_b_error / p->rho_b;
    const double of_stress = slope * p->sigma_1_error / p->sigma_1;
    return of_density * of_density + of_stress * of_stress;
}

/** The power law at a stress [kg/m3]. */
static double law(const clod_bulk_density *self, double sigma_1)
{
    return self->rho_1.value * pow(sigma_1 / KILO, self->compressibility.value);
}

/** Memory for a warning; each of the looks below gives one at most. */
static char *warning(clod_bulk_density *self)
{
    return self->warnings[self->warning_count++];
}

/** An exponent that no solid has. */
static void look_at_exponent(clod_bulk_density *self)
{
    const clod_locus_value *beta = &self->compressibility;
    if (beta->value < 0.0 && !(beta->value > -CHANCE * beta->error)) {
        snprintf(warning(self), CLOD_LOCUS_WARNING_TEXT,
                 "The bulk density falls while the stress rises (beta = %.4f): no solid is "
                 "compressed to less. Look at the columns and at the order of the rows.",
                 beta->value);
    } else if (beta->value > BETA_MOST) {
        snprintf(
            warning(self), CLOD_LOCUS_WARNING_TEXT,
            "beta = %.4f: no solid is compressed as much by a stress (at most %g). Look at "
            "the columns, at their units and for a slip.",
            beta->value, BETA_MOST);
    }
}

/** The point furthest off the law, beyond what it states. r2 does not tell: it is low for every solid that is hardly compressed. */
static void look_at_scatter(clod_bulk_density *self)
{
    const point *worst = NULL;
    double most = OFF;
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->points[i];
        const double off = fabs(log(p->rho_b / law(self, p->sigma_1)));
        if (off > most && off > CHANCE * sqrt(stated(p, self->compressibility.value))) {
            most = off;
            worst = p;
        }
    }
    if (worst != NULL) {
        snprintf(
            warning(self), CLOD_LOCUS_WARNING_TEXT,
            "The points do not follow the law (r2 = %.3f): %.6g kg/m3 at %.3f kPa, where the "
            "law has %.1f; more than %.0f %% apart. Look at the points for a slip, or give "
            "only those near the stresses at hand.",
            self->r_squared, worst->rho_b, worst->sigma_1 / KILO, law(self, worst->sigma_1),
            100.0 * OFF);
    }
}

static void look_at_stated(clod_bulk_density *self)
{
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->points[i];
        if (p->rho_b_error >= p->rho_b || p->sigma_1_error >= p->sigma_1) {
            const bool rho = p->rho_b_error >= p->rho_b;
            snprintf(warning(self), CLOD_LOCUS_WARNING_TEXT,
                     "%s is %.3f %s with a stated standard error of %.3f %s: nothing was "
                     "measured then; check the column of errors and its unit.",
                     rho ? "rho_b" : "sigma_1", rho ? p->rho_b : p->sigma_1 / KILO,
                     rho ? "kg/m3" : "kPa", rho ? p->rho_b_error : p->sigma_1_error / KILO,
                     rho ? "kg/m3" : "kPa");
            return;
        }
    }
}

static void look_at_least(clod_bulk_density *self)
{
    double least = HUGE_VAL;
    for (size_t i = 0; i < self->point_count; i++) {
        least = fmin(least, self->points[i].rho_b);
    }
    char text[CLOD_LOCUS_WARNING_TEXT];
    if (clod_bulk_density_warn(least, text)) {
        memcpy(warning(self), text, sizeof text);
    }
}

/** @param work  [2 point_count] */
static void fit(clod_bulk_density *self, double *work)
{
    const size_t count = self->point_count;
    double *x = work, *y = work + count;
    for (size_t i = 0; i < count; i++) {
        x[i] = log(self->points[i].sigma_1 / KILO);
        y[i] = log(self->points[i].rho_b);
    }
    const clod_fit line = clod_fit_line(x, y, count);
    double *variance = y; // the line has taken y
    for (size_t i = 0; i < count; i++) {
        variance[i] = stated(&self->points[i], line.slope);
    }
    const clod_fit_error error = clod_fit_errors(&line, x, variance, count);
    const double rho_1 = exp(line.intercept);
    self->rho_1 = (clod_locus_value){rho_1, rho_1 * error.intercept, (double)NAN};
    self->compressibility = (clod_locus_value){line.slope, error.slope, (double)NAN};
    self->r_squared = line.r_squared;
    look_at_exponent(self);
    look_at_scatter(self);
    look_at_stated(self);
    look_at_least(self);
}

bool clod_bulk_density_evaluate(const clod_bulk_density_point *points, size_t count,
                                clod_bulk_density *self, clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || (count > 0 && !CLOD_GIVEN(points, status))) {
        return false;
    }
    memset(self, 0, sizeof *self);
    double *work = clod_memory_alloc(2 * count + 1, sizeof *work);
    self->points = clod_memory_alloc(count + 1, sizeof *self->points);
    if (work == NULL || self->points == NULL) {
        clod_memory_free(work);
        clod_bulk_density_fini(self);
        return clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
    }
    if (count > 0) {
        memcpy(self->points, points, count * sizeof *points);
        qsort(self->points, count, sizeof *self->points, ascending);
    }
    const bool good = count > 1 && self->points[0].sigma_1 > 0.0 &&
                      self->points[count - 1].sigma_1 > self->points[0].sigma_1;
    self->point_count = count;
    if (good) {
        fit(self, work);
    } else {
        clod_bulk_density_fini(self);
        clod_status_fail(status, CLOD_USAGE,
                         "Bulk density over stress needs at least two points at different "
                         "stresses above 0; there %s %zu.",
                         count == 1 ? "is" : "are", count);
    }
    clod_memory_free(work);
    return good;
}

void clod_bulk_density_fini(clod_bulk_density *self)
{
    CLOD_NEED(self);
    clod_memory_free(self->points);
    self->points = NULL;
    self->point_count = 0;
}

// ---- writing

char *clod_bulk_density_table(const clod_bulk_density *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "Bulk density: %zu points, rho_b = rho_1 (sigma_1/1 kPa)^beta\n\n",
            self->point_count);
    fprintf(out, "  %-32s %-8s%10.1f ± ", "bulk density at 1 kPa", "rho_1", self->rho_1.value);
    clod_prose_error(out, 8, 1, self->rho_1.error);
    fprintf(out, "  kg/m3\n  %-32s %-8s%10.4f ± ", "compressibility", "beta",
            self->compressibility.value);
    clod_prose_error(out, 8, 4, self->compressibility.error);
    fprintf(out, "\n  %-32s %-8s%10.4f\n\n", "fit of the law", "r2", self->r_squared);
    fputs(isfinite(self->compressibility.error)
              ? "  ± one standard error, from scatter about the law and errors of the points.\n"
              : "  No error bars: they need three points, or the errors of the points.\n",
          out);
    fprintf(out, "\n  %10s%10s%10s\n  %10s%10s%10s\n", "sigma_1", "rho_b", "law", "[kPa]",
            "[kg/m3]", "[kg/m3]");
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->points[i];
        fprintf(out, "  %10.3f%10.1f%10.1f\n", p->sigma_1 / KILO, p->rho_b,
                law(self, p->sigma_1));
    }
    fputs(self->warning_count > 0 ? "\n  Warnings\n" : "", out);
    for (size_t i = 0; i < self->warning_count; i++) {
        clod_prose_warning(out, self->warnings[i]);
    }
    return clod_text_close(&text);
}

char *clod_bulk_density_json(const clod_bulk_density *self)
{
    CLOD_NEED(self);
    json_t *points = json_array();
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->points[i];
        json_array_append_new(points,
                              json_pack("{s:f, s:o, s:f, s:o, s:f}", "sigma_1_Pa", p->sigma_1,
                                        "sigma_1_error_Pa",
                                        clod_json_number(clod_cells_error(p->sigma_1_error)),
                                        "rho_b_kg_m3", p->rho_b, "rho_b_error_kg_m3",
                                        clod_json_number(clod_cells_error(p->rho_b_error)),
                                        "law_kg_m3", law(self, p->sigma_1)));
    }
    json_t *warnings = json_array();
    for (size_t i = 0; i < self->warning_count; i++) {
        json_array_append_new(warnings, json_string(self->warnings[i]));
    }
    json_t *all =
        json_pack("{s:{s:f, s:o}, s:{s:f, s:o}, s:f, s:o, s:o}", "rho_1_kg_m3", "value",
                  self->rho_1.value, "error", clod_json_number(self->rho_1.error),
                  "compressibility", "value", self->compressibility.value, "error",
                  clod_json_number(self->compressibility.error), "r_squared", self->r_squared,
                  "points", points, "warnings", warnings);
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}

char *clod_bulk_density_csv(const clod_bulk_density *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs("sigma_1 [Pa],sigma_1_error [Pa],rho_b [kg/m3],rho_b_error [kg/m3]\n", out);
    for (size_t i = 0; i < self->point_count; i++) {
        const point *p = &self->points[i];
        fprintf(out, "%.10g", p->sigma_1);
        clod_cells_put(out, clod_cells_error(p->sigma_1_error));
        clod_cells_put(out, p->rho_b);
        clod_cells_put(out, clod_cells_error(p->rho_b_error));
        fputs("\n", out);
    }
    return clod_text_close(&text);
}
