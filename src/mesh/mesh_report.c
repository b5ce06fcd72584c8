/**
 * @file mesh_report.c
 * Measures of a mesh, and doubts about it.
 */

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "base/memory.h"
#include "base/sort.h"
#include "base/text.h"
#include "mesh/mesh.h"
#include "mesh/mesh_findings.h"
#include "mesh/mesh_vertices.h"

#define GRAINS_MOST 1000.0 ///< grain diameters along the box from which on a unit looks wrong
#define GRAINS_LEAST 10.0  ///< the same, to the other side
#define SIZE_MOST 1000.0   ///< m, of a plant
#define SIZE_LEAST 1e-3    ///< m, of a part of one
#define FINE_SHARE 0.1     ///< of the facets that may be smaller than a grain
#define ROUGH_GRAIN 1e-3   ///< step of a float over the radius of a grain
#define ROUGH_BOX 1e-5     ///< step of a float over the size of the box
#define NAME_SHOWN 80      ///< bytes of the name of a part in a warning

const clod_mesh_words CLOD_MESH_FINDINGS[CLOD_MESH_KINDS] = {
    [CLOD_MESH_WELDED] = {"welded_vertices", "vertex", "vertices",
                          " that only rounding tells from another", "joined", ""},
    [CLOD_MESH_DEGENERATE] = {"degenerate_facets", "facet", "facets", " without area",
                              "dropped", ""},
    [CLOD_MESH_DUPLICATE] = {"duplicate_facets", "facet", "facets",
                             " with the corners of another", "dropped", ""},
    [CLOD_MESH_TURNED] = {"flipped_facets", "facet", "facets",
                          " whose normal disagrees with the neighbours", "turned", ""},
    [CLOD_MESH_TWISTED] = {"twisted_edges", "edge", "edges",
                           " where no turning makes normals agree", "kept",
                           "Is the surface twisted like a Moebius strip?"},
    [CLOD_MESH_OPEN] = {"open_edges", "open edge", "open edges", "", "kept",
                        "A sheet ends there. If the wall should be closed, close it in CAD."},
    [CLOD_MESH_T] = {"t_edges", "edge", "edges", " with a vertex of another facet inside",
                     "kept", "The facets on both sides are neighbours."},
    [CLOD_MESH_NONMANIFOLD] = {"nonmanifold_edges", "edge", "edges", " of three or more facets",
                               "kept", "Sheets meet there."},
    [CLOD_MESH_NEEDLE] = {"needle_facets", "needle", "needles",
                          ", one edge below 1/100 of the longest", "kept", ""},
    [CLOD_MESH_SLIVER] = {"sliver_facets", "sliver", "slivers",
                          ", height below 1/100 of the longest edge", "kept", ""},
    [CLOD_MESH_OVERLAP] = {"overlapping_facets", "facet", "facets",
                           " over an earlier one in one plane", "kept",
                           "Together they push as one plane, once; where parts differ, the "
                           "first in the file decides."},
    [CLOD_MESH_CROSSING] =
        {"crossing_facets", "facet", "facets", " cut through by another", "kept",
         "Where they cross, grains feel a groove on every side: each pushes with its "
         "full overlap. What pokes through pushes there too."},
};

const char *const CLOD_MESH_EDGES[CLOD_MESH_EDGE_KINDS] = {
    [CLOD_MESH_EDGE_FLAT] = "flat",
    [CLOD_MESH_EDGE_CONVEX] = "convex",
    [CLOD_MESH_EDGE_CONCAVE] = "concave",
    [CLOD_MESH_EDGE_OPEN] = "open",
    [CLOD_MESH_EDGE_T] = "t",
    [CLOD_MESH_EDGE_NONMANIFOLD] = "nonmanifold",
};

static void measure_box(const clod_mesh *self, clod_mesh_report *report)
{
    for (int k = 0; k < 3; k++) {
        report->box[0][k] = INFINITY;
        report->box[1][k] = -INFINITY;
    }
    for (size_t v = 0; v < self->view.vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            report->box[0][k] = fmin(report->box[0][k], self->vertices[v][k]);
            report->box[1][k] = fmax(report->box[1][k], self->vertices[v][k]);
        }
    }
}

