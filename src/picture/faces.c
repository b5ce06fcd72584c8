#include "picture/faces.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/sort.h"
#include "base/vec3.h"

#define SMOOTH 0.8660254037844386 ///< cosine of the angle below which triangles are one face
#define GRID 2097151.0            ///< steps of a coordinate, 21 bits: nearer points are one

/** What is needed on the way; all owned. */
typedef struct work {
    size_t triangles;
    clod_sort_item *item, *scratch; ///< [3 triangles]
    uint64_t (*vertex)[3];          ///< [triangles] numbers of the corners
    clod_vec3 *normal;              ///< [triangles] as long as twice the area
    int32_t *parent;                ///< [triangles] of a union-find forest
    uint8_t *parity;                ///< against that parent
    double (*end)[2][3];            ///< [3 triangles]
    size_t lines;
} work;

static void free_work(work *self)
{
    clod_memory_free(self->item);
    clod_memory_free(self->scratch);
    clod_memory_free(self->vertex);
    clod_memory_free(self->normal);
    clod_memory_free(self->parent);
    clod_memory_free(self->parity);
    clod_memory_free(self->end);
}

static bool take_work(work *self, size_t triangles)
{
    *self = (work){
        .triangles = triangles,
        .item = clod_memory_alloc(3 * triangles + 1, sizeof *self->item),
        .scratch = clod_memory_alloc(3 * triangles + 1, sizeof *self->scratch),
        .vertex = clod_memory_alloc(triangles + 1, sizeof *self->vertex),
        .normal = clod_memory_alloc(triangles + 1, sizeof *self->normal),
        .parent = clod_memory_alloc(triangles + 1, sizeof *self->parent),
        .parity = clod_memory_alloc(triangles + 1, sizeof *self->parity),
        .end = clod_memory_alloc(3 * triangles + 1, sizeof *self->end),
    };
    return self->item != NULL && self->scratch != NULL && self->vertex != NULL &&
           self->normal != NULL && self->parent != NULL && self->parity != NULL &&
           self->end != NULL;
}

/** Give corners at the same place the same number. */
static void number_vertices(work *self, const clod_scene *scene)
{
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
    double size = 0.0;
    const size_t corners = 3 * self->triangles;
    for (int pass = 0; pass < 2; pass++) { // the lowest corner, then the largest extent
        for (size_t k = 0; k < corners; k++) {
            for (int d = 0; d < 3; d++) {
                const double x = scene->corner[k / 3][k % 3][d];
                low[d] = pass == 0 ? fmin(low[d], x) : low[d];
                size = pass == 1 ? fmax(size, x - low[d]) : size;
            }
        }
    }
    for (size_t k = 0; k < corners; k++) {
        uint64_t key = 0;
        for (int d = 0; d < 3; d++) {
            const double x = scene->corner[k / 3][k % 3][d] - low[d];
            key = (key << 21) | (uint64_t)(size > 0.0 ? x / size * GRID : 0.0);
        }
        self->item[k] = (clod_sort_item){key, k};
    }
    clod_sort(self->item, self->scratch, corners);
    uint64_t number = 0;
    for (size_t k = 0; k < corners; k++) {
        number += k > 0 && self->item[k].key != self->item[k - 1].key;
        const uint64_t of = self->item[k].index;
        self->vertex[of / 3][of % 3] = number;
    }
}

/** Root of a triangle's tree; `parity`: whether it is turned against it. */
static int32_t find_root(work *self, int32_t t, uint8_t *parity)
{
    uint8_t turned = 0;
    int32_t root = t;
    while (self->parent[root] != root) {
        turned ^= self->parity[root];
        root = self->parent[root];
    }
    *parity = turned;
    while (self->parent[t] != root && t != root) { // shorten the way
        const int32_t next = self->parent[t];
        const uint8_t step = self->parity[t];
        self->parent[t] = root;
        self->parity[t] = turned;
        turned ^= step;
        t = next;
    }
    return root;
}

static void join(work *self, int32_t a, int32_t b, uint8_t turned)
{
    uint8_t of_a, of_b;
    const int32_t root_a = find_root(self, a, &of_a);
    const int32_t root_b = find_root(self, b, &of_b);
    if (root_a != root_b) {
        const int32_t high = root_a > root_b ? root_a : root_b;
        self->parent[high] = root_a > root_b ? root_b : root_a;
        self->parity[high] = (uint8_t)(of_a ^ of_b ^ turned);
    }
}

/** Whether an edge of a triangle goes from the lower number of its ends to the higher. */
static bool goes_up(const work *self, uint64_t edge)
{
    const uint64_t *v = self->vertex[edge / 3];
    return v[edge % 3] < v[(edge % 3 + 1) % 3];
}

