// Lengths of the command line of clod mesh: a unit, or a number with one.

#include <string.h>

#include "clod/mesh.h"
#include "support/check.h"

static void lengths_are_read(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double metres;
    } LENGTHS[] = {{"m", 1.0},         {"mm", 1e-3},   {"cm", 1e-2},   {"in", 0.0254},
                   {"ft", 0.3048},     {"um", 1e-6},   {"3 mm", 3e-3}, {"3mm", 3e-3},
                   {"0.5 in", 0.0127}, {"1e3 mm", 1.0}};
    for (size_t k = 0; k < sizeof LENGTHS / sizeof LENGTHS[0]; k++) {
        clod_status status = {CLOD_OK, ""};
        double metres = 0.0;
        assert_true(clod_mesh_unit(LENGTHS[k].text, &metres, &status));
        check_relative(metres, LENGTHS[k].metres, 1e-15);
    }
}

static void what_is_no_length_is_refused(void **state)
{
    (void)state;
    static const char *const WRONG[] = {"", "3", "kg", "3 kPa", "mmm", "-3 mm", "0 m", "nan m"};
    for (size_t k = 0; k < sizeof WRONG / sizeof WRONG[0]; k++) {
        clod_status status = {CLOD_OK, ""};
        double metres = 0.0;
        assert_false(clod_mesh_unit(WRONG[k], &metres, &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, ": "));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lengths_are_read),
        cmocka_unit_test(what_is_no_length_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
