#include "step/trouble.h"

#include <math.h>
#include <stdio.h>

static bool row_is_finite(const double *row, int count)
{
    for (int c = 0; c < count; c++) {
        if (!(fabs(row[c]) < 1e30)) {
            return false;
        }
    }
    return true;
}

static bool report_not_finite(const clod_state *state, clod_status *status)
{
    for (size_t g = 0; g < state->grains.count; g++) {
        if (!row_is_finite(state->grains.place[g], 3) ||
            !row_is_finite(state->grains.motion[g], 3) ||
            !row_is_finite(state->grains.turning[g], 3)) {
            return clod_status_fail(
                status, CLOD_FAILED,
                "step %lld: position, velocity or spin of grain %llu is not a finite number; "
                "the time step (%g s) is most likely too large, see clod check",
                (long long)state->step, (unsigned long long)state->grains.id[g], state->dt);
        }
    }
    return clod_status_fail(status, CLOD_FAILED,
                            "step %lld: a velocity is out of all bounds; the time step (%g s) "
                            "is most likely too large, see clod check",
                            (long long)state->step, state->dt);
}

/** Overlap of two grains as a fraction of the smaller radius. */
static double overlap_fraction(const clod_step *self, int32_t i, int32_t j)
{
    const double *a = self->state->grains.place[i];
    const double *b = self->state->grains.place[j];
    double s2 = 0.0;
    for (int c = 0; c < 3; c++) {
        const double s = clod_domain_separation(&self->state->domain, c, a[c], b[c]);
        s2 += s * s;
    }
    return (a[3] + b[3] - sqrt(s2)) / fmin(a[3], b[3]);
}

static double wall_overlap_fraction(const clod_step *self, const clod_wall_candidate *c)
{
    const double *p = self->state->grains.place[c->i];
    return (p[3] - clod_wall_rows_gap(&self->walls, c->wall, c->shape, p).distance) / p[3];
}

/** The largest overlap there is: of which grain, and with which grain or wall. */
typedef struct worst_overlap {
    double fraction; ///< of the radius; 0: there is none
    int32_t i, j;    ///< j < 0: with a wall
    int32_t wall;
} worst_overlap;

static worst_overlap find_worst(const clod_step *self)
{
    worst_overlap worst = {0};
    const clod_pairs *pairs = &self->neighbour.pairs;
    for (size_t i = 0; i < self->state->grains.count; i++) {
        for (size_t k = pairs->start[i]; k < pairs->start[i + 1]; k++) {
            const int32_t j = (int32_t)pairs->item[k].j;
            const double fraction = overlap_fraction(self, (int32_t)i, j);
            if (fraction > worst.fraction) {
                worst = (worst_overlap){fraction, (int32_t)i, j, -1};
            }
        }
    }
    for (size_t k = 0; k < self->neighbour.walls.count; k++) {
        const clod_wall_candidate *c = &self->neighbour.walls.item[k];
        const double fraction = wall_overlap_fraction(self, c);
        if (fraction > worst.fraction) {
            worst = (worst_overlap){fraction, c->i, -1, c->wall};
        }
    }
    return worst;
}

static bool report_overlap(const clod_step *self, clod_status *status)
{
    const clod_state *state = self->state;
    const worst_overlap worst = find_worst(self);
    if (!(worst.fraction > 0.0)) {
        return clod_status_fail(status, CLOD_FAILED, "step %lld: an overlap is out of range",
                                (long long)state->step);
    }
    const unsigned long long i = (unsigned long long)state->grains.id[worst.i];
    char partner[64];
    if (worst.j >= 0) {
        snprintf(partner, sizeof partner, "grain %llu",
                 (unsigned long long)state->grains.id[worst.j]);
    } else {
        snprintf(partner, sizeof partner, "wall '%s'", state->walls.wall[worst.wall].name);
    }
    return clod_status_fail(
        status, CLOD_FAILED,
        "step %lld: grain %llu overlaps %s by %.1f %% of its radius; the contact laws hold up "
        "to "
        "%.0f %%. Stiffen the contact, lower the load, or take a smaller time step (now %g s)",
        (long long)state->step, i, partner, 100.0 * worst.fraction,
        100.0 * CLOD_KERNEL_OVERLAP_LIMIT, state->dt);
}

bool clod_trouble_report(const clod_step *self, clod_status *status)
{
    for (int t = 0; t < self->threads; t++) {
        if (!self->thread[t].finite) {
            return report_not_finite(self->state, status);
        }
    }
    return report_overlap(self, status);
}
