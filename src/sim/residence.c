#include "sim/residence.h"

#include <inttypes.h>
#include <math.h>

#include "base/plural.h"

/** Lower end of a class [s]. */
static double end_of(int bin)
{
    return CLOD_RESIDENCE_LEAST * pow(10.0, (double)bin / CLOD_RESIDENCE_PER_DECADE);
}

/** Time that a fraction of the grains were not in for longer [s]: along the logarithm within its
 *  class. */
static double quantile(const clod_exchange *exchange, int64_t grains, double fraction)
{
    double left = fraction * (double)grains;
    int bin = 0;
    while (bin < CLOD_RESIDENCE_BINS - 1 && left > (double)exchange->residence_count[bin]) {
        left -= (double)exchange->residence_count[bin++];
    }
    const double count = (double)exchange->residence_count[bin];
    const double share = count > 0.0 ? left / count : 0.0;
    return end_of(bin) * pow(10.0, share / CLOD_RESIDENCE_PER_DECADE);
}

clod_residence clod_residence_of(const clod_exchange *exchange)
{
    clod_residence self = {0};
    for (int b = 0; b < CLOD_RESIDENCE_BINS; b++) {
        self.grains += exchange->residence_count[b];
    }
    if (self.grains == 0) {
        return self;
    }
    const double count = (double)self.grains;
    self.mean = exchange->residence / count;
    self.deviation =
        sqrt(fmax(0.0, exchange->residence_squared / count - self.mean * self.mean));
    self.tenth = quantile(exchange, self.grains, 0.1);
    self.median = quantile(exchange, self.grains, 0.5);
    self.ninth = quantile(exchange, self.grains, 0.9);
    return self;
}

static void residence_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    (void)memory;
    const clod_residence r = clod_residence_of(&now->state->exchange);
    if (r.grains > 0) {
        fprintf(out,
                "  residence             %" PRId64
                " grain%s left after %.4g +- %.4g s (10, 50, 90 %%: %.3g, %.3g, %.3g s)\n",
                r.grains, clod_plural((double)r.grains), r.mean, r.deviation, r.tenth, r.median,
                r.ninth);
    }
}

static json_t *residence_json(const void *memory, const clod_free_moment *now)
{
    (void)memory;
    const clod_exchange *exchange = &now->state->exchange;
    const clod_residence r = clod_residence_of(exchange);
    if (r.grains == 0) {
        return NULL;
    }
    json_t *classes = json_array();
    for (int b = 0; b < CLOD_RESIDENCE_BINS; b++) {
        if (exchange->residence_count[b] > 0) {
            json_array_append_new(classes, json_pack("{s:f, s:f, s:I}", "from_s", end_of(b),
                                                     "to_s", end_of(b + 1), "grains",
                                                     (json_int_t)exchange->residence_count[b]));
        }
    }
    return json_pack("{s:I, s:f, s:f, s:f, s:f, s:f, s:o}", "grains", (json_int_t)r.grains,
                     "mean_s", r.mean, "deviation_s", r.deviation, "p10_s", r.tenth, "p50_s",
                     r.median, "p90_s", r.ninth, "classes", classes);
}

const clod_free_measure CLOD_MEASURE_RESIDENCE = {
    .key = "residence", .report = residence_report, .json = residence_json};
