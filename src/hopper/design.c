#include "hopper/design.h"

#include <math.h>
#include <stddef.h>

#include "hopper/bracket.h"
#include "hopper/critical.h"

#define DEGREE (M_PI / 180.0)
#define NO_STRESS 1e-6 // of a measured one

double clod_hopper_arch_thickness(clod_hopper_arch fit, clod_radial_shape shape, double theta)
{
    const double degrees = theta / DEGREE;
    if (fit == CLOD_HOPPER_ARCH_RHODES) {
        return shape == CLOD_RADIAL_CONE ? 2.0 + degrees / 60.0 : 1.0 + degrees / 180.0;
    }
    return shape == CLOD_RADIAL_CONE ? (130.0 + degrees) / 65.0 : (200.0 + degrees) / 200.0;
}

double clod_hopper_limit_at(const clod_solid *solid, double sigma_1, double tolerance)
{
    const clod_solid_state state = clod_solid_at(solid, sigma_1);
    return clod_critical_limit(&state, tolerance);
}

bool clod_hopper_is_critical(const clod_hopper_design *self)
{
    return self->outcome == CLOD_HOPPER_FLOWS ||
           (self->outcome == CLOD_HOPPER_UNPROVEN && self->outlet > 0.0);
}

bool clod_hopper_is_mass_flow(const clod_hopper_design *self)
{
    return self->outcome == CLOD_HOPPER_FLOWS || self->outcome == CLOD_HOPPER_NO_ARCH;
}

/** About the half angle of the design, by the closed approximation of the limit (theory/hopper.md) at
 *  the first stress; NAN: none. */
static double guess_angle(const clod_solid *solid, const clod_hopper_wish *wish)
{
    const clod_solid_state state = clod_solid_at(solid, clod_critical_first(solid, wish));
    const double s = sin(state.phi_e);
    return M_PI_2 - 0.5 * acos((1.0 - s) / (2.0 * s)) -
           clod_radial_beta(state.phi_e, state.phi_w) - wish->margin;
}

/** How an outlet flows. */
typedef enum flow { SLIDES, STICKS, UNSETTLED } flow;

/**
 * The state in flow at an outlet below a given half angle, by rounds from a first stress. They may
 * jump to where the solid sticks, past a state in which it slides; bounds lead back. A wall with
 * adhesion sticks at small stresses, one whose friction angle grows with stress at large ones.
 */
static flow flow_below(const clod_solid *solid, const clod_hopper_wish *wish, double outlet,
                       double first, clod_hopper_design *at)
{
    const double close = CLOD_CRITICAL_CLOSE * wish->tolerance;
    // near where the solid sticks below a given half angle, stresses hang on far less than that
    const double closed = wish->half_angle > 0.0 ? 0.0 : close;
    clod_bracket in = clod_bracket_from(first);
    flow how = UNSETTLED;
    double slid = 0.0; // Pa: the last stress at which it did
    bool above = false;
    for (int round = 0; round < CLOD_CRITICAL_ROUNDS && in.high > in.low * (1.0 + closed);
         round++) {
        const double before = in.sigma_1;
        double next = 0.0;
        how = clod_critical_shape(solid, wish, before, at) ? SLIDES : STICKS;
        if (how == SLIDES) {
            slid = before;
            next = at->flow_factor * at->state.rho * CLOD_HOPPER_GRAVITY * outlet / at->arch;
            if (fabs(next - before) <= close * before) {
                return SLIDES;
            }
        }
        if (slid == 0.0) {
            return STICKS;
        }
        above = above || (how == STICKS && before > slid);
        clod_bracket_narrow(&in, how == STICKS ? before < slid : next > before);
        clod_bracket_go(&in, next);
    }
    return how == STICKS || !clod_critical_shape(solid, wish, above ? in.high : in.low, at)
               ? STICKS
               : UNSETTLED;
}

/** The same below the half angle of that state: a limit costs far more than a round, and the stress
 *  hardly depends on it. */
