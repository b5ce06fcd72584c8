#include "picture/stage.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

static const double STILL[3] = {0.84, 0.87, 0.91};  ///< steel
static const double MOVING[3] = {0.53, 0.53, 0.55}; ///< belts are black
static const double NONE[3] = {0.60, 0.60, 0.60};
static const double LINE[3] = {0.30, 0.34, 0.40};

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for a picture.");
}

static void set_colours(const clod_stage *self, clod_scene *scene)
{
    memcpy(scene->colour[CLOD_SCENE_GRAIN], self->grains->bar.map.colour,
           sizeof self->grains->bar.map.colour);
    memcpy(scene->colour[CLOD_SCENE_WALL], self->walls->bar.map.colour,
           sizeof self->walls->bar.map.colour);
    memcpy(scene->colour[CLOD_SCENE_NONE], NONE, sizeof NONE);
    memcpy(scene->colour[CLOD_SCENE_STILL], STILL, sizeof STILL);
    memcpy(scene->colour[CLOD_SCENE_MOVING], MOVING, sizeof MOVING);
    memcpy(scene->colour[CLOD_SCENE_LINE], LINE, sizeof LINE);
}

static bool load_grains(const clod_stage *self, const clod_vtkhdf *file, clod_scene *scene,
                        clod_status *status)
{
    clod_field radius = {0};
    clod_field colour = {0};
    const size_t n = file->rows[CLOD_VTKHDF_POINTS];
    bool good = clod_field_read(&radius, file, CLOD_VTKHDF_POINTS, "radius", status) &&
                clod_field_read(&colour, file, CLOD_VTKHDF_POINTS, self->grains->field, status);
    scene->center = good ? clod_vtkhdf_points(file, status) : NULL;
    good = scene->center != NULL;
    scene->shade = clod_memory_alloc(n + 1, sizeof *scene->shade);
    if (good && scene->shade == NULL) {
        good = fail_memory(status);
    }
    for (size_t k = 0; good && k < n; k++) {
        scene->shade[k] = (uint16_t)clod_channel_colour(self->grains, colour.value[k]);
    }
    scene->spheres = good ? n : 0;
    scene->radius = radius.value;
    radius.value = NULL;
    clod_field_fini(&colour);
    return good;
}

double (*clod_stage_read_walls(const clod_vtkhdf *file, int32_t **wall,
                               clod_status *status))[3][3]
{
    const size_t n = file->rows[CLOD_VTKHDF_CELLS];
    clod_field number = {0};
    double(*corner)[3][3] = clod_memory_alloc(n + 1, sizeof *corner);
    *wall = clod_memory_alloc(n + 1, sizeof **wall);
    double(*point)[3] = clod_vtkhdf_points(file, status);
    size_t(*triangle)[3] = point != NULL ? clod_vtkhdf_triangles(file, status) : NULL;
    bool good =
        triangle != NULL && clod_field_read(&number, file, CLOD_VTKHDF_CELLS, "wall", status);
    if (good && (corner == NULL || *wall == NULL)) {
        good = fail_memory(status);
    }
    for (size_t k = 0; good && k < 3 * n; k++) {
        memcpy(corner[k / 3][k % 3], point[triangle[k / 3][k % 3]], sizeof corner[0][0]);
    }
    for (size_t t = 0; good && t < n; t++) {
        (*wall)[t] = (int32_t)number.value[t];
    }
    clod_memory_free(point);
    clod_memory_free(triangle);
    clod_field_fini(&number);
    if (!good) {
        clod_memory_free(corner);
        clod_memory_free(*wall);
        corner = NULL;
        *wall = NULL;
    }
    return corner;
}

/** Walls as they are in a file. */
typedef struct given {
    size_t count;
    double (*corner)[3][3]; ///< owned
    int32_t *wall;          ///< owned
    uint16_t *paint;        ///< owned
    clod_field speed, colour;
} given;

static void free_given(given *self)
{
    clod_memory_free(self->corner);
    clod_memory_free(self->wall);
    clod_memory_free(self->paint);
    clod_field_fini(&self->speed);
    clod_field_fini(&self->colour);
}

