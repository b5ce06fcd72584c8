// A heap of grains on a troughed belt at rest, and a stream on a moving one, beside the
// cross-section and the capacity of ISO 5048.
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/burden.h"
#include "base/memory.h"
#include "verify/bed.h"
#include "verify/profile.h"
#include "verify/suite.h"

#define DIAMETER 5e-3  ///< m, mean of the grains
#define DENSITY 2500.0 ///< kg/m3, of the grains
#define LENGTH 0.08    ///< m, of the piece of belt, between smooth planes
#define WIDTH 0.25     ///< m, of the belt laid flat
#define MIDDLE 0.095   ///< m, middle roll
#define ANGLE (35.0 * M_PI / 180.0)
#define GRAINS 2400
#define CORE 0.025 ///< m, half width of the piece of the heap whose density is taken
#define CORE_LOW (2.0 * DIAMETER)
#define ISO "ISO 5048: S1 + S2 for its width and surcharge angle"

/** The heap as found. */
typedef struct heap {
    clod_verify_profile profile; ///< across the belt
    double from;                 ///< m, where the piece of belt begins
    double mass, density;        ///< kg; kg/m3 of the core
    double momentum;             ///< kg m/s along the belt
} heap;

static const char CASE[] =
    "# Written by clod verify.\n"
    "title: A heap on a troughed belt\n"
    "materials:\n"
    "  bead: {density: %g kg/m3, youngs_modulus: 3 MPa, poissons_ratio: 0.25}\n"
    "  end: {youngs_modulus: 3 MPa, poissons_ratio: 0.25}\n"
    "contacts:\n"
    "  default: {law: hertz, restitution: 0.4, friction: 0.6, rolling: epsd2, rolling_friction: "
    "0.1}\n"
    "  bead-end: {friction: 0, rolling: none}\n"
    "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
    "domain: {min: [-0.1 m, -0.2 m, -0.02 m], max: [0.2 m, 0.2 m, 0.5 m]}\n"
    "grains:\n"
    "  - material: bead\n"
    "    count: %d\n"
    "    radius: {distribution: uniform, min: %g m, max: %g m}\n"
    "    region: {box: {min: [0 m, -50 mm, 5 mm], max: [%g m, 50 mm, 200 mm]}}\n"
    "walls:\n"
    "  belt:\n"
    "    material: bead\n"
    "    shapes: [{belt: {from: [-0.05 m, 0 m, 0 m], runs: [{length: 0.2 m}], width: %g m, "
    "idler_angle: 35 deg, middle_roll: %g m, speed: 0 m/s}}]\n"
    "  ends:\n"
    "    material: end\n"
    "    shapes:\n"
    "      - plane: {point: [0 m, 0 m, 0 m], normal: [1, 0, 0]}\n"
    "      - plane: {point: [%g m, 0 m, 0 m], normal: [-1, 0, 0]}\n"
    "stages: [{name: fill, duration: 1.5 s, rest: 20 mm/s}]\n"
    "output: {series_interval: 20 ms}\n";

/** Height of the belt [m]. */
static double belt_at(double y)
{
    return fmax(fabs(y) - 0.5 * MIDDLE, 0.0) * tan(ANGLE);
}

/** Whether a grain is in the piece of belt that is looked at. */
static bool is_in(const heap *self, const double *position)
{
    return position[0] >= self->from && position[0] <= self->from + LENGTH;
}

/** The profile across the belt: y takes the place of x. */
static bool find_profile(heap *self, const clod_grains *grains, clod_status *status)
{
    size_t count = 0;
    double(*turned)[4] = clod_memory_alloc(grains->count, sizeof *turned);
    if (turned == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "no memory for %zu grains", grains->count);
    }
    for (size_t g = 0; g < grains->count; g++) {
        const double *p = grains->position[g];
        if (is_in(self, p)) {
            const double place[4] = {p[1], p[0] - self->from, p[2], p[3]};
            memcpy(turned[count++], place, sizeof place);
        }
    }
    clod_verify_profile_find(&self->profile, (const double(*)[4])turned, count);
    clod_memory_free(turned);
    return true;
}

/** What of a grain lies between two heights [m3]. */
static double volume_between(const double *grain, double low, double top)
{
    const double r = grain[3], a = fmax(low - grain[2], -r), b = fmin(top - grain[2], r);
    return b > a ? M_PI * (r * r * (b - a) - (b * b * b - a * a * a) / 3.0) : 0.0;
}

/** Mass of all, and density of the core below `top`: a slab of one or two grains has its density
 *  only where what is cut counts in part. */
