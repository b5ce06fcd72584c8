// Angles of repose: their mean and its error, what a table says, and what is no angle.

#include "clod/repose_angles.h"

#include <math.h>
#include <string.h>

#include "support/check.h"

#define DEG (M_PI / 180.0)

/** 30, 32 and 34 deg: a standard deviation of 2 deg, of the mean 2 deg/sqrt(3). */
static void the_error_is_that_of_the_scatter(void **state)
{
    const clod_repose_heap heaps[] = {{30.0 * DEG, 0.0}, {34.0 * DEG, 0.0}, {32.0 * DEG, 0.0}};
    clod_repose_angles self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_repose_angles_evaluate(heaps, 3, &self, &status));
    check_relative(self.mean.value, 32.0 * DEG, 1e-12);
    check_relative(self.mean.error, 2.0 / sqrt(3.0) * DEG, 1e-12);
    check_relative(self.mean.scatter, 2.0 * DEG, 1e-12);
    assert_true(self.heap_count == 3 && self.heaps[1].angle == heaps[1].angle);
    clod_repose_angles_fini(&self);
}

/** 3 deg each make sqrt(27)/3 deg of the mean, more than the scatter; one that is not stated leaves the scatter. */
static void stated_errors_count_where_they_are_larger(void **state)
{
    clod_repose_heap heaps[] = {
        {30.0 * DEG, 3.0 * DEG}, {34.0 * DEG, 3.0 * DEG}, {32.0 * DEG, 3.0 * DEG}};
    clod_repose_angles self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_repose_angles_evaluate(heaps, 3, &self, &status));
    check_relative(self.mean.error, sqrt(3.0) * DEG, 1e-12);
    check_relative(self.mean.scatter, 2.0 * DEG, 1e-12);
    clod_repose_angles_fini(&self);
    heaps[2].error = 0.0;
    assert_true(clod_repose_angles_evaluate(heaps, 3, &self, &status));
    check_relative(self.mean.error, 2.0 / sqrt(3.0) * DEG, 1e-12);
    clod_repose_angles_fini(&self);
}

static void one_heap_has_the_error_that_it_states(void **state)
{
    clod_repose_heap heap = {33.0 * DEG, 1.5 * DEG};
    clod_repose_angles self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_repose_angles_evaluate(&heap, 1, &self, &status));
    check_relative(self.mean.error, 1.5 * DEG, 1e-12);
    assert_true(isnan(self.mean.scatter));
    clod_repose_angles_fini(&self);
    heap.error = 0.0;
    assert_true(clod_repose_angles_evaluate(&heap, 1, &self, &status));
    assert_true(isnan(self.mean.error));
    char *table = clod_repose_angles_table(&self);
    assert_non_null(strstr(table, "Angle of repose: 1 heap\n"));
    assert_non_null(strstr(table, "No error bar: it needs two heaps of different angles"));
    clod_locus_free(table);
    clod_repose_angles_fini(&self);
    assert_false(clod_repose_angles_evaluate(NULL, 0, &self, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, "A mean angle of repose needs one heap at least.");
    clod_repose_angles_fini(&self);
}

/** Laboratories round to whole degrees: heaps that agree so do not have an error of 0. */
static void one_rounded_angle_has_no_error(void **state)
{
    clod_repose_heap heaps[] = {{32.0 * DEG, 0.0}, {32.0 * DEG, 0.0}, {32.0 * DEG, 0.0}};
    clod_repose_angles self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_repose_angles_evaluate(heaps, 3, &self, &status));
    assert_true(isnan(self.mean.error));
    clod_repose_angles_fini(&self);
    for (int k = 0; k < 3; k++) {
        heaps[k].error = 0.5 * DEG; // sqrt(3) 0.5/3 of the mean
    }
    assert_true(clod_repose_angles_evaluate(heaps, 3, &self, &status));
    check_relative(self.mean.error, 0.5 / sqrt(3.0) * DEG, 1e-12);
    assert_true(self.warning[0] == '\0');
    clod_repose_angles_fini(&self);
}

