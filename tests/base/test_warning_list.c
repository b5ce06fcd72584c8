/**
 * @file test_warning_list.c
 * A list of warnings keeps what it has room for, and says when there are more.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/warning_list.h"

static void fill(clod_warning_list *list)
{
    for (int k = 0; k < CLOD_WARNING_LIST_MOST; k++) {
        clod_warning_list_add(list, "number %d", k);
    }
}

static void full_list_has_every_warning(void **state)
{
    (void)state;
    static clod_warning_list list;
    fill(&list);
    assert_int_equal(list.count, CLOD_WARNING_LIST_MOST);
    assert_string_equal(list.text[0], "number 0");
    assert_string_equal(list.text[CLOD_WARNING_LIST_MOST - 1], "number 63");
}

static void last_of_too_many_says_that_there_are_more(void **state)
{
    (void)state;
    static clod_warning_list list;
    fill(&list);
    clod_warning_list_add(&list, "one more");
    assert_int_equal(list.count, CLOD_WARNING_LIST_MOST);
    assert_string_equal(list.text[CLOD_WARNING_LIST_MOST - 2], "number 62");
    assert_string_equal(list.text[CLOD_WARNING_LIST_MOST - 1],
                        "There are more warnings than these.");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(full_list_has_every_warning),
        cmocka_unit_test(last_of_too_many_says_that_there_are_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
