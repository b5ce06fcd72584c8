#include "clod/status.h"

#include <stdio.h>

#include "base/given.h"

bool clod_status_vfail(clod_status *status, clod_code code, const char *format, va_list args)
{
    CLOD_NEED(status);
    CLOD_NEED(format);
    status->code = code;
    vsnprintf(status->text, sizeof status->text, format, args);
    return false;
}

bool clod_status_fail(clod_status *status, clod_code code, const char *format, ...)
{
    CLOD_NEED(status);
    CLOD_NEED(format);
    va_list args;
    va_start(args, format);
    clod_status_vfail(status, code, format, args);
    va_end(args);
    return false;
}
