/**
 * @file beverloo.c
 * Discharge of a flat-bottomed silo: rate against orifice,
 *
 *     W = C rho_b sqrt(g) (D - k d)^(5/2)
 *
 * Source: Beverloo, Leniger & van de Velde, Chem. Eng. Sci. 15, 260 (1961); k 1.4 +- 0.1 for
 * spheres and 1 to 2 at most, C 0.55 to 0.65: Nedderman, Statics and Kinematics of Granular
 * Materials (1992), 10.2. The rate does not depend on a silo wider than 2.5 D and D + 30 d
 * (Mankoc et al., Granular Matter 9, 407 (2007)), nor on a bed higher than 2 D: silos are 2.5 D
 * and D + 15 d wide at least, beds 2.4 D high, so that the rain of what has fallen out does not
 * reach down to the orifice.
 *
 * The domain is periodic along z: what has fallen out comes down on top of the bed, so its
 * height stays and the flow is steady.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/fit.h"
#include "base/memory.h"
#include "measure/contacts.h"
#include "verify/bed.h"
#include "verify/rate.h"
#include "verify/suite.h"

#define DIAMETER 5e-3             ///< m, mean of the grains: d
#define BOTTOM (-6.0 * DIAMETER)  ///< m, of the domain
#define GATE (-0.1 * DIAMETER)    ///< m, where it is: clear of grains on the floor
#define LEFT (-1.0 * DIAMETER)    ///< m, the level below which a grain has left
#define SLAB_LOW (3.0 * DIAMETER) ///< m, between these the bulk density is taken
#define SLAB_HIGH (12.0 * DIAMETER)
#define FILL 0.3      ///< s
#define OPENING 0.05  ///< s
#define FLOW 1.0      ///< s
#define UNSTEADY 0.2  ///< s of the flow that are left out
#define INTERVAL 5e-3 ///< s between looks
#define LOOKS 512
#define GRAVITY 9.81 ///< m/s2
#define K_SPHERES 1.4
#define K_ERROR 0.1
#define MANKOC_B 0.051 ///< of glass beads

#define ORIFICE_COUNT 5

/** A silo and its bed, in grain diameters. */
typedef struct silo {
    double orifice, width, height;
} silo;

static const silo SILOS[ORIFICE_COUNT] = {{5.0, 20.0, 16.0},
                                          {6.0, 21.0, 16.0},
                                          {7.5, 22.5, 18.0},
                                          {9.5, 24.5, 23.0},
                                          {12.0, 30.0, 29.0}};

static const char SOURCE[] = "Beverloo et al. 1961; Nedderman 1992";
static const char MANKOC[] = "Mankoc et al., Granular Matter 9 (2007) 407; Beverloo: 0";

/** Discharge of one silo. */
typedef struct discharge {
    double radius;                   ///< m, of the silo
    double *height;                  ///< m, by id, of each grain at the last look
    double time[LOOKS], mass[LOOKS]; ///< s and kg discharged, since the orifice was opened
    size_t count;
    double gone;    ///< kg
    double density; ///< kg/m3, of the bed before
    double overlap; ///< mean of the bed before, over a radius
} discharge;

/** What all silos gave. */
typedef struct silos {
    discharge of[ORIFICE_COUNT];
    clod_verify_rate rate[ORIFICE_COUNT];
    double density; ///< kg/m3, mean
    double overlap; ///< largest of the means
} silos;

/** Grains that fill the bed at a solid fraction of 0.6. */
static int grain_count(const silo *self)
{
    return (int)(0.9 * self->width * self->width * self->height);
}

static void write_case(const silo *self, char *text, size_t size)
{
    const double r = 0.5 * DIAMETER;
    const double orifice = self->orifice * DIAMETER;
    const double radius = 0.5 * self->width * DIAMETER;
    const double top = 1.7 * self->height * DIAMETER; // room for a loose filling
    const double edge = 1.2 * radius;
    snprintf(
        text, size,
        "# Written by clod verify. What falls out of the silo comes down on top of the bed.\n"
        "title: Discharge of a flat-bottomed silo, orifice of %g grains\n"
        "domain: {min: [%g m, %g m, %g m], max: [%g m, %g m, %g m],\n"
        "         periodic: [false, false, true]}\n"
        "materials:\n"
        "  glass: {density: 2500 kg/m3, youngs_modulus: 8 MPa, poissons_ratio: 0.25}\n"
        "contacts:\n"
        "  default: {law: hertz, restitution: 0.5, friction: 0.5}\n"
        "grains:\n"
        "  - material: glass\n"
        "    count: %d\n"
        "    radius: {distribution: uniform, min: %g m, max: %g m}\n"
        "    region: {annulus: {outer_radius: %g m, height: %g m}}\n"
        "walls:\n"
        "  silo:\n"
        "    material: glass\n"
        "    shapes:\n"
        "      - cylinder: {foot: [0 m, 0 m, 0 m], axis: [0, 0, 1], radius: %g m, "
        "length: %g m, side: inside}\n"
        "      - annulus: {center: [0 m, 0 m, 0 m], normal: [0, 0, 1], inner_radius: %g m, "
        "outer_radius: %g m}\n"
        "  gate:\n"
        "    material: glass\n"
        "    shapes: [{disc: {center: [0 m, 0 m, %g m], normal: [0, 0, 1], radius: %g m}}]\n"
        "stages:\n"
        "  - {name: fill, duration: %g s}\n"
        "  - {name: open, duration: %g s, walls: {gate: {velocity: [%g m/s, 0 m/s, 0 m/s]}}}\n"
        "  - {name: flow, duration: %g s, walls: {gate: {velocity: [0 m/s, 0 m/s, 0 m/s]}}}\n"
        "output: {series_interval: %g s, snapshot_interval: 0.1 s}\n",
        self->orifice, -edge - orifice, -edge, BOTTOM, edge + orifice, edge, top,
        grain_count(self), 0.9 * r, 1.1 * r, radius, top - r, radius, top, 0.5 * orifice,
        radius, GATE, 0.5 * orifice, FILL, OPENING, 1.5 * orifice / OPENING, FLOW, INTERVAL);
}

