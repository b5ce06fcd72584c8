// A mesh as the mesh doctor sees it: each facet in the colour of what is done about it, and over them the edges
// at which surfaces do not join.

#include "picture/mesh_picture.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/plural.h"
#include "picture/faces.h"
#include "picture/page.h"
#include "picture/picture.h"
#include "picture/tracer.h"
#include "picture/view.h"

#define ANGLE (25.0 * M_PI / 180.0) ///< of view from bottom to top
#define ROOM 1.04                   ///< a margin about what is seen
#define KIND_TEXT 80

/** What is found, what clod does about it, and its colour. */
static const struct {
    const char *text;
    double colour[3];
} FAULTS[CLOD_MESH_FAULTS] = {
    [CLOD_MESH_FAULT_NONMANIFOLD] = {"edge of 3 or more facets: kept", {0.64, 0.12, 0.38}},
    [CLOD_MESH_FAULT_TWISTED] = {"normals that cannot agree: kept", {0.36, 0.14, 0.50}},
    [CLOD_MESH_FAULT_DUPLICATE] = {"more than once: kept once", {0.90, 0.45, 0.10}},
    [CLOD_MESH_FAULT_OVERLAP] = {"over another in its plane: kept", {0.55, 0.38, 0.22}},
    [CLOD_MESH_FAULT_CROSSING] = {"cut through by another: kept", {0.08, 0.22, 0.38}},
    [CLOD_MESH_FAULT_TURNED] = {"normal flipped: turned", {0.16, 0.42, 0.78}},
    [CLOD_MESH_FAULT_OPEN] = {"open edge: kept", {0.84, 0.22, 0.18}},
    [CLOD_MESH_FAULT_T] = {"vertex inside an edge: kept", {0.93, 0.77, 0.20}},
    [CLOD_MESH_FAULT_NEEDLE] = {"needle: kept", {0.20, 0.62, 0.55}},
    [CLOD_MESH_FAULT_SLIVER] = {"sliver: kept", {0.45, 0.72, 0.28}},
    [CLOD_MESH_FAULT_NONE] = {"good", {0.84, 0.87, 0.91}},
};

static const double LINE[3] = {0.30, 0.34, 0.40};

/** Edges that are drawn over the facets, by colours that no facet has. */
#define MARKS 2
static const struct {
    uint8_t edge; ///< clod_mesh_edge
    const char *text;
    double colour[3];
} EDGES[MARKS] = {
    {CLOD_MESH_EDGE_OPEN, "open", {0.00, 0.80, 0.90}},
    {CLOD_MESH_EDGE_T, "on a T", {0.85, 0.00, 0.85}},
};

static bool has_edge(const uint8_t edges[3], int kind)
{
    return edges[0] == kind || edges[1] == kind || edges[2] == kind;
}

clod_mesh_fault clod_mesh_picture_fault(const clod_mesh_view *view, size_t facet)
{
    static const clod_mesh_kind NOTED[CLOD_MESH_FAULT_NONE] = {
        [CLOD_MESH_FAULT_NONMANIFOLD] = CLOD_MESH_NONMANIFOLD,
        [CLOD_MESH_FAULT_TWISTED] = CLOD_MESH_TWISTED,
        [CLOD_MESH_FAULT_DUPLICATE] = CLOD_MESH_DUPLICATE,
        [CLOD_MESH_FAULT_OVERLAP] = CLOD_MESH_OVERLAP,
        [CLOD_MESH_FAULT_CROSSING] = CLOD_MESH_CROSSING,
        [CLOD_MESH_FAULT_TURNED] = CLOD_MESH_TURNED,
        [CLOD_MESH_FAULT_NEEDLE] = CLOD_MESH_NEEDLE,
        [CLOD_MESH_FAULT_SLIVER] = CLOD_MESH_SLIVER,
        [CLOD_MESH_FAULT_T] = CLOD_MESH_T,
        [CLOD_MESH_FAULT_OPEN] = CLOD_MESH_OPEN,
    };
    const uint8_t *edges = view->edges[facet];
    for (int fault = 0; fault < CLOD_MESH_FAULT_NONE; fault++) {
        // edges of several facets are noted at one of them alone
        if ((view->found[facet] >> NOTED[fault] & 1) != 0 ||
            (fault == CLOD_MESH_FAULT_NONMANIFOLD &&
             has_edge(edges, CLOD_MESH_EDGE_NONMANIFOLD)) ||
            (fault == CLOD_MESH_FAULT_T && has_edge(edges, CLOD_MESH_EDGE_T))) {
            return (clod_mesh_fault)fault;
        }
    }
    return CLOD_MESH_FAULT_NONE;
}

/** Of facets, dropped ones too, and edges. */
#define KINDS (CLOD_MESH_FAULTS + 1 + MARKS)

/** All that is drawn; owned content. */
typedef struct drawing {
    clod_scene scene;
    clod_faces faces;
    clod_page page;
    clod_page_bar bar[2]; ///< of facets, of edges
    size_t bars;
    size_t kinds;
    char text[KINDS][KIND_TEXT]; ///< of both, one after the other
    const char *name[KINDS];
    double colour[KINDS][3];
    uint8_t *image;
} drawing;