static flow flow_from(const clod_solid *solid, const clod_hopper_wish *wish, double outlet,
                      double first, clod_hopper_design *at)
{
    if (wish->half_angle > 0.0) {
        return flow_below(solid, wish, outlet, first, at);
    }
    clod_hopper_wish fixed = *wish;
    clod_bracket in = clod_bracket_from(first);
    fixed.half_angle = guess_angle(solid, wish);
    if (fixed.half_angle > 0.0 && flow_below(solid, &fixed, outlet, first, at) == SLIDES) {
        in.sigma_1 = at->state.sigma_1; // a better start
    }
    for (int round = 0; round < CLOD_CRITICAL_ROUNDS; round++) {
        const double before = in.sigma_1;
        if (!clod_critical_shape(solid, wish, before, at)) {
            return STICKS;
        }
        fixed.half_angle = at->half_angle;
        const flow how = flow_below(solid, &fixed, outlet, before, at);
        const double next = at->state.sigma_1;
        if (how == SLIDES &&
            fabs(next - before) <= CLOD_CRITICAL_CLOSE * wish->tolerance * before) {
            return SLIDES;
        }
        if (how == UNSETTLED || (how == STICKS && next <= before)) {
            // but a steeper one of another stress may slide
            return flow_below(solid, wish, outlet, before, at);
        }
        // where it sticks above, a steeper hopper of a larger stress slides
        clod_bracket_narrow(&in, next > before);
        clod_bracket_go(&in, next);
    }
    return flow_below(solid, wish, outlet, first, at);
}

/** The same from small stresses, or else from large ones, or that of so high a column of solid as the outlet is wide: outlets
 *  that are wide may have larger ones than were measured; or from hardly any, where a wall that roughens with stress slides. */
static flow flow_at(const clod_solid *solid, const clod_hopper_wish *wish, double outlet,
                    clod_hopper_design *at)
{
    const clod_curve *strength = &solid->strength;
    const double last = strength->points[strength->count - 1].x;
    const double column = clod_curve_at(&solid->rho, last) * CLOD_HOPPER_GRAVITY * outlet;
    *at = (clod_hopper_design){0};
    flow how = flow_from(solid, wish, outlet, clod_critical_first(solid, wish), at);
    if (how != SLIDES) {
        how = flow_from(solid, wish, outlet, last, at);
    }
    if (how != SLIDES && column > last) {
        how = flow_from(solid, wish, outlet, column, at);
    }
    clod_hopper_design low = {0};
    if (how != SLIDES && flow_from(solid, wish, outlet, NO_STRESS * last, &low) == SLIDES) {
        *at = low;
        how = SLIDES;
    }
    return how;
}

/**
 * By how much a limit that is given lies above that of a cone, at the stress for which it holds. At other
 * stresses it is taken to change as a cone's does.
 */
static double lift_of(const clod_solid *solid, const clod_hopper_wish *wish, double sigma_1)
{
    return wish->limit > 0.0
               ? wish->limit - clod_hopper_limit_at(solid, sigma_1, wish->tolerance)
               : 0.0;
}

/** Whether a cone of this half angle less `lift`, which is safe for a wedge too, is mass flow at a stress. At a
 *  limit that is given it is the half angle just below it, since the search may miss the cone's own.
 *  @param axis  [in,out] of the last field that was found, 0: none; NULL: not wanted */
static bool slides(const clod_solid *solid, const clod_hopper_wish *wish, double lift,
                   double sigma_1, double *axis)
{
    const clod_solid_state state = clod_solid_at(solid, sigma_1);
    const double most =
        wish->limit > 0.0 ? clod_critical_below(wish->limit, 0.0) : (double)INFINITY;
    const double half_angle = fmin(wish->half_angle, most) - lift;
    if (half_angle <= 0.0) {
        return clod_critical_limit(&state, wish->tolerance) > 0.0;
    }
    const clod_radial cone = {CLOD_RADIAL_CONE, state.phi_e, state.phi_w, wish->tolerance};
    clod_radial_wall wall;
    const bool good =
        clod_radial_solve_near(&cone, half_angle, axis != NULL ? *axis : 0.0, &wall);
    if (good && axis != NULL) {
        *axis = wall.axis;
    }
    return good;
}

/**
 * Where a hopper of a half angle would have no arch, but the solid sticks to the wall: the smallest
 * outlet above which it slides becomes the critical one.
 *
 * @param good  Pa: a stress at which it slides
 */
