/**
 * @file mesh_text.c
 * The report of a mesh for people.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/given.h"
#include "base/memory.h"
#include "base/plural.h"
#include "base/text.h"
#include "mesh/mesh.h"
#include "mesh/mesh_findings.h"

#define PARTS_SHOWN 20
#define WIDTH 88

static void put_size(FILE *out, const clod_mesh *self, const clod_mesh_report *report)
{
    const clod_mesh_view *view = &self->view;
    fprintf(out, "%s: %zu facet%s", self->path, report->read_facets,
            clod_plural((double)report->read_facets));
    if (view->facet_count != report->read_facets) {
        fprintf(out, ", %zu kept", view->facet_count);
    }
    fprintf(out, ", %zu %s, %zu unconnected piece%s, %s\n\n", view->vertex_count,
            view->vertex_count == 1 ? "vertex" : "vertices", view->shell_count,
            clod_plural((double)view->shell_count), report->closed ? "closed" : "open");
    fprintf(out, "  box%15s%14s%14s%16s\n", "from [m]", "to [m]", "size [m]", "size [mm]");
    for (int k = 0; k < 3; k++) {
        const double low = report->box[0][k], high = report->box[1][k];
        fprintf(out, "  %c  %15.6g%14.6g%14.6g%16.6g\n", "xyz"[k], low, high, high - low,
                1000.0 * (high - low));
    }
    fprintf(out, "\n  area     %.6g m2\n", report->area);
    if (report->closed) {
        fprintf(out, "  volume   %.6g m3\n", fabs(report->volume));
    } else {
        fputs("  volume   none: the mesh is open\n", out);
    }
    fprintf(out, "  edges    ");
    for (int e = 0; e < CLOD_MESH_EDGE_KINDS; e++) {
        fprintf(out, "%s%zu %s", e > 0 ? ", " : "", report->edges[e],
                e == CLOD_MESH_EDGE_T             ? "on a T"
                : e == CLOD_MESH_EDGE_NONMANIFOLD ? "of three or more facets"
                                                  : CLOD_MESH_EDGES[e]);
    }
    fprintf(out, "\n  lengths  of edges: shortest %.4g mm, median %.4g mm, longest %.4g mm\n",
            1000.0 * report->shortest, 1000.0 * report->median, 1000.0 * report->longest);
    if (report->grain_radius > 0.0) {
        fprintf(out, "  grain    of radius %.4g mm: %zu facet%s smaller than it\n",
                1000.0 * report->grain_radius, report->small_facets,
                report->small_facets == 1 ? " is" : "s are");
    }
}

static void put_parts(FILE *out, const clod_mesh *self)
{
    const clod_mesh_view *view = &self->view;
    fprintf(out, "\n  %zu part%s%10s\n", view->part_count,
            clod_plural((double)view->part_count), "facets");
    for (size_t p = 0; p < view->part_count && p < PARTS_SHOWN; p++) {
        const char *name = view->parts[p].name;
        fprintf(out, "  %12zu  %s\n", view->parts[p].facets,
                name[0] != '\0' ? name : "(without a name)");
    }
    if (view->part_count > PARTS_SHOWN) {
        fprintf(out, "  ... and %zu more\n", view->part_count - PARTS_SHOWN);
    }
}

static void put_places(FILE *out, const clod_mesh *self, int kind,
                       const clod_mesh_finding *finding)
{
    for (size_t k = 0; k < finding->count && k < CLOD_MESH_PLACES; k++) {
        const clod_mesh_place *at = &finding->places[k];
        const char *name = self->view.parts[at->part].name;
        fprintf(out, "      facet %u%s%s at (%.6g, %.6g, %.6g) m", at->number,
                name[0] != '\0' ? " of " : "", name, at->point[0], at->point[1], at->point[2]);
        if (at->other != 0) {
            fprintf(out, ", %s facet %u", kind == CLOD_MESH_CROSSING ? "through" : "over",
                    at->other);
        }
        fputc('\n', out);
    }
    if (finding->count > CLOD_MESH_PLACES) {
        fprintf(out, "      ... and %zu more\n", finding->count - CLOD_MESH_PLACES);
    }
}

static void put_findings(FILE *out, const clod_mesh *self, const clod_mesh_report *report)
{
    size_t kinds = 0;
    fputs("\n  Found\n", out);
    for (int k = 0; k < CLOD_MESH_KINDS; k++) {
        const clod_mesh_finding *finding = &report->findings[k];
        const clod_mesh_words *words = &CLOD_MESH_FINDINGS[k];
        if (finding->count == 0) {
            continue;
        }
        kinds++;
        fprintf(out, "  - %zu %s%s: %s.%s%s\n", finding->count,
                finding->count == 1 ? words->one : words->many, words->what, words->action,
                words->advice[0] != '\0' ? " " : "", words->advice);
        put_places(out, self, k, finding);
    }
    if (kinds == 0) {
        fputs("  nothing of what clod looks for\n", out);
    }
}

/** A text, broken between words; lines after the first are indented. */
static void put_warning(FILE *out, const char *text)
{
    fputs("  - ", out);
    while (strlen(text) > WIDTH) {
        size_t end = WIDTH;
        while (end > 1 && text[end] != ' ') {
            end--;
        }
        fprintf(out, "%.*s\n    ", (int)end, text);
        text += end + 1;
    }
    fprintf(out, "%s\n", text);
}

char *clod_mesh_text(const clod_mesh *self, const clod_mesh_report *report)
{
    CLOD_NEED(self);
    CLOD_NEED(report);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    put_size(out, self, report);
    put_parts(out, self);
    put_findings(out, self, report);
    if (report->warning_count > 0) {
        fputs("\n  Warnings\n", out);
    }
    for (size_t w = 0; w < report->warning_count; w++) {
        put_warning(out, report->warnings[w]);
    }
    return clod_text_close(&text);
}

void clod_mesh_free(void *memory)
{
    clod_memory_free(memory);
}
