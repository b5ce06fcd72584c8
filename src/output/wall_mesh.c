#include "output/wall_mesh.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/surface_touch.h"
#include "state/wear.h"

#define SEGMENTS CLOD_WALL_MESH_SEGMENTS

/** Where new triangles go, and what they belong to. */
typedef struct clod_mesh_pen {
    clod_wall_mesh *mesh;
    const clod_wall *wall;
    const clod_shape *shape;
    int32_t number; ///< of the wall
    const clod_domain *domain;
    const clod_state *state;
    int32_t place; ///< of the wall (state/wear.h)
    int32_t part;  ///< of the mesh's parts
} clod_mesh_pen;

/** A point of the wall's frame, in space. */
static clod_vec3 to_space(const clod_wall *wall, clod_vec3 point)
{
    const clod_vec3 arm =
        clod_quat_rotate(clod_wall_orientation(wall), clod_vec3_sub(point, wall->spin_point));
    const clod_vec3 turned = clod_vec3_rotate(arm, wall->spin_axis, wall->angle);
    return clod_vec3_add(turned, clod_vec3_add(wall->spin_point, wall->shift));
}

/** A point of the shape: its centre plus a, b, c times its axes; in the wall's frame. */
static clod_vec3 shape_point(const clod_shape *shape, double a, double b, double c)
{
    clod_vec3 point = clod_vec3_axpy(shape->center, a, shape->axis[0]);
    point = clod_vec3_axpy(point, b, shape->axis[1]);
    return clod_vec3_axpy(point, c, shape->axis[2]);
}

/** What wear tells of a place, by area; zero where it has no bound. */
static void wear_of(const clod_state *state, const clod_wall *wall, int32_t s, int32_t place,
                    double to[CLOD_WALL_MESH_WEAR])
{
    memset(to, 0, CLOD_WALL_MESH_WEAR * sizeof *to);
    const double area = clod_wear_area(wall, s, place);
    const double time = state->time - wall->wear_since;
    if (wall->wear == NULL || !(area > 0.0) || !(time > 0.0)) {
        return;
    }
    const double *sum = wall->wear[place];
    to[CLOD_WALL_MESH_PRESSURE] = sum[CLOD_WEAR_PRESS] / (area * time);
    to[CLOD_WALL_MESH_SHEAR_WORK] = sum[CLOD_WEAR_SHEAR] / area;
    to[CLOD_WALL_MESH_IMPACT_ENERGY] = sum[CLOD_WEAR_ENERGY] / area;
    to[CLOD_WALL_MESH_IMPACTS] = sum[CLOD_WEAR_IMPACTS] / area;
    to[CLOD_WALL_MESH_ARCHARD_DEPTH] = wall->shapes[s].archard * sum[CLOD_WEAR_SLIDING] / area;
    to[CLOD_WALL_MESH_FINNIE_DEPTH] = wall->shapes[s].finnie * sum[CLOD_WEAR_CUTTING] / area;
}

/** Add a triangle given in the wall's frame. */
static void draw(clod_mesh_pen *pen, clod_vec3 a, clod_vec3 b, clod_vec3 c)
{
    const int32_t shape = (int32_t)(pen->shape - pen->wall->shapes);
    const clod_vec3 corners[3] = {to_space(pen->wall, a), to_space(pen->wall, b),
                                  to_space(pen->wall, c)};
    clod_wall_mesh *mesh = pen->mesh;
    const size_t t = mesh->count++;
    clod_vec3 sum = {0.0, 0.0, 0.0};
    for (int v = 0; v < 3; v++) {
        memcpy(mesh->corner[t][v], &corners[v], sizeof mesh->corner[t][v]);
        sum = clod_vec3_add(sum, corners[v]);
    }
    const clod_vec3 middle = clod_vec3_scale(sum, 1.0 / 3.0);
    const clod_vec3 normal = clod_vec3_unit(clod_vec3_cross(
        clod_vec3_sub(corners[1], corners[0]), clod_vec3_sub(corners[2], corners[0])));
    const clod_vec3 velocity = clod_wall_material_velocity(pen->wall, shape, middle, normal);
    memcpy(mesh->velocity[t], &velocity, sizeof mesh->velocity[t]);
    mesh->wall[t] = pen->number;
    mesh->material[t] = clod_wall_material(pen->wall, shape);
    mesh->shape[t] = (int32_t)pen->shape->kind;
    mesh->part[t] = pen->part;
    if (mesh->wears) {
        wear_of(pen->state, pen->wall, shape, pen->place, mesh->wear[t]);
    }
}

