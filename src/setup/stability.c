#include "setup/stability.h"

#include <math.h>
#include <string.h>

#include "base/lanczos.h"
#include "base/memory.h"
#include "base/random.h"
#include "geometry/wall_rows.h"
#include "law/law_forms.h"
#include "law/law_kinds.h"
#include "law/law_springs.h"
#include "state/contact_walk.h"

#define FREEDOMS 6 ///< of a grain: it moves and turns
#define STEPS 12   ///< most tries for the largest step
#define CLOSE 1e-5 ///< of the eigenvalue

/** Stiffness and dash-pot in one direction of a contact. */
typedef struct spring {
    double stiffness; ///< N/m; rolling: N m/rad
    double dash_pot;  ///< N s/m; rolling: N m s
} spring;

/** A contact as springs between two grains, or of one with a wall (j < 0). */
typedef struct bond {
    int32_t i, j;
    clod_vec3 normal;
    double arm_i, arm_j; ///< m
    spring push, slip, roll;
} bond;

/** All springs of a bed, as dt^2/4 K + dt/2 C by masses. */
typedef struct bed {
    size_t grains, count, room;
    bond *bonds;        ///< owned [room]
    double (*scale)[2]; ///< owned [grains] 1/sqrt of mass [kg] and of moment of inertia [kg m2]
    double by_stiffness, by_dash_pot; ///< dt^2/4 and dt/2
} bed;

/** What a contact's stiffnesses follow from. */
typedef struct meeting {
    double overlap, m_star, r_star, roll_inertia;
} meeting;

static clod_vec3 scaled_part(const double *x, double scale)
{
    return (clod_vec3){scale * x[0], scale * x[1], scale * x[2]};
}

static void add_part(double *y, double scale, clod_vec3 v)
{
    y[0] += scale * v.x;
    y[1] += scale * v.y;
    y[2] += scale * v.z;
}

static double factor(const bed *self, spring s)
{
    return self->by_stiffness * s.stiffness + self->by_dash_pot * s.dash_pot;
}

static clod_vec3 across(clod_vec3 v, clod_vec3 normal)
{
    return clod_vec3_axpy(v, -clod_vec3_dot(v, normal), normal);
}

/** Forces of one contact on its grains, signs turned: as the kernel adds them (kernel_contact.h). */
static void add_bond(const bed *self, const bond *b, const double *x, double *y)
{
    const double *scale_i = self->scale[b->i];
    const double *at_i = x + FREEDOMS * b->i;
    const clod_vec3 n = b->normal;
    clod_vec3 apart = scaled_part(at_i, scale_i[0]);
    clod_vec3 turn = scaled_part(at_i + 3, scale_i[1]);
    clod_vec3 arms = clod_vec3_scale(turn, b->arm_i);
    if (b->j >= 0) {
        const double *scale_j = self->scale[b->j];
        const double *at_j = x + FREEDOMS * b->j;
        const clod_vec3 turn_j = scaled_part(at_j + 3, scale_j[1]);
        apart = clod_vec3_sub(apart, scaled_part(at_j, scale_j[0]));
        arms = clod_vec3_axpy(arms, b->arm_j, turn_j);
        turn = clod_vec3_sub(turn, turn_j);
    }
    const clod_vec3 slip = clod_vec3_sub(across(apart, n), clod_vec3_cross(arms, n));
    const clod_vec3 drag = clod_vec3_scale(slip, factor(self, b->slip));
    const double push = factor(self, b->push) * clod_vec3_dot(apart, n);
    const clod_vec3 force = clod_vec3_axpy(drag, push, n);
    const clod_vec3 lever = clod_vec3_cross(n, drag);
    const clod_vec3 roll = clod_vec3_scale(across(turn, n), factor(self, b->roll));
    double *to_i = y + FREEDOMS * b->i;
    add_part(to_i, scale_i[0], force);
    add_part(to_i + 3, scale_i[1], clod_vec3_axpy(roll, -b->arm_i, lever));
    if (b->j >= 0) {
        const double *scale_j = self->scale[b->j];
        double *to_j = y + FREEDOMS * b->j;
        add_part(to_j, -scale_j[0], force);
        add_part(to_j + 3, -scale_j[1], clod_vec3_axpy(roll, b->arm_j, lever));
    }
}

