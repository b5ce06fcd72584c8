#include "verify/passive.h"

#include <math.h>
#include <string.h>

#include "base/assert.h"
#include "law/law_springs.h"

#define RADIUS CLOD_VERIFY_PASSIVE_RADIUS
#define DEGREE (M_PI / 180.0)
/** Height of the pairs above the plane, and from one impact to the next [m]. */
#define APART (4.0 * RADIUS)
/** Time from the beginning to touch, and to the end, over the duration of an impact. */
#define BEFORE 0.02
#define LENGTH 3.0

/** One impact of a deck: a on the plane, or on b. */
typedef struct impact {
    int a, b;                            ///< grains of the deck; b -1: the plane
    double energy, tangential;           ///< J, kinetic, of the beginning
    double sliding, rolling;             ///< J, in its springs after the step before
    double made[CLOD_VERIFY_MADE_COUNT]; ///< J, largest so far
    double after, tangential_after;      ///< J, last
    double lag;                          ///< J, so far
    bool touching;                       ///< has been in contact
} impact;

typedef struct watch {
    impact impacts[2 * CLOD_VERIFY_PASSIVE_ANGLES];
    int count;
    double step;
} watch;

// ---- what the ledger says

/** Keep the largest. */
static void offer(double *most, double made)
{
    *most = clod_verify_larger(*most, made);
}

static void see_dissipated(impact *self, const clod_dissipation_block *dissipated, int lane)
{
    self->lag += dissipated->lag[lane];
    offer(&self->made[CLOD_VERIFY_MADE_PLASTIC], -dissipated->plastic[lane]);
    offer(&self->made[CLOD_VERIFY_MADE_DASH_POT], -dissipated->dash_pot[lane]);
    offer(&self->made[CLOD_VERIFY_MADE_FRICTION], -dissipated->friction[lane]);
    offer(&self->made[CLOD_VERIFY_MADE_ROLLING], -dissipated->rolling[lane]);
}

/** Where a contact lies in the near list. */
typedef struct place {
    const clod_history *history; ///< NULL: not near
    const clod_dissipation_block *dissipated;
    int lane;
} place;

static place find_contact(const clod_verify_play *now, const impact *self)
{
    const bool pair = self->b >= 0;
    const clod_near_blocks *list = pair ? &now->step.near.pairs : &now->step.near.walls;
    const int32_t a = (int32_t)now->row[self->a];
    const int32_t b = pair ? (int32_t)now->row[self->b] : -1;
    for (size_t q = 0; q < clod_near_groups(&now->step.near); q++) {
        for (size_t k = 0; k < list->group_count[q]; k++) {
            const size_t at = list->group_start[q] + k / CLOD_LANES;
            const int lane = (int)(k % CLOD_LANES);
            if (pair) {
                const clod_contact_block *block = (const clod_contact_block *)list->block + at;
                if ((block->i[lane] == a && block->j[lane] == b) ||
                    (block->i[lane] == b && block->j[lane] == a)) {
                    return (place){&block->history, &list->dissipated[at], lane};
                }
            } else {
                const clod_wall_block *block = (const clod_wall_block *)list->block + at;
                if (block->i[lane] == a) {
                    return (place){&block->history, &list->dissipated[at], lane};
                }
            }
        }
    }
    return (place){NULL, NULL, 0};
}

// ---- what forces and velocities say

/** A grain of an impact in the middle of the last step; the plane: at rest. */
typedef struct body {
    clod_vec3 at, velocity, spin; ///< m, m/s, rad/s, along t, b, n
    clod_vec3 force, torque;      ///< N, N m
} body;

static body body_of(const clod_verify_play *now, int grain)
{
    if (grain < 0) {
        return (body){.at = {0.0, 0.0, 0.0}};
    }
    const size_t row = now->row[grain];
    const double half = 0.5 * now->state.dt;
    body self = {.at = clod_verify_play_place(now, grain),
                 .force = clod_verify_play_force(now, grain),
                 .torque = clod_verify_play_torque(now, grain)};
    self.velocity = clod_vec3_axpy(clod_verify_play_velocity(now, grain),
                                   -half / now->state.grains.velocity[row][3], self.force);
    self.spin = clod_vec3_axpy(clod_verify_play_spin(now, grain),
                               -half * now->state.grains.angular_velocity[row][3], self.torque);
    return self;
}