static void draw_quad(clod_mesh_pen *pen, const clod_vec3 q[4])
{
    draw(pen, q[0], q[1], q[2]);
    draw(pen, q[0], q[2], q[3]);
}

/** A square in the plane, around the point next to the middle of the domain. */
static void draw_plane(clod_mesh_pen *pen)
{
    const clod_shape *shape = pen->shape;
    const clod_domain *domain = pen->domain;
    const clod_vec3 middle = {0.5 * (domain->min[0] + domain->max[0]),
                              0.5 * (domain->min[1] + domain->max[1]),
                              0.5 * (domain->min[2] + domain->max[2])};
    double half = 0.0;
    for (int d = 0; d < 3; d++) {
        half = fmax(half, 0.5 * (domain->max[d] - domain->min[d]));
    }
    const clod_vec3 arm = clod_vec3_sub(middle, shape->center);
    const double a = clod_vec3_dot(arm, shape->axis[0]);
    const double b = clod_vec3_dot(arm, shape->axis[1]);
    draw_quad(pen, (clod_vec3[4]){shape_point(shape, a - half, b - half, 0.0),
                                  shape_point(shape, a + half, b - half, 0.0),
                                  shape_point(shape, a + half, b + half, 0.0),
                                  shape_point(shape, a - half, b + half, 0.0)});
}

/** Point number `corner` of the circle of the given radius at `height` along the axis. */
static clod_vec3 circle_point(const clod_shape *shape, double radius, int corner, double height)
{
    const double angle = 2.0 * M_PI * (corner % SEGMENTS) / SEGMENTS;
    return shape_point(shape, radius * cos(angle), radius * sin(angle), height);
}

/** A flat shape or a shell: a ring between two circles, of which one may be a point. */
static void draw_round(clod_mesh_pen *pen)
{
    const clod_shape *shape = pen->shape;
    const double inner = clod_shape_end_radius(shape);
    const double height = 2.0 * shape->half[2]; // 0 for discs and annuli
    for (int s = 0; s < SEGMENTS; s++) {
        const clod_vec3 q[4] = {circle_point(shape, shape->outer, s, 0.0),
                                circle_point(shape, shape->outer, s + 1, 0.0),
                                circle_point(shape, inner, s + 1, height),
                                circle_point(shape, inner, s, height)};
        if (inner == 0.0) {
            draw(pen, q[0], q[1], q[2]);
        } else if (shape->outer == 0.0) {
            draw(pen, q[0], q[2], q[3]);
        } else {
            draw_quad(pen, q);
        }
    }
}

/** The six faces of a box or bar. */
static void draw_box(clod_mesh_pen *pen)
{
    const double *half = pen->shape->half;
    for (int face = 0; face < 6; face++) {
        const int normal = face / 2;
        const double sign = face % 2 == 0 ? 1.0 : -1.0;
        clod_vec3 q[4];
        for (int corner = 0; corner < 4; corner++) {
            double at[3];
            at[normal] = sign * half[normal];
            at[(normal + 1) % 3] =
                half[(normal + 1) % 3] * (corner == 1 || corner == 2 ? 1 : -1);
            at[(normal + 2) % 3] = half[(normal + 2) % 3] * sign * (corner >= 2 ? 1 : -1);
            q[corner] = shape_point(pen->shape, at[0], at[1], at[2]);
        }
        draw_quad(pen, q);
    }
}

/** All facets of a mesh, each with the shape of its patch. */
static void draw_facets(clod_mesh_pen *pen)
{
    const clod_shape *first = pen->shape;
    const clod_surface *surface = first->surface;
    const int32_t parts = pen->part; // where those of this mesh begin
    for (size_t f = 0; clod_shape_begins_mesh(first) && f < surface->facet_count; f++) {
        const uint32_t *v = surface->facet[f];
        pen->shape = first + CLOD_SURFACE_SLOTS * surface->patch[f];
        pen->place = first->place + (int32_t)f;
        pen->part = surface->part_name[surface->part[f]][0] != '\0'
                        ? parts + (int32_t)surface->part[f]
                        : -1;
        draw(pen, clod_vec3_of(surface->vertex[v[0]]), clod_vec3_of(surface->vertex[v[1]]),
             clod_vec3_of(surface->vertex[v[2]]));
    }
}

