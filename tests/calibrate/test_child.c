// Processes of clod calibrate that do not end as they should.

#include <signal.h>
#include <string.h>
#include <time.h>

#include "calibrate/child.h"
#include "support/check.h"

static int wait_for(clod_child *child)
{
    int result = 0;
    for (int naps = 0; !clod_child_ended(child, &result); naps++) {
        const struct timespec time = {0, 10000000};
        assert_true(naps < 1000);
        nanosleep(&time, NULL);
    }
    assert_int_equal(child->process, 0);
    return result;
}

static void program_that_is_not_there_is_told(void **state)
{
    (void)state;
    char *arguments[] = {(char *)"/none/clod", NULL};
    clod_child child = {0};
    clod_status status = {CLOD_OK, ""};
    assert_false(clod_child_start(&child, arguments, "/dev/null", &status));
    assert_int_equal(status.code, CLOD_FAILED);
    assert_non_null(strstr(status.text, "/none/clod: No such file or directory"));
    assert_int_equal(child.process, 0);
}

static void end_that_nobody_tells_is_an_end(void **state)
{
    (void)state;
    char *arguments[] = {(char *)"/bin/true", NULL};
    clod_child child = {0};
    clod_status status = {CLOD_OK, ""};
    signal(SIGCHLD, SIG_IGN);
    assert_true(clod_child_start(&child, arguments, "/dev/null", &status));
    assert_int_equal(wait_for(&child), CLOD_CHILD_LOST);
    signal(SIGCHLD, SIG_DFL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(program_that_is_not_there_is_told),
        cmocka_unit_test(end_that_nobody_tells_is_an_end),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
