// The outcome of a call: code and text, cut at its size.

#include <stdlib.h>
#include <string.h>

#include "clod/status.h"
#include "support/check.h"

static void a_failure_has_a_code_and_a_text(void **state)
{
    (void)state;
    clod_status status = {0};
    assert_int_equal(status.code, CLOD_OK);
    assert_false(clod_status_fail(&status, CLOD_USAGE, "line %d: %s", 7, "no unit"));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, "line 7: no unit");
    assert_false(clod_status_fail(&status, CLOD_FAILED, "disk full"));
    assert_int_equal(status.code, CLOD_FAILED);
    assert_string_equal(status.text, "disk full");
}

static void a_text_too_long_is_cut_with_its_end_in_place(void **state)
{
    (void)state;
    static clod_status status;
    static char text[2 * CLOD_STATUS_TEXT];
    memset(text, 'a', sizeof text - 1);
    assert_false(clod_status_fail(&status, CLOD_FAILED, "%s", text));
    assert_int_equal(strlen(status.text), CLOD_STATUS_TEXT - 1);
}

/** Exit statuses of the program (issue: 0, 1 failed, 2 usage). */
static void codes_are_exit_statuses(void **state)
{
    (void)state;
    assert_int_equal(CLOD_OK, 0);
    assert_int_equal(CLOD_FAILED, 1);
    assert_int_equal(CLOD_USAGE, 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_failure_has_a_code_and_a_text),
        cmocka_unit_test(a_text_too_long_is_cut_with_its_end_in_place),
        cmocka_unit_test(codes_are_exit_statuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
