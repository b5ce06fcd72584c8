#include "picture/axis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define OUTER 0.005 ///< share of the values at either end that may lie outside
#define FAR 0.1     ///< by less than this part of the range they are within

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a;
    const double y = *(const double *)b;
    return (x > y) - (x < y);
}

double clod_axis_round_down(double x)
{
    const double decade = pow(10.0, floor(log10(x)));
    const double part = x / decade * (1.0 + 1e-9);
    return decade * (part >= 10.0 ? 10.0 : part >= 5.0 ? 5.0 : part >= 2.0 ? 2.0 : 1.0);
}

/** Distance of ticks over a range. */
static double tick_step(double min, double max)
{
    return clod_axis_round_down((max - min) / 4.0);
}

void clod_axis_range(double *value, size_t count, double *min, double *max)
{
    *min = 0.0;
    *max = 1.0;
    if (count == 0) {
        return;
    }
    qsort(value, count, sizeof *value, compare);
    const size_t outer = (size_t)(OUTER * (double)count);
    double low = value[outer];
    double high = value[count - 1 - outer];
    const double room = FAR * (high - low);
    low = value[0] >= low - room ? value[0] : low;
    high = value[count - 1] <= high + room ? value[count - 1] : high;
    if (low >= 0.0 && low < 0.25 * high) {
        low = 0.0;
    } else if (low < 0.0 && high > 0.0 && -low > 0.1 * high && high > -0.1 * low) {
        high = fmax(high, -low);
        low = -high;
    }
    if (!(high > low)) { // one value: a range about it
        high = low + (low != 0.0 ? 0.1 * fabs(low) : 1.0);
        low -= 0.1 * fabs(low);
    }
    const double step = 0.5 * tick_step(low, high);
    *min = step * floor(low / step + 1e-6);
    *max = step * ceil(high / step - 1e-6);
}

/** "m s-1" as "m/s": what has a negative power goes behind a stroke. */
static void write_units(const char *units, char text[48])
{
    char above[48] = "", below[48] = "", copy[48];
    snprintf(copy, sizeof copy, "%s", units);
    char *rest = NULL;
    for (char *word = strtok_r(copy, " ", &rest); word != NULL;
         word = strtok_r(NULL, " ", &rest)) {
        char *power = strpbrk(word, "-0123456789");
        const bool negative = power != NULL && *power == '-';
        const char *digits = power == NULL ? "" : power + (negative ? 1 : 0);
        char *list = negative ? below : above;
        const size_t used = strlen(list);
        const int letters = power == NULL ? (int)strlen(word) : (int)(power - word);
        if (letters > 0) { // a plain 1 is no unit
            snprintf(list + used, sizeof above - used, "%s%.*s%s", used > 0 ? " " : "", letters,
                     word, strcmp(digits, "1") == 0 ? "" : digits);
        }
    }
    const bool whole = below[0] == '\0';
    snprintf(text, 48, "%s%s%s", above[0] == '\0' && !whole ? "1" : above, whole ? "" : "/",
             below);
}

/** The factor 10^(3k) by which a range reads well, and the unit that goes with it. */
static double choose_prefix(double most, const char *units, char text[64])
{
    static const struct {
        double factor;
        const char *prefix, *of_kg;
    } PREFIXES[] = {{1e9, "G", "10^9 kg"},  {1e6, "M", "10^6 kg"}, {1e3, "k", "t"},
                    {1.0, "", "kg"},        {1e-3, "m", "g"},      {1e-6, "\u00b5", "mg"},
                    {1e-9, "n", "\u00b5g"}, {1e-12, "p", "ng"}};
    char plain[48];
    write_units(units, plain);
    snprintf(text, 64, "%s", plain);
    const bool mass = strcmp(plain, "kg") == 0;
    const bool takes_prefix =
        mass || strcmp(plain, "m") == 0 || strcmp(plain, "s") == 0 || strcmp(plain, "N") == 0 ||
        strcmp(plain, "J") == 0 || strcmp(plain, "W") == 0 || strcmp(plain, "Pa") == 0 ||
        strcmp(plain, "N m") == 0 || strcmp(plain, "m/s") == 0 || strcmp(plain, "m/s2") == 0;
    if (most == 0.0 || (most >= 0.1 && most < 10000.0)) {
        return 1.0;
    }
    const int last = (int)(sizeof PREFIXES / sizeof PREFIXES[0]) - 1;
    int k = 0;
    while (k < last && most < PREFIXES[k].factor) {
        k++;
    }
    if (takes_prefix) {
        snprintf(text, 64, "%s%s", mass ? PREFIXES[k].of_kg : PREFIXES[k].prefix,
                 mass ? "" : plain);
        return PREFIXES[k].factor;
    }
    if (most >= 0.01 && most < 1e6) {
        return 1.0;
    }
    const int power = 3 * (int)floor(log10(most) / 3.0);
    snprintf(text, 64, "10^%d%s%s", power, plain[0] != '\0' ? " " : "", plain);
    return pow(10.0, power);
}

void clod_axis_make(clod_axis *self, double min, double max, const char *title,
                    const char *units)
{
    *self = (clod_axis){.min = min, .max = max};
    char unit[64];
    const double factor = choose_prefix(fmax(fabs(min), fabs(max)), units, unit);
    snprintf(self->title, sizeof self->title, unit[0] != '\0' ? "%s [%s]" : "%s", title, unit);
    const double low = min / factor;
    const double high = max / factor;
    const double step = tick_step(low, high);
    const int digits = (int)fmax(0.0, ceil(-log10(step) - 1e-9));
    for (double k = ceil(low / step - 1e-6);
         k * step <= high + 1e-6 * step && self->tick_count < CLOD_AXIS_TICKS; k += 1.0) {
        const double number = k * step;
        self->tick[self->tick_count] = number * factor;
        snprintf(self->text[self->tick_count++], sizeof self->text[0], "%.*f",
                 digits < 12 ? digits : 12, number == 0.0 ? 0.0 : number);
    }
}

void clod_axis_length_text(double length, char text[32])
{
    if (length >= 1.0) {
        snprintf(text, 32, "%.10g m", length);
    } else if (length >= 1e-3) {
        snprintf(text, 32, "%.10g mm", 1e3 * length);
    } else {
        snprintf(text, 32, "%.10g \u00b5m", 1e6 * length);
    }
}
