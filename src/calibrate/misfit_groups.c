/**
 * @file misfit_groups.c
 * Correlations of the targets of one test, from runs and from specimens, and how well errors are known.
 */

#include "calibrate/misfit_groups.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/correlate.h"

/** Packings count as so many specimens at most: that the simulated test copies the laboratory's is a guess. */
#define MOST_FROM_PACKINGS 10.0

typedef clod_misfit_group group;

/** Room for one group. */
typedef struct space {
    double *rows;   ///< [runs or specimens][count]
    double *off;    ///< [runs] of one surrogate
    double *packed; ///< [count][count] correlation of packings
    double *part;   ///< [count][count] of the targets of one table
    double *other;  ///< [count][count]
    double *test;   ///< [count][count] for a factor
    double packed_degrees;
} space;

static const clod_plan_target *target_of(const clod_plan *plan, const group *self, size_t k)
{
    return &plan->targets[self->targets[k]];
}

static bool definite(const double *r, size_t count, double *room)
{
    memcpy(room, r, count * count * sizeof *room);
    return isfinite(clod_correlate_factor(room, count));
}

/** Shrink, and once more where pairs without all rows have left it indefinite. */
static void settle(double *r, size_t count, double degrees, double *room)
{
    do {
        clod_correlate_shrink(r, count, degrees);
    } while (!definite(r, count, room));
}

// ---- runs

/** What the runs are off the surrogates; false without memory. */
static bool take_residuals(const clod_misfit_runs *runs, const group *self, space *at)
{
    const size_t all = runs->points * (size_t)runs->plan->seeds;
    for (size_t k = 0; k < self->count; k++) {
        const size_t t = self->targets[k];
        size_t taken = 0;
        if (runs->surrogates[t] != NULL &&
            !clod_surrogate_residuals(runs->surrogates[t], at->off)) {
            return false;
        }
        for (size_t row = 0; row < all; row++) {
            const bool has = runs->surrogates[t] != NULL &&
                             isfinite(runs->results[row * runs->plan->target_count + t]);
            at->rows[row * self->count + k] = has ? at->off[taken] : (double)NAN;
            taken += has ? 1 : 0;
        }
    }
    return true;
}

/** Coefficients of the surrogates: those of the one with the most. */
static size_t coefficients(const clod_misfit_runs *runs, const group *self)
{
    size_t most = 1;
    for (size_t k = 0; k < self->count; k++) {
        const clod_surrogate *of = runs->surrogates[self->targets[k]];
        const size_t terms = of == NULL ? 1
                                        : clod_surrogate_terms(clod_surrogate_kind_of(of),
                                                               runs->plan->parameter_count);
        most = terms > most ? terms : most;
    }
    return most;
}

/** Packings about the mean of their point, over the noise that the surrogate has there. */
static void take_packings(const clod_misfit_runs *runs, const group *self, double *rows)
{
    const size_t seeds = (size_t)runs->plan->seeds;
    for (size_t k = 0; k < self->count; k++) {
        const clod_surrogate *surrogate = runs->surrogates[self->targets[k]];
        size_t taken = 0;
        for (size_t point = 0; point < runs->points; point++) {
            const double *from =
                runs->results + point * seeds * runs->plan->target_count + self->targets[k];
            double sum = 0.0, count = 0.0;
            for (size_t s = 0; s < seeds; s++) {
                const double value = from[s * runs->plan->target_count];
                sum += isfinite(value) ? value : 0.0;
                count += isfinite(value) ? 1.0 : 0.0;
            }
            const double noise = surrogate != NULL && count > 0.0
                                     ? clod_surrogate_noise_of(surrogate, taken)
                                     : 1.0;
            for (size_t s = 0; s < seeds; s++) { // a missing one stays so
                rows[(point * seeds + s) * self->count + k] =
                    count > 1.0 ? (from[s * runs->plan->target_count] - sum / count) / noise
                                : (double)NAN;
            }
            taken += (size_t)count;
        }
    }
}

static bool fill_runs(const clod_misfit_runs *runs, group *self, space *at)
{
    const size_t all = runs->points * (size_t)runs->plan->seeds;
    clod_correlate_rows of = {.values = at->rows,
                              .rows = all,
                              .count = self->count,
                              .block = all,
                              .lost = coefficients(runs, self)};
    if (!take_residuals(runs, self, at)) {
        return false;
    }
    const double degrees = clod_correlate(&of, self->runs);
    clod_correlate_complete(self->runs, NULL, self->count);
    settle(self->runs, self->count, degrees, at->test);
    take_packings(runs, self, at->rows);
    of.block = (size_t)runs->plan->seeds;
    of.lost = 0;
    at->packed_degrees = clod_correlate(&of, at->packed);
    clod_correlate_complete(at->packed, NULL, self->count);
    return true;
}

// ---- the laboratory

