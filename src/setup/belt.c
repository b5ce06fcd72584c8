#include "setup/belt.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/vec3.h"

/** Pieces into which a transition is cut along the belt. */
#define TRANSITION_PIECES 8
#define MOST_POINTS 4 ///< of a cross-section

/** A place of the path, in the upright plane through its middle: x along the heading, z up. */
typedef struct station {
    double x, z;
    double up[2];   ///< along which heights above the belt count; longer than 1 in a bend
    double flatten; ///< share of the idler angle that is gone
} station;

/** Places of a cross-section: y to the left, z along `up`. */
typedef struct section {
    int count;
    double point[MOST_POINTS][2];
} section;

/** What writes a belt as the text of an OBJ file. */
typedef struct writer {
    FILE *out;
    const clod_case_belt *belt;
    double
        origin[2]; ///< x, z: numbers of the file count from the pulley, where they matter most
    size_t vertices;
} writer;

static section section_at(const clod_case_belt *belt, double flatten)
{
    const double half = 0.5 * belt->middle_roll;
    if (belt->idler_angle == 0.0) {
        return (section){2, {{0.5 * belt->width, 0.0}, {-0.5 * belt->width, 0.0}}};
    }
    const double angle = belt->idler_angle * (1.0 - flatten);
    const double wing = 0.5 * belt->width - half;
    const double y = half + wing * cos(angle), z = wing * sin(angle);
    if (half == 0.0) {
        return (section){3, {{y, z}, {0.0, 0.0}, {-y, z}}};
    }
    return (section){4, {{y, z}, {half, 0.0}, {-half, 0.0}, {-y, z}}};
}

static clod_vec3 place(const station *at, double y, double height)
{
    return (clod_vec3){at->x + height * at->up[0], y, at->z + height * at->up[1]};
}

/** Pieces of a length that are no longer than a facet may be; 1 without such a limit. */
static int pieces(const writer *self, double length)
{
    const double most = self->belt->facet;
    return most > 0.0 ? (int)fmax(1.0, ceil(length / most - 1e-9)) : 1;
}

/** Two facets whose normal looks from where the corners are met counterclockwise. */
static void write_piece(writer *self, const clod_vec3 corner[4])
{
    for (int k = 0; k < 4; k++) {
        fprintf(self->out, "v %.9g %.9g %.9g\n", corner[k].x - self->origin[0], corner[k].y,
                corner[k].z - self->origin[1]);
    }
    const size_t v = self->vertices;
    fprintf(self->out, "f %zu %zu %zu\nf %zu %zu %zu\n", v + 1, v + 2, v + 3, v + 1, v + 3,
            v + 4);
    self->vertices += 4;
}

static clod_vec3 mix(clod_vec3 a, clod_vec3 b, double share)
{
    return clod_vec3_axpy(clod_vec3_scale(a, 1.0 - share), share, b);
}

/** Corners a, b, c, d of a plate: the place between them, 0 to 1 from a to b, and from a to d. */
static clod_vec3 between(const clod_vec3 corner[4], double along_b, double along_d)
{
    const clod_vec3 low = mix(corner[0], corner[1], along_b);
    const clod_vec3 high = mix(corner[3], corner[2], along_b);
    return mix(low, high, along_d);
}

/** Pieces between two stations of a straight part. */
static int pieces_along(const writer *self, const station *a, const station *b)
{
    return pieces(self, hypot(b->x - a->x, b->z - a->z));
}

/** A plate in pieces: `to_b` from its first corner to the second, `to_d` from there to the last. */
static void write_quad(writer *self, const clod_vec3 corner[4], int to_b, int to_d)
{
    for (int d = 0; d < to_d; d++) {
        for (int b = 0; b < to_b; b++) {
            const double left = (double)b / to_b, right = (double)(b + 1) / to_b;
            const double low = (double)d / to_d, high = (double)(d + 1) / to_d;
            write_piece(self, (clod_vec3[4]){
                                  between(corner, left, low), between(corner, right, low),
                                  between(corner, right, high), between(corner, left, high)});
        }
    }
}

/** The belt between two stations, in so many pieces along it. */
static void write_strip(writer *self, const station *a, const station *b, int along)
{
    const section first = section_at(self->belt, a->flatten);
    const section second = section_at(self->belt, b->flatten);
    for (int k = 0; k + 1 < first.count; k++) {
        const double *p = first.point[k], *q = first.point[k + 1];
        const double *r = second.point[k + 1], *s = second.point[k];
        write_quad(self,
                   (clod_vec3[4]){place(a, p[0], p[1]), place(a, q[0], q[1]),
                                  place(b, r[0], r[1]), place(b, s[0], s[1])},
                   pieces(self, hypot(q[0] - p[0], q[1] - p[1])), along);
    }
}

