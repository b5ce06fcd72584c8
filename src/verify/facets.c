#include "verify/facets.h"

#include <errno.h>
#include <math.h>
#include <string.h>

bool clod_verify_facets_open(clod_verify_facets *self, const char *folder, const char *name,
                             clod_status *status)
{
    snprintf(self->path, sizeof self->path, "%.3000s/%.100s.stl", folder, name);
    self->out = fopen(self->path, "w");
    if (self->out == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", self->path,
                                strerror(errno));
    }
    fprintf(self->out, "solid %s\n", name);
    return true;
}

static void put_facet(FILE *out, clod_vec3 a, clod_vec3 b, clod_vec3 c)
{
    const clod_vec3 corner[] = {a, b, c};
    fprintf(out, "facet normal 0 0 0\nouter loop\n");
    for (int k = 0; k < 3; k++) {
        fprintf(out, "vertex %.9g %.9g %.9g\n", corner[k].x, corner[k].y, corner[k].z);
    }
    fprintf(out, "endloop\nendfacet\n");
}

static void put_quad(FILE *out, const clod_vec3 corner[4])
{
    put_facet(out, corner[0], corner[1], corner[2]);
    put_facet(out, corner[0], corner[2], corner[3]);
}

/** A corner of a polygon whose mean distance from the axis is the radius of a point. */
static clod_vec3 corner_of(const double point[2], int side, int sides)
{
    // along a side the distance is a/cos(t), a = R cos(h), |t| <= h: its mean over t is
    // a ln((1 + sin h)/cos h)/h
    const double half = M_PI / sides, angle = 2.0 * half * side;
    const double mean = cos(half) * log((1.0 + sin(half)) / cos(half)) / half;
    const double r = point[0] / mean;
    return (clod_vec3){r * cos(angle), r * sin(angle), point[1]};
}

void clod_verify_facets_lathe(clod_verify_facets *self, const double (*points)[2], int count,
                              int sides)
{
    for (int p = 0; p + 1 < count; p++) {
        for (int s = 0; s < sides; s++) {
            const int next = (s + 1) % sides;
            const clod_vec3 corner[4] = {
                corner_of(points[p], s, sides), corner_of(points[p], next, sides),
                corner_of(points[p + 1], next, sides), corner_of(points[p + 1], s, sides)};
            put_quad(self->out, corner);
        }
    }
}

void clod_verify_facets_box(clod_verify_facets *self, clod_vec3 center, const clod_vec3 half[3])
{
    for (int f = 0; f < 6; f++) {
        const double side = f < 3 ? 1.0 : -1.0;
        const clod_vec3 u = half[(f + 1) % 3], v = half[(f + 2) % 3];
        const clod_vec3 middle = clod_vec3_axpy(center, side, half[f % 3]);
        clod_vec3 corner[4];
        for (int c = 0; c < 4; c++) { // seen from outside they go round to the left
            const double a = c == 0 || c == 3 ? -1.0 : 1.0, b = c < 2 ? -1.0 : 1.0;
            corner[c] = clod_vec3_axpy(clod_vec3_axpy(middle, a * side, u), b, v);
        }
        put_quad(self->out, corner);
    }
}

bool clod_verify_facets_close(clod_verify_facets *self, clod_status *status)
{
    fprintf(self->out, "endsolid\n");
    const bool lost = ferror(self->out) != 0;
    const bool closed = fclose(self->out) == 0;
    self->out = NULL;
    return (closed && !lost) ||
           clod_status_fail(status, CLOD_FAILED, "%s: cannot be written", self->path);
}