static void weigh(heap *self, const clod_grains *grains, double top)
{
    double core = 0.0;
    self->mass = self->momentum = 0.0;
    for (size_t g = 0; g < grains->count; g++) {
        const double *p = grains->position[g], mass = grains->velocity[g][3];
        if (!is_in(self, p)) {
            continue;
        }
        core += fabs(p[1]) < CORE ? DENSITY * volume_between(p, CORE_LOW, top) : 0.0;
        self->mass += mass;
        self->momentum += mass * grains->velocity[g][0];
    }
    self->density = core / (LENGTH * 2.0 * CORE * (top - CORE_LOW));
}

/** Find the heap as it is now. */
static bool find_heap(heap *self, const clod_grains *grains, clod_status *status)
{
    const int columns = (int)ceil(2.0 * (0.5 * MIDDLE + 0.5 * (WIDTH - MIDDLE)) / DIAMETER);
    self->profile = (clod_verify_profile){.begin = -0.5 * columns * DIAMETER,
                                          .width = DIAMETER,
                                          .depth = LENGTH,
                                          .count = (size_t)columns};
    if (!find_profile(self, grains, status)) {
        return false;
    }
    const double middle = self->profile.height[columns / 2];
    weigh(self, grains, middle - 2.0 * DIAMETER);
    return true;
}

static bool look(void *context, clod_verify_bed *now, clod_status *status)
{
    return find_heap(context, &now->state.grains, status);
}

/** The parabola a - c y^2 through the surface, and where it meets the belt. */
typedef struct parabola {
    double a, c;
    double edge;      ///< m, half width of the burden
    double surcharge; ///< rad, slope at the edge
    double area;      ///< m2, between surface and belt
} parabola;

static double find_edge(const parabola *self)
{
    double low = 0.0, high = 0.5 * WIDTH;
    for (int k = 0; k < 60; k++) {
        const double y = 0.5 * (low + high);
        const bool above = self->a - self->c * y * y > belt_at(y);
        low = above ? y : low;
        high = above ? high : y;
    }
    return low;
}

/** Fit it to the columns in which the surface is clear of the belt. */
static parabola fit(const clod_verify_profile *profile)
{
    parabola self = {.area = 0.0};
    double n = 0.0, x = 0.0, xx = 0.0, z = 0.0, xz = 0.0;
    for (size_t k = 0; k < profile->count; k++) {
        const double y = profile->x[k], height = profile->height[k] - belt_at(y);
        if (height < 1.5 * DIAMETER) {
            continue; // a layer of single grains is no heap
        }
        n += 1.0;
        x += y * y;
        xx += y * y * y * y;
        z += profile->height[k];
        xz += y * y * profile->height[k];
        self.area += profile->width * height;
    }
    self.c = -(n * xz - x * z) / (n * xx - x * x);
    self.a = (z + self.c * x) / n;
    self.edge = find_edge(&self);
    self.surcharge = atan(2.0 * self.c * self.edge);
    return self;
}

static bool check(const clod_verify_bench *bench, const heap *found, clod_status *status)
{
    const parabola surface = fit(&found->profile);
    const clod_burden_belt belt = {WIDTH, MIDDLE, ANGLE};
    const double width = MIDDLE + 2.0 * (surface.edge - 0.5 * MIDDLE) / cos(ANGLE);
    const clod_burden_section section = clod_burden_of(&belt, width, surface.surcharge);
    const double area = section.heap + section.trough;
    const clod_verify_expect same = {area, 0.05, true, ISO};
    return clod_verify_bench_check(bench, &same, surface.area, status,
                                   "heap %.0f mm wide at %.1f deg: area below its surface [m2]",
                                   1e3 * width, surface.surcharge * 180.0 / M_PI) &&
           clod_verify_bench_check(bench, &same, found->mass / (found->density * LENGTH),
                                   status,
                                   "heap: area by its mass and the core's density [m2]");
}

// ---- a stream on a moving belt

#define SPEED 0.3   ///< m/s
#define FLOW 1.1    ///< kg/s
#define STEADY 1.4  ///< s, from when on it is looked at
#define WINDOW 0.22 ///< m, where the piece of belt that is looked at begins
#define CAPACITY "ISO 5048: (S1 + S2) v rho for its width and surcharge angle"

