#include "setup/timestep.h"

#include <math.h>

#include "law/law_cycle.h"

/** Overlap assumed at least, as a fraction of the radius: a bed without load is not soft. */
#define LEAST_OVERLAP 1e-4

/** A spring of a contact, and the mass that swings on it. */
typedef struct clod_timestep_spring {
    clod_timestep_reason reason;
    double stiffness, mass;
} clod_timestep_spring;

/** A pair of materials at the estimated load. */
typedef struct clod_timestep_pair {
    clod_law law;
    bool wall;
    double m_star;  ///< kg, of the lightest grains
    double overlap; ///< m
    double force;   ///< N
} clod_timestep_pair;

double clod_timestep_rayleigh(const clod_case_material *material, double radius)
{
    if (!(material->youngs_modulus > 0.0)) {
        return 0.0;
    }
    const double nu = material->poissons_ratio;
    const double shear = material->youngs_modulus / (2.0 * (1.0 + nu));
    return M_PI * radius * sqrt(material->density / shear) / (0.1631 * nu + 0.8766);
}

double clod_timestep_impact(const clod_law *law, double r_star, double m_star, double speed)
{
    return clod_law_cycle_impact(law, r_star, 0.5 * m_star * speed * speed);
}

double clod_timestep_unloading(const clod_law *law, double r_star, double overlap)
{
    return clod_law_tangent(law, overlap, r_star) * law->k2 / law->k1;
}

double clod_timestep_period(double mass, double stiffness)
{
    return 2.0 * M_PI * sqrt(mass / stiffness);
}

double clod_timestep_force(double stress, double radius)
{
    return stress * 4.0 * radius * radius;
}

/** Reduced mass of two grains of one radius; with a wall the grain's own. */
static double reduced_mass(const clod_case *from, int a, int b, bool wall, double radius)
{
    const double volume = 4.0 / 3.0 * M_PI * radius * radius * radius;
    const double mass_a = volume * from->materials[a].density;
    const double mass_b = volume * from->materials[b].density;
    return wall ? mass_a : mass_a * mass_b / (mass_a + mass_b);
}

static clod_timestep_pair make_pair(const clod_case *from, const clod_timestep_grains *grains,
                                    int a, int b, bool wall)
{
    const double radius = grains->radius_mean;
    const double r_star = wall ? radius : 0.5 * radius;
    clod_timestep_pair pair = {.wall = wall};
    pair.law =
        clod_law_make(clod_case_pair(from, a, b), &from->materials[a], &from->materials[b]);
    pair.m_star = reduced_mass(from, a, b, wall, grains->radius_min);
    const double force = clod_timestep_force(grains->stress, radius);
    const double rest = clod_law_cycle_overlap(&pair.law, r_star, force);
    const double mass = reduced_mass(from, a, b, wall, radius);
    const double impact = clod_timestep_impact(&pair.law, r_star, mass, grains->speed);
    pair.overlap = fmax(fmax(rest, impact), LEAST_OVERLAP * radius);
    pair.force = clod_law_cycle_force(&pair.law, r_star, pair.overlap);
    return pair;
}

static double spring_period(clod_timestep_spring spring)
{
    return clod_timestep_period(spring.mass, spring.stiffness);
}

static clod_timestep_spring stiffer(clod_timestep_spring a, clod_timestep_spring b)
{
    return b.stiffness > 0.0 && spring_period(b) < spring_period(a) ? b : a;
}

/**
 * The spring of a pair with the shortest period. Masses: a slip moves and turns both grains,
 * 1/m* + R^2/I each gives 2/7 m*; rolling turns them alone, with a stiffness per R*^2, which
 * gives (I/2)/(R/2)^2 = 1.6 m* for two equal grains and 0.4 m* at a wall.
 */
static clod_timestep_spring stiffest_spring(const clod_timestep_pair *pair, double radius)
{
    const clod_law *law = &pair->law;
    const double r_star = pair->wall ? radius : 0.5 * radius;
    const double loading = clod_law_tangent(law, pair->overlap, r_star);
    const double tangential = law->tangential == CLOD_TANGENTIAL_LITERAL
                                  ? law->literal_stiffness
                                  : law->tangent_ratio * loading;
    const double unloading = clod_timestep_unloading(law, r_star, pair->overlap);
    double rolling = 0.0; // cdt has no spring
    if (law->rolling == CLOD_ROLLING_EPSD) {
        rolling = law->epsd_ratio * loading;
    } else if (law->rolling == CLOD_ROLLING_EPSD2) {
        rolling = tangential;
    }
    const double turning = (pair->wall ? 0.4 : 1.6) * pair->m_star;
    clod_timestep_spring s = {CLOD_TIMESTEP_UNLOADING, unloading, pair->m_star};
    if (law->friction > 0.0) {
        s = stiffer(s, (clod_timestep_spring){CLOD_TIMESTEP_TANGENTIAL, tangential,
                                              2.0 / 7.0 * pair->m_star});
    }
    return stiffer(s, (clod_timestep_spring){CLOD_TIMESTEP_ROLLING, rolling, turning});
}

