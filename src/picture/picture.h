#pragma once
/**
 * @file picture.h
 * Pictures of a run: its snapshots drawn as PNG, one run or two side by side.
 *
 * Grains are spheres, walls triangles; the ray tracer is Tachyon, text and bars are cairo's.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/mesh.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** From where a picture is taken, if nothing else is said. */
typedef enum clod_picture_view {
    CLOD_PICTURE_OBLIQUE, ///< from the front, one side and above
    CLOD_PICTURE_FRONT,   ///< along y
    CLOD_PICTURE_SIDE,    ///< against x
    CLOD_PICTURE_TOP,     ///< against z
} clod_picture_view;

/** How much work goes into a picture. */
typedef enum clod_picture_quality {
    CLOD_PICTURE_DRAFT,
    CLOD_PICTURE_NORMAL,
    CLOD_PICTURE_HIGH, ///< light from the whole sky
} clod_picture_quality;

typedef struct clod_picture_options {
    const char *run;          ///< results folder
    const char *beside;       ///< a second one, shown at the right; NULL: none
    const char *part;         ///< of a test; NULL: the only one
    bool all;                 ///< every snapshot, not one
    const double *time;       ///< s: the nearest snapshot; NULL: the last one
    const char *field;        ///< that colours the grains
    const char *wall_field;   ///< that colours the walls; NULL: steel and belts
    const char *map;          ///< colour map of the grains; NULL: by the values
    const double *range;      ///< [2] of the field; NULL: by the values
    const double *wall_range; ///< [2] of wall_field; NULL: by the values
    const char *const
        *hidden; ///< [hidden_count] walls to leave out, by name or number, and parts: WALL.PART
    size_t hidden_count;
    int view;           ///< clod_picture_view
    const double *from; ///< [3] m: where the eye is; NULL: where all is seen
    const double *at;   ///< [3] m: what it looks at; NULL: the middle
    double angle;       ///< of view from bottom to top [degrees]
    int width, height;  ///< pixels
    int quality;        ///< clod_picture_quality
    int threads;        ///< that draw one picture
} clod_picture_options;

/** How a mesh is drawn. */
typedef struct clod_picture_mesh {
    const char *title;
    const char *const *hidden; ///< [hidden_count] names of parts to leave out
    size_t hidden_count;
    int view;          ///< clod_picture_view
    int width, height; ///< pixels
    int quality;       ///< clod_picture_quality
    int threads;
} clod_picture_mesh;

/**
 * Draw a mesh into a PNG file, which is replaced at one stroke: each facet in the colour of what
 * was found about it and is done, with a legend.
 *
 * Errors  CLOD_USAGE: a hidden part that the mesh has not, or nothing left; CLOD_FAILED: disk,
 *         memory.   Threads  one at a time.   Test  tests/cli/test_mesh.py
 */
bool clod_picture_draw_mesh(const clod_mesh *mesh, const clod_picture_mesh *options,
                            const char *path, clod_status *status);

typedef struct clod_picture clod_picture;

/**
 * Look at all snapshots that are to be drawn: ranges of colours and camera are the same for all
 * of them.
 *
 * @param options  borrowed until the end
 * @return         owned pictures (clod_picture_close), or NULL
 * Errors  CLOD_USAGE: not a results folder, no snapshots, a damaged one, no such part, field,
 *         wall or map, a time outside; CLOD_FAILED: no memory.   Threads  one at a time.
 * Test    tests/cli/test_picture.py
 */
clod_picture *clod_picture_open(const clod_picture_options *options, clod_status *status);

/** How many pictures there are to draw. */
size_t clod_picture_count(const clod_picture *self);

/** Time of picture k of the (first) run [s]. */
double clod_picture_time(const clod_picture *self, size_t k);

/**
 * Draw picture k, k < clod_picture_count, into a PNG file, which is replaced at one stroke.
 * Errors  CLOD_USAGE: a damaged snapshot; CLOD_FAILED: disk, memory.   Threads  one at a time;
 *         processes that were forked may draw at the same time.
 */
bool clod_picture_draw(const clod_picture *self, size_t k, const char *path,
                       clod_status *status);

/** Free and null the pointer; NULL is fine. */
void clod_picture_close(clod_picture **self);

#ifdef __cplusplus
}
#endif
