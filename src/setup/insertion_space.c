#include "setup/insertion_space.h"

#include <math.h>

#include "base/memory.h"
#include "base/room.h"
#include "config/region.h"
#include "geometry/wall_pose.h"

/** Of a place that was turned into a face, as a fraction of its extent. */
#define ROUNDING 1e-12

// ---- what differs between kinds of regions: one row each

typedef struct space_row {
    bool repeats; ///< goes through the sides of a period that it fills
    /** Whether a sphere is in the region; in a direction that is all of a period it always is;
     *  of a face: whether it comes whole through. */
    bool (*inside)(const clod_insertion_space *self, const double place[4]);
    /** A position in it between two heights, before a face at any; false: the sphere is too
     *  large for it. */
    bool (*draw)(const clod_insertion_space *self, double place[4], const double range[2],
                 const double u[3]);
} space_row;

static bool inside_box(const clod_insertion_space *self, const double place[4])
{
    const double r = place[3];
    for (int a = 0; a < 3; a++) {
        if (!self->through[a] &&
            (place[a] - r < self->low[a] || place[a] + r > self->high[a])) {
            return false;
        }
    }
    return true;
}

static bool inside_annulus(const clod_insertion_space *self, const double place[4])
{
    if (!inside_box(self, place)) {
        return false;
    }
    const double r = place[3];
    const double rho =
        hypot(place[0] - self->region->center[0], place[1] - self->region->center[1]);
    const double inner = self->region->inner_radius;
    return rho + r <= self->region->outer_radius && (inner == 0.0 || rho - r >= inner);
}

/** Coordinates of a place along the axes of a face. */
static void in_face(const clod_insertion_space *self, const double place[4], double in[3])
{
    for (int a = 0; a < 3; a++) {
        in[a] = 0.0;
        for (int k = 0; k < 3; k++) {
            in[a] += (place[k] - self->region->center[k]) * self->axis[a][k];
        }
    }
}

static bool inside_disc(const clod_insertion_space *self, const double place[4])
{
    double in[3];
    in_face(self, place, in);
    return hypot(in[0], in[1]) + place[3] <= self->half[0] * (1.0 + ROUNDING);
}

static bool inside_rectangle(const clod_insertion_space *self, const double place[4])
{
    double in[3];
    in_face(self, place, in);
    return fabs(in[0]) + place[3] <= self->half[0] * (1.0 + ROUNDING) &&
           fabs(in[1]) + place[3] <= self->half[1] * (1.0 + ROUNDING);
}

/** Uniform between two ends; false when they are in the wrong order. */
static bool draw_between(double from, double to, double u, double *x)
{
    *x = from + u * (to - from);
    return from <= to;
}

static bool draw_height(const clod_insertion_space *self, double place[4],
                        const double range[2], const double u[3])
{
    const double r = self->through[2] ? 0.0 : place[3];
    return draw_between(range[0] + r, range[1] - r, u[2], &place[2]);
}

static bool draw_box(const clod_insertion_space *self, double place[4], const double range[2],
                     const double u[3])
{
    const double x = self->through[0] ? 0.0 : place[3];
    const double y = self->through[1] ? 0.0 : place[3];
    return draw_height(self, place, range, u) &&
           draw_between(self->low[0] + x, self->high[0] - x, u[0], &place[0]) &&
           draw_between(self->low[1] + y, self->high[1] - y, u[1], &place[1]);
}

static bool draw_annulus(const clod_insertion_space *self, double place[4],
                         const double range[2], const double u[3])
{
    const double r = place[3];
    const double outer = self->region->outer_radius - r;
    const double inner =
        self->region->inner_radius > 0.0 ? self->region->inner_radius + r : 0.0;
    double square = 0.0; // the square of the distance from the axis is uniform
    if (!draw_height(self, place, range, u) || outer < 0.0 ||
        !draw_between(inner * inner, outer * outer, u[0], &square)) {
        return false;
    }
    const double angle = 2.0 * M_PI * u[1];
    place[0] = self->region->center[0] + sqrt(square) * cos(angle);
    place[1] = self->region->center[1] + sqrt(square) * sin(angle);
    return true;
}

/** A position before a face from where it is in it; whether the sphere fits through. */
static bool put_before(const clod_insertion_space *self, double place[4], double x, double y,
                       double u)
{
    const double r = place[3];
    const double in[3] = {x, y, r + u * self->region->depth}; // along the axes
    for (int k = 0; k < 3; k++) {
        place[k] = self->region->center[k];
        for (int a = 0; a < 3; a++) {
            place[k] += in[a] * self->axis[a][k];
        }
    }
    return self->half[0] >= r && self->half[1] >= r;
}

