#pragma once
/**
 * @file wall_rows.h
 * All walls as they are at one moment, in rows of four numbers that kernels load by number: the
 * shapes of all walls in space (wall_closest.h), and how each wall moves. Turned and shifted
 * once per wall and step, so a contact meets its shape where it is.
 *
 * A shape that its wall's turning leaves where it is (clod_shape.symmetric) is never turned,
 * and one of a wall at rest is exactly the one that was given.
 */

#include <math.h>

#include "geometry/wall_closest.h"
#include "geometry/wall_gap.h"
#include "state/walls.h"

/** Rows of a shape, and of a wall: its velocity [m/s], its spin [rad/s], where it turns [m]. */
enum { CLOD_SHAPE_ROWS = 4, CLOD_WALL_ROWS = 3 };

typedef struct clod_wall_rows {
    double (*shape)[4];   ///< [(shapes + 1) * CLOD_SHAPE_ROWS]; the last one is for padding
    double (*wall)[4];    ///< [walls * CLOD_WALL_ROWS]
    int32_t *first_shape; ///< [walls + 1] number of each wall's first shape
    double (*at)[4];      ///< [walls] shift and angle that its shapes' rows are for
    double *reach;        ///< [walls] clod_wall_reach [m]
} clod_wall_rows;

/**
 * Rows of the walls where they are now.
 *
 * @return  false without memory
 * Errors  false.   Threads  one per set of rows, as for the rest of this file; looking is free.
 * Test    tests/geometry/test_wall_rows.c
 */
bool clod_wall_rows_init(clod_wall_rows *self, const clod_walls *walls);

/** The walls have moved: the same rows for where they are now. */
void clod_wall_rows_update(clod_wall_rows *self, const clod_walls *walls);

/** Rows of wall `w` alone, where `wall` says it is. */
void clod_wall_rows_place(clod_wall_rows *self, int32_t w, const clod_wall *wall);

/** First row of the shape that every point is at distance 0 from: padding grains have R < 0. */
static inline int32_t clod_wall_rows_padding(const clod_wall_rows *self, int32_t walls)
{
    return CLOD_SHAPE_ROWS * self->first_shape[walls];
}

/** First row of a shape of a wall. */
static inline int32_t clod_wall_rows_shape(const clod_wall_rows *self, int32_t w, int32_t shape)
{
    return CLOD_SHAPE_ROWS * (self->first_shape[w] + shape);
}

/** Gap between a shape of a wall and a point of space [m]. */
static inline clod_gap clod_wall_rows_gap(const clod_wall_rows *self, int32_t w, int32_t shape,
                                          const double p[3])
{
    return clod_wall_gap_rows((const double(*)[4])self->shape +
                                  clod_wall_rows_shape(self, w, shape),
                              (clod_vec3){p[0], p[1], p[2]});
}

/**
 * Whether a point is farther than `reach` [m] from a shape for sure: outside the sphere about a
 * box or bar, made larger by so much. False says nothing.
 */
static inline bool clod_wall_rows_is_far(const clod_wall_rows *self, int32_t w, int32_t shape,
                                         const double p[3], double reach)
{
    const double(*row)[4] =
        (const double(*)[4])self->shape + clod_wall_rows_shape(self, w, shape);
    double apart2 = 0.0;
    double half2 = 0.0;
    for (int a = 0; a < 3; a++) {
        apart2 += (p[a] - row[0][a]) * (p[a] - row[0][a]);
        half2 += row[1 + a][3] * row[1 + a][3];
    }
    const double most = sqrt(half2) + reach;
    return row[0][3] == CLOD_WALL_BOX && apart2 > most * most;
}

/**
 * Box along the axes that a shape of a wall does not leave [m]; a plane's is endless.
 *
 * @param low, high  [out] [3]
 * Errors  none.   Threads  pure.   Test  tests/step/test_many_walls.c
 */
void clod_wall_rows_box(const clod_wall_rows *self, int32_t w, int32_t shape, double low[3],
                        double high[3]);

void clod_wall_rows_fini(clod_wall_rows *self);
