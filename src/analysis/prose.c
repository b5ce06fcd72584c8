#include "analysis/prose.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void clod_prose_number(FILE *out, int width, int digits, double value)
{
    if (isfinite(value)) {
        fprintf(out, "%*.*f", width, digits, value);
    } else {
        fprintf(out, "%*s", width, "-");
    }
}

void clod_prose_error(FILE *out, int width, int digits, double value)
{
    const double least = pow(10.0, -digits);
    if (value > 0.0 && value < 0.5 * least) {
        char text[32];
        snprintf(text, sizeof text, "<%.*f", digits, least);
        fprintf(out, "%*s", width, text);
    } else {
        clod_prose_number(out, width, digits, value);
    }
}

/** Worth of the last of four digits of a value; 0: it has none. */
static double last_digit(double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.3e", value); // rounded as "%.4g" rounds it
    const char *power = strchr(text, 'e');
    return value != 0.0 && power != NULL ? pow(10.0, (double)strtol(power + 1, NULL, 10) - 3.0)
                                         : 0.0;
}

const char *clod_prose_deviation(char text[32], double value, double deviation)
{
    const double least = last_digit(value);
    text[0] = '\0';
    if (deviation > 0.0 && deviation < 0.5 * least) {
        snprintf(text, 32, " +- <%g", least);
    } else if (isfinite(deviation)) {
        snprintf(text, 32, " +- %.2g", deviation);
    }
    return text;
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
