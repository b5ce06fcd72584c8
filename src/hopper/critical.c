#include "hopper/critical.h"

#include <math.h>

#include "hopper/bracket.h"

#define QUICK 20                      ///< rounds after which bounds are halved
#define NEAREST (0.05 * M_PI / 180.0) ///< rad below a limit: nearer to it the search may miss q

double clod_critical_below(double limit, double margin)
{
    return limit - fmax(margin, NEAREST);
}

double clod_critical_limit(const clod_solid_state *state, double tolerance)
{
    const clod_radial cone = {CLOD_RADIAL_CONE, state->phi_e, state->phi_w, tolerance};
    double limit;
    return clod_radial_limit(&cone, &limit) ? limit : 0.0;
}

bool clod_critical_shape(const clod_solid *solid, const clod_hopper_wish *wish, double sigma_1,
                         clod_hopper_design *self)
{
    self->state = clod_solid_at(solid, sigma_1);
    self->half_angle = wish->half_angle;
    if (wish->half_angle == 0.0) {
        self->limit = clod_critical_limit(&self->state, wish->tolerance);
        self->half_angle = clod_critical_below(self->limit, wish->margin);
    }
    const clod_radial field = {wish->shape, self->state.phi_e, self->state.phi_w,
                               wish->tolerance};
    clod_radial_wall wall;
    if (self->half_angle <= 0.0 ||
        !clod_radial_solve_near(&field, self->half_angle, self->axis, &wall)) {
        return false;
    }
    self->axis = wall.axis;
    self->arch = clod_hopper_arch_thickness(wish->arch, wish->shape, self->half_angle);
    self->flow_factor = self->arch * wall.sigma_1 / (2.0 * sin(self->half_angle));
    return true;
}

double clod_critical_outlet(const clod_hopper_design *at)
{
    return at->state.sigma_1 / at->flow_factor * at->arch /
           (at->state.rho * CLOD_HOPPER_GRAVITY);
}

/** The stress to look at where the strength stays on one side: the end it tends to. */
static double end_of(const clod_solid *solid, clod_curve_meeting meeting)
{
    return meeting == CLOD_CURVE_BELOW ? solid->strength.points[0].x : clod_solid_end(solid);
}

/**
 * One round: the state at sigma_1 has a flow factor, and that another sigma_1: where an arch stands one above, else
 * one below, each the largest.
 */
static clod_curve_meeting go_on(const clod_solid *solid, const clod_hopper_design *self,
                                clod_bracket *at)
{
    const bool arches = self->state.strength * self->flow_factor > at->sigma_1;
    const double high = at->high < CLOD_BRACKET_HIGHEST ? at->high : (double)INFINITY;
    double met = 0.0;
    const clod_curve_meeting meeting = clod_curve_meet(
        &solid->strength, 1.0 / self->flow_factor, arches ? high : at->sigma_1, &met);
    if (meeting != CLOD_CURVE_MEETS) {
        met = end_of(solid, meeting);
    }
    clod_bracket_narrow(at, met > at->sigma_1);
    clod_bracket_go(at, met);
    return meeting;
}

/** What a round that meets the flow function, or an end of it, has found. */
static clod_hopper_design found_at(clod_hopper_design self, clod_curve_meeting meeting)
{
    static const clod_hopper_outcome OUTCOMES[] = {CLOD_HOPPER_NO_ARCH, CLOD_HOPPER_FLOWS,
                                                   CLOD_HOPPER_ARCHES};
    self.outcome = OUTCOMES[meeting];
    self.outlet = meeting == CLOD_CURVE_MEETS
                      ? self.state.strength * self.arch / (self.state.rho * CLOD_HOPPER_GRAVITY)
                  : meeting == CLOD_CURVE_BELOW ? 0.0
                                                : (double)INFINITY;
    return self;
}

/**
 * Rounds from a first stress to the largest at which an arch stands. Where the solid begins to slide the flow factor falls steeply with the
 * stress, and a round may jump past a critical state there to where the solid sticks; bounds lead
 * back. Funnel flow, with the largest stress at which it sticks, if there is none above that.
 *
 * @param floor  Pa: a stress at which an arch is known to stand, and no rounds go below; 0: none
 */
static clod_hopper_design settle_from(const clod_solid *solid, const clod_hopper_wish *wish,
                                      double first, double floor)
{
    clod_hopper_design self = {.outcome = CLOD_HOPPER_UNSETTLED, .outlet = (double)NAN};
    clod_bracket at = clod_bracket_from(first);
    at.low = fmax(floor, at.low);
    const double close = CLOD_CRITICAL_CLOSE * wish->tolerance;
    double slid = 0.0, stuck = 0.0; // Pa: the last stresses at which it did
    for (int round = 0; round < CLOD_CRITICAL_ROUNDS; round++) {
        const double before = at.sigma_1;
        if (!clod_critical_shape(solid, wish, before, &self)) {
            if (before >= slid || slid - before <= close * before) {
                self.outcome = CLOD_HOPPER_FUNNEL;
                return self;
            }
            stuck = before;
            clod_bracket_narrow(&at, true);
            clod_bracket_halve(&at);
            continue;
        }
        slid = before;
        const clod_curve_meeting meeting = go_on(solid, &self, &at);
        if (round >= QUICK && at.low > CLOD_BRACKET_LOWEST && at.high < CLOD_BRACKET_HIGHEST) {
            clod_bracket_halve(&at); // rounds go to and fro, and hardly closer
        }
        if (fabs(at.sigma_1 - before) > close * before) {
            continue;
        }
        if (at.halved && at.low == stuck) {
            clod_critical_shape(solid, wish, stuck, &self); // no arch down to where it sticks
            self.outcome = CLOD_HOPPER_FUNNEL;
            return self;
        }
        return found_at(self, floor > 0.0 && meeting == CLOD_CURVE_BELOW ? CLOD_CURVE_MEETS
                                                                         : meeting);
    }
    return self;
}

