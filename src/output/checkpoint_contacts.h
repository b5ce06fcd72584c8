#pragma once
/**
 * @file checkpoint_contacts.h
 * The contacts of a checkpoint, on their way between a file and a state slab by slab.
 */

#include "output/hdf.h"
#include "state/contact_source.h"

/**
 * Write all contacts.
 *
 * @param source  NULL: the state's own list
 * @return        false without memory; errors of the file are those of `hdf`
 */
bool clod_checkpoint_contacts_put(clod_hdf *hdf, const clod_state *state,
                                  const clod_contact_source *source, clod_status *status);

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
