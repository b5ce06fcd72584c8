// A silo of grains whose wall carries part of their weight: a column in a cylinder of stacked
// shells, on a floor that sinks slowly, so that friction on the wall is mobilised upwards to
// the limit everywhere, as in the experiments of Vanel & Clement. Janssen's law then says how
// much stands on what is below.
#include <math.h>
#include <stdio.h>

#include "analysis/fit.h"
#include "tester/limits.h"
#include "verify/bed.h"
#include "verify/saturation.h"
#include "verify/suite.h"

#define GRAINS 10000
#define RADIUS 3e-3       ///< m, mean of the grains
#define DIAMETER 72e-3    ///< m, of the silo: 12 grains
#define SHELL 36e-3       ///< m, height of a shell: half a diameter
#define SHELLS 14         ///< the column is 7 diameters high
#define STIFFNESS 1e4     ///< N/m: overlaps of 1 % of a radius under the whole column
#define WALL_FRICTION 0.3 ///< well below what the grains can bear among themselves
#define COLUMNS 2         ///< with friction on the wall; each its own seed
#define TEXT 6000
#define LOW 2 ///< shells between these are full and away from floor and top
#define HIGH 11
#define RANKINE (1.0 / 3.0) ///< (1 - sin 30 deg)/(1 + sin 30 deg): active
#define SOURCE "Janssen (1895), transl. Sperl, Granular Matter 8 (2006) 59"

/** One column: what its walls felt while the floor sank, summed over the looks. */
typedef struct column {
    double wall_friction;
    int seed;
    int looks;
    double floor;            ///< N, on the floor, downwards
    double weight;           ///< N, of all grains
    double above[SHELLS];    ///< N, weight of the grains above the foot of a shell
    double friction[SHELLS]; ///< N, on the shell, downwards
    double normal[SHELLS];   ///< N, on the shell, outwards; from the overlaps
    double overlap;          ///< largest, over the smaller radius
} column;

/** What stands on the joints between the shells, from the top down; of several columns. */
typedef struct profile {
    size_t count;
    double filled[COLUMNS * SHELLS];   ///< N, weight above
    double apparent[COLUMNS * SHELLS]; ///< N, what the layer below feels of it
} profile;

/** The case as a text: shells from the floor up, the last one high enough to fill into. */
static void write_case(const column *self, char text[TEXT])
{
    int used = snprintf(
        text, TEXT,
        "# Written by clod verify: Janssen's silo.\n"
        "title: Silo, wall friction %g\n"
        "seed: %d\n"
        "time: {safety: 0.15}\n"
        "materials: {bead: {density: 2500 kg/m3}, floor: {}, shell: {}}\n"
        "contacts:\n"
        "  default: {law: hooke, k1: %g N/m, restitution: 0.5, friction: 0.5, rolling: none,\n"
        "            tangential_ratio: 0.2857142857142857}\n"
        "  bead-shell: {friction: %g}\n"
        "grains:\n"
        "  - material: bead\n"
        "    count: %d\n"
        "    radius: {distribution: uniform, min: %g mm, max: %g mm}\n"
        "    region: {annulus: {outer_radius: %g mm, height: 1.1 m}}\n"
        "stages:\n"
        "  - {name: fill, duration: 1.5 s, rest: 20 mm/s}\n"
        "  - {name: mobilise, duration: 0.3 s, walls: {floor: {velocity: [0 mm/s, 0 mm/s, -10 "
        "mm/s]}}}\n"
        "  - {name: measure, duration: 0.3 s}\n"
        "output: {series_interval: 5 ms}\n"
        "walls:\n"
        "  floor: {material: floor, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, "
        "0, 1]}}]}\n",
        self->wall_friction, self->seed, STIFFNESS, self->wall_friction, GRAINS, 0.9e3 * RADIUS,
        1.1e3 * RADIUS, 0.5e3 * DIAMETER);
    for (int s = 0; s < SHELLS; s++) {
        const double foot = s > 0 ? s * SHELL : -0.5 * SHELL; // the floor sinks into the first
        const double top = s < SHELLS - 1 ? (s + 1) * SHELL : 1.2;
        used +=
            snprintf(text + used, TEXT - (size_t)used,
                     "  shell_%d: {material: shell, shapes: [{cylinder: {foot: [0 mm, 0 mm, "
                     "%g mm], radius: %g mm, length: %g mm}}]}\n",
                     s + 1, 1e3 * foot, 0.5e3 * DIAMETER, 1e3 * (top - foot));
    }
}

static int shell_of(double height)
{
    const double shell = floor(height / SHELL);
    return (int)fmin(fmax(shell, 0.0), SHELLS - 1);
}

/** Weight of the grains by shell, and how they press on it: hooke, so stiffness times overlap.
 */
