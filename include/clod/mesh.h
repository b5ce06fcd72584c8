#pragma once
/**
 * @file mesh.h
 * Triangle meshes from STL, OBJ and PLY files: read, checked, repaired where that is safe, and
 * what was found told. docs/meshes.md says what each finding means. A NULL where an argument is
 * needed: see clod/status.h.
 */

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "clod/case.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

#define CLOD_MESH_FACETS_MOST 5000000   ///< facets of a file
#define CLOD_MESH_BYTES_MOST 2000000000 ///< bytes of a file
#define CLOD_MESH_PARTS_MOST 4096       ///< named parts of a file
#define CLOD_MESH_NAME_MOST 255         ///< bytes of the name of a part

/** No facet: the neighbour over an open edge. */
#define CLOD_MESH_NONE UINT32_MAX

/** A mesh; create with clod_mesh_read or clod_mesh_parse. It does not change afterwards. */
typedef struct clod_mesh clod_mesh;

/** How the numbers of a file become places, in this order: unit, scale, rotate, move. */
typedef struct clod_mesh_placing {
    double unit;               ///< m, one unit of the file; > 0
    double scale;              ///< > 0
    clod_case_rotation rotate; ///< of the scaled mesh; point in m
    double move[3];            ///< m
} clod_mesh_placing;

/** What lies over an edge of a facet, seen from the side of its normal. */
typedef enum clod_mesh_edge {
    CLOD_MESH_EDGE_FLAT,        ///< one facet in the same plane (docs/meshes.md: tolerance)
    CLOD_MESH_EDGE_CONVEX,      ///< one facet that bends away from the normal
    CLOD_MESH_EDGE_CONCAVE,     ///< one facet that bends towards the normal
    CLOD_MESH_EDGE_OPEN,        ///< nothing
    CLOD_MESH_EDGE_T,           ///< edges of different lengths on one line
    CLOD_MESH_EDGE_NONMANIFOLD, ///< two or more facets
    CLOD_MESH_EDGE_KINDS,
} clod_mesh_edge;

/** A named part: an STL solid, an OBJ object or group; the only one of a PLY has no name. */
typedef struct clod_mesh_part {
    char *name;    ///< "" = none; printable UTF-8, up to CLOD_MESH_NAME_MOST bytes
    size_t facets; ///< that are kept
} clod_mesh_part;

/** Arrays of a mesh, borrowed from it. Corners of a facet are in the order of its normal. */
typedef struct clod_mesh_view {
    size_t vertex_count, facet_count, part_count;
    const double (*vertices)[3]; ///< [vertex_count] m
    const uint32_t (*facets)[3]; ///< [facet_count] vertices
    const uint32_t *part;        ///< [facet_count] index into parts
    const uint32_t *number;      ///< [facet_count] number of the facet in its file, from 1
    const uint32_t (
        *neighbours)[3];       ///< [facet_count] facet over the edge from corner e to e + 1,
                               ///< one of them where there are several; CLOD_MESH_NONE
    const uint8_t (*edges)[3]; ///< [facet_count] clod_mesh_edge of these edges
    const uint32_t *shell;     ///< [facet_count] connected piece, from 0
    const uint16_t *found;     ///< [facet_count] bit k: clod_mesh_kind k was found here; of
                               ///< DUPLICATE: at facets in its place that were dropped
    size_t shell_count;
    const clod_mesh_part *parts; ///< [part_count] in the order of the file
} clod_mesh_view;

/**
 * Read a mesh file and make it ready: join vertices, drop degenerate and duplicate facets, turn
 * facets that disagree with their neighbours, class edges.
 *
 * @param path     a regular file; .stl (text or binary), .obj or .ply, in any case
 * @param placing  of its numbers
 * @return         owned mesh (clod_mesh_destroy), or NULL
 * Errors  CLOD_USAGE: a NULL; with file, line or facet, value and what to do; also a file that is too
 *         large, before memory is taken. CLOD_FAILED: the disk, memory.
 * Threads safe; one at a time is in Assimp.   Test  tests/mesh/test_mesh_read.c
 */
clod_mesh *clod_mesh_read(const char *path, const clod_mesh_placing *placing,
                          clod_status *status);

/** The same from the content of a file; `path` is its name in messages and gives the format. */
clod_mesh *clod_mesh_parse(const char *path, const char *bytes, size_t length,
                           const clod_mesh_placing *placing, clod_status *status);

