#include "tester/contact_bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/assert.h"
#include "base/given.h"
#include "law/law_contact.h"
#include "law/law_kinds.h"
#include "law/law_springs.h"

/** Steps of an impact that last one radian of the contact's oscillation. */
#define IMPACT_STEPS 20000

/** Radians after which grains that have not parted stick: the way in and out takes about pi. */
#define IMPACT_RADIANS 12

/** Overlap over R* that closed forms are told for when the path never pressed. */
#define SMALL_OVERLAP 1e-3

/** The two partners, and where the path is. */
typedef struct bench {
    const clod_case_contact_bench *from;
    clod_law law;
    double m_star, r_star;
    double inertia; ///< reduced moment of inertia about the contact [kg m2]
    clod_law_memory memory;
} bench;

/** Speeds of one leg. */
typedef struct pace {
    double dt;
    double closing;     ///< m/s
    double slip[2];     ///< m/s
    double roll, twist; ///< rad/s
} pace;

static double sphere_mass(const clod_case_material *material, double radius)
{
    return 4.0 / 3.0 * M_PI * radius * radius * radius * material->density;
}

/** Moment of inertia of a sphere about a point of its surface, 7/5 m R^2. */
static double rim_inertia(double mass, double radius)
{
    return 1.4 * mass * radius * radius;
}

static bool check_density(const bench *self, const clod_case_material *material,
                          clod_status *status)
{
    const clod_law *law = &self->law;
    const bool rolls = clod_law_springs_rolling_row_of((int)law->rolling)->dash_pot &&
                       law->rolling_damping > 0.0;
    if (material->density > 0.0 || (!rolls && self->law.damping == 0.0)) {
        return true;
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        "contact_bench: material %s has no density, but the dash-pot of the "
        "pair needs the grain's mass; give materials.%s a density, or the "
        "pair restitution: 1",
        material->name, material->name);
}

static bool make_bench(const clod_case *from, bench *self, clod_status *status)
{
    const clod_case_contact_bench *b = &from->contact_bench;
    if (!b->present) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s has no contact_bench; clod new contact-bench writes an "
                                "example",
                                from->path);
    }
    const int index_1 = clod_case_material_index(from, b->material_1);
    const int index_2 = clod_case_material_index(from, b->material_2);
    CLOD_ASSERT(index_1 >= 0 && index_2 >= 0);
    const clod_case_material *one = &from->materials[index_1];
    const clod_case_material *two = &from->materials[index_2];
    *self = (bench){.from = b};
    self->law = clod_law_make(clod_case_pair(from, index_1, index_2), one, two);
    clod_law_set_adhesion(&self->law, b->adhesion);
    const double r_1 = b->radius_1;
    const double r_2 = b->radius_2;
    const double m_1 = sphere_mass(one, r_1);
    const double i_1 = rim_inertia(m_1, r_1);
    self->m_star = m_1;
    self->r_star = r_1;
    self->inertia = i_1;
    if (!b->wall) {
        const double m_2 = sphere_mass(two, r_2);
        const double i_2 = rim_inertia(m_2, r_2);
        self->m_star = m_1 > 0.0 && m_2 > 0.0 ? m_1 * m_2 / (m_1 + m_2) : 0.0;
        self->r_star = r_1 * r_2 / (r_1 + r_2);
        self->inertia = i_1 > 0.0 && i_2 > 0.0 ? i_1 * i_2 / (i_1 + i_2) : 0.0;
    }
    return check_density(self, one, status) && (b->wall || check_density(self, two, status));
}

static pace leg_pace(const clod_case_leg *leg, double overlap_before)
{
    return (pace){.dt = leg->duration / (double)leg->steps,
                  .closing = (leg->overlap - overlap_before) / leg->duration,
                  .slip = {leg->slip[0] / leg->duration, leg->slip[1] / leg->duration},
                  .roll = leg->roll / leg->duration,
                  .twist = leg->twist / leg->duration};
}

