#include "step/passages.h"

#include <math.h>
#include <string.h>

#include "step/near_skins.h"
#include "step/spread.h"

_Static_assert(CLOD_PASSAGE_ROWS >= CLOD_NEAR_WATCHED, "a watch is looked at together");

#define ROUNDING 1e-12 ///< relative, of places and ways, generously

/** Length of a plane's period [m]; 0: it has none. */
static double period_of(const clod_plane *plane, const clod_domain *domain)
{
    const int a = plane->axis;
    return domain->periodic[a] ? domain->max[a] - domain->min[a] : 0.0;
}

/** Way from a coordinate to the nearest image of a plane [m]. */
static double way_to(const clod_plane *plane, const clod_domain *domain, double x)
{
    const double way = fabs(clod_domain_within(domain, plane->axis, x) - plane->at);
    const double period = period_of(plane, domain);
    return period > 0.0 ? fmin(way, period - way) : way;
}

static bool is_odd(double level)
{
    const double half = 0.5 * level;
    return half != floor(half);
}

/** What there is to know of rows and a plane now. */
static clod_passage look(const clod_plane *plane, const clod_state *state, size_t first,
                         size_t rows)
{
    const int a = plane->axis;
    const clod_domain *domain = &state->domain;
    clod_passage seen = {.way = HUGE_VAL};
    for (size_t k = 0; k < rows; k++) {
        const double x = state->grains.position[first + k][a];
        const uint64_t odd = is_odd(clod_plane_level(plane, domain, x));
        seen.way = fmin(seen.way, way_to(plane, domain, x));
        seen.odd |= odd << k;
    }
    seen.way -= ROUNDING * (fabs(plane->at) + fabs(domain->min[a]) + fabs(domain->max[a]));
    return seen;
}

void clod_passages_note(clod_passage *seen, const clod_state *state, size_t first, size_t rows)
{
    for (int32_t p = 0; p < state->planes.count; p++) {
        seen[p] = look(&state->planes.plane[p], state, first, rows);
    }
}

/** Whether a grain that has just passed a plane did so within its region. */
static bool passed_within(const clod_plane *plane, const clod_state *state, size_t row)
{
    const int axis = plane->axis;
    const clod_domain *domain = &state->domain;
    const double *at = state->grains.position[row], *v = state->grains.velocity[row];
    double beyond = clod_domain_within(domain, axis, at[axis]) - plane->at;
    beyond = v[axis] > 0.0 ? beyond : -beyond;
    if (beyond < 0.0) { // the nearest image that is behind
        beyond += period_of(plane, domain);
    }
    const double since = fmin(beyond / fabs(v[axis]), state->dt); // s, for which it is beyond
    double point[3];
    for (int a = 0; a < 3; a++) {
        point[a] = a == axis ? plane->at : clod_domain_within(domain, a, at[a] - since * v[a]);
    }
    return clod_outlet_has(&plane->region, point);
}

/** Rows of a look that have passed the plane, as bits. */
static void count_rows(clod_passed *passed, const clod_plane *plane, const clod_state *state,
                       uint64_t changed, size_t first)
{
    const double(*velocity)[4] = (const double(*)[4])state->grains.velocity;
    for (size_t g = first; changed != 0; changed >>= 1, g++) {
        if ((changed & 1) == 0 || !passed_within(plane, state, g)) {
            continue;
        }
        const int way = velocity[g][plane->axis] * plane->sign > 0.0 ? CLOD_PASSED_FORWARD
                                                                     : CLOD_PASSED_BACK;
        passed->grains[way]++;
        clod_exact_add(&passed->mass[way], velocity[g][3]);
    }
}

void clod_passages_count(clod_passed *passed, clod_passage *seen, const clod_state *state,
                         double speed, size_t first, size_t rows)
{
    // rounding makes no way longer than twice what it should be: it has whole last digits
    const double most = 2.0 * speed * state->dt;
    for (int32_t p = 0; p < state->planes.count; p++) {
        seen[p].way -= most;
        if (seen[p].way > 0.0) {
            continue;
        }
        const clod_plane *plane = &state->planes.plane[p];
        const clod_passage now = look(plane, state, first, rows);
        count_rows(&passed[p], plane, state, now.odd ^ seen[p].odd, first);
        seen[p] = now;
    }
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
