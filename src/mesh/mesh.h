#pragma once
/**
 * @file mesh.h
 * What a mesh is made of, for the steps that make one: vertices (mesh_vertices), facets
 * (mesh_facets), edges (mesh_edges), seams (mesh_seams), shells (mesh_shells).
 */

#include "base/vec3.h"
#include "clod/mesh.h"

struct clod_mesh {
    clod_mesh_view view; ///< the counts; its arrays are those below
    char *path;          ///< owned, for reports
    double unit;         ///< m, of the file
    double (*vertices)[3];
    uint32_t (*facets)[3];
    uint32_t *part, *number, *shell;
    uint16_t *found;
    uint32_t (*neighbours)[3];
    uint8_t (*edges)[3];
    uint8_t *ends; ///< [facet_count] bit e: a piece of edge e on a T has no partner, or several
    uint32_t (*overlaps)[2]; ///< [overlap_count] pairs of facets that lie over each other
    size_t overlap_count;
    size_t unsearched; ///< facets for which no others over or through them were looked for
    clod_mesh_part *parts;
    size_t read_facets; ///< of the file
    double weld;        ///< m, distance up to which vertices are one: four steps of a float
    clod_mesh_finding findings[CLOD_MESH_KINDS];
};

/** Record a finding at a facet. */
void clod_mesh_note(clod_mesh *self, clod_mesh_kind kind, uint32_t facet, clod_vec3 point);

/** Record a finding at a facet that has to do with another one. */
void clod_mesh_note_pair(clod_mesh *self, clod_mesh_kind kind, uint32_t facet, uint32_t other,
                         clod_vec3 point);

/** Record that there is no memory; false. */
bool clod_mesh_lacks_memory(const clod_mesh *self, clod_status *status);

/** Lengths of a triangle [m]. */
typedef struct clod_mesh_triangle {
    clod_vec3 normal; ///< unit; 0 without area
    double area;      ///< m2
    double shortest, longest;
    double height; ///< over the longest edge, the smallest of the three
} clod_mesh_triangle;

/** Place of a vertex. */
static inline clod_vec3 clod_mesh_vertex(const clod_mesh *self, uint32_t vertex)
{
    const double *at = self->vertices[vertex];
    return clod_vec3_of(at);
}

/** Corner c, 0 to 2, of a facet; 3 is 0 again. */
static inline clod_vec3 clod_mesh_corner(const clod_mesh *self, uint32_t facet, int c)
{
    return clod_mesh_vertex(self, self->facets[facet][c % 3]);
}

/** Middle of an edge of a facet. */
static inline clod_vec3 clod_mesh_middle(const clod_mesh *self, uint32_t facet, int edge)
{
    const clod_vec3 a = clod_mesh_corner(self, facet, edge);
    return clod_vec3_scale(clod_vec3_add(a, clod_mesh_corner(self, facet, edge + 1)), 0.5);
}

/** Centroid of a facet. */
static inline clod_vec3 clod_mesh_centre(const clod_mesh *self, uint32_t facet)
{
    const clod_vec3 a = clod_mesh_corner(self, facet, 0);
    const clod_vec3 b = clod_mesh_corner(self, facet, 1);
    return clod_vec3_scale(clod_vec3_add(clod_vec3_add(a, b), clod_mesh_corner(self, facet, 2)),
                           1.0 / 3.0);
}

/** Measure a facet. */
clod_mesh_triangle clod_mesh_measure(const clod_mesh *self, uint32_t facet);
