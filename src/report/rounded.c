#include "report/rounded.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "report/figure_json.h"
#include "report/html.h"

#define MOST_DIGITS 5 ///< behind the point
#define LEAST 1e-6    ///< of the value: an error below is none
#define MOST_PLACES 6 ///< of a value whose error is far smaller
#define MOST_ZEROS 3  ///< before the first digit of a number below 1, as in 0.0012

/** Power of ten of the first digit, after rounding to so many. */
static int power_of(double number, int digits)
{
    char text[48];
    snprintf(text, sizeof text, "%.*e", digits - 1, fabs(number));
    const char *at = text;
    while (*at != 'e') {
        at++;
    }
    return (int)strtol(at + 1, NULL, 10);
}

/** Whether there is an error that a reader would look at. */
static bool is_known(double value, double error)
{
    return isfinite(error) && error > 0.0 && !(error < LEAST * fabs(value));
}

clod_rounded clod_rounded_of(double value, double error, int digits)
{
    clod_rounded how = {.digits = digits};
    if (!isfinite(value) || !is_known(value, error)) {
        return how;
    }
    how.digits = 1 - power_of(error, 2);
    const double larger = fmax(fabs(value), error);
    const int first = power_of(larger, MOST_PLACES);
    how.digits = how.digits > MOST_PLACES - 1 - first ? MOST_PLACES - 1 - first : how.digits;
    if ((how.digits > MOST_DIGITS && first < -MOST_ZEROS) || how.digits < -MOST_DIGITS) {
        how.power = first;
        how.digits += first;
    }
    return how;
}

void clod_rounded_text(char text[48], clod_rounded how, double number)
{
    const double scaled = number / pow(10.0, how.power);
    const double unit = pow(10.0, how.digits < 0 ? -how.digits : 0);
    const int digits = how.digits < 0 ? 0 : how.digits;
    const double shown = how.digits < 0 ? unit * round(scaled / unit) : scaled;
    int used = snprintf(text, 48, "%.*f", digits, shown);
    if (strtod(text, NULL) == 0.0) { // no -0.00
        used = snprintf(text, 48, "%.*f", digits, 0.0);
    }
    if (how.power != 0 && used > 0 && used < 40) {
        snprintf(text + used, 48 - (size_t)used, "e%d", how.power);
    }
}

/** A number that is far below the last digit of the value keeps two of its own. */
static void put_small(clod_writer out, clod_rounded how, double number)
{
    char text[48];
    clod_rounded_text(text, how, number);
    if (strtod(text, NULL) == 0.0) {
        snprintf(text, sizeof text, "%.1e", number);
    }
    clod_writer_text(out, text);
}

void clod_rounded_put(clod_writer out, double value, double error, double scatter, int digits,
                      const char *unit)
{
    char text[48];
    const bool known = is_known(value, error);
    const clod_rounded how = clod_rounded_of(value, error, digits);
    if (!known && digits == CLOD_ROUNDED_SHORT) {
        snprintf(text, sizeof text, "%.4g", value);
    } else {
        clod_rounded_text(text, how, value);
    }
    clod_writer_text(out, text);
    if (known) {
        clod_writer_mark(out, " <small>&plusmn; ", " \u00b1 ");
        put_small(out, how, error);
        clod_writer_text(out, unit[0] != '\0' ? " " : "");
        clod_writer_text(out, unit);
        clod_writer_mark(out, "</small>", "");
    } else if (unit[0] != '\0') {
        clod_writer_mark(out, " <small>", " ");
        clod_writer_text(out, unit);
        clod_writer_mark(out, "</small>", "");
    }
    if (known && isfinite(scatter) && scatter > 0.0) {
        clod_writer_mark(out, " <small>(s ", " (s ");
        put_small(out, how, scatter);
        clod_writer_mark(out, ")</small>", ")");
    }
}

void clod_rounded_begin(FILE *out, const char *tag, double value, double error,
                        const char *unit)
{
    if (!isfinite(value)) {
        fprintf(out, "<%s>", tag);
        return;
    }
    fprintf(out, "<%s title=\"", tag);
    clod_figure_json_number(out, value);
    if (isfinite(error) && error > 0.0) {
        fputs(" &plusmn; ", out);
        clod_figure_json_number(out, error);
    }
    if (unit[0] != '\0') {
        fputs(" ", out);
        clod_html_text(out, unit);
    }
    fputs("\">", out);
}