/** Mass of the grains whose centres lie in a slab of the bed, over its volume [kg/m3]. */
static double bulk_density(const clod_grains *grains, double radius)
{
    double mass = 0.0;
    for (size_t g = 0; g < grains->count; g++) {
        const double z = grains->position[g][2];
        mass += z >= SLAB_LOW && z < SLAB_HIGH ? grains->velocity[g][3] : 0.0;
    }
    return mass / (M_PI * radius * radius * (SLAB_HIGH - SLAB_LOW));
}

/** Follow every grain through the periodic height; what sinks below LEFT has left. */
static void follow(discharge *self, const clod_state *state)
{
    const clod_grains *grains = &state->grains;
    for (size_t g = 0; g < grains->count; g++) {
        double *last = &self->height[grains->id[g]];
        const double now =
            *last + clod_domain_separation(&state->domain, 2, grains->position[g][2], *last);
        self->gone += *last > LEFT && now <= LEFT ? grains->velocity[g][3] : 0.0;
        *last = grains->position[g][2];
    }
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    discharge *self = context;
    const clod_grains *grains = &now->state.grains;
    if (now->state.step == 0) {
        for (size_t g = 0; g < grains->count; g++) {
            self->height[grains->id[g]] = grains->position[g][2];
        }
    }
    follow(self, &now->state);
    if (clod_verify_bed_is_in(now, "fill")) {
        self->density = bulk_density(grains, self->radius);
        const bool ok = clod_step_export(&now->step, status);
        self->overlap = clod_measure_contacts_of(&now->state).mean_overlap;
        return ok;
    }
    const double since = now->state.time - FILL - OPENING;
    if (since >= 0.0 && self->count < LOOKS) {
        self->time[self->count] = since;
        self->mass[self->count++] = self->gone;
    }
    return true;
}

/** Rate of the steady part. */
static double evaluate(const discharge *self, double *error)
{
    size_t first = 0;
    while (first < self->count && self->time[first] < UNSTEADY) {
        first++;
    }
    return clod_verify_rate_of(self->time + first, self->mass + first, self->count - first,
                               error);
}

static bool run_silo(const clod_verify_bench *bench, const silo *of, discharge *self,
                     clod_status *status)
{
    char text[4096];
    char name[32];
    self->radius = 0.5 * of->width * DIAMETER;
    self->height = clod_memory_alloc((size_t)grain_count(of), sizeof *self->height);
    if (self->height == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %d grains",
                                grain_count(of));
    }
    snprintf(name, sizeof name, "beverloo-%g", of->orifice);
    write_case(of, text, sizeof text);
    const bool ok = clod_verify_bed_run(bench, name, text, look, self, status);
    clod_memory_free(self->height);
    self->height = NULL;
    return ok;
}

static bool check_exponent(const clod_verify_bench *bench, const silos *self,
                           clod_status *status)
{
    double error;
    double ignored;
    const double found =
        clod_verify_rate_exponent(self->rate, ORIFICE_COUNT, K_SPHERES, &error);
    const double low =
        clod_verify_rate_exponent(self->rate, ORIFICE_COUNT, K_SPHERES + K_ERROR, &ignored);
    const double high =
        clod_verify_rate_exponent(self->rate, ORIFICE_COUNT, K_SPHERES - K_ERROR, &ignored);
    const clod_verify_expect expect = {2.5, 2.0 * error + 0.5 * fabs(high - low), false,
                                       SOURCE};
    if (!clod_verify_bench_check(bench, &expect, found, status,
                                 "exponent of W over D - %g d; two standard errors and k "
                                 "+- %g",
                                 K_SPHERES, K_ERROR)) {
        return false;
    }
    clod_verify_bench_record_miss(bench, "these grains have k of 1.6 to 1.7, with which the "
                                         "exponent is 2.5 (the rows below)");
    return true;
}

/**
 * Bend of W^(2/5) over D by the law of Mankoc et al. for small orifices, W proportional to
 * (1 - exp(-0.051 (D/d - 1))/2) (D/d - 1)^(5/2), with the slope that was found: there
 * Beverloo's line is bent.
 */