/** Take a pair's numbers into the result when it asks for a smaller step than all before. */
static void meet(const clod_case *from, const clod_timestep_grains *grains, int a, int b,
                 bool wall, clod_timestep *self)
{
    const clod_timestep_pair pair = make_pair(from, grains, a, b, wall);
    const clod_timestep_spring spring = stiffest_spring(&pair, grains->radius_mean);
    const double period = spring_period(spring);
    if (!(self->limit > 0.0) || period / M_PI < self->limit) {
        self->limit = period / M_PI;
        self->limit_force = pair.force;
        self->limit_a = from->materials[a].name;
        self->limit_b = from->materials[b].name;
        self->limit_wall = wall;
    }
    double step = from->time.safety * period / M_PI;
    clod_timestep_reason reason = spring.reason;
    if (pair.law.kind == CLOD_LAW_HERTZ) {
        const double rayleigh = clod_timestep_rayleigh(&from->materials[a], grains->radius_min);
        step = from->time.rayleigh_limit * rayleigh;
        reason = CLOD_TIMESTEP_RAYLEIGH;
    }
    if (self->automatic > 0.0 && step >= self->automatic) {
        return;
    }
    self->automatic = step;
    self->reason = reason;
    self->material_a = a;
    self->material_b = b;
    self->wall = wall;
    self->stiffness = spring.stiffness;
    self->mass = spring.mass;
    self->period = period;
    self->critical = period / M_PI;
    const double r_star = wall ? grains->radius_mean : 0.5 * grains->radius_mean;
    self->unloading = clod_timestep_unloading(&pair.law, r_star, pair.overlap);
    self->force = pair.force;
    self->overlap = pair.overlap;
    self->overlap_ratio = pair.overlap / grains->radius_mean;
}

static const char *reason_text(clod_timestep_reason reason)
{
    switch (reason) {
    case CLOD_TIMESTEP_UNLOADING:
        return "normal stiffness of unloading (k2)";
    case CLOD_TIMESTEP_TANGENTIAL:
        return "tangential stiffness";
    case CLOD_TIMESTEP_ROLLING:
        return "rolling stiffness";
    default:
        return "Rayleigh time";
    }
}

/** Smallest Rayleigh time of the grains, 0 when no material has a Young's modulus. */
static double smallest_rayleigh(const clod_case *from, const clod_timestep_grains *grains)
{
    double smallest = 0.0;
    for (size_t m = 0; m < from->material_count; m++) {
        const double t = clod_timestep_rayleigh(&from->materials[m], grains->radius_min);
        if (grains->is_grain[m] && t > 0.0 && (smallest == 0.0 || t < smallest)) {
            smallest = t;
        }
    }
    return smallest;
}

clod_timestep clod_timestep_choose(const clod_case *from, const clod_timestep_grains *grains)
{
    clod_timestep self = {0};
    const int materials = (int)from->material_count;
    for (int a = 0; a < materials; a++) {
        for (int b = 0; grains->is_grain[a] && b < materials; b++) {
            if (grains->is_grain[b] && b >= a) {
                meet(from, grains, a, b, false, &self);
            }
            if (grains->is_wall[b]) {
                meet(from, grains, a, b, true, &self);
            }
        }
    }
    self.given = from->time.step > 0.0;
    self.step = self.given ? from->time.step : self.automatic;
    self.text = reason_text(self.reason);
    self.rayleigh = smallest_rayleigh(from, grains);
    self.rayleigh_fraction = self.rayleigh > 0.0 ? self.step / self.rayleigh : 0.0;
    return self;
}

bool clod_timestep_accept(const clod_timestep *self, clod_status *status)
{
    if (!self->given || !(self->limit > 0.0) || self->step <= self->limit) {
        return true;
    }
    return clod_status_fail(
        status, CLOD_USAGE,
        "time.step: %.4g s is beyond the critical step of the stiffest contact, under %.4g N "
        "between %s and %s%s (time.design_stress changes this load): the run would blow up. It "
        "must be at most %.4g s, which is the largest stable step of a single contact; write "
        "auto, which takes %.4g s",
        self->step, self->limit_force, self->limit_a, self->limit_b,
        self->limit_wall ? " (wall)" : "", self->limit, self->automatic);
}
