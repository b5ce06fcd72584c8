#include "setup/region_walls.h"

#include <math.h>
#include <stdio.h>

#include "config/source.h"
#include "geometry/wall_pose.h"
#include "setup/region_prism.h"
#include "setup/walls.h"

#define SEGMENTS 90 ///< of a disc or annulus: they are within 0.06 % of its radius

/** A shape of a wall, beside a region. */
typedef struct pair {
    const clod_shape *shape;
    clod_wall_pose pose;
    clod_region_prism region;
    clod_vec3 at;     ///< m, where the shape cuts it
    const char *part; ///< of a mesh, that cuts it; "": it has no name
} pair;

static bool cut(pair *self, clod_vec3 *corner, int count)
{
    for (int k = 0; k < count; k++) {
        corner[k] = clod_wall_point_to_space(&self->pose, corner[k]);
    }
    return clod_region_prism_cut(&self->region, corner, count, &self->at);
}

/** A point of a shape from where it is along its axes. */
static clod_vec3 point_of(const clod_shape *shape, double x, double y, double z)
{
    clod_vec3 p = clod_vec3_axpy(shape->center, x, shape->axis[0]);
    p = clod_vec3_axpy(p, y, shape->axis[1]);
    return clod_vec3_axpy(p, z, shape->axis[2]);
}

/** How far the middle of a region is before a plane, and half its extent across it [m]. */
static double before_plane(const pair *self, double *extent)
{
    const clod_vec3 normal = clod_wall_to_space(&self->pose, self->shape->axis[2]);
    const clod_vec3 point = clod_wall_point_to_space(&self->pose, self->shape->center);
    *extent = clod_region_prism_extent(&self->region, normal);
    return clod_vec3_dot(clod_vec3_sub(self->region.middle, point), normal);
}

static bool plane_cuts(pair *self)
{
    double extent;
    const double before = before_plane(self, &extent);
    const clod_vec3 normal = clod_wall_to_space(&self->pose, self->shape->axis[2]);
    self->at = clod_vec3_axpy(self->region.middle, -before, normal);
    return fabs(before) < extent;
}

static bool plane_hides(const pair *self)
{
    double extent;
    return before_plane(self, &extent) <= -extent;
}

static bool box_cuts(pair *self)
{
    static const double SIDE[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    const double *half = self->shape->half;
    for (int face = 0; face < 6; face++) {
        const int a = face / 2, b = (a + 1) % 3, c = (a + 2) % 3;
        clod_vec3 corner[4];
        for (int k = 0; k < 4; k++) {
            double p[3];
            p[a] = face % 2 == 0 ? -half[a] : half[a];
            p[b] = SIDE[k][0] * half[b];
            p[c] = SIDE[k][1] * half[c];
            corner[k] = point_of(self->shape, p[0], p[1], p[2]);
        }
        if (cut(self, corner, 4)) {
            return true;
        }
    }
    return false;
}

static bool box_hides(const pair *self)
{
    const clod_vec3 middle = clod_wall_to_frame(&self->pose, self->region.middle);
    const clod_vec3 r = clod_vec3_sub(middle, self->shape->center);
    bool within = true;
    for (int a = 0; a < 3; a++) {
        const clod_vec3 axis = clod_wall_to_space(&self->pose, self->shape->axis[a]);
        within = within && fabs(clod_vec3_dot(r, self->shape->axis[a])) +
                                   clod_region_prism_extent(&self->region, axis) <=
                               self->shape->half[a];
    }
    return within;
}

static bool disc_cuts(pair *self)
{
    const double radius[2] = {self->shape->outer, clod_shape_end_radius(self->shape)};
    for (int k = 0; k < SEGMENTS; k++) {
        clod_vec3 corner[4];
        for (int c = 0; c < 4; c++) {
            const double angle = 2.0 * M_PI / SEGMENTS * (k + (c == 1 || c == 2));
            const double r = radius[c / 2];
            corner[c] = point_of(self->shape, r * cos(angle), r * sin(angle), 0.0);
        }
        if (cut(self, corner, 4)) {
            return true;
        }
    }
    return false;
}

static bool mesh_cuts(pair *self)
{
    const clod_surface *surface = self->shape->surface;
    for (size_t f = 0; f < surface->facet_count; f++) {
        clod_vec3 corner[3];
        for (int c = 0; c < 3; c++) {
            corner[c] = clod_vec3_of(surface->vertex[surface->facet[f][c]]);
        }
        if (cut(self, corner, 3)) {
            self->part = surface->part_name[surface->part[f]];
            return true;
        }
    }
    return false;
}

/** Radius of the smallest grain of a group [m]. */
static double smallest(const clod_case_grains *group)
{
    return group->sieve_count > 0 ? 0.5 * group->sieve[0].size : group->radius_min;
}

static bool cuts(pair *self)
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row(self->shape->kind);
    return kind->endless   ? plane_cuts(self)
           : kind->solid   ? box_cuts(self)
           : kind->faceted ? mesh_cuts(self)
           : kind->flat    ? disc_cuts(self)
                           : false;
}

