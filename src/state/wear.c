#include "state/wear.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/surface_touch.h"

int32_t clod_wear_number(clod_wall *wall)
{
    int32_t places = 0, faces = 0, place = 0, face = 0;
    const clod_surface *surface = NULL;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        clod_shape *shape = &wall->shapes[s];
        if (shape->surface == NULL ||
            shape->surface != surface) { // the first of a mesh, or none
            surface = shape->surface;
            place = places;
            face = faces;
            places += surface != NULL ? (int32_t)surface->facet_count : 1;
            faces += surface != NULL ? (int32_t)surface->part_count : 1;
        }
        shape->place = place;
        shape->face = face;
    }
    return places;
}

int32_t clod_wear_faces(const clod_wall *wall)
{
    if (wall->shape_count == 0) {
        return 0;
    }
    const clod_shape *last = &wall->shapes[wall->shape_count - 1];
    return last->face + (last->surface != NULL ? (int32_t)last->surface->part_count : 1);
}

void clod_wear_visit(const clod_wall *wall, clod_wear_look look, void *context)
{
    for (int32_t s = 0; s < wall->shape_count; s++) {
        const clod_shape *shape = &wall->shapes[s];
        const clod_surface *surface = shape->surface;
        if (surface == NULL) {
            look(context, wall, (clod_wear_place){s, shape->place, shape->face});
        } else if (clod_shape_begins_mesh(shape)) { // the mesh's other shapes follow
            for (int32_t f = 0; f < (int32_t)surface->facet_count; f++) {
                look(context, wall,
                     (clod_wear_place){s + CLOD_SURFACE_SLOTS * (int32_t)surface->patch[f],
                                       shape->place + f,
                                       shape->face + (int32_t)surface->part[f]});
            }
        }
    }
}

void clod_wear_name(const clod_wall *wall, int32_t face, char *text, size_t size)
{
    for (int32_t s = wall->shape_count; s-- > 0;) {
        const clod_shape *shape = &wall->shapes[s];
        const clod_surface *surface = shape->surface;
        if (surface != NULL && shape->face <= face &&
            face < shape->face + (int32_t)surface->part_count &&
            surface->part_label[face - shape->face][0] != '\0') {
            snprintf(text, size, "%s.%s", wall->name, surface->part_label[face - shape->face]);
            return;
        }
    }
    if (clod_wear_faces(wall) > 1) {
        snprintf(text, size, "%s.%d", wall->name, (int)face + 1);
    } else {
        snprintf(text, size, "%s", wall->name);
    }
}

/** Rows that the impacts of a surface take. */
#define IMPACT_ROWS ((sizeof(clod_impacts) - 1) / sizeof(double[CLOD_WEAR_SUMS]) + 1)

int32_t clod_wear_rows(const clod_wall *wall, int32_t places)
{
    return places + (2 + (int32_t)IMPACT_ROWS) * clod_wear_faces(wall);
}

clod_impacts *clod_wear_impacts(const clod_wall *wall, int32_t face)
{
    const size_t first = (size_t)wall->wear_places + 2 * (size_t)clod_wear_faces(wall);
    return (clod_impacts *)wall->wear[first + IMPACT_ROWS * (size_t)face];
}

bool clod_wear_begin(clod_wall *wall)
{
    clod_memory_free(wall->wear);
    wall->wear_places = clod_wear_number(wall);
    wall->wear_rows = clod_wear_rows(wall, wall->wear_places);
    wall->wear = clod_memory_alloc((size_t)wall->wear_rows + 1, sizeof *wall->wear);
    return wall->wear != NULL;
}

void clod_wear_reset(clod_wall *wall, double time)
{
    if (wall->wear != NULL) {
        memset(wall->wear, 0, (size_t)wall->wear_rows * sizeof *wall->wear);
        wall->wear_since = wall->wear_row = time;
    }
}

static double facet_area(const clod_surface *surface, int32_t facet)
{
    const uint32_t *v = surface->facet[facet];
    const clod_vec3 a = clod_vec3_of(surface->vertex[v[0]]);
    const clod_vec3 b = clod_vec3_sub(clod_vec3_of(surface->vertex[v[1]]), a);
    const clod_vec3 c = clod_vec3_sub(clod_vec3_of(surface->vertex[v[2]]), a);
    return 0.5 * clod_vec3_length(clod_vec3_cross(b, c));
}

double clod_wear_area(const clod_wall *wall, int32_t shape, int32_t place)
{
    const clod_shape *self = &wall->shapes[shape];
    const clod_shape_kind_row *row = clod_shape_kinds_row(self->kind);
    if (row->faceted) {
        return facet_area(self->surface, place - self->place);
    }
    return row->area != NULL ? row->area(self) : 0.0;
}
