#include "sim/gauges_plane.h"

#include <inttypes.h>
#include <math.h>

#include "analysis/prose.h"
#include "base/json.h"
#include "base/plural.h"
#include "base/vec3.h"
#include "setup/planes.h"

/** What has passed the plane of a gauge, which has one. */
static const clod_passed *passed_of(const clod_case *from, const clod_state *state,
                                    size_t gauge)
{
    const int number = clod_setup_planes_number(from, &from->gauges[gauge]);
    return &state->planes.passed[number];
}

static clod_gauge_passed count_of(const clod_case *from, const clod_state *state, size_t gauge)
{
    const clod_passed *passed = passed_of(from, state, gauge);
    return (clod_gauge_passed){.time = state->time,
                               .forward = clod_exact_value(&passed->mass[CLOD_PASSED_FORWARD]),
                               .back = clod_exact_value(&passed->mass[CLOD_PASSED_BACK])};
}

static bool has_planes(const clod_case *from)
{
    bool any = false;
    for (size_t k = 0; k < from->gauge_count; k++) {
        any |= from->gauges[k].has_plane;
    }
    return any;
}

void clod_gauges_plane_begin(clod_gauges *self, const clod_case *from, const clod_state *state)
{
    for (size_t k = 0; k < from->gauge_count; k++) {
        if (from->gauges[k].has_plane) {
            self->gauge[k].passed_row = count_of(from, state, k);
        }
    }
}

void clod_gauges_plane_note(clod_gauges *self, const clod_free_moment *now)
{
    if (!has_planes(now->from)) {
        return;
    }
    const int edges = clod_steady_time_edges(&now->steady, now->state->time);
    for (; self->edges < edges; self->edges++) {
        for (size_t k = 0; k < now->from->gauge_count; k++) {
            if (now->from->gauges[k].has_plane) {
                self->gauge[k].passed_edge[self->edges] = count_of(now->from, now->state, k);
            }
        }
    }
}

int64_t clod_gauges_plane_plan(const clod_gauges *self, const clod_case *from,
                               const clod_state *state, const clod_steady_time *steady)
{
    if (!has_planes(from) || self->edges > CLOD_STEADY_BLOCKS) {
        return INT64_MAX;
    }
    const double at = steady->since + (double)self->edges * steady->block;
    const int64_t steps = clod_steady_time_steps(at, state->time, state->dt);
    return steps > 1 ? steps : 1;
}

/** Forward less back, between two moments [kg/s]; NAN when they are one. */
static double flow_between(const clod_gauge_passed *first, const clod_gauge_passed *last)
{
    const double mass = (last->forward - first->forward) - (last->back - first->back);
    return last->time > first->time ? mass / (last->time - first->time) : (double)NAN;
}

int clod_gauges_plane_blocks(const clod_gauges *self, size_t gauge, double *block)
{
    const clod_gauge_passed *edge = self->gauge[gauge].passed_edge;
    const int blocks = self->edges > 0 ? (int)self->edges - 1 : 0;
    for (int b = 0; b < blocks; b++) {
        block[b] = flow_between(&edge[b], &edge[b + 1]);
    }
    return blocks;
}

/** Mean over the blocks, and their standard deviation [kg/s]; NAN without a whole block. */
static void flow_of(const clod_gauges *self, size_t gauge, double told[2])
{
    const clod_gauge_passed *edge = self->gauge[gauge].passed_edge;
    double each[CLOD_STEADY_BLOCKS];
    const int blocks = clod_gauges_plane_blocks(self, gauge, each);
    told[0] = told[1] = (double)NAN;
    if (blocks > 0) {
        told[0] = flow_between(&edge[0], &edge[blocks]);
        told[1] = clod_steady_time_deviation(each, blocks);
    }
}

// ---- the series

const char *clod_gauges_plane_column(size_t k)
{
    static const char *const NAME[CLOD_GAUGES_PLANE_COLUMNS] = {
        "passed_forward [1]", "passed_back [1]", "mass_forward [kg]", "mass_back [kg]",
        "flow_through [kg/s]"};
    return NAME[k];
}

void clod_gauges_plane_row(clod_gauges *self, const clod_free_moment *now, size_t gauge,
                           double *row)
{
    const clod_passed *passed = passed_of(now->from, now->state, gauge);
    const clod_gauge_passed count = count_of(now->from, now->state, gauge);
    row[0] = (double)passed->grains[CLOD_PASSED_FORWARD];
    row[1] = (double)passed->grains[CLOD_PASSED_BACK];
    row[2] = count.forward;
    row[3] = count.back;
    row[4] = flow_between(&self->gauge[gauge].passed_row, &count);
    self->gauge[gauge].passed_row = count;
}

// ---- report and summary

void clod_gauges_plane_report(FILE *out, const clod_gauges *self, const clod_free_moment *now,
                              size_t gauge)
{
    const clod_case_gauge *from = &now->from->gauges[gauge];
    if (!from->has_plane) {
        return;
    }
    const int64_t *grains = passed_of(now->from, now->state, gauge)->grains;
    const clod_gauge_passed count = count_of(now->from, now->state, gauge);
    double flow[2];
    flow_of(self, gauge, flow);
    fprintf(out,
            "  %-21s through %c = %.6g m: %" PRId64 " grain%s, %.6g kg forward; %" PRId64
            " grain%s, %.6g kg back",
            "", "xyz"[clod_vec3_nearest_axis(from->direction)], from -> plane_at,
            grains[CLOD_PASSED_FORWARD], clod_plural((double)grains[CLOD_PASSED_FORWARD]),
            count.forward, grains[CLOD_PASSED_BACK],
            clod_plural((double)grains[CLOD_PASSED_BACK]), count.back);
    if (!isnan(flow[0])) {
        char text[32];
        fprintf(out, "; flow %.4g%s kg/s", flow[0],
                clod_prose_deviation(text, flow[0], flow[1]));
    }
    fputc('\n', out);
}

void clod_gauges_plane_json(json_t *object, const clod_gauges *self,
                            const clod_free_moment *now, size_t gauge)
{
    if (!now->from->gauges[gauge].has_plane) {
        return;
    }
    const int64_t *grains = passed_of(now->from, now->state, gauge)->grains;
    const clod_gauge_passed count = count_of(now->from, now->state, gauge);
    double flow[2];
    flow_of(self, gauge, flow);
    json_object_set_new(object, "passed_forward", json_integer(grains[CLOD_PASSED_FORWARD]));
    json_object_set_new(object, "passed_back", json_integer(grains[CLOD_PASSED_BACK]));
    json_object_set_new(object, "mass_forward_kg", json_real(count.forward));
    json_object_set_new(object, "mass_back_kg", json_real(count.back));
    json_object_set_new(object, "flow_through_kg_per_s",
                        json_pack("{s:o, s:o}", "mean", clod_json_number(flow[0]), "deviation",
                                  clod_json_number(flow[1])));
}

void clod_gauges_plane_paths(const clod_case_gauge *gauge, clod_free_paths *paths)
{
    if (gauge->has_plane) {
        clod_free_paths_add(paths, gauge->name,
                            "passed_forward passed_back mass_forward_kg mass_back_kg "
                            "flow_through_kg_per_s.mean flow_through_kg_per_s.deviation");
    }
}
