#pragma once
/**
 * @file faces.h
 * Triangles of walls as the faces that an eye sees: smooth pieces, their normals, and the edges
 * between them.
 */

#include <stdint.h>

#include "clod/status.h"
#include "picture/scene.h"

/** Faces of a scene's triangles. */
typedef struct clod_faces {
    size_t count;
    int32_t *face;   ///< [triangles] owned: number of the face that a triangle is in
    uint8_t *turned; ///< [triangles] owned: its corners go round against those of its face
} clod_faces;

/**
 * Find the faces: triangles of one wall that meet at less than 30 degrees. Fills normal, lines
 * and end of the scene.
 *
 * @param self   [out] owned content (clod_faces_fini), also after a failure
 * @param scene  [in,out] corner and wall are read
 * Errors  CLOD_FAILED: no memory.   Threads  pure.   Test  tests/picture/test_cutaway.c
 */
bool clod_faces_make(clod_faces *self, clod_scene *scene, clod_status *status);

void clod_faces_fini(clod_faces *self);
