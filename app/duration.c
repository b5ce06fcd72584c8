#include "duration.h"

#include <math.h>
#include <stddef.h>
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

/** A whole number of at most six digits and the mark behind it, 0 at the end; false: no such thing. */
static bool read_field(const char **text, double *number, char *mark)
{
    const size_t digits = strspn(*text, "0123456789");
    if (digits == 0 || digits > 6) {
        return false;
    }
    *number = (double)strtoul(*text, NULL, 10);
    *mark = (*text)[digits];
    *text += digits + (*mark != '\0');
    return true;
}

/** "12:30:00", "30:00" or "1-12:30:00"; false: no such thing. */
static bool read_clock(const char *text, double *seconds)
{
    double field[3] = {0.0}; // hours, minutes, seconds behind days; else the last is seconds
    double days = 0.0, number;
    char mark;
    int count = 0;
    bool has_days = false;
    do {
        if (count == 3 || !read_field(&text, &number, &mark)) {
            return false;
        }
        if (mark == '-' && count == 0 && !has_days) {
            days = number;
            has_days = true;
        } else if (mark == ':' || mark == '\0') {
            field[count++] = number;
        } else {
            return false;
        }
    } while (mark != '\0');
    if (!has_days && count < 3) { // minutes:seconds; a single number has no unit
        field[2] = field[1];
        field[1] = field[0];
        field[0] = 0.0;
    }
    *seconds = 86400.0 * days + 3600.0 * field[0] + 60.0 * field[1] + field[2];
    const bool long_minutes = !has_days && count == 2;
    return (has_days || count > 1) && (field[1] < 60.0 || long_minutes) && field[2] < 60.0;
}

bool clod_duration_read(const char *text, double *seconds)
{
    return (read_number(text, seconds) || read_clock(text, seconds)) && *seconds > 0.0 &&
           isfinite(*seconds);
}
