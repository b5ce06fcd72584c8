#pragma once
/**
 * @file mesh_ply.h
 * A PLY file while it is checked: what its header announces.
 */

#include "mesh/mesh_source.h"
#include "mesh/mesh_words.h"

#define CLOD_MESH_PLY_PROPERTIES 64 ///< of an element

typedef enum clod_mesh_ply_form {
    CLOD_MESH_PLY_TEXT,
    CLOD_MESH_PLY_LITTLE, ///< the least byte of a number comes first
    CLOD_MESH_PLY_BIG,
} clod_mesh_ply_form;

typedef struct clod_mesh_ply_property {
    int size;      ///< bytes; of a list: of one item
    bool whole;    ///< an integer
    bool negative; ///< an integer that may be below 0
    int axis;      ///< 0, 1, 2 of x, y, z; -1 = none of them
    int counter;   ///< bytes of the number of items; 0 = no list
} clod_mesh_ply_property;

typedef struct clod_mesh_ply_element {
    int64_t count;
    bool known;
    clod_mesh_ply_property properties[CLOD_MESH_PLY_PROPERTIES];
    size_t property_count;
    int axes[3], lists; ///< how many of its properties are x, y, z, and lists
} clod_mesh_ply_element;

enum { CLOD_MESH_PLY_VERTEX, CLOD_MESH_PLY_FACE, CLOD_MESH_PLY_ELEMENTS };

typedef struct clod_mesh_ply {
    clod_mesh_source *source;
    clod_mesh_cursor at;
    clod_mesh_ply_form form;
    clod_mesh_ply_element elements[CLOD_MESH_PLY_ELEMENTS];
    clod_mesh_ply_element *open; ///< that properties belong to
    clod_status *status;
} clod_mesh_ply;

/** The file ends in the item `number`, from 1, of `count`; false. */
bool clod_mesh_ply_fail_end(const clod_mesh_ply *self, const char *what, int64_t number,
                            int64_t count);

/** Whether a face may have so many corners. */
bool clod_mesh_ply_check_count(const clod_mesh_ply *self, int64_t face, uint64_t corners);

/** Whether a corner is a vertex that there is. */
bool clod_mesh_ply_check_corner(const clod_mesh_ply *self, int64_t face, uint64_t vertex);

/**
 * Check what follows the header of a binary file, and write the file anew for Assimp: single
 * precision, no other properties, and in front of each vertex a byte. Assimp 5.2.5 takes a line
 * feed at the very begin of the data, as one of 128 files has it, for a part of the header, and
 * then reads beyond the end.
 */
bool clod_mesh_ply_binary_check(clod_mesh_ply *self);
