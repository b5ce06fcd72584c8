#include "analysis/prose.h"

#include <math.h>
#include <string.h>

void clod_prose_number(FILE *out, int width, int digits, double value)
{
    if (isfinite(value)) {
        fprintf(out, "%*.*f", width, digits, value);
    } else {
        fprintf(out, "%*s", width, "-");
    }
}

void clod_prose_warning(FILE *out, const char *text)
{
    const size_t width = 88;
    fputs("  - ", out);
    while (strlen(text) > width) {
        size_t end = width;
        while (end > 0 && text[end] != ' ') {
            end--;
        }
        end = end == 0 ? width : end;
        fprintf(out, "%.*s\n    ", (int)end, text);
        text += end + (text[end] == ' ' ? 1 : 0);
    }
    fprintf(out, "%s\n", text);
}
