#pragma once
/**
 * @file wall_rows.h
 * All walls as they are at one moment, in rows of four numbers that kernels load by number:
 * each shape in space (wall_closest.h), and how its material moves. Turned and shifted once per
 * step, so a contact meets its shape where it is.
 *
 * A shape that its wall's turning leaves where it is (clod_shape.symmetric) is never turned,
 * and one of a wall at rest is exactly the one that was given.
 *
 * The material of a shape at a point p moves with v + w x lever + u: lever = p - origin; v and
 * w are the velocity and spin of the wall; u = b + w_b x lever + s t without what of it is
 * normal to the surface is that of the belt, t the unit vector along the projection of a
 * direction onto the surface.
 */

#include <math.h>

#include "geometry/wall_closest.h"
#include "geometry/wall_facets.h"
#include "geometry/wall_gap.h"
#include "geometry/wall_pose.h"
#include "state/walls.h"

/** Numbers that a wall's rows follow from: pose, and motion of the wall. */
#define CLOD_WALL_MOTION_NUMBERS 10

/** Of which patch of a mesh a shape is a contact; no surface: it is no mesh. */
typedef struct clod_wall_patch {
    const clod_surface *surface; ///< borrowed from the wall's shape
    int32_t patch, slot;
} clod_wall_patch;

typedef struct clod_wall_rows {
    clod_wall_patch *patch; ///< [shapes]
    double (*shape)[4];     ///< [(shapes + CLOD_FORMS) * CLOD_SHAPE_ROWS]; the last for padding
    int32_t *first_shape;   ///< [walls + 1] number of each wall's first shape
    double (*pose)[CLOD_WALL_POSE_NUMBERS];     ///< [walls] that all rows of a wall are for
    double (*motion)[CLOD_WALL_MOTION_NUMBERS]; ///< [walls] the same
    double *reach;                              ///< [walls] clod_wall_reach [m]
} clod_wall_rows;

/** Where a wall is and how it moves, in all that its shapes need to know of it. */
typedef struct clod_wall_placement {
    const clod_wall *wall;
    clod_wall_pose now, rest; ///< rest: at angle 0
    clod_vec3 velocity, spin; ///< m/s, rad/s
    bool turned, given;       ///< has an angle; has the orientation in which it was given
} clod_wall_placement;

/** Where a wall is and how it moves; `wall` is borrowed. Threads: pure. */
clod_wall_placement clod_wall_placement_of(const clod_wall *wall);

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

/** Rows of wall `w` alone, where `wall` says it is; nothing to do where they are for that. */
void clod_wall_rows_place(clod_wall_rows *self, int32_t w, const clod_wall *wall);

/**
 * Rows of one shape of wall `w`, as its wall is placed, whatever they were for. Threads: other
 * shapes may be placed at the same time.
 */
void clod_wall_rows_place_shape(clod_wall_rows *self, int32_t w,
                                const clod_wall_placement *placement, int32_t shape);

/** Place wall `w` anew the next time: belts of its shapes have changed. */
void clod_wall_rows_forget(clod_wall_rows *self, int32_t w);

/** Note that all shapes of wall `w` have been placed where `wall` says it is. */
void clod_wall_rows_note(clod_wall_rows *self, int32_t w, const clod_wall *wall);

/** First row of a form's shape that no point is within: padding grains have R < 0. */
static inline int32_t clod_wall_rows_padding(const clod_wall_rows *self, int32_t walls,
                                             clod_wall_form form)
{
    return CLOD_SHAPE_ROWS * (self->first_shape[walls] + (int32_t)form);
}

/** Form of a shape, by its first row. */
static inline clod_wall_form clod_wall_rows_form(const clod_wall_rows *self, int32_t row)
{
    return clod_wall_form_of(self->shape[row][3]);
}

/** First row of a shape of a wall. */
static inline int32_t clod_wall_rows_shape(const clod_wall_rows *self, int32_t w, int32_t shape)
{
    return CLOD_SHAPE_ROWS * (self->first_shape[w] + shape);
}

/** Patch of a mesh that a shape is. */
static inline const clod_wall_patch *clod_wall_rows_patch(const clod_wall_rows *self, int32_t w,
                                                          int32_t shape)
{
    return &self->patch[self->first_shape[w] + shape];
}

/** Gap between a shape of a wall and a point of space [m]. */
static inline clod_gap clod_wall_rows_gap(const clod_wall_rows *self, int32_t w, int32_t shape,
                                          const double p[3])
{
    const double(*row)[4] =
        (const double(*)[4])self->shape + clod_wall_rows_shape(self, w, shape);
    if (row[0][3] != CLOD_WALL_MESH) {
        return clod_wall_gap_rows(row, clod_vec3_of(p));
    }
    const clod_wall_patch *at = clod_wall_rows_patch(self, w, shape);
    const clod_wall_pose pose = clod_wall_facets_pose(row);
    const clod_gap gap =
        clod_wall_gap_patch(at->surface, at->patch, clod_wall_to_frame(&pose, clod_vec3_of(p)));
    return (clod_gap){gap.distance, clod_wall_to_space(&pose, gap.normal)};
}

/**
 * Whether a contact of a point, the centre of a grain, with a shape may be within `reach` [m]:
 * the gap is smaller. A mesh's patch has contacts beyond its first slot near its rims alone.
 */
bool clod_wall_rows_is_near(const clod_wall_rows *self, int32_t w, int32_t shape,
                            const double p[3], double reach);

/**
 * Whether some point within `half` of a point p of space may be within `reach` of a shape [m]: of
 * a mesh's patch by the box about it. Gaps change by no more than the way between two points.
 */
bool clod_wall_rows_may_reach(const clod_wall_rows *self, int32_t w, int32_t shape,
                              const double p[3], double half, double reach);

/**
 * Box along the axes that a shape of a wall does not leave [m]; a plane's is endless.
 *
 * @param low, high  [out] [3]
 * Errors  none.   Threads  pure.   Test  tests/step/test_many_walls.c
 */
void clod_wall_rows_box(const clod_wall_rows *self, int32_t w, int32_t shape, double low[3],
                        double high[3]);

void clod_wall_rows_fini(clod_wall_rows *self);