/** How shapes of a form are drawn, and with how many triangles at most; one row each. */
static const struct {
    size_t triangles; ///< 0: those of its facets
    void (*draw)(clod_mesh_pen *pen);
} DRAWING[CLOD_FORMS] = {[CLOD_FORM_PLANE] = {2, draw_plane},
                         [CLOD_FORM_BOX] = {12, draw_box},
                         [CLOD_FORM_SHELL] = {2 * SEGMENTS, draw_round},
                         [CLOD_FORM_MESH] = {0, draw_facets}};

static clod_wall_form form_of(const clod_shape *shape)
{
    return clod_shape_kinds_row(shape->kind)->form;
}

static size_t triangles_of(const clod_shape *shape)
{
    return clod_shape_begins_mesh(shape) ? shape->surface->facet_count // of all its patches
                                         : DRAWING[form_of(shape)].triangles;
}

/** A line for each part of all meshes, up to the first for which there is no room; "" if none has a name.
 *  Owned, or NULL without memory. */
static char *name_parts(const clod_state *state)
{
    char *text = clod_memory_alloc(CLOD_WALL_MESH_PARTS, 1);
    size_t used = 0;
    bool named = false, full = false;
    for (int32_t w = 0; text != NULL && w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_surface *of =
                clod_shape_begins_mesh(&wall->shapes[s]) ? wall->shapes[s].surface : NULL;
            for (size_t p = 0; of != NULL && p < of->part_count; p++) {
                char line[CLOD_WEAR_NAME + 2];
                snprintf(line, sizeof line, "%s.%s\n", wall->name, of->part_label[p]);
                const size_t length = strlen(line);
                named = named || of->part_name[p][0] != '\0';
                full = full || used + length >= CLOD_WALL_MESH_PARTS;
                if (!full) { // a line's number is that of its part
                    memcpy(text + used, line, length);
                    used += length;
                }
            }
        }
    }
    if (text != NULL && !named) {
        text[0] = '\0';
    }
    return text;
}

static bool wears(const clod_state *state)
{
    bool any = false;
    for (int32_t w = 0; w < state->walls.count; w++) {
        any |= state->walls.wall[w].wear != NULL;
    }
    return any;
}

bool clod_wall_mesh_make(clod_wall_mesh *self, const clod_state *state, clod_status *status)
{
    size_t triangles = 0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            triangles += triangles_of(&wall->shapes[s]);
        }
    }
    *self = (clod_wall_mesh){
        .corner = clod_memory_alloc(triangles, sizeof *self->corner),
        .velocity = clod_memory_alloc(triangles, sizeof *self->velocity),
        .wall = clod_memory_alloc(triangles, sizeof *self->wall),
        .material = clod_memory_alloc(triangles, sizeof *self->material),
        .shape = clod_memory_alloc(triangles, sizeof *self->shape),
        .part = clod_memory_alloc(triangles, sizeof *self->part),
        .parts = name_parts(state),
        .wears = wears(state),
    };
    if (self->wears) {
        self->wear = clod_memory_alloc(triangles, sizeof *self->wear);
    }
    if (self->corner == NULL || self->velocity == NULL || self->wall == NULL ||
        self->material == NULL || self->shape == NULL || self->part == NULL ||
        self->parts == NULL || (self->wears && self->wear == NULL)) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture of the walls.");
    }
    int32_t parts = 0;
    for (int32_t w = 0; w < state->walls.count; w++) {
        const clod_wall *wall = &state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            const clod_shape *shape = &wall->shapes[s];
            const bool mesh = clod_shape_begins_mesh(shape);
            clod_mesh_pen pen = {self,           wall,  shape,        w,
                                 &state->domain, state, shape->place, mesh ? parts : -1};
            DRAWING[form_of(shape)].draw(&pen);
            parts += mesh ? (int32_t)shape->surface->part_count : 0;
        }
    }
    return true;
}

void clod_wall_mesh_fini(clod_wall_mesh *self)
{
    clod_memory_free(self->corner);
    clod_memory_free(self->velocity);
    clod_memory_free(self->wall);
    clod_memory_free(self->material);
    clod_memory_free(self->shape);
    clod_memory_free(self->part);
    clod_memory_free(self->parts);
    clod_memory_free(self->wear);
    *self = (clod_wall_mesh){0};
}
