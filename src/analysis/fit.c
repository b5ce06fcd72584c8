#include "analysis/fit.h"

#include <math.h>

clod_fit clod_fit_line(const double *x, const double *y, size_t count)
{
    clod_fit self = {0};
    const double n = (double)count;
    double mean_y = 0.0;
    for (size_t i = 0; i < count; i++) {
        self.mean_x += x[i] / n;
        mean_y += y[i] / n;
    }
    double sxy = 0.0;
    double syy = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double dx = x[i] - self.mean_x;
        const double dy = y[i] - mean_y;
        self.sxx += dx * dx;
        sxy += dx * dy;
        syy += dy * dy;
    }
    self.slope = sxy / self.sxx;
    self.intercept = mean_y - self.slope * self.mean_x;
    for (size_t i = 0; i < count; i++) {
        const double off = y[i] - mean_y - self.slope * (x[i] - self.mean_x);
        self.residual += off * off;
    }
    self.r_squared = syy > 0.0 ? 1.0 - self.residual / syy : 1.0;
    return self;
}

double clod_fit_slope_error(const clod_fit *line, size_t count)
{
    return sqrt(line->residual / (((double)count - 2.0) * line->sxx));
}

clod_fit_error clod_fit_errors(const clod_fit *line, const double *x, const double *variance,
                               size_t count)
{
    const double n = (double)count;
    double mean = 0.0;
    bool all = true;
    for (size_t i = 0; i < count; i++) {
        mean += variance[i] / n;
        all = all && variance[i] > 0.0;
    }
    if (!all && count <= 2) {
        return (clod_fit_error){(double)NAN, (double)NAN, false};
    }
    const double scatter = count > 2 ? line->residual / (n - 2.0) : 0.0;
    const double beyond = fmax(scatter - mean, 0.0);
    double of_slope = 0.0;
    double of_intercept = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double lever = (x[i] - line->mean_x) / line->sxx;
        const double foot = 1.0 / n - line->mean_x * lever;
        of_slope += lever * lever * (variance[i] + beyond);
        of_intercept += foot * foot * (variance[i] + beyond);
    }
    return (clod_fit_error){sqrt(of_slope), sqrt(of_intercept), true};
}

/** Two-sided 95 % point of Student's t. */
static double student(size_t freedom)
{
    static const double T95[] = {INFINITY, 12.706, 4.303, 3.182, 2.776, 2.571,
                                 2.447,    2.365,  2.306, 2.262, 2.228};
    const size_t last = sizeof T95 / sizeof T95[0] - 1;
    return T95[freedom < last ? freedom : last];
}

double clod_fit_sag(const clod_fit *line, const double *x, const double *y, size_t count,
                    double *error)
{
    // the part of (x - mean)^2 that no line can take up: minus its mean and its slope
    const double n = (double)count;
    double cubes = 0.0;
    for (size_t i = 0; i < count; i++) {
        cubes += pow(x[i] - line->mean_x, 3.0);
    }
    double squares = 0.0;
    double moment = 0.0;
    double low = INFINITY;
    double high = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        const double dx = x[i] - line->mean_x;
        const double bow = dx * dx - line->sxx / n - cubes / line->sxx * dx;
        squares += bow * bow;
        moment += bow * (y[i] - line->intercept - line->slope * x[i]);
        low = fmin(low, bow);
        high = fmax(high, bow);
    }
    *error = INFINITY;
    if (count < 4 || squares <= 0.0) {
        return 0.0;
    }
    const double bend = moment / squares;
    const size_t freedom = count - 3;
    const double scatter = fmax(line->residual - bend * moment, 0.0) / (double)freedom;
    *error = student(freedom) * sqrt(scatter / squares) * (high - low);
    return -bend * (high - low);
}
