#include "sim/residence.h"

#include <inttypes.h>
#include <math.h>

#include "base/memory.h"
#include "base/plural.h"
#include "base/text.h"
#include "output/folder_files.h"

static double quantile(const clod_exchange *exchange, int64_t grains, double fraction)
{
    const double range[2] = {exchange->residence_least, exchange->residence_most};
    return clod_time_class_quantile(exchange->residence_count, grains, fraction, range);
}

clod_residence clod_residence_of(const clod_exchange *exchange)
{
    clod_residence self = {0};
    for (int b = 0; b < CLOD_TIME_CLASSES; b++) {
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
    const clod_exchange *exchange = &now->state->exchange;
    const clod_residence r = clod_residence_of(exchange);
    if (r.grains > 0) {
        fprintf(out,
                "  residence             %" PRId64
                " grain%s that came in left from %.4g s on, after %.4g s, standard deviation "
                "%.4g s (10, 50, 90 %%: %.4g, %.4g, %.4g s)\n",
                r.grains, clod_plural((double)r.grains), exchange->residence_since, r.mean,
                r.deviation, r.tenth, r.median, r.ninth);
    }
}

/** Of the first grain that has left on. */
static bool residence_told(const clod_case *from)
{
    return from->open == CLOD_OPEN_DELETE || from->outlet_count > 0;
}

static void residence_paths(const clod_case *from, const clod_state *state,
                            clod_free_paths *paths)
{
    (void)from;
    (void)state;
    const int last = CLOD_TIME_CLASSES - 1;
    clod_free_paths_add(paths, NULL,
                        "since_s grains mean_s deviation_s least_s p10_s p50_s p90_s most_s "
                        "classes.[0-%d].from_s classes.[0-%d].to_s classes.[0-%d].grains",
                        last, last, last);
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
    for (int b = 0; b < CLOD_TIME_CLASSES; b++) {
        if (exchange->residence_count[b] > 0) {
            json_array_append_new(classes, json_pack("{s:f, s:f, s:I}", "from_s",
                                                     clod_time_class_from(b), "to_s",
                                                     clod_time_class_from(b + 1), "grains",
                                                     (json_int_t)exchange->residence_count[b]));
        }
    }
    return json_pack("{s:f, s:I, s:f, s:f, s:f, s:f, s:f, s:f, s:f, s:o}", "since_s",
                     exchange->residence_since, "grains", (json_int_t)r.grains, "mean_s",
                     r.mean, "deviation_s", r.deviation, "least_s", exchange->residence_least,
                     "p10_s", r.tenth, "p50_s", r.median, "p90_s", r.ninth, "most_s",
                     exchange->residence_most, "classes", classes);
}

/** The distribution: of each class that has grains their number, and the share of all that was
 *  in for no longer than its upper end. */
static void put_classes(FILE *out, const clod_exchange *exchange, int64_t grains)
{
    int64_t sum = 0;
    fputs("from [s],to [s],grains [1],share_up_to [1]\n", out);
    for (int b = 0; b < CLOD_TIME_CLASSES; b++) {
        const int64_t count = exchange->residence_count[b];
        sum += count;
        if (count > 0) {
            fprintf(out, "%.17g,%.17g,%" PRId64 ",%.17g\n", clod_time_class_from(b),
                    clod_time_class_from(b + 1), count, (double)sum / (double)grains);
        }
    }
}

static bool residence_write(const clod_folder *folder, const void *memory,
                            const clod_free_moment *now, clod_status *status)
{
    (void)memory;
    const clod_exchange *exchange = &now->state->exchange;
    const clod_residence r = clod_residence_of(exchange);
    if (r.grains == 0) {
        return true;
    }
    clod_text text;
    FILE *out = clod_text_open(&text);
    char *made = NULL;
    if (out != NULL) {
        put_classes(out, exchange, r.grains);
        made = clod_text_close(&text);
    }
    const bool good = clod_folder_write(folder, "residence.csv", made, status);
    clod_memory_free(made);
    return good;
}

const clod_free_measure CLOD_MEASURE_RESIDENCE = {.key = "residence",
                                                  .report = residence_report,
                                                  .told = residence_told,
                                                  .paths = residence_paths,
                                                  .json = residence_json,
                                                  .write = residence_write};
