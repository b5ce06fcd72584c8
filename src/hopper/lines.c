#include "hopper/lines.h"

#include <math.h>

double clod_lines_reach(const clod_hopper *self)
{
    const clod_curve *curve = &self->solid.strength;
    double critical = 0.0;
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        critical = fmax(critical, self->shape[s].number[CLOD_HOPPER_SIGMA_1].value);
    }
    const double last = curve->points[curve->count - 1].x;
    const double near = critical > 0.0 ? fmax(3.0 * critical, curve->points[1].x) : last;
    return last < 2.0 * near ? fmax(near, last) : near;
}

void clod_lines_curve(const clod_curve *curve, double most, clod_line *line)
{
    line->count = CLOD_LINES_MOST;
    for (size_t k = 0; k < CLOD_LINES_MOST; k++) {
        line->x[k] = most * (double)k / (CLOD_LINES_MOST - 1);
        line->y[k] = clod_curve_at(curve, line->x[k]);
    }
}

void clod_lines_limit(const clod_hopper *self, clod_line *line)
{
    const double phi_e = self->shape[CLOD_RADIAL_CONE].design.design_state.phi_e;
    line->count = 0;
    for (size_t k = 0; k < CLOD_LINES_MOST; k++) {
        const double phi_w = phi_e * (double)k / (CLOD_LINES_MOST - 1);
        const clod_radial field = {CLOD_RADIAL_CONE, phi_e, phi_w, CLOD_RADIAL_TOLERANCE};
        double theta;
        if (clod_radial_limit(&field, &theta)) {
            line->x[line->count] = theta;
            line->y[line->count++] = phi_w;
        }
    }
}
