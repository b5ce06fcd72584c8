#include "sim/steady_doubt.h"

#include <math.h>

#include "analysis/fit.h"
#include "analysis/mean.h"
#include "sim/warning_box.h"

#define ERRORS 3.0 // standard errors
#define SHARE 0.1  // of the mean, or of what comes in
#define ADVICE "Let the stages last longer, or give a later output.steady_since."

/** Blocks that are known, with their numbers; how many. */
static int known(const double *block, int count, double *number, double *value)
{
    int n = 0;
    for (int k = 0; k < count; k++) {
        if (!isnan(block[k])) {
            number[n] = k;
            value[n++] = block[k];
        }
    }
    return n;
}

/** First values that are 0, when others are there and none of these is. */
static int late_of(const double *value, int count)
{
    int first = 0;
    while (first < count && value[first] == 0.0) {
        first++;
    }
    for (int k = first; k < count; k++) {
        if (value[k] == 0.0) {
            return 0;
        }
    }
    return first < count ? first : 0;
}

clod_steady_doubt clod_steady_doubt_of(const double *block, int count)
{
    double number[CLOD_STEADY_BLOCKS], value[CLOD_STEADY_BLOCKS];
    const int n = known(block, count, number, value);
    clod_steady_doubt doubt = {0};
    if (n >= CLOD_STEADY_DOUBT_BLOCKS) {
        const clod_fit line = clod_fit_line(number, value, (size_t)n);
        const double error = clod_fit_slope_error(&line, (size_t)n);
        const double change = line.slope * count;
        doubt.late = late_of(value, n);
        if (fabs(line.slope) > ERRORS * error &&
            fabs(change) > SHARE * fabs(clod_mean_of(value, (size_t)n, 0.0).value)) {
            doubt.change = change;
        }
    }
    return doubt;
}

bool clod_steady_doubt_not_zero(const double *block, int count, double scale)
{
    double number[CLOD_STEADY_BLOCKS], value[CLOD_STEADY_BLOCKS];
    const int n = known(block, count, number, value);
    if (n < CLOD_STEADY_DOUBT_BLOCKS) {
        return false;
    }
    const clod_locus_value mean = clod_mean_of(value, (size_t)n, 0.0);
    return fabs(mean.value) > SHARE * scale && fabs(mean.value) > ERRORS * mean.error;
}

bool clod_steady_doubt_warn(json_t *list, const char *what, const char *unit,
                            const double *block, int count, const clod_steady_time *steady)
{
    const clod_steady_doubt doubt = clod_steady_doubt_of(block, count);
    const double end = steady->since + count * steady->block;
    if (doubt.late > 0) {
        clod_warning_box_add(list,
                             "%s is 0 until %.4g s, and its mean is taken from %.4g s on: the "
                             "stream has only begun, and the mean is no steady one. " ADVICE,
                             what, steady->since + doubt.late * steady->block, steady->since);
    } else if (doubt.change != 0.0) {
        clod_warning_box_add(
            list,
            "%s %s by %.2g %s from %.4g to %.4g s, over which its mean is taken: "
            "the mean is no steady one. " ADVICE,
            what, doubt.change > 0.0 ? "rises" : "falls", fabs(doubt.change), unit,
            steady->since, end);
    }
    return doubt.late > 0 || doubt.change != 0.0;
}