static void add_grains(column *self, const clod_state *state)
{
    double weight[SHELLS] = {0.0};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *place = state->grains.place[g];
        const int shell = shell_of(place[2]);
        const double overlap = hypot(place[0], place[1]) + place[3] - 0.5 * DIAMETER;
        weight[shell] -= state->grains.motion[g][3] * state->gravity[2];
        self->normal[shell] += STIFFNESS * fmax(overlap, 0.0);
    }
    double above = 0.0;
    for (int s = SHELLS - 1; s >= 0; s--) {
        above += weight[s];
        self->above[s] += above;
    }
    self->weight += above;
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    column *self = context;
    const clod_wall *wall = now->state.walls.wall;
    if (!clod_verify_bed_is_in(now, "measure") || wall[0].sum_steps == 0) {
        return true;
    }
    const double steps = (double)wall[0].sum_steps;
    self->looks++;
    self->floor -= wall[0].sum_force.z / steps;
    for (int s = 0; s < SHELLS; s++) {
        self->friction[s] -= wall[1 + s].sum_force.z / steps;
    }
    add_grains(self, &now->state);
    return clod_verify_bed_overlap(now, &self->overlap, status);
}

/** Sums to means. */
static void finish(column *self)
{
    self->floor /= self->looks;
    self->weight /= self->looks;
    for (int s = 0; s < SHELLS; s++) {
        self->above[s] /= self->looks;
        self->friction[s] /= self->looks;
        self->normal[s] /= self->looks;
    }
}

static bool run(const clod_verify_bench *bench, column *self, clod_status *status)
{
    char name[64];
    char text[TEXT];
    snprintf(name, sizeof name, "janssen-%g-%d", self->wall_friction, self->seed);
    write_case(self, text);
    const bool ok = clod_verify_bed_run(bench, name, text, look, self, status);
    finish(self);
    return ok;
}

/** The joints with at least a shell of grains above; the lowest one is the floor. */
static void add_profile(profile *self, const column *of)
{
    double carried = 0.0;
    for (int s = SHELLS - 1; s >= 0; s--) {
        carried += of->friction[s];
        if (SHELLS * of->above[s] >= of->weight) {
            self->filled[self->count] = of->above[s];
            self->apparent[self->count++] = of->above[s] - carried;
        }
    }
}

/** rho_b g A, weight of a metre of column [N/m]. */
static double line_weight(const column *self)
{
    return (self->above[LOW] - self->above[HIGH]) / ((HIGH - LOW) * SHELL);
}

/** Weight on the middle of a shell [N]. */
static double stands_on(const column *self, int shell)
{
    double carried = 0.5 * self->friction[shell];
    for (int s = shell + 1; s < SHELLS; s++) {
        carried += self->friction[s];
    }
    return 0.5 * (self->above[shell] + self->above[shell + 1]) - carried;
}

/** Stress on the wall over the vertical one, of shells LOW to HIGH. */
static double stress_ratio(const column *self)
{
    double wall = 0.0;
    double vertical = 0.0;
    for (int s = LOW; s < HIGH; s++) {
        wall += self->normal[s] / (M_PI * DIAMETER * SHELL);
        vertical += stands_on(self, s) / (0.25 * M_PI * DIAMETER * DIAMETER);
    }
    return wall / vertical;
}

/** Friction on the wall over what its normal force bears. */
static double mobilised(const column *self)
{
    double friction = 0.0;
    double normal = 0.0;
    for (int s = 0; s < SHELLS; s++) {
        friction += self->friction[s];
        normal += self->normal[s];
    }
    return friction / (self->wall_friction * normal);
}

/** Floor and wall together over the weight. */
static double balance(const column *self)
{
    double carried = self->floor;
    for (int s = 0; s < SHELLS; s++) {
        carried += self->friction[s];
    }
    return carried / self->weight;
}

static bool check_column(const clod_verify_bench *bench, const column *of, clod_status *status)
{
    const clod_verify_expect whole = {1.0, 1e-3, true, "balance of forces"};
    const clod_verify_expect shallow = {0.0, CLOD_LIMITS_OVERLAP_MOST, false,
                                        "src/tester/limits.h"};
    return clod_verify_bench_check(bench, &whole, balance(of), status,
                                   "wall friction %g, seed %d: what floor and wall carry over "
                                   "the weight [1]",
                                   of->wall_friction, of->seed) &&
           clod_verify_bench_check(bench, &shallow, of->overlap, status,
                                   "wall friction %g, seed %d: largest overlap over the "
                                   "radius [1]",
                                   of->wall_friction, of->seed);
}

