#include "calibrate/misfit.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/correlate.h"
#include "calibrate/misfit_groups.h"

typedef clod_misfit_group group;

static bool same_group(const group *self, const clod_plan_target *target)
{
    return self->test == target->test && self->held_back == target->held_back;
}

/** Sort targets into groups. */
static bool sort_targets(const clod_plan *plan, clod_misfit *self)
{
    for (size_t t = 0; t < plan->target_count; t++) {
        const clod_plan_target *target = &plan->targets[t];
        size_t g = 0;
        while (g < self->count && !same_group(&self->groups[g], target)) {
            g++;
        }
        group *to = &self->groups[g];
        if (g == self->count) {
            self->count++;
            *to = (group){.test = target->test,
                          .held_back = target->held_back,
                          .targets = clod_memory_alloc(plan->target_count, sizeof(size_t))};
        }
        if (to->targets == NULL) {
            return false;
        }
        to->targets[to->count++] = t;
        self->group_of[t] = g;
    }
    return true;
}

clod_misfit *clod_misfit_create(const clod_misfit_runs *runs)
{
    const clod_plan *plan = runs->plan;
    clod_misfit *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return NULL;
    }
    self->plan = plan;
    self->groups = clod_memory_alloc(plan->target_count, sizeof *self->groups);
    self->group_of = clod_memory_alloc(plan->target_count, sizeof *self->group_of);
    bool good = self->groups != NULL && self->group_of != NULL && sort_targets(plan, self);
    for (size_t g = 0; g < self->count && good; g++) {
        group *of = &self->groups[g];
        of->runs = clod_memory_alloc(of->count * of->count, sizeof(double));
        of->laboratory = clod_memory_alloc(of->count * of->count, sizeof(double));
        of->common = clod_memory_alloc(of->count * of->count, sizeof(double));
        good = of->runs != NULL && of->laboratory != NULL && of->common != NULL &&
               clod_misfit_groups_fill(runs, of);
    }
    if (!good) {
        clod_misfit_destroy(&self);
    }
    return self;
}

void clod_misfit_destroy(clod_misfit **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    for (size_t g = 0; g < (*self)->count; g++) {
        clod_memory_free((*self)->groups[g].targets);
        clod_memory_free((*self)->groups[g].runs);
        clod_memory_free((*self)->groups[g].laboratory);
        clod_memory_free((*self)->groups[g].common);
    }
    clod_memory_free((*self)->groups);
    clod_memory_free((*self)->group_of);
    clod_memory_free(*self);
    *self = NULL;
}

size_t clod_misfit_count(const clod_misfit *self)
{
    return self->count;
}

size_t clod_misfit_room(const clod_misfit *self)
{
    const size_t n = self->plan->target_count;
    return n * n + n + 2 * CLOD_MISFIT_NODES;
}

/** Standard error of a measured value but for what it has in common, where estimated variances are larger by a factor. */
static double own_error(const clod_plan_target *target, double factor)
{
    const double common = target->common.error;
    const double own = common > 0.0
                           ? sqrt(fmax(target->error * target->error - common * common, 0.0))
                           : target->error;
    return own * (target->repeats.estimate ? sqrt(factor) : 1.0);
}

/** Covariance of the measured values of a group about what the surrogates say. */
static void fill_covariance(const clod_misfit *self, const group *of,
                            const clod_surrogate_value *told, double factor, double *v)
{
    const clod_plan_target *targets = self->plan->targets;
    const size_t n = of->count;
    for (size_t a = 0; a < n; a++) {
        const clod_plan_target *one = &targets[of->targets[a]];
        for (size_t b = 0; b <= a; b++) {
            const clod_plan_target *other = &targets[of->targets[b]];
            v[a * n + b] =
                of->laboratory[a * n + b] * own_error(one, factor) * own_error(other, factor) +
                factor * of->common[a * n + b] +
                of->runs[a * n + b] *
                    sqrt(told[of->targets[a]].variance * told[of->targets[b]].variance);
        }
        v[a * n + a] += one->discrepancy * one->discrepancy;
    }
}

