#pragma once
/**
 * @file checkpoint_contacts.h
 * The contacts of a checkpoint, on their way between a file and a state slab by slab.
 */

#include "output/hdf.h"
#include "state/bed_source.h"

/**
 * Write all contacts.
 *
 * @param bed  has begun
 * @param all  what it has
 * @return     false without memory; errors of the file are those of `hdf`
 */
bool clod_checkpoint_contacts_put(clod_hdf *hdf, const clod_bed_source *bed,
                                  const clod_bed_counts *all, clod_status *status);

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
