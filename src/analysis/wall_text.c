/**
 * @file wall_text.c
 * Wall yield loci for people, and for programs as JSON and CSV.
 */

#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/cells.h"
#include "analysis/prose.h"
#include "base/given.h"
#include "base/json.h"
#include "base/text.h"
#include "clod/wall_locus.h"

#define DEGREES (180.0 / M_PI)

typedef clod_wall_locus locus;
typedef clod_wall_locus_mark mark;

// ---- for people

static void put_value(FILE *out, const locus *self, const char *name, const char *key,
                      clod_locus_value value, double scale, int digits, const char *unit)
{
    fprintf(out, "  %-32s %-8s%10.*f ± ", name, key, digits, scale * value.value);
    clod_prose_error(out, 8, digits, scale * value.error);
    if (self->seed_count > 1) {
        clod_prose_number(out, 10, digits, scale * value.scatter);
    }
    fprintf(out, "  %s\n", unit);
}

static void put_errors(FILE *out, const locus *self)
{
    switch (self->errors) {
    case CLOD_LOCUS_ERRORS_SEEDS:
        fprintf(out,
                "  Mean ± standard error of the mean, then the scatter (standard deviation), "
                "of %zu seeds.\n",
                self->seed_count);
        return;
    case CLOD_LOCUS_ERRORS_FIT:
        fputs("  ± one standard error, from scatter about the line and errors of the points",
              out);
        fputs(clod_wall_locus_one_specimen(self) ? ";\n  " CLOD_LOCUS_ONE_SPECIMEN ".\n"
                                                 : ".\n",
              out);
        return;
    default:
        fputs("  No error bars: they need three points, or the errors of the points.\n", out);
    }
}

static void put_mark(FILE *out, const mark *m, bool seeds)
{
    fputs("  ", out);
    if (seeds) {
        fprintf(out, "%8lld", (long long)m->point.seed);
    }
    fprintf(out, "%10.3f%10.3f ± ", 1e-3 * m->point.sigma, 1e-3 * m->point.tau);
    clod_prose_error(out, 6, 3, 1e-3 * clod_cells_error(m->point.tau_error));
    fprintf(out, "%10.2f ± ", DEGREES * m->phi_x.value);
    clod_prose_error(out, 5, 2, DEGREES * m->phi_x.error);
    fprintf(out, "%10.3f%s\n", 1e-3 * m->line, m->point.unsteady ? "  not steady" : "");
}

char *clod_wall_locus_table(const clod_wall_locus *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    const bool seeds = self->seed_count > 1;
    fprintf(out, "Wall yield locus: %zu points", self->point_count);
    fprintf(out, seeds ? ", %zu seeds\n\n" : "\n\n", self->seed_count);
    put_value(out, self, "kinematic angle of wall friction", "phi_w", self->phi_w, DEGREES, 2,
              "deg");
    put_value(out, self, "wall adhesion", "tau_ad", self->tau_ad, 1e-3, 3, "kPa");
    fprintf(out, "  %-32s %-8s%10.4f\n\n", seeds ? "worst fit of a line" : "fit of the line",
            "r2", self->r_squared);
    put_errors(out, self);
    fprintf(out, "\n  %s%10s%10s%9s%10s%8s%10s\n", seeds ? "    seed" : "", "sigma_w", "tau_w",
            "", "phi_x", "", "line");
    fprintf(out, "  %s%10s%10s%9s%10s%8s%10s\n", seeds ? "        " : "", "[kPa]", "[kPa]", "",
            "[deg]", "", "[kPa]");
    for (size_t i = 0; i < self->point_count; i++) {
        put_mark(out, &self->marks[i], seeds);
    }
    fputs(self->warning_count > 0 ? "\n  Warnings\n" : "", out);
    for (size_t i = 0; i < self->warning_count; i++) {
        clod_prose_warning(out, self->warnings[i]);
    }
    return clod_text_close(&text);
}

// ---- for programs

static json_t *value_of(clod_locus_value value, double scale)
{
    return json_pack("{s:o, s:o, s:o}", "value", clod_json_number(scale * value.value), "error",
                     clod_json_number(scale * value.error), "scatter",
                     clod_json_number(scale * value.scatter));
}

/** The stress that was asked for; NaN: of a table nobody knows. */
static double asked_of(const mark *m)
{
    return m->point.wall_stress > 0.0 ? m->point.wall_stress : (double)NAN;
}

static json_t *mark_of(const mark *m)
{
    return json_pack(
        "{s:I, s:o, s:f, s:o, s:f, s:o, s:f, s:o, s:f, s:b}", "seed", (json_int_t)m->point.seed,
        "wall_stress_Pa", clod_json_number(asked_of(m)), "sigma_w_Pa", m->point.sigma,
        "sigma_w_error_Pa", clod_json_number(clod_cells_error(m->point.sigma_error)),
        "tau_w_Pa", m->point.tau, "tau_w_error_Pa",
        clod_json_number(clod_cells_error(m->point.tau_error)), "phi_x_deg",
        DEGREES * m->phi_x.value, "phi_x_error_deg", clod_json_number(DEGREES * m->phi_x.error),
        "line_Pa", m->line, "steady", !m->point.unsteady);
}

char *clod_wall_locus_json(const clod_wall_locus *self)
{
    static const char *const ERRORS[] = {"none", "fit", "seeds"};
    CLOD_NEED(self);
    json_t *points = json_array();
    json_t *warnings = json_array();
    for (size_t i = 0; i < self->point_count; i++) {
        json_array_append_new(points, mark_of(&self->marks[i]));
    }
    for (size_t i = 0; i < self->warning_count; i++) {
        json_array_append_new(warnings, json_string(self->warnings[i]));
    }
    json_t *all = json_pack(
        "{s:o, s:o, s:f, s:s, s:s?, s:I, s:o, s:o}", "phi_w_deg",
        value_of(self->phi_w, DEGREES), "tau_ad_Pa", value_of(self->tau_ad, 1.0), "r_squared",
        self->r_squared, "errors_from", ERRORS[self->errors], "errors_note",
        clod_wall_locus_one_specimen(self) ? CLOD_LOCUS_ONE_SPECIMEN : NULL, "seed_count",
        (json_int_t)self->seed_count, "points", points, "warnings", warnings);
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}

char *clod_wall_locus_csv(const clod_wall_locus *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs("seed,sigma_w [Pa],sigma_w_error [Pa],tau_w [Pa],tau_w_error [Pa],phi_x [deg],"
          "phi_x_error [deg],line [Pa],wall_stress [Pa],steady [1]\n",
          out);
    for (size_t i = 0; i < self->point_count; i++) {
        const mark *m = &self->marks[i];
        const double values[] = {m->point.sigma,
                                 clod_cells_error(m->point.sigma_error),
                                 m->point.tau,
                                 clod_cells_error(m->point.tau_error),
                                 DEGREES * m->phi_x.value,
                                 DEGREES * m->phi_x.error,
                                 m->line,
                                 asked_of(m)};
        fprintf(out, "%lld", (long long)m->point.seed);
        for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
            clod_cells_put(out, values[k]);
        }
        fprintf(out, ",%d\n", !m->point.unsteady);
    }
    return clod_text_close(&text);
}
