#include "hopper/scatter.h"

#include <math.h>

#include "analysis/fit.h"
#include "base/memory.h"

#define ROUND_OFF                                                                              \
    1e-9 ///< of the largest value: points that scatter by less are on a line by construction

/** Standard deviation of the points about their line; 0: it is not known. */
static double scatter_of(const clod_curve *curve, double *work)
{
    const size_t n = curve->count;
    double *x = work, *y = work + n, largest = 0.0;
    for (size_t i = 0; i < n; i++) {
        x[i] = curve->points[i].x;
        y[i] = curve->points[i].y;
        largest = fmax(largest, fabs(y[i]));
    }
    const double scatter =
        n > 2 ? sqrt(clod_fit_line(x, y, n).residual / ((double)n - 2.0)) : 0.0;
    return scatter > ROUND_OFF * largest ? scatter : 0.0;
}

bool clod_scatter_take(clod_curve *curve)
{
    double *work = clod_memory_alloc(2 * curve->count, sizeof *work);
    const double scatter = work != NULL ? scatter_of(curve, work) : 0.0;
    const clod_curve_point *first = NULL;
    for (size_t i = 0; i < curve->count && scatter > 0.0; i++) {
        clod_curve_point *point = &curve->points[i];
        if (point->y_error == 0.0 && point->spread == NULL) {
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
