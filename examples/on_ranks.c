// One simulation on all processes of mpirun: two clouds of grains fly into each other. Number 0 is the
// whole program, the others compute for it; alone, without mpirun, it gives the same numbers.
//
//   mpirun -n 4 ./on_ranks
#include <math.h>
#include <stdio.h>

#include <clod/sim.h>

static const char CASE[] =
    "materials: {glass: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}}\n"
    "contacts: {default: {law: hertz, restitution: 0.5, friction: 0.3}}\n"
    "gravity: [0 m/s2, 0 m/s2, 0 m/s2]\n"
    "time: {design_stress: 1 kPa}\n"
    "domain: {min: [0 mm, 0 mm, 0 mm], max: [80 mm, 30 mm, 30 mm], periodic: [true, true, "
    "true]}\n"
    "grains:\n"
    "  - {material: glass, count: 500, radius: {distribution: uniform, min: 1 mm, max: 1.5 "
    "mm},\n"
    "     region: {box: {min: [0 mm, 0 mm, 0 mm], max: [80 mm, 30 mm, 30 mm]}}}\n"
    "stages: [{name: all, duration: 1 s}]\n"; // a case needs one; this program decides instead

/** Mass times velocity along x of all grains [kg m/s]. */
static bool find_momentum(clod_sim *sim, double *momentum, clod_status *status)
{
    clod_sim_view mass, velocity;
    if (!clod_sim_array(sim, "mass", &mass, status) ||
        !clod_sim_array(sim, "velocity", &velocity, status)) {
        return false;
    }
    *momentum = 0.0;
    for (size_t g = 0; g < mass.rows; g++) {
        *momentum += clod_sim_row(&mass, g)[0] * clod_sim_row(&velocity, g)[0];
    }
    return true;
}

/** The left half flies to the right, the other one faster to the left. */
static bool throw_clouds(clod_sim *sim, clod_status *status)
{
    clod_sim_view position, velocity;
    if (!clod_sim_array(sim, "position", &position, status) ||
        !clod_sim_array(sim, "velocity", &velocity, status)) {
        return false;
    }
    for (size_t g = 0; g < position.rows; g++) {
        clod_sim_row(&velocity, g)[0] = clod_sim_row(&position, g)[0] < 0.04 ? 1.0 : -1.5;
    }
    return true;
}

/** The whole program, in one process. */
static int collide(clod_ranks *ranks)
{
    static clod_status status;
    const clod_sim_options options = {.ranks = ranks};
    double before = 0.0, after = 0.0;
    clod_sim_energy first, last;
    clod_sim *sim = clod_sim_create_from_text("clouds.yaml", CASE, &options, &status);
    const bool ok =
        sim != NULL && throw_clouds(sim, &status) && find_momentum(sim, &before, &status) &&
        clod_sim_energies(sim, &first, &status) &&
        clod_sim_advance(sim, (int64_t)(0.02 / clod_sim_dt(sim)), &status) &&
        find_momentum(sim, &after, &status) && clod_sim_energies(sim, &last, &status);
    clod_sim_destroy(&sim);
    if (!ok) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    printf("momentum %.12g kg m/s, before it was %.12g; of the energy %.12g is left\n", after,
           before, last.translation / first.translation);
    return !(fabs(after / before - 1.0) < 1e-9 && last.translation < 0.8 * first.translation);
}

int main(void)
{
    static clod_status status;
    clod_ranks *ranks = clod_ranks_open(&status); // in every process
    if (ranks == NULL) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    const int result = clod_ranks_number(ranks) == 0 ? collide(ranks) : 0;
    clod_ranks_close(&ranks); // here the others compute, until number 0 comes here too
    return result;
}