/** Area, and the volume that facets enclose with the middle of the box, which is near them. */
static void measure_facets(const clod_mesh *self, clod_mesh_report *report)
{
    const double(*box)[3] = (const double(*)[3])report->box;
    const clod_vec3 middle = {0.5 * (box[0][0] + box[1][0]), 0.5 * (box[0][1] + box[1][1]),
                              0.5 * (box[0][2] + box[1][2])};
    double six = 0.0;
    report->area = 0.0;
    report->small_facets = 0;
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        const clod_mesh_triangle t = clod_mesh_measure(self, f);
        const clod_vec3 a = clod_vec3_sub(clod_mesh_corner(self, f, 0), middle);
        const clod_vec3 b = clod_vec3_sub(clod_mesh_corner(self, f, 1), middle);
        const clod_vec3 c = clod_vec3_sub(clod_mesh_corner(self, f, 2), middle);
        report->area += t.area;
        report->small_facets += t.longest < report->grain_radius;
        six += clod_vec3_dot(a, clod_vec3_cross(b, c));
    }
    report->closed = self->findings[CLOD_MESH_OPEN].count == 0 &&
                     self->findings[CLOD_MESH_NONMANIFOLD].count == 0 &&
                     self->findings[CLOD_MESH_TWISTED].count == 0;
    report->volume = report->closed ? six / 6.0 : (double)NAN;
}

static void count_edges(const clod_mesh *self, clod_mesh_report *report)
{
    memset(report->edges, 0, sizeof report->edges);
    for (uint32_t f = 0; f < self->view.facet_count; f++) {
        for (int e = 0; e < 3; e++) {
            const uint8_t kind = self->edges[f][e];
            const bool shared = kind <= CLOD_MESH_EDGE_CONCAVE;
            report->edges[kind] += !shared || f < self->neighbours[f][e];
        }
    }
    report->edges[CLOD_MESH_EDGE_NONMANIFOLD] = self->findings[CLOD_MESH_NONMANIFOLD].count;
}

/** Shortest, median and longest edge of a facet. */
static bool measure_edges(const clod_mesh *self, clod_mesh_report *report)
{
    const size_t count = 3 * self->view.facet_count;
    clod_sort_item *items = clod_memory_alloc(count, 2 * sizeof *items);
    if (items == NULL) {
        return false;
    }
    for (size_t e = 0; e < count; e++) {
        const uint32_t f = (uint32_t)(e / 3);
        const int c = (int)(e % 3);
        const double length = clod_vec3_length(
            clod_vec3_sub(clod_mesh_corner(self, f, c), clod_mesh_corner(self, f, c + 1)));
        memcpy(&items[e].key, &length,
               sizeof length); // numbers above 0 ascend as their bits do
        items[e].index = e;
    }
    clod_sort(items, items + count, count);
    memcpy(&report->shortest, &items[0].key, sizeof report->shortest);
    memcpy(&report->median, &items[count / 2].key, sizeof report->median);
    memcpy(&report->longest, &items[count - 1].key, sizeof report->longest);
    clod_memory_free(items);
    return true;
}

static void __attribute__((format(printf, 2, 3)))
warn(clod_mesh_report *report, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (report->warning_count < CLOD_MESH_WARNINGS) {
        vsnprintf(report->warnings[report->warning_count++], CLOD_MESH_WARNING_TEXT, format,
                  args);
    }
    va_end(args);
}

/** Units in which the mesh would have a plausible size, as a list for a message. */
static void list_units(const clod_mesh *self, double size, double diameter, char *list,
                       size_t room)
{
    static const struct {
        const char *name;
        double metres;
    } UNITS[] = {{"m", 1.0},   {"ft", 0.3048}, {"in", 0.0254},
                 {"cm", 0.01}, {"mm", 0.001},  {"um", 1e-6}};
    size_t used = 0;
    list[0] = '\0';
    for (size_t u = 0; u < sizeof UNITS / sizeof UNITS[0]; u++) {
        const double other = size / self->unit * UNITS[u].metres;
        const bool plausible = other >= SIZE_LEAST && other <= SIZE_MOST &&
                               (diameter == 0.0 || (other >= GRAINS_LEAST * diameter &&
                                                    other <= GRAINS_MOST * diameter));
        if (plausible && used < room) {
            used += (size_t)snprintf(list + used, room - used, "%s%s", used > 0 ? ", " : "",
                                     UNITS[u].name);
        }
    }
    if (used == 0) {
        snprintf(list, room, "none of the usual units");
    }
}

static double longest_side(const clod_mesh_report *report)
{
    double size = 0.0;
    for (int k = 0; k < 3; k++) {
        size = fmax(size, report->box[1][k] - report->box[0][k]);
    }
    return size;
}

/** Three digits, from 1000 to 99999 all: "0.02", "1012". */
static const char *short_text(double value, char text[24])
{
    snprintf(text, 24, value >= 1000.0 && value < 1e5 ? "%.0f" : "%.3g", value);
    return text;
}

