// CSV files of a results folder, read; columns sorted into groups.

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "report/series_groups.h"
#include "report/table.h"

static void columns_units_and_cells_are_told_apart(void **state)
{
    (void)state;
    static const char TEXT[] = "time [s],feed.power [W],count\n0.5,nan,all\n1,-2e3,\n2,3";
    clod_table table;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_table_parse(&table, "t.csv", TEXT, strlen(TEXT), &status));
    assert_int_equal(table.columns, 3);
    assert_int_equal(table.rows, 2); // the last line is not complete
    assert_string_equal(table.names[1], "feed.power");
    assert_string_equal(table.units[1], "W");
    assert_string_equal(table.units[2], "");
    assert_string_equal(table.cells[2], "all");
    assert_string_equal(table.cells[5], "");
    assert_int_equal(clod_table_find(&table, "count"), 2);
    assert_int_equal(clod_table_find(&table, "speed"), -1);
    double *power = clod_table_numbers(&table, 1);
    double *count = clod_table_numbers(&table, 2);
    assert_true(isnan(power[0]) && power[1] == -2000.0);
    assert_true(isnan(count[0]) && isnan(count[1]));
    clod_memory_free(power);
    clod_memory_free(count);
    clod_table_fini(&table);
}

static void rows_of_another_length_are_refused(void **state)
{
    (void)state;
    static const char *const TEXTS[] = {"a,b\n1,2\n3\n", "a,b\n1,2\n3,4,5\n"};
    for (int k = 0; k < 2; k++) {
        clod_table table;
        clod_status status = {CLOD_OK, ""};
        assert_false(clod_table_parse(&table, "t.csv", TEXTS[k], strlen(TEXTS[k]), &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, "t.csv:3: "));
        clod_table_fini(&table);
    }
}

static void a_file_that_is_not_there_is_empty(void **state)
{
    (void)state;
    clod_table table;
    clod_status status = {CLOD_OK, ""};
    assert_true(clod_table_read(&table, "/nowhere", "t.csv", &status));
    assert_int_equal(table.rows + table.columns, 0);
    clod_table_fini(&table);
}

static void columns_of_one_quantity_make_a_group(void **state)
{
    (void)state;
    static const char TEXT[] =
        "time [s],a.power [W],speed [m/s],b_c.power [W],d.power [kW],e.power [W]\n"
        "0,1,1,1,1,5\n1,2,2,2,2,5\n";
    clod_table table;
    clod_series_groups groups;
    clod_status status = {CLOD_OK, ""};
    char words[CLOD_FIGURE_NAME];
    assert_true(clod_table_parse(&table, "t.csv", TEXT, strlen(TEXT), &status));
    assert_true(clod_series_groups_make(&groups, &table));
    assert_int_equal(groups.count, 3); // time is none, and e.power never changes
    assert_string_equal(groups.group[0].quantity, "power");
    assert_int_equal(groups.group[0].count, 2);
    assert_int_equal(groups.group[0].column[0], 1);
    assert_int_equal(groups.group[0].column[1], 3);
    assert_string_equal(groups.group[1].quantity, "speed");
    assert_string_equal(groups.group[2].unit, "kW");
    clod_series_groups_object(table.names[3], words);
    assert_string_equal(words, "b c");
    char title[CLOD_SERIES_GROUPS_TITLE];
    clod_series_groups_title(clod_series_groups_quantity("gauge_lip.mass_flow"), "gauge lip",
                             title);
    assert_string_equal(title, "Mass flow: gauge lip");
    clod_series_groups_title(clod_series_groups_quantity("max_speed"), "", title);
    assert_string_equal(title, "Max speed");
    clod_series_groups_object("speed", words);
    assert_string_equal(words, "");
    clod_series_groups_whose(&groups.group[0], &table, words); // of walls that have no kind
    assert_string_equal(words, "");
    clod_series_groups_fini(&groups);
    clod_table_fini(&table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_units_and_cells_are_told_apart),
        cmocka_unit_test(rows_of_another_length_are_refused),
        cmocka_unit_test(a_file_that_is_not_there_is_empty),
        cmocka_unit_test(columns_of_one_quantity_make_a_group),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
