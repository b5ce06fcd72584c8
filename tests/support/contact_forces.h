#pragma once
/**
 * @file contact_forces.h
 * Forces of contacts, told again between steps, beside what the last step added up.
 */

#include "base/memory.h"
#include "step/contact_force.h"
#include "support/check.h"

/** Go back to the velocities that the forces of the last step were computed with. */
static inline void contact_forces_undo_kick(clod_state *state)
{
    clod_grains *grains = &state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        for (int a = 0; a < 3; a++) {
            grains->velocity[g][a] -=
                0.5 * state->dt / grains->velocity[g][3] * grains->load[g][a];
            grains->angular_velocity[g][a] -=
                0.5 * state->dt * grains->angular_velocity[g][3] * grains->load[g][4 + a];
        }
    }
}

/** How many contacts were compared. */
typedef struct contact_forces_count {
    size_t pairs, walls;
} contact_forces_count;

/** Sums over all contacts on grains, and on walls. */
static inline contact_forces_count contact_forces_add(const clod_state *state,
                                                      const clod_contact_source *from,
                                                      bool turn, double (*grain)[3],
                                                      double (*wall)[3])
{
    clod_contact contact;
    contact_forces_count met = {0};
    size_t pairs, walls;
    from->begin(from->context, &pairs, &walls);
    while (from->next(from->context, &contact, 1) == 1) {
        const bool pair = contact.shape < 0;
        met.pairs += pair;
        met.walls += !pair;
        if (pair && turn) {
            clod_contact_turn(&contact);
        }
        const clod_contact_force told = from->force(from->laws, &contact);
        const double *p = state->grains.position[contact.i];
        double square = 0.0;
        for (int a = 0; a < 3; a++) {
            grain[contact.i][a] += told.force[a];
            if (pair) {
                grain[contact.j][a] -= told.force[a];
            } else {
                wall[contact.j][a] -= told.force[a];
            }
            square += (p[a] - told.from[a]) * (p[a] - told.from[a]);
        }
        const double reach = pair ? p[3] + state->grains.position[contact.j][3] : p[3];
        assert_true(square < reach * reach && square > 0.25 * reach * reach);
    }
    return met;
}

/** Forces that are told again are the loads of the grains and those on the walls.
 *  @param turn  see pairs from their other grain */
static inline contact_forces_count contact_forces_compare(clod_step *step, bool turn)
{
    const clod_state *state = step->state;
    const size_t n = state->grains.count;
    double(*grain)[3] = clod_memory_alloc(n, sizeof *grain), wall[4][3] = {{0.0}};
    clod_step_reader reader;
    const clod_contact_source from = clod_step_contacts(step, &reader);
    const contact_forces_count met = contact_forces_add(state, &from, turn, grain, wall);
    double largest = 0.0;
    for (size_t g = 0; g < n; g++) {
        for (int a = 0; a < 3; a++) {
            largest = fmax(largest, fabs(state->grains.load[g][a]));
        }
    }
    assert_true(largest > 1e-3);
    for (size_t g = 0; g < n; g++) {
        for (int a = 0; a < 3; a++) {
            const double weight = state->grains.velocity[g][3] * state->gravity[a];
            check_close(grain[g][a] + weight, state->grains.load[g][a], 1e-9 * largest);
        }
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        check_close(wall[w][0], state->walls.wall[w].force.x, 1e-8 * largest);
        check_close(wall[w][1], state->walls.wall[w].force.y, 1e-8 * largest);
        check_close(wall[w][2], state->walls.wall[w].force.z, 1e-8 * largest);
    }
    clod_memory_free(grain);
    return met;
}
