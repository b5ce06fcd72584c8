#include "state/wear.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

const clod_wear_column CLOD_WEAR_COLUMN[CLOD_WEAR_COLUMNS] = {
    {"impulse_x", "N s"}, {"impulse_y", "N s"}, {"impulse_z", "N s"}, {"press", "N s"},
    {"shear", "J"},       {"squeeze", "J"},     {"impacts", "1"},     {"energy", "J"},
    {"angle", "J rad"},   {"sliding", "J"},     {"cutting", "J"}};

int32_t clod_wear_number_places(clod_wall *wall)
{
    int32_t places = 0, first = 0;
    const clod_surface *surface = NULL;
    for (int32_t s = 0; s < wall->shape_count; s++) {
        clod_shape *shape = &wall->shapes[s];
        const bool next = shape->surface == NULL || shape->surface != surface;
        if (next) {
            first = places;
            surface = shape->surface;
            places += surface != NULL ? (int32_t)surface->facet_count : 1;
        }
        shape->place = first;
    }
    return places;
}

bool clod_wear_begin(clod_wall *wall)
{
    clod_memory_free(wall->wear);
    wall->wear_places = clod_wear_number_places(wall);
    wall->wear = clod_memory_alloc((size_t)wall->wear_places + 1, sizeof *wall->wear);
    return wall->wear != NULL;
}

void clod_wear_reset(clod_wall *wall)
{
    if (wall->wear != NULL) {
        memset(wall->wear, 0, (size_t)wall->wear_places * sizeof *wall->wear);
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
    const double slant = hypot(2.0 * self->half[2], self->outer - clod_shape_end_radius(self));
    switch (self->kind) {
    case CLOD_SHAPE_MESH:
        return facet_area(self->surface, place - self->place);
    case CLOD_SHAPE_DISC:
    case CLOD_SHAPE_ANNULUS:
        return M_PI * (self->outer * self->outer - self->inner * self->inner);
    case CLOD_SHAPE_CYLINDER:
    case CLOD_SHAPE_CONE:
        return M_PI * (self->outer + clod_shape_end_radius(self)) * slant;
    case CLOD_SHAPE_BOX:
    case CLOD_SHAPE_BAR:
        return 8.0 * (self->half[0] * self->half[1] + self->half[1] * self->half[2] +
                      self->half[2] * self->half[0]);
    default:
        return 0.0;
    }
}

double clod_wear_finnie(double normal, double along)
{
    const double square = normal * normal + along * along;
    if (3.0 * normal < along) {
        return (2.0 * normal * along - 3.0 * normal * normal) / square;
    }
    return along * along / (3.0 * square);
}
