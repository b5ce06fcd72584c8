#include "state/shape_kinds.h"

#include <math.h>

#include "base/assert.h"
#include "base/vec3.h"
#include "state/walls.h"

// ---- rules between keys

static clod_shape_fault fault_of_annulus(const clod_case_shape *from)
{
    if (from->inner_radius >= from->outer_radius) {
        return (clod_shape_fault){"annulus.inner_radius", "must be smaller than outer_radius"};
    }
    return (clod_shape_fault){0};
}

static clod_shape_fault fault_of_cone(const clod_case_shape *from)
{
    if (from->foot_radius == from->top_radius) {
        return (clod_shape_fault){"cone.top_radius",
                                  "is the same as foot_radius; write a cylinder, or change one "
                                  "of them"};
    }
    return (clod_shape_fault){0};
}

static bool is_zero(clod_vec3 v)
{
    return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

static clod_shape_fault fault_of_bar(const clod_case_shape *from)
{
    const clod_vec3 along = clod_vec3_sub(clod_vec3_of(from->to), clod_vec3_of(from->from));
    if (is_zero(along)) {
        return (clod_shape_fault){"bar.to", "is the same point as from; the bar has no length"};
    }
    if (is_zero(clod_vec3_cross(along, clod_vec3_of(from->up)))) {
        return (clod_shape_fault){"bar.up",
                                  "points along the bar; choose a direction across it"};
    }
    return (clod_shape_fault){0};
}

// ---- sizes and axes

/** A bar is a box whose first axis is its centre line and whose third axis is `up`. */
static void make_bar(const clod_case_shape *from, clod_shape *shape)
{
    const clod_vec3 start = clod_vec3_of(from->from);
    const clod_vec3 line = clod_vec3_sub(clod_vec3_of(from->to), start);
    shape->axis[0] = clod_vec3_unit(line);
    shape->axis[1] = clod_vec3_unit(clod_vec3_cross(clod_vec3_of(from->up), shape->axis[0]));
    shape->axis[2] = clod_vec3_cross(shape->axis[0], shape->axis[1]);
    shape->center = clod_vec3_axpy(start, 0.5, line);
    shape->half[0] = 0.5 * clod_vec3_length(line);
    shape->half[1] = 0.5 * from->width;
    shape->half[2] = 0.5 * from->height;
}

static void make_box(const clod_case_shape *from, clod_shape *shape)
{
    shape->axis[0] = (clod_vec3){1.0, 0.0, 0.0};
    shape->axis[1] = (clod_vec3){0.0, 1.0, 0.0};
    shape->axis[2] = (clod_vec3){0.0, 0.0, 1.0};
    for (int a = 0; a < 3; a++) {
        shape->half[a] = 0.5 * from->size[a];
    }
}

/** A disc; or a plane, which has no radius. */
static void make_disc(const clod_case_shape *from, clod_shape *shape)
{
    shape->axis[2] = clod_vec3_unit(clod_vec3_of(from->normal));
    shape->outer = from->radius;
}

static void make_annulus(const clod_case_shape *from, clod_shape *shape)
{
    shape->axis[2] = clod_vec3_unit(clod_vec3_of(from->normal));
    shape->inner = from->inner_radius;
    shape->outer = from->outer_radius;
}

static void make_cylinder(const clod_case_shape *from, clod_shape *shape)
{
    shape->axis[2] = clod_vec3_unit(clod_vec3_of(from->axis));
    shape->outer = from->radius;
    shape->half[2] = 0.5 * from->length;
    shape->side = (clod_side)from->side;
}

static void make_cone(const clod_case_shape *from, clod_shape *shape)
{
    make_cylinder(from, shape);
    shape->outer = from->foot_radius;
    shape->inner = from->top_radius;
}

// ---- areas

static double area_of_ring(const clod_shape *shape)
{
    return M_PI * (shape->outer * shape->outer - shape->inner * shape->inner);
}

static double area_of_shell(const clod_shape *shape)
{
    const double end = clod_shape_end_radius(shape);
    return M_PI * (shape->outer + end) * hypot(2.0 * shape->half[2], shape->outer - end);
}

static double area_of_box(const clod_shape *shape)
{
    const double *half = shape->half;
    return 8.0 * (half[0] * half[1] + half[1] * half[2] + half[2] * half[0]);
}

static const clod_shape_kind_row SHAPES[CLOD_SHAPE_KINDS] = {
    [CLOD_SHAPE_PLANE] = {.form = CLOD_FORM_PLANE, .endless = true, .make = make_disc},
    [CLOD_SHAPE_DISC] = {.form = CLOD_FORM_SHELL,
                         .flat = true,
                         .make = make_disc,
                         .area = area_of_ring},
    [CLOD_SHAPE_ANNULUS] = {.form = CLOD_FORM_SHELL,
                            .flat = true,
                            .make = make_annulus,
                            .area = area_of_ring,
                            .fault = fault_of_annulus},
    [CLOD_SHAPE_CYLINDER] = {.form = CLOD_FORM_SHELL,
                             .shell = true,
                             .straight = true,
                             .make = make_cylinder,
                             .area = area_of_shell},
    [CLOD_SHAPE_CONE] = {.form = CLOD_FORM_SHELL,
                         .shell = true,
                         .make = make_cone,
                         .area = area_of_shell,
                         .fault = fault_of_cone},
    [CLOD_SHAPE_BOX] = {.form = CLOD_FORM_BOX,
                        .solid = true,
                        .boxed = true,
                        .make = make_box,
                        .area = area_of_box},
    [CLOD_SHAPE_BAR] = {.form = CLOD_FORM_BOX,
                        .solid = true,
                        .boxed = true,
                        .make = make_bar,
                        .area = area_of_box,
                        .fault = fault_of_bar},
    [CLOD_SHAPE_MESH] = {.form = CLOD_FORM_MESH, .faceted = true, .boxed = true, .file = true},
    [CLOD_SHAPE_CONVEYOR] = {.form = CLOD_FORM_MESH,
                             .faceted = true,
                             .boxed = true,
                             .conveyor = true},
};

const clod_shape_kind_row *clod_shape_kinds_row(clod_shape_kind kind)
{
    CLOD_ASSERT((unsigned)kind < CLOD_SHAPE_KINDS);
    return &SHAPES[kind];
}
