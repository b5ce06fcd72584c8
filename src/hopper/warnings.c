#include "hopper/warnings.h"

#include <stdarg.h>
#include <stdio.h>

void clod_hopper_warn(clod_hopper_warnings *self, const char *format, ...)
{
    if (self->count == CLOD_HOPPER_WARNINGS) {
        snprintf(self->text[CLOD_HOPPER_WARNINGS - 1], CLOD_HOPPER_WARNING_TEXT,
                 "There are more warnings than these.");
        return;
    }
    va_list args;
    va_start(args, format);
    vsnprintf(self->text[self->count++], CLOD_HOPPER_WARNING_TEXT, format, args);
    va_end(args);
}