/** Specimens of a point whose numbers are known. */
static size_t kept_of(const clod_plan_repeats *self)
{
    return self->count < CLOD_PLAN_SPECIMENS ? self->count : CLOD_PLAN_SPECIMENS;
}

/** Specimens that two points have in common, over the root of the product of how many each has. */
static double in_common(const clod_plan_repeats *a, const clod_plan_repeats *b)
{
    double common = 0.0;
    for (size_t k = 0; k < kept_of(a); k++) {
        for (size_t m = 0; m < kept_of(b); m++) {
            common += a->differences[k].specimen == b->differences[m].specimen ? 1.0 : 0.0;
        }
    }
    return common > 0.0 ? common / sqrt((double)kept_of(a) * (double)kept_of(b)) : 0.0;
}

/** The row of a specimen among those taken so far, or a new one. */
static size_t row_of(int64_t specimen, int64_t *specimens, size_t *count)
{
    for (size_t k = 0; k < *count; k++) {
        if (specimens[k] == specimen) {
            return k;
        }
    }
    specimens[*count] = specimen;
    return (*count)++;
}

/**
 * What specimens differ by, each in a row: those of the targets `members`.
 *
 * @return rows; 0: a specimen was measured twice at one stress, or the table does not tell them apart
 */
static size_t take_specimens(const clod_plan *plan, const group *self, const size_t *members,
                             size_t count, double *rows, int64_t *specimens)
{
    size_t found = 0;
    for (size_t k = 0; k < CLOD_PLAN_SPECIMENS * count * count; k++) {
        rows[k] = (double)NAN;
    }
    for (size_t k = 0; k < count; k++) {
        const clod_plan_repeats *of = &target_of(plan, self, members[k])->repeats;
        for (size_t s = 0; s < kept_of(of) && of->count > 1;
             s++) { // one alone differs from none
            const size_t row = row_of(of->differences[s].specimen, specimens, &found);
            if (isfinite(rows[row * count + k])) {
                return 0;
            }
            rows[row * count + k] = of->differences[s].value;
        }
    }
    return found;
}

/** Targets of the group from one table. @return how many */
static size_t find_members(const clod_plan *plan, const group *self, size_t table,
                           size_t *members)
{
    size_t count = 0;
    for (size_t k = 0; k < self->count; k++) {
        if (target_of(plan, self, k)->table == table) {
            members[count++] = k;
        }
    }
    return count;
}

/** Correlations of what errors have beside those of their mean preshears: these are taken out of the mean correlation, as
 *  they are counted by themselves. */
static void take_out_preshears(const clod_plan *plan, const group *self, const size_t *members,
                               size_t count, double *r)
{
    double all = 0.0, known = 0.0, pairs = 0.0;
    for (size_t a = 0; a < count; a++) {
        const clod_plan_target *one = target_of(plan, self, members[a]);
        for (size_t b = 0; b < a; b++) {
            const clod_plan_target *other = target_of(plan, self, members[b]);
            all += r[a * count + b];
            known += one->common.error * other->common.error / (one->error * other->error);
            pairs += 1.0;
        }
    }
    if (known <= 0.0) {
        return;
    }
    const double kept = all > known ? (all - known) / (pairs - known) * pairs / all : 0.0;
    for (size_t k = 0; k < count * count; k++) {
        r[k] *= k % (count + 1) == 0 ? 1.0 : kept; // positive definite, as kept is at most 1
    }
}

/** Correlations of the targets of one table, whose specimens recur: those of one specimen's numbers, times the
 *  specimens that two points have in common. */
static void fill_table(const clod_plan *plan, group *self, size_t *members, size_t count,
                       int64_t *specimens, space *at)
{
    const size_t n = self->count;
    const clod_correlate_rows of = {
        .values = at->rows,
        .rows = take_specimens(plan, self, members, count, at->rows, specimens),
        .count = count,
        .block = CLOD_PLAN_SPECIMENS * count};
    double degrees = clod_correlate(&of, at->part);
    if (degrees <= 0.0) {
        return;
    }
    for (size_t k = 0; k < count * count; k++) {
        at->other[k] = at->packed[members[k / count] * n + members[k % count]];
    }
    clod_correlate_complete(at->part, at->packed_degrees > 0.0 ? at->other : NULL, count);
    degrees = clod_correlate_join(at->part, degrees, at->other,
                                  fmin(at->packed_degrees, MOST_FROM_PACKINGS), count);
    settle(at->part, count, degrees, at->test);
    take_out_preshears(plan, self, members, count, at->part);
    for (size_t k = 0; k < count * count; k++) {
        const size_t a = members[k / count], b = members[k % count];
        const double common =
            in_common(&target_of(plan, self, a)->repeats, &target_of(plan, self, b)->repeats);
        self->laboratory[a * n + b] = a == b ? 1.0 : common * at->part[k];
    }
}

