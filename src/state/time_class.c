#include "state/time_class.h"

double clod_time_class_quantile(const int64_t *count, int64_t all, double fraction,
                                const double range[2])
{
    double left = fraction * (double)all;
    int k = 0;
    while (k < CLOD_TIME_CLASSES - 1 && left > (double)count[k]) {
        left -= (double)count[k++];
    }
    const double share = count[k] > 0 ? left / (double)count[k] : 0.0;
    const double time = clod_time_class_from(k) * pow(10.0, share / CLOD_TIME_PER_DECADE);
    return fmin(fmax(time, range[0]), range[1]);
}
