#include "setup/collision.h"

#include <math.h>

#include "law/law_cycle.h"

#define PHASES 16          ///< places of the first touch between two steps
#define LENGTHS 8          ///< collisions of up to half a step less and more
#define STEPS_MOST 10000.0 ///< more are not cut finer: the error is below 1e-4 then

#define TIME_MOST 100.0 ///< in units of a collision of some 3

/** Quarter of a swing on k d^n, as a multiple of largest d over speed. */
static double quarter(double exponent)
{
    const double part = 1.0 / (exponent + 1.0);
    return sqrt(M_PI) * tgamma(1.0 + part) / tgamma(0.5 + part);
}

double clod_collision_time(const clod_law *law, double r_star, double m_star, double overlap)
{
    const double pull = law->touch * overlap; // eepa: its work is no part of the swing
    const double energy = clod_law_cycle_energy(law, r_star, overlap) + pull;
    const double speed = sqrt(2.0 * energy / m_star);
    const double there = quarter(law->exponent) * overlap / speed;
    return there * (1.0 + sqrt(law->k1 / law->k2));
}

/**
 * One collision with mass, speed and k d^n/d all 1 at first: from the first touch, which is a
 * part of a step before the first look, until the spheres are apart.
 */
static double collide(const clod_law *law, double dt, double part)
{
    const double n = law->exponent;
    double overlap = part * dt;
    double speed = 1.0; // of the half step
    for (double time = 0.0; overlap > 0.0; time += dt) {
        if (time > TIME_MOST) { // restitution 0 creeps apart
            return 0.0;
        }
        const double tangent = n * pow(overlap, n - 1.0);
        speed -= dt * (pow(overlap, n) + law->damping * sqrt(tangent) * speed);
        overlap += dt * speed;
    }
    return -speed;
}

clod_collision_range clod_collision_restitution(const clod_law *law, double steps)
{
    const double n = law->exponent;
    const double most = pow(0.5 * (n + 1.0), 1.0 / (n + 1.0)); // all energy in k d^n
    const double time = 2.0 * quarter(n) * most;
    clod_collision_range range = {HUGE_VAL, -HUGE_VAL};
    for (int k = 0; k < PHASES * LENGTHS; k++) {
        const int length = k / PHASES;
        const double more = (length + 0.5) / LENGTHS - 0.5;
        const double dt = time / (fmin(fmax(steps, 1.0), STEPS_MOST) + more);
        const double e = collide(law, dt, (k % PHASES + 0.5) / PHASES);
        range.least = fmin(range.least, e);
        range.most = fmax(range.most, e);
    }
    return range;
}