static void an_error_as_large_as_its_angle_is_told(void **state)
{
    const clod_repose_heap heaps[] = {{30.0 * DEG, 29.0 * DEG}, {32.0 * DEG, 40.0 * DEG}};
    static const char WORDS[] = "angle_of_repose is 32.00 deg with a stated standard error of "
                                "40.00 deg: nothing was measured then";
    clod_repose_angles self;
    clod_status status = {0};
    (void)state;
    assert_true(clod_repose_angles_evaluate(heaps, 1, &self, &status));
    assert_true(self.warning[0] == '\0');
    clod_repose_angles_fini(&self);
    assert_true(clod_repose_angles_evaluate(heaps, 2, &self, &status));
    char *table = clod_repose_angles_table(&self);
    char *json = clod_repose_angles_json(&self);
    assert_non_null(strstr(self.warning, WORDS));
    assert_non_null(strstr(table, "  Warnings\n  - angle_of_repose is 32.00 deg"));
    assert_non_null(strstr(json, WORDS));
    clod_locus_free(table);
    clod_locus_free(json);
    clod_repose_angles_fini(&self);
}

static bool parses(const char *text, clod_repose_heap **heaps, size_t *count,
                   clod_status *status)
{
    *status = (clod_status){0};
    return clod_repose_angles_parse("lab.csv", text, strlen(text), heaps, count, status);
}

static void a_table_is_read_in_its_unit(void **state)
{
    clod_repose_heap *heaps;
    size_t count;
    clod_status status;
    (void)state;
    assert_true(
        parses("heap,angle_of_repose [deg],angle_of_repose_error [rad]\n1,30,0.02\n2,32,\n",
               &heaps, &count, &status));
    assert_int_equal(count, 2);
    check_relative(heaps[0].angle, 30.0 * DEG, 1e-12);
    check_relative(heaps[0].error, 0.02, 1e-12);
    check_relative(heaps[1].angle, 32.0 * DEG, 1e-12);
    assert_true(heaps[1].error == 0.0);
    clod_locus_free(heaps);
    // numbers of the heaps mean nothing, nor need they be numbers
    assert_true(
        parses("seed,angle_of_repose [rad],heap\n7,0.5,a\n7,0.6,\n", &heaps, &count, &status));
    assert_int_equal(count, 2);
    check_relative(heaps[1].angle, 0.6, 1e-12);
    clod_locus_free(heaps);
}

static void what_is_no_angle_is_told(void **state)
{
    static const struct {
        const char *text, *words;
    } WRONG[] = {
        {"angle_of_repose [deg]\n30\n0.55\n",
         "lab.csv:3: column angle_of_repose: 0.55 deg is below 5 deg, and no solid lies so flat; "
         "is its unit another one, [rad]?"},
        {"angle_of_repose [deg]\n95\n",
         "lab.csv:2: column angle_of_repose: \"95\" must be below 90 in the unit of the column."},
        {"angle_of_repose [deg]\n-30\n", "lab.csv:2: column angle_of_repose: \"-30\" must be"},
        {"angle_of_repose [deg]\n0\n",
         "lab.csv:2: column angle_of_repose: \"0\" must be above 0."},
        {"angle_of_repose [deg]\n\n", "lab.csv: there is no angle of repose in it."},
        {"angle_of_repose [deg],angle_of_repose_error [deg]\n30,-1\n",
         "lab.csv:2: column angle_of_repose_error: \"-1\" must be 0 or more."},
        {"seed,angle_of_repose_error [deg]\n1,2\n",
         "lab.csv:1: the header has no column angle_of_repose."},
        {"angle_of_repose [kPa]\n30\n", "kPa"},
        {"angle_of_repose\n30\n", "lab.csv:1"},
        {"angle_of_repose [deg],phi_w [deg]\n30,12\n", "phi_w"},
    };
    (void)state;
    for (size_t k = 0; k < sizeof WRONG / sizeof WRONG[0]; k++) {
        clod_repose_heap *heaps;
        size_t count;
        clod_status status;
        assert_false(parses(WRONG[k].text, &heaps, &count, &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_null(heaps);
        if (strstr(status.text, WRONG[k].words) == NULL) {
            fail_msg("%s: not in: %s", WRONG[k].words, status.text);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_error_is_that_of_the_scatter),
        cmocka_unit_test(stated_errors_count_where_they_are_larger),
        cmocka_unit_test(one_heap_has_the_error_that_it_states),
        cmocka_unit_test(one_rounded_angle_has_no_error),
        cmocka_unit_test(an_error_as_large_as_its_angle_is_told),
        cmocka_unit_test(a_table_is_read_in_its_unit),
        cmocka_unit_test(what_is_no_angle_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
