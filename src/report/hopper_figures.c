#include "report/hopper_figures.h"

#include <math.h>
#include <stdio.h>

#include "base/memory.h"
#include "hopper/fields.h"
#include "hopper/lines.h"
#include "report/hopper_cells.h"

#define DEGREES 57.295779513082323
#define BLACK 6 ///< of what was measured

// a colour and a dash for each shape, the same in all figures
static const int COLOUR[CLOD_HOPPER_SHAPES] = {[CLOD_RADIAL_CONE] = 0, [CLOD_RADIAL_WEDGE] = 1};
static const clod_figure_style DASH[CLOD_HOPPER_SHAPES] = {
    [CLOD_RADIAL_CONE] = CLOD_FIGURE_DASHED, [CLOD_RADIAL_WEDGE] = CLOD_FIGURE_DOTTED};

/** How a measured curve is shown. */
typedef struct measured {
    const char *name, *title, *text, *unit;
    double factor;
    bool of_wall; ///< over the normal stress at the wall
} measured;

static const measured MEASURED[CLOD_SOLID_CURVES] = {
    [CLOD_SOLID_STRENGTH] = {"flow-function", "Flow function, all measured points",
                             "unconfined yield strength f_c", "kPa", 1e-3, false},
    [CLOD_SOLID_PHI_E] = {"phi-e", "Effective angle of internal friction", "phi_e", "deg",
                          DEGREES, false},
    [CLOD_SOLID_PHI_T] = {"phi-t", "Static angle of internal friction", "phi_t", "deg", DEGREES,
                          false},
    [CLOD_SOLID_RHO] = {"bulk-density", "Bulk density", "bulk density", "kg/m3", 1.0, false},
    [CLOD_SOLID_WALL] = {"wall-yield-locus", "Wall yield locus", "wall shear stress", "kPa",
                         1e-3, true},
};

/** Add from low to high through a point, in both directions; what is not known is left out. */
static void add_bars(clod_figure *figure, int colour, const clod_hopper_value *x,
                     const clod_hopper_value *y)
{
    const double none = (double)NAN;
    const double across[5] = {x->low, x->high, none, x->value, x->value};
    const double up[5] = {y->value, y->value, none, y->low, y->high};
    clod_figure_add(figure, "", CLOD_FIGURE_LINE, colour, 5, across, up, NULL);
}

/** A point of a shape with its intervals. */
static void add_state(clod_figure *figure, int shape, const char *name,
                      const clod_hopper_value *x, const clod_hopper_value *y)
{
    add_bars(figure, COLOUR[shape], x, y);
    clod_figure_add(figure, name, CLOD_FIGURE_HOLLOW, COLOUR[shape], 1, &x->value, &y->value,
                    NULL);
}

/** Add the measured points up to a stress, with one standard error to each side; how many. */
static size_t add_points(clod_figure *figure, const clod_curve *curve, double most)
{
    double *room = clod_memory_alloc(9 * curve->count, sizeof *room);
    if (room == NULL) {
        figure->lost = true;
        return 0;
    }
    double *const y = room + curve->count;
    double *const error = y + curve->count;
    double *const bar = error + curve->count;
    double *const level = bar + 3 * curve->count;
    size_t count = 0;
    for (; count < curve->count && curve->points[count].x <= most; count++) {
        const clod_curve_point *point = &curve->points[count];
        room[count] = point->x;
        y[count] = point->y;
        error[count] = point->y_error;
        bar[3 * count] = point->x - point->x_error;
        bar[3 * count + 1] = point->x + point->x_error;
        bar[3 * count + 2] = (double)NAN;
        level[3 * count] = level[3 * count + 1] = point->y;
        level[3 * count + 2] = (double)NAN;
    }
    clod_figure_add(figure, "", CLOD_FIGURE_LINE, BLACK, 3 * count, bar, level, NULL);
    clod_figure_add(figure, "measured", CLOD_FIGURE_POINTS, BLACK, count, room, y, error);
    clod_memory_free(room);
    return count;
}

static void add_curve(clod_figure *figure, const char *name, const clod_curve *curve,
                      double most)
{
    clod_line line;
    clod_lines_curve(curve, most, &line);
    clod_figure_add(figure, name, CLOD_FIGURE_LINE, BLACK, line.count, line.x, line.y, NULL);
}

