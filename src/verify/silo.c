#include "verify/silo.h"

#include <math.h>
#include <stdio.h>

#include "verify/bed.h"

#define SHELLS CLOD_VERIFY_SILO_SHELLS
#define SHELL CLOD_VERIFY_SILO_SHELL
#define DIAMETER CLOD_VERIFY_SILO_DIAMETER
#define GRAINS 5800
#define RADIUS 3e-3   ///< m, mean of the grains
#define STIFFNESS 1e4 ///< N/m: overlaps of 1 % of a radius under the whole column
#define TOP 1.2       ///< m, above the loose column that falls
#define TEXT 8192

static const char CASE[] =
    "# Written by clod verify: Janssen's silo, a shell for each half of a diameter.\n"
    "title: Silo, wall friction %g\n"
    "seed: %d\n"
    "time: {safety: 0.15}\n"
    "materials: {bead: {density: 2500 kg/m3}, floor: {}, shell: {}}\n"
    "contacts:\n"
    "  default: {law: hooke, k1: %g N/m, restitution: 0.5, friction: 0.5,\n"
    "            tangential_ratio: 0.2857142857142857, rolling: none}\n"
    "  bead-shell: {friction: %g%s}\n"
    "grains:\n"
    "  - material: bead\n"
    "    count: %d\n"
    "    radius: {distribution: uniform, min: %g mm, max: %g mm}\n"
    "    region: {annulus: {outer_radius: %g mm, height: 1.1 m}}\n"
    "stages:\n"
    "  - {name: fill, duration: 1.5 s, rest: 20 mm/s}\n"
    "  - name: mobilise\n"
    "    duration: 0.3 s\n"
    "    walls: {floor: {velocity: [0 mm/s, 0 mm/s, -10 mm/s]}}\n"
    "  - {name: measure, duration: 0.3 s}\n"
    "output: {series_interval: 5 ms}\n"
    "walls:\n"
    "  floor:\n"
    "    material: floor\n"
    "    shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]\n";

/** The case as a text: shells from the floor up, the last one high enough to fill into. */
static void write_case(const clod_verify_silo *self, char text[TEXT])
{
    char rolling[64] = "";
    if (self->rolling > 0.0) {
        snprintf(rolling, sizeof rolling, ", rolling: epsd2, rolling_friction: %g",
                 self->rolling);
    }
    int used = snprintf(text, TEXT, CASE, self->friction, self->seed, STIFFNESS, self->friction,
                        rolling, GRAINS, 0.9e3 * RADIUS, 1.1e3 * RADIUS, 0.5e3 * DIAMETER);
    for (int s = 0; s < SHELLS; s++) {
        const double foot = s > 0 ? s * SHELL : -0.5 * SHELL; // the floor sinks into the first
        const double top = s < SHELLS - 1 ? (s + 1) * SHELL : TOP;
        used += snprintf(text + used, TEXT - (size_t)used,
                         "  shell_%d:\n"
                         "    material: shell\n"
                         "    shapes: [{cylinder: {foot: [0 mm, 0 mm, %g mm], radius: %g mm, "
                         "length: %g mm}}]\n",
                         s + 1, 1e3 * foot, 0.5e3 * DIAMETER, 1e3 * (top - foot));
    }
}

static int shell_of(double height)
{
    return (int)fmin(fmax(floor(height / SHELL), 0.0), SHELLS - 1);
}

/** Weight of the grains by shell, and how they press on it: hooke's stiffness times overlap. */
static void add_grains(clod_verify_silo *self, const clod_state *state)
{
    double weight[SHELLS] = {0.0};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *place = state->grains.position[g];
        const int shell = shell_of(place[2]);
        const double overlap = hypot(place[0], place[1]) + place[3] - 0.5 * DIAMETER;
        weight[shell] -= state->grains.velocity[g][3] * state->gravity[2];
        self->normal[shell] += STIFFNESS * fmax(overlap, 0.0);
    }
    double above = 0.0;
    for (int s = SHELLS - 1; s >= 0; s--) {
        above += weight[s];
        self->above[s] += above;
    }
    self->weight += above;
}

