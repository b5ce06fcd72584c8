#include "state/walls.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

/** Angle [rad] and relative offset below which two axes count as one. */
#define SAME_AXIS 1e-9

/** A direction of the frame as it lies in space at angle 0. */
static clod_vec3 oriented(const clod_wall *self, clod_vec3 direction)
{
    return clod_quat_is_none(self->orientation)
               ? direction
               : clod_quat_rotate(self->orientation, direction);
}

/** Distance of a point of the frame from the spin axis [m]. */
static double axis_distance(const clod_wall *self, clod_vec3 point)
{
    const clod_vec3 arm = oriented(self, clod_vec3_sub(point, self->spin_point));
    return clod_vec3_length(clod_vec3_cross(self->spin_axis, arm));
}

static bool is_symmetric(const clod_wall *self, const clod_shape *shape)
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row(shape->kind);
    if (kind->boxed) {
        return false;
    }
    const clod_vec3 axis = oriented(self, shape->axis[2]);
    if (clod_vec3_length(clod_vec3_cross(axis, self->spin_axis)) > SAME_AXIS) {
        return false;
    }
    const double radius = fmax(shape->inner, shape->outer);
    return kind->endless || axis_distance(self, shape->center) <= SAME_AXIS * radius;
}

void clod_wall_find_symmetry(clod_wall *self)
{
    for (int32_t s = 0; s < self->shape_count; s++) {
        self->shapes[s].symmetric = is_symmetric(self, &self->shapes[s]);
    }
}

int32_t clod_wall_plane_across(const clod_wall *self)
{
    for (int32_t s = 0; s < self->shape_count; s++) {
        const clod_shape *shape = &self->shapes[s];
        if (clod_shape_kinds_row(shape->kind)->endless && !shape->symmetric) {
            return s;
        }
    }
    return -1;
}

/** A direction of the frame in space, where the wall is now. */
static clod_vec3 to_space(const clod_wall *self, clod_vec3 direction)
{
    return clod_vec3_rotate(oriented(self, direction), self->spin_axis, self->angle);
}

/** Without what of it is along the normal. */
static clod_vec3 flat(clod_vec3 v, clod_vec3 normal)
{
    return clod_vec3_axpy(v, -clod_vec3_dot(v, normal), normal);
}

clod_vec3 clod_wall_material_velocity(const clod_wall *self, int32_t shape, clod_vec3 point,
                                      clod_vec3 normal)
{
    const clod_belt *belt = &self->shapes[shape].belt;
    const clod_vec3 origin = clod_vec3_add(self->spin_point, self->shift);
    const clod_vec3 arm = clod_vec3_sub(belt->spin_point, self->spin_point);
    const clod_vec3 centre = clod_vec3_add(origin, to_space(self, arm));
    const clod_vec3 turning = clod_vec3_scale(to_space(self, belt->spin_axis), belt->spin);
    const clod_vec3 along = flat(to_space(self, belt->direction), normal);
    const double square = clod_vec3_dot(along, along);
    clod_vec3 v = to_space(self, belt->velocity);
    v = clod_vec3_add(v, clod_vec3_cross(turning, clod_vec3_sub(point, centre)));
    if (square > CLOD_BELT_ACROSS) {
        v = clod_vec3_axpy(v, belt->speed / sqrt(square), along);
    }
    v = clod_vec3_axpy(self->surface_velocity, 1.0 - self->belt_lag, v);
    return clod_vec3_add(clod_wall_velocity_at(self, point), flat(v, normal));
}

bool clod_wall_has_belts(const clod_wall *self)
{
    const clod_vec3 all = self->surface_velocity;
    if (all.x != 0.0 || all.y != 0.0 || all.z != 0.0) {
        return true;
    }
    for (int32_t s = 0; s < self->shape_count; s++) {
        if (clod_belt_moves(&self->shapes[s].belt)) {
            return true;
        }
    }
    return false;
}

void clod_wall_set_orientation(clod_wall *self, clod_quat orientation)
{
    self->orientation = clod_quat_unit(orientation);
    self->angle = self->turned = 0.0;
    clod_wall_find_symmetry(self);
}

