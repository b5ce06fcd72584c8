#include "picture/stage.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "clod/case_walls.h"
#include "state/part_labels.h"
#include "state/shape_kinds.h"

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

/** Whether a number in the file says an endless shape. */
static bool is_plane(double kind)
{
    return kind >= 0.0 && kind < CLOD_SHAPE_KINDS &&
           clod_shape_kinds_row((clod_shape_kind)kind)->endless;
}

/** Note which triangles show planes: two each. */
static bool find_planes(clod_stage_walls *self, const clod_vtkhdf *file, clod_status *status)
{
    clod_field shape = {0};
    if (clod_vtkhdf_find(file, CLOD_VTKHDF_CELLS, "shape") == NULL) {
        return true;
    }
    const bool good = clod_field_read(&shape, file, CLOD_VTKHDF_CELLS, "shape", status);
    for (size_t t = 0; good && t + 1 < self->count; t++) {
        if (is_plane(shape.value[t]) && is_plane(shape.value[t + 1])) {
            self->plane[t++] = true;
        }
    }
    clod_field_fini(&shape);
    return good;
}

/** Whether `length` characters of a name are those of a text, as they stand in names. */
static bool is_same(const char *name, const char *text, size_t length)
{
    for (size_t k = 0; k < length; k++) {
        if (clod_part_labels_clean(name[k]) != clod_part_labels_clean(text[k])) {
            return false;
        }
    }
    return true;
}

bool clod_stage_is_part(const clod_stage_part *asked, const char *name, size_t length)
{
    const size_t most = strlen(asked->name);
    if (!asked->any_shape) {
        return most == length && is_same(name, asked->name, length);
    }
    const char *point = memchr(name, '.', length);
    const size_t head = point != NULL ? (size_t)(point - name) + 1 : length;
    const size_t digits = strspn(name + head, "0123456789");
    const size_t tail = head + digits + 1; // behind the number of the shape
    return digits > 0 && tail < length && name[tail - 1] == '.' &&
           most == head + length - tail && is_same(name, asked->name, head) &&
           is_same(name + tail, asked->name + head, length - tail);
}

static bool is_hidden_part(const clod_stage_hidden *hidden, const char *name, size_t length)
{
    bool found = false;
    for (size_t p = 0; p < hidden->part_count && !found; p++) {
        found = clod_stage_is_part(&hidden->part[p], name, length);
    }
    return found;
}

/** Read which part a triangle is in; in a file from before there were parts none are. */
static bool find_parts(clod_stage_walls *self, const clod_vtkhdf *file, clod_status *status)
{
    clod_field part = {0};
    const bool told = clod_vtkhdf_find(file, CLOD_VTKHDF_CELLS, "part") != NULL;
    const bool good = !told || clod_field_read(&part, file, CLOD_VTKHDF_CELLS, "part", status);
    for (size_t t = 0; good && t < self->count; t++) {
        self->part[t] = told && part.value[t] >= 0.0 && part.value[t] < INT32_MAX
                            ? (int32_t)part.value[t]
                            : -1;
    }
    clod_field_fini(&part);
    return good;
}

/** Hide the triangles of some parts. */
static bool hide_parts(clod_stage_walls *self, const clod_vtkhdf *file,
                       const clod_stage_hidden *hidden, clod_status *status)
{
    char *names = clod_memory_alloc(CLOD_VTKHDF_PARTS, 1);
    if (names == NULL) {
        return fail_memory(status);
    }
    const bool named = hidden->part_count > 0 && clod_vtkhdf_parts(file, names);
    int32_t number = 0;
    for (const char *line = names; named && line[0] != '\0'; number++) {
        const size_t length = strcspn(line, "\n");
        const bool hides = is_hidden_part(hidden, line, length);
        for (size_t t = 0; hides && t < self->count; t++) {
            self->hidden[t] = self->hidden[t] || self->part[t] == number;
        }
        line += length + (line[length] == '\n');
    }
    clod_memory_free(names);
    return true;
}