/** What two points have in common by the mean preshears that prorated them: all, of the same seeds. */
static double of_preshears(const clod_plan_target *a, const clod_plan_target *b)
{
    const double common = a->common.error * b->common.error;
    return common > 0.0 && a->table == b->table
               ? common * fmin(in_common(&a->repeats, &b->repeats), 1.0)
               : 0.0;
}

/** Correlation of two estimates of variances, as a root: so much of it comes of specimens in common. */
static double of_variances(const clod_plan *plan, const group *self, size_t a, size_t b)
{
    const double common =
        in_common(&target_of(plan, self, a)->repeats, &target_of(plan, self, b)->repeats);
    return a == b         ? 1.0
           : common > 0.0 ? self->laboratory[a * self->count + b] / sqrt(common)
                          : 0.0;
}

/** Degrees of freedom of the errors of one entry of the plan: of all its points with repeats, where they were
 *  pooled, or of the one with the fewest. */
static double degrees_of(const clod_plan *plan, const group *self, size_t entry, space *at,
                         size_t *members)
{
    size_t count = 0, fewest = 0;
    bool estimate = false, pooled = true;
    for (size_t k = 0; k < self->count; k++) {
        const clod_plan_target *of = target_of(plan, self, k);
        if (of->entry == entry && of->repeats.count > 1) {
            fewest = count == 0 || of->repeats.count < fewest ? of->repeats.count : fewest;
            members[count++] = k;
            pooled = pooled && of->repeats.pooled;
        }
        estimate = estimate || (of->entry == entry && of->repeats.estimate);
    }
    if (!estimate || count == 0) {
        return (double)INFINITY;
    }
    for (size_t k = 0; k < count * count; k++) {
        at->part[k] = of_variances(plan, self, members[k / count], members[k % count]);
    }
    return pooled ? clod_correlate_pooled(at->part, count, (double)fewest - 1.0)
                  : (double)fewest - 1.0;
}

/** Equally likely variances over the estimated one: nu/chi-square. */
static void fill_factors(group *self)
{
    self->nodes = isfinite(self->degrees) ? CLOD_MISFIT_NODES : 1;
    self->factors[0] = 1.0;
    for (size_t k = 0; k < self->nodes && self->nodes > 1; k++) {
        const double share = ((double)k + 0.5) / (double)self->nodes;
        self->factors[k] = self->degrees / gsl_cdf_chisq_Pinv(share, self->degrees);
    }
}

static void fill_laboratory(const clod_plan *plan, group *self, size_t *members,
                            int64_t *specimens, space *at)
{
    const size_t n = self->count;
    for (size_t k = 0; k < n * n; k++) {
        self->laboratory[k] = k % (n + 1) == 0 ? 1.0 : 0.0;
        self->common[k] =
            of_preshears(target_of(plan, self, k / n), target_of(plan, self, k % n));
    }
    for (size_t k = 0; k < n; k++) {
        const size_t table = target_of(plan, self, k)->table;
        const size_t count = table > 0 ? find_members(plan, self, table, members) : 0;
        if (count > 1 && members[0] == k) {
            fill_table(plan, self, members, count, specimens, at);
        }
    }
    self->degrees = (double)INFINITY;
    for (size_t k = 0; k < n; k++) {
        const clod_plan_target *of = target_of(plan, self, k);
        self->degrees = fmin(self->degrees, degrees_of(plan, self, of->entry, at, members));
        if (of->common.error > 0.0) {
            self->degrees = fmin(self->degrees, of->common.degrees);
        }
    }
    fill_factors(self);
}

bool clod_misfit_groups_fill(const clod_misfit_runs *runs, clod_misfit_group *self)
{
    const size_t n = self->count;
    const size_t all = runs->points * (size_t)runs->plan->seeds;
    const size_t specimens = CLOD_PLAN_SPECIMENS * n;
    space at = {.rows =
                    clod_memory_alloc(n * (all > specimens ? all : specimens), sizeof(double)),
                .off = clod_memory_alloc(all, sizeof(double)),
                .packed = clod_memory_alloc(n * n, sizeof(double)),
                .part = clod_memory_alloc(n * n, sizeof(double)),
                .other = clod_memory_alloc(n * n, sizeof(double)),
                .test = clod_memory_alloc(n * n, sizeof(double))};
    size_t *members = clod_memory_alloc(n, sizeof *members);
    int64_t *names = clod_memory_alloc(specimens, sizeof *names);
    bool good = at.rows != NULL && at.off != NULL && at.packed != NULL && at.part != NULL &&
                at.other != NULL && at.test != NULL && members != NULL && names != NULL;
    if (good) {
        good = fill_runs(runs, self, &at);
    }
    if (good) {
        fill_laboratory(runs->plan, self, members, names, &at);
    }
    clod_memory_free(at.rows);
    clod_memory_free(at.off);
    clod_memory_free(at.packed);
    clod_memory_free(at.part);
    clod_memory_free(at.other);
    clod_memory_free(at.test);
    clod_memory_free(members);
    clod_memory_free(names);
    return good;
}
