// A lid that this program drives: its own servo sets the lid's velocity from the force that the
// lid felt, until the bed carries the load asked for.
#include <math.h>
#include <stdio.h>

#include <clod/sim.h>

#define TARGET 2.0  ///< N
#define GAIN 0.05   ///< m/s per N
#define FASTEST 0.1 ///< m/s
#define EACH 20     ///< steps between two turns of the servo

static const char CASE[] =
    "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
    "stages: [{name: all, duration: 1 s}]\n" // a case needs one; this program decides instead
    "materials:\n"
    "  glass: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"
    "contacts:\n"
    "  default: {law: hertz, restitution: 0.1, friction: 0.2}\n"
    "time: {design_stress: 10 kPa}\n"
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 45 mm], periodic: [true, true, "
    "false]}\n"
    "grains:\n"
    "  - material: glass\n"
    "    count: 150\n"
    "    radius: {distribution: uniform, min: 1.8 mm, max: 2.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 20 mm, 40 mm]}}\n"
    "walls:\n"
    "  floor: {material: glass, shapes: [\n"
    "    {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n"
    "  lid: {material: glass, shapes: [\n"
    "    {plane: {point: [0 mm, 0 mm, 40 mm], normal: [0, 0, -1]}}]}\n";

/** Down while the bed pushes less than the target, up while it pushes more. */
static bool servo(clod_sim *sim, int32_t lid, clod_status *status)
{
    clod_sim_wall now;
    if (!clod_sim_wall_look(sim, lid, &now, status)) {
        return false;
    }
    const double error = TARGET - now.force[2];
    const double speed = fmin(fmax(GAIN * error, -FASTEST), FASTEST);
    return clod_sim_set_wall_velocity(sim, lid, (double[3]){0.0, 0.0, -speed}, status);
}

static bool press(clod_sim *sim, double forces[2], clod_status *status)
{
    const int32_t lid = clod_sim_wall_index(sim, "lid");
    const int32_t floor = clod_sim_wall_index(sim, "floor");
    clod_sim_wall top, bottom;
    while (clod_sim_time(sim) < 1.0) {
        if (!servo(sim, lid, status) || !clod_sim_advance(sim, EACH, status)) {
            return false;
        }
        if (clod_sim_time(sim) < 0.9) {
            clod_sim_reset_wall_means(sim);
        }
    }
    if (!clod_sim_wall_look(sim, lid, &top, status) ||
        !clod_sim_wall_look(sim, floor, &bottom, status)) {
        return false;
    }
    forces[0] = top.mean_force[2];
    forces[1] = -bottom.mean_force[2];
    return true;
}

int main(void)
{
    static clod_status status;
    double forces[2] = {0.0, 0.0};
    clod_sim *sim = clod_sim_create_from_text("driven_wall.yaml", CASE, NULL, &status);
    const bool ok = sim != NULL && press(sim, forces, &status);
    clod_sim_destroy(&sim);
    if (!ok) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    printf("lid %.4f N, floor %.4f N, target %.4f N\n", forces[0], forces[1], TARGET);
    return fabs(forces[0] / TARGET - 1.0) > 0.02 || fabs(forces[1] / TARGET - 1.0) > 0.02;
}
