#include "setup/flush_walls.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "config/source.h"
#include "geometry/wall_pose.h"
#include "mesh/surface_flush.h"
#include "mesh/surface_touch.h"

#define STEPS 5000000 ///< of the search in two bodies, ...
#define STEPS_EACH 60 ///< ... and for each facet; then it ends
#define TOLD 6        ///< pairs of walls; of the others only the number
#define MESHES 64     ///< of a wall that are searched together

/** A mesh beside another body of a wall at rest beside it. */
typedef struct pair {
    const clod_wall *wall, *other;
    clod_wall_pose pose, beside; ///< of both
    clod_surface_flush search;
    size_t found; ///< facets of `wall` that are flush
    clod_vec3 at; ///< m, middle of the first one
    bool ended;   ///< before all was searched
} pair;

typedef struct doubts {
    const clod_case *from;
    double crack; ///< m
    clod_setup_flush_tell tell;
    void *context;
    size_t pairs; ///< found so far
} doubts;

static bool is_same(clod_vec3 a, clod_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

/** Whether a stage gives a wall another motion. */
static bool is_changed(const clod_case *from, const clod_wall *wall)
{
    bool changed = false;
    for (size_t s = 0; s < from->stage_count; s++) {
        for (size_t w = 0; w < from->stages[s].wall_count; w++) {
            const clod_case_wall_change *change = &from->stages[s].walls[w];
            changed = changed || ((change->has_velocity || change->has_spin) &&
                                  strcmp(change->name, wall->name) == 0);
        }
    }
    return changed;
}

/** Whether two walls never move beside each other. */
static bool move_as_one(const clod_case *from, const clod_wall *a, const clod_wall *b)
{
    const clod_oscillation *p = &a->oscillation, *q = &b->oscillation;
    const bool turns = a->spin != 0.0 || p->angle != 0.0;
    return a->load == CLOD_LOAD_NONE && b->load == CLOD_LOAD_NONE && !is_changed(from, a) &&
           !is_changed(from, b) && is_same(a->velocity, b->velocity) && a->spin == b->spin &&
           p->frequency == q->frequency && p->amplitude == q->amplitude &&
           p->angle == q->angle && p->phase == q->phase &&
           is_same(p->direction, q->direction) &&
           (!turns ||
            (is_same(a->spin_axis, b->spin_axis) && is_same(a->spin_point, b->spin_point)));
}

static clod_vec3 to_beside(const pair *self, clod_vec3 p)
{
    return clod_wall_to_frame(&self->beside, clod_wall_point_to_space(&self->pose, p));
}

/** A facet of the wall in the frame of the other body. */
static clod_surface_triangle facet_beside(const pair *self, const clod_surface *surface,
                                          uint32_t facet)
{
    clod_surface_triangle made = clod_surface_triangle_of(surface, facet);
    for (int c = 0; c < 3; c++) {
        made.corner[c] = to_beside(self, made.corner[c]);
    }
    return made;
}

static void count_facet(pair *self, const clod_surface_triangle *facet)
{
    if (self->found++ == 0) {
        const clod_vec3 sum =
            clod_vec3_add(clod_vec3_add(facet->corner[0], facet->corner[1]), facet->corner[2]);
        self->at = clod_wall_point_to_space(&self->beside, clod_vec3_scale(sum, 1.0 / 3.0));
    }
}

/** Facets of a mesh that are flush with those of others. */
static void search_meshes(pair *self, const clod_surface *own, const clod_surface **others,
                          size_t count)
{
    self->search.left = STEPS + STEPS_EACH * (uint64_t)own->facet_count;
    for (uint32_t f = 0; f < own->facet_count && self->search.left > 0; f++) {
        const clod_surface_triangle facet = facet_beside(self, own, f);
        bool flush = false;
        for (size_t k = 0; k < count && !flush; k++) {
            flush = clod_surface_flush_has(others[k], &facet, &self->search);
        }
        if (flush) {
            count_facet(self, &facet);
        }
    }
    self->ended = self->ended || self->search.left == 0;
}

/** Whether a facet lies in an endless plane, and is not the back of a body that stands on it. */
static bool lies_on_plane(const clod_surface_triangle *facet, const clod_shape *plane,
                          double crack)
{
    const clod_vec3 normal = plane->axis[2];
    const clod_vec3 own = clod_vec3_cross(clod_vec3_sub(facet->corner[1], facet->corner[0]),
                                          clod_vec3_sub(facet->corner[2], facet->corner[0]));
    const double dot = clod_vec3_dot(own, normal);
    bool in = (facet->sheet || dot > 0.0) &&
              fabs(dot) > CLOD_SURFACE_FLUSH_COSINE * clod_vec3_length(own);
    for (int c = 0; c < 3; c++) {
        const clod_vec3 arm = clod_vec3_sub(facet->corner[c], plane->center);
        in = in && fabs(clod_vec3_dot(arm, normal)) <= crack;
    }
    return in;
}

/** Half of a face of a box, outwards. */
static clod_surface_triangle half_face(const clod_shape *box, int face, int half)
{
    static const double SIDE[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    const int a = face / 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const double out = face % 2 == 0 ? 1.0 : -1.0;
    clod_surface_triangle made = {.sheet = false};
    for (int k = 0; k < 3; k++) {
        const double *side = SIDE[k == 0 ? 0 : k + half];
        clod_vec3 p = clod_vec3_axpy(box->center, out * box->half[a], box->axis[a]);
        p = clod_vec3_axpy(p, out * side[0] * box->half[b], box->axis[b]);
        made.corner[k] = clod_vec3_axpy(p, side[1] * box->half[c], box->axis[c]);
    }
    return made;
}

/** Whether a facet lies beyond a face of a box. */
static bool is_beside(const clod_surface_triangle *facet, const clod_shape *box, double crack)
{
    bool beside = false;
    for (int a = 0; a < 3; a++) {
        double low = INFINITY, high = -INFINITY;
        for (int c = 0; c < 3; c++) {
            const clod_vec3 arm = clod_vec3_sub(facet->corner[c], box->center);
            const double along = clod_vec3_dot(arm, box->axis[a]);
            low = fmin(low, along);
            high = fmax(high, along);
        }
        beside = beside || low > box->half[a] + crack || high < -box->half[a] - crack;
    }
    return beside;
}

static bool lies_on_box(const clod_surface_triangle *facet, const clod_shape *box, double crack)
{
    bool in = false;
    for (int k = is_beside(facet, box, crack) ? 12 : 0; k < 12 && !in; k++) {
        const clod_surface_triangle face = half_face(box, k / 2, k % 2);
        in = clod_surface_flush_are(&face, facet, crack);
    }
    return in;
}

/** Facets of a mesh that lie on a plane or a box. */
static void search_shape(pair *self, const clod_surface *own, const clod_shape *shape)
{
    const bool endless = clod_shape_kinds_row(shape->kind)->endless;
    for (uint32_t f = 0; f < own->facet_count; f++) {
        const clod_surface_triangle facet = facet_beside(self, own, f);
        if (endless ? lies_on_plane(&facet, shape, self->search.crack)
                    : lies_on_box(&facet, shape, self->search.crack)) {
            count_facet(self, &facet);
        }
    }
}

/** The mesh that begins with a shape, or NULL; an outlet's surface takes away what touches it. */
static const clod_surface *mesh_of(const clod_shape *shape)
{
    return clod_shape_begins_mesh(shape) && shape->outlet == 0 ? shape->surface : NULL;
}

/** Meshes of a wall from a shape on, as many as there is room for; the shape behind them. */
static int32_t list_meshes(const clod_wall *wall, int32_t from, const clod_surface *to[MESHES],
                           size_t *count)
{
    *count = 0;
    for (; from < wall->shape_count && *count < MESHES; from++) {
        const clod_surface *mesh = mesh_of(&wall->shapes[from]);
        if (mesh != NULL) {
            to[(*count)++] = mesh;
        }
    }
    return from;
}

static void tell_pair(doubts *self, const pair *of, const char *what, const char *remedy)
{
    char text[CLOD_SETUP_FLUSH_TEXT], key[64], where[CLOD_SOURCE_WHERE];
    if (of->found == 0 || self->pairs++ >= TOLD) {
        return;
    }
    snprintf(key, sizeof key, "walls.%s", of->wall->name);
    snprintf(text, sizeof text,
             "%s%s: %zu%s of its facets lie%s in one plane with %s, over or right beside "
             "it, the first at (%.4g, %.4g, %.4g) mm: a grain there is pushed by both, so "
             "twice. %s",
             clod_source_where(self->from, key, where), key, of->found,
             of->ended ? " or more" : "", of->found == 1 ? "s" : "", what, 1e3 * of->at.x,
             1e3 * of->at.y, 1e3 * of->at.z, remedy);
    self->tell(self->context, text);
}

/** All meshes of a wall beside those of another one. */
static void compare_meshes(doubts *self, pair *of)
{
    const clod_surface *others[MESHES];
    size_t count;
    for (int32_t from = 0; from < of->other->shape_count;) {
        from = list_meshes(of->other, from, others, &count);
        for (int32_t s = 0; count > 0 && s < of->wall->shape_count; s++) {
            const clod_surface *own = mesh_of(&of->wall->shapes[s]);
            if (own != NULL) {
                search_meshes(of, own, others, count);
            }
        }
    }
    char what[64];
    snprintf(what, sizeof what, "facets of walls.%s", of->other->name);
    tell_pair(self, of, what, "Make them shapes of one wall, which push once");
}

/** All meshes of a wall beside the planes and boxes of a wall, its own too. */
static void compare_shapes(doubts *self, const pair *walls)
{
    int number = 0; // of the shape in the case, where a mesh is one
    for (int32_t k = 0; k < walls->other->shape_count; k++) {
        const clod_shape *shape = &walls->other->shapes[k];
        const clod_shape_kind_row *kind = clod_shape_kinds_row(shape->kind);
        pair one = *walls;
        for (int32_t s = 0; s < one.wall->shape_count && (kind->endless || kind->solid); s++) {
            const clod_surface *own = mesh_of(&one.wall->shapes[s]);
            if (own != NULL && shape->outlet == 0) {
                search_shape(&one, own, shape);
            }
        }
        char what[80];
        snprintf(what, sizeof what, "walls.%s.shapes.%d", one.other->name, number);
        tell_pair(self, &one, what,
                  kind->endless ? "Leave the plane or these facets out"
                                : "Leave the box or these facets out, or give the box as a "
                                  "mesh in the same wall");
        number += shape->surface == NULL || clod_shape_begins_mesh(shape);
    }
}

/** Radius of the smallest grain of the groups that are no files [m]; 0: there is none. */
static double smallest(const clod_case *from)
{
    double least = INFINITY;
    for (size_t k = 0; k < from->grains_count; k++) {
        const clod_case_grains *group = &from->grains[k];
        if (group->file == NULL) {
            least = fmin(least, group->sieve_count > 0 ? 0.5 * group->sieve[0].size
                                                       : group->radius_min);
        }
    }
    return isfinite(least) ? least : 0.0;
}

void clod_setup_flush_doubts(const clod_case *from, const clod_walls *walls, double radius,
                             clod_setup_flush_tell tell, void *context)
{
    doubts all = {.from = from,
                  .crack = CLOD_SURFACE_CRACK * (radius > 0.0 ? radius : smallest(from)),
                  .tell = tell,
                  .context = context};
    for (int32_t a = 0; a < walls->count; a++) {
        for (int32_t b = 0; b < walls->count; b++) {
            pair one = {.wall = &walls->wall[a], .other = &walls->wall[b]};
            one.search.crack = all.crack;
            if (a != b && !move_as_one(from, one.wall, one.other)) {
                continue;
            }
            one.pose = clod_wall_pose_now(one.wall);
            one.beside = clod_wall_pose_now(one.other);
            compare_shapes(&all, &one);
            if (b < a) {
                compare_meshes(&all, &one);
            }
        }
    }
    if (all.pairs > TOLD) {
        char text[CLOD_SETUP_FLUSH_TEXT];
        snprintf(text, sizeof text, "walls: %zu more pairs have facets in one plane likewise",
                 all.pairs - TOLD);
        tell(context, text);
    }
}
