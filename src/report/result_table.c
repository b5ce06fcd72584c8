#include "report/result_table.h"

#include <math.h>
#include <string.h>

#include "report/rounded.h"
#include "report/summary_tables.h"

double clod_result_table_number(const json_t *object, const char *key)
{
    const json_t *value = json_object_get(object, key);
    if (json_is_object(value)) {
        const json_t *mean = json_object_get(value, "mean"); // of a gauge
        value = mean != NULL ? mean : json_object_get(value, "value");
    }
    return json_is_number(value) ? json_number_value(value) : (double)NAN;
}

static double error_of(const json_t *from, const clod_result_row *row)
{
    const json_t *object = json_object_get(from, row->key);
    const bool spread = json_object_get(object, "deviation") != NULL;
    const double own = clod_result_table_number(object, spread ? "deviation" : "error");
    return isnan(own) && row->error != NULL ? clod_result_table_number(from, row->error) : own;
}

/** How far the simulation is off a measured number, where that is told. */
static void put_off(clod_writer out, const json_t *object)
{
    const double off = 100.0 * clod_result_table_number(object, "off");
    const double error = 100.0 * clod_result_table_number(object, "off_error");
    if (isfinite(off)) {
        clod_writer_mark(out, " <small class=\"off\">(simulation ", " (simulation ");
        clod_writer_text(out, off > 0.0 ? "+" : "");
        clod_rounded_put(out, off, error, (double)NAN, 1, "%");
        clod_writer_mark(out, ")</small>", ")");
    }
}

void clod_result_table_value(clod_writer out, const char *tag, const json_t *from,
                             const clod_result_row *row, bool all)
{
    const json_t *object = json_object_get(from, row->key);
    const double value = clod_result_table_number(from, row->key);
    const double error = error_of(from, row);
    const double scatter = all ? clod_result_table_number(object, "scatter") : (double)NAN;
    if (row->words) {
        fprintf(out.page, "<%s>", tag);
        clod_writer_text(out, json_string_value(object));
        return;
    }
    char name[CLOD_FIGURE_NAME], unit[16];
    clod_summary_tables_name(row->key, name, unit);
    clod_rounded_begin(out.page, tag, value, error, unit);
    if (!isfinite(value)) {
        clod_writer_text(out, row->missing != NULL ? row->missing : "undefined");
        return;
    }
    clod_rounded_put(out, row->factor * value, row->factor * error, row->factor * scatter,
                     row->digits, all ? "" : row->unit);
    const double known = clod_result_table_number(object, "n"),
                 all_of = clod_result_table_number(from, "n");
    if (known < all_of) {
        char count[48];
        snprintf(count, sizeof count, "(n %.0f)", known);
        clod_writer_mark(out, " <small>", " ");
        clod_writer_text(out, count);
        clod_writer_mark(out, "</small>", "");
    }
    put_off(out, object);
}

static void put_cell(clod_writer out, const clod_result_of *of, const clod_result_row *row)
{
    clod_result_table_value(out, "td", of->from, row, true);
    clod_writer_mark(out, "</td>", "\t");
}

/** Whether a row is worth its place: some have the number, or what is missing is said. */
static bool has_place(const clod_result_row *row, const clod_result_of *of, size_t count)
{
    bool told = row->words || row->missing == NULL || row->missing[0] != '\0';
    for (size_t s = 0; s < count && !told; s++) {
        told = isfinite(clod_result_table_number(of[s].from, row->key));
    }
    return told;
}

/** Write whose numbers they are; several of one name are told apart by the stress of preshear or consolidation. */
static void put_name(clod_writer out, const clod_result_of *of, size_t count, size_t s)
{
    static const char *const STRESSES[] = {"sigma_p_Pa", "consolidation_stress_Pa",
                                           "sigma_1_Pa"};
    double stress = (double)NAN;
    for (size_t k = 0; k < sizeof STRESSES / sizeof *STRESSES && isnan(stress); k++) {
        stress = clod_result_table_number(of[s].from, STRESSES[k]);
    }
    size_t alike = 0;
    for (size_t k = 0; k < count; k++) {
        alike += strcmp(of[k].name, of[s].name) == 0;
    }
    clod_writer_mark(out, "<th>", "");
    clod_writer_text(out, of[s].name);
    if (alike > 1 && isfinite(stress)) {
        char text[48];
        snprintf(text, sizeof text, "%.4g", 1e-3 * stress);
        clod_writer_text(out, ", ");
        clod_writer_text(out, text);
        clod_writer_mark(out, "&nbsp;kPa", " kPa");
    }
    clod_writer_mark(out, "</th>", "\t");
}

