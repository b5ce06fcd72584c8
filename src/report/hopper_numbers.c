#include "report/hopper_numbers.h"

#include <math.h>

#include "analysis/cells.h"
#include "base/input.h"
#include "base/memory.h"
#include "clod/version.h"
#include "hopper/words.h"
#include "report/hopper_cells.h"
#include "report/html.h"

#define MOST_BYTES ((size_t)1 << 22) ///< of a case or a table that the page shows

static const clod_hopper_field HEAD = {
    "filling_stress_Pa", "vertical stress after filling", "kPa", 1e-3, 1.0, 3, NULL};

/** Begin a row with the name of a quantity and its unit. */
static void begin_row(FILE *out, const char *name, const char *unit)
{
    char text[128];
    snprintf(text, sizeof text, unit[0] != '\0' ? "%s [%s]" : "%s", name, unit);
    fputs("<tr>", out);
    clod_html_cell(out, "th", text);
}

static void put_row(FILE *out, const clod_hopper_field *how, const clod_hopper_value *number)
{
    begin_row(out, how->text, how->unit);
    clod_hopper_cells_put(out, how, number->value);
    clod_hopper_cells_put(out, how, number->low);
    clod_hopper_cells_put(out, how, number->high);
    fputs("</tr>\n", out);
}

/** How well the number of samples tells the ends of the interval of the critical outlet. */
static void put_ends(FILE *out, const clod_hopper_value *outlet)
{
    static const clod_hopper_field ENDS = {
        "", "its ends, ± by the number of samples", "mm", 1e3, 1.0, 1, NULL};
    if (outlet->low_error > 0.0 || outlet->high_error > 0.0) {
        put_row(out, &ENDS,
                &(clod_hopper_value){.value = (double)NAN,
                                     .low = outlet->low_error,
                                     .high = outlet->high_error});
    }
}

static void begin_table(FILE *out, const clod_hopper *design, const char *first)
{
    const double tail = 50.0 * (1.0 - design->from.interval.level);
    fprintf(out,
            "<div class=\"scroll\"><table class=\"copied\"><thead><tr><th>%s</th><th>value</th>"
            "<th>%.3g %%</th><th>%.3g %%</th></tr></thead>\n<tbody>",
            first, tail, 100.0 - tail);
}

static void put_numbers(FILE *out, const clod_hopper *design)
{
    static const clod_hopper_field PARTICLES[CLOD_HOPPER_SHAPES] = {
        [CLOD_RADIAL_CONE] = {"", "outlet by particles, 8 times", "mm", 1e3, 1.0, 1, NULL},
        [CLOD_RADIAL_WEDGE] = {"", "outlet by particles, 4 times", "mm", 1e3, 1.0, 1, NULL}};
    const double none = (double)NAN;
    clod_html_section(out, "results", "Numbers");
    for (int k = 0; k < CLOD_HOPPER_SHAPES; k++) {
        const clod_hopper_found *found = &design->shape[CLOD_HOPPER_CELLS_SHAPES[k]];
        begin_table(out, design, clod_hopper_cells_shape(CLOD_HOPPER_CELLS_SHAPES[k]));
        for (int n = 0; n < CLOD_HOPPER_NUMBERS; n++) {
            if (n != CLOD_HOPPER_MARGIN || found->planned > 0.0) {
                put_row(out, clod_hopper_field_of(found, (clod_hopper_number)n),
                        &found->number[n]);
            }
            if (n == CLOD_HOPPER_OUTLET) {
                put_ends(out, &found->number[n]);
            }
        }
        if (found->mechanical > 0.0) {
            put_row(
                out, &PARTICLES[CLOD_HOPPER_CELLS_SHAPES[k]],
                &(clod_hopper_value){.value = found->mechanical, .low = none, .high = none});
        }
        if (found->wish.shape == CLOD_RADIAL_WEDGE) {
            put_row(out, &CLOD_HOPPER_FIELD_SLOT, &design->slot_width);
        }
        fputs("</tbody></table></div>\n", out);
    }
    if (design->solid.phi_t.count > 0) {
        begin_table(out, design, "Rathole");
        put_row(out, &CLOD_HOPPER_CELLS_HOLES[CLOD_HOPPER_EMPTYING],
                &design->rathole[CLOD_HOPPER_EMPTYING]);
        if (design->silo.diameter > 0.0) {
            put_row(out, &CLOD_HOPPER_CELLS_HOLES[CLOD_HOPPER_FILLING],
                    &design->rathole[CLOD_HOPPER_FILLING]);
            put_row(out, &HEAD,
                    &(clod_hopper_value){
                        .value = design->hole.filling_stress, .low = none, .high = none});
        }
        fputs("</tbody></table></div>\n", out);
    }
}

