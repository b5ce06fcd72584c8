/**
 * @file chart.c
 * The design chart: the flow function with the flow factors of both shapes, and the limit of mass
 * flow over the wall friction angle.
 */

#include <math.h>
#include <stdio.h>

#include "base/given.h"
#include "base/text.h"
#include "hopper/fields.h"
#include "hopper/lines.h"
#include "hopper/plot.h"

#define DEGREES 57.295779513082323
#define BLACK "#222222"

// Okabe and Ito's colours, which the colour-blind tell apart
static const char *const COLOURS[CLOD_HOPPER_SHAPES] = {
    [CLOD_RADIAL_WEDGE] = "#D55E00", [CLOD_RADIAL_CONE] = "#0072B2"};

/** Ends of the axes of the flow function, kPa. */
static void reach(const clod_hopper *self, clod_plot *panel)
{
    panel->most_x = clod_plot_round_up(1.08e-3 * clod_lines_reach(self));
    panel->most_y = 1.5e-3 * clod_curve_at(&self->solid.strength, 1e3 * panel->most_x);
    panel->most_y = clod_plot_round_up(fmax(panel->most_y, 1e-6));
}

/** A line in SI units, times a scale on both axes. */
static void put_line(const clod_plot *panel, const clod_line *line, double scale,
                     const clod_plot_pen *pen)
{
    clod_plot_point points[CLOD_LINES_MOST];
    for (size_t k = 0; k < line->count; k++) {
        points[k] = (clod_plot_point){scale * line->x[k], scale * line->y[k]};
    }
    clod_plot_line(panel, points, line->count, pen);
}

/** A pair of numbers with their intervals. */
static void put_state(const clod_plot *panel, int s, const clod_hopper_value *x,
                      const clod_hopper_value *y, double scale)
{
    clod_plot_mark(panel, (clod_plot_point){scale * x->value, scale * y->value},
                   (clod_plot_point){scale * x->low, scale * y->low},
                   (clod_plot_point){scale * x->high, scale * y->high}, COLOURS[s]);
}

static void put_flow_factor(const clod_hopper *self, int s, const clod_plot *panel)
{
    const clod_hopper_found *found = &self->shape[s];
    const double flow_factor = found->number[CLOD_HOPPER_FLOW_FACTOR].value;
    const clod_plot_pen pen = {COLOURS[s], 2.0, true};
    char text[64];
    if (isnan(flow_factor)) {
        snprintf(text, sizeof text, "%s: funnel flow", CLOD_HOPPER_SHAPE_NAMES[s]);
    } else {
        snprintf(text, sizeof text, "%s, ff = %.2f%s", CLOD_HOPPER_SHAPE_NAMES[s], flow_factor,
                 found->design.outcome == CLOD_HOPPER_UNPROVEN ? " (not known to be mass flow)"
                                                               : "");
        const clod_plot_point ray[] = {{0.0, 0.0},
                                       {panel->most_x, panel->most_x / flow_factor}};
        clod_plot_line(panel, ray, 2, &pen);
    }
    clod_plot_legend(panel, s == CLOD_RADIAL_CONE ? 1 : 2, &pen, text);
    const clod_hopper_value *sigma_1 = &found->number[CLOD_HOPPER_SIGMA_1];
    const clod_hopper_value *strength = &found->number[CLOD_HOPPER_STRENGTH];
    if (!isnan(sigma_1->value)) {
        put_state(panel, s, sigma_1, strength, 1e-3);
    }
}

/** Say which measured points are not in the panel: far ones would press critical states into its corner. */
static void put_outside(const clod_curve *curve, const clod_plot *panel)
{
    size_t outside = 0;
    for (size_t i = 0; i < curve->count; i++) {
        outside += 1e-3 * curve->points[i].x > panel->most_x ||
                   1e-3 * curve->points[i].y > panel->most_y;
    }
    if (outside > 0) {
        char text[192];
        snprintf(text, sizeof text,
                 "%zu of %zu measured points outside; measured up to %.4g kPa", outside,
                 curve->count, 1e-3 * curve->points[curve->count - 1].x);
        clod_plot_note(panel, text);
    }
}

static void put_flow_function(const clod_hopper *self, clod_plot *panel)
{
    const clod_curve *curve = &self->solid.strength;
    const clod_plot_pen pen = {BLACK, 2.0, false};
    clod_line line;
    clod_lines_curve(curve, 1e3 * panel->most_x, &line);
    clod_plot_axes(panel, "sigma_1, kPa", "f_c, kPa");
    put_line(panel, &line, 1e-3, &pen);
    clod_plot_legend(panel, 0, &pen, "flow function");
    for (size_t i = 0; i < curve->count; i++) {
        const clod_curve_point *point = &curve->points[i];
        const double dx = point->x_error;
        const double dy = point->y_error;
        clod_plot_mark(panel, (clod_plot_point){1e-3 * point->x, 1e-3 * point->y},
                       (clod_plot_point){1e-3 * (point->x - dx), 1e-3 * (point->y - dy)},
                       (clod_plot_point){1e-3 * (point->x + dx), 1e-3 * (point->y + dy)},
                       BLACK);
    }
    put_flow_factor(self, CLOD_RADIAL_CONE, panel);
    put_flow_factor(self, CLOD_RADIAL_WEDGE, panel);
    put_outside(curve, panel);
}

/** Limit of mass flow over the wall friction angle, at the effective angle of the cone's state. */
static void put_limits(const clod_hopper *self, clod_plot *panel)
{
    const double phi_e = self->shape[CLOD_RADIAL_CONE].design.design_state.phi_e;
    const clod_plot_pen pen = {BLACK, 2.0, false};
    char text[64];
    snprintf(text, sizeof text, "limit of a cone, phi_e = %.1f deg", DEGREES * phi_e);
    clod_plot_axes(panel, "half angle, deg", "wall friction angle, deg");
    clod_plot_legend(panel, 0, &pen, text);
    clod_line line;
    clod_lines_limit(self, &line);
    put_line(panel, &line, DEGREES, &pen);
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        const clod_hopper_value *angle = &self->shape[s].number[CLOD_HOPPER_HALF_ANGLE];
        const clod_hopper_design *at = &self->shape[s].design;
        const clod_hopper_value *wall = &self->shape[s].number[CLOD_HOPPER_DESIGN_PHI_W];
        if (at->outcome != CLOD_HOPPER_FUNNEL) {
            put_state(panel, s, angle, wall, DEGREES);
        }
    }
}

char *clod_hopper_chart(const clod_hopper *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    clod_plot flow = {out, 70.0, 45.0, 400.0, 330.0, 1.0, 1.0};
    clod_plot limits = {out, 560.0, 45.0, 400.0, 330.0, 60.0, 50.0};
    clod_plot_begin(out, 990, 440, self->from.title != NULL ? self->from.title : "Hopper");
    reach(self, &flow);
    put_flow_function(self, &flow);
    put_limits(self, &limits);
    clod_plot_end(out);
    return clod_text_close(&text);
}
