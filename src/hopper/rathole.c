#include "hopper/rathole.h"

#include <math.h>

#include "hopper/bracket.h"
#include "hopper/design.h"

#define DEGREE (M_PI / 180.0)
#define ROUNDS 100
#define QUICK 40 ///< rounds after which bounds are halved
#define CLOSE 1e-9
#define LEAST_FLOW_FACTOR 1.7 ///< of ratholes, and of domes over slots in funnel flow
#define DOME 1.15             ///< H of a dome over a slot in funnel flow

double clod_rathole_function(double phi_t)
{
    if (!(phi_t >= CLOD_RATHOLE_LEAST - 1e-9 && phi_t <= CLOD_RATHOLE_MOST + 1e-9)) {
        return (double)NAN;
    }
    const double p = phi_t / DEGREE;
    return -6.86712 + p * (0.58911 + p * (-0.012966 + p * 1.1939e-4));
}

static double diameter(const clod_solid_state *at)
{
    return clod_rathole_function(at->phi_t) * at->strength / (at->rho * CLOD_HOPPER_GRAVITY);
}

/** State and flow factor of a rathole at a stress; NAN: G is not known there. */
static double flow_factor_at(const clod_solid *solid, double sigma_1, clod_solid_state *at)
{
    *at = clod_solid_at(solid, sigma_1);
    const double s = sin(at->phi_e);
    const double g = clod_rathole_function(at->phi_t);
    return isnan(g) ? g : fmax(LEAST_FLOW_FACTOR, (1.0 + s) / (4.0 * s) * g);
}

/**
 * Diameter as the hole empties, by rounds from a stress; 0: none stands.
 *
 * @param floor  Pa: a stress at which a hole is known to stand, and no rounds go below; 0: none
 */
static double empty_from(const clod_solid *solid, double first, double floor,
                         clod_solid_state *at)
{
    clod_bracket in = clod_bracket_from(first);
    in.low = fmax(floor, in.low);
    for (int round = 0; round < ROUNDS; round++) {
        const double before = in.sigma_1;
        const double flow_factor = flow_factor_at(solid, before, at);
        if (isnan(flow_factor)) {
            return (double)NAN;
        }
        const bool stands = at->strength * flow_factor > before;
        const double high = in.high < CLOD_BRACKET_HIGHEST ? in.high : (double)INFINITY;
        double met = 0.0;
        const clod_curve_meeting meeting =
            clod_curve_meet(&solid->strength, 1.0 / flow_factor, stands ? high : before, &met);
        if (meeting ==
            CLOD_CURVE_ABOVE) { // there, but not with the flow factor of large stresses
            met = clod_solid_end(solid);
        }
        if (meeting == CLOD_CURVE_BELOW && floor == 0.0) {
            return 0.0;
        }
        clod_bracket_narrow(&in, met > before);
        clod_bracket_go(&in, met);
        if (round >= QUICK && in.low > CLOD_BRACKET_LOWEST && in.high < CLOD_BRACKET_HIGHEST) {
            clod_bracket_halve(&in);
        }
        if (fabs(in.sigma_1 - before) <= CLOSE * before) {
            return diameter(at);
        }
    }
    return (double)NAN;
}

/** The largest stress above one, of those at which flow function, phi_e or phi_t were measured, at which a hole
 *  stands; 0: none. */
static double hole_above(const clod_solid *solid, double least)
{
    const clod_curve *const curves[] = {&solid->strength, &solid->phi_e, &solid->phi_t};
    double found = 0.0;
    clod_solid_state at;
    for (size_t c = 0; c < 3; c++) {
        for (size_t k = 0; k < curves[c]->count; k++) {
            const double sigma_1 = curves[c]->points[k].x;
            const double needed = (1.0 + CLOSE) * sigma_1;
            if (sigma_1 > fmax(found, (1.0 + CLOSE) * least) &&
                flow_factor_at(solid, sigma_1, &at) * at.strength > needed) {
                found = sigma_1;
            }
        }
    }
    return found;
}