/** Two triangles at an edge: one face, or a line between two. */
static bool meet_smoothly(work *self, const clod_scene *scene, uint64_t e, uint64_t f)
{
    const size_t a = e / 3;
    const size_t b = f / 3;
    const double sizes = clod_vec3_length(self->normal[a]) * clod_vec3_length(self->normal[b]);
    const bool turned = goes_up(self, e) == goes_up(self, f);
    const double cosine = clod_vec3_dot(self->normal[a], self->normal[b]) / sizes;
    if (scene->wall[a] != scene->wall[b] || !((turned ? -cosine : cosine) > SMOOTH)) {
        return false;
    }
    join(self, (int32_t)a, (int32_t)b, turned);
    return true;
}

static void find_edges(work *self, const clod_scene *scene)
{
    const size_t edges = 3 * self->triangles;
    for (size_t e = 0; e < edges; e++) {
        const uint64_t a = self->vertex[e / 3][e % 3];
        const uint64_t b = self->vertex[e / 3][(e % 3 + 1) % 3];
        self->item[e] = (clod_sort_item){(a < b ? a : b) * (edges + 1) + (a < b ? b : a), e};
    }
    clod_sort(self->item, self->scratch, edges);
    for (size_t first = 0, end; first < edges; first = end) {
        for (end = first + 1; end < edges && self->item[end].key == self->item[first].key;) {
            end++;
        }
        const uint64_t e = self->item[first].index;
        if (end - first != 2 || !meet_smoothly(self, scene, e, self->item[first + 1].index)) {
            memcpy(self->end[self->lines][0], scene->corner[e / 3][e % 3], 3 * sizeof(double));
            memcpy(self->end[self->lines++][1], scene->corner[e / 3][(e % 3 + 1) % 3],
                   3 * sizeof(double));
        }
    }
}

/** Number the faces from 0, in the order of their first triangles. */
static void number_faces(clod_faces *self, work *from)
{
    for (size_t t = 0; t < from->triangles; t++) {
        const int32_t root = find_root(from, (int32_t)t, &self->turned[t]);
        self->face[t] = (size_t)root == t ? (int32_t)self->count++ : self->face[root];
    }
}

/** Normals at the corners: means over the triangles of a face that meet there, by area. */
static void make_normals(clod_scene *scene, const clod_faces *faces, work *from)
{
    const size_t corners = 3 * from->triangles;
    for (size_t k = 0; k < corners; k++) {
        const uint64_t face = (uint64_t)faces->face[k / 3];
        from->item[k] = (clod_sort_item){face * (corners + 1) + from->vertex[k / 3][k % 3], k};
    }
    clod_sort(from->item, from->scratch, corners);
    for (size_t first = 0, end; first < corners; first = end) {
        clod_vec3 sum = {0.0, 0.0, 0.0};
        for (end = first; end < corners && from->item[end].key == from->item[first].key;
             end++) {
            const size_t t = from->item[end].index / 3;
            sum = clod_vec3_axpy(sum, faces->turned[t] ? -1.0 : 1.0, from->normal[t]);
        }
        const double length = clod_vec3_length(sum);
        const clod_vec3 unit =
            length > 0.0 ? clod_vec3_scale(sum, 1.0 / length) : (clod_vec3){0.0, 0.0, 1.0};
        for (size_t k = first; k < end; k++) {
            const size_t corner = from->item[k].index;
            const double sign = faces->turned[corner / 3] ? -1.0 : 1.0;
            clod_vec3_put(scene->normal[corner / 3][corner % 3], clod_vec3_scale(unit, sign));
        }
    }
}

static void fill(clod_faces *self, clod_scene *scene, work *with)
{
    for (size_t t = 0; t < with->triangles; t++) {
        const clod_vec3 a = clod_vec3_of(scene->corner[t][0]);
        with->normal[t] = clod_vec3_cross(clod_vec3_sub(clod_vec3_of(scene->corner[t][1]), a),
                                          clod_vec3_sub(clod_vec3_of(scene->corner[t][2]), a));
        with->parent[t] = (int32_t)t;
    }
    number_vertices(with, scene);
    find_edges(with, scene);
    number_faces(self, with);
    make_normals(scene, self, with);
    scene->lines = with->lines;
    clod_memory_free(scene->end);
    scene->end = with->end;
    with->end = NULL;
}

bool clod_faces_make(clod_faces *self, clod_scene *scene, clod_status *status)
{
    const size_t n = scene->triangles;
    work with;
    clod_memory_free(scene->normal);
    scene->normal = clod_memory_alloc(n + 1, sizeof *scene->normal);
    *self = (clod_faces){0, clod_memory_alloc(n + 1, sizeof *self->face),
                         clod_memory_alloc(n + 1, sizeof *self->turned)};
    const bool good = take_work(&with, n) && scene->normal != NULL && self->face != NULL &&
                      self->turned != NULL && n < INT32_MAX;
    if (good) {
        fill(self, scene, &with);
    }
    free_work(&with);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the walls.");
}

void clod_faces_fini(clod_faces *self)
{
    clod_memory_free(self->face);
    clod_memory_free(self->turned);
    *self = (clod_faces){0};
}
