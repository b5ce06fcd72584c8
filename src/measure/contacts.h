#pragma once
/**
 * @file contacts.h
 * What the contacts of a state say about the bed.
 */

#include "state/contact_source.h"

typedef struct clod_measure_contacts {
    size_t pairs, walls; ///< closed contacts: grain-grain, grain-wall
    double coordination; ///< mean number of grain-grain contacts of a grain
    double max_overlap;  ///< of grain pairs, as a fraction of the smaller radius
    double mean_overlap; ///< likewise
} clod_measure_contacts;

/** Of all contacts of a source, in any order; `state` has the grains.  Threads: pure. */
clod_measure_contacts clod_measure_contacts_from(const clod_state *state,
                                                 const clod_contact_source *contacts);

/** The same of state->contacts. */
clod_measure_contacts clod_measure_contacts_of(const clod_state *state);

/** Grains on which anything but their weight acts: those that are in contact and carry load.
 *  Threads: pure. */
size_t clod_measure_loaded_grains(const clod_state *state);

/** Kinetic energy of all grains, translation and rotation [J]; fastest grain [m/s]. */
double clod_measure_kinetic_energy(const clod_state *state);
double clod_measure_max_speed(const clod_state *state);
