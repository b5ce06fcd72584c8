#include "analysis/mean.h"

#include <math.h>

clod_locus_value clod_mean_of(const double *value, size_t count, double stated)
{
    if (count == 0) {
        return (clod_locus_value){NAN, NAN, NAN};
    }
    const double n = (double)count;
    double mean = 0.0;
    for (size_t i = 0; i < count; i++) {
        mean += value[i] / n;
    }
    double squares = 0.0;
    for (size_t i = 0; i < count; i++) {
        squares += (value[i] - mean) * (value[i] - mean);
    }
    const double between = count > 1 ? squares / (n - 1.0) / n : 0.0;
    const double variance = fmax(between, stated / n / n);
    return (clod_locus_value){mean, count > 1 || stated > 0.0 ? sqrt(variance) : (double)NAN,
                              NAN};
}
