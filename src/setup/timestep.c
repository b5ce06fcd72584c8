#include "setup/timestep.h"

#include <math.h>
#include <stdio.h>

#include "law/law_kinds.h"
#include "law/law_springs.h"
#include "setup/collision.h"
#include "setup/lattice.h"

/** Overlap assumed at least, as a fraction of the radius: a bed without load is not soft. */
#define LEAST_OVERLAP 1e-4

/** A spring of a contact, and the mass that swings on it. */
typedef struct clod_timestep_spring {
    clod_timestep_reason reason;
    double stiffness, mass;
} clod_timestep_spring;

/** Overlap of a sheared bed's deepest contact over that of the mean load, as measured in copper ore; of other beds it is
 *  6 to 80. A bed that is not sheared goes with the mean load (docs/theory/stability.md). */
#define DEEPEST 17.0

/** One of the two that meet, as a sphere; a wall has no end. */
typedef struct clod_timestep_body {
    double least, mean; ///< m, radii of the smallest and of the mean grain
    double density;     ///< kg/m3
} clod_timestep_body;

/** A pair of materials at the estimated load. */
typedef struct clod_timestep_pair {
    clod_law law;
    clod_timestep_body a, b;
    bool wall;
    double m_star;  ///< kg, of the smallest grains
    double r_star;  ///< m, of the mean grains
    double radius;  ///< m, of the smaller mean grain
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
    return clod_law_stiffest(law, overlap, r_star);
}

double clod_timestep_period(double mass, double stiffness)
{
    return 2.0 * M_PI * sqrt(mass / stiffness);
}

double clod_timestep_force(double stress, double radius)
{
    return stress * 4.0 * radius * radius;
}

void clod_timestep_add(clod_timestep_sizes *self, double count, double radius)
{
    self->least = self->count > 0.0 ? fmin(self->least, radius) : radius;
    self->sum += count * radius;
    self->count += count;
}

static double sphere_mass(double radius, double density)
{
    return 4.0 / 3.0 * M_PI * radius * radius * radius * density;
}

/** Reduced mass of two grains; with a wall the grain's own. */
static double reduced_mass(const clod_timestep_pair *pair, double radius_a, double radius_b)
{
    const double mass_a = sphere_mass(radius_a, pair->a.density);
    const double mass_b = sphere_mass(radius_b, pair->b.density);
    return pair->wall ? mass_a : mass_a * mass_b / (mass_a + mass_b);
}

static clod_timestep_body make_body(const clod_case *from, const clod_timestep_grains *grains,
                                    int material)
{
    const clod_timestep_sizes *sizes = &grains->sizes[material];
    return (clod_timestep_body){.least = sizes->least,
                                .mean = sizes->sum / sizes->count,
                                .density = from->materials[material].density};
}

