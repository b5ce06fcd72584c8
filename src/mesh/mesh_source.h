#pragma once
/**
 * @file mesh_source.h
 * Content of a mesh file, and the checks of each format. Assimp is lenient: it skips what it does
 * not understand, and memory is taken for whatever a header promises. So a format's check goes
 * first: it knows the grammar, tells line or facet of what is wrong, counts facets and notes the
 * parts. It hands on what clod needs and blanks the rest (names, normals, materials, textures).
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/mesh.h"

/** Corners of a polygon that is cut into triangles; Assimp's time grows with their square. */
#define CLOD_MESH_CORNERS_MOST 255

/** Vertices of a file: all that facets can have. */
#define CLOD_MESH_VERTICES_MOST (3 * CLOD_MESH_FACETS_MOST)

/** Place of a vertex behind those of the file, in its unit. */
static const int CLOD_MESH_END[3] = {1, 2, 3};

/** Triangles of one part that follow each other. */
typedef struct clod_mesh_run {
    uint32_t part;
    size_t facets;
} clod_mesh_run;

typedef struct clod_mesh_source {
    const char *path;      ///< for messages
    const char *extension; ///< "stl", "obj" or "ply"; static
    char *bytes;           ///< owned, a zero byte behind their end; checks write into them
    size_t length;
    size_t begin;          ///< first byte that Assimp is given
    clod_mesh_part *parts; ///< [part_room] owned, with names
    size_t part_count, part_room;
    uint32_t *slots;     ///< hash table of part names, index + 1; 0 = free
    clod_mesh_run *runs; ///< [run_room] owned
    size_t run_count, run_room;
    size_t facets; ///< triangles
    size_t
        extra; ///< triangles behind them that no file has, 0 or 1, of a vertex at CLOD_MESH_END
} clod_mesh_source;

/** Find the format by the extension of `path`. Errors CLOD_USAGE: none of the three. */
bool clod_mesh_source_init(clod_mesh_source *self, const char *path, clod_status *status);

/** Check the content by its format. Errors CLOD_USAGE: what is wrong, and where. */
bool clod_mesh_source_check(clod_mesh_source *self, clod_status *status);

/**
 * The facets that follow belong to the part of this name, which may be new.
 *
 * @param line  of the file, for messages
 * Errors  CLOD_USAGE: a name that is too long, too many parts.
 */
bool clod_mesh_source_part(clod_mesh_source *self, const char *name, size_t length, size_t line,
                           clod_status *status);

/** Count triangles; without a part before, they belong to one without a name. */
bool clod_mesh_source_add(clod_mesh_source *self, size_t triangles, clod_status *status);

/** Free everything; an empty one is fine. */
void clod_mesh_source_fini(clod_mesh_source *self);

bool clod_mesh_stl_check(clod_mesh_source *self, clod_status *status);
bool clod_mesh_obj_check(clod_mesh_source *self, clod_status *status);
bool clod_mesh_ply_check(clod_mesh_source *self, clod_status *status);
