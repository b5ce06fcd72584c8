// Grains fall onto a floor between walls and come to rest: the floor carries their weight.
#include <math.h>
#include <stdio.h>

#include <clod/sim.h>

static const char CASE[] =
    "stages: [{name: all, duration: 1 s}]\n" // a case needs one; this program decides instead
    "materials:\n"
    "  glass: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"
    "contacts:\n"
    "  default: {law: hertz, restitution: 0.3, friction: 0}\n"
    "domain: {min: [0 mm, 0 mm, -1 mm], max: [20 mm, 20 mm, 200 mm], periodic: [true, true, "
    "false]}\n"
    "grains:\n"
    "  - material: glass\n"
    "    count: 100\n"
    "    radius: {distribution: uniform, min: 1.8 mm, max: 2.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [20 mm, 20 mm, 60 mm]}}\n"
    "walls:\n"
    "  floor: {material: glass, shapes: [\n"
    "    {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n";

static bool settle(clod_sim *sim, double *weight, double *carried, clod_status *status)
{
    clod_sim_view mass;
    clod_sim_wall floor;
    const int32_t wall = clod_sim_wall_index(sim, "floor");
    if (!clod_sim_advance(sim, (int64_t)(0.5 / clod_sim_dt(sim)), status)) {
        return false;
    }
    clod_sim_reset_wall_means(sim); // now the mean over another tenth of a second
    if (!clod_sim_advance(sim, (int64_t)(0.1 / clod_sim_dt(sim)), status) ||
        !clod_sim_array(sim, "mass", &mass, status) ||
        !clod_sim_wall_look(sim, wall, &floor, status)) {
        return false;
    }
    *weight = 0.0;
    for (size_t g = 0; g < mass.rows; g++) {
        *weight += 9.81 * clod_sim_row(&mass, g)[0];
    }
    *carried = -floor.mean_force[2];
    return true;
}

int main(void)
{
    static clod_status status;
    double weight = 0.0, carried = 0.0;
    clod_sim *sim = clod_sim_create_from_text("pile.yaml", CASE, NULL, &status);
    const bool ok = sim != NULL && settle(sim, &weight, &carried, &status);
    clod_sim_destroy(&sim);
    if (!ok) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    printf("the floor carries %.5f N, the grains weigh %.5f N\n", carried, weight);
    return fabs(carried / weight - 1.0) > 0.01;
}