/** Chi-square and log density at each node. */
static void look(const clod_misfit *self, const group *of, const clod_surrogate_value *told,
                 double *room, double *chi, double *density)
{
    double *v = room, *x = room + of->count * of->count;
    for (size_t k = 0; k < of->nodes; k++) {
        fill_covariance(self, of, told, of->factors[k], v);
        const double determinant = clod_correlate_factor(v, of->count);
        for (size_t a = 0; a < of->count; a++) {
            x[a] = self->plan->targets[of->targets[a]].value - told[of->targets[a]].mean;
        }
        chi[k] = clod_correlate_distance(v, of->count, x);
        density[k] = -0.5 * (chi[k] + determinant);
    }
}

/** Logarithm of the mean density; densities become that of each node over the largest. */
static double mean_of(double *density, size_t nodes)
{
    double largest = density[0];
    for (size_t k = 1; k < nodes; k++) {
        largest = fmax(largest, density[k]);
    }
    density[0] = exp(density[0] - largest);
    double sum = density[0];
    for (size_t k = 1; k < nodes; k++) {
        density[k] = exp(density[k] - largest);
        sum += density[k];
    }
    return largest + log(sum / (double)nodes);
}

/** Room of the nodes behind that of matrix and vector. */
static double *nodes_in(const clod_misfit *self, double *room)
{
    return room + self->plan->target_count * (self->plan->target_count + 1);
}

double clod_misfit_density(const clod_misfit *self, const clod_surrogate_value *told,
                           double *room)
{
    double *chi = nodes_in(self, room), *density = chi + CLOD_MISFIT_NODES;
    double sum = 0.0;
    for (size_t g = 0; g < self->count; g++) {
        if (!self->groups[g].held_back) {
            look(self, &self->groups[g], told, room, chi, density);
            sum += mean_of(density, self->groups[g].nodes);
        }
    }
    return sum;
}

/** The node that a die falls on, by their weights. */
static size_t choose(const double *weights, size_t nodes, double die)
{
    double sum = 0.0;
    for (size_t k = 0; k < nodes; k++) {
        sum += weights[k];
    }
    size_t k = 0;
    for (double left = die * sum - weights[0]; left > 0.0 && k + 1 < nodes;) {
        left -= weights[++k];
    }
    return k;
}

double clod_misfit_draw(const clod_misfit *self, const clod_surrogate_value *told,
                        const double *dice, double *variances, double *room)
{
    double *chi = nodes_in(self, room), *density = chi + CLOD_MISFIT_NODES;
    double square = 0.0;
    for (size_t g = 0; g < self->count; g++) {
        const group *of = &self->groups[g];
        size_t node =
            (size_t)(dice[g] * (double)of->nodes); // nothing is known of those held back
        if (!of->held_back) {
            look(self, of, told, room, chi, density);
            (void)mean_of(density, of->nodes);
            node = choose(density, of->nodes, dice[g]);
            square += chi[node];
        }
        for (size_t a = 0; a < of->count; a++) {
            const clod_plan_target *target = &self->plan->targets[of->targets[a]];
            const double own = own_error(target, of->factors[node]);
            variances[of->targets[a]] =
                own * own + of->factors[node] * of->common[a * (of->count + 1)] +
                target->discrepancy * target->discrepancy + told[of->targets[a]].variance;
        }
    }
    return square;
}

double clod_misfit_degrees(const clod_misfit *self, size_t target)
{
    return self->groups[self->group_of[target]].degrees;
}

void clod_misfit_correlation(const clod_misfit *self, size_t a, size_t b, double *runs,
                             double *laboratory)
{
    const group *of = &self->groups[self->group_of[a]];
    size_t at = 0, other = 0;
    *runs = *laboratory = 0.0;
    if (self->group_of[a] != self->group_of[b]) {
        return;
    }
    for (size_t k = 0; k < of->count; k++) {
        at = of->targets[k] == a ? k : at;
        other = of->targets[k] == b ? k : other;
    }
    *runs = of->runs[at * of->count + other];
    const clod_plan_target *one = &self->plan->targets[a], *two = &self->plan->targets[b];
    const double common = of->common[at * of->count + other];
    *laboratory = of->laboratory[at * of->count + other];
    if (common > 0.0) {
        *laboratory = (*laboratory * own_error(one, 1.0) * own_error(two, 1.0) + common) /
                      (one->error * two->error);
    }
}
