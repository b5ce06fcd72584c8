#include "step/passages.h"

#include <math.h>
#include <string.h>

#include "step/spread.h"

/** Passages in one step from which on they are no number of passages, but of a run that has gone wrong. */
#define MANY 1e9
#define ROUNDING 1e-12 ///< relative, of places and ways

/** Share of the way from one coordinate to another that is behind at the first passage. */
static double share_before(const clod_plane *plane, const clod_domain *domain, double from,
                           double to)
{
    const int a = plane->axis;
    const double period = domain->periodic[a] ? domain->max[a] - domain->min[a] : 0.0;
    double gap = plane->at - clod_domain_within(domain, a, from);
    if (to > from && gap <= 0.0) { // the next image is ahead
        gap += period;
    } else if (to < from && gap > 0.0) {
        gap -= period;
    }
    return fmin(fmax(gap / (to - from), 0.0), 1.0);
}

/** Whether a grain passes a plane within its region. */
static bool passes_within(const clod_plane *plane, const clod_domain *domain,
                          const double from[4], const double to[4])
{
    const double share = share_before(plane, domain, from[plane->axis], to[plane->axis]);
    double point[3];
    for (int a = 0; a < 3; a++) {
        point[a] = a == plane->axis
                       ? plane->at
                       : clod_domain_within(domain, a, from[a] + share * (to[a] - from[a]));
    }
    return clod_outlet_has(&plane->region, point);
}

/** Way from a coordinate to the nearest image of a plane [m]. */
static double way_to(const clod_plane *plane, const clod_domain *domain, double x)
{
    const int a = plane->axis;
    const double way = fabs(clod_domain_within(domain, a, x) - plane->at);
    return domain->periodic[a] ? fmin(way, domain->max[a] - domain->min[a] - way) : way;
}

/** Rounding of ways to a plane, generously [m]. */
static double rounding_of(const clod_plane *plane, const clod_domain *domain)
{
    const int a = plane->axis;
    return ROUNDING * (fabs(plane->at) + fabs(domain->min[a]) + fabs(domain->max[a]));
}

/** @return  m, the least way to the plane that is left */
static double count_one(clod_passed *passed, const clod_plane *plane, const clod_domain *domain,
                        const double (*before)[4], const clod_grains *grains, size_t first,
                        size_t rows)
{
    const int a = plane->axis;
    double least = HUGE_VAL;
    for (size_t k = 0; k < rows; k++) {
        const double *to = grains->position[first + k];
        least = fmin(least, way_to(plane, domain, to[a]));
        const double passages = clod_plane_level(plane, domain, to[a]) -
                                clod_plane_level(plane, domain, before[k][a]);
        const double times = fabs(passages);
        if (!(times > 0.0 && times < MANY) || !passes_within(plane, domain, before[k], to)) {
            continue;
        }
        const int way = passages * plane->sign > 0.0 ? CLOD_PASSED_FORWARD : CLOD_PASSED_BACK;
        passed->grains[way] += (int64_t)times;
        clod_exact_add(&passed->mass[way], times * grains->velocity[first + k][3]);
    }
    return least - rounding_of(plane, domain);
}

double clod_passages_count(clod_passed *passed, const clod_state *state,
                           const double (*before)[4], size_t first, size_t rows)
{
    double least = HUGE_VAL;
    for (int32_t p = 0; p < state->planes.count; p++) {
        const double way = count_one(&passed[p], &state->planes.plane[p], &state->domain,
                                     before, &state->grains, first, rows);
        least = fmin(least, way);
    }
    return least;
}

void clod_passages_merge(clod_passed *into, const clod_passed *from, int32_t count)
{
    for (int32_t p = 0; p < count; p++) {
        for (int way = 0; way < CLOD_PASSED_WAYS; way++) {
            into[p].grains[way] += from[p].grains[way];
            clod_exact_merge(&into[p].mass[way], &from[p].mass[way]);
        }
    }
}

static void merge_ranks(const void *context, void *into, const void *from)
{
    const clod_planes *planes = context;
    clod_passages_merge(into, from, planes->count);
}

/** What all threads of all ranks have counted in these steps, onto the sums of the state. */
void clod_step_passages(clod_step *self, int part)
{
    clod_planes *planes = &self->state->planes;
    if (part != 0 || self->passed == NULL) {
        return;
    }
    const size_t count = (size_t)planes->count;
    for (size_t t = 1; t < (size_t)self->threads; t++) {
        clod_passages_merge(self->passed, self->passed + t * count, planes->count);
    }
    if (self->spread != NULL) {
        clod_ranks_merge(self->spread->ranks, self->passed, count * sizeof *self->passed,
                         merge_ranks, planes);
    }
    clod_passages_merge(planes->passed, self->passed, planes->count);
    for (size_t p = 0; p < count; p++) {
        for (int way = 0; way < CLOD_PASSED_WAYS; way++) {
            clod_exact_settle(&planes->passed[p].mass[way]);
        }
    }
    memset(self->passed, 0, (size_t)self->threads * count * sizeof *self->passed);
}
