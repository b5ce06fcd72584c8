// A measurement that clod does not have: the height of the centre of mass, and the number of
// partners of each grain, from the arrays and the contacts. A falling bed without contacts
// follows z - g t^2/2.
#include <math.h>
#include <stdio.h>

#include <clod/sim.h>

#define GRAVITY 9.81 ///< m/s2, that of a case that says nothing else

static const char CASE[] =
    "stages: [{name: all, duration: 1 s}]\n" // a case needs one; this program decides instead
    "materials:\n"
    "  glass: {density: 2500 kg/m3, youngs_modulus: 10 MPa, poissons_ratio: 0.3}\n"
    "contacts:\n"
    "  default: {law: hertz, restitution: 0.3, friction: 0.3}\n"
    "time: {step: 5 us}\n"
    "domain: {min: [0 mm, 0 mm, -1 mm], max: [20 mm, 20 mm, 200 mm], periodic: [true, true, "
    "false]}\n"
    "grains:\n"
    "  - material: glass\n"
    "    count: 100\n"
    "    radius: {distribution: uniform, min: 1.8 mm, max: 2.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 100 mm], max: [20 mm, 20 mm, 160 mm]}}\n"
    "walls:\n"
    "  floor: {material: glass, shapes: [\n"
    "    {plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n";

static bool centre_height(clod_sim *sim, double *height, clod_status *status)
{
    clod_sim_view place, mass;
    if (!clod_sim_array(sim, "position", &place, status) ||
        !clod_sim_array(sim, "mass", &mass, status)) {
        return false;
    }
    double sum = 0.0, all = 0.0;
    for (size_t g = 0; g < place.rows; g++) {
        sum += clod_sim_row(&mass, g)[0] * clod_sim_row(&place, g)[2];
        all += clod_sim_row(&mass, g)[0];
    }
    *height = sum / all;
    return true;
}

/** Mean number of partners, counted by hand. */
static bool partners(clod_sim *sim, double *mean, clod_status *status)
{
    const clod_sim_contact *contacts;
    size_t count, ends = 0;
    if (!clod_sim_contacts(sim, &contacts, &count, status)) {
        return false;
    }
    for (size_t c = 0; c < count; c++) {
        ends += contacts[c].wall < 0 ? 2 : 0;
    }
    *mean = (double)ends / (double)clod_sim_grain_count(sim);
    return true;
}

static bool measure(clod_sim *sim, double results[3], clod_status *status)
{
    double before, after, mean;
    clod_sim_bed bed;
    if (!centre_height(sim, &before, status) || !clod_sim_advance(sim, 10000, status) ||
        !centre_height(sim, &after, status)) {
        return false;
    }
    const double t = clod_sim_time(sim);
    results[0] = (before - after) / (0.5 * GRAVITY * t * t);
    if (!clod_sim_advance(sim, 100000, status) || !partners(sim, &mean, status) ||
        !clod_sim_measure(sim, &bed, status)) {
        return false;
    }
    results[1] = mean;
    results[2] = bed.coordination;
    return true;
}

int main(void)
{
    static clod_status status;
    double results[3] = {0.0, 0.0, 0.0};
    clod_sim *sim = clod_sim_create_from_text("own_measurement.yaml", CASE, NULL, &status);
    const bool ok = sim != NULL && measure(sim, results, &status);
    clod_sim_destroy(&sim);
    if (!ok) {
        fprintf(stderr, "%s\n", status.text);
        return 1;
    }
    printf("fall over g t^2/2: %.6f; partners of a grain %.3f, by clod %.3f\n", results[0],
           results[1], results[2]);
    return fabs(results[0] - 1.0) > 0.005 || fabs(results[1] - results[2]) > 1e-12 ||
           results[1] < 2.0;
}
