// Parts of a summary as tables: components of vectors and tensors are rows with names of their own.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "base/text.h"
#include "report/summary_tables.h"

#define NOTE "&plusmn; what it is"

/** The table of objects given as JSON, with a note about what is behind +-. */
static char *table_of(const char *objects)
{
    json_t *from = json_loads(objects, 0, NULL);
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(from);
    assert_non_null(out);
    clod_summary_tables_put(out, NULL, NOTE, from);
    json_decref(from);
    return clod_text_close(&text);
}

/** By hand: a row for each component with its own deviation, the unit of the key, and axes of the object. */
static void components_are_rows(void **state)
{
    (void)state;
    static const char *const ROWS[] = {
        "<tr><th>velocity x [m/s]</th><td title=\"0.5 &plusmn; 0.25 m/s\">0.50 <small>",
        "<tr><th>velocity y [m/s]</th><td title=\"-2 m/s\">-2</td></tr>",
        "<tr><th>velocity z [m/s]</th><td></td></tr>",
        "<tr><th>stress xx [Pa]</th><td title=\"1 &plusmn; 0.1 Pa\">",
        "<tr><th>stress xy [Pa]</th><td title=\"2 &plusmn; 0.2 Pa\">",
        "<tr><th>stress xz [Pa]</th><td title=\"3 &plusmn; 0.3 Pa\">",
        "<tr><th>stress yx [Pa]</th><td title=\"4 &plusmn; 0.4 Pa\">",
        "<tr><th>stress yy [Pa]</th><td title=\"5 &plusmn; 0.5 Pa\">",
        "<tr><th>stress yz [Pa]</th><td title=\"6 &plusmn; 0.6 Pa\">",
        "<tr><th>stress zx [Pa]</th><td title=\"7 &plusmn; 0.7 Pa\">",
        "<tr><th>stress zy [Pa]</th><td title=\"8 &plusmn; 0.8 Pa\">",
        "<tr><th>stress zz [Pa]</th><td title=\"9 &plusmn; 0.9 Pa\">"};
    char *text = table_of("{\"bed\": {\"velocity_m_per_s\": {\"mean\": [0.5, -2, null], "
                          "\"deviation\": [0.25, null, null]}, \"stress_Pa\": {\"mean\": "
                          "[1, 2, 3, 4, 5, 6, 7, 8, 9], \"deviation\": [0.1, 0.2, 0.3, 0.4, "
                          "0.5, 0.6, 0.7, 0.8, 0.9]}}}");
    const char *at = text;
    for (size_t k = 0; k < sizeof ROWS / sizeof *ROWS; k++) {
        at = strstr(at, ROWS[k]); // in this order
        assert_non_null(at);
    }
    clod_memory_free(text);
}

/** By hand: those along z have one row for objects of both kinds, the others one for each kind. */
static void objects_along_other_axes_have_rows_of_their_own(void **state)
{
    (void)state;
    char *text = table_of("[{\"name\": \"box\", \"force_N\": {\"mean\": [1, 2, 3], "
                          "\"deviation\": [0, 0, 0]}}, {\"name\": \"ring\", \"components\": "
                          "\"cylindrical\", \"force_N\": {\"mean\": [4, 5, 6], "
                          "\"deviation\": [0, 0, 0]}}]");
    assert_non_null(strstr(text, "<thead><tr><th></th><th>box</th><th>ring</th></tr></thead>"));
    assert_non_null(strstr(
        text, "<tr><th>force x [N]</th><td title=\"1 N\">1</td><td></td></tr>\n"
              "<tr><th>force y [N]</th><td title=\"2 N\">2</td><td></td></tr>\n"
              "<tr><th>force z [N]</th><td title=\"3 N\">3</td><td title=\"6 N\">6</td></tr>\n"
              "<tr><th>force r [N]</th><td></td><td title=\"4 N\">4</td></tr>\n"
              "<tr><th>force t [N]</th><td></td><td title=\"5 N\">5</td></tr>\n</tbody>"));
    assert_null(strstr(text, "components"));
    clod_memory_free(text);
}

/** Lists of other lengths, and means without deviations, have no rows. */
static void other_lists_are_left_out(void **state)
{
    (void)state;
    char *text = table_of("{\"a\": {\"grains\": 3, \"four\": {\"mean\": [1, 2, 3, 4], "
                          "\"deviation\": [1, 2, 3, 4]}, \"bare\": {\"mean\": [1, 2, 3]}}}");
    assert_non_null(strstr(text, "grains"));
    assert_null(strstr(text, "four"));
    assert_null(strstr(text, "bare"));
    clod_memory_free(text);
}

/** A table says what is behind +- where it has one. */
static void a_note_stands_below_errors(void **state)
{
    (void)state;
    static const struct {
        const char *objects;
        bool noted;
    } CASES[] = {
        {"{\"lip\": {\"mass_flow_kg_per_s\": {\"mean\": 2, \"deviation\": 0.1}}}", true},
        {"{\"heap\": {\"angle_deg\": 28, \"error_deg\": 0.9}}", true},
        {"{\"bed\": {\"v_m_per_s\": {\"mean\": [1, 2, 3], \"deviation\": [0, 0, 1]}}}", true},
        {"{\"lip\": {\"mass_flow_kg_per_s\": {\"mean\": 2, \"deviation\": 0}}}", false},
        {"{\"lip\": {\"grains\": 3}}", false}};
    for (size_t k = 0; k < sizeof CASES / sizeof *CASES; k++) {
        char *text = table_of(CASES[k].objects);
        assert_int_equal(strstr(text, "<p class=\"note\">" NOTE "</p>") != NULL,
                         CASES[k].noted);
        clod_memory_free(text);
    }
}

static void add_line(void *context, const clod_summary_cell *cell)
{
    fprintf(context, "%s %s%s", cell->of, cell->key, cell->axes);
    if (cell->words != NULL) {
        fprintf(context, " %s\n", cell->words);
    } else {
        fprintf(context, cell->error > 0.0 ? " %g %g\n" : " %g\n", cell->value, cell->error);
    }
}

/** By hand: numbers with what is behind +-, texts, components of vectors and of means of vectors, and none of what is missing. */
static void every_cell_is_told(void **state)
{
    (void)state;
    json_t *from = json_loads(
        "{\"a_b\": {\"flow_kg_per_s\": {\"mean\": 2, \"deviation\": 0.5}, \"blocked\": false, \"by\": "
        "\"number\", \"none\": null, \"force_N\": [1, 2, 3], \"v\": {\"mean\": [4, 5, null], "
        "\"deviation\": [1, null, null]}}, \"c\": {\"mean_s\": 3, \"deviation_s\": 0.25}}",
        0, NULL);
    clod_text text;
    FILE *out = clod_text_open(&text);
    assert_non_null(from);
    assert_non_null(out);
    assert_true(clod_summary_tables_each(from, out, add_line));
    char *told = clod_text_close(&text);
    assert_string_equal(told, "a b flow_kg_per_s 2 0.5\na b blocked no\na b by number\n"
                              "a b force_Nx 1\na b force_Ny 2\na b force_Nz 3\n"
                              "a b vx 4 1\na b vy 5\nc mean_s 3 0.25\n");
    clod_memory_free(told);
    json_decref(from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_are_rows),
        cmocka_unit_test(objects_along_other_axes_have_rows_of_their_own),
        cmocka_unit_test(other_lists_are_left_out),
        cmocka_unit_test(a_note_stands_below_errors),
        cmocka_unit_test(every_cell_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