/** Kinematics of the contact; x, y, z are t1, t2, normal. */
static clod_law_motion contact_motion(const bench *self, const pace *speed, double overlap)
{
    const bool wall = self->from->wall;
    clod_law_motion motion = {
        .overlap = overlap,
        .normal = {0.0, 0.0, 1.0},
        .velocity = {speed->slip[0], speed->slip[1], -speed->closing},
        .arm_i = self->from->radius_1 - (wall ? 1.0 : 0.5) * overlap,
        .arm_j = wall ? 0.0 : self->from->radius_2 - 0.5 * overlap,
        .m_star = self->m_star,
        .r_star = self->r_star,
        .roll_inertia = self->inertia,
    };
    if (wall) { // w t2 x normal = w t1: the grain moves along as it rolls
        motion.spin_i.y = speed->roll;
        motion.velocity.x += motion.arm_i * speed->roll;
    } else {
        const double arms = motion.arm_i + motion.arm_j;
        motion.spin_i.y = speed->roll * motion.arm_j / arms;
        motion.spin_j.y = -speed->roll * motion.arm_i / arms;
    }
    motion.spin_i.z = speed->twist;
    return motion;
}

/** Branch after a step; luding's limit branch is a line of unloading and reloading. */
static clod_contact_branch branch_of(const clod_law *law, clod_law_stiffness s,
                                     clod_law_normal normal, double plastic)
{
    if (clod_law_rises(law)) {
        return normal.force <= -normal.pull ? CLOD_BRANCH_ADHESIVE
               : plastic == s.overlap       ? CLOD_BRANCH_LOADING
                                            : CLOD_BRANCH_UNLOADING;
    }
    if (plastic <= law->virgin * s.power) {
        return CLOD_BRANCH_LOADING;
    }
    const double most =
        law->patch > 0.0 ? clod_law_patch_bound(law, s) : law->pull_off * s.power;
    return plastic < most ? CLOD_BRANCH_UNLOADING : CLOD_BRANCH_ADHESIVE;
}

/** One step of the law; what it did goes into the row, which has its kinematics already. */
static void advance(bench *self, const pace *speed, clod_contact_bench_row *row)
{
    const clod_law *law = &self->law;
    const clod_law_motion motion = contact_motion(self, speed, row->overlap);
    double plastic = self->memory.plastic;
    const clod_law_result result = clod_law_contact(law, &motion, speed->dt, &self->memory);
    if (!result.closed) {
        self->memory = (clod_law_memory){0}; // an open contact forgets (docs/theory/mepa.md)
        return;
    }
    const clod_law_stiffness s = clod_law_stiffness_at(law, motion.overlap, motion.r_star);
    const clod_law_memory *m = &self->memory;
    const clod_law_normal normal = clod_law_normal_force(law, s, &plastic); // as in the contact
    row->force = normal.force;
    row->damping = -clod_law_damping(law, s, motion.m_star) * motion.velocity.z;
    row->friction[0] = result.force.x;
    row->friction[1] = result.force.y;
    const vreal3 torque = vreal3_axpy(result.roll, -motion.arm_i, result.lever);
    row->torque[0] = torque.x;
    row->torque[1] = torque.y;
    row->torque[2] = torque.z;
    row->roll_torque[0] = result.roll.x;
    row->roll_torque[1] = result.roll.y;
    row->branch = branch_of(law, s, normal, m->plastic);
    row->plastic = clod_law_kinds_row(law->kind)->plastic(law, motion.r_star, m->plastic);
    row->spring[0] = m->spring.x;
    row->spring[1] = m->spring.y;
    row->roll_spring[0] = m->roll.x;
    row->roll_spring[1] = m->roll.y;
    row->limit = law->friction * clod_law_normal_measure(law, normal);
    const double friction = hypot(row->friction[0], row->friction[1]);
    row->sliding = friction >= row->limit * (1.0 - 1e-12); // a cut force rounds to its limit
}