static double momentum_of(const clod_state *state)
{
    double sum = 0.0;
    for (size_t g = 0; g < state->grains.count; g++) {
        sum += state->grains.velocity[g][2] * state->grains.velocity[g][3];
    }
    return sum;
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    clod_verify_silo *self = context;
    const clod_wall *wall = now->state.walls.wall; // the floor, then the shells
    if (!clod_verify_bed_is_in(now, "measure")) {
        self->time = now->state.time;
        self->momentum = momentum_of(&now->state);
        return true;
    }
    self->inertia =
        (momentum_of(&now->state) - self->momentum) / (now->state.time - self->time);
    const double steps = (double)wall[0].sum_steps;
    self->looks++;
    self->floor -= wall[0].sum_force.z / steps;
    for (int s = 0; s < SHELLS; s++) {
        self->shear[s] -= wall[1 + s].sum_force.z / steps;
    }
    add_grains(self, &now->state);
    double overlap = 0.0;
    const bool ok = clod_verify_bed_overlap(now, &overlap, status);
    self->overlap = clod_verify_larger(self->overlap, overlap);
    return ok;
}

bool clod_verify_silo_run(clod_verify_silo *self, const clod_verify_bench *bench,
                          clod_status *status)
{
    char text[TEXT];
    write_case(self, text);
    if (!clod_verify_bed_run(bench, self->name, text, look, self, status)) {
        return false;
    }
    self->floor /= self->looks;
    self->weight /= self->looks;
    for (int s = 0; s < SHELLS; s++) {
        self->above[s] /= self->looks;
        self->shear[s] /= self->looks;
        self->normal[s] /= self->looks;
    }
    return true;
}

/** Shear of the shells from one upwards [N]. */
static double shear_from(const clod_verify_silo *self, int shell)
{
    double sum = 0.0;
    for (int s = shell; s < SHELLS; s++) {
        sum += self->shear[s];
    }
    return sum;
}

double clod_verify_silo_carried(const clod_verify_silo *self)
{
    return self->floor + shear_from(self, 0) - self->inertia;
}

double clod_verify_silo_wall_friction(const clod_verify_silo *self)
{
    double normal = 0.0;
    for (int s = 0; s < SHELLS; s++) {
        normal += self->normal[s];
    }
    return shear_from(self, 0) / normal;
}

double clod_verify_silo_line_weight(const clod_verify_silo *self)
{
    const double height = (CLOD_VERIFY_SILO_HIGH - CLOD_VERIFY_SILO_LOW) * SHELL;
    return (self->above[CLOD_VERIFY_SILO_LOW] - self->above[CLOD_VERIFY_SILO_HIGH]) / height;
}

double clod_verify_silo_stands_on(const clod_verify_silo *self, int shell)
{
    const double above = 0.5 * (self->above[shell] + self->above[shell + 1]);
    return above - shear_from(self, shell + 1) - 0.5 * self->shear[shell];
}

double clod_verify_silo_stress_ratio(const clod_verify_silo *self)
{
    double wall = 0.0;
    double vertical = 0.0;
    for (int s = CLOD_VERIFY_SILO_LOW; s < CLOD_VERIFY_SILO_HIGH; s++) {
        wall += self->normal[s] / (M_PI * DIAMETER * SHELL);
        vertical += clod_verify_silo_stands_on(self, s) / (0.25 * M_PI * DIAMETER * DIAMETER);
    }
    return wall / vertical;
}

clod_verify_silo_profile clod_verify_silo_joints(const clod_verify_silo *self)
{
    clod_verify_silo_profile found = {0};
    for (int s = SHELLS - 1; s >= 0; s--) {
        if (SHELLS * self->above[s] >= self->weight) {
            found.filled[found.count] = self->above[s];
            found.apparent[found.count++] = self->above[s] - shear_from(self, s);
        }
    }
    return found;
}