double clod_critical_first(const clod_solid *solid, const clod_hopper_wish *wish)
{
    return wish->first > 0.0 ? wish->first : solid->strength.points[0].x;
}

/** Whether a search from a stress goes down at once to where another one began, or below. */
static bool leads_below(const clod_solid *solid, const clod_hopper_wish *wish, double stress,
                        double begin)
{
    clod_hopper_design self = {0};
    clod_bracket at = clod_bracket_from(stress);
    if (!clod_critical_shape(solid, wish, stress, &self)) {
        return false;
    }
    go_on(solid, &self, &at);
    return at.sigma_1 <= begin;
}

/** Rounds from small stresses up, and where they end at a wall that holds the solid, down. */
clod_hopper_design clod_critical_guess(const clod_solid *solid, const clod_hopper_wish *wish)
{
    const clod_curve *strength = &solid->strength;
    const double first = clod_critical_first(solid, wish);
    const double last = strength->points[strength->count - 1].x;
    const clod_hopper_design self = settle_from(solid, wish, first, 0.0);
    if (self.outcome != CLOD_HOPPER_FUNNEL) {
        return self;
    }
    // a wall with adhesion may hold the solid at small stresses only; but where it slid at the first
    // stress, too, the rounds from there have looked at all that lies below
    const bool slid = self.state.sigma_1 < first;
    return slid && leads_below(solid, wish, last, first) ? self
                                                         : settle_from(solid, wish, last, 0.0);
}

/** Whether an arch stands at a stress. */
static bool arches_at(const clod_solid *solid, const clod_hopper_wish *fixed, double sigma_1,
                      clod_hopper_design *at)
{
    const double close = CLOD_CRITICAL_CLOSE * fixed->tolerance;
    return clod_critical_shape(solid, fixed, sigma_1, at) &&
           at->state.strength * at->flow_factor > (1.0 + close) * sigma_1;
}

/**
 * The largest stress above a state, of those at which flow function or phi_e were measured, at which an arch
 * stands in the hopper of that state; 0: none. Between them both are straight, and strength over the stress of an
 * arch hardly has a maximum.
 */
static double arch_above(const clod_solid *solid, const clod_hopper_wish *fixed,
                         const clod_hopper_design *self)
{
    const clod_curve *const curves[] = {&solid->strength, &solid->phi_e};
    const double least = self->state.sigma_1 * (1.0 + CLOD_CRITICAL_CLOSE * fixed->tolerance);
    clod_hopper_design at = *self;
    double found = 0.0;
    for (size_t c = 0; c < 2; c++) {
        for (size_t k = curves[c]->count; k-- > 0;) {
            const double sigma_1 = curves[c]->points[k].x;
            if (sigma_1 <= fmax(least, found)) {
                break;
            }
            const bool known =
                c > 0 && k < solid->strength.count && solid->strength.points[k].x == sigma_1;
            if (!known && arches_at(solid, fixed, sigma_1, &at)) {
                found = sigma_1;
            }
        }
    }
    return found;
}

/** Whether the flow function ends above the stress of an arch in the hopper of a state, which becomes that of the
 *  largest measured stress then. */
static bool ends_above(const clod_solid *solid, const clod_hopper_wish *fixed,
                       clod_hopper_design *self)
{
    const clod_curve *strength = &solid->strength;
    clod_hopper_design at = *self;
    double met;
    if (!clod_critical_shape(solid, fixed, clod_solid_end(solid), &at) ||
        clod_curve_meet(strength, 1.0 / at.flow_factor, (double)INFINITY, &met) !=
            CLOD_CURVE_ABOVE) {
        return false;
    }
    *self = found_at(at, CLOD_CURVE_ABOVE);
    return true;
}

/** Whether a state may have others above it. */
static bool may_be_lower(const clod_hopper_design *self)
{
    return self->half_angle > 0.0 && self->outcome != CLOD_HOPPER_ARCHES &&
           self->outcome != CLOD_HOPPER_UNSETTLED;
}

clod_hopper_design clod_critical_settle(const clod_solid *solid, const clod_hopper_wish *wish)
{
    clod_hopper_design self = clod_critical_guess(solid, wish);
    while (may_be_lower(&self)) {
        clod_hopper_wish fixed = *wish;
        fixed.half_angle = self.half_angle;
        const double above =
            ends_above(solid, &fixed, &self) ? 0.0 : arch_above(solid, &fixed, &self);
        if (above == 0.0) {
            break;
        }
        self = settle_from(solid, wish, above, above);
    }
    return self;
}
