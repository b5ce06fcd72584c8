#pragma once
/**
 * @file checkpoint_columns.h
 * The one table of what a checkpoint holds: name, units, type, shape and place in the state.
 * Writing and reading walk the same table.
 */

#include "output/hdf.h"
#include "state/state.h"

#define CLOD_CHECKPOINT_COLUMNS 80

/** A column with a row for each plane; there is none without planes. */
#define CLOD_CHECKPOINT_PLANES "planes/region"

typedef struct clod_checkpoint_columns {
    clod_hdf_column column[CLOD_CHECKPOINT_COLUMNS];
    size_t count;
    char name[CLOD_HISTORY_FIELDS][32]; ///< of the columns of histories
} clod_checkpoint_columns;

/**
 * List every column of the state but those of its grains, contacts, walls and their shapes.
 *
 * The pointers are borrowed from the state: list again when its arrays have moved. Arrays that
 * the state does not have or that have no rows (build_walls, planes) are not listed.
 */
void clod_checkpoint_columns_list(clod_checkpoint_columns *self, const clod_state *state);

/** List the columns of the grains of a state, likewise (build_position). */
void clod_checkpoint_columns_of_grains(clod_checkpoint_columns *self, const clod_state *state);

/**
 * List the columns of contacts. They are known by their partners: the ids of two grains, the
 * earlier one in the order of forces first; or the id of a grain and the number of a wall.
 *
 * @param contacts  [rows] borrowed
 * @param partners  [rows] of each contact, borrowed
 */
void clod_checkpoint_columns_of_contacts(clod_checkpoint_columns *self,
                                         const clod_contact *contacts,
                                         const uint64_t (*partners)[2], size_t rows);

/** List the columns of walls: all of them but for their shapes. */
void clod_checkpoint_columns_of_walls(clod_checkpoint_columns *self, const clod_wall *walls,
                                      size_t rows);

/** List the columns of shapes, those of the first wall first; `symmetric` follows from the
 * rest. */
void clod_checkpoint_columns_of_shapes(clod_checkpoint_columns *self, const clod_shape *shapes,
                                       size_t rows);

/** List the sums of places of walls (state/wear.h), those of the first wall first. */
void clod_checkpoint_columns_of_wear(clod_checkpoint_columns *self,
                                     const double (*sums)[CLOD_WEAR_SUMS], size_t rows);

/** Write all columns of a list, or read them into where they point; `hdf` notes failures. */
void clod_checkpoint_columns_put(const clod_checkpoint_columns *self, clod_hdf *hdf);
void clod_checkpoint_columns_get(const clod_checkpoint_columns *self, clod_hdf *hdf);

/** How many of the contacts, the last ones, are with walls. */
clod_hdf_column clod_checkpoint_columns_wall_count(const size_t *count);
