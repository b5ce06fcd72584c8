#include "hopper/scatter.h"

#include <math.h>

#include "analysis/fit.h"
#include "base/memory.h"

#define ROUND_OFF                                                                              \
    1e-9 ///< of the largest value: points that scatter by less are on a line by construction

/** Standard deviation of the points about their line; 0: it is not known. */
static double scatter_of(const clod_curve *curve, double round_off, double *work)
{
    const size_t n = curve->count;
    double *x = work, *y = work + n;
    for (size_t i = 0; i < n; i++) {
        x[i] = curve->points[i].x;
        y[i] = curve->points[i].y;
    }
    const double scatter =
        n > 2 ? sqrt(clod_fit_line(x, y, n).residual / ((double)n - 2.0)) : 0.0;
    return scatter > round_off ? scatter : 0.0;
}

/** Errors by construction, of a yield locus whose points are on a line, are none. @return whether a point has none */
static bool drop_round_off(clod_curve *curve, double round_off)
{
    bool some = false;
    for (size_t i = 0; i < curve->count; i++) {
        clod_curve_point *point = &curve->points[i];
        if (point->spread == NULL && point->y_error <= round_off) {
            point->y_error = 0.0;
            some = true;
        }
    }
    return some;
}

bool clod_scatter_take(clod_curve *curve)
{
    double largest = 0.0;
    for (size_t i = 0; i < curve->count; i++) {
        largest = fmax(largest, fabs(curve->points[i].y));
    }
    if (!drop_round_off(curve, ROUND_OFF * largest)) {
        return true;
    }
    double *work = clod_memory_alloc(2 * curve->count, sizeof *work);
    const double scatter = work != NULL ? scatter_of(curve, ROUND_OFF * largest, work) : 0.0;
    const clod_curve_point *first = NULL;
    for (size_t i = 0; i < curve->count && scatter > 0.0; i++) {
        clod_curve_point *point = &curve->points[i];
        if (point->y_error < scatter && point->spread == NULL) {
            first = first == NULL ? point : first;
            point->y_error = scatter;
            point->freedom = curve->count - 2;
            point->set = first->set;
            point->by_line = scatter;
            point->joint = false; // its own error had no part in those of its row
        }
    }
    clod_memory_free(work);
    return work != NULL;
}