static bool is_named(const clod_mesh_view *view, size_t facet, const char *name)
{
    return strcmp(view->parts[view->part[facet]].name, name) == 0;
}

static bool is_hidden(const clod_mesh_view *view, size_t facet,
                      const clod_picture_mesh *options)
{
    for (size_t h = 0; h < options->hidden_count; h++) {
        if (is_named(view, facet, options->hidden[h])) {
            return true;
        }
    }
    return false;
}

/** That a part to hide is not there, and which are. */
static bool fail_hidden(const clod_mesh_view *view, const char *name, clod_status *status)
{
    char names[600] = "";
    for (size_t p = 0; p < view->part_count; p++) {
        const size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s", used > 0 ? ", " : "",
                 view->parts[p].name);
    }
    return clod_status_fail(status, CLOD_USAGE, "--hide %s: the mesh has no such part. %s%s.",
                            name, names[0] != '\0' ? "Parts: " : "Its parts have no names",
                            names);
}

/** Whether every part to hide is there, and something is left. */
static bool check_hidden(const clod_mesh_view *view, const clod_picture_mesh *options,
                         clod_status *status)
{
    for (size_t h = 0; h < options->hidden_count; h++) {
        size_t f = 0;
        while (f < view->facet_count && !is_named(view, f, options->hidden[h])) {
            f++;
        }
        if (f == view->facet_count) {
            return fail_hidden(view, options->hidden[h], status);
        }
    }
    size_t shown = 0;
    for (size_t f = 0; f < view->facet_count; f++) {
        shown += !is_hidden(view, f, options);
    }
    return shown > 0 ||
           clod_status_fail(
               status, CLOD_USAGE,
               "--hide: every part is hidden, nothing is left to draw; hide less.");
}

static bool fill_scene(clod_scene *scene, const clod_mesh_view *view,
                       const clod_picture_mesh *options, size_t *count)
{
    const size_t n = view->facet_count;
    scene->corner = clod_memory_alloc(n, sizeof *scene->corner);
    scene->paint = clod_memory_alloc(n, sizeof *scene->paint);
    scene->wall = clod_memory_alloc(n, sizeof *scene->wall);
    scene->veiled = clod_memory_alloc(n, sizeof *scene->veiled);
    if (scene->corner == NULL || scene->paint == NULL || scene->wall == NULL ||
        scene->veiled == NULL) {
        return false;
    }
    for (size_t f = 0; f < n; f++) {
        if (is_hidden(view, f, options)) {
            continue;
        }
        const size_t at = scene->triangles++;
        const clod_mesh_fault fault = clod_mesh_picture_fault(view, f);
        for (int c = 0; c < 3; c++) {
            memcpy(scene->corner[at][c], view->vertices[view->facets[f][c]],
                   sizeof scene->corner[at][c]);
        }
        scene->paint[at] = (uint16_t)(CLOD_SCENE_WALL + fault);
        count[fault]++;
    }
    for (int k = 0; k < CLOD_MESH_FAULTS; k++) {
        memcpy(scene->colour[CLOD_SCENE_WALL + k], FAULTS[k].colour, sizeof FAULTS[k].colour);
    }
    memcpy(scene->colour[CLOD_SCENE_LINE], LINE, sizeof LINE);
    return true;
}

/** Mark the edges of the facets that are shown; count[m]: so many of each kind. */
static bool mark_edges(clod_scene *scene, const clod_mesh_view *view,
                       const clod_picture_mesh *options, size_t count[MARKS])
{
    scene->mark = clod_memory_alloc(3 * view->facet_count, sizeof *scene->mark);
    scene->ink = clod_memory_alloc(3 * view->facet_count, sizeof *scene->ink);
    if (scene->mark == NULL || scene->ink == NULL) {
        return false;
    }
    for (size_t e = 0; e < 3 * view->facet_count; e++) {
        const size_t f = e / 3, c = e % 3;
        for (int m = 0; m < MARKS && !is_hidden(view, f, options); m++) {
            if (view->edges[f][c] == EDGES[m].edge) {
                const size_t at = scene->marks++;
                memcpy(scene->mark[at][0], view->vertices[view->facets[f][c]],
                       sizeof scene->mark[at][0]);
                memcpy(scene->mark[at][1], view->vertices[view->facets[f][(c + 1) % 3]],
                       sizeof scene->mark[at][1]);
                scene->ink[at] = (uint16_t)(CLOD_SCENE_MARK + m);
                count[m]++;
            }
        }
    }
    for (int m = 0; m < MARKS; m++) {
        memcpy(scene->colour[CLOD_SCENE_MARK + m], EDGES[m].colour, sizeof EDGES[m].colour);
    }
    return true;
}

/** Begin a list of kinds. */
static void begin_bar(drawing *self, const char *title)
{
    clod_page_bar *bar = &self->bar[self->bars++];
    snprintf(bar->axis.title, sizeof bar->axis.title, "%s", title);
    bar->name = self->name + self->kinds;
    bar->colour = self->colour + self->kinds;
}

