#include <math.h>

#include "hopper/design.h"
#include "hopper/doubts.h"
#include "hopper/fields.h"
#include "hopper/radial.h"

#define DEGREE (M_PI / 180.0)
#define STEEPER (1.0 * DEGREE) // of phi_w: by so much an extrapolation decides
#define LOWER (0.1 * DEGREE)   // of a limit of mass flow
#define FLATTER (0.5 * DEGREE) // of a limit, of a margin of some 3 deg
#define MOST_PHI_E (80.0 * DEGREE)
#define ROUNDS 20 // until sigma_1 and phi_e fit

/**
 * Whether the wall friction angle of a state lies above that of the smallest measured stress since the
 * line is followed below it.
 */
static bool is_extrapolated(const clod_curve *wall, const clod_solid_state *state)
{
    return wall->count > 1 && state->sigma_w < wall->points[0].x &&
           state->phi_w > atan2(wall->points[0].y, wall->points[0].x) + STEEPER;
}

static void warn_intercept(clod_hopper *self, const char *name, const char *what,
                           const clod_solid_state *state)
{
    const clod_curve *wall = &self->solid.wall;
    const clod_curve_point *first = &wall->points[0];
    clod_warning_list_add(
        &self->warnings,
        "%s: %s rests on the intercept of the wall yield locus, %.3f kPa: it makes a wall friction "
        "angle of %.1f deg at a normal stress of %.3f kPa, below what was measured, where it is %.1f "
        "deg at %.3f kPa. Measure the wall at smaller stresses.",
        name, what, 1e-3 * clod_curve_at(wall, 0.0),
        clod_solid_wall_angle(&self->solid, state->sigma_w) / DEGREE, 1e-3 * state->sigma_w,
        atan2(first->y, first->x) / DEGREE, 1e-3 * first->x);
}

/**
 * sigma_1 in flow where the wall feels a normal stress: sigma_w (1 + s)/(1 + s cos 2 beta). Where the solid does not
 * slide along it, that where it would come to rest: beta is 45 deg.
 */
static double sigma_1_of(const clod_solid *solid, double sigma_w)
{
    const double phi_w = clod_solid_wall_angle(solid, sigma_w);
    double sigma_1 = sigma_w;
    for (int round = 0; round < ROUNDS; round++) { // phi_e hardly depends on sigma_1
        const double phi_e = clod_curve_at(&solid->phi_e, sigma_1);
        const double beta = clod_radial_beta(phi_e, phi_w);
        const double cosine = beta >= 0.0 ? cos(2.0 * beta) : 0.0;
        sigma_1 = sigma_w * (1.0 + sin(phi_e)) / (1.0 + sin(phi_e) * cosine);
    }
    return sigma_1;
}

/** By how much a limit that is given lies above that of a cone where it must be right; 0: none is given. */
static double lift_of(const clod_hopper *self, const clod_hopper_found *found)
{
    return found->wish.limit > 0.0
               ? found->wish.limit - clod_hopper_limit_at(&self->solid,
                                                          found->design.design_state.sigma_1,
                                                          CLOD_RADIAL_TOLERANCE)
               : 0.0;
}

/** What a limit is of. */
static const char *of_what(const clod_hopper_found *found)
{
    return found->wish.limit > 0.0 ? ", if that of a wedge changes as a cone's does,"
                                   : " in a cone";
}

/**
 * The stress above that of the outlet at which the limit of mass flow is lowest, of those of the flow function and of
 * those at which the wall feels what it was measured at.
 */
static double lowest(const clod_hopper *self, const clod_hopper_found *found, double *limit)
{
    const clod_hopper_design *at = &found->design;
    const double lift = lift_of(self, found);
    double stress = 0.0;
    const int curves[] = {CLOD_SOLID_STRENGTH, CLOD_SOLID_WALL};
    for (int c = 0; c < 2; c++) {
        const clod_curve *curve = &self->solid.curves[curves[c]];
        for (size_t i = 0; i < curve->count && curve->count > 1; i++) {
            const double x = curve->points[i].x;
            const double sigma_1 = c == 0 ? x : sigma_1_of(&self->solid, x);
            const double there =
                sigma_1 > at->design_state.sigma_1
                    ? lift + clod_hopper_limit_at(&self->solid, sigma_1, CLOD_RADIAL_TOLERANCE)
                    : *limit;
            if (there < *limit) {
                *limit = there;
                stress = sigma_1;
            }
        }
    }
    return stress;
}

