// The wall friction test: on a smooth plate each contact slips and bears its Coulomb limit, so
// that tau_w = mu_w sigma_w; on a rough one the solid shears within itself, and bears no more
// than in a ring shear test of the same grains at the same stress.
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "clod/run.h"
#include "verify/case_file.h"
#include "verify/suite.h"

#define COULOMB "Coulomb: fully mobilised"
#define BULK "no wall bears more than the solid on it"
#define STRESSES 3
#define ROLLING 0.3 ///< rolling friction of the grains, among themselves and on a smooth plate
#define HELD 1.0    ///< on a rough plate: no shear of the solid overcomes it

static const char HEAD[] =
    "# Written by clod verify: dry, elastic grains; friction 0.5 among them.\n"
    "title: Wall friction, %s\n"
    "seed: 1\n"
    "materials: {ore: {density: 2481.3 kg/m3}, side: {}, plate: {}, base: {}}\n"
    "contacts:\n"
    "  default:\n"
    "    law: hooke\n"
    "    k1: 1e5 N/m\n"
    "    restitution: 0.3\n"
    "    friction: 0.5\n"
    "    rolling: epsd2\n"
    "    rolling_friction: 0.3\n"
    "  ore-side: {friction: 0, rolling: none}\n"
    "  ore-plate: {friction: %g, rolling_friction: %g}\n"
    "  ore-base: {friction: 0.7}\n";

static const char CELL[] = "  grain_material: ore\n"
                           "  side_material: side\n"
                           "  lid_material: base\n"
                           "  radius: {mean: 2.5 mm, sd: 0.15 mm, min: 2.2 mm, max: 2.8 mm}\n"
                           "  lid_mass: 0.1 kg\n"
                           "  speed: 50 mm/s\n"
                           "  block_displacement: 1 mm\n";

static const char STRAIGHT[] = "wall_friction:\n"
                               "  cell: straight\n"
                               "  plate_material: plate\n"
                               "  outer_radius: 30 mm\n"
                               "  depth: 20 mm\n"
                               "  wall_stresses: [20 kPa, 10 kPa, 5 kPa]\n";

#define RING                                                                                   \
    "  inner_radius: 20 mm\n"                                                                  \
    "  outer_radius: 45 mm\n"                                                                  \
    "  depth: 25 mm\n"                                                                         \
    "  bar_count: 10\n"                                                                        \
    "  bar_height: 5 mm\n"                                                                     \
    "  bar_width: 2 mm\n"

static const char TURNING[] = "wall_friction:\n"
                              "  plate_material: plate\n"
                              "  wall_stresses: [20 kPa, 10 kPa, 5 kPa]\n" RING;

static const char SHEAR[] = "ring_shear:\n"
                            "  base_material: base\n"
                            "  preshear_stress: 20 kPa\n"
                            "  shear_stresses: [10 kPa, 15 kPa]\n" RING;

/** Run a case with `plate`, its friction and rolling friction, and load its summary; owned, NULL with a status. */
static json_t *run(const clod_verify_bench *bench, const char *name, const char *section,
                   const double plate[2], clod_status *status)
{
    char text[sizeof HEAD + sizeof TURNING + sizeof CELL + 512];
    char path[4096];
    char folder[4096];
    snprintf(text, sizeof text, HEAD, name, plate[0], plate[1]);
    const size_t used = strlen(text);
    snprintf(text + used, sizeof text - used, "%s%s", section, CELL);
    if (!clod_verify_case_file(bench->directory, name, text, path, status)) {
        return NULL;
    }
    snprintf(folder, sizeof folder, "%s/cases/%s/run", bench->directory, name);
    clod_case *from = clod_case_load(path, NULL, 0, status);
    char *report = NULL;
    const clod_run_options options = {
        .directory = folder, .fresh = true, .ranks = bench->ranks};
    const bool good = from != NULL && clod_run(from, &options, &report, status);
    clod_run_free(report);
    clod_case_destroy(&from);
    snprintf(path, sizeof path, "%.4000s/summary.json", folder);
    json_error_t error = {0};
    json_t *summary = good ? json_load_file(path, 0, &error) : NULL;
    if (good && summary == NULL) {
        clod_status_fail(status, CLOD_FAILED, "%s: %s", path, error.text);
    }
    return summary;
}

