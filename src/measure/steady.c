#include "measure/steady.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#define BLIND 1.5 // largest error of the trend, in tolerances

enum { TAU, HEIGHT, SIGMA };

void clod_steady_init(clod_steady *self, int64_t blocks_needed, int64_t samples_per_block,
                      double tolerance, double height_tolerance)
{
    CLOD_ASSERT(blocks_needed >= CLOD_STEADY_MIN && blocks_needed <= CLOD_STEADY_MAX);
    CLOD_ASSERT(samples_per_block >= 1 && tolerance > 0.0 && height_tolerance > 0.0);
    memset(self, 0, sizeof *self);
    self->blocks_needed = blocks_needed;
    self->samples_per_block = samples_per_block;
    self->tolerance = tolerance;
    self->height_tolerance = height_tolerance;
}

/** Block average number `k` of the last `window` blocks. */
static double block_at(const clod_steady *self, int signal, int64_t window, int64_t k)
{
    return self->block[signal][(self->block_count - window + k) % CLOD_STEADY_MAX];
}

/** Mean and fitted line over the last blocks, three at least. */
static clod_steady_mean average(const clod_steady *self, int signal, int64_t window)
{
    const double n = (double)window;
    const double middle = 0.5 * (n - 1.0);
    double mean = 0.0;
    for (int64_t k = 0; k < window; k++) {
        mean += block_at(self, signal, window, k) / n;
    }
    double squares = 0.0;
    double moment = 0.0;
    for (int64_t k = 0; k < window; k++) {
        const double off = block_at(self, signal, window, k) - mean;
        squares += off * off;
        moment += ((double)k - middle) * off;
    }
    const double lever = n * (n * n - 1.0) / 12.0; // sum of (k - middle)^2
    const double slope = moment / lever;
    const double residual = fmax(squares - slope * moment, 0.0) / (n - 2.0);
    const double to_end = 0.5 * n; // in blocks, from the middle of the window
    return (clod_steady_mean){
        .value = mean,
        .error = sqrt(squares / (n - 1.0) / n),
        .trend = slope * (n - 1.0),
        .trend_error = sqrt(residual / lever) * (n - 1.0),
        .end = mean + slope * to_end,
        .end_error = sqrt(residual * (1.0 / n + to_end * to_end / lever)),
    };
}

/** The three conditions of the header for one signal and one window. */
static bool is_level(const clod_steady *self, int signal, int64_t window, double tolerance)
{
    const clod_steady_mean mean = average(self, signal, window);
    const double limit = tolerance * fabs(mean.value);
    const double trend = fabs(mean.trend);
    const bool certain = trend > 2.0 * mean.trend_error;
    return trend <= (certain ? 0.5 * limit : limit) && mean.trend_error <= BLIND * limit;
}

/** Largest window that is steady, 0 when none is. */
static int64_t find_window(const clod_steady *self)
{
    const int64_t kept =
        self->block_count < CLOD_STEADY_MAX ? self->block_count : CLOD_STEADY_MAX;
    for (int64_t window = kept; window >= self->blocks_needed; window--) {
        if (is_level(self, TAU, window, self->tolerance) &&
            is_level(self, HEIGHT, window, self->height_tolerance)) {
            return window;
        }
    }
    return 0;
}

bool clod_steady_add(clod_steady *self, double tau, double height, double sigma)
{
    self->sum[TAU] += tau;
    self->sum[HEIGHT] += height;
    self->sum[SIGMA] += sigma;
    self->samples++;
    if (self->samples == self->samples_per_block) {
        const int64_t at = self->block_count % CLOD_STEADY_MAX;
        for (int signal = TAU; signal <= SIGMA; signal++) {
            self->block[signal][at] = self->sum[signal] / (double)self->samples;
            self->sum[signal] = 0.0;
        }
        self->samples = 0;
        self->block_count++;
        self->window = find_window(self);
    }
    return self->window > 0;
}

static clod_steady_mean summary_of(const clod_steady *self, int signal, int64_t window)
{
    if (window < CLOD_STEADY_MIN) {
        double sum = 0.0;
        for (int64_t k = 0; k < window; k++) {
            sum += block_at(self, signal, window, k);
        }
        return (clod_steady_mean){sum / (double)window, NAN, NAN, NAN, NAN, NAN}; // 0/0 is NAN
    }
    return average(self, signal, window);
}

clod_steady_result clod_steady_summary(const clod_steady *self)
{
    int64_t window = self->window;
    if (window == 0) {
        window =
            self->block_count < self->blocks_needed ? self->block_count : self->blocks_needed;
    }
    return (clod_steady_result){.steady = self->window > 0,
                                .blocks = window,
                                .tau = summary_of(self, TAU, window),
                                .height = summary_of(self, HEIGHT, window),
                                .sigma = summary_of(self, SIGMA, window)};
}
