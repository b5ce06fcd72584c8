#include "mesh/mesh.h"

#include <math.h>
#include <string.h>

#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"
#include "mesh/mesh_edges.h"
#include "mesh/mesh_facets.h"
#include "mesh/mesh_import.h"
#include "mesh/mesh_overlaps.h"
#include "mesh/mesh_seams.h"
#include "mesh/mesh_shells.h"
#include "mesh/mesh_source.h"
#include "mesh/mesh_vertices.h"

void clod_mesh_note(clod_mesh *self, clod_mesh_kind kind, uint32_t facet, clod_vec3 point)
{
    clod_mesh_finding *finding = &self->findings[kind];
    if (finding->count < CLOD_MESH_PLACES) {
        finding->places[finding->count] = (clod_mesh_place){
            self->number[facet], self->part[facet], {point.x, point.y, point.z}, 0};
    }
    finding->count++;
    self->found[facet] = (uint16_t)(self->found[facet] | 1u << kind);
}

void clod_mesh_note_pair(clod_mesh *self, clod_mesh_kind kind, uint32_t facet, uint32_t other,
                         clod_vec3 point)
{
    clod_mesh_finding *finding = &self->findings[kind];
    clod_mesh_note(self, kind, facet, point);
    if (finding->count <= CLOD_MESH_PLACES) {
        finding->places[finding->count - 1].other = self->number[other];
    }
}

bool clod_mesh_lacks_memory(const clod_mesh *self, clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh of %zu facets",
                            self->path, self->read_facets);
}

clod_mesh_triangle clod_mesh_measure(const clod_mesh *self, uint32_t facet)
{
    const clod_vec3 a = clod_mesh_corner(self, facet, 0);
    const clod_vec3 b = clod_mesh_corner(self, facet, 1);
    const clod_vec3 c = clod_mesh_corner(self, facet, 2);
    const clod_vec3 cross = clod_vec3_cross(clod_vec3_sub(b, a), clod_vec3_sub(c, a));
    const double twice = clod_vec3_length(cross);
    const double sides[3] = {clod_vec3_length(clod_vec3_sub(b, a)),
                             clod_vec3_length(clod_vec3_sub(c, b)),
                             clod_vec3_length(clod_vec3_sub(a, c))};
    const double longest = fmax(sides[0], fmax(sides[1], sides[2]));
    return (clod_mesh_triangle){
        .normal =
            twice > 0.0 ? clod_vec3_scale(cross, 1.0 / twice) : (clod_vec3){0.0, 0.0, 0.0},
        .area = 0.5 * twice,
        .shortest = fmin(sides[0], fmin(sides[1], sides[2])),
        .longest = longest,
        .height = longest > 0.0 ? twice / longest : 0.0,
    };
}

static bool is_finite(const double at[3])
{
    return isfinite(at[0]) && isfinite(at[1]) && isfinite(at[2]);
}

static bool check_placing(const char *path, const clod_mesh_placing *placing,
                          clod_status *status)
{
    const clod_case_rotation *turn = &placing->rotate;
    const double length = sqrt(turn->axis[0] * turn->axis[0] + turn->axis[1] * turn->axis[1] +
                               turn->axis[2] * turn->axis[2]);
    if (!(placing->unit > 0.0 && placing->unit <= 1e6)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: a unit of %g m; it must be above 0 and at most 1e6 m",
                                path, placing->unit);
    }
    if (!(placing->scale > 0.0 && placing->scale <= 1e6)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: a scale of %g; it must be above 0 and at most 1e6", path,
                                placing->scale);
    }
    if (!is_finite(placing->move) || !is_finite(turn->axis) || !is_finite(turn->point) ||
        !isfinite(turn->angle)) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: rotate and move must be finite numbers", path);
    }
    if (turn->angle != 0.0 && !(length > 0.0 && isfinite(length))) {
        return clod_status_fail(status, CLOD_USAGE,
                                "%s: the axis of rotate is (%g, %g, %g); it must not be zero",
                                path, turn->axis[0], turn->axis[1], turn->axis[2]);
    }
    return true;
}

/** The mesh of a checked source: parts, and for each facet part and number. */
static clod_mesh *create(clod_mesh_source *source, clod_status *status)
{
    clod_mesh *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", source->path);
        return NULL;
    }
    self->read_facets = source->facets;
    self->path = clod_memory_text(source->path);
    self->part = clod_memory_alloc(source->facets, sizeof *self->part);
    self->number = clod_memory_alloc(source->facets, sizeof *self->number);
    self->found = clod_memory_alloc(source->facets, sizeof *self->found);
    if (self->path == NULL || self->part == NULL || self->number == NULL ||
        self->found == NULL) {
        clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", source->path);
        clod_mesh_destroy(&self);
        return NULL;
    }
    size_t facet = 0;
    for (size_t r = 0; r < source->run_count; r++) {
        for (size_t k = 0; k < source->runs[r].facets; k++, facet++) {
            self->part[facet] = source->runs[r].part;
            self->number[facet] = (uint32_t)facet + 1;
        }
    }
    self->parts = source->parts;
    self->view.part_count = source->part_count;
    source->parts = NULL;
    source->part_count = 0;
    return self;
}