static void note(clod_contact_bench_summary *summary, const clod_contact_bench_row *row)
{
    if (row->force > summary->f_max) {
        summary->f_max = row->force;
        summary->d_max = row->overlap;
    }
    if (row->force < summary->f_min) {
        summary->f_min = row->force;
        summary->d_min = row->overlap;
        summary->f_before = summary->f_max;
        summary->d_before = summary->d_max;
    }
}

/** Row of step `step` of a leg: linear from `before`, and exactly the leg's end at the last. */
static clod_contact_bench_row row_at(const clod_case_leg *leg,
                                     const clod_contact_bench_row *before, int64_t step)
{
    const double part = (double)step / (double)leg->steps;
    clod_contact_bench_row row = {
        .time = before->time + part * leg->duration,
        .overlap = step == leg->steps
                       ? leg->overlap
                       : before->overlap + part * (leg->overlap - before->overlap),
        .slip = {before->slip[0] + part * leg->slip[0], before->slip[1] + part * leg->slip[1]},
        .roll = before->roll + part * leg->roll,
        .twist = before->twist + part * leg->twist,
    };
    return row;
}

/** docs/theory/mepa.md, all for the largest overlap 1: the laws whose restitution knows no
 * speed. */
static double closed_restitution(const clod_law *law)
{
    const double n1 = law->exponent + 1.0;
    const double m = pow((law->k2 - law->k1) / (law->k2 + law->k_adh), 1.0 / law->exponent);
    const double rest = pow(m, n1);
    const double in = law->k1 / n1;
    const double out = law->k2 * ((1.0 - rest) / n1 - (1.0 - law->k1 / law->k2) * (1.0 - m)) -
                       law->k_adh * rest / n1;
    return out > 0.0 ? sqrt(out / in) : 0.0;
}

double clod_contact_bench_restitution(const clod_law *law, double r_star, double d_max)
{
    if (clod_law_kinds_row(law->kind)->speed_free) {
        return closed_restitution(law);
    }
    clod_law bare = *law;
    bare.damping = 0.0;
    return clod_contact_bench_impact(&bare, 1.0, r_star, d_max); // any mass
}

double clod_contact_bench_impact(const clod_law *law, double m_star, double r_star,
                                 double d_max)
{
    const double energy = clod_law_cycle_energy(law, r_star, d_max);
    if (energy <= 0.0) { // eepa: without speed the first pull presses deeper than that
        return 0.0;
    }
    const double speed = sqrt(2.0 * energy / m_star);
    const double dt = d_max / (speed * IMPACT_STEPS);
    double overlap = 0.0;
    double closing = speed;
    double plastic = 0.0;
    for (int64_t step = 0; step < (int64_t)IMPACT_RADIANS * IMPACT_STEPS; step++) {
        overlap += dt * closing;
        if (overlap <= 0.0) {
            return -closing / speed;
        }
        const clod_law_stiffness s = clod_law_stiffness_at(law, overlap, r_star);
        const double force = clod_law_normal_force(law, s, &plastic).force +
                             clod_law_damping(law, s, m_star) * closing;
        closing -= dt * force / m_star;
    }
    return 0.0;
}

static void finish(const clod_case *from, const bench *self,
                   clod_contact_bench_summary *summary)
{
    const clod_law *law = &self->law;
    const double r_star = self->r_star;
    const int a = clod_case_material_index(from, self->from->material_1);
    const int b = clod_case_material_index(from, self->from->material_2);
    const double most = summary->d_max > 0.0 ? summary->d_max : SMALL_OVERLAP * r_star;
    const clod_law_pull pull = clod_law_cycle_pull(law, r_star, most);
    summary->pull_off_overlap = pull.overlap / most;
    const double push = clod_law_cycle_force(law, r_star, most);
    summary->pull_off_force = push > 0.0 ? pull.force / push : 0.0;
    summary->restitution_asked = clod_case_pair(from, a, b)->restitution;
    summary->restitution_law = clod_contact_bench_restitution(law, r_star, most);
    summary->restitution_both = summary->restitution_law;
    if (law->damping > 0.0) {
        summary->restitution_both = clod_contact_bench_impact(law, self->m_star, r_star, most);
    }
    const double n = law->exponent;
    summary->damping_ratio = 0.5 * law->damping / sqrt((n + 1.0) / (2.0 * n)) + 0.0; // not -0
    const double tangent = clod_law_tangent(law, summary->d_max, r_star);
    summary->damping_coefficient = law->damping * sqrt(self->m_star * tangent) + 0.0;
}

