#include "base/warning_list.h"

#include <stdarg.h>
#include <stdio.h>

void clod_warning_list_add(clod_warning_list *self, const char *format, ...)
{
    if (self->count == CLOD_WARNING_LIST_MOST) {
        snprintf(self->text[CLOD_WARNING_LIST_MOST - 1], CLOD_WARNING_LIST_TEXT,
                 "There are more warnings than these.");
        return;
    }
    va_list args;
    va_start(args, format);
    vsnprintf(self->text[self->count++], CLOD_WARNING_LIST_TEXT, format, args);
    va_end(args);
}
