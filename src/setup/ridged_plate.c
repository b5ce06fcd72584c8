#include "setup/ridged_plate.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/memory.h"
#include "config/wall_cells.h"
#include "config/wall_ridges.h"
#include "mesh/surface_touch.h"
#include "setup/surface.h"

/** Bends below it are smooth, at most: as of meshes [rad]. */
#define SMOOTH (M_PI / 9.0)
#define LINES 5 ///< of a ridge and the floor behind it: foot, crest, crest, foot, next foot

/** What writes the plate as the text of an OBJ file. */
typedef struct writer {
    FILE *out;
    const clod_case_wall_friction *cell;
    clod_wall_ridges ridges;
    size_t vertices;
} writer;

/** A line of the sheet, straight across the way of the plate. */
typedef struct line {
    clod_vec3 start, end;
} line;

/** The line `across` the middle of a ridge [m], at a height. */
static line line_at(const writer *self, int64_t ridge, double across, double height)
{
    const clod_wall_ridges *r = &self->ridges;
    if (clod_wall_cell_of(self->cell)->turns) {
        const double angle = 2.0 * M_PI * (double)(ridge % r->count) / (double)r->count;
        const double c = cos(angle), s = sin(angle);
        return (line){{c * r->from - s * across, s * r->from + c * across, height},
                      {c * r->to - s * across, s * r->to + c * across, height}};
    }
    // from the front to the back, so that a longer plate begins with the same ridges
    const double x = r->to - ((double)ridge + 0.5) * r->spacing - across;
    const double wide = self->cell->outer_radius;
    return (line){{x, -wide, height}, {x, wide, height}};
}

static void write_vertex(writer *self, clod_vec3 at)
{
    fprintf(self->out, "v %.9g %.9g %.9g\n", at.x, at.y, at.z);
    self->vertices++;
}

/** The piece of the sheet between two lines. */
static void write_piece(writer *self, const line *a, const line *b)
{
    const size_t v = self->vertices;
    write_vertex(self, a->start);
    write_vertex(self, a->end);
    write_vertex(self, b->end);
    write_vertex(self, b->start);
    fprintf(self->out, "f %zu %zu %zu\nf %zu %zu %zu\n", v + 1, v + 2, v + 3, v + 1, v + 3,
            v + 4);
}

/** A ridge, and the floor up to the next one. */
static void write_ridge(writer *self, int64_t ridge)
{
    const clod_wall_ridges *r = &self->ridges;
    const double foot = 0.5 * r->width, top = 0.5 * r->crest;
    const bool ring = clod_wall_cell_of(self->cell)->turns;
    const line at[LINES] = {
        line_at(self, ridge, -foot, 0.0), line_at(self, ridge, -top, r->height),
        line_at(self, ridge, top, r->height), line_at(self, ridge, foot, 0.0),
        line_at(self, ridge + 1, -foot, 0.0)};
    write_piece(self, &at[0], &at[1]);
    if (r->crest > 0.0) {
        write_piece(self, &at[1], &at[2]);
    }
    write_piece(self, &at[2], &at[3]);
    if (ring || r->width < r->room * (1.0 - 1e-9)) { // a ring has wedges of floor in any case
        write_piece(self, &at[3], &at[4]);
    }
}

static clod_mesh *make_mesh(writer *self, clod_status *status)
{
    char *text = NULL;
    size_t length = 0;
    self->out = open_memstream(&text, &length);
    bool good = self->out != NULL;
    for (int64_t k = 0; good && k < self->ridges.count; k++) {
        write_ridge(self, k);
    }
    good = self->out != NULL && fclose(self->out) == 0 && good;
    const clod_mesh_placing placing = {
        .unit = 1.0, .scale = 1.0, .rotate = {.axis = {0.0, 0.0, 1.0}}};
    clod_mesh *mesh =
        good ? clod_mesh_parse("plate.obj", text, length, &placing, status) : NULL;
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for the ridges of the plate");
    }
    free(text);
    return mesh;
}

bool clod_setup_ridged_plate(const clod_case_wall_friction *cell, clod_wall *plate,
                             clod_status *status)
{
    writer self = {.cell = cell, .ridges = clod_wall_ridges_of(cell)};
    clod_mesh *mesh = make_mesh(&self, status);
    // every side of a ridge is a surface of its own, however flat
    clod_surface *surface =
        mesh != NULL
            ? clod_surface_make(mesh, NULL, fmin(SMOOTH, 0.5 * self.ridges.flank), status)
            : NULL;
    clod_mesh_destroy(&mesh);
    if (surface == NULL) {
        return false;
    }
    const size_t count = CLOD_SURFACE_SLOTS * surface->patch_count;
    clod_shape *shapes = clod_memory_alloc(count, sizeof *shapes);
    for (size_t s = 0; shapes != NULL && s < count; s++) {
        clod_setup_surface_shape(surface, (int32_t)(s / CLOD_SURFACE_SLOTS),
                                 (int32_t)(s % CLOD_SURFACE_SLOTS), &shapes[s]);
    }
    clod_surface_release(surface); // the shapes are its users
    if (shapes == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the ridges of the plate");
    }
    clod_shapes_free(&plate->shapes, plate->shape_count);
    plate->shapes = shapes;
    plate->shape_count = (int32_t)count;
    clod_wall_find_symmetry(plate);
    return true;
}