bool clod_contact_bench_run(const clod_case *from, clod_contact_bench_sink sink, void *context,
                            clod_contact_bench_summary *summary, clod_status *status)
{
    if (!CLOD_GIVEN(from, status) || !CLOD_GIVEN(sink, status) ||
        !CLOD_GIVEN(summary, status)) {
        return false;
    }
    bench self;
    *summary = (clod_contact_bench_summary){0};
    if (!make_bench(from, &self, status)) {
        return false;
    }
    clod_contact_bench_row before = {0};
    for (size_t l = 0; l < self.from->leg_count; l++) {
        const clod_case_leg *leg = &self.from->legs[l];
        const pace speed = leg_pace(leg, before.overlap);
        clod_contact_bench_row row = before;
        for (int64_t step = 1; step <= leg->steps; step++) {
            row = row_at(leg, &before, step);
            advance(&self, &speed, &row);
            note(summary, &row);
            if (!sink(context, &row, status)) {
                return false;
            }
        }
        before = row;
    }
    finish(from, &self, summary);
    return true;
}

const char *clod_contact_bench_header(void)
{
    return "time [s],overlap [m],slip_t1 [m],slip_t2 [m],roll [rad],twist [rad],"
           "force_normal [N],damping [N],friction_t1 [N],friction_t2 [N],"
           "torque_t1 [N m],torque_t2 [N m],torque_normal [N m],"
           "roll_torque_t1 [N m],roll_torque_t2 [N m],branch,plastic_overlap [m],"
           "spring_t1 [m],spring_t2 [m],roll_spring_t1 [rad],roll_spring_t2 [rad],"
           "coulomb_limit [N],sliding";
}

/** Append a number with as few digits as read back exactly, and a comma. */
static char *put_number(char *at, double value)
{
    for (int digits = 15; digits <= 17; digits++) {
        const int length = snprintf(at, 32, "%.*g,", digits, value == 0.0 ? 0.0 : value);
        if (strtod(at, NULL) == value || digits == 17) {
            return at + length;
        }
    }
    return at;
}

static char *put(char *at, const double *values, size_t count)
{
    for (size_t v = 0; v < count; v++) {
        at = put_number(at, values[v]);
    }
    return at;
}

void clod_contact_bench_line(const clod_contact_bench_row *row,
                             char line[CLOD_CONTACT_BENCH_LINE])
{
    CLOD_NEED(row);
    CLOD_NEED(line);
    static const char *const BRANCHES[] = {"open", "loading", "unloading", "adhesive"};
    const double first[] = {row->time,        row->overlap,        row->slip[0],
                            row->slip[1],     row->roll,           row->twist,
                            row->force,       row->damping,        row->friction[0],
                            row->friction[1], row->torque[0],      row->torque[1],
                            row->torque[2],   row->roll_torque[0], row->roll_torque[1]};
    const double second[] = {row->plastic,        row->spring[0],      row->spring[1],
                             row->roll_spring[0], row->roll_spring[1], row->limit};
    char *at = put(line, first, sizeof first / sizeof first[0]);
    at += snprintf(at, 16, "%s,", BRANCHES[row->branch]);
    at = put(at, second, sizeof second / sizeof second[0]);
    snprintf(at, 4, "%d", row->sliding);
}
