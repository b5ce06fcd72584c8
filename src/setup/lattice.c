#include "setup/lattice.h"

#include <math.h>

#include "law/law_springs.h"

/** Springs and dash-pots of one mode, by its mass. */
typedef struct mode {
    double stiffness; ///< 1/s2
    double dash_pot;  ///< 1/s
} mode;

/** 2/omega (sqrt(1 + zeta^2) - zeta); infinite where nothing swings. */
static double stable_step(mode of)
{
    const double omega = sqrt(of.stiffness);
    const double zeta = 0.5 * of.dash_pot / omega;
    return omega > 0.0 ? 2.0 / omega * (sqrt(1.0 + zeta * zeta) - zeta) : HUGE_VAL;
}

double clod_lattice_step(const clod_law *law, double mass, double radius, double overlap)
{
    const double r_star = 0.5 * radius, m_star = 0.5 * mass;
    const double inertia = 0.4 * mass * radius * radius;
    const double arm = radius - 0.5 * overlap;
    const double loading = clod_law_tangent(law, overlap, r_star);
    const double normal = clod_law_stiffest(law, overlap, r_star);
    const double slip = law->friction > 0.0 ? clod_law_springs_tangential(law, loading) : 0.0;
    const double roll = law->rolling_friction > 0.0
                            ? clod_law_springs_rolling(law, loading) * r_star * r_star
                            : 0.0;
    const double push_pot = law->damping * sqrt(m_star * loading);
    const double slip_pot = law->damping * sqrt(m_star * slip);
    const double about =
        0.5 * (inertia + mass * radius * radius); // of both about their contact
    const double roll_pot = clod_law_springs_rolling_row_of((int)law->rolling)->dash_pot
                                ? 2.0 * law->rolling_damping * sqrt(about * roll)
                                : 0.0;
    const mode move = {(4.0 * normal + 8.0 * slip) / mass,
                       (4.0 * push_pot + 8.0 * slip_pot) / mass};
    const mode turn = {8.0 * slip * arm * arm / inertia, 8.0 * slip_pot * arm * arm / inertia};
    const mode rolling = {8.0 * roll / inertia, 8.0 * roll_pot / inertia};
    return fmin(fmin(stable_step(move), stable_step(turn)), stable_step(rolling));
}
