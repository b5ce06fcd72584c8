/**
 * libFuzzer target: no STL, OBJ or PLY file may crash the reader (Assimp within it), and what is
 * refused is refused with a message. What is accepted of the text formats has the facets that a
 * second reader finds (fuzz_oracle.h). The content tells the format: seeds begin as files do.
 */

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "clod/mesh.h"
#include "mesh/fuzz_oracle.h"
#include "mesh/touching.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/** What was read: places that are numbers, corners, neighbours and parts that there are. */
static void check_mesh(const clod_mesh *mesh)
{
    const clod_mesh_view *view = clod_mesh_look(mesh);
    for (size_t v = 0; v < view->vertex_count; v++) {
        if (!isfinite(view->vertices[v][0] + view->vertices[v][1] + view->vertices[v][2])) {
            abort();
        }
    }
    for (size_t f = 0; f < view->facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const uint32_t neighbour = view->neighbours[f][e];
            const bool open = view->edges[f][e] == CLOD_MESH_EDGE_OPEN;
            if (view->facets[f][e] >= view->vertex_count ||
                (neighbour != CLOD_MESH_NONE && neighbour >= view->facet_count) ||
                (open && neighbour != CLOD_MESH_NONE) ||
                (neighbour == CLOD_MESH_NONE && !open &&
                 view->edges[f][e] != CLOD_MESH_EDGE_T)) {
                abort();
            }
        }
        if (view->part[f] >= view->part_count || view->shell[f] >= view->shell_count) {
            abort();
        }
    }
}

static void report(const clod_mesh *mesh)
{
    static clod_status status;
    clod_mesh_report found;
    if (!clod_mesh_examine(mesh, 0.003, &found, &status)) {
        abort();
    }
    char *texts[] = {clod_mesh_text(mesh, &found), clod_mesh_json(mesh, &found)};
    for (int k = 0; k < 2; k++) {
        if (texts[k] == NULL) {
            abort();
        }
        clod_mesh_free(texts[k]);
    }
}

/** Facets stand where the oracle has them. */
static void compare(const clod_mesh *mesh, const char *extension, const uint8_t *data,
                    size_t size, double unit)
{
    static oracle second;
    static char text[ORACLE_MOST];
    static clod_status status;
    clod_mesh_report found;
    const size_t skip = size > 3 && memcmp(data, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    if (size >= sizeof text || memchr(data, '\0', size) != NULL) {
        return;
    }
    memcpy(text, data + skip, size - skip);
    text[size - skip] = '\0';
    if (!oracle_read(&second, extension, text) ||
        !clod_mesh_examine(mesh, 0.0, &found, &status)) {
        return;
    }
    const double tolerance = 2.0 * found.weld + 1e-30; // joined, and rounded to floats
    const clod_mesh_view *view = clod_mesh_look(mesh);
    if (found.read_facets != second.triangle_count) {
        abort();
    }
    for (size_t f = 0; f < view->facet_count; f++) {
        for (int c = 0; c < 3; c++) {
            if (!oracle_has(&second, view->number[f] - 1, view->vertices[view->facets[f][c]],
                            unit, tolerance)) {
                abort();
            }
        }
    }
}

#define NEAR_MOST 4096 ///< facets: more take the fuzzer too long

/** Grains on its first facets: contacts are facets that there are, each with its root. */
static void touch(const clod_mesh *mesh)
{
    static clod_status status;
    static touching found;
    clod_surface *surface = clod_surface_make(mesh, NULL, 0.35, &status);
    if (surface == NULL) {
        abort();
    }
    for (uint32_t f = 0; f < surface->facet_count && f < 16; f++) {
        const uint32_t *v = surface->facet[f];
        const double radius = 0.25 * surface->weld * 2097152.0; // of the size of the mesh
        const clod_vec3 at = clod_vec3_axpy(clod_vec3_of(surface->vertex[v[0]]), 0.9 * radius,
                                            surface->planes[surface->plane[f]].normal);
        touching_near(&found, surface, at, radius);
        if (found.count > NEAR_MOST) {
            continue;
        }
        touching_find(&found, at, radius); // which checks the roots
        for (int32_t k = 0; k < found.hits; k++) {
            if (!(found.hit[k].at.distance < radius) ||
                surface->patch[found.hit[k].facet] >= surface->patch_count) {
                abort();
            }
        }
    }
    clod_surface_release(surface);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static clod_status status;
    const clod_mesh_placing placing = {.unit = 1e-3, .scale = 1.0};
    const bool ply = size > 3 && memcmp(data, "ply", 3) == 0;
    const bool solid = size > 5 && memcmp(data, "solid", 5) == 0;
    const bool binary = size > 84 && data[83] == 0;
    const char *name = ply ? "fuzz.ply" : solid || binary ? "fuzz.stl" : "fuzz.obj";
    status.text[0] = '\0';
    clod_mesh *mesh = clod_mesh_parse(name, (const char *)data, size, &placing, &status);
    if (mesh != NULL) {
        check_mesh(mesh);
        if (!binary || ply) {
            compare(mesh, name + 5, data, size, placing.unit);
        }
        report(mesh);
        touch(mesh);
    } else if (status.text[0] == '\0') {
        abort();
    }
    clod_mesh_destroy(&mesh);
    return 0;
}