static bool draw_disc(const clod_insertion_space *self, double place[4], const double range[2],
                      const double u[3])
{
    (void)range;
    const double rho = (self->half[0] - place[3]) * sqrt(u[0]), angle = 2.0 * M_PI * u[1];
    return put_before(self, place, rho * cos(angle), rho * sin(angle), u[2]);
}

static bool draw_rectangle(const clod_insertion_space *self, double place[4],
                           const double range[2], const double u[3])
{
    (void)range;
    const double x = (2.0 * u[0] - 1.0) * (self->half[0] - place[3]);
    const double y = (2.0 * u[1] - 1.0) * (self->half[1] - place[3]);
    return put_before(self, place, x, y, u[2]);
}

static const space_row SPACES[] = {
    [CLOD_REGION_BOX] = {.repeats = true, .inside = inside_box, .draw = draw_box},
    [CLOD_REGION_ANNULUS] = {.inside = inside_annulus, .draw = draw_annulus},
    [CLOD_REGION_DISC] = {.inside = inside_disc, .draw = draw_disc},
    [CLOD_REGION_RECTANGLE] = {.inside = inside_rectangle, .draw = draw_rectangle},
};

static const space_row *space_row_of(const clod_insertion_space *self)
{
    return &SPACES[self->region->kind];
}

/** Whole grains before a face, the largest of this radius. */
static void set_face(clod_insertion_space *self, double largest)
{
    clod_region_axes(self->region, self->axis);
    clod_region_half(self->region, self->half);
    for (int a = 0; a < 3; a++) {
        self->low[a] -= 2.0 * largest;
        self->high[a] += 2.0 * largest;
    }
}

static void set_bounds(clod_insertion_space *self, double top, double largest)
{
    const clod_case_region *region = self->region;
    const bool repeats = space_row_of(self)->repeats;
    clod_region_bounds(region, self->low, self->high);
    for (int a = 0; a < 3; a++) {
        const clod_domain *domain = &self->state->domain;
        const double period = domain->max[a] - domain->min[a];
        self->through[a] = repeats && domain->periodic[a] &&
                           self->high[a] - self->low[a] >= period * (1.0 - 1e-12);
    }
    self->high[2] = top;
    self->face = clod_region_is_face(region);
    if (self->face) {
        set_face(self, largest);
    }
}

/** Whether a grain is between two heights, or an image of it is, and may be in the way there. */
static bool is_in_height(const clod_insertion_space *self, const double range[2],
                         const double place[4])
{
    const double half = 0.5 * (range[1] - range[0]);
    const double off =
        clod_domain_separation(&self->state->domain, 2, place[2], range[0] + half);
    return fabs(off) <= half + self->largest + place[3];
}

/** Rows of the state that were there before, between two heights. */
static bool collect_rows(clod_insertion_space *self, const double range[2], clod_status *status)
{
    self->rows = 0;
    for (size_t g = 0; g < self->before; g++) {
        if (!is_in_height(self, range, self->state->grains.position[g])) {
            continue;
        }
        if (!clod_room_for_one(&self->row, &self->row_capacity, self->rows,
                               sizeof *self->row)) {
            return clod_status_fail(status, CLOD_FAILED, "no memory to insert grains");
        }
        self->row[self->rows++] = g;
    }
    return true;
}

bool clod_insertion_space_block(clod_insertion_space *self, double bottom, double top,
                                clod_status *status)
{
    clod_domain_box box = {{self->low[0], self->low[1], bottom},
                           {self->high[0], self->high[1], top}};
    for (int a = 0; a < 3; a++) {
        box.low[a] -= self->largest;
        box.high[a] += self->largest;
    }
    return collect_rows(self, (const double[2]){bottom, top}, status) &&
           (self->pieces == NULL ||
            clod_setup_pieces_near(self->pieces, &box, &self->others, status));
}

/** Note the grains that were there before between two heights; or with `note` false, count them. */
static bool note_grains(clod_insertion_space *self, const double range[2], bool note,
                        size_t *count, clod_status *status)
{
    const size_t all = self->rows + self->others.count;
    bool good = true;
    *count = 0;
    for (size_t k = 0; good && k < all; k++) {
        const double *place = k < self->rows ? self->state->grains.position[self->row[k]]
                                             : self->others.place[k - self->rows];
        const bool near = is_in_height(self, range, place);
        *count += near;
        good = !near || !note || clod_sphere_grid_add(&self->grid, place, status);
    }
    return good;
}

bool clod_insertion_space_open(clod_insertion_space *self, const clod_case_region *region,
                               double top, const clod_state *state, double largest,
                               clod_status *status)
{
    *self = (clod_insertion_space){
        .region = region, .state = state, .largest = largest, .before = state->grains.count};
    set_bounds(self, top, largest);
    return clod_wall_rows_init(&self->walls, &state->walls) ||
           clod_status_fail(status, CLOD_FAILED, "no memory to insert grains");
}

