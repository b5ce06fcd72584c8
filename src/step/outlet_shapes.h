#pragma once
/**
 * @file outlet_shapes.h
 * Surfaces that remove grains which touch them. They have no contacts: a grain goes into one
 * until the next rebuild finds it there. Between two rebuilds a grain and a wall move by no more
 * than the smallest grain's diameter against each other (clod_neighbour_choose_skin), so none
 * passes through.
 */

#include "geometry/wall_rows.h"

/** One of them. */
typedef struct clod_outlet_shape {
    int32_t wall, shape;
    int32_t outlet;         ///< number from 0
    double low[3], high[3]; ///< m, box that it does not leave
} clod_outlet_shape;

typedef struct clod_outlet_shapes {
    clod_outlet_shape *of; ///< owned [count]
    int32_t count;
    double low[3], high[3]; ///< m, box about all
} clod_outlet_shapes;

/** List those of the walls; false without memory. */
bool clod_outlet_shapes_list(clod_outlet_shapes *self, const clod_walls *walls);

/** Note where they are now. @param rows  [in,out] of the walls; those of these shapes are made
 *  anew */
void clod_outlet_shapes_place(clod_outlet_shapes *self, clod_wall_rows *rows,
                              const clod_walls *walls);

/** The outlet, of lowest number, that a grain touches where they were placed; -1: none.
 *  @param position  [4] centre and radius [m].   Threads  pure. */
int32_t clod_outlet_shapes_touched(const clod_outlet_shapes *self, const clod_wall_rows *rows,
                                   const double *position);

void clod_outlet_shapes_fini(clod_outlet_shapes *self);
