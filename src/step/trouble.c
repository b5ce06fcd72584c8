#include "step/trouble.h"

#include <math.h>
#include <stdio.h>

#include "clod/case.h"
#include "law/law_kinds.h"
#include "law/law_springs.h"

#define LARGE_STEP 0.25 ///< of the critical step: six steps for half a swing
#define GOOD_STEP 0.1   ///< as time.safety

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
        if (!row_is_finite(state->grains.position[g], 3) ||
            !row_is_finite(state->grains.velocity[g], 3) ||
            !row_is_finite(state->grains.angular_velocity[g], 3)) {
            return clod_status_fail(
                status, CLOD_FAILED,
                "step %lld: position, velocity or spin of grain %llu is not a finite number; "
                "the time step (%g s) is most likely too large, see clod check",
                (long long)state->step, (unsigned long long)state->grains.id[g], state->dt);
        }
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_vec3 force = state->walls.wall[w].force;
        if (!isfinite(force.x + force.y + force.z)) {
            return clod_status_fail(
                status, CLOD_FAILED,
                "step %lld: the force on wall '%s' is not a finite number, or beyond 4e15 N; "
                "the time step (%g s) is most likely too large, see clod check",
                (long long)state->step, state->walls.wall[w].name, state->dt);
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
    const double *a = self->state->grains.position[i];
    const double *b = self->state->grains.position[j];
    double s2 = 0.0;
    for (int c = 0; c < 3; c++) {
        const double s = clod_domain_separation(&self->state->domain, c, a[c], b[c]);
        s2 += s * s;
    }
    return (a[3] + b[3] - sqrt(s2)) / fmin(a[3], b[3]);
}

static double wall_overlap_fraction(const clod_step *self, const clod_wall_candidate *c)
{
    const double *p = self->state->grains.position[c->i];
    return (p[3] - clod_wall_rows_gap(&self->walls, c->wall, c->shape, p).distance) / p[3];
}

/** The largest overlap there is: of which grain, and with which grain or wall. */
typedef struct worst_overlap {
    double fraction; ///< of the radius; 0: there is none
    int32_t i, j;    ///< j < 0: with a wall
    int32_t wall, shape;
    uint64_t id[2]; ///< as in clod_step_trouble
} worst_overlap;

/** Of two as deep the one with the lower ids: no rank sees the whole order. */
static bool is_deeper(double fraction, const uint64_t id[2], double than, const uint64_t of[2])
{
    return fraction > than ||
           (fraction == than && (id[0] < of[0] || (id[0] == of[0] && id[1] < of[1])));
}

static void compare(worst_overlap *worst, const worst_overlap *other)
{
    if (other->fraction > 0.0 &&
        is_deeper(other->fraction, other->id, worst->fraction, worst->id)) {
        *worst = *other;
    }
}

static worst_overlap find_worst(const clod_step *self)
{
    worst_overlap worst = {0};
    const uint64_t *id = self->state->grains.id;
    const clod_pairs *pairs = &self->neighbour.pairs;
    for (size_t i = 0; i < self->state->grains.count; i++) {
        for (size_t k = pairs->start[i]; k < pairs->start[i + 1]; k++) {
            const int32_t j = (int32_t)pairs->item[k].j;
            const worst_overlap one = {
                overlap_fraction(self, (int32_t)i, j), (int32_t)i, j, -1, -1, {id[i], id[j]}};
            compare(&worst, &one);
        }
    }
    for (size_t k = 0; k < self->neighbour.walls.count; k++) {
        const clod_wall_candidate *c = &self->neighbour.walls.item[k];
        const worst_overlap one = {wall_overlap_fraction(self, c),
                                   c->i,
                                   -1,
                                   c->wall,
                                   c->shape,
                                   {id[c->i], CLOD_TROUBLE_WALLS + (uint64_t)c->wall}};
        compare(&worst, &one);
    }
    return worst;
}

/** The other wall that the grain of the deepest contact overlaps at least half as far; -1: none. */
static int32_t find_opposite(const clod_step *self, const worst_overlap *worst)
{
    double most = 0.5 * worst->fraction;
    int32_t wall = -1;
    for (size_t k = 0; worst->j < 0 && k < self->neighbour.walls.count; k++) {
        const clod_wall_candidate *c = &self->neighbour.walls.item[k];
        const double fraction = wall_overlap_fraction(self, c);
        if (c->i == worst->i && c->wall != worst->wall && fraction > most) {
            most = fraction;
            wall = c->wall;
        }
    }
    return wall;
}

/** The deepest contact with its law. */
typedef struct deep_contact {
    const clod_law *law;
    double overlap, r_star; ///< m
    double m_star;          ///< kg
} deep_contact;

static deep_contact describe(const clod_step *self, const worst_overlap *worst)
{
    const clod_grains *grains = &self->state->grains;
    const double a = grains->position[worst->i][3];
    const double mass = grains->velocity[worst->i][3];
    const bool wall = worst->j < 0;
    const int32_t material =
        wall ? clod_wall_material(&self->state->walls.wall[worst->wall], worst->shape)
             : grains->material[worst->j];
    const int32_t law = clod_laws_index(self->laws, grains->material[worst->i], material);
    deep_contact deep = {.law = &self->laws->law[law], .r_star = a, .m_star = mass};
    deep.overlap = worst->fraction * a;
    if (!wall) {
        const double b = grains->position[worst->j][3];
        const double other = grains->velocity[worst->j][3];
        deep.overlap = worst->fraction * fmin(a, b);
        deep.r_star = a * b / (a + b);
        deep.m_star = mass * other / (mass + other);
    }
    return deep;
}

