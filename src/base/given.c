#include "base/given.h"

#include <stddef.h>

#include "base/assert.h"

void clod_given_need(bool given, const char *function, const char *name)
{
    if (!given) {
        clod_assert_fail_null(function, name);
    }
}

bool clod_given(bool given, const char *function, const char *name, clod_status *status)
{
    clod_given_need(status != NULL, function, "status");
    return given || clod_status_fail(status, CLOD_USAGE, "%s: %s is NULL", function, name);
}
