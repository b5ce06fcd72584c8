#include "measure/peak.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"

enum { PLACE, TAU, SIGMA };

void clod_peak_init(clod_peak *self, double window, double beyond)
{
    CLOD_ASSERT(window > 0.0 && beyond > 0.0);
    memset(self, 0, sizeof *self);
    self->window = window;
    self->beyond = beyond;
    self->at = NAN;
    for (int what = PLACE; what <= SIGMA; what++) {
        self->mean[what] = NAN;
    }
}

/** Mean of the bins that are kept. */
static double mean_of(const clod_peak *self, int what)
{
    const int64_t kept = self->bin_count < CLOD_PEAK_BINS ? self->bin_count : CLOD_PEAK_BINS;
    double sum = 0.0;
    for (int64_t k = 0; k < kept; k++) {
        sum += self->bin[what][k];
    }
    return sum / (double)kept;
}

/** Square of the standard error of the mean of `count` values, their linear trend taken off. */
static double error_squared(const double *value, int count)
{
    const double n = (double)count;
    double mean = 0.0;
    for (int k = 0; k < count; k++) {
        mean += value[k] / n;
    }
    double squares = 0.0;
    double moment = 0.0;
    for (int k = 0; k < count; k++) {
        const double off = value[k] - mean;
        squares += off * off;
        moment += ((double)k - 0.5 * (n - 1.0)) * off;
    }
    const double about_line = squares - moment * moment * 12.0 / (n * (n * n - 1.0));
    return fmax(about_line, 0.0) / (n - 2.0) / n;
}

/** Standard error of the smoothed curve by blocking: bins, pairs, fours. */
static double error_of(const clod_peak *self)
{
    double value[CLOD_PEAK_BINS];
    for (int k = 0; k < CLOD_PEAK_BINS; k++) {
        value[k] = self->bin[TAU][(self->bin_count + k) % CLOD_PEAK_BINS];
    }
    double largest = 0.0;
    for (int count = CLOD_PEAK_BINS; count >= CLOD_PEAK_BINS / 4; count /= 2) {
        largest = fmax(largest, error_squared(value, count));
        for (int k = 0; k < count / 2; k++) {
            value[k] = 0.5 * (value[2 * k] + value[2 * k + 1]);
        }
    }
    return sqrt(largest);
}

static void finish_bin(clod_peak *self)
{
    const int64_t at = self->bin_count % CLOD_PEAK_BINS;
    for (int what = PLACE; what <= SIGMA; what++) {
        self->bin[what][at] = self->mean[what];
    }
    self->way = 0.0;
    self->bin_count++;
    if (self->bin_count < CLOD_PEAK_BINS) {
        return;
    }
    self->smooth = mean_of(self, TAU);
    self->place = mean_of(self, PLACE);
    if (self->bin_count == CLOD_PEAK_BINS || self->smooth > self->peak) {
        self->peak = self->smooth;
        self->peak_place = self->place;
        self->peak_error = error_of(self);
        self->peak_sigma = mean_of(self, SIGMA);
    }
}

static bool is_passed(const clod_peak *self)
{
    return self->bin_count >= CLOD_PEAK_BINS && self->place - self->peak_place >= self->beyond;
}

/** A part of the way of a sample, all of it in the bin that is being filled. */
static void fill(clod_peak *self, double part, const double value[3])
{
    self->way += part;
    for (int what = PLACE; what <= SIGMA; what++) {
        self->mean[what] += (value[what] - self->mean[what]) * (part / self->way);
    }
}

bool clod_peak_add(clod_peak *self, double displacement, double tau, double sigma)
{
    const double width = self->window / CLOD_PEAK_BINS;
    if (isnan(self->at)) {
        self->at = displacement;
        self->mean[PLACE] = displacement;
        self->mean[TAU] = tau;
        self->mean[SIGMA] = sigma;
    }
    while (displacement > self->at) {
        const double room = width - self->way;
        const double left = displacement - self->at;
        const double part = fmin(left, room);
        fill(self, part, (double[3]){self->at + 0.5 * part, tau, sigma});
        if (left < room) {
            self->at = displacement;
        } else {
            self->at += part;
            finish_bin(self);
        }
    }
    return is_passed(self);
}

clod_peak_result clod_peak_summary(const clod_peak *self)
{
    if (self->bin_count >= CLOD_PEAK_BINS) {
        return (clod_peak_result){self->peak, self->peak_error, self->peak_place,
                                  self->peak_sigma, is_passed(self)};
    }
    if (self->bin_count > 0) {
        return (clod_peak_result){mean_of(self, TAU), NAN, mean_of(self, PLACE),
                                  mean_of(self, SIGMA), false};
    }
    return (clod_peak_result){self->mean[TAU], NAN, self->mean[PLACE], self->mean[SIGMA],
                              false};
}
