// No contact makes energy: oblique impacts over laws, rolling models, limits and time steps.
#include <math.h>
#include <stdio.h>

#include "verify/hertz.h"
#include "verify/passive.h"
#include "verify/rebound.h"
#include "verify/suite.h"

/** Of the energy of an impact: a loss is a sum of some ten products, none larger than that. */
#define ROUNDING 1e-14
#define PASSIVE                                                                                \
    "a contact takes energy and makes none: src/verify/passive.h, docs/theory/energy.md"
#define FIRST_ORDER                                                                            \
    "forces know the velocity of half a step earlier: first order, docs/theory/energy.md"
#define INTEGRATED "equations of the passive rule, integrated in src/verify/rebound.c"

static const double ANGLES[] = {0.0,  1.0,  3.0,  10.0, 20.0, 35.0,
                                45.0, 60.0, 75.0, 85.0, 88.0, 89.0};
#define ANGLE_COUNT ((int)(sizeof ANGLES / sizeof *ANGLES))

static const char *const MADE[CLOD_VERIFY_MADE_COUNT] = {
    "lost_plastic below zero in a step",
    "lost_dash_pot below zero in a step",
    "lost_friction below zero in a step",
    "lost_rolling below zero in a step",
    "made by friction against its spring in a step",
    "made by the rolling torque against its spring in a step",
    "kinetic energy after, beyond that before",
};

// ---- what several decks made together

typedef struct worst {
    double made[CLOD_VERIFY_MADE_COUNT];
    int impacts, touching;
} worst;

static void keep_worst(const clod_verify_passive_found *found, worst *self)
{
    self->impacts += found->impacts;
    self->touching += found->touching;
    for (int m = 0; m < CLOD_VERIFY_MADE_COUNT; m++) {
        self->made[m] = clod_verify_larger(self->made[m], found->made[m]);
    }
}

static bool check_worst(const clod_verify_bench *bench, const char *what, const worst *self,
                        clod_status *status)
{
    const clod_verify_expect none = {0.0, ROUNDING, false, PASSIVE};
    const clod_verify_expect all = {self->impacts, 0.0, false, "every grain meets its partner"};
    bool ok = clod_verify_bench_check(bench, &all, self->touching, status,
                                      "%s: impacts seen in contact [1]", what);
    for (int m = 0; ok && m < CLOD_VERIFY_MADE_COUNT; m++) {
        ok = clod_verify_bench_check(bench, &none, self->made[m], status,
                                     "%s: %s, largest, over E [1]", what, MADE[m]);
    }
    return ok;
}

// ---- laws, rolling models and limits

/** A law, with stiffnesses for grains of passive.h that meet at 1 m/s. */
typedef struct kind {
    const char *name, *keys;
    double young;    ///< Pa; 0: the law needs none
    double duration; ///< s, pi sqrt(m/k1), or 2.94 d/v of the loading branch (hertz.h)
} kind;

#define ORE "exponent: 1.5, k1: 4.75e8 N/m^1.5, k2: 2.37e9 N/m^1.5"

static const kind KINDS[] = {
    {"hertz", "law: hertz", 140e9, 2.5e-5},
    {"hooke", "law: hooke, k1: 2e7 N/m", 0.0, 1.2e-5},
    {"mepa", "law: mepa, k_adh: 3.56e8 N/m^1.5, " ORE, 0.0, 4e-5},
    {"luding", "law: luding, k1: 2e6 N/m, k2: 1e7 N/m, k_adh: 1e6 N/m, plasticity_depth: 0.002",
     0.0, 3.6e-5},
    {"eepa", "law: eepa, k_adh: 3.56e8 N/m^1.5, pull_off_force: 0.5 N, " ORE, 0.0, 4e-5},
    {"eepa-patch", "law: eepa, surface_energy: 2 J/m2, " ORE, 0.0, 4e-5},
};
#define KIND_COUNT ((int)(sizeof KINDS / sizeof *KINDS))

