#include "base/assert.h"

#include <stdio.h>
#include <stdlib.h>

_Noreturn void clod_assert_fail(const char *condition, const char *file, int line)
{
    fprintf(stderr, "clod: bug: %s:%d: %s does not hold; please report it\n", file, line,
            condition);
    abort();
}

_Noreturn void clod_assert_fail_null(const char *function, const char *name)
{
    fprintf(stderr, "%s: %s is NULL; the calling program must give one\n", function, name);
    abort();
}