/** Largest stable step of a contact as deep as it is [s]: of k2, or of the tangential spring.
 */
static double critical_step(const deep_contact *deep)
{
    const clod_law *law = deep->law;
    const double loading = clod_law_tangent(law, deep->overlap, deep->r_star);
    const double tangential = clod_law_springs_tangential(law, loading);
    const double slip = law->friction > 0.0 ? 3.5 * tangential : 0.0; // on 2/7 of the mass
    const double press = clod_law_stiffest(law, deep->overlap, deep->r_star);
    return 2.0 * sqrt(deep->m_star / fmax(press, slip));
}

/** What to do about the deepest contact: where it is new, where the step is too large for it,
 *  where another wall leaves the grain no room, and where it is too soft. */
static void advise(const clod_step *self, const worst_overlap *worst, char *text, size_t size)
{
    const deep_contact deep = describe(self, worst);
    const double dt = self->state->dt;
    const double critical = critical_step(&deep);
    const int32_t opposite = find_opposite(self, worst);
    const bool in_range = worst->fraction < CLOD_CASE_OVERLAP_MOST; // a limit can allow it
    if (self->state->step == self->begin) {                         // before any step was made
        snprintf(text, size, "They are put so: move them apart%s",
                 in_range ? ". If so deep a contact is meant, raise time.overlap_limit" : "");
    } else if (dt > LARGE_STEP * critical) {
        snprintf(text, size,
                 "The time step, %.3g s, is too large: %.2g of the critical step of this "
                 "contact as deep as it is, %.3g s. Take time.step: auto, or at most %.2g s; "
                 "when it is auto, time.design_stress for the load that comes",
                 dt, dt / critical, critical, GOOD_STEP * critical);
    } else if (opposite >= 0) {
        snprintf(text, size,
                 "It is caught between walls '%s' and '%s': make the gap between them narrower "
                 "than a grain's radius or wider than a grain, or change how they move%s",
                 self->state->walls.wall[worst->wall].name,
                 self->state->walls.wall[opposite].name,
                 in_range ? ". If so deep a contact is meant, raise time.overlap_limit" : "");
    } else {
        snprintf(text, size,
                 "The time step is not the reason (%.2g of the critical step of this contact): "
                 "it is too soft for its load, some %.3g N. Raise %s, lower the load or the "
                 "speed%s",
                 dt / critical, clod_law_cycle_force(deep.law, deep.r_star, deep.overlap),
                 clod_law_kinds_row(deep.law->kind)->stiffness_keys,
                 in_range ? ", or, if so deep a contact is meant, raise time.overlap_limit"
                          : "");
    }
}

static bool report_overlap(const clod_step *self, const worst_overlap *worst,
                           clod_status *status)
{
    const clod_state *state = self->state;
    if (!(worst->fraction > 0.0)) {
        return clod_status_fail(status, CLOD_FAILED, "step %lld: an overlap is out of range",
                                (long long)state->step);
    }
    char partner[64];
    char advice[400];
    if (worst->j >= 0) {
        snprintf(partner, sizeof partner, "grain %llu", (unsigned long long)worst->id[1]);
    } else {
        snprintf(partner, sizeof partner, "wall '%s'", state->walls.wall[worst->wall].name);
    }
    advise(self, worst, advice, sizeof advice);
    return clod_status_fail(status, CLOD_FAILED,
                            "step %lld: grain %llu overlaps %s by %.1f %% of the radius%s; "
                            "time.overlap_limit is %.3g %%. %s",
                            (long long)state->step, (unsigned long long)worst->id[0], partner,
                            100.0 * worst->fraction, worst->j >= 0 ? " of the smaller one" : "",
                            100.0 * self->view.overlap_limit, advice);
}

void clod_trouble_note(clod_step *self)
{
    clod_step_trouble *trouble = &self->trouble;
    const worst_overlap worst = find_worst(self);
    trouble->any = true;
    trouble->step = self->state->step;
    trouble->fraction = worst.fraction;
    trouble->id[0] = worst.id[0];
    trouble->id[1] = worst.id[1];
    report_overlap(self, &worst, &trouble->status);
}

bool clod_trouble_comes_first(const clod_step_trouble *a, const clod_step_trouble *b)
{
    if (!a->any || !b->any || a->step != b->step) {
        return a->any && (!b->any || a->step < b->step);
    }
    return is_deeper(a->fraction, a->id, b->fraction, b->id);
}

bool clod_trouble_report(const clod_step *self, clod_status *status)
{
    if (self->trouble.any) {
        *status = self->trouble.status;
        return false;
    }
    for (int t = 0; t < self->threads; t++) {
        if (!self->thread[t].finite) {
            return report_not_finite(self->state, status);
        }
    }
    const worst_overlap worst = find_worst(self);
    return report_overlap(self, &worst, status);
}
