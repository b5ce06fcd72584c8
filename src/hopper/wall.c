#include "hopper/wall.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "hopper/repeats.h"
#include "hopper/scatter.h"
#include "hopper/specimens.h"

#define ASKED 1e-6 ///< the same for those that were asked for, which are exact

/** A point and what it belongs to. */
typedef struct item {
    double x, y, x_error, y_error;
    double at; ///< what the points of one stress have in common
    int64_t seed;
    size_t specimen; ///< number of the seed
} item;

/** Points on their way to a curve. */
typedef struct set {
    item *items; ///< [count]
    size_t count;
    size_t specimens;
    double apart; ///< relative distance within which two `at` are the same
    double slope; ///< of the locus; NAN: each stress has the line from the origin
} set;

static int by_seed(const void *left, const void *right)
{
    const int64_t a = ((const item *)left)->seed;
    const int64_t b = ((const item *)right)->seed;
    return (a > b) - (a < b);
}

static int by_stress(const void *left, const void *right)
{
    const item *a = left;
    const item *b = right;
    return a->at != b->at ? (a->at > b->at) - (a->at < b->at) : by_seed(left, right);
}

static void fill(set *self, const clod_wall_locus_point *points)
{
    bool asked = true;
    for (size_t i = 0; i < self->count; i++) {
        asked = asked && points[i].wall_stress > 0.0;
    }
    self->apart = asked ? ASKED : CLOD_REPEATS_APART;
    for (size_t i = 0; i < self->count; i++) {
        const clod_wall_locus_point *p = &points[i];
        self->items[i] = (item){.x = p->sigma,
                                .y = p->tau,
                                .x_error = p->sigma_error,
                                .y_error = p->tau_error,
                                .at = asked ? p->wall_stress : p->sigma,
                                .seed = p->seed};
    }
    qsort(self->items, self->count, sizeof *self->items, by_seed);
    self->specimens = 1;
    for (size_t i = 1; i < self->count; i++) {
        self->specimens += self->items[i].seed != self->items[i - 1].seed ? 1 : 0;
        self->items[i].specimen = self->specimens - 1;
    }
    qsort(self->items, self->count, sizeof *self->items, by_stress);
}

/** The first point of the next stress. */
static size_t end_of(const set *self, size_t first)
{
    size_t next = first + 1;
    while (next < self->count &&
           self->items[next].at <= (1.0 + self->apart) * self->items[first].at) {
        next++;
    }
    return next;
}

static size_t count_stresses(const set *self)
{
    size_t stresses = 0;
    for (size_t first = 0; first < self->count; first = end_of(self, first)) {
        stresses++;
    }
    return stresses;
}

/**
 * Mean of the points of one stress.
 *
 * @param spread  [out] [specimens] NAN on entry; NULL: the points are no specimens
 */
static clod_curve_point mean_of(const set *self, const item *items, size_t count,
                                double *spread)
{
    const double n = (double)count;
    clod_curve_point mean = {0};
    for (size_t i = 0; i < count; i++) {
        mean.x += items[i].x / n;
        mean.y += items[i].y / n;
    }
    const double slope = isfinite(self->slope) ? self->slope : mean.y / mean.x;
    double stated = 0.0;
    double scatter = 0.0;
    for (size_t i = 0; i < count; i++) {
        const double across = slope * items[i].x_error;
        const double off =
            (items[i].y - mean.y - slope * (items[i].x - mean.x)) / sqrt(n * (n - 1.0));
        stated += (items[i].y_error * items[i].y_error + across * across) / n / n;
        scatter += off * off;
        if (spread != NULL) {
            double *own = &spread[items[i].specimen];
            *own = isnan(*own) ? off : *own + off;
        }
    }
    mean.y_error = sqrt(fmax(stated, scatter));
    mean.spread = spread;
    mean.freedom = spread == NULL && scatter > stated ? count - 1 : 0; // else as specimens say
    return mean;
}

static void make_curve(const set *self, clod_curve *curve)
{
    for (size_t first = 0, next; first < self->count; first = next) {
        next = end_of(self, first);
        const item *one = &self->items[first];
        double *spread =
            curve->spread != NULL ? &curve->spread[curve->count * curve->specimens] : NULL;
        curve->points[curve->count++] = next - first > 1
                                            ? mean_of(self, one, next - first, spread)
                                            : (clod_curve_point){.x = one->x,
                                                                 .y = one->y,
                                                                 .x_error = one->x_error,
                                                                 .y_error = one->y_error};
        curve->points[curve->count - 1].set = curve->count - 1;
    }
}

static const char OF[] = "Wall yield locus: ";

/** Evaluate the locus for what it says, and its slope; too few points for a line are a remark. */
static bool look(set *self, const clod_wall_locus_point *points, bool *one_specimen,
                 clod_warning_list *warnings, clod_status *status)
{
    clod_wall_locus locus;
    clod_status why = {0};
    self->slope = (double)NAN;
    if (!clod_wall_locus_evaluate(points, self->count, &locus, &why)) {
        clod_warning_list_add(warnings, "%s%s", OF, why.text);
        return why.code != CLOD_FAILED || clod_status_fail(status, CLOD_FAILED, "%s", why.text);
    }
    self->slope = tan(locus.phi_w.value);
    for (size_t k = 0; k < locus.warning_count; k++) {
        clod_warning_list_add(warnings, "%s%s", OF, locus.warnings[k]);
    }
    *one_specimen = clod_wall_locus_one_specimen(&locus);
    clod_wall_locus_fini(&locus);
    return true;
}

bool clod_wall_curve(const clod_wall_locus_point *points, size_t count, clod_curve *curve,
                     clod_warning_list *warnings, clod_status *status)
{
    set self = {.count = count};
    bool one_specimen = false;
    *curve = (clod_curve){.way = CLOD_CURVE_EXTENDED, .test = CLOD_CURVE_WALL};
    if (!look(&self, points, &one_specimen, warnings, status)) {
        return false;
    }
    self.items = clod_memory_alloc(count, sizeof *self.items);
    curve->points = clod_memory_alloc(count, sizeof *curve->points);
    bool good = self.items != NULL && curve->points != NULL;
    if (good) {
        fill(&self, points);
    }
    if (good && self.specimens > 1) {
        const size_t places = count_stresses(&self) * self.specimens;
        curve->specimens = self.specimens;
        curve->spread = clod_memory_alloc(places, sizeof *curve->spread);
        good = curve->spread != NULL;
        for (size_t k = 0; k < places && good; k++) {
            curve->spread[k] = (double)NAN;
        }
    }
    if (good) {
        make_curve(&self, curve);
        if (curve->specimens > 0) {
            clod_specimens_sort(curve->points, curve->count, curve->specimens);
        }
        good = clod_scatter_take(curve);
        clod_curve_sort(curve);
    }
    if (good && one_specimen && clod_curve_has_errors(curve)) {
        clod_warning_list_add(warnings, "%serrors of " CLOD_LOCUS_ONE_SPECIMEN ".", OF);
    }
    clod_memory_free(self.items);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for %zu points.", count);
}

bool clod_wall_read(const char *path, clod_curve *curve, clod_warning_list *warnings,
                    clod_status *status)
{
    clod_wall_locus_point *points;
    size_t count;
    if (!clod_wall_locus_read(path, &points, &count, status)) {
        return false;
    }
    const bool good = clod_wall_curve(points, count, curve, warnings, status);
    clod_locus_free(points);
    return good;
}
