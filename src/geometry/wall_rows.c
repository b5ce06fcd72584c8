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
    self->shape =
        clod_memory_alloc(CLOD_SHAPE_ROWS * (shapes + CLOD_FORMS), sizeof *self->shape);
    self->patch = clod_memory_alloc(shapes + 1, sizeof *self->patch);
    self->first_shape = clod_memory_alloc(count + 1, sizeof *self->first_shape);
    self->pose = clod_memory_alloc(count + 1, sizeof *self->pose);
    self->motion = clod_memory_alloc(count + 1, sizeof *self->motion);
    self->reach = clod_memory_alloc(count + 1, sizeof *self->reach);
    if (self->shape == NULL || self->patch == NULL || self->first_shape == NULL ||
        self->pose == NULL || self->motion == NULL || self->reach == NULL) {
        clod_wall_rows_fini(self);
        return false;
    }
    for (size_t f = 0; f < CLOD_FORMS; f++) { // all zero else
        self->shape[CLOD_SHAPE_ROWS * (shapes + f)][3] = CLOD_WALL_KIND[f];
    }
    for (int32_t w = 0; w < walls->count; w++) {
        self->first_shape[w + 1] = self->first_shape[w] + walls->wall[w].shape_count;
        for (int32_t s = 0; s < walls->wall[w].shape_count; s++) {
            const clod_shape *shape = &walls->wall[w].shapes[s];
            self->patch[self->first_shape[w] + s] =
                (clod_wall_patch){shape->surface, shape->patch, shape->slot};
        }
        clod_wall_rows_forget(self, w); // nowhere yet
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

clod_wall_placement clod_wall_placement_of(const clod_wall *wall)
{
    return (clod_wall_placement){.wall = wall,
                                 .now = clod_wall_pose_now(wall),
                                 .rest = clod_wall_pose_at_rest(wall),
                                 .turned = wall->angle != 0.0,
                                 .given = clod_quat_is_none(wall->orientation),
                                 .velocity = clod_wall_velocity(wall),
                                 .spin =
                                     clod_vec3_scale(wall->spin_axis, clod_wall_spin(wall))};
}

/** A shape where it is: shifted, and turned if there is an angle or an orientation. */
static void place_shape(const clod_wall_placement *self, const clod_shape *shape,
                        double (*row)[4])
{
    if (shape->surface != NULL) {
        clod_wall_facets_put(self->turned ? &self->now : &self->rest, row);
        return;
    }
    clod_shape now = *shape;
    const bool turned = self->turned && !shape->symmetric;
    if (!turned && self->given) {
        now.center = clod_vec3_add(now.center, self->wall->shift);
    } else {
        const clod_wall_pose *pose = turned ? &self->now : &self->rest;
        now.center = clod_wall_point_to_space(pose, now.center);
        for (int a = 0; a < 3; a++) {
            now.axis[a] = clod_wall_to_space(pose, now.axis[a]);
        }
    }
    clod_wall_shape_rows(&now, row);
}

/** How the material of a shape moves: with its wall, and as a belt, which turns with the wall.
 */
static void place_motion(const clod_wall_placement *self, const clod_belt *belt,
                         double (*row)[4])
{
    const clod_wall_pose *pose = &self->now;
    const clod_vec3 all = self->wall->surface_velocity;
    clod_vec3_put(row[CLOD_SHAPE_VELOCITY], self->velocity);
    clod_vec3_put(row[CLOD_SHAPE_SPIN], self->spin);
    clod_vec3_put(row[CLOD_SHAPE_ORIGIN], pose->origin);
    const bool moves = clod_belt_moves(belt) || all.x != 0.0 || all.y != 0.0 || all.z != 0.0;
    row[CLOD_SHAPE_VELOCITY][3] = moves ? 1.0 : 0.0;
    if (moves) {
        const double share = 1.0 - self->wall->belt_lag;
        const clod_vec3 turning =
            clod_vec3_scale(clod_wall_to_space(pose, belt->spin_axis), share * belt->spin);
        const clod_vec3 point = clod_wall_point_to_space(pose, belt->spin_point);
        const clod_vec3 arm = clod_vec3_sub(pose->origin, point);
        const clod_vec3 b =
            clod_vec3_axpy(all, share, clod_wall_to_space(pose, belt->velocity));
        clod_vec3_put(row[CLOD_SHAPE_BELT], clod_vec3_add(b, clod_vec3_cross(turning, arm)));
        clod_vec3_put(row[CLOD_SHAPE_BELT_SPIN], turning);
        clod_vec3_put(row[CLOD_SHAPE_DIRECTION], clod_wall_to_space(pose, belt->direction));
        row[CLOD_SHAPE_BELT][3] = share * belt->speed;
    }
}

void clod_wall_rows_place_shape(clod_wall_rows *self, int32_t w,
                                const clod_wall_placement *placement, int32_t shape)
{
    double(*row)[4] = self->shape + clod_wall_rows_shape(self, w, shape);
    place_shape(placement, &placement->wall->shapes[shape], row);
    place_motion(placement, &placement->wall->shapes[shape].belt, row);
}

/** Copy numbers; whether any is another one. */
static bool renew(double *to, const double *from, int count)
{
    bool other = false;
    for (int c = 0; c < count; c++) {
        other |= to[c] != from[c];
        to[c] = from[c];
    }
    return other;
}

/** Note what a wall's rows are to be for; whether they were for something else. */
static bool note(clod_wall_rows *self, int32_t w, const clod_wall *wall)
{
    double pose[CLOD_WALL_POSE_NUMBERS];
    clod_wall_pose_get(wall, pose);
    const clod_vec3 v = clod_wall_velocity(wall);
    const clod_vec3 spin = clod_vec3_scale(wall->spin_axis, clod_wall_spin(wall));
    const clod_vec3 u = wall->surface_velocity;
    const double motion[CLOD_WALL_MOTION_NUMBERS] = {v.x,    v.y, v.z, spin.x, spin.y,
                                                     spin.z, u.x, u.y, u.z,    wall->belt_lag};
    const bool moved = renew(self->pose[w], pose, CLOD_WALL_POSE_NUMBERS);
    return renew(self->motion[w], motion, CLOD_WALL_MOTION_NUMBERS) || moved;
}

void clod_wall_rows_note(clod_wall_rows *self, int32_t w, const clod_wall *wall)
{
    note(self, w, wall);
}

void clod_wall_rows_forget(clod_wall_rows *self, int32_t w)
{
    self->pose[w][0] = NAN; // no pose is the same
}

void clod_wall_rows_place(clod_wall_rows *self, int32_t w, const clod_wall *wall)
{
    if (note(self, w, wall)) {
        const clod_wall_placement placement = clod_wall_placement_of(wall);
        for (int32_t s = 0; s < wall->shape_count; s++) {
            clod_wall_rows_place_shape(self, w, &placement, s);
        }
    }
}

// ---- what differs between forms: one row each

typedef const double (*shape_rows)[4];

static shape_rows rows_of(const clod_wall_rows *self, int32_t w, int32_t shape)
{
    return (shape_rows)self->shape + clod_wall_rows_shape(self, w, shape);
}

static void box_of_plane(const clod_wall_rows *self, int32_t w, int32_t shape, int axis,
                         double *low, double *high)
{
    (void)self;
    (void)w;
    (void)shape;
    (void)axis;
    *low = -INFINITY;
    *high = INFINITY;
}

static void box_of_box(const clod_wall_rows *self, int32_t w, int32_t shape, int axis,
                       double *low, double *high)
{
    const shape_rows row = rows_of(self, w, shape);
    const double half = fabs(row[1][axis]) * row[1][3] + fabs(row[2][axis]) * row[2][3] +
                        fabs(row[3][axis]) * row[3][3];
    *low = row[0][axis] - half;
    *high = row[0][axis] + half;
}

/** Between the circles at both ends. */
static void box_of_shell(const clod_wall_rows *self, int32_t w, int32_t shape, int axis,
                         double *low, double *high)
{
    const shape_rows row = rows_of(self, w, shape);
    const double across = sqrt(fmax(1.0 - row[2][axis] * row[2][axis], 0.0));
    const double rise = row[2][axis] * row[3][2] * row[3][3];
    const double foot = across * row[3][0];
    const double top = across * fabs(row[3][0] + row[3][1] * row[3][3]);
    *low = row[0][axis] - fmax(foot, top - rise);
    *high = row[0][axis] + fmax(foot, top + rise);
}

/** That of the box about the patch in its frame. */
static void box_of_patch(const clod_wall_rows *self, int32_t w, int32_t shape, int axis,
                         double *low, double *high)
{
    const clod_wall_patch *at = clod_wall_rows_patch(self, w, shape);
    const clod_surface_patch *patch = &at->surface->patches[at->patch];
    const clod_wall_pose pose = clod_wall_facets_pose(rows_of(self, w, shape));
    double middle[3], half = 0.0;
    for (int b = 0; b < 3; b++) {
        middle[b] = 0.5 * (patch->low[b] + patch->high[b]);
        half += fabs(pose.rotation[axis][b]) * 0.5 * (patch->high[b] - patch->low[b]);
    }
    double centre[3];
    clod_vec3_put(centre, clod_wall_point_to_space(&pose, clod_vec3_of(middle)));
    *low = centre[axis] - half;
    *high = centre[axis] + half;
}

static double gap_of(const clod_wall_rows *self, int32_t w, int32_t shape, const double p[3])
{
    return clod_wall_gap_rows(rows_of(self, w, shape), clod_vec3_of(p)).distance;
}

static bool gap_is_near(const clod_wall_rows *self, int32_t w, int32_t shape, const double p[3],
                        double reach)
{
    return gap_of(self, w, shape, p) < reach;
}

/** First whether the point is outside the sphere about the box, made larger by `reach`. */
static bool box_is_near(const clod_wall_rows *self, int32_t w, int32_t shape, const double p[3],
                        double reach)
{
    const shape_rows row = rows_of(self, w, shape);
    double apart2 = 0.0;
    double half2 = 0.0;
    for (int a = 0; a < 3; a++) {
        apart2 += (p[a] - row[0][a]) * (p[a] - row[0][a]);
        half2 += row[1 + a][3] * row[1 + a][3];
    }
    const double most = sqrt(half2) + reach;
    return !(apart2 > most * most) && gap_is_near(self, w, shape, p, reach);
}

/** A point in the frame of a patch. */
static clod_vec3 to_frame(const clod_wall_rows *self, int32_t w, int32_t shape,
                          const double p[3])
{
    const clod_wall_pose pose = clod_wall_facets_pose(rows_of(self, w, shape));
    return clod_wall_to_frame(&pose, clod_vec3_of(p));
}

static bool patch_is_near(const clod_wall_rows *self, int32_t w, int32_t shape,
                          const double p[3], double reach)
{
    const clod_wall_patch *at = clod_wall_rows_patch(self, w, shape);
    const clod_vec3 q = to_frame(self, w, shape, p);
    return at->slot == 0
               ? clod_surface_patch_is_near(at->surface, (uint32_t)at->patch, q, reach)
               : clod_surface_rim_is_near(at->surface, (uint32_t)at->patch, q, reach);
}

static double patch_apart(const clod_wall_rows *self, int32_t w, int32_t shape,
                          const double p[3])
{
    const clod_wall_patch *at = clod_wall_rows_patch(self, w, shape);
    return clod_surface_patch_box(at->surface, (uint32_t)at->patch,
                                  to_frame(self, w, shape, p));
}

typedef struct form_row {
    /** Whether a point is nearer than `reach`. */
    bool (*is_near)(const clod_wall_rows *self, int32_t w, int32_t shape, const double p[3],
                    double reach);
    /** Distance of a point, of a patch from the box about it [m]. */
    double (*apart)(const clod_wall_rows *self, int32_t w, int32_t shape, const double p[3]);
    /** Extent along an axis of space [m]. */
    void (*box)(const clod_wall_rows *self, int32_t w, int32_t shape, int axis, double *low,
                double *high);
} form_row;

static const form_row FORMS[CLOD_FORMS] = {
    [CLOD_FORM_PLANE] = {gap_is_near, gap_of, box_of_plane},
    [CLOD_FORM_BOX] = {box_is_near, gap_of, box_of_box},
    [CLOD_FORM_SHELL] = {gap_is_near, gap_of, box_of_shell},
    [CLOD_FORM_MESH] = {patch_is_near, patch_apart, box_of_patch},
};

static const form_row *form_row_of(const clod_wall_rows *self, int32_t w, int32_t shape)
{
    return &FORMS[clod_wall_form_of(rows_of(self, w, shape)[0][3])];
}

bool clod_wall_rows_is_near(const clod_wall_rows *self, int32_t w, int32_t shape,
                            const double p[3], double reach)
{
    return form_row_of(self, w, shape)->is_near(self, w, shape, p, reach);
}

bool clod_wall_rows_may_reach(const clod_wall_rows *self, int32_t w, int32_t shape,
                              const double p[3], double half, double reach)
{
    return form_row_of(self, w, shape)->apart(self, w, shape, p) < half + reach;
}

void clod_wall_rows_box(const clod_wall_rows *self, int32_t w, int32_t shape, double low[3],
                        double high[3])
{
    const form_row *form = form_row_of(self, w, shape);
    for (int a = 0; a < 3; a++) {
        form->box(self, w, shape, a, &low[a], &high[a]);
    }
}

void clod_wall_rows_fini(clod_wall_rows *self)
{
    clod_memory_free(self->shape);
    clod_memory_free(self->patch);
    clod_memory_free(self->first_shape);
    clod_memory_free(self->pose);
    clod_memory_free(self->motion);
    clod_memory_free(self->reach);
    *self = (clod_wall_rows){0};
}