/** Free and null; NULL is fine. */
void clod_mesh_destroy(clod_mesh **self);

/** Arrays of the mesh; they live as long as it does. */
const clod_mesh_view *clod_mesh_look(const clod_mesh *self);

/** What can be found in a mesh. */
typedef enum clod_mesh_kind {
    CLOD_MESH_WELDED,      ///< vertices that differed by rounding
    CLOD_MESH_DEGENERATE,  ///< facets without area
    CLOD_MESH_DUPLICATE,   ///< facets with the corners of another
    CLOD_MESH_TURNED,      ///< facets whose normal disagreed with their neighbours
    CLOD_MESH_TWISTED,     ///< edges where no turning makes normals agree (a Moebius strip)
    CLOD_MESH_OPEN,        ///< edges of one facet
    CLOD_MESH_T,           ///< edges with a vertex of another facet inside
    CLOD_MESH_NONMANIFOLD, ///< edges of three or more facets
    CLOD_MESH_NEEDLE,      ///< facets with one very short edge
    CLOD_MESH_SLIVER,      ///< facets with a very small height and no very short edge
    CLOD_MESH_OVERLAP,     ///< facets that lie over an earlier one in one plane
    CLOD_MESH_CROSSING,    ///< facets that cut through another one
    CLOD_MESH_KINDS,
} clod_mesh_kind;

#define CLOD_MESH_PLACES 5

/** Where something was found. */
typedef struct clod_mesh_place {
    uint32_t number; ///< of the facet in its file, from 1
    uint32_t part;
    double point[3]; ///< m
    uint32_t other;  ///< of CLOD_MESH_OVERLAP: number of the earliest facet below; of
                     ///< CLOD_MESH_CROSSING: of the earliest that crosses it; else 0
} clod_mesh_place;

/** Everything of one kind that was found. */
typedef struct clod_mesh_finding {
    size_t count;
    clod_mesh_place places[CLOD_MESH_PLACES]; ///< of the first ones
} clod_mesh_finding;

#define CLOD_MESH_WARNINGS 8
#define CLOD_MESH_WARNING_TEXT 320

/** What the mesh doctor says. */
typedef struct clod_mesh_report {
    double box[2][3];   ///< m, smallest and largest coordinates
    double area;        ///< m2
    double volume;      ///< m3, negative when normals point inwards; NAN when the mesh is open
    bool closed;        ///< every edge has its partner
    size_t read_facets; ///< in the file, polygons cut into triangles
    size_t edges[CLOD_MESH_EDGE_KINDS]; ///< edges; on a T every facet's edge counts
    double shortest, median, longest;   ///< m, of the edges of facets
    double weld;                        ///< m, distance up to which vertices were joined
    double grain_radius;                ///< m; 0 = not given
    size_t small_facets;                ///< whose longest edge is less than a grain's radius
    clod_mesh_finding findings[CLOD_MESH_KINDS];
    size_t warning_count;
    char warnings[CLOD_MESH_WARNINGS][CLOD_MESH_WARNING_TEXT];
} clod_mesh_report;

/**
 * Measure a mesh and say what is doubtful about it.
 *
 * @param self          the mesh
 * @param grain_radius  m, radius of the grains that will touch it; 0 = not known
 * @param report        [out]
 * @return              false without memory
 * Errors  CLOD_USAGE: a NULL; CLOD_FAILED: memory.   Threads  pure.
 * Test    tests/mesh/test_mesh_report.c
 */
bool clod_mesh_examine(const clod_mesh *self, double grain_radius, clod_mesh_report *report,
                       clod_status *status);

/** A report for people; owned text (clod_mesh_free), or NULL without memory. */
char *clod_mesh_text(const clod_mesh *self, const clod_mesh_report *report);

/** The same as JSON, units in the names; owned text (clod_mesh_free), or NULL. */
char *clod_mesh_json(const clod_mesh *self, const clod_mesh_report *report);

/** Free a text of this header; NULL is fine. */
void clod_mesh_free(void *memory);

/**
 * Read a length with its unit.
 *
 * @param text    for instance "3 mm"; a unit alone is one of it
 * @param metres  [out] m, > 0
 * Errors  CLOD_USAGE: a NULL, no length, no unit, not above 0.   Threads  safe.
 * Test    tests/config/test_mesh_unit.c
 */
bool clod_mesh_unit(const char *text, double *metres, clod_status *status);

#ifdef __cplusplus
}
#endif