/** The station `along` a run [m], `flatten` of it; within the run heights count across it. */
static station station_on(const clod_case_belt *belt, size_t run, double along, double flatten)
{
    station at = {.flatten = flatten};
    for (size_t r = 0; r < run; r++) {
        at.x += belt->runs[r].length * cos(belt->runs[r].rise);
        at.z += belt->runs[r].length * sin(belt->runs[r].rise);
    }
    const double rise = belt->runs[run].rise;
    at.x += along * cos(rise);
    at.z += along * sin(rise);
    const bool begins = along == 0.0 && run > 0;
    const bool ends = along == belt->runs[run].length && run + 1 < belt->run_count;
    const double other = begins ? belt->runs[run - 1].rise
                         : ends ? belt->runs[run + 1].rise
                                : rise;
    const double half = 0.5 * (other - rise); // a mitre: both runs end in the middle plane
    at.up[0] = -sin(rise + half) / cos(half);
    at.up[1] = cos(rise + half) / cos(half);
    return at;
}

/** Length at the end of a run over which the trough flattens [m]. */
static double flattening(const clod_case_belt *belt, size_t run)
{
    const bool last = run + 1 == belt->run_count;
    return last && belt->idler_angle > 0.0 ? belt->transition : 0.0;
}

static void write_run(writer *self, size_t run)
{
    const clod_case_belt *belt = self->belt;
    const double length = belt->runs[run].length;
    const double flattens = flattening(belt, run);
    station from = station_on(belt, run, 0.0, 0.0);
    if (flattens < length) {
        const double along = flattens > 0.0 ? length - flattens : length;
        const station to = station_on(belt, run, along, 0.0);
        write_strip(self, &from, &to, pieces_along(self, &from, &to));
        from = to;
    }
    for (int k = 1; flattens > 0.0 && k <= TRANSITION_PIECES; k++) {
        const double share = (double)k / TRANSITION_PIECES;
        const double along = k < TRANSITION_PIECES ? length - (1.0 - share) * flattens : length;
        const station to = station_on(belt, run, along, share);
        write_strip(self, &from, &to, pieces_along(self, &from, &to));
        from = to;
    }
}

/** The station at an angle of the pulley from where the last run ends. */
static station station_on_pulley(const clod_case_belt *belt, double angle)
{
    const size_t run = belt->run_count - 1;
    const double radius = belt->pulley.radius;
    const double rise = belt->runs[run].rise;
    station at = station_on(belt, run, belt->runs[run].length, 1.0);
    if (angle > 0.0) { // centre, and from there
        at.x += radius * (sin(rise) - sin(rise - angle));
        at.z += radius * (cos(rise - angle) - cos(rise));
    }
    at.up[0] = -sin(rise - angle);
    at.up[1] = cos(rise - angle);
    return at;
}

static void write_pulley(writer *self)
{
    const double wrap = self->belt->pulley.wrap;
    const int facets = (int)ceil(wrap / CLOD_BELT_FACET);
    station from = station_on_pulley(self->belt, 0.0);
    for (int k = 1; k <= facets; k++) {
        const station to = station_on_pulley(self->belt, wrap * k / facets);
        write_strip(self, &from, &to, 1); // corners of facets lie on the cylinder
        from = to;
    }
}

static void write_return(writer *self)
{
    const clod_case_belt *belt = self->belt;
    const station from = station_on_pulley(belt, belt->pulley.wrap);
    const double rise = belt->runs[belt->run_count - 1].rise - belt->pulley.wrap;
    station to = from;
    to.x += belt->pulley.return_length * cos(rise);
    to.z += belt->pulley.return_length * sin(rise);
    write_strip(self, &from, &to, pieces_along(self, &from, &to));
}

/** Height of the trough above its middle at a distance y from there. */
static double trough_height(const clod_case_belt *belt, double y)
{
    return fmax(0.0, y - 0.5 * belt->middle_roll) * tan(belt->idler_angle);
}

/** Both plates between two stations. */
static void write_plates(writer *self, const station *a, const station *b)
{
    const clod_case_belt_skirts *skirts = &self->belt->skirts;
    const double y = 0.5 * skirts->distance;
    const double low = trough_height(self->belt, y) + skirts->gap;
    const double high = low + skirts->height;
    const int along = pieces_along(self, a, b);
    const int upright = pieces(self, skirts->height);
    write_quad(self,
               (clod_vec3[4]){place(a, y, low), place(b, y, low), place(b, y, high),
                              place(a, y, high)},
               along, upright);
    write_quad(self,
               (clod_vec3[4]){place(a, -y, low), place(a, -y, high), place(b, -y, high),
                              place(b, -y, low)},
               upright, along);
}

