#include "picture/cutaway.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/sort.h"

#define SAMPLE 800   ///< grains at most that are looked for
#define WORK 4.0e7   ///< triangles times grains at most
#define HIDDEN 0.015 ///< share of the grains that a piece of a face may hide
#define CORNERS 10   ///< of a triangle that was cut by six planes, with room

void clod_cutaway_include(clod_cutaway_box *box, const double point[3])
{
    for (int d = 0; d < 3; d++) {
        box->min[d] = fmin(box->min[d], point[d]);
        box->max[d] = fmax(box->max[d], point[d]);
    }
}

/** Cut a polygon by one side of the box: what is beyond goes. */
static size_t cut(double (*polygon)[3], size_t count, int d, double sign, double bound)
{
    double kept[CORNERS][3];
    size_t n = 0;
    for (size_t k = 0; k < count; k++) {
        const double *a = polygon[k];
        const double *b = polygon[(k + 1) % count];
        const double beyond_a = sign * (a[d] - bound);
        const double beyond_b = sign * (b[d] - bound);
        if (beyond_a <= 0.0 && n < CORNERS) {
            memcpy(kept[n++], a, sizeof kept[0]);
        }
        if ((beyond_a > 0.0) != (beyond_b > 0.0) && n < CORNERS) {
            const double part = beyond_a / (beyond_a - beyond_b);
            for (int i = 0; i < 3; i++) {
                kept[n][i] = a[i] + part * (b[i] - a[i]);
            }
            n++;
        }
    }
    memcpy(polygon, kept, n * sizeof kept[0]);
    return n;
}

size_t clod_cutaway_clip(const clod_cutaway_box *box, double (*const corner)[3][3],
                         double piece[CLOD_CUTAWAY_PIECES][3][3])
{
    double polygon[CORNERS][3];
    size_t count = 4;
    memcpy(polygon, corner[0], 3 * sizeof polygon[0]);
    memcpy(polygon[3], corner[1][2], sizeof polygon[3]);
    for (int d = 0; d < 3; d++) {
        count = cut(polygon, count, d, 1.0, box->max[d]);
        count = cut(polygon, count, d, -1.0, box->min[d]);
    }
    size_t pieces = 0;
    for (size_t k = 2; k < count; k++) {
        memcpy(piece[pieces][0], polygon[0], sizeof polygon[0]);
        memcpy(piece[pieces][1], polygon[k - 1], sizeof polygon[0]);
        memcpy(piece[pieces++][2], polygon[k], sizeof polygon[0]);
    }
    return pieces;
}

/** Whether the line from a grain to the eye goes through a triangle (Moeller and Trumbore 1997).
 */
static bool crosses(double (*const corner)[3], clod_vec3 from, clod_vec3 way)
{
    const clod_vec3 a = clod_vec3_of(corner[0]);
    const clod_vec3 ab = clod_vec3_sub(clod_vec3_of(corner[1]), a);
    const clod_vec3 ac = clod_vec3_sub(clod_vec3_of(corner[2]), a);
    const clod_vec3 p = clod_vec3_cross(way, ac);
    const double det = clod_vec3_dot(ab, p);
    if (det == 0.0) {
        return false;
    }
    const clod_vec3 s = clod_vec3_sub(from, a);
    const clod_vec3 q = clod_vec3_cross(s, ab);
    const double u = clod_vec3_dot(s, p) / det;
    const double v = clod_vec3_dot(way, q) / det;
    const double t = clod_vec3_dot(ac, q) / det;
    return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t < 1.0;
}

/** The triangles of one part on one side of a face: curved faces have a near side and a far one. */
typedef struct piece {
    uint64_t side;        ///< face and side as one number
    uint32_t hidden;      ///< sampled grains behind it
    uint32_t last;        ///< number of the grain that was counted last
    uint32_t hidden_side; ///< grains behind pieces of the side that hide few each
} piece;

/** What is needed on the way; all owned. */
typedef struct work {
    size_t pieces;
    piece *piece;                   ///< [pieces] those of a side one behind the other
    size_t *of;                     ///< [triangles] number of its piece
    clod_sort_item *item, *scratch; ///< [triangles]
} work;

static void free_work(work *self)
{
    clod_memory_free(self->piece);
    clod_memory_free(self->of);
    clod_memory_free(self->item);
    clod_memory_free(self->scratch);
}

