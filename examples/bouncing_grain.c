// A grain that hits a plate and bounces: the speed it leaves with over the speed it came with
// is the restitution of the case.
#include <math.h>
#include <stdio.h>

#include <clod/sim.h>

#define RESTITUTION 0.6

static const char CASE[] =
    "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
    "time: {step: 0.1 us}\n"
    "stages: [{name: all, duration: 1 s}]\n" // a case needs one; this program decides instead
    "materials:\n"
    "  glass: {density: 2500 kg/m3}\n"
    "contacts:\n"
    "  default: {law: hooke, k1: 1e5 N/m, restitution: 0.6, friction: 0}\n"
    "domain: {min: [-1 m, -1 m, -1 m], max: [1 m, 1 m, 1 m]}\n"
    "grains:\n"
    "  - material: glass\n"
    "    count: 1\n"
    "    radius: {distribution: uniform, min: 5 mm, max: 5 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 20 mm, 20 mm]}}\n"
    "    velocity: [0 m/s, 0 m/s, -0.5 m/s]\n"
    "walls:\n"
    "  plate: {material: glass, shapes: [\n"
    "    {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n";

static bool bounce(clod_sim *sim, double *speed, clod_status *status)
{
    clod_sim_view velocity;
    do { // a view lasts until the next advance
        if (!clod_sim_advance(sim, 100, status) ||
            !clod_sim_array(sim, "velocity", &velocity, status)) {
            return false;
        }
        *speed = clod_sim_row(&velocity, 0)[2];
    } while (*speed < 0.0 && clod_sim_time(sim) < 0.1);
    // until the contact is open again
    if (!clod_sim_advance(sim, 20000, status) ||
        !clod_sim_array(sim, "velocity", &velocity, status)) {
        return false;
    }
    *speed = clod_sim_row(&velocity, 0)[2];
    return true;
}

int main(void)
{
    static clod_status status;
    double speed = 0.0;
    clod_sim *sim = clod_sim_create_from_text("bouncing_grain.yaml", CASE, NULL, &status);
    const bool ok = sim != NULL && bounce(sim, &speed, &status);
    clod_sim_destroy(&sim);
    if (!ok) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    printf("restitution %.4f, asked for %.4f\n", speed / 0.5, RESTITUTION);
    return fabs(speed / 0.5 - RESTITUTION) > 0.01 * RESTITUTION;
}
