#include "step/outlet_shapes.h"

#include <math.h>

#include "base/memory.h"

/** A contact of a mesh beyond the first one of its patch is no surface of its own. */
static bool is_one(const clod_shape *shape)
{
    return shape->outlet > 0 && shape->slot == 0;
}

bool clod_outlet_shapes_list(clod_outlet_shapes *self, const clod_walls *walls)
{
    int32_t count = 0;
    clod_outlet_shapes_fini(self);
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            count += is_one(&walls->wall[w].shapes[s]);
        }
    }
    self->of = clod_memory_alloc((size_t)count + 1, sizeof *self->of);
    for (int32_t w = 0; self->of != NULL && w < walls->count; w++) {
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            const clod_shape *shape = &walls->wall[w].shapes[s];
            if (is_one(shape)) {
                self->of[self->count++] =
                    (clod_outlet_shape){.wall = w, .shape = s, .outlet = shape->outlet - 1};
            }
        }
    }
    return self->of != NULL;
}

void clod_outlet_shapes_place(clod_outlet_shapes *self, clod_wall_rows *rows,
                              const clod_walls *walls)
{
    for (int a = 0; a < 3; a++) {
        self->low[a] = HUGE_VAL;
        self->high[a] = -HUGE_VAL;
    }
    for (int32_t k = 0; k < self->count; k++) {
        clod_outlet_shape *one = &self->of[k];
        const clod_wall_placement placement = clod_wall_placement_of(&walls->wall[one->wall]);
        clod_wall_rows_place_shape(rows, one->wall, &placement, one->shape);
        clod_wall_rows_box(rows, one->wall, one->shape, one->low, one->high);
        for (int a = 0; a < 3; a++) {
            self->low[a] = fmin(self->low[a], one->low[a]);
            self->high[a] = fmax(self->high[a], one->high[a]);
        }
    }
}

/** Whether a sphere reaches into a box. */
static bool reaches(const double *position, const double low[3], const double high[3])
{
    bool in = true;
    for (int a = 0; a < 3; a++) {
        in = in && position[a] + position[3] >= low[a] && position[a] - position[3] <= high[a];
    }
    return in;
}

int32_t clod_outlet_shapes_touched(const clod_outlet_shapes *self, const clod_wall_rows *rows,
                                   const double *position)
{
    int32_t found = -1;
    if (!reaches(position, self->low, self->high)) {
        return found;
    }
    for (int32_t k = 0; k < self->count; k++) {
        const clod_outlet_shape *one = &self->of[k];
        if ((found < 0 || one->outlet < found) && reaches(position, one->low, one->high) &&
            clod_wall_rows_is_near(rows, one->wall, one->shape, position, position[3])) {
            found = one->outlet;
        }
    }
    return found;
}

void clod_outlet_shapes_fini(clod_outlet_shapes *self)
{
    clod_memory_free(self->of);
    *self = (clod_outlet_shapes){0};
}
