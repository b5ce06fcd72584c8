// A hopper, cone below cylinder, that discharges: as shapes, and as one mesh. What it carries as it
// discharges follows from Newton's second law alone: all that falls out comes down on it again.
#include <math.h>

#include "base/memory.h"
#include "verify/facets.h"
#include "verify/suite.h"
#include "verify/twin.h"

#define DIAMETER 5e-3 ///< m, mean of the grains
#define ORIFICE 0.015 ///< m, radius: 6 grains wide
#define RADIUS 0.04   ///< m, of the cylinder
#define CONE 0.0433   ///< m, height of the cone: 30 degrees from the vertical
#define TOP 0.17      ///< m
#define BOTTOM (-0.03)
#define LEFT (-DIAMETER) ///< m, below this a grain has left
#define SIDES 90
#define GRAINS 2500

static const char *const QUANTITIES[] = {"discharge rate [kg/s]",
                                         "downward force on the filled hopper [N]"};

static void put_case(FILE *out, bool mesh, int seed)
{
    fprintf(out,
            "# Written by clod verify. What falls out comes down on top of the bed.\n"
            "title: Discharge of a hopper\n"
            "seed: %d\n"
            "domain: {min: [-0.09 m, -0.05 m, %g m], max: [0.09 m, 0.05 m, %g m],\n"
            "         periodic: [false, false, true]}\n"
            "materials: {bead: {density: 2500 kg/m3, youngs_modulus: 3 MPa, "
            "poissons_ratio: 0.25}}\n"
            "contacts: {default: {law: hertz, restitution: 0.5, friction: 0.4}}\n"
            "grains:\n"
            "  - material: bead\n"
            "    count: %d\n"
            "    radius: {distribution: uniform, min: %g m, max: %g m}\n"
            "    region: {annulus: {center: [0 m, 0 m, %g m], outer_radius: %g m, height: "
            "%g m}}\n"
            "walls:\n"
            "  hopper:\n"
            "    material: bead\n",
            seed, BOTTOM, TOP, GRAINS, 0.45 * DIAMETER, 0.55 * DIAMETER, CONE, RADIUS,
            TOP - CONE - DIAMETER);
    if (mesh) {
        fprintf(out, "    shapes: [{mesh: {file: hopper.stl, unit: 1 m}}]\n");
    } else {
        fprintf(out,
                "    shapes:\n"
                "      - cone: {foot: [0 m, 0 m, 0 m], axis: [0, 0, 1], foot_radius: %g m, "
                "top_radius: %g m, length: %g m, side: inside}\n"
                "      - cylinder: {foot: [0 m, 0 m, %g m], axis: [0, 0, 1], radius: %g m, "
                "length: %g m, side: inside}\n",
                ORIFICE, RADIUS, CONE, CONE, RADIUS, TOP - CONE - 0.5 * DIAMETER);
    }
    fprintf(
        out,
        "  gate:\n"
        "    material: bead\n"
        "    shapes: [{disc: {center: [0 m, 0 m, %g m], normal: [0, 0, 1], radius: %g m}}]\n"
        "stages:\n"
        "  - {name: fill, duration: 0.3 s}\n"
        "  - {name: filled, duration: 0.1 s}\n"
        "  - {name: open, duration: 0.05 s, walls: {gate: {velocity: [%g m/s, 0 m/s, 0 "
        "m/s]}}}\n"
        "  - {name: begin, duration: 0.15 s, walls: {gate: {velocity: [0 m/s, 0 m/s, 0 "
        "m/s]}}}\n"
        "  - {name: flow, duration: 1 s}\n"
        "output: {series_interval: 5 ms}\n",
        -0.1 * DIAMETER, ORIFICE + 0.002, 0.05 / 0.05);
}

static bool put_meshes(const char *folder, clod_status *status)
{
    static const double LINE[][2] = {
        {ORIFICE, 0.0}, {RADIUS, CONE}, {RADIUS, 0.1}, {RADIUS, TOP - 0.5 * DIAMETER}};
    clod_verify_facets hopper;
    if (!clod_verify_facets_open(&hopper, folder, "hopper", status)) {
        return false;
    }
    clod_verify_facets_lathe(&hopper, LINE, 4, SIDES);
    return clod_verify_facets_close(&hopper, status);
}

/** Follow every grain through the periodic height; mass that has sunk below LEFT [kg]. */
static double follow(double *last, const clod_state *state)
{
    const clod_grains *grains = &state->grains;
    double gone = 0.0;
    for (size_t g = 0; g < grains->count; g++) {
        double *before = &last[grains->id[g]];
        const double now = *before + clod_domain_separation(&state->domain, 2,
                                                            grains->position[g][2], *before);
        gone += *before > LEFT && now <= LEFT ? grains->velocity[g][3] : 0.0;
        *before = grains->position[g][2];
    }
    return gone;
}