static bool read_given(const clod_stage *self, const clod_vtkhdf *file, given *walls,
                       clod_status *status)
{
    walls->count = file->rows[CLOD_VTKHDF_CELLS];
    walls->corner = clod_stage_read_walls(file, &walls->wall, status);
    if (walls->corner == NULL ||
        !clod_field_read(&walls->speed, file, CLOD_VTKHDF_CELLS, "velocity", status) ||
        (self->walls->field != NULL && !clod_field_read(&walls->colour, file, CLOD_VTKHDF_CELLS,
                                                        self->walls->field, status))) {
        return false;
    }
    walls->paint = clod_memory_alloc(walls->count + 1, sizeof *walls->paint);
    for (size_t t = 0; walls->paint != NULL && t < walls->count; t++) {
        const bool moves = walls->speed.value[t] > 0.0;
        walls->paint[t] =
            (uint16_t)(self->walls->field != NULL
                           ? clod_channel_colour(self->walls, walls->colour.value[t])
                       : moves ? CLOD_SCENE_MOVING
                               : CLOD_SCENE_STILL);
    }
    return walls->paint != NULL || fail_memory(status);
}

/** Put a triangle into the scene, which has room for it. */
static void put_triangle(clod_scene *scene, double (*const corner)[3], const given *walls,
                         size_t t)
{
    memcpy(scene->corner[scene->triangles], corner, sizeof scene->corner[0]);
    scene->wall[scene->triangles] = walls->wall[t];
    scene->paint[scene->triangles++] = walls->paint[t];
}

/** Whether triangles t and t + 1 are a square, which may be a plane without an end. */
static bool is_endless(const clod_stage *self, const given *walls, size_t t)
{
    double side;
    return clod_cutaway_is_square(walls->corner, walls->wall, t, walls->count, &side) &&
           self->clip.max[0] >= self->clip.min[0];
}

static bool put_walls(const clod_stage *self, const given *walls, clod_scene *scene,
                      clod_status *status)
{
    size_t room = walls->count + 1;
    for (size_t t = 0; t < walls->count; t++) {
        room += is_endless(self, walls, t) ? CLOD_CUTAWAY_PIECES : 0;
    }
    scene->corner = clod_memory_alloc(room, sizeof *scene->corner);
    scene->paint = clod_memory_alloc(room, sizeof *scene->paint);
    scene->wall = clod_memory_alloc(room, sizeof *scene->wall);
    scene->veiled = clod_memory_alloc(room, sizeof *scene->veiled);
    if (scene->corner == NULL || scene->paint == NULL || scene->wall == NULL ||
        scene->veiled == NULL) {
        return fail_memory(status);
    }
    for (size_t t = 0; t < walls->count; t++) {
        const int32_t wall = walls->wall[t];
        const bool hidden =
            wall >= 0 && (size_t)wall < self->hidden_count && self->hidden[wall];
        double piece[CLOD_CUTAWAY_PIECES][3][3];
        if (is_endless(self, walls, t)) {
            const size_t pieces = clod_cutaway_clip(&self->clip, walls->corner + t, piece);
            for (size_t k = 0; k < pieces && !hidden; k++) {
                put_triangle(scene, piece[k], walls, t);
            }
            t++; // its other half
        } else if (!hidden) {
            put_triangle(scene, walls->corner[t], walls, t);
        }
    }
    return true;
}

static bool load_walls(const clod_stage *self, const clod_vtkhdf *file, clod_scene *scene,
                       clod_status *status)
{
    given walls = {0};
    const bool good =
        read_given(self, file, &walls, status) && put_walls(self, &walls, scene, status);
    free_given(&walls);
    return good;
}

bool clod_stage_load(const clod_stage *self, const clod_film_frame *frame, clod_scene *scene,
                     clod_status *status)
{
    *scene = (clod_scene){0};
    set_colours(self, scene);
    clod_vtkhdf *file = clod_vtkhdf_open(frame->grains, status);
    bool good = file != NULL && load_grains(self, file, scene, status);
    clod_vtkhdf_close(&file);
    if (good && frame->walls != NULL) {
        file = clod_vtkhdf_open(frame->walls, status);
        good = file != NULL && load_walls(self, file, scene, status);
        clod_vtkhdf_close(&file);
    }
    return good;
}