/** tau_w/sigma_w at each stress of a wall friction test. */
static bool wall_ratios(const clod_verify_bench *bench, const char *name, const char *section,
                        const double plate[2], double ratio[STRESSES], clod_status *status)
{
    json_t *summary = run(bench, name, section, plate, status);
    const json_t *points = json_object_get(json_object_get(summary, "wall_locus"), "points");
    for (size_t s = 0; s < STRESSES; s++) {
        const json_t *p = json_array_get(points, s);
        ratio[s] = json_number_value(json_object_get(p, "tau_w_Pa")) /
                   json_number_value(json_object_get(p, "sigma_w_Pa"));
    }
    const bool good = summary != NULL;
    json_decref(summary);
    return good;
}

static bool check_smooth(const clod_verify_bench *bench, clod_status *status)
{
    static const double FRICTION[] = {0.1, 0.2, 0.3};
    for (size_t k = 0; k < sizeof FRICTION / sizeof *FRICTION; k++) {
        char name[64];
        double ratio[STRESSES];
        const clod_verify_expect coulomb = {FRICTION[k], 5e-3, true, COULOMB};
        snprintf(name, sizeof name, "wall-straight-%g", FRICTION[k]);
        if (!wall_ratios(bench, name, STRAIGHT, (const double[]){FRICTION[k], ROLLING}, ratio,
                         status)) {
            return false;
        }
        for (size_t s = 0; s < STRESSES; s++) {
            if (!clod_verify_bench_check(bench, &coulomb, ratio[s], status,
                                         "%s: shear over normal stress of the plate at stress "
                                         "%zu of %d [1]",
                                         name, s + 1, STRESSES)) {
                return false;
            }
        }
    }
    return true;
}

/** Steady shear over normal stress of the solid itself, in the same ring with bars below. */
static bool find_bulk(const clod_verify_bench *bench, double *ratio, double *error,
                      clod_status *status)
{
    json_t *summary =
        run(bench, "wall-ring-shear", SHEAR, (const double[]){0.5, ROLLING}, status);
    const json_t *locus =
        json_array_get(json_object_get(json_object_get(summary, "locus"), "loci"), 0);
    const json_t *tau = json_object_get(locus, "tau_p_Pa");
    const double sigma =
        json_number_value(json_object_get(json_object_get(locus, "sigma_p_Pa"), "value"));
    *ratio = json_number_value(json_object_get(tau, "value")) / sigma;
    *error = json_number_value(json_object_get(tau, "error")) / sigma;
    const bool good = summary != NULL;
    json_decref(summary);
    return good;
}

/** On plates rougher than the grains, on which they cannot roll, the solid shears: at its own
 *  shear stress. Where they can roll, at less. */
static bool check_rough(const clod_verify_bench *bench, clod_status *status)
{
    static const struct {
        const char *name;
        double plate[2];
    } ROUGH[] = {{"wall-ring-held", {1.0, HELD}}, {"wall-ring-rolling", {1.0, ROLLING}}};
    double bulk, error, ratio[2][STRESSES];
    if (!find_bulk(bench, &bulk, &error, status)) {
        return false;
    }
    for (int k = 0; k < 2; k++) {
        if (!wall_ratios(bench, ROUGH[k].name, TURNING, ROUGH[k].plate, ratio[k], status)) {
            return false;
        }
        // two errors to either side of that of the solid; where grains roll, from 0
        const double least = k == 0 ? bulk - 2.0 * error : 0.0;
        const double most = bulk + 2.0 * error;
        const clod_verify_expect within = {0.5 * (most + least), 0.5 * (most - least), false,
                                           BULK};
        if (!clod_verify_bench_check(
                bench, &within, ratio[k][0], status,
                "%s: shear over normal stress at the largest stress, from %.3f to %.3f; that of "
                "the solid in steady shear is %.3f ± %.3f [1]",
                ROUGH[k].name, least, most, bulk, error)) {
            return false;
        }
    }
    const clod_verify_expect yes = {1.0, 0.0, false, BULK};
    return clod_verify_bench_check(bench, &yes, ratio[0][0] > ratio[1][0], status,
                                   "a plate on which grains cannot roll bears %.3f, one on "
                                   "which they can %.3f: more (1: yes)",
                                   ratio[0][0], ratio[1][0]);
}

bool clod_verify_wall_friction(const clod_verify_bench *bench, clod_status *status)
{
    return check_smooth(bench, status) && check_rough(bench, status);
}