/** Room for the heights, as they are now. */
static bool begin_to_follow(clod_verify_twin_run *self, const clod_state *state,
                            clod_status *status)
{
    self->last = clod_memory_alloc(state->grains.count, sizeof *self->last);
    if (self->last == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %d grains", GRAINS);
    }
    for (size_t g = 0; g < state->grains.count; g++) {
        self->last[state->grains.id[g]] = state->grains.position[g][2];
    }
    self->begin = state->time;
    return true;
}

/** What a run notes of the discharge. */
enum { WEIGHT, BEGIN, END, BEGIN_MOMENTUM, END_MOMENTUM, IMPULSE, MOMENTUM, SQUARE };
_Static_assert(SQUARE < CLOD_VERIFY_TWIN_OWN, "room for them");

/** Note force on the walls and momentum of the grains, upwards; MOMENTUM and SQUARE are sums over
 *  the looks. */
static void weigh(clod_verify_twin_run *self, const clod_state *state, bool first)
{
    double *own = self->own, mass = 0.0, momentum = 0.0, force = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        mass += state->grains.velocity[g][3];
        momentum += state->grains.velocity[g][3] * state->grains.velocity[g][2];
    }
    for (int32_t w = 0; w < state->walls.count; w++) {
        force -= state->walls.wall[w].sum_force.z;
    }
    own[WEIGHT] = -mass * state->gravity[2];
    own[END] = state->time;
    own[END_MOMENTUM] = momentum;
    own[MOMENTUM] += momentum;
    own[SQUARE] += momentum * momentum;
    if (first) {
        own[BEGIN] = state->time;
        own[BEGIN_MOMENTUM] = momentum;
    } else {
        own[IMPULSE] += force * state->dt;
    }
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    clod_verify_twin_run *self = context;
    const clod_wall *hopper = &now->state.walls.wall[0];
    if (clod_verify_bed_is_in(now, "filled")) {
        clod_verify_twin_add(self, 1, -hopper->sum_force.z / (double)hopper->sum_steps);
    } else if (clod_verify_bed_is_in(now, "flow")) {
        weigh(self, &now->state, self->last == NULL);
        self->looks++;
        if (self->last == NULL && !begin_to_follow(self, &now->state, status)) {
            return false;
        }
        self->sum[0] += follow(self->last, &now->state);
        self->weight[0] = now->state.time - self->begin;
    }
    return true;
}

/** Two-sided 99 % of the normal distribution. */
#define NORMAL 2.576
/** Of the force: the sums of steps and the momentum are half a step apart at either end. */
#define HALF_STEPS 1e-4

/**
 * Newton's second law, twice. The mean force on the walls less the momentum gained in the time
 * is the weight, but for the steps. And the mean force alone is the weight but for chance:
 * it is off by (P(T) - P(0))/T, so its standard error is that of the momentum, times the root of
 * two, over T. (Forces of blocks of time are anticorrelated: their scatter tells too much.)
 */
static bool check(const clod_verify_bench *bench, bool mesh, const clod_verify_twin_run *runs,
                  clod_status *status)
{
    const char *walls = mesh ? "meshes" : "shapes";
    double worst = 1.0, force = 0.0, weight = 0.0, variance = 0.0;
    for (int s = 0; s < CLOD_VERIFY_TWIN_SEEDS; s++) {
        const double *own = runs[s].own, time = own[END] - own[BEGIN], looks = runs[s].looks;
        const double mean = own[MOMENTUM] / looks;
        const double gained = own[END_MOMENTUM] - own[BEGIN_MOMENTUM];
        const double ratio = (own[IMPULSE] - gained) / time / own[WEIGHT];
        worst = fabs(ratio - 1.0) >= fabs(worst - 1.0) ? ratio : worst;
        force += own[IMPULSE] / time / CLOD_VERIFY_TWIN_SEEDS;
        weight += own[WEIGHT] / CLOD_VERIFY_TWIN_SEEDS;
        variance += 2.0 * (own[SQUARE] / looks - mean * mean) / (time * time) /
                    (CLOD_VERIFY_TWIN_SEEDS * CLOD_VERIFY_TWIN_SEEDS);
    }
    const clod_verify_expect law = {1.0, HALF_STEPS, true, "Newton's second law"};
    const clod_verify_expect chance = {weight, NORMAL * sqrt(variance), false,
                                       "the weight; 99 % interval of the momentum's scatter"};
    return clod_verify_bench_check(bench, &law, worst, status,
                                   "walls as %s: force as it discharges less momentum gained, "
                                   "over the weight; the worst of three seeds",
                                   walls) &&
           clod_verify_bench_check(bench, &chance, force, status,
                                   "walls as %s: downward force as it discharges [N]", walls);
}

bool clod_verify_mesh_hopper(const clod_verify_bench *bench, clod_status *status)
{
    const clod_verify_twin twin = {.name = "mesh-hopper",
                                   .quantities = QUANTITIES,
                                   .count = 2,
                                   .put_case = put_case,
                                   .put_meshes = put_meshes,
                                   .look = look,
                                   .check = check};
    return clod_verify_twin_compare(&twin, bench, status);
}