/** Vertices, facets, edges of a mesh that has its parts. */
static bool build(clod_mesh *self, clod_mesh_source *source, const clod_mesh_placing *placing,
                  clod_status *status)
{
    float(*corners)[3][3] = NULL;
    if (!clod_mesh_import(source, &corners, status)) {
        return false;
    }
    clod_memory_free(source->bytes); // before the rest needs memory
    source->bytes = NULL;
    const bool joined =
        clod_mesh_vertices_join(self, (const float(*)[3][3])corners, self->read_facets, status);
    clod_memory_free(corners);
    return joined && clod_mesh_vertices_place(self, placing, status) &&
           clod_mesh_vertices_weld(self, status) && clod_mesh_facets_clean(self, status) &&
           clod_mesh_edges_pair(self, status) && clod_mesh_edges_turn(self, status) &&
           clod_mesh_seams_find(self, status) && clod_mesh_overlaps_find(self, status) &&
           clod_mesh_shells_number(self, status);
}

static void show(clod_mesh *self)
{
    clod_mesh_view *view = &self->view;
    view->vertices = (const double(*)[3])self->vertices;
    view->facets = (const uint32_t(*)[3])self->facets;
    view->part = self->part;
    view->number = self->number;
    view->neighbours = (const uint32_t(*)[3])self->neighbours;
    view->edges = (const uint8_t(*)[3])self->edges;
    view->shell = self->shell;
    view->found = self->found;
    view->parts = self->parts;
}

/** The mesh of a source with its content, which is freed. */
static clod_mesh *make(clod_mesh_source *source, const clod_mesh_placing *placing,
                       clod_status *status)
{
    clod_mesh *self = NULL;
    if (check_placing(source->path, placing, status) &&
        clod_mesh_source_check(source, status)) {
        self = create(source, status);
    }
    if (self != NULL && !build(self, source, placing, status)) {
        clod_mesh_destroy(&self);
    }
    if (self != NULL) {
        clod_mesh_edges_class(self);
        self->unit = placing->unit;
        show(self);
    }
    clod_mesh_source_fini(source);
    return self;
}

clod_mesh *clod_mesh_read(const char *path, const clod_mesh_placing *placing,
                          clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(placing, status)) {
        return NULL;
    }
    clod_mesh_source source;
    if (!clod_mesh_source_init(&source, path, status) ||
        !clod_input_read_regular(path, CLOD_MESH_BYTES_MOST, &source.bytes, &source.length,
                                 status)) {
        return NULL;
    }
    return make(&source, placing, status);
}

clod_mesh *clod_mesh_parse(const char *path, const char *bytes, size_t length,
                           const clod_mesh_placing *placing, clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(bytes, status) ||
        !CLOD_GIVEN(placing, status)) {
        return NULL;
    }
    clod_mesh_source source;
    if (!clod_mesh_source_init(&source, path, status)) {
        return NULL;
    }
    source.bytes = clod_memory_alloc(length + 1, 1);
    if (source.bytes == NULL) {
        clod_status_fail(status, CLOD_FAILED, "%s: no memory for the mesh", path);
        return NULL;
    }
    memcpy(source.bytes, bytes, length);
    source.length = length;
    return make(&source, placing, status);
}

void clod_mesh_destroy(clod_mesh **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    clod_mesh *mesh = *self;
    for (size_t p = 0; p < mesh->view.part_count; p++) {
        clod_memory_free(mesh->parts[p].name);
    }
    clod_memory_free(mesh->parts);
    clod_memory_free(mesh->path);
    clod_memory_free(mesh->vertices);
    clod_memory_free(mesh->facets);
    clod_memory_free(mesh->part);
    clod_memory_free(mesh->number);
    clod_memory_free(mesh->found);
    clod_memory_free(mesh->shell);
    clod_memory_free(mesh->neighbours);
    clod_memory_free(mesh->edges);
    clod_memory_free(mesh->ends);
    clod_memory_free(mesh->overlaps);
    clod_memory_free(mesh);
    *self = NULL;
}

const clod_mesh_view *clod_mesh_look(const clod_mesh *self)
{
    CLOD_NEED(self);
    return &self->view;
}