static const char STREAM[] =
    "# Written by clod verify.\n"
    "title: A stream on a troughed belt\n"
    "materials:\n"
    "  bead: {density: %g kg/m3, youngs_modulus: 3 MPa, poissons_ratio: 0.25}\n"
    "contacts:\n"
    "  default: {law: hertz, restitution: 0.4, friction: 0.6, rolling: epsd2, rolling_friction: "
    "0.1}\n"
    "gravity: [0 m/s2, 0 m/s2, -9.81 m/s2]\n"
    "domain: {min: [-0.2 m, -0.2 m, -0.05 m], max: [0.45 m, 0.2 m, 0.3 m], open: delete}\n"
    "time: {design_stress: 2 kPa}\n"
    "grains:\n"
    "  - material: bead\n"
    "    radius: {distribution: uniform, min: %g m, max: %g m}\n"
    "    inlet: {mass_flow: %g kg/s}\n"
    "    region: {box: {min: [-40 mm, -40 mm, 70 mm], max: [40 mm, 40 mm, 90 mm]}}\n"
    "    velocity: [%g m/s, 0 m/s, -0.6 m/s]\n"
    "walls:\n"
    "  belt:\n"
    "    material: bead\n"
    "    shapes: [{belt: {from: [-0.15 m, 0 m, 0 m], runs: [{length: 0.55 m}], width: %g m, "
    "idler_angle: 35 deg, middle_roll: %g m, speed: %g m/s}}]\n"
    "stages: [{name: run, duration: 2.6 s}]\n"
    "output: {series_interval: 20 ms}\n";

/** Means over the steady time. */
typedef struct conveyed {
    heap sum;
    double looks;
} conveyed;

static bool look_at_stream(void *context, clod_verify_bed *now, clod_status *status)
{
    conveyed *self = context;
    heap found = {.from = WINDOW};
    if (now->state.time < STEADY) {
        return true;
    }
    if (!find_heap(&found, &now->state.grains, status)) {
        return false;
    }
    for (size_t k = 0; k < found.profile.count; k++) {
        found.profile.height[k] += self->sum.profile.height[k];
    }
    self->sum.profile = found.profile;
    self->sum.mass += found.mass;
    self->sum.density += found.density;
    self->sum.momentum += found.momentum;
    self->looks += 1.0;
    return true;
}

static bool check_stream(const clod_verify_bench *bench, conveyed *found, clod_status *status)
{
    clod_verify_profile *profile = &found->sum.profile;
    for (size_t k = 0; k < profile->count; k++) {
        profile->height[k] /= found->looks;
    }
    const parabola surface = fit(profile);
    const clod_burden_belt belt = {WIDTH, MIDDLE, ANGLE};
    const double width = MIDDLE + 2.0 * (surface.edge - 0.5 * MIDDLE) / cos(ANGLE);
    const clod_burden_section section = clod_burden_of(&belt, width, surface.surcharge);
    const double speed = found->sum.momentum / found->sum.mass;
    const double density = found->sum.density / found->looks;
    const clod_verify_expect flow = {FLOW, 0.01, true, "mass flow of the inlet"};
    const clod_verify_expect same = {FLOW, 0.05, true, CAPACITY};
    return clod_verify_bench_check(bench, &flow, found->sum.momentum / (found->looks * LENGTH),
                                   status,
                                   "stream: mass on a metre of belt times its speed "
                                   "[kg/s]") &&
           clod_verify_bench_check(
               bench, &same, surface.area * speed * density, status,
               "stream %.0f mm wide at %.1f deg: area below its surface times "
               "speed and density [kg/s]",
               1e3 * width, surface.surcharge * 180.0 / M_PI) &&
           clod_verify_bench_check(bench, &same,
                                   (section.heap + section.trough) * speed * density, status,
                                   "stream: capacity by ISO 5048 [kg/s]");
}

static bool verify_stream(const clod_verify_bench *bench, clod_status *status)
{
    char text[4096];
    conveyed found = {.looks = 0.0};
    snprintf(text, sizeof text, STREAM, DENSITY, 0.45 * DIAMETER, 0.55 * DIAMETER, FLOW, SPEED,
             WIDTH, MIDDLE, SPEED);
    return clod_verify_bed_run(bench, "trough-stream", text, look_at_stream, &found, status) &&
           check_stream(bench, &found, status);
}

bool clod_verify_trough(const clod_verify_bench *bench, clod_status *status)
{
    char text[4096];
    heap found = {.from = 0.0};
    snprintf(text, sizeof text, CASE, DENSITY, GRAINS, 0.45 * DIAMETER, 0.55 * DIAMETER, LENGTH,
             WIDTH, MIDDLE, LENGTH);
    return clod_verify_bed_run(bench, "trough", text, look, &found, status) &&
           check(bench, &found, status) && verify_stream(bench, status);
}