/** Part across n. */
static clod_vec3 across(clod_vec3 v, clod_vec3 n)
{
    return clod_vec3_axpy(v, -clod_vec3_dot(v, n), n);
}

/** Energy of a spring whose components stand in one lane [J]. */
static double spring_energy(const double spring[3][CLOD_LANES], int lane, double stiffness)
{
    double square = 0.0;
    for (int c = 0; c < 3; c++) {
        square += spring[c][lane] * spring[c][lane];
    }
    return 0.5 * stiffness * square;
}

/** End force and end torque of the step against what the springs have gained. */
static void see_ends(const clod_verify_play *now, impact *self, const place *contact)
{
    const body a = body_of(now, self->a);
    const body b = body_of(now, self->b);
    const bool pair = self->b >= 0;
    const clod_vec3 apart = clod_vec3_sub(a.at, b.at);
    const clod_vec3 n = pair ? clod_vec3_unit(apart) : (clod_vec3){0.0, 0.0, 1.0};
    const double arm = pair ? 0.5 * clod_vec3_length(apart) : a.at.z;
    const clod_vec3 spins = pair ? clod_vec3_add(a.spin, b.spin) : a.spin;
    const clod_vec3 rolling = across(clod_vec3_sub(a.spin, b.spin), n);
    const clod_vec3 slip = clod_vec3_axpy(across(clod_vec3_sub(a.velocity, b.velocity), n),
                                          -arm, clod_vec3_cross(spins, n));
    const clod_vec3 friction = across(a.force, n);
    const clod_vec3 torque = clod_vec3_axpy(a.torque, arm, clod_vec3_cross(n, friction));

    const clod_law *law = &now->laws.law[clod_laws_index(&now->laws, 0, pair ? 0 : 1)];
    const double tangent = contact->history->tangent[contact->lane];
    self->touching |= tangent > 0.0;
    const double r_star = pair ? 0.5 * RADIUS : RADIUS;
    const double k_t = clod_law_springs_tangential(law, tangent);
    const double k_r = clod_law_springs_rolling(law, tangent) * (r_star * r_star);
    const double held = spring_energy(contact->history->spring, contact->lane, k_t);
    const double turned = spring_energy(contact->history->roll, contact->lane, k_r);
    const double dt = now->state.dt;
    offer(&self->made[CLOD_VERIFY_MADE_BY_FORCE],
          clod_vec3_dot(friction, slip) * dt + held - self->sliding);
    offer(&self->made[CLOD_VERIFY_MADE_BY_TORQUE],
          clod_vec3_dot(torque, rolling) * dt + turned - self->rolling);
    self->sliding = held;
    self->rolling = turned;
}

/** Kinetic energy now, and that without the motion along n [J]. */
static void see_motion(const clod_verify_play *now, impact *self)
{
    self->after = self->tangential_after = 0.0;
    const int grains[] = {self->a, self->b};
    for (int k = 0; k < (self->b >= 0 ? 2 : 1); k++) {
        const size_t row = now->row[grains[k]];
        const clod_vec3 v = clod_verify_play_velocity(now, grains[k]);
        const clod_vec3 w = clod_verify_play_spin(now, grains[k]);
        const double mass = now->state.grains.velocity[row][3];
        const double turning =
            0.5 * clod_vec3_dot(w, w) / now->state.grains.angular_velocity[row][3];
        self->after += 0.5 * mass * clod_vec3_dot(v, v) + turning;
        self->tangential_after += 0.5 * mass * (v.x * v.x + v.y * v.y) + turning;
    }
}

static bool look(void *context, const clod_verify_play *now, clod_status *status)
{
    watch *self = context;
    (void)status;
    self->step = now->state.dt;
    for (int k = 0; k < self->count; k++) {
        impact *seen = &self->impacts[k];
        see_motion(now, seen);
        if (now->state.step == 0) {
            seen->energy = seen->after;
            seen->tangential = seen->tangential_after;
            continue;
        }
        const place contact = find_contact(now, seen);
        if (contact.history != NULL) {
            see_dissipated(seen, contact.dissipated, contact.lane);
            see_ends(now, seen, &contact);
        }
    }
    return true;
}

// ---- the deck