/** Whether a hole of any diameter stands, beyond some one: the flow function ends above the flow factor. */
static bool ends_above(const clod_solid *solid)
{
    const clod_curve *strength = &solid->strength;
    clod_solid_state at;
    double met;
    const double flow_factor = flow_factor_at(solid, clod_solid_end(solid), &at);
    return !isnan(flow_factor) && clod_curve_meet(strength, 1.0 / flow_factor, (double)INFINITY,
                                                  &met) == CLOD_CURVE_ABOVE;
}

/** From the flow factor of a rathole, as it empties: the largest that stands; INFINITY: any. */
static double emptying(const clod_solid *solid, clod_solid_state *at)
{
    if (ends_above(solid)) {
        return (double)INFINITY;
    }
    double found = empty_from(solid, solid->strength.points[0].x, 0.0, at);
    while (!isnan(found)) {
        const double above = hole_above(solid, found > 0.0 ? at->sigma_1 : 0.0);
        if (above == 0.0) {
            break;
        }
        found = empty_from(solid, above, above, at);
    }
    return found;
}

static bool no_hole_at(const void *context, double sigma_1, double *size)
{
    const clod_solid *solid = context;
    clod_solid_state at;
    const double flow_factor = flow_factor_at(solid, sigma_1, &at);
    if (isnan(flow_factor)) {
        return false;
    }
    *size = clod_rathole_function(at.phi_t) * sigma_1 / flow_factor /
            (at.rho * CLOD_HOPPER_GRAVITY);
    return at.strength * flow_factor <= sigma_1;
}

/** Vertical stress at the bottom of the filled silo: Janssen, with properties at that stress. */
static double janssen(const clod_solid *solid, const clod_rathole_silo *silo)
{
    double sigma = clod_curve_at(&solid->rho, solid->strength.points[0].x) *
                   CLOD_HOPPER_GRAVITY * silo->height;
    for (int round = 0; round < ROUNDS; round++) {
        const double before = sigma;
        const double across = silo->stress_ratio * before;
        const double weight = clod_curve_at(&solid->rho, before) * CLOD_HOPPER_GRAVITY;
        const double grip = 4.0 * silo->stress_ratio *
                            tan(clod_solid_wall_angle(solid, across)) / silo->diameter;
        sigma =
            grip > 0.0 ? weight / grip * -expm1(-grip * silo->height) : weight * silo->height;
        if (fabs(sigma - before) <= CLOSE * before) {
            break;
        }
    }
    return sigma;
}

clod_rathole clod_rathole_of(const clod_solid *solid, const clod_rathole_silo *silo)
{
    clod_rathole self = {
        .emptying = (double)NAN, .filling = (double)NAN, .filling_stress = (double)NAN};
    if (solid->phi_t.count == 0) {
        return self;
    }
    self.emptying = emptying(solid, &self.state);
    if (silo->diameter > 0.0) {
        self.filling_stress = janssen(solid, silo);
        const clod_solid_state at = clod_solid_at(solid, self.filling_stress);
        self.filling = diameter(&at);
    }
    return self;
}

clod_rathole_slot clod_rathole_slot_of(const clod_solid *solid)
{
    clod_rathole_slot self = {.width = 0.0};
    double met = 0.0;
    const clod_curve_meeting meeting =
        clod_curve_meet(&solid->strength, 1.0 / LEAST_FLOW_FACTOR, (double)INFINITY, &met);
    if (meeting == CLOD_CURVE_ABOVE) {
        self.width = (double)INFINITY;
    } else if (meeting == CLOD_CURVE_MEETS) {
        self.state = clod_solid_at(solid, met);
        self.width = DOME * self.state.strength / (self.state.rho * CLOD_HOPPER_GRAVITY);
    }
    return self;
}

clod_ranges clod_rathole_ranges(const clod_solid *solid, const clod_rathole *hole)
{
    return hole->emptying > 0.0
               ? clod_ranges_find(&solid->strength,
                                  isinf(hole->emptying) ? hole->emptying : hole->state.sigma_1,
                                  no_hole_at, solid)
               : (clod_ranges){0};
}