static bool take_work(work *self, size_t triangles)
{
    *self = (work){0, clod_memory_alloc(triangles + 1, sizeof *self->piece),
                   clod_memory_alloc(triangles + 1, sizeof *self->of),
                   clod_memory_alloc(triangles + 1, sizeof *self->item),
                   clod_memory_alloc(triangles + 1, sizeof *self->scratch)};
    return self->piece != NULL && self->of != NULL && self->item != NULL &&
           self->scratch != NULL;
}

/** Face and side of a triangle as one number. */
static uint64_t side_of(const clod_scene *scene, const clod_faces *faces, size_t t,
                        clod_vec3 eye)
{
    const clod_vec3 a = clod_vec3_of(scene->corner[t][0]);
    const clod_vec3 n = clod_vec3_cross(clod_vec3_sub(clod_vec3_of(scene->corner[t][1]), a),
                                        clod_vec3_sub(clod_vec3_of(scene->corner[t][2]), a));
    const bool front = clod_vec3_dot(n, clod_vec3_sub(eye, a)) > 0.0;
    return 2 * (uint64_t)faces->face[t] + (front != (faces->turned[t] != 0));
}

/** Find the pieces. */
static void find_pieces(work *self, const clod_scene *scene, const clod_faces *faces,
                        clod_vec3 eye)
{
    const size_t n = scene->triangles;
    uint64_t parts = 1; // and those without a name
    for (size_t t = 0; t < n; t++) {
        const uint64_t number = (uint64_t)((int64_t)scene->part[t] + 1);
        parts = number >= parts ? number + 1 : parts;
    }
    for (size_t t = 0; t < n; t++) {
        const uint64_t part = (uint64_t)((int64_t)scene->part[t] + 1);
        self->item[t] = (clod_sort_item){side_of(scene, faces, t, eye) * parts + part, t};
    }
    clod_sort(self->item, self->scratch, n);
    for (size_t k = 0; k < n; k++) {
        if (k == 0 || self->item[k].key != self->item[k - 1].key) {
            self->piece[self->pieces++].side = self->item[k].key / parts;
        }
        self->of[self->item[k].index] = self->pieces - 1;
    }
}

/** Count for each piece the sampled grains that it hides. */
static void count_hidden(const clod_scene *scene, clod_vec3 eye, size_t every, work *with)
{
    uint32_t grain = 0;
    for (size_t k = 0; k < scene->spheres; k += every) {
        const clod_vec3 from = clod_vec3_of(scene->center[k]);
        const clod_vec3 way = clod_vec3_sub(eye, from);
        grain++;
        for (size_t t = 0; t < scene->triangles; t++) {
            piece *of = &with->piece[with->of[t]];
            if (of->last != grain && crosses(scene->corner[t], from, way)) {
                of->hidden++;
                of->last = grain;
            }
        }
    }
}

/** Add up, over the pieces of a side, the grains behind those that hide no more than `few`. */
static void add_sides(work *self, double few)
{
    for (size_t first = 0, end; first < self->pieces; first = end) {
        uint32_t sum = 0;
        for (end = first;
             end < self->pieces && self->piece[end].side == self->piece[first].side; end++) {
            sum += self->piece[end].hidden <= few ? self->piece[end].hidden : 0;
        }
        for (size_t k = first; k < end; k++) {
            self->piece[k].hidden_side = sum;
        }
    }
}

bool clod_cutaway_veil(clod_scene *scene, const clod_faces *faces, clod_vec3 eye,
                       clod_status *status)
{
    const size_t n = scene->triangles;
    work with;
    const bool good = take_work(&with, n);
    if (good && n > 0 && scene->spheres > 0) {
        const double most = fmin(SAMPLE, fmax(64.0, WORK / (double)n));
        const size_t every = 1 + (size_t)((double)scene->spheres / most);
        const double few = HIDDEN * ceil((double)scene->spheres / (double)every);
        find_pieces(&with, scene, faces, eye);
        count_hidden(scene, eye, every, &with);
        add_sides(&with, few);
        for (size_t t = 0; t < n; t++) {
            const piece *of = &with.piece[with.of[t]];
            scene->veiled[t] = of->hidden > few || (of->hidden > 0 && of->hidden_side > few);
        }
    }
    free_work(&with);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the walls.");
}
