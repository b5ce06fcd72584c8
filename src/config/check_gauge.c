// Rules for gauges, and for the time from which means count.

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/vec3.h"
#include "config/check.h"
#include "config/region.h"

/** Cosine of the angle between two directions below which they are at right angles. */
#define ACROSS 1e-6

static void fail(clod_loader *loader, const clod_case_gauge *gauge, const char *key,
                 const char *text)
{
    char path[CLOD_LOAD_PATH];
    snprintf(path, sizeof path, "gauges.%s%s%s", gauge->name, key[0] == '\0' ? "" : ".", key);
    clod_check_fail(loader, path, "%s", text);
}

static bool is_given(const double v[3])
{
    return v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0;
}

static double cosine(const double a[3], const double b[3])
{
    return clod_vec3_dot(clod_vec3_unit(clod_vec3_of(a)), clod_vec3_unit(clod_vec3_of(b)));
}

static void check_directions(clod_loader *loader, const clod_case *self,
                             const clod_case_gauge *gauge)
{
    const double *n = gauge->direction;
    const bool bins = gauge->profile_bins > 0 || gauge->trajectory_bins > 0;
    const char *which = gauge->profile_bins > 0 ? "profile" : "trajectory";
    if (!is_given(n)) {
        if (bins) {
            fail(loader, gauge, which,
                 "needs the direction of the stream, for instance direction: [1, 0, 0]");
        }
        return;
    }
    if (clod_region_row(&gauge->region)->upright && fabs(n[2]) < fmax(fabs(n[0]), fabs(n[1]))) {
        fail(loader, gauge, "direction",
             "an upright annulus or cylinder measures a stream that goes through its top and "
             "bottom; where it is more level than upright, make the region a box");
    }
    if (is_given(gauge->across)) {
        if (fabs(cosine(n, gauge->across)) > ACROSS) {
            fail(loader, gauge, "across", "must be at right angles to direction");
        }
    } else if (bins &&
               (!is_given(self->gravity) || fabs(cosine(n, self->gravity)) > 1.0 - ACROSS)) {
        fail(loader, gauge, which,
             "no level direction is across the stream: direction is upright, or there is no "
             "gravity; give one, for instance across: [0, 1, 0]");
    }
}

static void check_plane(clod_loader *loader, const clod_case *self,
                        const clod_case_gauge *gauge)
{
    if (!gauge->has_plane) {
        return;
    }
    if (!is_given(gauge->direction)) {
        fail(loader, gauge, "plane",
             "needs the direction in which grains pass it forward, for instance "
             "direction: [1, 0, 0]");
        return;
    }
    const int a = clod_vec3_nearest_axis(gauge->direction);
    const double at = gauge->plane_at;
    double low[3], high[3];
    char text[320];
    clod_region_bounds(&gauge->region, low, high);
    if (at < low[a] || at > high[a]) {
        snprintf(
            text, sizeof text,
            "is outside of the region: along %c, the axis nearest to direction, that "
            "reaches from %.9g m to %.9g m; put the plane there, or make the region larger",
            "xyz"[a], low[a], high[a]);
        fail(loader, gauge, "plane.at", text);
    } else if (self->has_domain && (at < self->domain_min[a] || at > self->domain_max[a])) {
        snprintf(text, sizeof text,
                 "is outside of the domain, so no grain passes it: along %c, the axis nearest "
                 "to direction, the domain reaches from %.9g m to %.9g m",
                 "xyz"[a], self -> domain_min[a], self -> domain_max[a]);
        fail(loader, gauge, "plane.at", text);
    }
}

static void check_belt(clod_loader *loader, const clod_case *self, const clod_case_gauge *gauge)
{
    if (gauge->belt == NULL) {
        return;
    }
    for (size_t w = 0; w < self->wall_count; w++) {
        if (clod_check_has_belt(&self->walls[w]) &&
            strcmp(self->walls[w].name, gauge->belt) == 0) {
            return;
        }
    }
    char text[480], names[280];
    snprintf(text, sizeof text, "there is no wall %.100s with a belt among its shapes%s",
             gauge->belt, clod_check_walls_text(self, gauge->belt, true, names, sizeof names));
    fail(loader, gauge, "belt", text);
}

/** Whether the means begin before the run ends. */
static void check_since(clod_loader *loader, const clod_case *self)
{
    double whole = 0.0;
    for (size_t s = 0; s < self->stage_count; s++) {
        whole += self->stages[s].duration;
    }
    if (self->output.has_steady_since && self->stage_count > 0 &&
        self->output.steady_since >= whole) {
        clod_check_fail(loader, "output.steady_since",
                        "must be before the end of the run: its stages last %.6g s together",
                        whole);
    }
}

void clod_check_gauges(clod_loader *loader, const clod_case *self)
{
    for (size_t k = 0; k < self->gauge_count; k++) {
        const clod_case_gauge *gauge = &self->gauges[k];
        char path[CLOD_LOAD_PATH];
        snprintf(path, sizeof path, "gauges.%s", gauge->name);
        if (clod_report_clean(loader->report, path)) {
            clod_check_region(loader, path, &gauge->region);
            check_directions(loader, self, gauge);
            check_plane(loader, self, gauge);
            check_belt(loader, self, gauge);
        }
    }
    if (self->gauge_count > CLOD_CASE_GAUGES) {
        clod_check_fail(loader, "gauges", "has %zu gauges; at most %d", self->gauge_count,
                        CLOD_CASE_GAUGES);
    }
    if (clod_report_clean(loader->report, "stages")) {
        check_since(loader, self);
    }
}