bool clod_stage_walls_read(clod_stage_walls *self, const clod_vtkhdf *file,
                           const clod_stage_hidden *hidden, clod_status *status)
{
    const size_t n = file->rows[CLOD_VTKHDF_CELLS];
    clod_field number = {0};
    *self = (clod_stage_walls){n,
                               clod_memory_alloc(n + 1, sizeof *self->corner),
                               clod_memory_alloc(n + 1, sizeof *self->wall),
                               clod_memory_alloc(n + 1, sizeof *self->part),
                               clod_memory_alloc(n + 1, sizeof *self->plane),
                               clod_memory_alloc(n + 1, sizeof *self->hidden)};
    double(*point)[3] = clod_vtkhdf_points(file, status);
    size_t(*triangle)[3] = point != NULL ? clod_vtkhdf_triangles(file, status) : NULL;
    bool good =
        triangle != NULL && clod_field_read(&number, file, CLOD_VTKHDF_CELLS, "wall", status);
    if (good && (self->corner == NULL || self->wall == NULL || self->part == NULL ||
                 self->plane == NULL || self->hidden == NULL)) {
        good = fail_memory(status);
    }
    for (size_t k = 0; good && k < 3 * n; k++) {
        memcpy(self->corner[k / 3][k % 3], point[triangle[k / 3][k % 3]],
               sizeof self->corner[0][0]);
    }
    for (size_t t = 0; good && t < n; t++) {
        const int32_t wall = (int32_t)number.value[t];
        self->wall[t] = wall;
        self->hidden[t] = wall >= 0 && (size_t)wall < hidden->wall_count && hidden->wall[wall];
    }
    clod_memory_free(point);
    clod_memory_free(triangle);
    clod_field_fini(&number);
    return good && find_planes(self, file, status) && find_parts(self, file, status) &&
           hide_parts(self, file, hidden, status);
}

void clod_stage_walls_fini(clod_stage_walls *self)
{
    clod_memory_free(self->corner);
    clod_memory_free(self->wall);
    clod_memory_free(self->part);
    clod_memory_free(self->plane);
    clod_memory_free(self->hidden);
    *self = (clod_stage_walls){0};
}

/** Walls as they are in a file, and their colours. */
typedef struct given {
    clod_stage_walls of;
    uint16_t *paint; ///< owned
    clod_field speed, colour;
} given;

static void free_given(given *self)
{
    clod_stage_walls_fini(&self->of);
    clod_memory_free(self->paint);
    clod_field_fini(&self->speed);
    clod_field_fini(&self->colour);
}

static bool read_given(const clod_stage *self, const clod_vtkhdf *file, given *walls,
                       clod_status *status)
{
    if (!clod_stage_walls_read(&walls->of, file, self->hidden, status) ||
        !clod_field_read(&walls->speed, file, CLOD_VTKHDF_CELLS, "velocity", status) ||
        (self->walls->field != NULL && !clod_field_read(&walls->colour, file, CLOD_VTKHDF_CELLS,
                                                        self->walls->field, status))) {
        return false;
    }
    walls->paint = clod_memory_alloc(walls->of.count + 1, sizeof *walls->paint);
    for (size_t t = 0; walls->paint != NULL && t < walls->of.count; t++) {
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
    scene->wall[scene->triangles] = walls->of.wall[t];
    scene->part[scene->triangles] = walls->of.part[t];
    scene->paint[scene->triangles++] = walls->paint[t];
}

static bool put_walls(const clod_stage *self, const given *walls, clod_scene *scene,
                      clod_status *status)
{
    const bool clips = self->clip.max[0] >= self->clip.min[0];
    size_t room = walls->of.count + 1;
    for (size_t t = 0; t < walls->of.count; t++) {
        room += walls->of.plane[t] ? CLOD_CUTAWAY_PIECES : 0;
    }
    scene->corner = clod_memory_alloc(room, sizeof *scene->corner);
    scene->paint = clod_memory_alloc(room, sizeof *scene->paint);
    scene->wall = clod_memory_alloc(room, sizeof *scene->wall);
    scene->part = clod_memory_alloc(room, sizeof *scene->part);
    scene->veiled = clod_memory_alloc(room, sizeof *scene->veiled);
    if (scene->corner == NULL || scene->paint == NULL || scene->wall == NULL ||
        scene->part == NULL || scene->veiled == NULL) {
        return fail_memory(status);
    }
    for (size_t t = 0; t < walls->of.count; t++) {
        const bool hidden = walls->of.hidden[t];
        double piece[CLOD_CUTAWAY_PIECES][3][3];
        if (clips && walls->of.plane[t]) {
            const size_t pieces = clod_cutaway_clip(&self->clip, walls->of.corner + t, piece);
            for (size_t k = 0; k < pieces && !hidden; k++) {
                put_triangle(scene, piece[k], walls, t);
            }
            t++; // its other half
        } else if (!hidden) {
            put_triangle(scene, walls->of.corner[t], walls, t);
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
