#include "law/law_cycle.h"

#include <math.h>

#include "law/law_forms.h"
#include "law/law_kinds.h"

/** Newton steps of the impact with a first pull: each halves what is too much, or better. */
#define IMPACT_STEPS 60

double clod_law_cycle_virgin(const clod_law *law, double r_star)
{
    return law->k1 * (clod_law_root_radius(law) ? sqrt(r_star) : 1.0);
}

/** Overlap from which virgin loading follows k2; most laws have none. */
static double flow_overlap(const clod_law *law, double r_star)
{
    const clod_law_kind_row *row = clod_law_kinds_row(law->kind);
    return row->flow != NULL ? row->flow(law, r_star) : HUGE_VAL;
}

double clod_law_cycle_force(const clod_law *law, double r_star, double overlap)
{
    const double flow = flow_overlap(law, r_star);
    if (overlap > flow) {
        return law->k1 * flow + law->k2 * (overlap - flow);
    }
    const double k1 = clod_law_cycle_virgin(law, r_star);
    return k1 * pow(overlap, law->exponent) - law->touch;
}

double clod_law_cycle_overlap(const clod_law *law, double r_star, double force)
{
    const double k1 = clod_law_cycle_virgin(law, r_star);
    const double overlap = pow((force + law->touch) / k1, 1.0 / law->exponent);
    const double flow = flow_overlap(law, r_star);
    return overlap > flow ? flow + (force - law->k1 * flow) / law->k2 : overlap;
}

double clod_law_cycle_energy(const clod_law *law, double r_star, double overlap)
{
    const double flow = flow_overlap(law, r_star);
    const double n1 = law->exponent + 1.0; // the work of k1 d^n is k1 d^(n+1)/(n+1)
    const double k1 = clod_law_cycle_virgin(law, r_star);
    const double first = fmin(overlap, flow);
    const double energy = k1 * pow(first, n1) / n1 - law->touch * first;
    const double more = overlap - first;
    return energy + more * (k1 * first + 0.5 * law->k2 * more);
}

/** k1 d^(n+1)/(n+1) - touch d = energy, by Newton's steps down from beyond both. */
static double impact_with_touch(const clod_law *law, double r_star, double energy)
{
    const double n1 = law->exponent + 1.0;
    double d = r_star + clod_law_cycle_overlap(law, r_star, 0.0);
    for (int k = 0; k < IMPACT_STEPS; k++) {
        const double power = law->k1 * pow(d, law->exponent);
        d = (power * d * (1.0 - 1.0 / n1) + energy) / (power - law->touch);
    }
    return d;
}

double clod_law_cycle_impact(const clod_law *law, double r_star, double energy)
{
    if (law->touch > 0.0) {
        return impact_with_touch(law, r_star, energy);
    }
    const double n1 = law->exponent + 1.0;
    const double overlap = pow(energy * n1 / clod_law_cycle_virgin(law, r_star), 1.0 / n1);
    const double flow = flow_overlap(law, r_star);
    if (overlap <= flow) {
        return overlap;
    }
    const double force = law->k1 * flow; // k2 more^2/2 + force more takes what is left
    const double left = energy - 0.5 * force * flow;
    return flow + 2.0 * left / (force + sqrt(force * force + 2.0 * law->k2 * left));
}

clod_law_pull clod_law_cycle_pull(const clod_law *law, double r_star, double overlap)
{
    return clod_law_kinds_row(law->kind)->pull(law, r_star, overlap);
}

double clod_law_cycle_pressed(const clod_law *law, double memory)
{
    return clod_law_kinds_row(law->kind)->pressed(law, memory);
}

clod_law_gain clod_law_cycle_gain(const clod_law *law, double r_star, double overlap,
                                  double memory, double approach)
{
    static const double NEAR = 1e-6; // of an overlap: beyond rounding, far below a step's way
    const double pressed = clod_law_cycle_pressed(law, memory);
    const double more = NEAR * pressed;
    if (!(approach > 0.0 && more > 0.0 && pressed < flow_overlap(law, r_star) &&
          overlap > pressed - more)) {
        return (clod_law_gain){0.0, 0.0};
    }
    const double rate = approach / more;
    const double force = fmax(0.0, clod_law_cycle_force(law, r_star, pressed));
    const double pull = clod_law_cycle_pull(law, r_star, pressed).force;
    return (clod_law_gain){
        rate * (fmax(0.0, clod_law_cycle_force(law, r_star, pressed + more)) - force),
        rate * (clod_law_cycle_pull(law, r_star, pressed + more).force - pull)};
}