static void begin_to_slide(const clod_solid *solid, const clod_hopper_wish *wish, double good,
                           clod_hopper_design *self)
{
    const bool known = self->outcome != CLOD_HOPPER_NO_ARCH && self->state.sigma_1 < good;
    double low = known ? self->state.sigma_1 : NO_STRESS * good;
    double high = good;
    const double lift = lift_of(solid, wish, good);
    double axis = 0.0;
    const bool there = wish->limit > 0.0 ? wish->half_angle <= wish->limit
                                         : slides(solid, wish, lift, high, &axis);
    if (slides(solid, wish, lift, low, &axis) || !there) {
        return;
    }
    const double close = CLOD_CRITICAL_CLOSE * wish->tolerance;
    const double near = low * (1.0 + 2.0 * close); // rounds that ended at the wall got as close
    if (near < high && slides(solid, wish, lift, near, &axis)) {
        high = near;
    }
    while (high > low * (1.0 + close)) {
        const double middle = sqrt(low * high);
        if (slides(solid, wish, lift, middle, &axis)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    clod_hopper_design at = *self;
    if (clod_critical_shape(solid, wish, high, &at) &&
        at.state.strength <= at.state.sigma_1 / at.flow_factor) {
        at.outcome = CLOD_HOPPER_FLOWS;
        at.outlet = clod_critical_outlet(&at);
        at.sticks = true;
        *self = at;
    }
}

/** Limit and half angle are those of a state. */
static void set_design_state(clod_hopper_design *self, const clod_hopper_design *at,
                             double built)
{
    self->design_state = at->state;
    self->limit = at->limit;
    self->half_angle = at->half_angle;
    self->built = fmax(built, clod_hopper_is_critical(self) ? self->outlet : 0.0);
}

/** The critical state of a half angle at which the solid slides at a stress, from there if it is found from no other. */
static clod_hopper_design settle_near(const clod_solid *solid, const clod_hopper_wish *wish,
                                      double good)
{
    clod_hopper_wish from = *wish;
    const clod_hopper_design self = clod_critical_settle(solid, wish);
    from.first = good;
    return self.outcome == CLOD_HOPPER_FUNNEL ? clod_critical_settle(solid, &from) : self;
}

/** A hopper with the half angle of a state in which it is mass flow. */
static clod_hopper_design design_for(const clod_solid *solid, const clod_hopper_wish *wish,
                                     const clod_hopper_design *at, double built)
{
    clod_hopper_wish fixed = *wish;
    fixed.half_angle = at->half_angle;
    clod_hopper_design self = settle_near(solid, &fixed, at->state.sigma_1);
    if (self.outcome != CLOD_HOPPER_ARCHES && self.outcome != CLOD_HOPPER_UNSETTLED) {
        begin_to_slide(solid, &fixed, at->state.sigma_1, &self);
    }
    set_design_state(&self, at, built);
    return self;
}

/** Whether the critical outlet seems to be larger than one: for a half angle near that of the design. */
static bool seems_larger(const clod_solid *solid, const clod_hopper_wish *wish, double least)
{
    clod_hopper_wish fixed = *wish;
    fixed.half_angle = guess_angle(solid, wish);
    if (least == 0.0 || !(fixed.half_angle > 0.0)) {
        return least == 0.0;
    }
    const clod_hopper_design self = clod_critical_guess(solid, &fixed);
    return self.outcome == CLOD_HOPPER_FLOWS && self.outlet > least;
}

/** The half angle follows from the outlet that is built, and that from the half angle. */
static clod_hopper_design design_own(const clod_solid *solid, const clod_hopper_wish *wish)
{
    const double least = fmax(wish->outlet, wish->least);
    const bool larger = seems_larger(solid, wish, least);
    clod_hopper_design at;
    clod_hopper_design self = {0};
    if (larger) { // as a rule it is: half the work
        self = clod_critical_settle(solid, wish);
        if (self.outcome == CLOD_HOPPER_FLOWS && self.outlet > least) {
            set_design_state(&self, &self, 0.0);
            return self;
        }
    }
    const flow how = least > 0.0 ? flow_at(solid, wish, least, &at) : UNSETTLED;
    if (how == SLIDES) {
        const clod_hopper_design built = design_for(solid, wish, &at, least);
        if (built.outcome == CLOD_HOPPER_NO_ARCH ||
            (built.outcome == CLOD_HOPPER_FLOWS && built.outlet <= least)) {
            return built;
        }
    }
    if (!larger) {
        self = clod_critical_settle(solid, wish); // the critical outlet is larger
    }
    if (self.outcome == CLOD_HOPPER_FUNNEL && wish->outlet == 0.0) {
        // critical at so little stress that the wall holds it: at what was measured, it may not
        at = self;
        if (clod_critical_shape(solid, wish, solid->strength.points[0].x, &at)) {
            self = design_for(solid, wish, &at, clod_critical_outlet(&at));
            self.at_measured = true;
            return self;
        }
    }
    if (self.outcome == CLOD_HOPPER_NO_ARCH) {
        at = self;
        return design_for(solid, wish, &at, 0.0);
    }
    set_design_state(&self, &self, 0.0);
    if (wish->outlet > 0.0 && self.outlet <= wish->outlet) {
        // slides at the critical outlet, but not at this one, or no state was found there
        at.outcome = how == STICKS ? CLOD_HOPPER_FUNNEL : CLOD_HOPPER_UNSETTLED;
        at.outlet = (double)NAN;
        set_design_state(&at, &at, 0.0);
        return at;
    }
    return self;
}

/** A hopper whose half angle is given. */
static clod_hopper_design design_given(const clod_solid *solid, const clod_hopper_wish *wish)
{
    const clod_curve *strength = &solid->strength;
    const double least = fmax(wish->outlet, wish->least);
    clod_hopper_design self = clod_critical_settle(solid, wish);
    clod_hopper_design at;
    double built = 0.0;
    if (least > self.outlet || self.outcome == CLOD_HOPPER_FUNNEL) {
        built = least > 0.0 && flow_at(solid, wish, least, &at) == SLIDES ? least : 0.0;
    }
    if (built == 0.0) {
        at = self;
    }
    const bool funnel = self.outcome == CLOD_HOPPER_FUNNEL;
    if (built > 0.0 || self.outcome == CLOD_HOPPER_NO_ARCH || funnel) {
        const bool here = wish->limit > 0.0 ? wish->half_angle <= wish->limit
                                            : slides(solid, wish, 0.0, at.state.sigma_1, NULL);
        begin_to_slide(solid, wish,
                       funnel && !here ? strength->points[strength->count - 1].x
                                       : at.state.sigma_1,
                       &self);
    }
    if (self.sticks && self.outlet > built) {
        at = self;
    }
    at.limit =
        wish->limit > 0.0 ? wish->limit : clod_critical_limit(&at.state, wish->tolerance);
    at.half_angle = wish->half_angle;
    set_design_state(&self, &at, built);
    return self;
}

/** A hopper whose limit is given; a half angle beyond it is funnel flow. */
static clod_hopper_design design_below(const clod_solid *solid, const clod_hopper_wish *wish)
{
    clod_hopper_wish fixed = *wish;
    fixed.half_angle = wish->half_angle > 0.0 ? wish->half_angle
                                              : clod_critical_below(wish->limit, wish->margin);
    if (fixed.half_angle <= 0.0) {
        return (clod_hopper_design){.outcome = CLOD_HOPPER_FUNNEL, .limit = wish->limit};
    }
    clod_hopper_design self = design_given(solid, &fixed);
    if (fixed.half_angle > wish->limit) {
        self.outcome = CLOD_HOPPER_FUNNEL;
    }
    return self;
}

clod_hopper_design clod_hopper_design_shape(const clod_solid *solid,
                                            const clod_hopper_wish *wish)
{
    if (wish->limit > 0.0) {
        return design_below(solid, wish);
    }
    clod_hopper_design self =
        wish->half_angle > 0.0 ? design_given(solid, wish) : design_own(solid, wish);
    const bool flows = self.outcome == CLOD_HOPPER_FLOWS || self.outcome == CLOD_HOPPER_NO_ARCH;
    if (flows && wish->shape == CLOD_RADIAL_WEDGE && self.half_angle > self.limit &&
        !self.sticks) {
        // the field of a wedge has solutions far beyond what charts allow: docs/theory/hopper.md
        self.outcome = CLOD_HOPPER_UNPROVEN;
    }
    return self;
}

clod_hopper_margin clod_hopper_margin_of(const clod_solid *solid, const clod_hopper_wish *wish,
                                         double outlet)
{
    clod_hopper_design at;
    clod_hopper_margin self = {.ratio = (double)NAN};
    const flow how = flow_at(solid, wish, outlet, &at);
    self.state = at.state;
    const bool beyond = wish->limit > 0.0 && wish->half_angle > wish->limit;
    self.sticks = how == STICKS || beyond;
    if (how == SLIDES && !beyond) {
        self.stress = at.state.rho * CLOD_HOPPER_GRAVITY * outlet / at.arch;
        self.ratio = self.stress / at.state.strength; // infinite for a strength of 0
    }
    return self;
}