/** A column with friction: mobilised to the limit; lambda from its own K. */
static bool check_silo(const clod_verify_bench *bench, const column *of, double saturated,
                       clod_status *status)
{
    const double ratio = stress_ratio(of);
    const double length = DIAMETER / (4.0 * of->wall_friction * ratio);
    const clod_verify_expect limit = {1.0, 0.05, true, "Coulomb; Vanel & Clement (1999)"};
    const clod_verify_expect between = {0.5 * (1.0 + RANKINE), 0.5 * (1.0 - RANKINE), false,
                                        "Rankine's active state at 30 deg to hydrostatic"};
    const clod_verify_expect same = {length, 0.1, true, SOURCE};
    return clod_verify_bench_check(bench, &limit, mobilised(of), status,
                                   "seed %d: friction on the wall over its limit [1]",
                                   of->seed) &&
           clod_verify_bench_check(bench, &between, ratio, status,
                                   "seed %d: stress on the wall over the vertical one, K [1]",
                                   of->seed) &&
           clod_verify_bench_check(bench, &same, saturated / line_weight(of), status,
                                   "seed %d: lambda of the fit beside D/(4 mu K) [m]",
                                   of->seed);
}

/** Curve, and the joint that is furthest from the law, over the saturated weight. */
static bool check_law(const clod_verify_bench *bench, const profile *joints,
                      clod_verify_curve *curve, clod_status *status)
{
    const double saturated =
        clod_verify_saturation_fit(joints->filled, joints->apparent, joints->count);
    const clod_verify_expect none = {0.0, 0.05, false, SOURCE};
    double worst = 0.0;
    double deepest = 0.0;
    for (size_t j = 0; j < joints->count; j++) {
        const double law = clod_verify_saturation_at(joints->filled[j], saturated);
        const double row[] = {joints->filled[j], joints->apparent[j], NAN, NAN};
        worst = fmax(worst, fabs(joints->apparent[j] - law) / saturated);
        deepest = fmax(deepest, joints->filled[j]);
        clod_verify_curve_add(curve, row, 4);
    }
    for (int i = 0; i <= 60; i++) {
        const double filled = deepest * i / 60.0;
        const double row[] = {filled, NAN, clod_verify_saturation_at(filled, saturated),
                              filled <= 2.0 * saturated ? filled : (double)NAN};
        clod_verify_curve_add(curve, row, 4);
    }
    return clod_verify_bench_check(bench, &none, worst, status,
                                   "joint furthest from the law with its own saturation, "
                                   "over that [1]");
}

/** Without friction: the wall feels a stress that goes with the depth. */
static bool check_hydrostatic(const clod_verify_bench *bench, const column *of,
                              clod_status *status)
{
    double depth[SHELLS];
    double wall[SHELLS];
    for (int s = LOW; s < HIGH; s++) {
        depth[s - LOW] = stands_on(of, s);
        wall[s - LOW] = of->normal[s];
    }
    const clod_fit line = clod_fit_line(depth, wall, HIGH - LOW);
    const double ratio = DIAMETER / (4.0 * SHELL) * line.slope;
    const clod_verify_expect weight = {1.0, 1e-3, true, "hydrostatics"};
    const clod_verify_expect same = {stress_ratio(of), 0.1, true,
                                     "hydrostatics: K is constant"};
    return clod_verify_bench_check(bench, &weight, of->floor / of->weight, status,
                                   "no wall friction: floor over weight [1]") &&
           clod_verify_bench_check(bench, &same, ratio, status,
                                   "no wall friction: slope of the stress on the wall over "
                                   "the vertical one, beside its mean K [1]");
}

static bool run_silos(const clod_verify_bench *bench, profile *joints, clod_status *status)
{
    for (int seed = 1; seed <= COLUMNS; seed++) {
        column silo = {.wall_friction = WALL_FRICTION, .seed = seed};
        const size_t first = joints->count;
        if (!run(bench, &silo, status)) {
            return false;
        }
        add_profile(joints, &silo);
        const double saturated = clod_verify_saturation_fit(
            joints->filled + first, joints->apparent + first, joints->count - first);
        if (!check_column(bench, &silo, status) ||
            !check_silo(bench, &silo, saturated, status)) {
            return false;
        }
    }
    return true;
}

bool clod_verify_janssen(const clod_verify_bench *bench, clod_status *status)
{
    profile joints = {0};
    column smooth = {.wall_friction = 0.0, .seed = 1};
    if (!run_silos(bench, &joints, status) || !run(bench, &smooth, status) ||
        !check_column(bench, &smooth, status) || !check_hydrostatic(bench, &smooth, status)) {
        return false;
    }
    clod_verify_curve *curve = clod_verify_curve_open(
        bench, bench->test,
        "weight above [N],clod: weight carried below [N],Janssen [N],hydrostatic [N]", status);
    const bool ok = curve != NULL && check_law(bench, &joints, curve, status);
    return clod_verify_curve_close(&curve, status) && ok;
}
