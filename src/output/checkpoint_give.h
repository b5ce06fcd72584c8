#pragma once
/**
 * @file checkpoint_give.h
 * Grains and contacts of a checkpoint, given away slab by slab as they are read.
 */

#include "output/hdf.h"
#include "state/bed_taker.h"

/**
 * Read all grains, then all contacts; the walls are those of the file.
 *
 * @param state  what the taker leaves of the grains
 * @param path   of the file, for messages
 * @return       false: contacts that do not fit the walls, no memory, or what the taker says;
 *               errors of the file are those of `hdf`
 * Test  tests/sim/test_deal_again.c
 */
bool clod_checkpoint_give(clod_hdf *hdf, clod_state *state, const clod_bed_taker *taker,
                          const char *path, clod_status *status);
