#include "verify/rebound.h"

#include <math.h>
#include <stdbool.h>

#include "verify/hertz.h"

/** Motion of the sphere; the plane is at rest. */
typedef struct motion {
    double overlap, approach; ///< m, m/s
    double v, w;              ///< along the plane [m/s], about the axis across it [rad/s]
    double spring, stiffness; ///< m, k_t [N/m]
} motion;

static double clamp(double value, double limit)
{
    return fmin(fmax(value, -limit), limit);
}

/** One step: forces at the middle of it. */
static void advance(const clod_verify_rebound *self, double dt, motion *m)
{
    const double z = -log(self->restitution) / hypot(log(self->restitution), M_PI);
    const double damping = 2.0 * z * sqrt(5.0 / 6.0);
    const double overlap = fmax(m->overlap + 0.5 * dt * m->approach, 0.0);
    const double root = sqrt(self->radius * overlap);
    const double elastic = 4.0 / 3.0 * self->young_star * root * overlap;
    const double k_t = 8.0 * self->shear_star * root;
    const double g_n = damping * sqrt(self->mass * 2.0 * self->young_star * root);
    const double g_t = damping * sqrt(self->mass * k_t);
    const double limit = self->friction * elastic;
    const double arm = self->radius - overlap;
    const double slip = m->v - arm * m->w;

    const double kept = k_t > m->stiffness ? m->spring * m->stiffness / k_t : m->spring;
    m->spring = k_t > 0.0 ? clamp(kept + dt * slip, limit / k_t) : 0.0;
    m->stiffness = k_t;
    const double force = clamp(-k_t * m->spring - g_t * slip, limit);
    m->v += dt * force / self->mass;
    m->w -= dt * force * arm / (0.4 * self->mass * self->radius * self->radius);
    const double before = m->approach;
    m->approach -= dt * (elastic + g_n * m->approach) / self->mass;
    m->overlap += 0.5 * dt * (before + m->approach);
}

double clod_verify_rebound_energy(const clod_verify_rebound *self, int steps)
{
    const clod_verify_pair pair = {.radius_a = self->radius,
                                   .mass_a = self->mass,
                                   .young_star = self->young_star,
                                   .speed = self->normal};
    const double dt = clod_verify_hertz_duration(&pair) / steps;
    motion m = {.approach = self->normal, .v = self->slip};
    do {
        advance(self, dt, &m);
    } while (m.overlap > 0.0);
    const double turning = 0.4 * self->radius * self->radius * m.w * m.w;
    return (m.v * m.v + turning) / (self->slip * self->slip);
}
