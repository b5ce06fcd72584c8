#include "hopper/specimens.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"

static int by_size(const void *left, const void *right)
{
    const int64_t a = *(const int64_t *)left;
    const int64_t b = *(const int64_t *)right;
    return (a > b) - (a < b);
}

static int64_t seed_of(const clod_locus *locus)
{
    return locus->marks[0].seed;
}

/** All seeds of a study, each once, in ascending order. */
static void collect(const clod_locus_study *study, clod_specimens *self)
{
    size_t all = 0;
    for (size_t g = 0; g < study->count; g++) {
        for (size_t k = 0; k < study->groups[g].seed_count; k++) {
            self->seeds[all++] = seed_of(&study->groups[g].seeds[k]);
        }
    }
    qsort(self->seeds, all, sizeof *self->seeds, by_size);
    for (size_t i = 0; i < all; i++) {
        if (i == 0 || self->seeds[i] != self->seeds[self->count - 1]) {
            self->seeds[self->count++] = self->seeds[i];
        }
    }
}

static size_t place_of(const clod_specimens *self, int64_t seed)
{
    size_t at = 0;
    while (self->seeds[at] != seed) {
        at++;
    }
    return at;
}

static double value_of(const clod_locus *locus, clod_specimens_value value)
{
    const double values[CLOD_SPECIMENS_VALUES] = {
        [CLOD_SPECIMENS_SIGMA_1] = locus->sigma_1.value,
        [CLOD_SPECIMENS_STRENGTH] = locus->sigma_c.value,
        [CLOD_SPECIMENS_PHI_E] = locus->phi_e.value,
        [CLOD_SPECIMENS_PHI_T] = locus->phi_lin.value,
        [CLOD_SPECIMENS_RHO] = locus->rho_b.value};
    return values[value];
}

/** Moves of one value of one locus. */
static void spread_of(const clod_specimens *self, const clod_locus_group *group,
                      clod_specimens_value value, double *spread)
{
    const double n = (double)group->seed_count;
    const double mean = value_of(&group->locus, value);
    for (size_t k = 0; k < group->seed_count; k++) {
        const clod_locus *one = &group->seeds[k];
        spread[place_of(self, seed_of(one))] =
            (value_of(one, value) - mean) / sqrt(n * (n - 1.0));
    }
}

bool clod_specimens_of(const clod_locus_study *study, clod_specimens *self)
{
    size_t all = 0;
    size_t most = 0;
    *self = (clod_specimens){0};
    for (size_t g = 0; g < study->count; g++) {
        all += study->groups[g].seed_count;
        most = study->groups[g].seed_count > most ? study->groups[g].seed_count : most;
    }
    if (most < 2) {
        return true;
    }
    self->seeds = clod_memory_alloc(all, sizeof *self->seeds);
    if (self->seeds == NULL) {
        return false;
    }
    collect(study, self);
    const size_t places = study->count * CLOD_SPECIMENS_VALUES * self->count;
    self->spread = clod_memory_alloc(places, sizeof *self->spread);
    for (size_t k = 0; k < places && self->spread != NULL; k++) {
        self->spread[k] = (double)NAN;
    }
    for (size_t g = 0; g < study->count && self->spread != NULL; g++) {
        for (int v = 0; v < CLOD_SPECIMENS_VALUES && study->groups[g].seed_count > 1; v++) {
            spread_of(self, &study->groups[g], (clod_specimens_value)v,
                      &self->spread[(g * CLOD_SPECIMENS_VALUES + (size_t)v) * self->count]);
        }
    }
    return self->spread != NULL;
}

const double *clod_specimens_at(const clod_specimens *self, size_t locus,
                                clod_specimens_value value)
{
    return &self->spread[(locus * CLOD_SPECIMENS_VALUES + (size_t)value) * self->count];
}

void clod_specimens_fini(clod_specimens *self)
{
    clod_memory_free(self->seeds);
    clod_memory_free(self->spread);
    *self = (clod_specimens){0};
}

static bool is_in(const clod_curve_point *point, size_t specimen)
{
    return point->spread != NULL && !isnan(point->spread[specimen]);
}

static size_t count_in(const clod_curve_point *point, size_t specimens)
{
    size_t count = 0;
    for (size_t s = 0; s < specimens; s++) {
        count += is_in(point, s) ? 1 : 0;
    }
    return count;
}

static bool share_one(const clod_curve_point *p, const clod_curve_point *q, size_t specimens)
{
    for (size_t s = 0; s < specimens; s++) {
        if (is_in(p, s) && is_in(q, s)) {
            return true;
        }
    }
    return false;
}

/** Number sets: points of one set have the smallest number among them. */
static void number_sets(clod_curve_point *points, size_t count, size_t specimens)
{
    for (size_t i = 0; i < count; i++) {
        points[i].set = i;
    }
    for (size_t round = 0; round < count; round++) { // a chain has at most `count` links
        for (size_t i = 0; i < count; i++) {
            for (size_t k = 0; k < count; k++) {
                if (points[k].set < points[i].set &&
                    share_one(&points[i], &points[k], specimens)) {
                    points[i].set = points[k].set;
                }
            }
        }
    }
}

void clod_specimens_sort(clod_curve_point *points, size_t count, size_t specimens)
{
    number_sets(points, count, specimens);
    for (size_t i = 0; i < count; i++) {
        size_t least = 0;
        for (size_t k = 0; k < count; k++) {
            const size_t in = points[k].set == points[i].set && specimens > 0
                                  ? count_in(&points[k], specimens)
                                  : 0;
            least = in > 1 && (least == 0 || in < least) ? in : least;
        }
        points[i].freedom = least > 0 && points[i].spread != NULL ? least - 1 : 0;
    }
}

double clod_specimens_value_of(double mean, const double *spread, size_t specimens,
                               size_t specimen)
{
    double n = 0.0;
    for (size_t s = 0; s < specimens && spread != NULL; s++) {
        n += isnan(spread[s]) ? 0.0 : 1.0;
    }
    return spread != NULL && n > 1.0 ? mean + sqrt(n * (n - 1.0)) * spread[specimen]
                                     : (double)NAN;
}