static const char *const ROLLING[] = {"none", "cdt", "epsd", "epsd2"};
static const char *const COULOMB[] = {"paper", "force", "adhesive"};
static const double RESTITUTION[] = {0.3, 0.6, 0.9, 0.98};
static const double FRICTION[] = {0.1, 0.4, 1.0};

/** What a deck of a kind varies: indices of the tables above. */
typedef struct choice {
    int rolling, coulomb, restitution, friction;
} choice;

/** @param parts  of the automatic step */
static bool run_kind(const clod_verify_bench *bench, const kind *law, choice c, double parts,
                     bool pairs, clod_verify_passive_found *found, clod_status *status)
{
    char name[128];
    char keys[512];
    snprintf(name, sizeof name, "%s-%s-%s-%s-e%g-mu%g-%g", bench->test, law->name,
             ROLLING[c.rolling], COULOMB[c.coulomb], RESTITUTION[c.restitution],
             FRICTION[c.friction], parts);
    snprintf(keys, sizeof keys,
             "%s, restitution: %g, friction: %g, coulomb: %s, rolling: %s%s%s", law->keys,
             RESTITUTION[c.restitution], FRICTION[c.friction], COULOMB[c.coulomb],
             ROLLING[c.rolling], c.rolling > 0 ? ", rolling_friction: 0.2" : "",
             c.rolling == 2 ? ", rolling_damping: 0.3" : "");
    const clod_verify_passive passive = {.name = name,
                                         .keys = keys,
                                         .young = law->young,
                                         .plane_young = law->young,
                                         .plane_poisson = CLOD_VERIFY_PASSIVE_POISSON,
                                         .speed = 1.0,
                                         .duration = law->duration,
                                         .parts = parts,
                                         .angles = ANGLES,
                                         .angle_count = ANGLE_COUNT,
                                         .pairs = pairs};
    return clod_verify_passive_run(bench, &passive, found, status);
}

/** All rolling models and limits of a law, each with one restitution and friction. */
static bool sweep(const clod_verify_bench *bench, const kind *law, worst *found,
                  clod_status *status)
{
    bool ok = true;
    for (int k = 0; ok && k < 24; k++) {
        const int n = k / 2;
        const choice c = {n % 4, n / 4, (n + n / 4) % 4, n % 3};
        clod_verify_passive_found one;
        ok = run_kind(bench, law, c, k % 2 == 0 ? 1.0 : 10.0, true, &one, status);
        if (ok) {
            keep_worst(&one, found);
        }
    }
    return ok;
}

/** Largest difference of two rebounds over the angles. */
static double differ(const clod_verify_passive_found *one,
                     const clod_verify_passive_found *other)
{
    double most = 0.0;
    for (int k = 1; k < ANGLE_COUNT; k++) { // at 0 deg there is nothing along the tangent
        most = clod_verify_larger(most, fabs(one->rebound[k] - other->rebound[k]));
    }
    return most;
}

#define PARTS 4

/** The automatic step and a tenth, hundredth and thousandth of it. */
static bool refine(const clod_verify_bench *bench, const kind *law, worst *found,
                   clod_status *status)
{
    const choice c = {2, 2, 2, 1}; // epsd, adhesive, 0.9, 0.4
    const clod_verify_expect first = {1.0, 0.1, false, FIRST_ORDER};
    clod_verify_passive_found one[PARTS];
    for (int s = 0; s < PARTS; s++) {
        if (!run_kind(bench, law, c, pow(10.0, s), false, &one[s], status)) {
            return false;
        }
        keep_worst(&one[s], found);
    }
    // the error is C h: 1/100 and 1/1000 of the automatic step h differ by 0.009 C h
    const double coarse = differ(&one[1], &one[2]);
    const double fine = differ(&one[2], &one[3]);
    const clod_verify_expect small = {0.0, 2e-4, false, FIRST_ORDER};
    return clod_verify_bench_check(bench, &first, log10(coarse / fine), status,
                                   "%s: order of E'/E along the tangent in the step, 1/10 to "
                                   "1/1000 of the automatic one [1]",
                                   law->name) &&
           clod_verify_bench_check(
               bench, &small, fine, status,
               "%s: E'/E along the tangent, 1/100 against 1/1000, worst of 1-89 deg [1]",
               law->name) &&
           clod_verify_bench_check(bench, &first, log10(one[2].lag / one[3].lag), status,
                                   "%s: order of the ledger's lag in the step [1]", law->name);
}

