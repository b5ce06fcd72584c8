#include "duration.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** "90 s"; false: no such thing. */
static bool read_number(const char *text, double *seconds)
{
    static const struct {
        const char *name;
        double seconds;
    } UNIT[] = {{"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};
    char *end;
    const double number = strtod(text, &end);
    while (*end == ' ') {
        end++;
    }
    for (size_t k = 0; end != text && k < sizeof UNIT / sizeof *UNIT; k++) {
        if (strcmp(end, UNIT[k].name) == 0) {
            *seconds = number * UNIT[k].seconds;
            return true;
        }
    }
    return false;
}

/** "1-12:30:00"; false: no such thing. */
static bool read_clock(const char *text, double *seconds)
{
    unsigned days = 0, hours = 0, minutes = 0, rest = 0;
    int end = 0;
    if (sscanf(text, "%4u-%n", &days, &end) < 1 || end == 0) {
        days = 0;
        end = 0;
    }
    text += end;
    end = 0;
    if (sscanf(text, "%6u:%2u%n", &hours, &minutes, &end) < 2) {
        return false;
    }
    text += end;
    end = 0;
    if (*text != '\0' && (sscanf(text, ":%2u%n", &rest, &end) < 1 || text[end] != '\0')) {
        return false;
    }
    *seconds = 86400.0 * days + 3600.0 * hours + 60.0 * minutes + rest;
    return minutes < 60 && rest < 60;
}

bool clod_duration_read(const char *text, double *seconds)
{
    return (read_number(text, seconds) || read_clock(text, seconds)) && *seconds > 0.0 &&
           isfinite(*seconds);
}