/** Flow function and flow factors where they meet. Returns whether all points are in it. */
static bool put_chart(clod_sheet *sheet, const clod_hopper *design)
{
    clod_figure figure;
    const clod_curve *curve = &design->solid.strength;
    const double most = 1.08 * clod_lines_reach(design);
    const double top = 1.5 * clod_curve_at(curve, most);
    clod_figure_init(&figure, "design-chart", "Design chart: flow function and flow factors");
    clod_figure_axis_set(&figure.x, "major principal stress sigma_1", "kPa", 1e-3);
    clod_figure_axis_set(&figure.y, "unconfined yield strength f_c", "kPa", 1e-3);
    figure.from_zero = true;
    add_curve(&figure, "flow function", curve, most);
    const size_t shown = add_points(&figure, curve, most);
    for (int k = 0; k < CLOD_HOPPER_SHAPES; k++) {
        const int s = CLOD_HOPPER_CELLS_SHAPES[k];
        const clod_hopper_value *number = design->shape[s].number;
        const double ff = number[CLOD_HOPPER_FLOW_FACTOR].value;
        const double end = fmin(most, ff * top);
        const double x[2] = {0.0, end};
        const double y[2] = {0.0, end / ff};
        char name[64];
        snprintf(name, sizeof name, "%s, ff = %.3f%s", CLOD_HOPPER_SHAPE_NAMES[s], ff,
                 design->shape[s].design.outcome == CLOD_HOPPER_UNPROVEN
                     ? " (not known to be mass flow)"
                     : "");
        if (isfinite(ff)) {
            clod_figure_add(&figure, name, DASH[s], COLOUR[s], 2, x, y, NULL);
        }
        snprintf(name, sizeof name, "critical state, %s", CLOD_HOPPER_SHAPE_NAMES[s]);
        add_state(&figure, s, name, &number[CLOD_HOPPER_SIGMA_1],
                  &number[CLOD_HOPPER_STRENGTH]);
    }
    snprintf(
        figure.note, sizeof figure.note,
        "An outlet is free of arches where the line of its flow factor is above the flow "
        "function. Bars of critical states: their intervals; of measured points: one standard "
        "error. %zu of %zu measured points lie within this figure.",
        shown, curve->count);
    clod_sheet_figure(sheet, &figure);
    return shown == curve->count;
}

/** Limit of mass flow, and the half angles of the design below it. */
static void put_limits(clod_sheet *sheet, const clod_hopper *design)
{
    clod_figure figure;
    clod_line line;
    char name[64];
    const double phi_e = design->shape[CLOD_RADIAL_CONE].design.design_state.phi_e;
    clod_figure_init(&figure, "half-angle", "Half angle and wall friction");
    clod_figure_axis_set(&figure.x, "half angle", "deg", DEGREES);
    clod_figure_axis_set(&figure.y, "wall friction angle", "deg", DEGREES);
    figure.from_zero = true;
    snprintf(figure.note, sizeof figure.note,
             "Below the limit a cone flows in mass flow. Bars: intervals.");
    snprintf(name, sizeof name, "limit of a cone, phi_e = %.1f deg", DEGREES * phi_e);
    clod_lines_limit(design, &line);
    clod_figure_add(&figure, name, CLOD_FIGURE_LINE, BLACK, line.count, line.x, line.y, NULL);
    for (int k = 0; k < CLOD_HOPPER_SHAPES; k++) {
        const int s = CLOD_HOPPER_CELLS_SHAPES[k];
        const clod_hopper_found *found = &design->shape[s];
        if (found->design.outcome != CLOD_HOPPER_FUNNEL) {
            add_state(&figure, s, CLOD_HOPPER_SHAPE_NAMES[s],
                      &found->number[CLOD_HOPPER_HALF_ANGLE],
                      &found->number[CLOD_HOPPER_DESIGN_PHI_W]);
        }
    }
    clod_sheet_figure(sheet, &figure);
}

