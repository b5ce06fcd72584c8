#include "report/flow_figure.h"

#include <stdio.h>

void clod_flow_figure_init(clod_figure *self)
{
    clod_figure_init(self, "flow-function", "Flow function, with Jenike's classes");
    clod_figure_axis_set(&self->x, "major principal stress at consolidation", "kPa", 1e-3);
    clod_figure_axis_set(&self->y, "unconfined yield strength", "kPa", 1e-3);
    self->from_zero = true;
    snprintf(
        self->note, sizeof self->note,
        "Bars: one standard error. ffc below 1: not flowing; 1 to 2: very cohesive; 2 to 4: "
        "cohesive; 4 to 10: easy flowing; above 10: free flowing.");
}

void clod_flow_figure_classes(clod_figure *self, double largest)
{
    static const double BORDERS[] = {1.0, 2.0, 4.0, 10.0};
    static const clod_figure_style STYLES[] = {CLOD_FIGURE_LINE, CLOD_FIGURE_DASHED,
                                               CLOD_FIGURE_DOTTED, CLOD_FIGURE_DASH_DOT};
    for (int k = 0; k < 4 && largest > 0.0; k++) {
        char name[32];
        const double x[2] = {0.0, 1.1 * largest};
        const double y[2] = {0.0, 1.1 * largest / BORDERS[k]};
        snprintf(name, sizeof name, "ffc = %g", BORDERS[k]);
        clod_figure_add(self, name, STYLES[k], CLOD_FIGURE_GREY, 2, x, y, NULL);
    }
}
