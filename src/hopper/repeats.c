#include "hopper/repeats.h"

#include <math.h>
#include <stdio.h>

#include "hopper/chance.h"
#include "hopper/line_fit.h"

#define ALIKE                                                                                  \
    0.05 ///< of the mean: what repeats differ by since their stresses are not quite one
#define TESTERS 0.10 ///< of the mean: standard deviation of repeats on most testers

size_t clod_repeats_end(const clod_curve *curve, size_t first)
{
    size_t end = first + 1;
    while (end < curve->count &&
           curve->points[end].x <= (1.0 + CLOD_REPEATS_APART) * curve->points[first].x) {
        end++;
    }
    return end;
}

/** Standard error of the mean of points `first` to before `end` by what they scatter; 0 of a single one. */
static double scatter_of(const clod_curve *curve, size_t first, size_t end)
{
    const double n = (double)(end - first);
    double mean = 0.0, scatter = 0.0;
    for (size_t i = first; i < end; i++) {
        mean += curve->points[i].y / n;
    }
    for (size_t i = first; i < end && n > 1.0; i++) {
        scatter = hypot(scatter, (curve->points[i].y - mean) / sqrt(n * (n - 1.0)));
    }
    return scatter;
}

clod_curve_point clod_repeats_mean(const clod_curve *curve, size_t first, size_t end)
{
    const double n = (double)(end - first);
    clod_curve_point mean = curve->points[first];
    double x = 0.0, y = 0.0, x_error = 0.0, y_error = 0.0;
    for (size_t i = first; i < end; i++) {
        const clod_curve_point *point = &curve->points[i];
        x += point->x / n;
        y += point->y / n;
        x_error = hypot(x_error, point->x_error / n);
        y_error = hypot(y_error, point->y_error / n);
        mean.by_line = fmax(mean.by_line, point->by_line);
        if (point->freedom > 0 && (mean.freedom == 0 || point->freedom < mean.freedom)) {
            mean.freedom = point->freedom;
            mean.set = point->set;
        }
    }
    if (end - first == 1) {
        return mean;
    }
    const double scatter = scatter_of(curve, first, end);
    mean.x = x;
    mean.y = y;
    mean.x_error = x_error;
    mean.y_error = y_error;
    mean.joint = false;
    if (scatter > y_error && mean.by_line == 0.0) {
        mean.y_error = scatter;
        mean.freedom = end - first - 1;
    }
    return mean;
}

/** The smallest and the largest of repeats, and whether all have an error that was stated. */
typedef struct range {
    double least, most;
    bool stated;
} range;

static range range_of(const clod_curve *curve, size_t first, size_t end)
{
    range self = {(double)INFINITY, 0.0, true};
    for (size_t i = first; i < end; i++) {
        self.least = fmin(self.least, curve->points[i].y);
        self.most = fmax(self.most, curve->points[i].y);
        self.stated = self.stated && clod_curve_stated(&curve->points[i]) > 0.0;
    }
    return self;
}

/** Chance of so different repeats, or more different ones, by their errors; of those without, by what testers scatter. */
static double chance_of(const clod_curve *curve, size_t first, size_t end, bool stated)
{
    const double testers = TESTERS * clod_repeats_mean(curve, first, end).y;
    double weights = 0.0, sum = 0.0, chi_square = 0.0;
    size_t freedom = 0; // of the errors, the fewest
    for (size_t i = first; i < end; i++) {
        const clod_curve_point *point = &curve->points[i];
        const double error = stated ? point->y_error : testers;
        const size_t own = stated ? point->freedom : 0;
        weights += 1.0 / (error * error);
        sum += point->y / (error * error);
        freedom = own > 0 && (freedom == 0 || own < freedom) ? own : freedom;
    }
    for (size_t i = first; i < end; i++) {
        const clod_curve_point *point = &curve->points[i];
        const double off = (point->y - sum / weights) / (stated ? point->y_error : testers);
        chi_square += off * off;
    }
    return clod_chance_above(chi_square, end - first - 1, freedom);
}

static bool has_spread(const clod_curve *curve, size_t first, size_t end)
{
    bool has = false;
    for (size_t i = first; i < end; i++) {
        has = has || curve->points[i].spread != NULL;
    }
    return has;
}

/** Whether repeats differ by more than their errors tell, or, without errors, than testers scatter by. */
static bool differ(const clod_curve *curve, size_t first, size_t end, const range *of)
{
    const double mean = clod_repeats_mean(curve, first, end).y;
    return end - first > 1 && !has_spread(curve, first, end) &&
           of->most - of->least > ALIKE * mean &&
           chance_of(curve, first, end, of->stated) < CLOD_LINE_FIT_RARE;
}

void clod_repeats_warn(const clod_curve *curve, const char *what, clod_warning_list *warnings)
{
    size_t stresses = 0, count = 0;
    double at = 0.0;
    range worst = {1.0, 1.0, false};
    for (size_t first = 0, end; first < curve->count; first = end) {
        end = clod_repeats_end(curve, first);
        const range of = range_of(curve, first, end);
        const bool is = differ(curve, first, end, &of);
        stresses += is ? 1 : 0;
        if (is && of.most * worst.least >= worst.most * of.least) {
            worst = of;
            count = end - first;
            at = curve->points[first].x;
        }
    }
    char others[64] = "";
    if (stresses > 1) {
        snprintf(others, sizeof others, ", and so it is at %zu other%s", stresses - 1,
                 stresses > 2 ? "s" : "");
    }
    if (stresses > 0) {
        clod_warning_list_add(
            warnings,
            "%s: %zu repeats at a sigma_1 of %.6g kPa have f_c from %.6g to %.6g kPa, which is more than "
            "%s%s. Is one of another sample, moisture or time at rest, or misprinted?",
            what, count, 1e-3 * at, 1e-3 * worst.least, 1e-3 * worst.most,
            worst.stated ? "their errors tell" : "testers scatter by, some 10 %", others);
    }
}

void clod_repeats_pool(clod_curve *curve)
{
    size_t count = 0;
    for (size_t first = 0, end; first < curve->count; first = end) {
        end = clod_repeats_end(curve, first);
        if (has_spread(curve, first, end)) {
            end = first + 1;
        }
        curve->points[count++] = clod_repeats_mean(curve, first, end);
    }
    curve->count = count;
}