/** A share of cone and wedge, in the order of the page. */
static void put_shares(FILE *out, const clod_hopper_field *how,
                       const double share[CLOD_HOPPER_SHAPES])
{
    fprintf(out, "<tr><th>%s</th>", how->text);
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        clod_hopper_cells_put(out, how, share[s]);
    }
    fputs("</tr>\n", out);
}

/** Where the intervals come from: what the samples came to, and which measurement spreads them. */
static void put_causes(FILE *out, const clod_hopper *design)
{
    static const struct {
        int curve;
        clod_hopper_field how;
    } ROWS[] = {
        {CLOD_SOLID_STRENGTH, {"", "flow function", "%", 100.0, 1.0, 1, NULL}},
        {CLOD_SOLID_WALL, {"", "wall friction", "%", 100.0, 1.0, 1, NULL}},
        {CLOD_SOLID_PHI_E, {"", "effective angle phi_e", "%", 100.0, 1.0, 1, NULL}},
        {CLOD_SOLID_RHO, {"", "bulk density", "%", 100.0, 1.0, 1, NULL}},
    };
    static const clod_hopper_field NO_CURVE = {
        "", "not told by all of them", "%", 100.0, 1.0, 1, NULL};
    const clod_hopper_interval *interval = &design->from.interval;
    clod_html_section(out, "interval", "Where the intervals come from");
    fprintf(out,
            "<p>%lld samples: each is a design from values drawn within the errors of what was "
            "measured.",
            (long long)interval->samples);
    char note[CLOD_WORDS_MOST];
    if (clod_words_line(design, note)) {
        fputs(" ", out);
        clod_html_text(out, note);
    }
    if (clod_words_drawn(design, note)) {
        fputs(" ", out);
        clod_html_text(out, note);
    }
    fputs("</p>\n<ul>", out);
    for (int k = 0; k < CLOD_HOPPER_SHAPES; k++) {
        char text[CLOD_WORDS_MOST];
        clod_words_shares(&design->shape[CLOD_HOPPER_CELLS_SHAPES[k]], text);
        fprintf(out, "<li>%s: ", CLOD_HOPPER_SHAPE_NAMES[CLOD_HOPPER_CELLS_SHAPES[k]]);
        clod_html_text(out, text);
        fputs("</li>\n", out);
    }
    fputs("</ul>\n<div class=\"scroll\"><table class=\"copied\"><thead><tr><th>share of the "
          "spread of the critical outlet [%]</th><th>cone</th><th>wedge</th></tr>"
          "</thead>\n<tbody>",
          out);
    for (size_t k = 0; k < sizeof ROWS / sizeof ROWS[0]; k++) {
        double share[CLOD_HOPPER_SHAPES];
        for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
            share[s] = design->shape[CLOD_HOPPER_CELLS_SHAPES[s]].cause[ROWS[k].curve];
        }
        put_shares(out, &ROWS[k].how, share);
    }
    put_shares(out, &NO_CURVE,
               (double[]){design->shape[CLOD_HOPPER_CELLS_SHAPES[0]].untold,
                          design->shape[CLOD_HOPPER_CELLS_SHAPES[1]].untold});
    fprintf(
        out,
        "</tbody></table></div>\n<p class=\"note\">Square of Spearman's correlation, that of "
        "ranks, over the samples, of the outlet with the value of each curve at the critical "
        "state; chance alone gives about %.2g %%. The last row is what a weighted sum of their "
        "ranks does not tell. A curve without errors has no share (-): it is not known. Measure first what has the "
        "largest share.</p>\n",
        100.0 / (double)interval->samples);
}

#define DEGREES 57.295779513082323

/** Measured curves; angles are in degrees in JSON, too. */
static const struct {
    const char *of, *over;
    clod_hopper_field how;
} CURVES[CLOD_SOLID_CURVES] = {
    [CLOD_SOLID_STRENGTH] = {"f_c", "sigma_1", {"", "", "kPa", 1e-3, 1.0, 3, NULL}},
    [CLOD_SOLID_PHI_E] = {"phi_e", "sigma_1", {"", "", "deg", DEGREES, DEGREES, 2, NULL}},
    [CLOD_SOLID_PHI_T] = {"phi_t", "sigma_1", {"", "", "deg", DEGREES, DEGREES, 2, NULL}},
    [CLOD_SOLID_RHO] = {"rho_b", "sigma_1", {"", "", "kg/m3", 1.0, 1.0, 1, NULL}},
    [CLOD_SOLID_WALL] = {"tau_w", "sigma_w", {"", "", "kPa", 1e-3, 1.0, 3, NULL}},
};
static const clod_hopper_field ANGLE = {"", "", "deg", DEGREES, DEGREES, 2, NULL};