/** Stresses grow upwards from the outlet; where the limit falls with them, the hopper is too flat. */
static void warn_upwards(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    double limit = fmin(at->limit, at->half_angle + found->wish.margin) - LOWER;
    const double stress = lowest(self, found, &limit);
    if (stress > 0.0) {
        clod_warning_list_add(
            &self->warnings,
            "%s: higher in the hopper, where sigma_1 is %.3f kPa, the limit of mass flow%s is "
            "%.1f deg, less than at the outlet, %.1f deg. A hopper that reaches there needs a half "
            "angle below %.1f deg.",
            name, 1e-3 * stress, of_what(found), limit / DEGREE, at->limit / DEGREE,
            fmax(0.0, limit - found->wish.margin) / DEGREE);
    }
}

/** phi_e below the smallest measured stress, if it goes on as between that and the next that is clearly apart; NAN:
 *  there is none. */
static double going_on(const clod_curve *phi_e, double sigma_1)
{
    const clod_curve_point *first = &phi_e->points[0];
    const clod_curve_point *end = first + phi_e->count, *next = first + 1;
    while (next < end && next->x < CLOD_DOUBTS_SLOPE * first->x) {
        next++;
    }
    if (next == end) {
        return (double)NAN;
    }
    const double slope = (next->y - first->y) / (next->x - first->x);
    return fmin(first->y + slope * (sigma_1 - first->x), MOST_PHI_E);
}

/** Below the smallest measured stress phi_e is held. It may go on rising there, and then the hopper is too flat. */
static void warn_friction(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    const clod_curve *phi_e = &self->solid.phi_e;
    const double sigma_1 = at->design_state.sigma_1;
    if (phi_e->count < 2 || sigma_1 >= phi_e->points[0].x) {
        return;
    }
    clod_curve_point there = {.x = sigma_1, .y = going_on(phi_e, sigma_1)};
    if (isnan(there.y)) {
        return;
    }
    clod_solid other = self->solid;
    other.phi_e = (clod_curve){.way = CLOD_CURVE_HELD, .points = &there, .count = 1};
    const double limit =
        lift_of(self, found) + clod_hopper_limit_at(&other, sigma_1, CLOD_RADIAL_TOLERANCE);
    if (limit < fmin(at->limit, at->half_angle + found->wish.margin) - FLATTER) {
        clod_warning_list_add(
            &self->warnings,
            "%s: phi_e rises towards small stresses, to %.1f deg at the smallest measured sigma_1, "
            "%.3f kPa, and is held there below it. If it goes on as between the two smallest, it is "
            "%.1f deg at %.3f kPa, where the half angle must be right, and the limit of mass flow%s "
            "%.1f deg in place of %.1f deg. Measure at smaller stresses, or stay below %.1f deg.",
            name, phi_e->points[0].y / DEGREE, 1e-3 * phi_e->points[0].x, there.y / DEGREE,
            1e-3 * sigma_1, of_what(found), limit / DEGREE, at->limit / DEGREE,
            fmax(0.0, limit - found->wish.margin) / DEGREE);
    }
}

/** Nothing but the range of the tests chose the stress of the half angle. */
static void warn_measured(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    clod_warning_list_add(
        &self->warnings,
        "%s: at the stresses of a critical outlet the wall holds the solid. So the half angle is that "
        "for the smallest measured sigma_1, %.3f kPa, and the critical outlet that of this half angle: "
        "tests at other stresses would give another pair. Give %s.outlet, the outlet that is built.",
        name, 1e-3 * at->design_state.sigma_1, CLOD_HOPPER_SHAPE_NAMES[found->wish.shape]);
}

void clod_doubts_wall(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    const clod_hopper_design *at = &found->design;
    const clod_curve *wall = &self->solid.wall;
    const bool mass_flow = clod_hopper_is_mass_flow(at);
    if (at->sticks && is_extrapolated(wall, &at->state)) {
        warn_intercept(self, name, "the critical outlet", &at->state);
    }
    if (at->outcome == CLOD_HOPPER_FUNNEL && is_extrapolated(wall, &at->design_state)) {
        warn_intercept(self, name, "funnel flow", &at->design_state);
    } else if (is_extrapolated(wall, &at->design_state) &&
               !(at->sticks && at->design_state.sigma_1 == at->state.sigma_1)) {
        warn_intercept(self, name, "the limit of mass flow", &at->design_state);
    }
    if (at->at_measured) {
        warn_measured(self, name, found);
    }
    if (mass_flow && at->limit > 0.0) {
        warn_upwards(self, name, found);
        warn_friction(self, name, found);
    }
}