void clod_wall_set_spin_axis(clod_wall *self, clod_vec3 axis, clod_vec3 point)
{
    const clod_quat turned = clod_quat_about(self->spin_axis, self->angle);
    const clod_quat now =
        clod_quat_unit(clod_quat_product(turned, clod_wall_orientation(self)));
    const clod_vec3 origin = clod_vec3_add(self->spin_point, self->shift);
    const clod_quat back = {now.w, -now.x, -now.y, -now.z};
    const clod_vec3 arm = clod_quat_rotate(back, clod_vec3_sub(point, origin));
    self->spin_point = clod_vec3_add(self->spin_point, arm);
    self->shift = clod_vec3_sub(point, self->spin_point);
    self->spin_axis = axis;
    clod_wall_set_orientation(self, now);
}

/** Largest distance of a corner of a box from the spin axis; exact, as a box is convex. */
static double box_reach(const clod_wall *self, const clod_shape *shape)
{
    double reach = 0.0;
    for (int corner = 0; corner < 8; corner++) {
        clod_vec3 p = shape->center;
        for (int a = 0; a < 3; a++) {
            const double half = (corner >> a & 1) != 0 ? shape->half[a] : -shape->half[a];
            p = clod_vec3_axpy(p, half, shape->axis[a]);
        }
        reach = fmax(reach, axis_distance(self, p));
    }
    return reach;
}

/** Upper bound of the distance of any point of a bounded shape from the spin axis [m]. */
static double shape_reach(const clod_wall *self, const clod_shape *shape)
{
    const clod_shape_kind_row *kind = clod_shape_kinds_row(shape->kind);
    if (kind->boxed) {
        return box_reach(self, shape);
    }
    const double foot = axis_distance(self, shape->center) + shape->outer;
    if (kind->shell) {
        const clod_vec3 end =
            clod_vec3_axpy(shape->center, 2.0 * shape->half[2], shape->axis[2]);
        return fmax(foot, axis_distance(self, end) + clod_shape_end_radius(shape));
    }
    return foot;
}

double clod_wall_reach(const clod_wall *self)
{
    double reach = 0.0;
    for (int32_t s = 0; s < self->shape_count; s++) {
        const clod_shape *shape = &self->shapes[s];
        if (!shape->symmetric && !clod_shape_kinds_row(shape->kind)->endless) {
            reach = fmax(reach, shape_reach(self, shape));
        }
    }
    return reach;
}

double clod_wall_speed_within(const clod_wall *self, double reach)
{
    const double rate = 2.0 * M_PI * self->oscillation.frequency;
    const double spin = fabs(self->spin) + rate * self->oscillation.angle;
    return clod_vec3_length(self->velocity) + fabs(self->servo_velocity) +
           rate * self->oscillation.amplitude + spin * reach;
}

double clod_wall_speed_bound(const clod_wall *self)
{
    return clod_wall_speed_within(self, clod_wall_reach(self));
}

/** Cycles of an oscillation that are done after some steps, without the whole ones. */
static double cycles_after(const clod_oscillation *oscillation, double dt, double steps)
{
    const double per_step = oscillation->frequency * dt;
    const double cycles = steps * per_step;
    const double lost = fma(steps, per_step, -cycles); // to rounding: it grows with the time
    return cycles - floor(cycles) + lost;
}

/** Displacement, where travel and turned have it, and velocity; `sine` and its rate [1/s]. */
static void displace(clod_wall *self, double sine, double rate)
{
    const clod_oscillation *o = &self->oscillation;
    self->shift = clod_vec3_axpy(self->travel, o->amplitude * sine, o->direction);
    self->angle = self->turned + o->angle * sine;
    self->sway_velocity = clod_vec3_scale(o->direction, o->amplitude * rate);
    self->sway_spin = o->angle * rate;
}

/** Fraction of their speed that the belts lack at a time [s]. */
static double lag_at(const clod_start_up *self, double time)
{
    const double since = time - self->at;
    return since >= self->duration ? 0.0 : since <= 0.0 ? 1.0 : 1.0 - since / self->duration;
}

void clod_wall_start(clod_wall *self)
{
    const clod_oscillation *o = &self->oscillation;
    self->belt_lag = lag_at(&self->start_up, 0.0);
    displace(self, sin(o->phase), 2.0 * M_PI * o->frequency * cos(o->phase));
}

/** The oscillation at the end of a step: sin b - sin a = 2 sin((b - a)/2) cos((b + a)/2). */
static void sway(clod_wall *self, double dt, int64_t step)
{
    const clod_oscillation *o = &self->oscillation;
    const double end = 2.0 * M_PI * cycles_after(o, dt, (double)step) + o->phase;
    const double middle = 2.0 * M_PI * cycles_after(o, dt, (double)step - 0.5) + o->phase;
    displace(self, sin(end), 2.0 / dt * sin(M_PI * o->frequency * dt) * cos(middle));
}

