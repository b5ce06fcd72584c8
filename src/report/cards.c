#include "report/cards.h"

#include <math.h>
#include <string.h>

#include "report/html.h"
#include "report/rounded.h"
#include "report/run_kinds.h"
#include "report/shear_rows.h"
#include "report/wall_page.h"

#define MOST_OF_MEASURE 4 ///< cards of one measure: tables have them all

typedef struct card {
    const char *key, *text, *format;
    double factor;
} card;

/** Of every free run. */
static const card FREE[] = {
    {"time_s", "simulated time", "%.4g s", 1.0},
    {"grains", "grains", "%.0f", 1.0},
    {"max_overlap", "largest overlap, of a radius", "%.2g %%", 100.0},
};
/** Of a bed through which nothing streams. */
static const card BED[] = {
    {"coordination", "contacts of a grain, mean", "%.2f", 1.0},
    {"kinetic_energy_J", "kinetic energy", "%.4g J", 1.0},
};

static void put_value(FILE *out, const char *format, double value, const char *caption)
{
    char text[64];
    if (isfinite(value)) {
        snprintf(text, sizeof text, format, value);
        fputs("<div class=\"card\"><b>", out);
        clod_html_text(out, text);
        fprintf(out, "</b><span>%s</span></div>\n", caption);
    }
}

static void put_card(FILE *out, const card *of, const json_t *from)
{
    put_value(out, of->format, of->factor * clod_shear_number(from, of->key), of->text);
}

static double mass_of(const json_t *balance, const char *part)
{
    return clod_shear_number(json_object_get(balance, part), "mass_kg");
}

/** What came, went and is there, of a run with inlets or outlets. */
static void put_balance(FILE *out, const json_t *balance)
{
    double went = 0.0;
    const char *name;
    json_t *way;
    json_object_foreach(json_object_get(balance, "out"), name, way)
    {
        went += clod_shear_number(way, "mass_kg");
    }
    put_value(out, "%.4g kg", mass_of(balance, "in"), "came in");
    put_value(out, "%.4g kg", went, "went out");
    put_value(out, "%.4g kg", mass_of(balance, "inside"), "inside at the end");
    put_value(out, "%.0f", clod_shear_number(json_object_get(balance, "lost"), "grains"),
              "grains lost");
}

void clod_cards_result(FILE *out, const json_t *from, const clod_result_row *row,
                       const char *more)
{
    fputs("<div class=\"card\">", out);
    const clod_writer page = clod_writer_page(out);
    clod_result_table_value(page, "b", from, row, false);
    fputs("</b><span>", out);
    clod_writer_symbol(page, row->symbol);
    fputs(row->symbol[0] != '\0' ? ", " : "", out);
    clod_writer_words(page, row->text);
    if (more != NULL) {
        fputs(": ", out);
        clod_html_text(out, more);
    }
    fputs("</span></div>\n", out);
}

/** Results of one yield locus. */
static void put_locus(FILE *out, const json_t *locus)
{
    const bool inside = isfinite(clod_shear_number(locus, "rho_inside_kg_m3"));
    const char *const KEYS[] = {"phi_e_deg", "phi_lin_deg",
                                "c_Pa",      "sigma_c_Pa",
                                "ffc",       inside ? "rho_inside_kg_m3" : "rho_b_kg_m3"};
    for (size_t k = 0; k < sizeof KEYS / sizeof *KEYS; k++) {
        const bool class = strcmp(KEYS[k], "ffc") == 0;
        clod_cards_result(out, locus, clod_shear_row_of(KEYS[k]),
                          class ? json_string_value(json_object_get(locus, "flow")) : NULL);
    }
}

static void put_strengths(FILE *out, const json_t *strengths)
{
    size_t k;
    const json_t *one;
    json_array_foreach(strengths, k, one)
    {
        char text[128];
        snprintf(text, sizeof text, "unconfined strength after %.3f kPa: $ff_c$ %.2f",
                 1e-3 * clod_shear_number(one, "sigma_1_Pa"), clod_shear_number(one, "ffc"));
        const clod_result_row row = {"sigma_c_Pa",       text, "",   "kPa", 1e-3, 3,
                                     "sigma_c_error_Pa", NULL, false};
        clod_cards_result(out, one, &row, NULL);
    }
}

void clod_cards_shear(FILE *out, const clod_run_files *run)
{
    const json_t *study = json_object_get(run->summary, "locus");
    if (clod_shear_locus(study, 0) != NULL && clod_shear_locus(study, 1) == NULL) {
        put_locus(out, clod_shear_locus(study, 0));
    }
}

void clod_cards_uniaxial(FILE *out, const clod_run_files *run)
{
    put_strengths(out, json_object_get(run->summary, "flow_function"));
}

void clod_cards_wall(FILE *out, const clod_run_files *run)
{
    clod_wall_page_cards(out, json_object_get(run->summary, "wall_locus"));
}

/** A number of each object of a measure, with its name: "angle of repose, heap". */
static size_t put_measure(FILE *out, const json_t *measure, const clod_result_row *row)
{
    size_t count = 0;
    const char *name;
    json_t *one;
    json_object_foreach((json_t *)measure, name, one)
    {
        if (count < MOST_OF_MEASURE && isfinite(clod_result_table_number(one, row->key))) {
            clod_cards_result(out, one, row, name);
            count++;
        }
    }
    return count;
}

/** What the case was made to measure; how many cards. */
static size_t put_measures(FILE *out, const json_t *summary)
{
    static const clod_result_row ANGLE = {"angle_deg", "angle of repose", "",   "deg", 1.0,
                                          2,           "error_deg",       NULL, false};
    static const clod_result_row LACEY = {
        "lacey", "mixing index (Lacey)", "", "", 1.0, 3, NULL, NULL, false};
    static const clod_result_row FLOW = {"mass_flow_kg_per_s",
                                         "mass flow, mean and deviation",
                                         "",
                                         "kg/s",
                                         1.0,
                                         CLOD_ROUNDED_SHORT,
                                         NULL,
                                         NULL,
                                         false};
    static const clod_result_row THROUGH = {"flow_through_kg_per_s",
                                            "flow through the plane, mean and deviation",
                                            "",
                                            "kg/s",
                                            1.0,
                                            CLOD_ROUNDED_SHORT,
                                            NULL,
                                            NULL,
                                            false};
    return put_measure(out, json_object_get(summary, "repose"), &ANGLE) +
           put_measure(out, json_object_get(summary, "mixing"), &LACEY) +
           put_measure(out, json_object_get(summary, "gauges"), &FLOW) +
           put_measure(out, json_object_get(summary, "gauges"), &THROUGH);
}

void clod_cards_free(FILE *out, const clod_run_files *run)
{
    const size_t measures = put_measures(out, run->summary);
    for (size_t k = 0; k < sizeof FREE / sizeof *FREE; k++) {
        put_card(out, &FREE[k], run->summary);
    }
    const json_t *balance = json_object_get(run->summary, "balance");
    if (balance != NULL && (json_object_get(run->summary, "inlets") != NULL ||
                            json_object_get(run->summary, "outlets") != NULL)) {
        put_balance(out, balance);
        return;
    }
    const size_t beds = sizeof BED / sizeof *BED;
    for (size_t k = 0; k < (measures > 0 ? 1 : beds);
         k++) { // kinetic energy where nothing was asked for
        put_card(out, &BED[k], run->summary);
    }
}

void clod_cards_put(FILE *out, const clod_run_files *run)
{
    fputs("<div class=\"cards\">\n", out);
    run->kind->cards(out, run);
    fputs("</div>\n", out);
}