static clod_timestep_pair make_pair(const clod_case *from, const clod_timestep_grains *grains,
                                    int a, int b, bool wall)
{
    clod_timestep_pair pair = {.wall = wall};
    pair.law =
        clod_law_make(clod_case_pair(from, a, b), &from->materials[a], &from->materials[b]);
    pair.a = make_body(from, grains, a);
    pair.b =
        wall ? (clod_timestep_body){HUGE_VAL, HUGE_VAL, HUGE_VAL} : make_body(from, grains, b);
    pair.m_star = reduced_mass(&pair, pair.a.least, pair.b.least);
    pair.r_star = pair.a.mean / (1.0 + pair.a.mean / pair.b.mean);
    pair.radius = fmin(pair.a.mean, pair.b.mean);
    const double force = clod_timestep_force(grains->stress, pair.radius);
    const double rest = clod_law_cycle_overlap(&pair.law, pair.r_star, force);
    const double mass = reduced_mass(&pair, pair.a.mean, pair.b.mean);
    const double impact = clod_timestep_impact(&pair.law, pair.r_star, mass, grains->speed);
    pair.overlap = fmax(fmax(rest, impact), LEAST_OVERLAP * pair.radius);
    pair.force = clod_law_cycle_force(&pair.law, pair.r_star, pair.overlap);
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
 * Mass on a rolling spring as a multiple of m*: rolling turns the grains alone, with a
 * stiffness per R*^2, so it is I_a I_b/(I_a + I_b)/R*^2, I = 0.4 m R^2: 1.6 m* for two equal
 * grains and 0.4 m* at a wall.
 */
static double turning_ratio(const clod_timestep_pair *pair)
{
    if (pair->wall) {
        return 0.4;
    }
    const double a = pair->a.least;
    const double b = pair->b.least;
    const double mass_a = sphere_mass(a, pair->a.density);
    const double mass_b = sphere_mass(b, pair->b.density);
    return 0.4 * ((mass_a + mass_b) * (a + b) * (a + b) / (mass_a * a * a + mass_b * b * b));
}

/**
 * The spring of a pair with the shortest period. Masses: a slip moves and turns both grains,
 * 1/m* + R^2/I each gives 2/7 m* whatever their sizes.
 */
static clod_timestep_spring stiffest_spring(const clod_timestep_pair *pair)
{
    const clod_law *law = &pair->law;
    const double loading = clod_law_tangent(law, pair->overlap, pair->r_star);
    const double tangential = clod_law_springs_tangential(law, loading);
    const double rolling = clod_law_springs_rolling(law, loading);
    const double unloading = clod_timestep_unloading(law, pair->r_star, pair->overlap);
    const double turning = turning_ratio(pair) * pair->m_star;
    clod_timestep_spring s = {CLOD_TIMESTEP_UNLOADING, unloading, pair->m_star};
    if (law->friction > 0.0) {
        s = stiffer(s, (clod_timestep_spring){CLOD_TIMESTEP_TANGENTIAL, tangential,
                                              2.0 / 7.0 * pair->m_star});
    }
    return stiffer(s, (clod_timestep_spring){CLOD_TIMESTEP_ROLLING, rolling, turning});
}

/** Rayleigh time of a material's grain, with the softening of the case. */
static double rayleigh_time(const clod_case *from, int material, double radius)
{
    const clod_case_material soft =
        clod_law_soften_material(&from->materials[material], from->soften);
    return clod_timestep_rayleigh(&soft, radius);
}

/** Smaller Rayleigh time of the grains of a pair; 0 when neither material has a modulus. */
static double pair_rayleigh(const clod_case *from, const clod_timestep_pair *pair, int a, int b)
{
    const double first = rayleigh_time(from, a, pair->a.least);
    const double second = pair->wall ? 0.0 : rayleigh_time(from, b, pair->b.least);
    return first > 0.0 && second > 0.0 ? fmin(first, second) : fmax(first, second);
}

/** Take a pair's numbers into the result when it asks for a smaller step than all before. */
static void meet(const clod_case *from, const clod_timestep_grains *grains, int a, int b,
                 bool wall, clod_timestep *self)
{
    const clod_timestep_pair pair = make_pair(from, grains, a, b, wall);
    const clod_timestep_spring spring = stiffest_spring(&pair);
    const double period = spring_period(spring);
    if (!wall) {
        const double deep = clod_case_shear(from) != NULL ? DEEPEST : 1.0;
        const double most = from->time.overlap_limit * 2.0 * pair.r_star; // a run stops there
        const double bed = clod_lattice_step(&pair.law, 2.0 * pair.m_star, 2.0 * pair.r_star,
                                             fmin(deep * pair.overlap, most));
        self->bed = self->bed > 0.0 ? fmin(self->bed, bed) : bed;
    }
    if (!(self->limit > 0.0) || period / M_PI < self->limit) {
        self->limit = period / M_PI;
        self->limit_force = pair.force;
        self->limit_a = from->materials[a].name;
        self->limit_b = from->materials[b].name;
        self->limit_wall = wall;
        self->limit_radius_a = pair.a.least;
        self->limit_radius_b = wall ? 0.0 : pair.b.least;
    }
    double step = from->time.safety * period / M_PI;
    clod_timestep_reason reason = spring.reason;
    if (clod_law_kinds_row(pair.law.kind)->rayleigh) {
        step = from->time.rayleigh_limit * pair_rayleigh(from, &pair, a, b);
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
    self->radius_a = pair.a.least;
    self->radius_b = wall ? 0.0 : pair.b.least;
    self->stiffness = spring.stiffness;
    self->mass = spring.mass;
    self->period = period;
    self->critical = period / M_PI;
    self->collision = clod_collision_time(&pair.law, pair.r_star, pair.m_star, pair.overlap);
    self->unloading = clod_timestep_unloading(&pair.law, pair.r_star, pair.overlap);
    self->radius = pair.radius;
    self->force = pair.force;
    self->overlap = pair.overlap;
    self->overlap_ratio = pair.overlap / pair.radius;
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
        const double t = rayleigh_time(from, (int)m, grains->sizes[m].least);
        if (grains->sizes[m].count > 0.0 && t > 0.0 && (smallest == 0.0 || t < smallest)) {
            smallest = t;
        }
    }
    return smallest;
}

/** All pairs that can meet; with `alone`, single grains also with their like. */
static void meet_all(const clod_case *from, const clod_timestep_grains *grains, bool alone,
                     clod_timestep *self)
{
    const int materials = (int)from->material_count;
    for (int a = 0; a < materials; a++) {
        const double count = grains->sizes[a].count;
        for (int b = 0; count > 0.0 && b < materials; b++) {
            const bool pair = b > a ? grains->sizes[b].count > 0.0 : count > 1.0 || alone;
            if (pair && b >= a) {
                meet(from, grains, a, b, false, self);
            }
            if (grains->is_wall[b]) {
                meet(from, grains, a, b, true, self);
            }
        }
    }
}

clod_timestep clod_timestep_choose(const clod_case *from, const clod_timestep_grains *grains)
{
    clod_timestep self = {0};
    meet_all(from, grains, false, &self);
    if (!(self.limit > 0.0)) { // nothing can meet: as if there were a second grain
        meet_all(from, grains, true, &self);
    }
    self.given = from->time.step > 0.0;
    self.step = self.given ? from->time.step : self.automatic;
    self.text = reason_text(self.reason);
    self.rayleigh = smallest_rayleigh(from, grains);
    self.rayleigh_fraction = self.rayleigh > 0.0 ? self.step / self.rayleigh : 0.0;
    return self;
}

/** A material with the radius of its smallest grain, or as a wall. */
static void describe(const char *name, double radius, char text[96])
{
    if (radius > 0.0) {
        snprintf(text, 96, "%.48s (radius %.4g mm)", name, 1e3 * radius);
    } else {
        snprintf(text, 96, "%.48s (wall)", name);
    }
}

bool clod_timestep_accept(const clod_timestep *self, clod_status *status)
{
    if (!self->given || !(self->limit > 0.0) || self->step <= self->limit) {
        return true;
    }
    char a[96], b[96];
    describe(self->limit_a, self->limit_radius_a, a);
    describe(self->limit_b, self->limit_radius_b, b);
    return clod_status_fail(
        status, CLOD_USAGE,
        "time.step: %.4g s is beyond the critical step of the stiffest contact, under %.4g N "
        "between %s and %s (time.design_stress changes this load): the run would blow up. It "
        "must be at most %.4g s, which is the largest stable step of a single contact; write "
        "auto, which takes %.4g s",
        self->step, self->limit_force, a, b, self->limit, self->automatic);
}
