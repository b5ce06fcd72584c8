/**
 * @file surrogate_out.c
 * A surrogate with a point less: how well the others predict it.
 */

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/surrogate_fit.h"

/** The runs of a surrogate. */
static clod_surrogate_runs runs_of(const clod_surrogate *self)
{
    return (clod_surrogate_runs){self->dimensions, self->count, self->inputs, self->results,
                                 NULL};
}

/** A surrogate of other runs with the hyperparameters and the variance of this one. */
static clod_surrogate *with(const clod_surrogate *self, const clod_surrogate_runs *runs,
                            clod_status *status)
{
    clod_surrogate *other = clod_surrogate_create_at(runs, self->kind, &self->hyper, status);
    if (other != NULL) {
        other->variance = self->variance;
    }
    return other;
}

clod_surrogate *clod_surrogate_copy(const clod_surrogate *self, clod_status *status)
{
    const clod_surrogate_runs runs = runs_of(self);
    return with(self, &runs, status);
}

/** Sums over the points that are left out. */
typedef struct sums {
    double square, about, covered, points;
} sums;

/** The point of a run: mean of its packings and their number, the others into `points` and `results`. */
static clod_surrogate_runs without(const clod_surrogate *self, size_t row, double *points,
                                   double *results, double *mean, double *packings)
{
    const size_t d = self->dimensions;
    const double *out = self->inputs + row * d;
    size_t kept = 0;
    *mean = 0.0;
    *packings = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        if (memcmp(self->inputs + i * d, out, d * sizeof *out) == 0) {
            *mean += self->results[i];
            *packings += 1.0;
        } else {
            memcpy(points + kept * d, self->inputs + i * d, d * sizeof *points);
            results[kept++] = self->results[i];
        }
    }
    *mean /= *packings;
    return (clod_surrogate_runs){d, kept, points, results, NULL};
}

/** Leave out the point of a run, unless an earlier run has it. */
static bool leave(const clod_surrogate *self, size_t row, double centre, double *points,
                  double *room, sums *to, clod_status *status)
{
    const size_t d = self->dimensions;
    const double *out = self->inputs + row * d;
    for (size_t i = 0; i < row; i++) {
        if (memcmp(self->inputs + i * d, out, d * sizeof *out) == 0) {
            return true;
        }
    }
    double mean, packings;
    const clod_surrogate_runs others =
        without(self, row, points, points + self->count * d, &mean, &packings);
    clod_surrogate *left = with(self, &others, status);
    if (left == NULL) {
        return false;
    }
    const clod_surrogate_value told = clod_surrogate_at(left, out, room);
    const double noise =
        self->kind == CLOD_SURROGATE_GAUSSIAN ? clod_surrogate_noise(self, out) : 0.0;
    const double error = mean - told.mean;
    const double deviation = sqrt(told.variance + noise * noise / packings);
    to->square += error * error;
    to->about += (mean - centre) * (mean - centre);
    to->covered += fabs(error) <= 2.0 * deviation ? 1.0 : 0.0;
    to->points += 1.0;
    clod_surrogate_destroy(&left);
    return true;
}

bool clod_surrogate_leave_one_out(const clod_surrogate *self, const clod_stop *stop,
                                  clod_surrogate_check *check, clod_status *status)
{
    double *points = clod_memory_alloc(self->count * (self->dimensions + 1), sizeof *points);
    double *room = clod_memory_alloc(clod_surrogate_room(self), sizeof *room);
    sums all = {0};
    double centre = 0.0;
    for (size_t i = 0; i < self->count; i++) {
        centre += self->results[i] / (double)self->count;
    }
    bool good = points != NULL && room != NULL;
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "No memory for a surrogate's check.");
    }
    for (size_t i = 0; i < self->count && good; i++) {
        good = clod_stop_asked(stop) ? clod_stop_fail(status)
                                     : leave(self, i, centre, points, room, &all, status);
    }
    const clod_surrogate_runs runs = runs_of(self);
    *check = (clod_surrogate_check){.points = clod_surrogate_points(&runs),
                                    .error = sqrt(all.square / all.points),
                                    .q2 = 1.0 - all.square / all.about,
                                    .scatter = sqrt(all.about / all.points),
                                    .covered = all.covered / all.points};
    clod_memory_free(points);
    clod_memory_free(room);
    return good;
}
