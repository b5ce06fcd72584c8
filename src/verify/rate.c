#include "verify/rate.h"

#include <math.h>

#include "analysis/fit.h"

double clod_verify_rate_of(const double *time, const double *mass, size_t count, double *error)
{
    double rate[CLOD_VERIFY_BLOCKS];
    double mean = 0.0;
    double squares = 0.0;
    for (size_t b = 0; b < CLOD_VERIFY_BLOCKS; b++) {
        const size_t begin = b * (count - 1) / CLOD_VERIFY_BLOCKS;
        const size_t end = (b + 1) * (count - 1) / CLOD_VERIFY_BLOCKS;
        rate[b] = (mass[end] - mass[begin]) / (time[end] - time[begin]);
        mean += rate[b] / CLOD_VERIFY_BLOCKS;
    }
    for (size_t b = 0; b < CLOD_VERIFY_BLOCKS; b++) {
        squares += (rate[b] - mean) * (rate[b] - mean);
    }
    *error = sqrt(squares / (CLOD_VERIFY_BLOCKS - 1) / CLOD_VERIFY_BLOCKS);
    return clod_fit_line(time, mass, count).slope;
}

double clod_verify_rate_exponent(const clod_verify_rate *rates, size_t count, double k,
                                 double *error)
{
    double x[CLOD_VERIFY_RATES] = {0};
    double y[CLOD_VERIFY_RATES] = {0};
    const size_t used = count < CLOD_VERIFY_RATES ? count : CLOD_VERIFY_RATES;
    for (size_t r = 0; r < used; r++) {
        x[r] = log(rates[r].orifice - k);
        y[r] = log(rates[r].value);
    }
    const clod_fit line = clod_fit_line(x, y, used);
    double variance = 0.0;
    for (size_t r = 0; r < used; r++) {
        const double weight = (x[r] - line.mean_x) / line.sxx;
        const double relative = rates[r].error / rates[r].value;
        variance += weight * weight * relative * relative;
    }
    *error = sqrt(fmax(line.residual / (double)(used - 2) / line.sxx, variance));
    return line.slope;
}
