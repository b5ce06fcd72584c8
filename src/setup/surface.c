#include "setup/surface.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "clod/mesh.h"
#include "mesh/surface_touch.h"
#include "state/shape_kinds.h"

/** Most patches of a surface: the shapes of each take 3 kB. */
#define PATCHES_MOST 200000
/** A belt goes smoothly over bends below this angle: idlers of a trough bend it more [rad]. */
#define BELT_SMOOTH (M_PI / 9.0)

/** Names of the parts of a mesh for a message; "": it has none. */
static void names_of(const clod_mesh_view *view, char *text, size_t size)
{
    clod_text_names names = clod_text_names_begin(text, size);
    for (size_t p = 0; p < view->part_count; p++) {
        if (view->parts[p].name[0] != '\0') {
            clod_text_names_add(&names, view->parts[p].name);
        }
    }
    clod_text_names_end(&names);
}

/** Find the parts of the case in the file. */
static bool find_parts(clod_setup_mesh *self, const clod_mesh_view *view,
                       const clod_case_shape *shape, clod_status *status)
{
    self->parts = clod_memory_alloc(view->part_count + 1, sizeof *self->parts);
    if (self->parts == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the parts of %s",
                                shape->file);
    }
    for (size_t k = 0; k < shape->part_count; k++) {
        bool found = false;
        for (size_t p = 0; p < view->part_count; p++) {
            if (strcmp(view->parts[p].name, shape->parts[k].name) == 0) {
                self->parts[p] = &shape->parts[k];
                found = true;
            }
        }
        if (!found) {
            char names[400];
            names_of(view, names, sizeof names);
            return clod_status_fail(
                status, CLOD_USAGE,
                "parts.%s: the mesh %s has no part of this name; its parts %s%s",
                shape->parts[k].name, shape->file,
                names[0] != '\0' ? "are " : "have no names: write surface: for all of it",
                names);
        }
    }
    return true;
}

/** Whether clod makes its mesh: a conveyor belt. */
static bool is_conveyor(const clod_case_shape *shape)
{
    return clod_shape_kinds_row((clod_shape_kind)shape->kind)->conveyor;
}

/** The surface of a mesh, where it stands at the start; NULL: failed. */
static clod_surface *make_surface(const clod_mesh *mesh, const clod_case_wall *wall,
                                  const clod_case_shape *shape, clod_status *status)
{
    clod_mesh_placing then = {.unit = 1.0, .scale = 1.0, .rotate = wall->rotate};
    memcpy(then.move, wall->move, sizeof then.move);
    const bool belt = is_conveyor(shape);
    const double smooth = belt ? BELT_SMOOTH : shape->smooth_angle;
    clod_surface *surface = clod_surface_make(mesh, &then, smooth, status);
    if (surface != NULL && surface->patch_count > PATCHES_MOST) {
        clod_status_fail(status, CLOD_USAGE,
                         "the mesh %s is rough: its facets make %zu pieces of smooth surface, "
                         "and clod takes %d; make it coarser, or smooth_angle larger",
                         shape->file, surface->patch_count, PATCHES_MOST);
        clod_surface_release(surface);
        return NULL;
    }
    return surface;
}

/** The cylinder about the axis of a part, where the wall places it. */
static clod_surface_cylinder placed(const clod_case_wall *wall, const clod_case_surface *part,
                                    double radius)
{
    clod_surface_cylinder self = {clod_vec3_of(part->spin_point), clod_vec3_of(part->spin_axis),
                                  radius};
    const clod_case_rotation *turn = &wall->rotate;
    if (turn->angle != 0.0) {
        const clod_vec3 axis = clod_vec3_unit(clod_vec3_of(turn->axis));
        const clod_vec3 point = clod_vec3_of(turn->point);
        const clod_vec3 arm = clod_vec3_sub(self.point, point);
        self.point = clod_vec3_add(point, clod_vec3_rotate(arm, axis, turn->angle));
        self.axis = clod_vec3_rotate(self.axis, axis, turn->angle);
    }
    self.point = clod_vec3_add(self.point, clod_vec3_of(wall->move));
    return self;
}

/** The same of a belt, whose mesh is made. */
static void read_belt(clod_setup_mesh *self, const clod_case_wall *wall,
                      const clod_case_shape *shape, clod_status *status)
{
    self->belt = clod_setup_belt_make(&shape->belt, wall->name, status);
    if (self->belt.mesh == NULL) {
        return;
    }
    const size_t count = clod_mesh_look(self->belt.mesh)->part_count;
    self->parts = clod_memory_alloc(count + 1, sizeof *self->parts);
    if (self->parts == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for the belt %s", wall->name);
        return;
    }
    for (size_t p = 0; p < count; p++) {
        self->parts[p] = &self->belt.parts[p];
    }
    self->surface = make_surface(self->belt.mesh, wall, shape, status);
    const clod_case_belt *belt = &shape->belt;
    const uint32_t pulley = (uint32_t)belt->run_count; // the part behind the runs
    if (self->surface != NULL && belt->pulley.radius > 0.0) {
        const clod_surface_cylinder cylinder =
            placed(wall, &self->belt.parts[pulley], belt->pulley.radius);
        if (!clod_surface_make_round(self->surface, pulley, &cylinder)) {
            clod_status_fail(status, CLOD_FAILED, "no memory for the belt %s", wall->name);
            clod_surface_release(self->surface);
            self->surface = NULL;
        }
    }
}

clod_setup_mesh clod_setup_mesh_read(const clod_case_wall *wall, const clod_case_shape *shape,
                                     clod_status *status)
{
    clod_setup_mesh self = {0};
    if (is_conveyor(shape)) {
        read_belt(&self, wall, shape, status);
        return self;
    }
    clod_mesh_placing placing = {
        .unit = shape->unit, .scale = shape->scale, .rotate = shape->rotate};
    memcpy(placing.move, shape->move, sizeof placing.move);
    clod_mesh *mesh = clod_mesh_read(shape->file, &placing, status);
    if (mesh != NULL && find_parts(&self, clod_mesh_look(mesh), shape, status)) {
        self.surface = make_surface(mesh, wall, shape, status);
    }
    clod_mesh_destroy(&mesh);
    return self;
}

void clod_setup_mesh_fini(clod_setup_mesh *self)
{
    clod_surface_release(self->surface);
    clod_memory_free(self->parts);
    clod_setup_belt_fini(&self->belt);
    *self = (clod_setup_mesh){0};
}

void clod_setup_surface_shape(clod_surface *surface, int32_t patch, int32_t slot,
                              clod_shape *shape)
{
    const clod_surface_patch *of = &surface->patches[patch];
    const clod_vec3 low = clod_vec3_of(of->low), high = clod_vec3_of(of->high);
    shape->kind = CLOD_SHAPE_MESH;
    shape->center = clod_vec3_scale(clod_vec3_add(low, high), 0.5);
    shape->axis[0] = (clod_vec3){1.0, 0.0, 0.0};
    shape->axis[1] = (clod_vec3){0.0, 1.0, 0.0};
    shape->axis[2] = (clod_vec3){0.0, 0.0, 1.0};
    for (int a = 0; a < 3; a++) {
        shape->half[a] = 0.5 * (of->high[a] - of->low[a]);
    }
    shape->surface = clod_surface_share(surface);
    shape->patch = patch;
    shape->slot = slot;
}