void clod_wall_join(clod_wall *self, double dt, int64_t step)
{
    clod_wall_start(self);
    self->belt_lag = lag_at(&self->start_up, dt * (double)step);
    if (step > 0 && self->oscillation.frequency > 0.0) {
        sway(self, dt, step);
    }
}

void clod_wall_move(clod_wall *self, double dt, int64_t step)
{
    const bool sways = self->oscillation.frequency > 0.0;
    self->belt_lag = lag_at(&self->start_up, dt * (double)step);
    clod_vec3 *moved = sways ? &self->travel : &self->shift;
    double *turned = sways ? &self->turned : &self->angle;
    *moved = clod_vec3_axpy(*moved, dt, self->velocity);
    *moved = clod_vec3_axpy(*moved, dt * self->servo_velocity, self->load_axis);
    *turned += dt * self->spin;
    if (sways) {
        sway(self, dt, step);
    }
}

int32_t clod_walls_find(const clod_walls *self, const char *name)
{
    for (int32_t w = 0; w < self->count; w++) {
        if (strcmp(self->wall[w].name, name) == 0) {
            return w;
        }
    }
    return -1;
}

bool clod_walls_remove(const clod_walls *self)
{
    bool some = false;
    for (int32_t w = 0; w < self->count; w++) {
        for (int32_t s = 0; s < self->wall[w].shape_count; s++) {
            some |= self->wall[w].shapes[s].outlet > 0;
        }
    }
    return some;
}

void clod_walls_reset_sums(clod_walls *self)
{
    for (int32_t w = 0; w < self->count; w++) {
        clod_wall *wall = &self->wall[w];
        wall->sum_steps = 0;
        wall->sum_force = (clod_vec3){0.0, 0.0, 0.0};
        wall->sum_torque = (clod_vec3){0.0, 0.0, 0.0};
        wall->sum_power = 0.0;
    }
}

clod_shape *clod_shapes_copy(const clod_shape *shapes, int32_t count)
{
    clod_shape *copy = clod_memory_alloc((size_t)count, sizeof *copy);
    for (int32_t s = 0; copy != NULL && s < count; s++) {
        copy[s] = shapes[s];
        clod_surface_share(copy[s].surface);
    }
    return copy;
}

void clod_shapes_free(clod_shape **shapes, int32_t count)
{
    for (int32_t s = 0; *shapes != NULL && s < count; s++) {
        clod_surface_release((*shapes)[s].surface);
    }
    clod_memory_free(*shapes);
    *shapes = NULL;
}

bool clod_walls_copy(clod_walls *self, const clod_walls *from, clod_status *status)
{
    *self = (clod_walls){0};
    if (from->count == 0) {
        return true;
    }
    self->wall = clod_memory_alloc((size_t)from->count, sizeof *self->wall);
    if (self->wall == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory to copy the walls");
    }
    for (int32_t w = 0; w < from->count; w++) {
        const clod_wall *wall = &from->wall[w];
        clod_shape *shapes = clod_shapes_copy(wall->shapes, wall->shape_count);
        if (shapes == NULL) {
            clod_walls_fini(self);
            return clod_status_fail(status, CLOD_FAILED, "no memory to copy the walls");
        }
        self->wall[w] = *wall;
        self->wall[w].shapes = shapes;
        self->wall[w].wear = NULL;
        self->count = w + 1;
        if (wall->wear != NULL) {
            const size_t size = (size_t)wall->wear_rows * sizeof *wall->wear;
            self->wall[w].wear = clod_memory_alloc(1, size + 1);
            if (self->wall[w].wear == NULL) {
                clod_walls_fini(self);
                return clod_status_fail(status, CLOD_FAILED, "no memory to copy the walls");
            }
            memcpy(self->wall[w].wear, wall->wear, size);
        }
    }
    return true;
}

void clod_wall_fini(clod_wall *self)
{
    clod_shapes_free(&self->shapes, self->shape_count);
    clod_memory_free(self->wear);
    clod_wall_give(self);
}

void clod_wall_give(clod_wall *self)
{
    self->shapes = NULL;
    self->shape_count = 0;
    self->wear = NULL;
    self->wear_places = self->wear_rows = 0;
}

void clod_walls_fini(clod_walls *self)
{
    for (int32_t w = 0; w < self->count; w++) {
        clod_wall_fini(&self->wall[w]);
    }
    clod_memory_free(self->wall);
    *self = (clod_walls){0};
}