static void write_skirts(writer *self)
{
    const clod_case_belt *belt = self->belt;
    const clod_case_belt_skirts *skirts = &belt->skirts;
    double begin = 0.0;
    for (size_t r = 0; r < belt->run_count; r++) {
        const double length = belt->runs[r].length;
        const double from = fmax(0.0, skirts->from - begin);
        const double to = fmin(length, skirts->to - begin);
        if (from < to) {
            const station a = station_on(belt, r, from, 0.0), b = station_on(belt, r, to, 0.0);
            write_plates(self, &a, &b);
        }
        begin += length;
    }
}

// ---- parts

/** How many parts a belt has. */
static size_t count_parts(const clod_case_belt *belt)
{
    return belt->run_count + (belt->pulley.radius > 0.0 ? 1 : 0) +
           (belt->pulley.return_length > 0.0 ? 1 : 0) + (belt->skirts.height > 0.0 ? 1 : 0);
}

static clod_vec3 heading_of(const clod_case_belt *belt)
{
    return clod_vec3_unit((clod_vec3){belt->heading[0], belt->heading[1], 0.0});
}

/** The origin of the file in space. */
static clod_vec3 origin_of(const writer *self)
{
    const clod_vec3 from = clod_vec3_of(self->belt->from);
    clod_vec3 at = clod_vec3_axpy(from, self->origin[0], heading_of(self->belt));
    at.z += self->origin[1];
    return at;
}

/** Let a part move along a straight piece of the path: where its facets lean, along the projection
 *  of that onto them, with the belt's speed all the same. Elsewhere what is normal to the surface
 *  is lost, at the edge where a belt without a pulley ends. */
static void drive(const clod_case_belt *belt, double rise, bool leans, clod_case_surface *part)
{
    const double size = leans ? 1.0 : belt->speed;
    const clod_vec3 flat = clod_vec3_scale(heading_of(belt), size * cos(rise));
    const clod_vec3 along = {flat.x, flat.y, size * sin(rise)};
    clod_vec3_put(leans ? part->direction : part->velocity, along);
    part->speed = leans ? belt->speed : 0.0;
}

/** Write the belt, and how each part moves; parts come in the order in which they are written. */
static void write_parts(writer *self, clod_case_surface *parts)
{
    const clod_case_belt *belt = self->belt;
    const double end = belt->runs[belt->run_count - 1].rise;
    size_t part = 0;
    for (size_t r = 0; r < belt->run_count; r++, part++) {
        fprintf(self->out, "o run %zu\n", r + 1);
        write_run(self, r);
        drive(belt, belt->runs[r].rise, flattening(belt, r) > 0.0, &parts[part]);
    }
    if (belt->pulley.radius > 0.0) {
        fprintf(self->out, "o pulley\n");
        write_pulley(self);
        clod_vec3_put(parts[part].spin_point, origin_of(self));
        clod_vec3_put(parts[part].spin_axis,
                      clod_vec3_cross((clod_vec3){0.0, 0.0, 1.0}, heading_of(belt)));
        parts[part++].spin = belt->speed / belt->pulley.radius;
    }
    if (belt->pulley.return_length > 0.0) {
        fprintf(self->out, "o return\n");
        write_return(self);
        drive(belt, end - belt->pulley.wrap, false, &parts[part++]);
    }
    if (belt->skirts.height > 0.0) {
        fprintf(self->out, "o skirts\n");
        write_skirts(self);
        parts[part].material = belt->skirts.material;
    }
}

clod_setup_belt clod_setup_belt_make(const clod_case_belt *belt, const char *name,
                                     clod_status *status)
{
    clod_setup_belt self = {.parts =
                                clod_memory_alloc(count_parts(belt) + 1, sizeof *self.parts)};
    char *text = NULL;
    size_t length = 0;
    writer out = {.out = open_memstream(&text, &length), .belt = belt};
    const station top = station_on_pulley(belt, 0.0);
    out.origin[0] = top.x - belt->pulley.radius * top.up[0];
    out.origin[1] = top.z - belt->pulley.radius * top.up[1];
    clod_mesh_placing placing = {
        .unit = 1.0,
        .scale = 1.0,
        .rotate = {.axis = {0.0, 0.0, 1.0},
                   .angle = atan2(belt->heading[1], belt->heading[0])}};
    clod_vec3_put(placing.move, origin_of(&out));
    bool good = self.parts != NULL && out.out != NULL;
    if (good) {
        write_parts(&out, self.parts);
    }
    good = out.out != NULL && fclose(out.out) == 0 && good;
    if (good) {
        char path[128];
        snprintf(path, sizeof path, "%s.obj", name);
        self.mesh = clod_mesh_parse(path, text, length, &placing, status);
    } else {
        clod_status_fail(status, CLOD_FAILED, "no memory for the belt %s", name);
    }
    free(text);
    return self;
}

void clod_setup_belt_fini(clod_setup_belt *self)
{
    clod_mesh_destroy(&self->mesh);
    clod_memory_free(self->parts);
    *self = (clod_setup_belt){0};
}