/** A row of the name that has been put. */
static void put_point(FILE *out, const clod_hopper_field *how, const clod_curve_point *point)
{
    static const clod_hopper_field STRESS = {"", "", "kPa", 1e-3, 1.0, 3, NULL};
    clod_hopper_cells_put(out, &STRESS, point->x);
    clod_hopper_cells_put(out, &STRESS, clod_cells_error(point->x_error));
    clod_hopper_cells_put(out, how, point->y);
    clod_hopper_cells_put(out, how, clod_cells_error(point->y_error));
    fputs("</tr>\n", out);
}

static void put_measured(FILE *out, const clod_hopper *design)
{
    clod_html_section(out, "measured", "What was measured");
    fputs("<div class=\"scroll\"><table class=\"copied\"><thead><tr><th>curve</th><th>stress "
          "[kPa]</th><th>error [kPa]</th><th>value</th><th>error</th></tr></thead>\n"
          "<tbody>",
          out);
    for (int c = 0; c < CLOD_SOLID_CURVES; c++) {
        const clod_curve *curve = &design->solid.curves[c];
        const clod_hopper_property *value = clod_hopper_cells_value(&design->from, c);
        if (value != NULL) {
            const double none = (double)NAN;
            const clod_hopper_field *how = c == CLOD_SOLID_WALL ? &ANGLE : &CURVES[c].how;
            begin_row(out, c == CLOD_SOLID_WALL ? "phi_w" : CLOD_HOPPER_CURVE_KEYS[c],
                      how->unit);
            put_point(
                out, how,
                &(clod_curve_point){
                    .x = none, .x_error = none, .y = value->value, .y_error = value->error});
        }
        for (size_t i = 0; i < curve->count && value == NULL; i++) {
            char name[64];
            snprintf(name, sizeof name, "%s [%s] over %s", CURVES[c].of, CURVES[c].how.unit,
                     CURVES[c].over);
            begin_row(out, name, "");
            put_point(out, &CURVES[c].how, &curve->points[i]);
        }
    }
    fputs("</tbody></table></div>\n", out);
}

/** A file that the case names: its name among the facts, or its text folded. */
static void put_file(FILE *out, const char *what, const char *path, bool folded)
{
    char *text;
    size_t length;
    clod_status none = {CLOD_OK, ""};
    if (path == NULL) {
        return;
    }
    if (!folded) {
        clod_html_fact(out, what, path);
    } else if (clod_input_read_regular(path, MOST_BYTES, &text, &length, &none)) {
        clod_html_folded(out, path, text);
        clod_memory_free(text);
    }
}

static void put_files(FILE *out, const clod_hopper *design, bool folded)
{
    const clod_hopper_case *from = &design->from;
    put_file(out, "case", design->path, folded);
    put_file(out, "flow function", from->strength.file, folded);
    for (size_t k = 0; k < from->strength.test_count; k++) {
        put_file(out, "shear test", from->strength.tests[k].points, folded);
    }
    put_file(out, "flow function after storage", from->strength.after_storage, folded);
    put_file(out, "wall friction", from->wall.file, folded);
    put_file(out, "effective friction", from->phi_e.file, folded);
    put_file(out, "static friction", from->phi_t.file, folded);
    put_file(out, "bulk density", from->rho.file, folded);
}

static void put_sources(FILE *out, const clod_hopper *design)
{
    const clod_hopper_case *from = &design->from;
    char text[160];
    clod_html_section(out, "provenance", "Where this comes from");
    fputs("<div class=\"scroll\"><table class=\"facts\">", out);
    put_files(out, design, false);
    for (size_t k = 0; k < design->override_count; k++) {
        clod_html_fact(out, "said in place of the case's value", design->overrides[k]);
    }
    clod_html_fact(out, "curve of the flow function",
                   from->strength.curve == CLOD_HOPPER_STRENGTH_LINE ? "line through all points"
                                                                     : "from point to point");
    clod_html_fact(out, "H(theta)", CLOD_HOPPER_ARCH_NAMES[from->arch]);
    snprintf(text, sizeof text, "%.3g %%, %lld samples, seed %lld",
             100.0 * from->interval.level, (long long)from->interval.samples,
             (long long)from->interval.seed);
    clod_html_fact(out, "intervals", text);
    clod_html_fact(out, "computed by", clod_version_text());
    clod_html_fact(out, "equations and their sources", "docs/theory/hopper.md");
    fputs("</table></div>\n", out);
    put_files(out, design, true);
}

void clod_hopper_numbers_put(FILE *out, const clod_hopper *design)
{
    put_numbers(out, design);
    put_causes(out, design);
    put_measured(out, design);
    put_sources(out, design);
}
