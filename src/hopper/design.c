#include "hopper/design.h"

#include <math.h>

#define DEGREE (M_PI / 180.0)
#define ROUNDS 60
#define CLOSE 10.0 // relative change of sigma_1 at which the state is found, in tolerances

double clod_hopper_arch_thickness(clod_hopper_arch fit, clod_radial_shape shape, double theta)
{
    const double degrees = theta / DEGREE;
    if (fit == CLOD_HOPPER_ARCH_RHODES) {
        return shape == CLOD_RADIAL_CONE ? 2.0 + degrees / 60.0 : 1.0 + degrees / 180.0;
    }
    return shape == CLOD_RADIAL_CONE ? (130.0 + degrees) / 65.0 : (200.0 + degrees) / 200.0;
}

/** Largest half angle of mass flow in a cone for a state; 0: none. */
static double limit_at(const clod_solid_state *state, double tolerance)
{
    const clod_radial cone = {CLOD_RADIAL_CONE, state->phi_e, state->phi_w, tolerance};
    double limit;
    return clod_radial_limit(&cone, &limit) ? limit : 0.0;
}

/** Half angle, H and flow factor at one stress; false: funnel flow. */
static bool shape_at(const clod_solid *solid, const clod_hopper_wish *wish, double sigma_1,
                     clod_hopper_design *self)
{
    self->state = clod_solid_at(solid, sigma_1);
    self->half_angle = wish->half_angle;
    if (wish->half_angle == 0.0) {
        self->limit = limit_at(&self->state, wish->tolerance);
        self->half_angle = self->limit - wish->margin;
    }
    const clod_radial field = {wish->shape, self->state.phi_e, self->state.phi_w,
                               wish->tolerance};
    clod_radial_wall wall;
    if (self->half_angle <= 0.0 || !clod_radial_solve(&field, self->half_angle, &wall)) {
        return false;
    }
    self->arch = clod_hopper_arch_thickness(wish->arch, wish->shape, self->half_angle);
    self->flow_factor = self->arch * wall.sigma_1 / (2.0 * sin(self->half_angle));
    return true;
}

/** The stress to look at where the strength stays on one side: the end it tends to. */
static double end_of(const clod_solid *solid, clod_curve_meeting meeting)
{
    const clod_curve *curve = &solid->strength;
    return curve->points[meeting == CLOD_CURVE_BELOW ? 0 : curve->count - 1].x;
}

/** Where to look next, and within which bounds: sigma_1 lies between low and high. */
typedef struct search {
    double sigma_1, low, high;
} search;

/**
 * One round: the state at sigma_1 has a flow factor, and that another sigma_1. Bounds that close
 * in keep rounds from going in circles.
 */
static clod_curve_meeting go_on(const clod_solid *solid, double flow_factor, search *at)
{
    double met = 0.0;
    const clod_curve_meeting meeting =
        clod_curve_meet(&solid->strength, 1.0 / flow_factor, &met);
    if (meeting != CLOD_CURVE_MEETS) {
        met = end_of(solid, meeting);
    }
    if (met > at->sigma_1) {
        at->low = at->sigma_1;
    } else {
        at->high = at->sigma_1;
    }
    const bool inside = met > at->low && met < at->high;
    at->sigma_1 = inside || met == at->sigma_1 ? met : sqrt(at->low * at->high);
    return meeting;
}

/** Rounds from a first stress. */
static clod_hopper_design settle(const clod_solid *solid, const clod_hopper_wish *wish,
                                 double first)
{
    clod_hopper_design self = {.outcome = CLOD_HOPPER_UNSETTLED, .outlet = (double)NAN};
    search at = {first, 1e-9, 1e12};
    for (int round = 0; round < ROUNDS; round++) {
        const double before = at.sigma_1;
        if (!shape_at(solid, wish, before, &self)) {
            self.outcome = CLOD_HOPPER_FUNNEL;
            return self;
        }
        const clod_curve_meeting meeting = go_on(solid, self.flow_factor, &at);
        if (fabs(at.sigma_1 - before) > CLOSE * wish->tolerance * before) {
            continue;
        }
        static const clod_hopper_outcome OUTCOMES[] = {CLOD_HOPPER_NO_ARCH, CLOD_HOPPER_FLOWS,
                                                       CLOD_HOPPER_ARCHES};
        self.outcome = OUTCOMES[meeting];
        self.outlet = meeting == CLOD_CURVE_MEETS ? self.state.strength * self.arch /
                                                        (self.state.rho * CLOD_HOPPER_GRAVITY)
                      : meeting == CLOD_CURVE_BELOW ? 0.0
                                                    : (double)INFINITY;
        return self;
    }
    return self;
}

clod_hopper_design clod_hopper_design_shape(const clod_solid *solid,
                                            const clod_hopper_wish *wish)
{
    const clod_curve *strength = &solid->strength;
    const double first = wish->first > 0.0 ? wish->first : strength->points[0].x;
    clod_hopper_design self = settle(solid, wish, first);
    if (self.outcome == CLOD_HOPPER_FUNNEL) {
        // a wall with adhesion may hold the solid at small stresses only
        self = settle(solid, wish, strength->points[strength->count - 1].x);
    }
    if (wish->half_angle > 0.0) {
        self.limit = limit_at(&self.state, wish->tolerance);
    }
    const bool flows = self.outcome == CLOD_HOPPER_FLOWS || self.outcome == CLOD_HOPPER_NO_ARCH;
    if (flows && wish->shape == CLOD_RADIAL_WEDGE && self.half_angle > self.limit) {
        // the field of a wedge has solutions far beyond what charts allow: docs/theory/hopper.md
        self.outcome = CLOD_HOPPER_UNPROVEN;
    }
    return self;
}

bool clod_hopper_is_critical(const clod_hopper_design *self)
{
    return self->outcome == CLOD_HOPPER_FLOWS ||
           (self->outcome == CLOD_HOPPER_UNPROVEN && self->outlet > 0.0);
}

/** The margin by rounds from a first stress. */
static clod_hopper_margin margin_from(const clod_solid *solid, const clod_hopper_wish *wish,
                                      double outlet, double first)
{
    clod_hopper_margin self = {.ratio = (double)NAN};
    double sigma_1 = first;
    for (int round = 0; round < ROUNDS; round++) {
        clod_hopper_design at;
        if (!shape_at(solid, wish, sigma_1, &at)) {
            self.state = at.state;
            self.sticks = true;
            return self;
        }
        const double before = sigma_1;
        self.state = at.state;
        self.stress = at.state.rho * CLOD_HOPPER_GRAVITY * outlet / at.arch;
        sigma_1 = at.flow_factor * self.stress;
        if (fabs(sigma_1 - before) <= CLOSE * wish->tolerance * before) {
            self.ratio = self.stress / at.state.strength; // infinite for a strength of 0
            return self;
        }
    }
    return self;
}

clod_hopper_margin clod_hopper_margin_of(const clod_solid *solid, const clod_hopper_wish *wish,
                                         double outlet)
{
    const clod_curve *strength = &solid->strength;
    const double first = wish->first > 0.0 ? wish->first : strength->points[0].x;
    const clod_hopper_margin self = margin_from(solid, wish, outlet, first);
    // as in a design: adhesion may hold the solid at small stresses only
    return isnan(self.ratio)
               ? margin_from(solid, wish, outlet, strength->points[strength->count - 1].x)
               : self;
}