/** Write " [unit]", where there is one. */
static void put_unit(clod_writer out, const char *unit, bool small)
{
    if (unit[0] != '\0') {
        clod_writer_mark(out, small ? " <small>[" : " [", " [");
        clod_writer_text(out, unit);
        clod_writer_mark(out, small ? "]</small>" : "]", "]");
    }
}

/** Those of whom it is are columns, as on the page of one run. */
static void put_columns(clod_writer out, const clod_result_row *rows, size_t row_count,
                        const clod_result_of *of, size_t count)
{
    bool symbols = false;
    for (size_t k = 0; k < row_count; k++) {
        symbols = symbols || rows[k].symbol[0] != '\0';
    }
    fprintf(out.page, "<div class=\"scroll\"><table class=\"results%s\"><thead><tr>",
            symbols ? " symbols" : "");
    clod_writer_cell(out, "th", "quantity");
    if (symbols) {
        clod_writer_cell(out, "th", "");
    }
    for (size_t s = 0; s < count; s++) {
        put_name(out, of, count, s);
    }
    clod_writer_mark(out, "</tr></thead>\n<tbody>", "\n");
    for (size_t k = 0; k < row_count; k++) {
        if (!has_place(&rows[k], of, count)) {
            continue;
        }
        clod_writer_mark(out, "<tr><th>", "");
        clod_writer_words(out, rows[k].text);
        put_unit(out, rows[k].unit, false);
        clod_writer_mark(out, "</th>", "\t");
        if (symbols) {
            clod_writer_mark(out, "<td>", "");
            clod_writer_symbol(out, rows[k].symbol);
            clod_writer_mark(out, "</td>", "\t");
        }
        for (size_t s = 0; s < count; s++) {
            put_cell(out, &of[s], &rows[k]);
        }
        clod_writer_mark(out, "</tr>\n", "\n");
    }
    clod_writer_mark(out, "</tbody></table></div>\n", "\f");
}

/** A row for each: for more of them than a page is wide. */
static void put_rows(clod_writer out, const clod_result_row *rows, size_t row_count,
                     const clod_result_of *of, size_t count)
{
    fputs("<div class=\"scroll\"><table class=\"copied tight\"><thead><tr>", out.page);
    clod_writer_cell(out, "th", "run");
    for (size_t k = 0; k < row_count; k++) {
        if (!has_place(&rows[k], of, count)) {
            continue;
        }
        const bool symbol = rows[k].symbol[0] != '\0';
        const bool title = symbol && strchr(rows[k].text, '$') == NULL;
        fprintf(out.page, title ? "<th title=\"%s\">" : "<th>", rows[k].text);
        (symbol ? clod_writer_symbol : clod_writer_words)(out, symbol ? rows[k].symbol
                                                                      : rows[k].text);
        put_unit(out, rows[k].unit, true);
        clod_writer_mark(out, "</th>", "\t");
    }
    clod_writer_mark(out, "</tr></thead>\n<tbody>", "\n");
    for (size_t s = 0; s < count; s++) {
        clod_writer_mark(out, of[s].mean ? "<tr class=\"mean\">" : "<tr>", "");
        put_name(out, of, count, s);
        for (size_t k = 0; k < row_count; k++) {
            if (has_place(&rows[k], of, count)) {
                put_cell(out, &of[s], &rows[k]);
            }
        }
        clod_writer_mark(out, "</tr>\n", "\n");
    }
    clod_writer_mark(out, "</tbody></table></div>\n", "\f");
}

void clod_result_table_put(clod_writer out, const clod_result_row *rows, size_t row_count,
                           const clod_result_of *of, size_t count)
{
    if (count > CLOD_RESULT_COLUMNS && row_count <= CLOD_RESULT_NUMBERS) {
        put_rows(out, rows, row_count, of, count);
        return;
    }
    for (size_t s = 0; s < count; s += CLOD_RESULT_COLUMNS) {
        const size_t left = count - s;
        put_columns(out, rows, row_count, &of[s],
                    left < CLOD_RESULT_COLUMNS ? left : CLOD_RESULT_COLUMNS);
    }
}
