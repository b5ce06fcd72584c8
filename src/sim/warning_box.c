#include "sim/warning_box.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "analysis/prose.h"

#define HEAD "\n  Warnings of the simulation\n"

void clod_warning_box_add(json_t *list, const char *format, ...)
{
    char text[600];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    json_array_append_new(list, json_string(text));
}

void clod_warning_box_put(FILE *out, const json_t *list)
{
    size_t at;
    json_t *warning;
    json_array_foreach(list, at, warning)
    {
        fputs(at == 0 ? HEAD : "", out);
        clod_prose_warning(out, json_string_value(warning));
    }
}

size_t clod_warning_box_size(const json_t *list)
{
    size_t size = sizeof HEAD;
    size_t at;
    json_t *warning;
    json_array_foreach(list, at, warning)
    {
        size += sizeof "  - \n" + json_string_length(warning);
    }
    return size;
}

void clod_warning_box_append(char *text, size_t size, const json_t *list)
{
    size_t used = strlen(text);
    size_t at;
    json_t *warning;
    json_array_foreach(list, at, warning)
    {
        used += (size_t)snprintf(text + used, size - used, "%s  - %s\n", at == 0 ? HEAD : "",
                                 json_string_value(warning));
    }
}
