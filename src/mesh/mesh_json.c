/**
 * @file mesh_json.c
 * The report of a mesh for programs.
 */

#include <jansson.h>
#include <math.h>

#include "base/given.h"
#include "base/json.h"
#include "mesh/mesh.h"
#include "mesh/mesh_findings.h"

/** A text of a file; null when it is no UTF-8. */
static json_t *text_of(const char *text)
{
    json_t *value = json_string(text);
    return value != NULL ? value : json_null();
}

static json_t *vector_of(const double at[3])
{
    return json_pack("[f, f, f]", at[0], at[1], at[2]);
}

static json_t *parts_of(const clod_mesh *self)
{
    json_t *list = json_array();
    for (size_t p = 0; p < self->view.part_count; p++) {
        const clod_mesh_part *part = &self->view.parts[p];
        json_array_append_new(list, json_pack("{s:o, s:I}", "name", text_of(part->name),
                                              "facets", (json_int_t)part->facets));
    }
    return list;
}

static json_t *edges_of(const clod_mesh_report *report)
{
    json_t *all = json_object();
    for (int e = 0; e < CLOD_MESH_EDGE_KINDS; e++) {
        json_object_set_new(all, CLOD_MESH_EDGES[e],
                            json_integer((json_int_t)report->edges[e]));
    }
    return all;
}

static json_t *finding_of(const clod_mesh *self, int kind, const clod_mesh_finding *finding)
{
    json_t *places = json_array();
    for (size_t k = 0; k < finding->count && k < CLOD_MESH_PLACES; k++) {
        const clod_mesh_place *at = &finding->places[k];
        json_t *place = json_pack("{s:I, s:o, s:o}", "facet", (json_int_t)at->number, "part",
                                  text_of(self->view.parts[at->part].name), "point_m",
                                  vector_of(at->point));
        if (at->other != 0) {
            json_object_set_new(place,
                                kind == CLOD_MESH_CROSSING ? "through_facet" : "over_facet",
                                json_integer((json_int_t)at->other));
        }
        json_array_append_new(places, place);
    }
    return json_pack("{s:s, s:I, s:s, s:o}", "kind", CLOD_MESH_FINDINGS[kind].key, "count",
                     (json_int_t)finding->count, "action", CLOD_MESH_FINDINGS[kind].action,
                     "first", places);
}

static json_t *findings_of(const clod_mesh *self, const clod_mesh_report *report)
{
    json_t *list = json_array();
    for (int k = 0; k < CLOD_MESH_KINDS; k++) {
        if (report->findings[k].count > 0) {
            json_array_append_new(list, finding_of(self, k, &report->findings[k]));
        }
    }
    return list;
}

static json_t *warnings_of(const clod_mesh_report *report)
{
    json_t *list = json_array();
    for (size_t w = 0; w < report->warning_count; w++) {
        json_array_append_new(list, json_string(report->warnings[w]));
    }
    return list;
}

char *clod_mesh_json(const clod_mesh *self, const clod_mesh_report *report)
{
    CLOD_NEED(self);
    CLOD_NEED(report);
    const clod_mesh_view *view = &self->view;
    json_t *all = json_pack(
        "{s:o, s:I, s:I, s:I, s:I, s:b, s:o, s:o, s:f, s:o}", "file", text_of(self->path),
        "facets_read", (json_int_t)report->read_facets, "facets", (json_int_t)view->facet_count,
        "vertices", (json_int_t)view->vertex_count, "pieces", (json_int_t)view->shell_count,
        "closed", report->closed, "box_min_m", vector_of(report->box[0]), "box_max_m",
        vector_of(report->box[1]), "area_m2", report->area, "volume_m3",
        isnan(report->volume) ? json_null() : json_real(report->volume));
    json_object_set_new(all, "edges", edges_of(report));
    json_object_set_new(all, "edge_length_m",
                        json_pack("{s:f, s:f, s:f}", "shortest", report->shortest, "median",
                                  report->median, "longest", report->longest));
    json_object_set_new(all, "weld_distance_m", json_real(report->weld));
    json_object_set_new(all, "grain_radius_m",
                        report->grain_radius > 0.0 ? json_real(report->grain_radius)
                                                   : json_null());
    json_object_set_new(all, "facets_smaller_than_grain",
                        report->grain_radius > 0.0
                            ? json_integer((json_int_t)report->small_facets)
                            : json_null());
    json_object_set_new(all, "parts", parts_of(self));
    json_object_set_new(all, "findings", findings_of(self, report));
    json_object_set_new(all, "warnings", warnings_of(report));
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}
