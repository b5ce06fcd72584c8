#pragma once
/**
 * @file stage.h
 * The files of a frame on their way into a scene: grains with their colours, walls without what
 * is hidden by request or has no end.
 */

#include "picture/channel.h"
#include "picture/cutaway.h"

/** What all frames have in common. */
typedef struct clod_stage {
    const clod_channel *grains, *walls; ///< colours; walls->field may be NULL
    const bool *hidden;                 ///< [hidden_count] walls that are not shown
    size_t hidden_count;
    clod_cutaway_box clip; ///< planes end here
} clod_stage;

/** Triangles of a file of walls; owned, or NULL. @param wall  [out] owned: their numbers */
double (*clod_stage_read_walls(const clod_vtkhdf *file, int32_t **wall,
                               clod_status *status))[3][3];

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
