#include "hopper/samples.h"

#include <math.h>

#define LEAST 3 ///< outlets that make a line
#define CLOSE                                                                                  \
    (1e-12 * 1e-12) ///< variance over the square of the mean below which all are one value

double clod_samples_quantile(const double *sorted, size_t count, double share)
{
    const double at = share * (double)(count - 1);
    const size_t k = (size_t)at;
    const double part = at - (double)k;
    if (k + 1 >= count || part == 0.0 || sorted[k] == sorted[k + 1]) {
        return sorted[k];
    }
    return sorted[k] + part * (sorted[k + 1] - sorted[k]);
}

void clod_samples_values(const clod_solid *solid, const clod_solid_state *state,
                         double value[CLOD_SOLID_CURVES])
{
    for (size_t k = 0; k < CLOD_SOLID_CURVES; k++) {
        const double stress = k == CLOD_SOLID_WALL ? state->sigma_w : state->sigma_1;
        value[k] = clod_curve_at(&solid->curves[k], stress);
    }
}

double clod_samples_share(const double *drawn, const double *outlet, size_t count)
{
    double x = 0.0;
    double y = 0.0;
    double used = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (isfinite(outlet[i]) && isfinite(drawn[i])) {
            x += drawn[i];
            y += outlet[i];
            used += 1.0;
        }
    }
    x /= used;
    y /= used;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (size_t i = 0; i < count; i++) {
        if (isfinite(outlet[i]) && isfinite(drawn[i])) {
            xx += (drawn[i] - x) * (drawn[i] - x);
            xy += (drawn[i] - x) * (outlet[i] - y);
            yy += (outlet[i] - y) * (outlet[i] - y);
        }
    }
    if (used < LEAST || !(yy > CLOSE * used * y * y)) {
        return (double)NAN;
    }
    return xx > CLOSE * used * x * x ? xy * xy / (xx * yy) : 0.0;
}
