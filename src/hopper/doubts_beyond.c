/**
 * @file doubts_beyond.c
 * Stresses outside what was measured, where a design rests on an extrapolation.
 */

#include <math.h>
#include <stdio.h>

#include "hopper/doubts.h"
#include "hopper/fields.h"

#define PLACES 4
#define FAR 10.0   // times the largest measured stress: a length in another unit, as a rule
#define SLIDES 1.5 // rad: of a wall along which the solid slides phi_w is below
#define TEXT 256   // bytes

/** Where in a hopper a stress is. */
typedef struct place {
    char where[64]; ///< "at the critical outlet"
    double outlet;  ///< m; 0: the critical one, or none
    double sigma_1, sigma_w;
} place;

/** The stresses of all places that lie outside those of a curve, in one warning. */
static void warn_beyond(clod_hopper *self, const char *name, const clod_curve *curve,
                        const char *what, const place *at, const double *stress, size_t count)
{
    char text[TEXT] = "";
    size_t used = 0;
    if (curve->count < 2) {
        return;
    }
    const double low = curve->points[0].x, high = curve->points[curve->count - 1].x;
    for (size_t k = 0; k < count; k++) {
        if (stress[k] < low * (1.0 - CLOD_DOUBTS_APART) ||
            stress[k] > high * (1.0 + CLOD_DOUBTS_APART)) {
            const int more = used == 0 ? snprintf(text, TEXT, "%s %s is %.3f kPa", at[k].where,
                                                  what, 1e-3 * stress[k])
                                       : snprintf(text + used, TEXT - used, ", and %s %.3f kPa",
                                                  at[k].where, 1e-3 * stress[k]);
            used += (size_t)more;
        }
    }
    if (used > 0) {
        clod_warning_list_add(
            &self->warnings,
            "%s: %s, outside what was measured, %.3f to %.3f kPa: an extrapolation.", name,
            text, 1e-3 * low, 1e-3 * high);
    }
}

/** One more place: an outlet of this diameter or width and state; 0: the critical one. */
static void add(place at[PLACES], size_t *count, double outlet, const clod_solid_state *state)
{
    place *to = &at[(*count)++];
    to->outlet = outlet;
    if (outlet > 0.0) {
        snprintf(to->where, sizeof to->where, "at the outlet of %.6g mm", 1e3 * outlet);
    } else {
        snprintf(to->where, sizeof to->where, "at the critical outlet");
    }
    to->sigma_1 = state->sigma_1;
    to->sigma_w = state->phi_w < SLIDES ? state->sigma_w : (double)NAN;
}

/** The state at the outlet that is given, in flow at the half angle of the design. */
static clod_solid_state planned_of(const clod_hopper *self, const clod_hopper_found *found)
{
    clod_hopper_wish wish = found->wish;
    wish.half_angle = found->design.half_angle;
    wish.first = found->design.design_state.sigma_1;
    return clod_hopper_margin_of(&self->solid, &wish, found->planned).state;
}

/** An outlet with a stress that hardly any hopper has, beside those that were measured. */
static void warn_far(clod_hopper *self, const char *name, const clod_hopper_found *found,
                     const place *at)
{
    const clod_curve *strength = &self->solid.strength;
    const double times = at->sigma_1 / strength->points[strength->count - 1].x;
    if (times > FAR && at->outlet > 0.0) {
        clod_warning_list_add(
            &self->warnings,
            "%s: %s sigma_1 is %.0f times the largest that was measured. Is the unit of %s "
            "another one?",
            name, at->where, times,
            at->outlet == found->planned ? "the outlet" : "the largest particle");
    }
}

/** Where a shape has outlets, and with which stresses; how many. */
static size_t places_of(const clod_hopper *self, const clod_hopper_found *found,
                        place at[PLACES])
{
    const clod_hopper_design *design = &found->design;
    size_t count = 0;
    const bool flows =
        design->outcome != CLOD_HOPPER_FUNNEL && design->outcome != CLOD_HOPPER_UNSETTLED;
    if (flows && clod_hopper_is_critical(design)) {
        add(at, &count, 0.0, &design->state);
    }
    if (flows && design->built > 0.0 && !(design->built == design->outlet)) {
        add(at, &count, design->built, &design->design_state);
    }
    if (flows && !isnan(found->number[CLOD_HOPPER_MARGIN].value) &&
        found->planned != design->built) {
        const clod_solid_state planned = planned_of(self, found);
        add(at, &count, found->planned, &planned);
    }
    if (found->wish.shape == CLOD_RADIAL_WEDGE && self->slot.state.sigma_1 > 0.0) {
        at[count++] = (place){.where = "for a slot in funnel flow",
                              .sigma_1 = self->slot.state.sigma_1,
                              .sigma_w = (double)NAN};
    }
    return count;
}

void clod_doubts_beyond(clod_hopper *self, const char *name, const clod_hopper_found *found)
{
    place at[PLACES];
    double sigma_1[PLACES], sigma_w[PLACES];
    const size_t count = places_of(self, found, at);
    for (size_t k = 0; k < count; k++) {
        sigma_1[k] = at[k].sigma_1;
        sigma_w[k] = at[k].sigma_w;
        warn_far(self, name, found, &at[k]);
    }
    warn_beyond(self, name, &self->solid.strength, "sigma_1", at, sigma_1, count);
    warn_beyond(self, name, &self->solid.wall, "the normal stress at the wall", at, sigma_w,
                count);
}

void clod_doubts_looser(clod_hopper *self)
{
    const clod_curve_point *least = &self->solid.rho.points[0];
    place lowest = {.sigma_1 = (double)INFINITY};
    const char *name = "";
    for (int s = 0; s < CLOD_HOPPER_SHAPES; s++) {
        place at[PLACES];
        const size_t count = places_of(self, &self->shape[s], at);
        for (size_t k = 0; k < count; k++) {
            if (at[k].sigma_1 < lowest.sigma_1) {
                lowest = at[k];
                name = CLOD_HOPPER_SHAPE_NAMES[s];
            }
        }
    }
    if (lowest.sigma_1 <
        least->x * (1.0 - CLOD_DOUBTS_APART)) { // a single value is of no stress, 0
        clod_warning_list_add(
            &self->warnings,
            "Bulk density: %s (%s) sigma_1 is %.3f kPa, below the smallest at which it was measured, %.3f kPa, whose "
            "%.0f kg/m3 is taken there. The solid is looser, and its outlet wider in proportion: give bulk_density "
            "with smaller stresses, or with the loose density at 0 kPa.",
            lowest.where, name, 1e-3 * lowest.sigma_1, 1e-3 * least->x, least->y);
    }
}

void clod_doubts_beyond_holes(clod_hopper *self)
{
    static const place AT[CLOD_HOPPER_HOLES] = {
        [CLOD_HOPPER_EMPTYING] = {.where = "as it empties"},
        [CLOD_HOPPER_FILLING] = {.where = "after filling"}};
    const bool empties = isfinite(self->hole.emptying) && self->hole.emptying > 0.0;
    const double stress[CLOD_HOPPER_HOLES] = {
        [CLOD_HOPPER_EMPTYING] = empties ? self->hole.state.sigma_1 : (double)NAN,
        [CLOD_HOPPER_FILLING] =
            isnan(self->hole.filling) ? (double)NAN : self->hole.filling_stress};
    warn_beyond(self, "Rathole", &self->solid.strength, "sigma_1", AT, stress,
                CLOD_HOPPER_HOLES);
}
