#include "picture/cutaway.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"

#define SAMPLE 800   ///< grains at most that are looked for
#define WORK 4.0e7   ///< triangles times grains at most
#define HIDDEN 0.015 ///< share of the grains that a face may hide
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

/** Face and side of a triangle as one number: curved faces have a near side and a far one. */
static size_t side_of(const clod_scene *scene, const clod_faces *faces, size_t t, clod_vec3 eye)
{
    const clod_vec3 a = clod_vec3_of(scene->corner[t][0]);
    const clod_vec3 n = clod_vec3_cross(clod_vec3_sub(clod_vec3_of(scene->corner[t][1]), a),
                                        clod_vec3_sub(clod_vec3_of(scene->corner[t][2]), a));
    const bool front = clod_vec3_dot(n, clod_vec3_sub(eye, a)) > 0.0;
    return 2 * (size_t)faces->face[t] + (front != (faces->turned[t] != 0));
}

/** Count for each side the sampled grains that it hides. */
static void count_hidden(const clod_scene *scene, const size_t *side, clod_vec3 eye,
                         size_t every, uint32_t (*hidden)[2])
{
    uint32_t grain = 0;
    for (size_t k = 0; k < scene->spheres; k += every) {
        const clod_vec3 from = clod_vec3_of(scene->center[k]);
        const clod_vec3 way = clod_vec3_sub(eye, from);
        grain++;
        for (size_t t = 0; t < scene->triangles; t++) {
            uint32_t *of = hidden[side[t]]; // how many, and the last one that was counted
            if (of[1] != grain && crosses(scene->corner[t], from, way)) {
                of[0]++;
                of[1] = grain;
            }
        }
    }
}

bool clod_cutaway_veil(clod_scene *scene, const clod_faces *faces, clod_vec3 eye,
                       clod_status *status)
{
    const size_t n = scene->triangles;
    size_t *side = clod_memory_alloc(n + 1, sizeof *side);
    uint32_t(*hidden)[2] = clod_memory_alloc(2 * faces->count + 1, sizeof *hidden);
    const bool good = side != NULL && hidden != NULL;
    if (good && n > 0 && scene->spheres > 0) {
        const double most = fmin(SAMPLE, fmax(64.0, WORK / (double)n));
        const size_t every = 1 + (size_t)((double)scene->spheres / most);
        const double sampled = ceil((double)scene->spheres / (double)every);
        for (size_t t = 0; t < n; t++) {
            side[t] = side_of(scene, faces, t, eye);
        }
        count_hidden(scene, side, eye, every, hidden);
        for (size_t t = 0; t < n; t++) {
            scene->veiled[t] = (double)hidden[side[t]][0] > HIDDEN * sampled;
        }
    }
    clod_memory_free(side);
    clod_memory_free(hidden);
    return good || clod_status_fail(status, CLOD_FAILED, "No memory for the walls.");
}