/** A measured curve over all its points, and where the design looks at it. */
static void put_measured(clod_sheet *sheet, const clod_hopper *design, int which)
{
    clod_figure figure;
    const measured *as = &MEASURED[which];
    const clod_curve *curve = &design->solid.curves[which];
    const bool value = clod_hopper_cells_value(&design->from, which) != NULL;
    double most = value || curve->count == 0 ? 0.0 : curve->points[curve->count - 1].x;
    clod_figure_init(&figure, as->name, as->title);
    clod_figure_axis_set(&figure.x,
                         as->of_wall ? "wall normal stress" : "major principal stress sigma_1",
                         "kPa", 1e-3);
    clod_figure_axis_set(&figure.y, as->text, as->unit, as->factor);
    figure.from_zero = as->factor == 1e-3; // two stresses
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        const clod_solid_state *state = &design->shape[s].design.state;
        most = fmax(most, as->of_wall ? state->sigma_w : state->sigma_1);
    }
    if (curve->count == 0) {
        return;
    }
    add_curve(&figure, value ? "as the case says" : "curve of the design", curve, 1.05 * most);
    if (!value) {
        add_points(&figure, curve, 1.05 * most);
    }
    for (int k = 0; k < CLOD_HOPPER_SHAPES && which != CLOD_SOLID_PHI_T; k++) {
        const int s = CLOD_HOPPER_CELLS_SHAPES[k];
        const clod_hopper_design *at = &design->shape[s].design;
        const double x = as->of_wall ? at->state.sigma_w : at->state.sigma_1;
        const double y = clod_curve_at(curve, x);
        char name[64];
        snprintf(name, sizeof name, "critical state, %s", CLOD_HOPPER_SHAPE_NAMES[s]);
        if (clod_hopper_is_critical(at)) {
            clod_figure_add(&figure, name, CLOD_FIGURE_HOLLOW, COLOUR[s], 1, &x, &y, NULL);
        }
    }
    clod_sheet_figure(sheet, &figure);
}

/** Share of the samples whose critical outlet is at most so wide. */
static void put_outlets(clod_sheet *sheet, const clod_hopper *design)
{
    clod_figure figure;
    double share[CLOD_HOPPER_QUANTILES];
    const double tail = 0.5 * (1.0 - design->from.interval.level);
    const double ends[2] = {tail, 1.0 - tail};
    for (int q = 0; q < CLOD_HOPPER_QUANTILES; q++) {
        share[q] = (double)q / (CLOD_HOPPER_QUANTILES - 1);
    }
    clod_figure_init(&figure, "outlets", "Critical outlets of the samples");
    clod_figure_axis_set(&figure.x, "critical outlet", "mm", 1e3);
    clod_figure_axis_set(&figure.y, "share of the samples", "%", 100.0);
    snprintf(
        figure.note, sizeof figure.note,
        "Each sample is a design from values drawn within the errors of what was measured. "
        "Circles: ends of the %.3g %% interval. Samples for which no outlet is large enough "
        "are beyond the right end.",
        100.0 * design->from.interval.level);
    for (int k = 0; k < CLOD_HOPPER_SHAPES; k++) {
        const int s = CLOD_HOPPER_CELLS_SHAPES[k];
        const clod_hopper_found *found = &design->shape[s];
        const clod_hopper_value *outlet = &found->number[CLOD_HOPPER_OUTLET];
        const double x[2] = {outlet->low, outlet->high};
        clod_figure_add(&figure, CLOD_HOPPER_SHAPE_NAMES[s], DASH[s], COLOUR[s],
                        CLOD_HOPPER_QUANTILES, found->quantile, share, NULL);
        clod_figure_add(&figure, "", CLOD_FIGURE_HOLLOW, COLOUR[s], 2, x, ends, NULL);
    }
    clod_sheet_figure(sheet, &figure);
}

void clod_hopper_figures_put(clod_sheet *sheet, const clod_hopper *design)
{
    static const int CURVES[] = {CLOD_SOLID_WALL, CLOD_SOLID_RHO, CLOD_SOLID_PHI_E,
                                 CLOD_SOLID_PHI_T};
    clod_sheet_columns(sheet, true);
    if (!put_chart(sheet, design)) {
        put_measured(sheet, design, CLOD_SOLID_STRENGTH);
    }
    put_limits(sheet, design);
    for (size_t k = 0; k < sizeof CURVES / sizeof CURVES[0]; k++) {
        put_measured(sheet, design, CURVES[k]);
    }
    put_outlets(sheet, design);
    clod_sheet_columns(sheet, false);
}