/** Warn of a size that no plant has; whether it did. */
static bool doubt_size(const clod_mesh *self, clod_mesh_report *report)
{
    const double diameter = 2.0 * report->grain_radius;
    const double size = longest_side(report);
    char units[64], length[24], ratio[24];
    list_units(self, size, diameter, units, sizeof units);
    const double grains = diameter > 0.0 ? size / diameter : GRAINS_LEAST;
    if (size > SIZE_MOST || size < SIZE_LEAST) {
        warn(report,
             "The mesh is %s m long; a plant has from 1 mm to 1 km. Is the unit right? "
             "The size would be plausible in: %s.",
             short_text(size, length), units);
    } else if (grains > GRAINS_MOST || grains < GRAINS_LEAST) {
        warn(report,
             "The mesh is %s m long, %s grain diameters; from 10 to 1000 are usual. "
             "Is the unit right? The size would be plausible in: %s.",
             short_text(size, length), short_text(grains, ratio), units);
    } else {
        return false;
    }
    return true;
}

/** Single precision is coarse far from the origin. */
static void doubt_rounding(const clod_mesh *self, clod_mesh_report *report)
{
    const double step = self->weld / CLOD_MESH_WELD_STEPS;
    if (step > ROUGH_BOX * longest_side(report) ||
        (report->grain_radius > 0.0 && step > ROUGH_GRAIN * report->grain_radius)) {
        warn(
            report,
            "Coordinates are rounded to %.2g m: single precision, as far from the origin of the "
            "file as this mesh lies. Move it to the origin in CAD.",
            step);
    }
}

static void doubt_facets(const clod_mesh *self, clod_mesh_report *report)
{
    const double count = (double)self->view.facet_count;
    if ((double)report->small_facets > FINE_SHARE * count) {
        warn(report,
             "%zu of %zu facets %s smaller than the radius of a grain, which feels none "
             "of them singly but takes time for each. Export a coarser mesh.",
             report->small_facets, self->view.facet_count,
             report->small_facets == 1 ? "is" : "are");
    }
    if (self->unsearched > 0) {
        warn(
            report,
            "Facets over each other in one plane, or through each other, were looked for at %zu of %zu "
            "facets only: too many lie over each other, or long ones aslant side by side. The others "
            "count as sheets of their own, which push once where they lie over each other.",
            self->view.facet_count - self->unsearched, self->view.facet_count);
    }
    if (report->volume < 0.0) {
        warn(report, "The normals of the closed mesh point inwards. That is right for a room "
                     "that holds grains; for a solid body turn the normals in CAD if another "
                     "program needs them.");
    }
}

/** Bytes of the longest start of a name, of whole characters, that a warning has room for. */
static int shown(const char *name)
{
    size_t length = 0, next = 0;
    while (name[length] != '\0' && next <= NAME_SHOWN) {
        length = next;
        next += clod_text_utf8(name + length, strlen(name + length));
    }
    return (int)length;
}

/** Warn of parts whose names are alike since some of their bytes were replaced. */
static void doubt_names(const clod_mesh *self, clod_mesh_report *report)
{
    const clod_mesh_part *parts = self->view.parts;
    for (size_t p = 0; p < self->view.part_count; p++) {
        const char *name = parts[p].name;
        size_t first = p, alike = 0;
        for (size_t q = 0; strchr(name, '?') != NULL && q < self->view.part_count; q++) {
            if (strcmp(parts[q].name, name) == 0) {
                first = q < first ? q : first;
                alike++;
            }
        }
        if (alike > 1 && first == p) {
            const int length = shown(name);
            warn(report,
                 "%zu parts are called %.*s%s: control characters and bytes that are not UTF-8 "
                 "are shown as ?. A key of this name in a case means %s; rename them to tell "
                 "them apart.",
                 alike, length, name, name[length] != '\0' ? "..." : "",
                 alike == 2 ? "both" : "all of them");
        }
    }
}

bool clod_mesh_examine(const clod_mesh *self, double grain_radius, clod_mesh_report *report,
                       clod_status *status)
{
    if (!CLOD_GIVEN(self, status) || !CLOD_GIVEN(report, status)) {
        return false;
    }
    *report = (clod_mesh_report){
        .read_facets = self->read_facets, .weld = self->weld, .grain_radius = grain_radius};
    memcpy(report->findings, self->findings, sizeof report->findings);
    measure_box(self, report);
    measure_facets(self, report);
    count_edges(self, report);
    if (!measure_edges(self, report)) {
        return clod_mesh_lacks_memory(self, status);
    }
    if (!doubt_size(self, report)) {
        doubt_rounding(self, report);
    }
    doubt_facets(self, report);
    doubt_names(self, report);
    return true;
}
