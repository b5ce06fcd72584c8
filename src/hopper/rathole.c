#include "hopper/rathole.h"

#include <math.h>

#include "hopper/design.h"

#define DEGREE (M_PI / 180.0)
#define ROUNDS 100
#define CLOSE 1e-9
#define LEAST_FLOW_FACTOR 1.7

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

/** From the flow factor of a rathole, as it empties. */
static double emptying(const clod_solid *solid, clod_solid_state *at)
{
    const clod_curve *strength = &solid->strength;
    double sigma_1 = strength->points[0].x;
    for (int round = 0; round < ROUNDS; round++) {
        const double before = sigma_1;
        *at = clod_solid_at(solid, before);
        const double s = sin(at->phi_e);
        const double flow_factor =
            fmax(LEAST_FLOW_FACTOR, (1.0 + s) / (4.0 * s) * clod_rathole_function(at->phi_t));
        if (isnan(clod_rathole_function(at->phi_t))) {
            return (double)NAN;
        }
        switch (clod_curve_meet(strength, 1.0 / flow_factor, &sigma_1)) {
        case CLOD_CURVE_BELOW:
            return 0.0;
        case CLOD_CURVE_ABOVE:
            return (double)INFINITY;
        default:
            break;
        }
        if (fabs(sigma_1 - before) <= CLOSE * before) {
            return diameter(at);
        }
    }
    return (double)NAN;
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
