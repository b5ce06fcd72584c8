#pragma once
/**
 * @file law_probe.h
 * One contact of src/law, driven by hand in the scalar vocabulary.
 */

#include "law/law_contact.h"
#include "support/check.h"
#include "support/materials.h"

typedef struct law_probe {
    clod_law law;
    clod_history history; ///< lane 0
} law_probe;

static inline law_probe probe_make(const clod_case_contact *contact)
{
    return (law_probe){.law = clod_law_make(contact, &ORE, &ORE)};
}

/** Two equal grains of 3 mm radius and 1 g, at rest, touching along x. */
static inline clod_law_motion probe_motion(double overlap)
{
    return (clod_law_motion){.overlap = overlap,
                             .normal = {1.0, 0.0, 0.0},
                             .arm_i = 3e-3 - 0.5 * overlap,
                             .arm_j = 3e-3 - 0.5 * overlap,
                             .m_star = 0.5e-3,
                             .r_star = 1.5e-3,
                             .roll_inertia = 0.5 * (1.4 * 1e-3 * 9e-6)};
}

static inline clod_law_result probe_step(law_probe *self, const clod_law_motion *motion,
                                         double dt)
{
    clod_law_memory memory = clod_law_memory_load(&self->history, 0);
    const clod_law_result result = clod_law_contact(&self->law, motion, dt, &memory);
    clod_law_memory_store(&self->history, 0, result.closed, memory);
    return result;
}

/** Normal force at rest and at an overlap. */
static inline double probe_press(law_probe *self, double overlap)
{
    const clod_law_motion motion = probe_motion(overlap);
    return probe_step(self, &motion, 0.0).force.x;
}

/** Press from one overlap to another in small steps; the force at the end. */
static inline double probe_path(law_probe *self, double from, double to, int steps)
{
    double force = 0.0;
    for (int s = 1; s <= steps; s++) {
        const double t = (double)s / (double)steps;
        force = probe_press(self, s == steps ? to : from + t * (to - from));
    }
    return force;
}
