#include "geometry/wall_rows.h"

#include <math.h>
#include <stddef.h>

#include "base/memory.h"
#include "geometry/wall_pose.h"

bool clod_wall_rows_init(clod_wall_rows *self, const clod_walls *walls)
{
    *self = (clod_wall_rows){0};
    const size_t count = (size_t)walls->count;
    size_t shapes = 0;
    for (size_t w = 0; w < count; w++) {
        shapes += (size_t)walls->wall[w].shape_count;
    }
    self->shape = clod_memory_alloc(CLOD_SHAPE_ROWS * (shapes + 1), sizeof *self->shape);
    self->wall = clod_memory_alloc(CLOD_WALL_ROWS * count + 1, sizeof *self->wall);
    self->first_shape = clod_memory_alloc(count + 1, sizeof *self->first_shape);
    self->at = clod_memory_alloc(count + 1, sizeof *self->at);
    self->reach = clod_memory_alloc(count + 1, sizeof *self->reach);
    if (self->shape == NULL || self->wall == NULL || self->first_shape == NULL ||
        self->at == NULL || self->reach == NULL) {
        clod_wall_rows_fini(self);
        return false;
    }
    self->shape[CLOD_SHAPE_ROWS * shapes][3] = CLOD_WALL_PLANE; // all zero else: nowhere
    for (int32_t w = 0; w < walls->count; w++) {
        self->first_shape[w + 1] = self->first_shape[w] + walls->wall[w].shape_count;
        self->at[w][0] = NAN; // nowhere yet
        self->reach[w] = clod_wall_reach(&walls->wall[w]);
        clod_wall_rows_place(self, w, &walls->wall[w]);
    }
    return true;
}

void clod_wall_rows_update(clod_wall_rows *self, const clod_walls *walls)
{
    for (int32_t w = 0; w < walls->count; w++) {
        clod_wall_rows_place(self, w, &walls->wall[w]);
    }
}

static void put(double row[4], clod_vec3 v)
{
    row[0] = v.x;
    row[1] = v.y;
    row[2] = v.z;
}

/** The shapes of a wall, shifted, and turned if there is an angle. */
static void place_shapes(clod_wall_rows *self, int32_t w, const clod_wall *wall)
{
    const clod_wall_pose pose = clod_wall_pose_now(wall);
    for (int32_t s = 0; s < wall->shape_count; s++) {
        clod_shape now = wall->shapes[s];
        if (now.symmetric || wall->angle == 0.0) {
            now.center = clod_vec3_add(now.center, wall->shift);
        } else {
            now.center = clod_wall_point_to_space(&pose, now.center);
            for (int a = 0; a < 3; a++) {
                now.axis[a] = clod_wall_to_space(&pose, now.axis[a]);
            }
        }
        clod_wall_shape_rows(&now, self->shape + clod_wall_rows_shape(self, w, s));
    }
}

void clod_wall_rows_place(clod_wall_rows *self, int32_t w, const clod_wall *wall)
{
    double(*row)[4] = self->wall + (ptrdiff_t)CLOD_WALL_ROWS * w;
    put(row[0], clod_wall_velocity(wall));
    put(row[1], clod_vec3_scale(wall->spin_axis, clod_wall_spin(wall)));
    put(row[2], clod_vec3_add(wall->spin_point, wall->shift));
    const double at[4] = {wall->shift.x, wall->shift.y, wall->shift.z, wall->angle};
    bool moved = false;
    for (int c = 0; c < 4; c++) {
        moved |= at[c] != self->at[w][c];
        self->at[w][c] = at[c];
    }
    if (moved) {
        place_shapes(self, w, wall);
    }
}

void clod_wall_rows_box(const clod_wall_rows *self, int32_t w, int32_t shape, double low[3],
                        double high[3])
{
    const double(*row)[4] =
        (const double(*)[4])self->shape + clod_wall_rows_shape(self, w, shape);
    for (int a = 0; a < 3; a++) {
        const double at = row[0][a];
        double below = INFINITY, above = INFINITY; // of a plane
        if (row[0][3] == CLOD_WALL_BOX) {
            below = above = fabs(row[1][a]) * row[1][3] + fabs(row[2][a]) * row[2][3] +
                            fabs(row[3][a]) * row[3][3];
        } else if (row[0][3] != CLOD_WALL_PLANE) { // between the circles at both ends
            const double across = sqrt(fmax(1.0 - row[2][a] * row[2][a], 0.0));
            const double rise = row[2][a] * row[3][2] * row[3][3];
            const double foot = across * row[3][0];
            const double top = across * fabs(row[3][0] + row[3][1] * row[3][3]);
            below = fmax(foot, top - rise);
            above = fmax(foot, top + rise);
        }
        low[a] = at - below;
        high[a] = at + above;
    }
}

void clod_wall_rows_fini(clod_wall_rows *self)
{
    clod_memory_free(self->shape);
    clod_memory_free(self->wall);
    clod_memory_free(self->first_shape);
    clod_memory_free(self->at);
    clod_memory_free(self->reach);
    *self = (clod_wall_rows){0};
}