// ---- the cases that friction made energy in

#define ALUMINA 380e9 ///< Pa
#define GLASS 70e9    ///< Pa
#define GLASS_POISSON 0.25
#define STEPS 4

/** Impacts of aluminium oxide on glass. */
typedef struct known {
    const char *name, *title;
    double speed, duration; ///< m/s, s
    double restitution, friction;
    double angle;       ///< deg
    double step[STEPS]; ///< s; 0: automatic
    /** What the cut sum of spring and dash-pot gave when it was left in the spring. */
    const char *before[STEPS]; ///< NULL: no more steps
} known;

static const known KNOWN[] = {
    {.name = "alumina-glass-fast",
     .title = "alumina on glass, 3.9 m/s, 1 deg, e 0.98",
     .speed = 3.9,
     .duration = 2e-5,
     .restitution = 0.98,
     .friction = 0.092,
     .angle = 1.0,
     .step = {0.0, 1e-8, 1e-9, 2e-10},
     .before = {"0.800", "0.922", "1.719", "1.842"}},
    {.name = "alumina-glass-slow",
     .title = "alumina on glass, 0.01 m/s, 3 deg, e 0.9",
     .speed = 0.01,
     .duration = 8e-5,
     .restitution = 0.9,
     .friction = 0.1,
     .angle = 3.0,
     .step = {0.0, 2e-8, 1e-9},
     .before = {"0.915", "1.029", "1.045"}},
};
#define KNOWN_COUNT ((int)(sizeof KNOWN / sizeof *KNOWN))

/** What the equations give at an angle [deg]. */
static double integrate(const known *self, double angle)
{
    const double nu = CLOD_VERIFY_PASSIVE_POISSON;
    const double compliance =
        (1.0 - nu * nu) / ALUMINA + (1.0 - GLASS_POISSON * GLASS_POISSON) / GLASS; // 1/E*
    const double shear = (2.0 - nu) * 2.0 * (1.0 + nu) / ALUMINA +
                         (2.0 - GLASS_POISSON) * 2.0 * (1.0 + GLASS_POISSON) / GLASS; // 1/G*
    const clod_verify_rebound rebound = {
        .radius = CLOD_VERIFY_PASSIVE_RADIUS,
        .mass =
            clod_verify_hertz_sphere(CLOD_VERIFY_PASSIVE_DENSITY, CLOD_VERIFY_PASSIVE_RADIUS),
        .young_star = 1.0 / compliance,
        .shear_star = 1.0 / shear,
        .restitution = self->restitution,
        .friction = self->friction,
        .normal = self->speed * cos(angle * M_PI / 180.0),
        .slip = self->speed * sin(angle * M_PI / 180.0)};
    return clod_verify_rebound_energy(&rebound, 100000);
}

/** First order: three steps of the duration of the impact; and the integration's own error. */
static double tolerance(const known *self, double step)
{
    return 3.0 * step / self->duration + 2e-5;
}

static bool run_known(const clod_verify_bench *bench, const known *self, double step,
                      const double *angles, int count, clod_verify_passive_found *found,
                      clod_status *status)
{
    char name[96];
    char keys[128];
    snprintf(name, sizeof name, "%s-%s-%g-%d", bench->test, self->name, step, count);
    snprintf(keys, sizeof keys, "law: hertz, restitution: %g, friction: %g, rolling: none",
             self->restitution, self->friction);
    const clod_verify_passive passive = {.name = name,
                                         .keys = keys,
                                         .young = ALUMINA,
                                         .plane_young = GLASS,
                                         .plane_poisson = GLASS_POISSON,
                                         .speed = self->speed,
                                         .duration = self->duration,
                                         .parts = step > 0.0 ? 0.0 : 1.0,
                                         .step = step,
                                         .angles = angles,
                                         .angle_count = count};
    return clod_verify_passive_run(bench, &passive, found, status);
}