static double small_orifice_bend(const double *orifice, double slope)
{
    double root[ORIFICE_COUNT];
    double ignored;
    for (size_t o = 0; o < ORIFICE_COUNT; o++) {
        const double wide = orifice[o] - 1.0;
        root[o] = pow(1.0 - 0.5 * exp(-MANKOC_B * wide), 0.4) * wide;
    }
    const clod_fit line = clod_fit_line(orifice, root, ORIFICE_COUNT);
    return slope / line.slope * clod_fit_sag(&line, orifice, root, ORIFICE_COUNT, &ignored);
}

/** W^(2/5) over D: its line gives k and C, its bend is that of small orifices. */
static bool check_line(const clod_verify_bench *bench, const silos *self, clod_fit *line,
                       clod_status *status)
{
    double orifice[ORIFICE_COUNT];
    double root[ORIFICE_COUNT];
    double bend_error;
    for (size_t o = 0; o < ORIFICE_COUNT; o++) {
        orifice[o] = SILOS[o].orifice;
        root[o] = pow(self->rate[o].value, 0.4);
    }
    *line = clod_fit_line(orifice, root, ORIFICE_COUNT);
    const double bend = clod_fit_sag(line, orifice, root, ORIFICE_COUNT, &bend_error);
    const double c = pow(line->slope / DIAMETER, 2.5) / (self->density * sqrt(GRAVITY));
    const clod_verify_expect small = {small_orifice_bend(orifice, line->slope), bend_error,
                                      false, MANKOC};
    const clod_verify_expect k = {1.5, 0.5, false, SOURCE};
    const clod_verify_expect coefficient = {0.6, 0.05, false, SOURCE};
    return clod_verify_bench_check(bench, &small, bend, status,
                                   "bend of W^(2/5) over D [(kg/s)^(2/5)], 95 %% interval") &&
           clod_verify_bench_check(bench, &k, -line->intercept / line->slope, status,
                                   "k, where W^(2/5) over D is zero") &&
           clod_verify_bench_check(bench, &coefficient, c, status,
                                   "C, from the slope of W^(2/5) over D");
}

static bool check_bed(const clod_verify_bench *bench, const silos *self, clod_status *status)
{
    const clod_verify_expect hard = {0.0, 0.01, false, "hard grains"};
    return clod_verify_bench_check(bench, &hard, self->overlap, status,
                                   "mean overlap of the bed at rest, over a radius");
}

static bool write_rates(const clod_verify_bench *bench, const silos *self, const clod_fit *line,
                        clod_status *status)
{
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, "beverloo-rates", "orifice over grain diameter,clod: rate [kg/s],Beverloo",
        status);
    for (size_t o = 0; curve != NULL && o < ORIFICE_COUNT; o++) {
        const double on_line = pow(line->intercept + line->slope * SILOS[o].orifice, 2.5);
        const double row[] = {SILOS[o].orifice, self->rate[o].value, on_line};
        clod_verify_curve_add(curve, row, 3);
    }
    return curve != NULL && clod_verify_curve_close(&curve, status);
}

static bool write_masses(const clod_verify_bench *bench, const silos *self, clod_status *status)
{
    char header[256] = "time [s]";
    for (size_t o = 0; o < ORIFICE_COUNT; o++) {
        const size_t used = strlen(header);
        snprintf(header + used, sizeof header - used, ",clod: mass [kg] from D = %g d",
                 SILOS[o].orifice);
    }
    clod_verify_curve *curve = clod_verify_curve_open(bench, "beverloo-masses", header, status);
    for (size_t k = 0; curve != NULL && k < self->of[0].count; k++) {
        double row[1 + ORIFICE_COUNT] = {self->of[0].time[k]};
        for (size_t o = 0; o < ORIFICE_COUNT; o++) {
            row[1 + o] = self->of[o].mass[k];
        }
        clod_verify_curve_add(curve, row, 1 + ORIFICE_COUNT);
    }
    return curve != NULL && clod_verify_curve_close(&curve, status);
}

static bool run_silos(const clod_verify_bench *bench, silos *self, clod_status *status)
{
    for (size_t o = 0; o < ORIFICE_COUNT; o++) {
        if (!run_silo(bench, &SILOS[o], &self->of[o], status)) {
            return false;
        }
        self->rate[o].orifice = SILOS[o].orifice;
        self->rate[o].value = evaluate(&self->of[o], &self->rate[o].error);
        self->density += self->of[o].density / ORIFICE_COUNT;
        self->overlap = clod_verify_larger(self->overlap, self->of[o].overlap);
    }
    clod_fit line;
    return check_exponent(bench, self, status) && check_line(bench, self, &line, status) &&
           check_bed(bench, self, status) && write_rates(bench, self, &line, status) &&
           write_masses(bench, self, status);
}

bool clod_verify_beverloo(const clod_verify_bench *bench, clod_status *status)
{
    silos *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for the silos");
    }
    const bool ok = run_silos(bench, self, status);
    clod_memory_free(self);
    return ok;
}