static void put_impact(const clod_verify_passive *self, int k, clod_verify_deck *deck,
                       watch *seen)
{
    const double angle = self->angles[k] * DEGREE;
    const double normal = self->speed * cos(angle);
    const double slip = self->speed * sin(angle);
    const double before = BEFORE * self->duration * normal;
    const double along = APART * (k - 0.5 * (self->angle_count - 1));
    seen->impacts[seen->count++] = (impact){.a = deck->grain_count, .b = -1};
    clod_verify_grain *grain =
        clod_verify_deck_grain(deck, "grain", RADIUS, (clod_vec3){0.0, along, RADIUS + before});
    grain->velocity = (clod_vec3){slip, 0.0, -normal};
    if (!self->pairs) {
        return;
    }
    seen->impacts[seen->count++] = (impact){.a = deck->grain_count, .b = deck->grain_count + 1};
    for (int side = -1; side <= 1; side += 2) { // they spin: they roll, twist and slip
        const double height = 2.0 * APART + side * (RADIUS + 0.5 * before);
        grain = clod_verify_deck_grain(deck, "grain", RADIUS, (clod_vec3){0.0, along, height});
        grain->velocity = (clod_vec3){0.5 * side * slip, 0.0, -0.5 * side * normal};
        const double spin = 0.3 * self->speed / RADIUS;
        grain->spin = (clod_vec3){side * spin, 0.5 * spin, 0.7 * spin};
    }
}

static void make_deck(const clod_verify_passive *self, double step, clod_verify_deck *deck,
                      watch *seen)
{
    CLOD_ASSERT(self->angle_count <= CLOD_VERIFY_PASSIVE_ANGLES);
    *deck = (clod_verify_deck){.name = self->name,
                               .title = "oblique impacts: no contact makes energy",
                               .step = step,
                               .ledger = true};
    *seen = (watch){.count = 0};
    clod_verify_deck_material(deck, "grain", CLOD_VERIFY_PASSIVE_DENSITY, self->young,
                              CLOD_VERIFY_PASSIVE_POISSON);
    clod_verify_deck_material(deck, "plane", CLOD_VERIFY_PASSIVE_DENSITY, self->plane_young,
                              self->plane_poisson);
    clod_verify_deck_contact(deck, "default", "%s", self->keys);
    clod_verify_deck_wall(deck, "plane", "plane", 0.0, 1.0);
    clod_verify_deck_stage(deck, (clod_verify_stage){.duration = LENGTH * self->duration});
    for (int k = 0; k < self->angle_count; k++) {
        put_impact(self, k, deck, seen);
    }
}

static void collect(const watch *seen, clod_verify_passive_found *found)
{
    *found = (clod_verify_passive_found){.step = seen->step, .impacts = seen->count};
    int angle = 0;
    for (int k = 0; k < seen->count; k++) {
        impact one = seen->impacts[k];
        offer(&one.made[CLOD_VERIFY_MADE_IN_ALL], one.after - one.energy);
        for (int m = 0; m < CLOD_VERIFY_MADE_COUNT; m++) {
            offer(&found->made[m], one.made[m] / one.energy);
        }
        found->touching += one.touching;
        if (one.b < 0) {
            found->lag = clod_verify_larger(found->lag, fabs(one.lag) / one.energy);
            found->rebound[angle++] =
                one.tangential > 0.0 ? one.tangential_after / one.tangential : (double)NAN;
        }
    }
}

static bool run(const clod_verify_bench *bench, const clod_verify_passive *self, double step,
                watch *seen, clod_status *status)
{
    const clod_verify_frame frame = clod_verify_frame_plain();
    clod_verify_deck deck;
    make_deck(self, step, &deck, seen);
    return clod_verify_play_run(bench, &deck, &frame, look, seen, status);
}

bool clod_verify_passive_run(const clod_verify_bench *bench, const clod_verify_passive *self,
                             clod_verify_passive_found *found, clod_status *status)
{
    watch seen;
    double step = self->step;
    if (self->parts > 0.0) {
        if (!run(bench, self, 0.0, &seen, status)) {
            return false;
        }
        step = self->parts > 1.0 ? seen.step / self->parts : 0.0;
    }
    if (!(self->parts == 1.0) && !run(bench, self, step, &seen, status)) {
        return false;
    }
    collect(&seen, found);
    return true;
}