bool clod_insertion_space_band(clod_insertion_space *self, double bottom, double top,
                               size_t grains, clod_status *status)
{
    const clod_domain *domain = &self->state->domain;
    const double low[3] = {self->low[0], self->low[1], bottom};
    const double high[3] = {self->high[0], self->high[1], top};
    double period[3] = {0.0, 0.0, 0.0};
    for (int a = 0; a < 3; a++) {
        if (domain->periodic[a]) {
            period[a] = domain->max[a] - domain->min[a];
        }
    }
    const double range[2] = {bottom, top};
    size_t before;
    return note_grains(self, range, false, &before, status) &&
           clod_sphere_grid_begin(&self->grid, low, high, period, self->largest,
                                  grains + before, status) &&
           note_grains(self, range, true, &before, status);
}

bool clod_insertion_space_init(clod_insertion_space *self, const clod_case_region *region,
                               double top, const clod_state *state, double largest,
                               size_t grains, clod_status *status)
{
    return clod_insertion_space_open(self, region, top, state, largest, status) &&
           clod_insertion_space_block(self, self->low[2], self->high[2], status) &&
           clod_insertion_space_band(self, self->low[2], self->high[2], grains, status);
}

double clod_insertion_space_volume(const clod_insertion_space *self)
{
    const double height = self->face ? self->region->depth : self->high[2] - self->low[2];
    return clod_region_area(self->region) * height;
}

/** Whether a point beside a shell is on the side where the grains belong. */
static bool right_side(const clod_wall *wall, const clod_shape *shape, const double place[4])
{
    if (!clod_shape_kinds_row(shape->kind)->shell) {
        return true;
    }
    const clod_wall_pose pose = clod_wall_pose_now(wall);
    const clod_vec3 p = clod_wall_to_frame(&pose, clod_vec3_of(place));
    const clod_vec3 r = clod_vec3_sub(p, shape->center);
    const double height = clod_vec3_dot(r, shape->axis[2]);
    const double rho = clod_vec3_length(clod_vec3_axpy(r, -height, shape->axis[2]));
    const double length = 2.0 * shape->half[2];
    const double widening = clod_shape_end_radius(shape) - shape->outer;
    const double radius = shape->outer + widening * (height / length);
    const bool beside = height >= 0.0 && height <= length;
    return !beside || (rho < radius) == (shape->side == CLOD_SIDE_INSIDE);
}

/** Whether a grain would overlap a shape; of a mesh all at once, with its first shape. */
static bool overlaps(const clod_insertion_space *self, int32_t w, int32_t s,
                     const double place[4])
{
    const clod_shape *shape = &self->state->walls.wall[w].shapes[s];
    if (shape->surface == NULL) {
        return clod_wall_rows_is_near(&self->walls, w, s, place, place[3]);
    }
    if (shape->patch > 0 || shape->slot > 0) {
        return false;
    }
    const clod_wall_pose pose = clod_wall_pose_now(&self->state->walls.wall[w]);
    return clod_surface_is_near(shape->surface, clod_wall_to_frame(&pose, clod_vec3_of(place)),
                                place[3]);
}

static bool clear_of_walls(const clod_insertion_space *self, const double place[4])
{
    for (int32_t w = 0; w < self->state->walls.count; w++) {
        const clod_wall *wall = &self->state->walls.wall[w];
        for (int32_t s = 0; s < wall->shape_count; s++) {
            if (overlaps(self, w, s, place) || !right_side(wall, &wall->shapes[s], place)) {
                return false;
            }
        }
    }
    return true;
}

bool clod_insertion_space_clear(const clod_insertion_space *self, const double place[4])
{
    return space_row_of(self)->inside(self, place) &&
           clod_sphere_grid_clear(&self->grid, place) && clear_of_walls(self, place);
}

bool clod_insertion_space_open_at(const clod_insertion_space *self, const double place[4])
{
    return space_row_of(self)->inside(self, place) && clear_of_walls(self, place);
}

bool clod_insertion_space_take(clod_insertion_space *self, const double place[4],
                               clod_status *status)
{
    return clod_sphere_grid_add(&self->grid, place, status);
}

bool clod_insertion_space_draw(const clod_insertion_space *self, double place[4], double bottom,
                               double top, const double u[3])
{
    return space_row_of(self)->draw(self, place, (const double[2]){bottom, top}, u);
}

void clod_insertion_space_fini(clod_insertion_space *self)
{
    clod_wall_rows_fini(&self->walls);
    clod_sphere_grid_fini(&self->grid);
    clod_memory_free(self->row);
    *self = (clod_insertion_space){0};
}
