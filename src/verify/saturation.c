#include "verify/saturation.h"

#include <math.h>

#define RANGE 1000.0 ///< of the search, about the largest filled mass
#define SCAN 200     ///< points of the search, evenly spaced in the logarithm
#define GOLDEN 0.6180339887498949
#define NARROWINGS 80 ///< golden sections: 0.618^80 is far below rounding

double clod_verify_saturation_at(double filled, double saturated)
{
    return -saturated * expm1(-filled / saturated);
}

/** Sum of squares about the law with the saturated mass e^t. */
static double squares(const double *filled, const double *apparent, size_t count, double t)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double off = apparent[i] - clod_verify_saturation_at(filled[i], exp(t));
        sum += off * off;
    }
    return sum;
}

double clod_verify_saturation_fit(const double *filled, const double *apparent, size_t count)
{
    double largest = filled[0];
    for (size_t i = 1; i < count; i++) {
        largest = fmax(largest, filled[i]);
    }
    const double step = 2.0 * log(RANGE) / SCAN;
    const double start = log(largest / RANGE);
    double best = start;
    double least = HUGE_VAL;
    for (int s = 0; s <= SCAN; s++) {
        const double sum = squares(filled, apparent, count, start + s * step);
        if (sum < least) {
            least = sum;
            best = start + s * step;
        }
    }
    double low = best - step;
    double high = best + step;
    for (int n = 0; n < NARROWINGS; n++) {
        const double width = GOLDEN * (high - low);
        if (squares(filled, apparent, count, high - width) <
            squares(filled, apparent, count, low + width)) {
            high = low + width;
        } else {
            low = high - width;
        }
    }
    return exp(0.5 * (low + high));
}
