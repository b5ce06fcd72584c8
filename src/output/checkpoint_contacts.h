#pragma once
/**
 * @file checkpoint_contacts.h
 * The contacts of a checkpoint, on their way from a file into a state slab by slab.
 */

#include "output/hdf.h"
#include "state/state.h"

/**
 * Fill state->contacts, which has room for all of them, and find their rows; the grains and
 * walls are those of the file.
 *
 * @param path  of the file, for messages
 * @return      false: contacts that do not fit the grains and walls, or no memory; errors of
 * the file are those of `hdf`
 */
bool clod_checkpoint_contacts_get(clod_hdf *hdf, clod_state *state, const char *path,
                                  clod_status *status);
