#pragma once
/**
 * @file mesh_findings.h
 * Words for what can be found in a mesh, in the order of clod_mesh_kind and clod_mesh_edge.
 */

#include "clod/mesh.h"

typedef struct clod_mesh_words {
    const char *key;    ///< in JSON
    const char *one;    ///< noun behind 1
    const char *many;   ///< noun behind other numbers
    const char *what;   ///< behind the noun
    const char *action; ///< what clod does about it
    const char *advice; ///< for the user; "" = none
} clod_mesh_words;

extern const clod_mesh_words CLOD_MESH_FINDINGS[CLOD_MESH_KINDS];
extern const char *const CLOD_MESH_EDGES[CLOD_MESH_EDGE_KINDS];