static void multiply(const void *matrix, const double *x, double *y)
{
    const bed *self = matrix;
    memset(y, 0, self->grains * FREEDOMS * sizeof *y);
    for (size_t b = 0; b < self->count; b++) {
        add_bond(self, &self->bonds[b], x, y);
    }
}

/** Springs of a contact (law/law_normal.h, law_tangential.h); nothing resists without friction. */
static void set_springs(bond *b, const clod_law *law, const meeting *m, double memory)
{
    const double loading = clod_law_tangent(law, m->overlap, m->r_star);
    const double tangential = clod_law_springs_tangential(law, loading);
    b->push.stiffness =
        clod_law_kinds_row(law->kind)->unloading(law, m->overlap, m->r_star, memory);
    b->push.dash_pot = law->damping * sqrt(m->m_star * loading);
    if (law->friction > 0.0) {
        b->slip = (spring){tangential, law->damping * sqrt(m->m_star * tangential)};
    }
    if (law->rolling_friction > 0.0) {
        b->roll.stiffness = clod_law_springs_rolling(law, loading) * m->r_star * m->r_star;
    }
    if (law->rolling_friction > 0.0 &&
        clod_law_springs_rolling_row_of((int)law->rolling)->dash_pot) {
        b->roll.dash_pot =
            2.0 * law->rolling_damping * sqrt(m->roll_inertia * b->roll.stiffness);
    }
}

/** Moment of inertia about a contact point at the surface. */
static double contact_inertia(const clod_grains *grains, int32_t row)
{
    const double radius = grains->position[row][3];
    return 1.0 / grains->angular_velocity[row][3] + grains->velocity[row][3] * radius * radius;
}

/** Geometry of a contact of two grains, and its law. */
static const clod_law *meet_grain(const clod_state *state, const clod_laws *laws,
                                  const clod_contact *c, bond *b, meeting *m)
{
    const clod_grains *g = &state->grains;
    const double *p = g->position[c->i];
    const double *q = g->position[c->j];
    double apart[3];
    for (int a = 0; a < 3; a++) {
        apart[a] = clod_domain_separation(&state->domain, a, p[a], q[a]);
    }
    const clod_vec3 way = clod_vec3_of(apart);
    const double distance = sqrt(clod_vec3_dot(way, way));
    const double mass_i = g->velocity[c->i][3], mass_j = g->velocity[c->j][3];
    const double about_i = contact_inertia(g, c->i), about_j = contact_inertia(g, c->j);
    m->overlap = p[3] + q[3] - distance;
    m->m_star = mass_i * mass_j / (mass_i + mass_j);
    m->r_star = p[3] * q[3] / (p[3] + q[3]);
    m->roll_inertia = about_i * about_j / (about_i + about_j);
    *b = (bond){.i = c->i,
                .j = c->j,
                .normal = clod_vec3_scale(way, 1.0 / distance),
                .arm_i = p[3] - 0.5 * m->overlap,
                .arm_j = q[3] - 0.5 * m->overlap};
    return &laws->law[clod_laws_index(laws, g->material[c->i], g->material[c->j])];
}

/** The same of a contact with a wall; of a mesh the nearest point of the patch counts. */
static const clod_law *meet_wall(const clod_state *state, const clod_wall_rows *rows,
                                 const clod_laws *laws, const clod_contact *c, bond *b,
                                 meeting *m)
{
    const clod_grains *g = &state->grains;
    const double radius = g->position[c->i][3];
    const clod_gap gap = clod_wall_rows_gap(rows, c->j, c->shape, g->position[c->i]);
    m->overlap = radius - gap.distance;
    m->m_star = g->velocity[c->i][3];
    m->r_star = radius;
    m->roll_inertia = contact_inertia(g, c->i);
    *b = (bond){.i = c->i, .j = -1, .normal = gap.normal, .arm_i = gap.distance};
    const int32_t material = clod_wall_material(&state->walls.wall[c->j], c->shape);
    return &laws->law[clod_laws_index(laws, g->material[c->i], material)];
}

static void add_contact(bed *self, const clod_state *state, const clod_wall_rows *rows,
                        const clod_laws *laws, const clod_contact *c)
{
    bond b;
    meeting m;
    const clod_law *law = c->shape < 0 ? meet_grain(state, laws, c, &b, &m)
                                       : meet_wall(state, rows, laws, c, &b, &m);
    if (m.overlap > 0.0) {
        set_springs(&b, law, &m, c->history[CLOD_HISTORY[CLOD_HISTORY_PLASTIC].first]);
        self->bonds[self->count++] = b;
    }
}