static void add_kind(drawing *self, const double colour[3], const char *text, size_t number)
{
    const size_t k = self->kinds++;
    self->bar[self->bars - 1].kinds++;
    snprintf(self->text[k], KIND_TEXT, "%s (%zu)", text, number);
    self->name[k] = self->text[k];
    memcpy(self->colour[k], colour, sizeof self->colour[k]);
}

/** The legend: faults that occur, facets that are not there any more, and edges that are marked. */
static void make_legend(drawing *self, const size_t *count, const size_t *marks,
                        const clod_mesh_report *report)
{
    static const double WHITE[3] = {1.0, 1.0, 1.0};
    const size_t dropped = report->findings[CLOD_MESH_DEGENERATE].count;
    begin_bar(self, "facets");
    for (int k = 0; k < CLOD_MESH_FAULTS; k++) {
        if (count[k] > 0) {
            add_kind(self, FAULTS[k].colour, FAULTS[k].text, count[k]);
        }
    }
    if (dropped > 0) {
        add_kind(self, WHITE, "no area: dropped", dropped);
    }
    if (self->scene.marks > 0) {
        begin_bar(self, "edges");
    }
    for (int m = 0; m < MARKS; m++) {
        if (marks[m] > 0) {
            add_kind(self, EDGES[m].colour, EDGES[m].text, marks[m]);
        }
    }
}

/** A camera from which all is seen. */
static clod_camera make_camera(const drawing *self, const clod_mesh_report *report, int view)
{
    const clod_page_box *panel = &self->page.panel[0];
    const double *low = report->box[0], *high = report->box[1];
    const clod_vec3 middle = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]),
                              0.5 * (low[2] + high[2])};
    clod_camera camera = clod_camera_make(middle, clod_view_direction(view, low, high), ANGLE,
                                          (double)panel->width / panel->height);
    clod_camera_bounds bounds = CLOD_CAMERA_BOUNDS_NONE;
    camera.half_height /= ROOM;
    camera.half_width /= ROOM;
    for (size_t k = 0; k < 3 * self->scene.triangles; k++) {
        clod_camera_bound(&camera, &bounds, clod_vec3_of(self->scene.corner[k / 3][k % 3]),
                          0.0);
    }
    clod_camera_fit(&camera, &bounds);
    camera.half_height *= ROOM;
    camera.half_width *= ROOM;
    return camera;
}

static bool draw(drawing *self, const clod_mesh *mesh, const clod_picture_mesh *options,
                 clod_status *status)
{
    size_t count[CLOD_MESH_FAULTS] = {0}, marks[MARKS] = {0};
    const clod_mesh_view *view = clod_mesh_look(mesh);
    clod_mesh_report report;
    if (!clod_mesh_examine(mesh, 0.0, &report, status)) {
        return false;
    }
    if (!check_hidden(view, options, status)) {
        return false;
    }
    if (!fill_scene(&self->scene, view, options, count) ||
        !mark_edges(&self->scene, view, options, marks)) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture of the mesh.");
    }
    make_legend(self, count, marks, &report);
    if (!clod_faces_make(&self->faces, &self->scene, status) ||
        !clod_page_begin(&self->page, options->width, options->height, 1, self->bar, self->bars,
                         status)) {
        return false;
    }
    const clod_page_box *panel = &self->page.panel[0];
    self->image = clod_memory_alloc((size_t)panel->width * (size_t)panel->height, 3);
    const clod_camera camera = make_camera(self, &report, options->view);
    const clod_tracer_order order = {panel->width, panel->height,
                                     (clod_tracer_quality)options->quality, options->threads};
    if (self->image == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture of the mesh.");
    }
    char under[160];
    snprintf(under, sizeof under, "%zu facet%s, %.4g m x %.4g m x %.4g m",
             self->scene.triangles, clod_plural((double)self->scene.triangles),
             report.box[1][0] - report.box[0][0], report.box[1][1] - report.box[0][1],
             report.box[1][2] - report.box[0][2]);
    if (!clod_tracer_draw(&self->scene, &camera, &order, self->image, status)) {
        return false;
    }
    clod_page_put_image(&self->page, 0, self->image, options->title, under);
    clod_page_put_scale(
        &self->page, 0, &camera,
        clod_vec3_scale(clod_vec3_add(clod_vec3_of(report.box[0]), clod_vec3_of(report.box[1])),
                        0.5));
    clod_page_put_bars(&self->page, self->bar, self->bars);
    return true;
}

bool clod_picture_draw_mesh(const clod_mesh *mesh, const clod_picture_mesh *options,
                            const char *path, clod_status *status)
{
    drawing *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for a picture of the mesh.");
    }
    const bool good =
        draw(self, mesh, options, status) && clod_page_write(&self->page, path, status);
    clod_memory_free(self->image);
    clod_page_fini(&self->page);
    clod_faces_fini(&self->faces);
    clod_scene_fini(&self->scene);
    clod_memory_free(self);
    return good;
}
