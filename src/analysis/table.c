/**
 * @file table.c
 * Results of shear tests for people: aligned tables with units, error bars and warnings.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fields.h"
#include "analysis/prose.h"
#include "base/given.h"
#include "base/memory.h"
#include "base/text.h"

#define DEGREES (180.0 / 3.14159265358979323846)

/** How a kind of value is shown. */
typedef struct format {
    double scale;
    int digits;
    const char *unit;
} format;

static const format FORMATS[] = {
    [CLOD_FIELD_STRESS] = {1e-3, 3, "kPa"},
    [CLOD_FIELD_ANGLE] = {DEGREES, 2, "deg"},
    [CLOD_FIELD_NUMBER] = {1.0, 2, ""},
    [CLOD_FIELD_DENSITY] = {1.0, 1, "kg/m3"},
};

/** A number in a column of `width`, or what stands for it when there is none. */
static void put_number(FILE *out, const format *how, int width, double value,
                       const char *otherwise)
{
    if (isnan(value)) {
        fprintf(out, "%*s", width, otherwise);
    } else if (isinf(value)) {
        fprintf(out, "%*s", width, "infinite");
    } else {
        fprintf(out, "%*.*f", width, how->digits, how->scale * value);
    }
}

static void put_field(FILE *out, const clod_locus *locus, clod_field_index index)
{
    const clod_field *field = &CLOD_FIELDS[index];
    const clod_locus_value value = clod_field_get(locus, index);
    const format *how = &FORMATS[field->kind];
    const bool known = index != CLOD_FIELD_RHO_B;
    const char *key = index == CLOD_FIELD_FFC ? "ffc" : field->key;
    // a longer name takes of the words before it, so that the numbers stand in their column
    const int width = (int)fmax((double)strlen(key), 8.0);
    fprintf(out, "  %-*s %-*s", 40 - width, field->text, width, key);
    put_number(out, how, 10, value.value, known ? "undefined" : "not given");
    fputs(" ± ", out);
    put_number(out, how, 8, value.error, "-");
    if (locus->seed_count > 1) {
        put_number(out, how, 10, value.scatter, "-");
    }
    fprintf(out, "%s%s\n", how->unit[0] == '\0' ? "" : "  ", how->unit);
}

static void put_errors(FILE *out, const clod_locus *locus)
{
    switch (locus->errors) {
    case CLOD_LOCUS_ERRORS_SEEDS:
        fprintf(out,
                "  Mean ± standard error of the mean, then the scatter (standard deviation), "
                "of %zu seeds",
                locus->seed_count);
        break;
    case CLOD_LOCUS_ERRORS_FIT:
        fputs("  ± one standard error, from scatter about the line and errors of the points",
              out);
        break;
    default:
        fputs(
            "  No error bars: they need three points, or errors of the points and the preshear",
            out);
    }
    const char *specimen = clod_locus_specimen_note(locus);
    if (specimen != NULL) {
        const bool unless = strstr(specimen, CLOD_LOCUS_UNLESS_JENIKE) != NULL;
        fputs(";\n  " CLOD_LOCUS_ONE_SPECIMEN, out);
        fputs(unless ? ",\n  " CLOD_LOCUS_UNLESS_JENIKE : "", out);
    }
    fputs(locus->preshear_untold ? ";\n  " CLOD_LOCUS_PRESHEAR_UNTOLD : "", out);
    fputs(".\n", out);
}

static void put_marks(FILE *out, const clod_locus *locus)
{
    const format *how = &FORMATS[CLOD_FIELD_STRESS];
    const bool seeds = locus->seed_count > 1;
    fprintf(out, "\n  %s%10s%10s%10s%10s   kPa\n", seeds ? "    seed" : "", "sigma_s", "tau_s",
            "prorated", "line");
    for (size_t i = 0; i < locus->point_count; i++) {
        const clod_locus_mark *mark = &locus->marks[i];
        fputs("  ", out);
        if (seeds) {
            fprintf(out, "%8lld", (long long)mark->seed);
        }
        put_number(out, how, 10, mark->sigma, "-");
        put_number(out, how, 10, mark->measured, "-");
        put_number(out, how, 10, mark->prorated, "-");
        put_number(out, how, 10, mark->line, "-");
        fputs("\n", out);
    }
}

static void put_locus(FILE *out, const clod_locus *locus)
{
    fprintf(out, "Yield locus at preshear %.3f kPa: %zu points", locus->sigma_p.value / 1000.0,
            locus->point_count);
    fprintf(out, locus->seed_count > 1 ? ", %zu seeds\n\n" : "\n\n", locus->seed_count);
    for (clod_field_index k = 0; k < CLOD_FIELD_COUNT; k++) {
        if (k != CLOD_FIELD_RHO_INSIDE || !isnan(locus->rho_inside.value)) {
            put_field(out, locus, k); // no laboratory knows that one, nor a narrow cell
        }
    }
    fprintf(out, "  %-32s %-8s%10s\n", "flow (Jenike)", "", locus->flow);
    fprintf(out, "  %-32s %-8s%10.4f\n\n",
            locus->seed_count > 1 ? "worst fit of a line" : "fit of the line", "r2",
            locus->r_squared);
    put_errors(out, locus);
    put_marks(out, locus);
    if (locus->warning_count > 0) {
        fputs("\n  Warnings\n", out);
    }
    for (size_t i = 0; i < locus->warning_count; i++) {
        clod_prose_warning(out, locus->warnings[i]);
    }
}

/** sigma_c over sigma_1, one row per consolidation. */
static void put_flow_function(FILE *out, const clod_locus_study *study)
{
    static const clod_field_index COLUMNS[] = {
        CLOD_FIELD_SIGMA_P, CLOD_FIELD_SIGMA_1, CLOD_FIELD_SIGMA_C, CLOD_FIELD_FFC,
        CLOD_FIELD_PHI_E,   CLOD_FIELD_PHI_LIN, CLOD_FIELD_RHO_B};
    const size_t columns = sizeof COLUMNS / sizeof COLUMNS[0];
    fprintf(out, "\nFlow function: %zu consolidations\n\n  ", study->count);
    for (size_t k = 0; k < columns; k++) {
        fprintf(out, "%11s", CLOD_FIELDS[COLUMNS[k]].key);
    }
    fputs("  flow (Jenike)\n  ", out);
    for (size_t k = 0; k < columns; k++) {
        fprintf(out, "%11s", FORMATS[CLOD_FIELDS[COLUMNS[k]].kind].unit);
    }
    fputs("\n", out);
    for (size_t g = 0; g < study->count; g++) {
        const clod_locus *locus = &study->groups[g].locus;
        fputs("  ", out);
        for (size_t k = 0; k < columns; k++) {
            put_number(out, &FORMATS[CLOD_FIELDS[COLUMNS[k]].kind], 11,
                       clod_field_get(locus, COLUMNS[k]).value,
                       COLUMNS[k] == CLOD_FIELD_RHO_B ? "not given" : "undefined");
        }
        fprintf(out, "  %s\n", locus->flow);
    }
    if (study->warning[0] != '\0') {
        fputs("\n  Warnings\n", out);
        clod_prose_warning(out, study->warning);
    }
}

char *clod_locus_table(const clod_locus_study *study)
{
    CLOD_NEED(study);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    for (size_t g = 0; g < study->count; g++) {
        fputs(g > 0 ? "\n" : "", out);
        put_locus(out, &study->groups[g].locus);
    }
    if (study->count > 1) {
        put_flow_function(out, study);
    }
    return clod_text_close(&text);
}
