// What `clod --version` says. The version is that of CMakeLists.txt, the compiler's that of
// this very file, which the same compiler has seen.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "clod/version.h"

static void the_text_names_version_commit_and_compiler(void **state)
{
    (void)state;
    const char *text = clod_version_text();
    assert_memory_equal(text, "clod 0.1.0 (", strlen("clod 0.1.0 ("));
#if defined(__clang__)
    assert_non_null(strstr(text, "), Clang "));
#else
    assert_non_null(strstr(text, "), GNU " __VERSION__));
#endif
}

static void the_text_is_one_line(void **state)
{
    (void)state;
    assert_null(strchr(clod_version_text(), '\n'));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_text_names_version_commit_and_compiler),
        cmocka_unit_test(the_text_is_one_line),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