/** One angle at steps from the automatic one down. */
static bool check_known(const clod_verify_bench *bench, const known *self, clod_status *status)
{
    worst made = {{0.0}, 0, 0};
    for (int k = 0; k < STEPS && self->before[k] != NULL; k++) {
        clod_verify_passive_found found;
        if (!run_known(bench, self, self->step[k], &self->angle, 1, &found, status)) {
            return false;
        }
        const clod_verify_expect expect = {integrate(self, self->angle),
                                           tolerance(self, found.step), true, INTEGRATED};
        if (!clod_verify_bench_check(bench, &expect, found.rebound[0], status,
                                     "%s: E'/E along the tangent, step %.3g s%s; %s before "
                                     "ADR 0025 [1]",
                                     self->title, found.step,
                                     self->step[k] > 0.0 ? "" : " (auto)", self->before[k])) {
            return false;
        }
        keep_worst(&found, &made);
    }
    return check_worst(bench, self->name, &made, status);
}

/** All angles at one small step. */
static bool check_angles(const clod_verify_bench *bench, const known *self, clod_status *status)
{
    const double step = 1e-9;
    clod_verify_passive_found found;
    clod_verify_worst worst_angle = CLOD_VERIFY_WORST;
    if (!run_known(bench, self, step, ANGLES, ANGLE_COUNT, &found, status)) {
        return false;
    }
    for (int k = 1; k < ANGLE_COUNT; k++) {
        clod_verify_worst_offer(&worst_angle, ANGLES[k], integrate(self, ANGLES[k]),
                                found.rebound[k]);
    }
    const clod_verify_expect expect = {worst_angle.expected, tolerance(self, step), true,
                                       INTEGRATED};
    return clod_verify_bench_check(bench, &expect, worst_angle.got, status,
                                   "%s: E'/E along the tangent, step %.3g s, 1-89 deg, worst "
                                   "at %.0f deg [1]",
                                   self->name, step, worst_angle.at);
}

// ---- the tests

bool clod_verify_passivity(const clod_verify_bench *bench, clod_status *status)
{
    bool ok = true;
    for (int k = 0; ok && k < KIND_COUNT; k++) {
        worst found = {{0.0}, 0, 0};
        ok = sweep(bench, &KINDS[k], &found, status) &&
             refine(bench, &KINDS[k], &found, status) &&
             check_worst(bench, KINDS[k].name, &found, status);
    }
    for (int k = 0; ok && k < KNOWN_COUNT; k++) {
        ok = check_known(bench, &KNOWN[k], status) && check_angles(bench, &KNOWN[k], status);
    }
    return ok;
}

/**
 * Every restitution with every friction, too. Below a tenth of the automatic step only one of
 * each for every rolling model and limit: they take the time.
 */
static bool sweep_all(const clod_verify_bench *bench, const kind *law, double parts,
                      worst *found, clod_status *status)
{
    for (int k = 0; k < 144; k++) {
        const choice c = {k % 4, k / 4 % 3, k / 12 % 4, k / 48};
        clod_verify_passive_found one;
        if (parts > 10.0 && k % 12 != k / 12) {
            continue;
        }
        if (!run_kind(bench, law, c, parts, true, &one, status)) {
            return false;
        }
        keep_worst(&one, found);
    }
    return true;
}

bool clod_verify_passivity_sweep(const clod_verify_bench *bench, clod_status *status)
{
    bool ok = true;
    for (int k = 0; ok && k < KIND_COUNT; k++) {
        for (int s = 0; ok && s < PARTS; s++) {
            char what[64];
            worst found = {{0.0}, 0, 0};
            const double parts = pow(10.0, s);
            snprintf(what, sizeof what, "%s, 1/%g of the automatic step", KINDS[k].name, parts);
            ok = sweep_all(bench, &KINDS[k], parts, &found, status) &&
                 check_worst(bench, what, &found, status);
        }
    }
    return ok;
}