static bool hides(const pair *self)
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row(self->shape->kind);
    return kind->endless ? plane_hides(self) : kind->solid && box_hides(self);
}

/** Shapes of a wall as the case counts them: a mesh is one. */
static bool begins(const clod_shape *shape)
{
    return shape->surface == NULL || clod_shape_begins_mesh(shape);
}

static void tell_cut(const pair *self, const char *shape, const char *key, const char *where,
                     clod_setup_regions_tell tell, void *context)
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row(self->shape->kind);
    const bool named = self->part[0] != '\0';
    char text[512];
    snprintf(text, sizeof text,
             "%s%s: %s%s%s reaches through it, at (%.4g, %.4g, %.4g) m: %s. Move or "
             "shorten the region, or the wall",
             where, key, shape, named ? ", part " : "", self->part, self->at.x, self->at.y,
             self->at.z,
             kind->endless ? "no grain comes behind this plane"
             : kind->solid ? "no grain comes in this solid"
                           : "grains come on both sides of it");
    tell(context, text);
}

/** A shape by its key in the case, from one to the next. */
static void name_shape(const clod_wall *wall, int number, char *text, size_t size)
{
    snprintf(text, size, "walls.%s.shapes.%d", wall->name, number);
}

void clod_setup_regions_doubts(const clod_case *from, const clod_walls *walls, bool packings,
                               clod_setup_regions_tell tell, void *context)
{
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        const double radius = smallest(group);
        pair one = {.part = ""};
        if (group->file != NULL || !(group->comes || packings)) {
            continue;
        }
        one.region = clod_region_prism_make(&group->region, radius);
        if (!clod_region_prism_shrink(&group->region, 2.0 * radius, &one.region)) {
            continue;
        }
        for (int32_t w = 0; w < walls->count; w++) {
            const clod_wall *wall = &walls->wall[w];
            one.pose = clod_wall_pose_now(wall);
            for (int32_t s = 0, number = 0; s < wall->shape_count; s++) {
                one.shape = &wall->shapes[s];
                one.part = "";
                if (begins(one.shape) && cuts(&one)) {
                    char shape[80], key[64], where[CLOD_SOURCE_WHERE];
                    name_shape(wall, number, shape, sizeof shape);
                    snprintf(key, sizeof key, "grains.%zu.region", k);
                    tell_cut(&one, shape, key, clod_source_where(from, key, where), tell,
                             context);
                }
                number += begins(one.shape);
            }
        }
    }
}

/** Whether a wall hides no region of a group. */
static bool is_reached(const clod_wall *wall, const clod_case_grains *group, size_t k,
                       clod_status *status)
{
    pair one = {.pose = clod_wall_pose_now(wall),
                .region = clod_region_prism_make(&group->region, smallest(group))};
    for (int32_t s = 0, number = 0; s < wall->shape_count; s++) {
        one.shape = &wall->shapes[s];
        if (hides(&one)) {
            char shape[80];
            name_shape(wall, number, shape, sizeof shape);
            const bool plane = clod_shape_kinds_row(one.shape->kind)->endless;
            return clod_status_fail(
                status, CLOD_USAGE,
                plane
                    ? "grains.%zu.region: all of it lies behind the plane %s, where no grain can be. Move the "
                      "region, or turn the normal of the plane to it"
                    : "grains.%zu.region: all of it lies in the solid %s, where no grain can be. Move the "
                      "region or the wall",
                k, shape);
        }
        number += begins(one.shape);
    }
    return true;
}

bool clod_setup_regions_reached(const clod_case *from, const clod_walls *walls,
                                clod_status *status)
{
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        for (int32_t w = 0; group->file == NULL && w < walls->count; w++) {
            const bool counts = !group->comes || clod_setup_wall_stays(from, &walls->wall[w]);
            if (counts && !is_reached(&walls->wall[w], group, k, status)) {
                return false;
            }
        }
    }
    return true;
}
