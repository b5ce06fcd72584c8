#include "step/contact_force.h"

#include "geometry/wall_gap.h"
#include "geometry/wall_pose.h"
#include "law/law_contact.h"
#include "law/law_cycle.h"
#include "mesh/surface_touch.h"

static vreal3 vector_of(const double v[4])
{
    return (vreal3){v[0], v[1], v[2]};
}

/** Moment of inertia of a grain about the contact point [kg m2]. */
static double inertia_of(const clod_grains *grains, int32_t g)
{
    const double radius = grains->position[g][3];
    return 1.0 / grains->angular_velocity[g][3] + grains->velocity[g][3] * radius * radius;
}

/** Kinematics of two grains, as kernel_contact.h has them. */
static clod_law_motion meet_grain(const clod_state *state, const clod_contact *contact)
{
    const clod_grains *grains = &state->grains;
    const int32_t i = contact->i, j = contact->j;
    const double *pi = grains->position[i], *pj = grains->position[j];
    const double mass_i = grains->velocity[i][3], mass_j = grains->velocity[j][3];
    const vreal3 apart = {clod_domain_separation(&state->domain, 0, pi[0], pj[0]),
                          clod_domain_separation(&state->domain, 1, pi[1], pj[1]),
                          clod_domain_separation(&state->domain, 2, pi[2], pj[2])};
    const double distance = sqrt(vreal3_dot(apart, apart));
    const double overlap = pi[3] + pj[3] - distance;
    const double a = inertia_of(grains, i), b = inertia_of(grains, j);
    return (clod_law_motion){
        .overlap = overlap,
        .normal = vreal3_scale(apart, distance > 0.0 ? 1.0 / distance : 0.0),
        .velocity = vreal3_sub(vector_of(grains->velocity[i]), vector_of(grains->velocity[j])),
        .spin_i = vector_of(grains->angular_velocity[i]),
        .spin_j = vector_of(grains->angular_velocity[j]),
        .arm_i = pi[3] - 0.5 * overlap,
        .arm_j = pj[3] - 0.5 * overlap,
        .m_star = mass_i * mass_j / (mass_i + mass_j),
        .roll_inertia = a * b / (a + b)};
}

clod_contact_gain clod_step_gain_of(const void *step, const clod_contact *contact)
{
    const clod_step *self = step;
    double r_star;
    const clod_law *law = clod_step_law_of(self, contact, &r_star);
    const clod_law_motion motion = meet_grain(self->state, contact);
    const double memory = contact->history[CLOD_HISTORY[CLOD_HISTORY_PLASTIC].first];
    const clod_law_gain gain = clod_law_cycle_gain(law, r_star, motion.overlap, memory,
                                                   -vreal3_dot(motion.velocity, motion.normal));
    return (clod_contact_gain){gain.pull, gain.pressed};
}

/** Gap between a grain and a shape of a wall where both are now; normal in space. */
static clod_gap gap_of(const clod_wall *wall, int32_t number, const double p[4])
{
    const clod_shape *shape = &wall->shapes[number];
    const clod_wall_pose pose =
        shape->symmetric ? clod_wall_pose_at_rest(wall) : clod_wall_pose_now(wall);
    const clod_vec3 at = clod_wall_to_frame(&pose, clod_vec3_of(p));
    clod_gap gap;
    if (shape->surface != NULL) {
        const clod_surface_closest closest =
            clod_surface_slot_closest(shape->surface, shape->patch, shape->slot, at, p[3]);
        gap = (clod_gap){closest.distance, closest.direction};
    } else {
        gap = clod_wall_gap(shape, at);
    }
    gap.normal = clod_wall_to_space(&pose, gap.normal);
    return gap;
}

/** Where a grain meets a wall, the gap there, and how the wall's material moves. */
typedef struct wall_meeting {
    clod_gap gap;
    clod_vec3 point, carrier; ///< m, m/s
} wall_meeting;

static wall_meeting meeting_of(const clod_state *state, const clod_contact *contact)
{
    const clod_wall *wall = &state->walls.wall[contact->j];
    const double *p = state->grains.position[contact->i];
    const clod_gap gap = gap_of(wall, contact->shape, p);
    const clod_vec3 point = clod_vec3_axpy(clod_vec3_of(p), -gap.distance, gap.normal);
    return (wall_meeting){gap, point,
                          clod_wall_material_velocity(wall, contact->shape, point, gap.normal)};
}

void clod_step_carrier_of(const void *step, const clod_contact *contact, double velocity[3])
{
    const clod_step *self = step;
    clod_vec3_put(velocity, meeting_of(self->state, contact).carrier);
}

/** Kinematics of a grain at a wall, as kernel_wall.h has them. The wall's spin counts for rolling
 *  torques alone: an arm of 0 leaves it out of the force. */
static clod_law_motion meet_wall(const clod_state *state, const clod_contact *contact,
                                 clod_vec3 *point)
{
    const clod_grains *grains = &state->grains;
    const double *p = grains->position[contact->i];
    const wall_meeting at = meeting_of(state, contact);
    const clod_gap gap = at.gap;
    const clod_vec3 carrier = at.carrier;
    *point = at.point;
    return (clod_law_motion){.overlap = p[3] - gap.distance,
                             .normal = {gap.normal.x, gap.normal.y, gap.normal.z},
                             .velocity = vreal3_sub(vector_of(grains->velocity[contact->i]),
                                                    (vreal3){carrier.x, carrier.y, carrier.z}),
                             .spin_i = vector_of(grains->angular_velocity[contact->i]),
                             .arm_i = gap.distance,
                             .m_star = grains->velocity[contact->i][3],
                             .roll_inertia = inertia_of(grains, contact->i)};
}

clod_contact_force clod_step_force_of(const void *step, const clod_contact *contact)
{
    const clod_step *self = step;
    const clod_state *state = self->state;
    const double *p = state->grains.position[contact->i];
    double r_star;
    const clod_law *law = clod_step_law_of(self, contact, &r_star);
    clod_contact_force told = {.force = {0.0}};
    clod_law_motion motion;
    if (contact->shape < 0) {
        motion = meet_grain(state, contact);
        for (int a = 0; a < 3; a++) {
            told.from[a] = p[a] - clod_domain_separation(&state->domain, a, p[a],
                                                         state->grains.position[contact->j][a]);
        }
    } else {
        clod_vec3 point;
        motion = meet_wall(state, contact, &point);
        clod_vec3_put(told.from, point);
    }
    if (!(motion.overlap > 0.0)) {
        return told;
    }
    motion.r_star = r_star;
    clod_history history = {.plastic = {0.0}};
    clod_history_put(&history, 0, contact->history);
    clod_law_memory memory = clod_law_memory_load(&history, 0);
    const clod_law_result result =
        clod_law_contact(law, &motion, 0.0, &memory); // no time passes
    told.force[0] = result.force.x;
    told.force[1] = result.force.y;
    told.force[2] = result.force.z;
    return told;
}