/** Room for as many contacts as there are, and all of them. */
static bool read_contacts(bed *self, const clod_state *state,
                          const clod_contact_source *contacts, const clod_laws *laws)
{
    clod_contact_walk walk;
    clod_contact_walk_begin(&walk, contacts);
    self->room = walk.pairs + walk.walls;
    self->bonds = clod_memory_alloc(self->room + 1, sizeof *self->bonds);
    clod_wall_rows rows;
    const bool good = self->bonds != NULL && clod_wall_rows_init(&rows, &state->walls);
    if (good) {
        const clod_contact *contact;
        while ((contact = clod_contact_walk_next(&walk)) != NULL) {
            add_contact(self, state, &rows, laws, contact);
        }
        clod_wall_rows_fini(&rows);
    }
    return good;
}

static bool read_grains(bed *self, const clod_grains *grains)
{
    self->grains = grains->count;
    self->scale = clod_memory_alloc(grains->count + 1, sizeof *self->scale);
    for (size_t g = 0; self->scale != NULL && g < grains->count; g++) {
        self->scale[g][0] = 1.0 / sqrt(grains->velocity[g][3]);
        self->scale[g][1] = sqrt(grains->angular_velocity[g][3]);
    }
    return self->scale != NULL;
}

/** A start that has a part of every oscillation, whatever the order of the grains. */
static void set_start(clod_lanczos *lanczos, const clod_grains *grains)
{
    for (size_t g = 0; g < grains->count; g++) {
        for (uint64_t f = 0; f < FREEDOMS; f++) {
            lanczos->start[FREEDOMS * g + f] =
                clod_random_uniform(0, CLOD_RANDOM_STABILITY, grains->id[g], f) - 0.5;
        }
    }
}

/** Largest eigenvalue of dt^2/4 K + dt/2 C by masses: 1 at the largest stable step. */
static double measure_step(bed *self, clod_lanczos *lanczos, double dt)
{
    self->by_stiffness = 0.25 * dt * dt;
    self->by_dash_pot = 0.5 * dt;
    return clod_lanczos_largest(lanczos, self, multiply);
}

/**
 * The step at which the eigenvalue is 1. It rises between dt, dash-pots alone, and dt^2, springs
 * alone, so the step sought lies between dt over it and dt over its root; a secant held to these.
 * No logarithm: their last bits differ between processors.
 */
static double find_step(bed *self, clod_lanczos *lanczos, double without)
{
    double before = 0.0, there = 0.0; // nothing at dt = 0
    double at = without;
    double here = measure_step(self, lanczos, at);
    for (int k = 0; k < STEPS && fabs(here - 1.0) > CLOSE; k++) {
        const double slope = (here - there) / (at - before);
        const double one = at / here, other = at / sqrt(here);
        const double least = fmin(one, other), most = fmax(one, other);
        before = at;
        at = fmin(fmax(at + (1.0 - here) / slope, least), most);
        there = here;
        here = measure_step(self, lanczos, at);
    }
    return at;
}

static void measure(clod_stability *self, bed *all, clod_lanczos *lanczos)
{
    all->by_stiffness = 1.0; // K alone
    self->frequency = sqrt(clod_lanczos_largest(lanczos, all, multiply));
    if (self->frequency > 0.0) {
        self->step = find_step(all, lanczos, 2.0 / self->frequency);
    }
}

bool clod_stability_measure(clod_stability *self, const clod_state *state,
                            const clod_contact_source *contacts, const clod_laws *laws,
                            clod_status *status)
{
    *self = (clod_stability){.step = INFINITY};
    bed all = {0};
    clod_lanczos lanczos = {0};
    bool good = read_grains(&all, &state->grains) &&
                read_contacts(&all, state, contacts, laws) &&
                clod_lanczos_init(&lanczos, FREEDOMS * all.grains);
    if (good) {
        self->contacts = all.count;
        set_start(&lanczos, &state->grains);
        measure(self, &all, &lanczos);
    }
    clod_lanczos_fini(&lanczos);
    clod_memory_free(all.bonds);
    clod_memory_free(all.scale);
    if (isnan(self->frequency) || isnan(self->step)) {
        self->step = 0.0;
    }
    return good ||
           clod_status_fail(status, CLOD_FAILED, "no memory for the largest stable time step");
}
