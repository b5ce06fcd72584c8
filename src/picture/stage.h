#pragma once
/**
 * @file stage.h
 * The files of a frame on their way into a scene: grains with their colours, walls without what
 * is hidden by request or has no end.
 */

#include "picture/channel.h"
#include "picture/cutaway.h"

/** Parts that are not shown. */
typedef struct clod_stage_part {
    const char *name; ///< borrowed: "WALL.PART"
    bool any_shape;   ///< of all shapes of the wall: "WALL.1.PART", "WALL.2.PART" ...
} clod_stage_part;

/** What of the walls is not shown. */
typedef struct clod_stage_hidden {
    bool *wall; ///< [wall_count] owned by number
    size_t wall_count;
    clod_stage_part *part; ///< [part_count] owned
    size_t part_count;
} clod_stage_hidden;

/** What all frames have in common. */
typedef struct clod_stage {
    const clod_channel *grains, *walls; ///< colours; walls->field may be NULL
    const clod_stage_hidden *hidden;
    clod_cutaway_box clip; ///< planes end here
} clod_stage;

/** Triangles of a file of walls; all owned. */
typedef struct clod_stage_walls {
    size_t count;
    double (*corner)[3][3]; ///< [count] m
    int32_t *wall;          ///< [count] number of the wall
    int32_t *part;          ///< [count] number of the named part; -1: none
    bool *plane;            ///< [count] the first of two that show a plane without an end
    bool *hidden;           ///< [count]
} clod_stage_walls;

/**
 * Whether the name of a part in a file is asked for. Characters that clod does not write into
 * names match the _ in their place.
 *
 * @param name    [length]
 * Threads  pure.   Test  tests/cli/test_part_names.py
 */
bool clod_stage_is_part(const clod_stage_part *asked, const char *name, size_t length);

/**
 * Read the triangles of a file of walls. Which of them show a plane is told by the column
 * `shape`; in a file without it, written before there was one, none do: its planes are drawn as
 * the squares that they are there.
 *
 * @param hidden  what is not to be shown
 * @param self    [out] clod_stage_walls_fini in any case
 * Errors  CLOD_USAGE: a damaged file; CLOD_FAILED: no memory.
 */
bool clod_stage_walls_read(clod_stage_walls *self, const clod_vtkhdf *file,
                           const clod_stage_hidden *hidden, clod_status *status);

void clod_stage_walls_fini(clod_stage_walls *self);

/**
 * Load a frame.
 *
 * @param scene  [out] owned content (clod_scene_fini), also after a failure; without normals,
 *               lines and veils
 * Errors  CLOD_USAGE: a damaged file, no such field; CLOD_FAILED: no memory.
 * Threads one at a time.   Test  tests/cli/test_picture.py
 */
bool clod_stage_load(const clod_stage *self, const clod_film_frame *frame, clod_scene *scene,
                     clod_status *status);
