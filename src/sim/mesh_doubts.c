#include "sim/mesh_doubts.h"

#include <stdio.h>
#include <string.h>

#include "clod/mesh.h"
#include "state/shape_kinds.h"

/** What of the doctor's findings a run should hear of; the others change nothing. */
static const struct {
    clod_mesh_kind kind;
    const char *words;
} TOLD[] = {
    {CLOD_MESH_OPEN, "open edges"},
    {CLOD_MESH_NONMANIFOLD, "edges of three or more facets"},
    {CLOD_MESH_TWISTED, "edges where normals cannot agree"},
    {CLOD_MESH_TURNED, "facets turned"},
    {CLOD_MESH_DEGENERATE, "facets without area dropped"},
    {CLOD_MESH_DUPLICATE, "double facets dropped"},
    {CLOD_MESH_OVERLAP, "facets over others in one plane"},
    {CLOD_MESH_CROSSING, "facets through others"},
    {CLOD_MESH_NEEDLE, "needles"},
    {CLOD_MESH_SLIVER, "slivers"},
};

/** The last part of a path. */
static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

/** The findings as one text; false where there are none. */
static bool list_findings(const clod_mesh_report *report, char *text, size_t size)
{
    size_t used = 0;
    for (size_t k = 0; k < sizeof TOLD / sizeof TOLD[0] && used < size; k++) {
        const size_t count = report->findings[TOLD[k].kind].count;
        if (count > 0) {
            used += (size_t)snprintf(text + used, size - used, "%s%zu %s", used > 0 ? ", " : "",
                                     count, TOLD[k].words);
        }
    }
    return used > 0;
}

static bool look(const clod_case_wall *wall, const clod_case_shape *shape, double radius,
                 clod_mesh_doubts_tell tell, void *context, clod_status *status)
{
    clod_mesh_placing placing = {
        .unit = shape->unit, .scale = shape->scale, .rotate = shape->rotate};
    memcpy(placing.move, shape->move, sizeof placing.move);
    clod_mesh *mesh = clod_mesh_read(shape->file, &placing, status);
    clod_mesh_report report;
    const bool good = mesh != NULL && clod_mesh_examine(mesh, radius, &report, status);
    clod_mesh_destroy(&mesh);
    for (size_t k = 0; good && k < report.warning_count; k++) {
        char text[CLOD_MESH_DOUBTS_TEXT];
        snprintf(text, sizeof text, "walls.%s: %s: %s", wall->name, name_of(shape->file),
                 report.warnings[k]);
        if (strstr(text, "point inwards") == NULL) { // a room may hold grains
            tell(context, true, text);
        }
    }
    char list[240];
    if (good && list_findings(&report, list, sizeof list)) {
        char text[CLOD_MESH_DOUBTS_TEXT];
        snprintf(text, sizeof text, "walls.%s: %s has %s; `clod mesh` says where", wall->name,
                 name_of(shape->file), list);
        tell(context, false, text);
    }
    return good;
}

bool clod_mesh_doubts(const clod_case *from, double radius, clod_mesh_doubts_tell tell,
                      void *context, clod_status *status)
{
    for (size_t w = 0; w < from->wall_count; w++) {
        const clod_case_wall *wall = &from->walls[w];
        for (size_t s = 0; s < wall->shape_count; s++) {
            if (clod_shape_kinds_row((clod_shape_kind)wall->shapes[s].kind)->file &&
                !look(wall, &wall->shapes[s], radius, tell, context, status)) {
                return false;
            }
        }
    }
    return true;
}
