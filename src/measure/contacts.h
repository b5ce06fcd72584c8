#pragma once
/**
 * @file contacts.h
 * What the contacts and the motion of grains say about the bed.
 */

#include "measure/survey.h"
#include "parallel/exact.h"

typedef struct clod_measure_contacts {
    size_t pairs, walls; ///< closed contacts: grain-grain, grain-wall
    double coordination; ///< mean number of grain-grain contacts of a grain
    double max_overlap;  ///< of grain pairs, as a fraction of the smaller radius
    double mean_overlap; ///< likewise
} clod_measure_contacts;

/** Of all contacts of a bed; false without memory on any rank.  Threads: one per bed. */
bool clod_measure_contacts_from(const clod_survey *survey, clod_measure_contacts *found,
                                clod_status *status);

/** The same of state->contacts. */
clod_measure_contacts clod_measure_contacts_of(const clod_state *state);

/** How grains move. */
typedef struct clod_measure_motion {
    int64_t grains;
    int64_t
        loaded; ///< those on which anything but their weight acts: in contact, and carrying load
    double mass;           ///< kg
    double kinetic_energy; ///< J, translation and rotation
    double max_speed;      ///< m/s
} clod_measure_motion;

/** Of all grains of a bed. Not a number, and no grains, after a failure, which only ranks can have:
 *  the next steps fail with its status.  Threads: one per bed. */
clod_measure_motion clod_measure_motion_from(const clod_survey *survey);

/** The same of a state.  Threads: pure. */
clod_measure_motion clod_measure_motion_of(const clod_state *state);

extern const clod_survey_way CLOD_MEASURE_CONTACTS_WAY, CLOD_MEASURE_MOTION_WAY;
