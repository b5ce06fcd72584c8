#include <math.h>

#include "base/json.h"
#include "config/wall_cells.h"
#include "config/wall_ridges.h"
#include "sim/check_testers.h"
#include "sim/wall_shear_warnings.h"
#include "tester/limits.h"

#define BAR_LIMIT 0.98  ///< grain diameters, as good as one
#define SINK_LEAST 0.01 ///< of a grain's radius that it sinks between crests: nothing
#define SPACING_LIMIT                                                                          \
    0.01 ///< by which the spacing in a ring may differ from what was asked for
#define DEGREE (M_PI / 180.0)

static void look_at_ridges(const clod_case_wall_friction *test, double radius,
                           clod_check_report *report)
{
    const clod_wall_ridges ridges = clod_wall_ridges_of(test);
    if (ridges.count > 0) {
        report->plate_ridges = ridges.count;
        report->ridge_spacing = ridges.spacing;
        report->ridge_flank = ridges.flank;
        report->ridge_sink_depth = clod_wall_ridges_sink_depth(&ridges, radius);
        report->plate_roughness = clod_wall_ridges_roughness(&ridges, 2.0 * radius);
    }
}

bool clod_check_wall_look(const clod_check_subject *subject, clod_check_report *report,
                          clod_status *status)
{
    const clod_case_wall_friction *test = &subject->from->wall_friction;
    const double area = clod_wall_cell_area(test);
    if (!clod_check_heights(subject, test->depth, area, report, status)) {
        return false;
    }
    const double diameter = 2.0 * report->radius_mean;
    double lowest = report->stress;
    for (size_t s = 0; s < test->wall_stress_count; s++) {
        lowest = fmin(lowest, test->wall_stresses[s]);
    }
    report->lowest_stress = lowest;
    report->lowest_speed = test->speed * sqrt(lowest / report->stress);
    report->inertial_preshear = clod_check_inertia(
        subject, diameter, test->speed / report->height_aimed, report->stress);
    report->across_width = clod_wall_cell_width(test) / diameter;
    report->bar_diameters = clod_wall_cell_bars(test) > 0 ? test->bar_height / diameter : 0.0;
    look_at_ridges(test, report->radius_mean, report);
    return true;
}

static clod_check_batch filling(const clod_case_wall_friction *test, bool most)
{
    const double time = most ? test->fill_max : CLOD_CHECK_FILL_LIKELY;
    return (clod_check_batch){(int)test->seeds, (double)test->seeds * time, time};
}

/** Consolidation, then run-in and shear at each stress. */
static clod_check_batch shearing(const clod_case_wall_friction *test, double largest, bool most)
{
    const double blocks = (double)test->steady_blocks * test->block_displacement;
    const double likely = fmin(fmax(blocks, test->shear_min), test->shear_max);
    const double way = test->block_displacement + (most ? test->shear_max : likely);
    double time = most ? test->settle_max + test->depth / CLOD_LIMITS_LOWER_SPEED
                       : CLOD_CHECK_LOAD_LIKELY;
    for (size_t s = 0; s < test->wall_stress_count; s++) {
        time += way / (test->speed * sqrt(test->wall_stresses[s] / largest));
    }
    return (clod_check_batch){(int)test->seeds, (double)test->seeds * time, time};
}

int clod_check_wall_batches(const clod_case *from, bool most,
                            clod_check_batch all[CLOD_CHECK_BATCHES])
{
    all[0] = filling(&from->wall_friction, most);
    all[1] = shearing(&from->wall_friction, clod_case_tester_stress(from), most);
    return 2;
}

/** Depth to which a mean grain sinks between two ridges, over its diameter. */
static double sink_over_diameter(const clod_check_report *r)
{
    return r->ridge_sink_depth / (2.0 * r->radius_mean);
}

void clod_check_wall_write(clod_check_page *to, const clod_check_report *r)
{
    clod_check_line(
        to, "inertial number",
        "%.3g if the solid is sheared over its height of %.3g mm and does not slip;",
        r->inertial_preshear, 1e3 * r->height_aimed);
    clod_check_line(
        to, "",
        "the lowest stress, %.4g kPa, is sheared at %.3g mm/s: the same inertial number",
        1e-3 * r->lowest_stress, 1e3 * r->lowest_speed);
    clod_check_line(to, "cell", "%.1f grain diameters wide, %.1f deep; bars %.2f high",
                    r->across_width, r->across_depth, r->bar_diameters);
    if (r->plate_ridges > 0) {
        clod_check_line(
            to, "plate",
            "%lld ridges, one every %.4g mm, flanks of %.3g deg; grains sink %.3g mm "
            "between them",
            (long long)r->plate_ridges, 1e3 * r->ridge_spacing, r->ridge_flank / DEGREE,
            1e3 * r->ridge_sink_depth);
        clod_check_line(to, "", "roughness over a grain's diameter Rmax(L = d)/d = %.3g",
                        r->plate_roughness);
        if (r->ridge_spacing < 2.0 * r->radius_mean) {
            clod_check_line(to, "",
                            "ridges closer than a grain's diameter: grains lie on crests;");
            clod_check_line(to, "",
                            "the roughness that they feel is the depth they sink, %.3g d",
                            sink_over_diameter(r));
        }
    }
}

static const clod_check_real WALL_REALS[] = {
    CLOD_CHECK_REAL("inertial_number", inertial_preshear),
    CLOD_CHECK_REAL("height_aimed_m", height_aimed),
    CLOD_CHECK_REAL("height_loose_m", height_loose),
    CLOD_CHECK_REAL("lowest_stress_Pa", lowest_stress),
    CLOD_CHECK_REAL("lowest_speed_m_per_s", lowest_speed),
    CLOD_CHECK_REAL("diameters_across_width", across_width),
    CLOD_CHECK_REAL("diameters_across_depth", across_depth),
    CLOD_CHECK_REAL("bar_height_diameters", bar_diameters),
};

static const clod_check_real RIDGE_REALS[] = {
    CLOD_CHECK_REAL("ridge_spacing_m", ridge_spacing),
    CLOD_CHECK_REAL("ridge_flank_rad", ridge_flank),
    CLOD_CHECK_REAL("ridge_sink_depth_m", ridge_sink_depth),
    CLOD_CHECK_REAL("plate_roughness", plate_roughness),
};

void clod_check_wall_put(json_t *to, const clod_check_report *r)
{
    clod_check_put(to, r, WALL_REALS, sizeof WALL_REALS / sizeof WALL_REALS[0]);
    if (r->plate_ridges > 0) {
        json_object_set_new(to, "plate_ridges", json_integer((json_int_t)r->plate_ridges));
        clod_check_put(to, r, RIDGE_REALS, sizeof RIDGE_REALS / sizeof RIDGE_REALS[0]);
        json_object_set_new(to, "ridge_sink_depth_diameters",
                            clod_json_number(sink_over_diameter(r)));
    }
}

/** Ridges that grains do not feel, or that are not as far apart as the case says. */
static void warn_ridges(const clod_case_wall_friction *test, clod_check_report *r)
{
    const double asked = test->plate_ridges.spacing;
    if (r->ridge_sink_depth < SINK_LEAST * r->radius_mean) {
        clod_check_warning(
            r,
            "grains sink %.2g mm between the ridges of the plate, %.2g %% of their radius: they "
            "hardly feel them. Raise wall_friction.plate_ridges.height or spacing, or leave the "
            "ridges out and raise the friction of grains and plate",
            1e3 * r->ridge_sink_depth, 1e2 * r->ridge_sink_depth / r->radius_mean);
    }
    if (fabs(r->ridge_spacing / asked - 1.0) > SPACING_LIMIT) {
        clod_check_warning(r,
                           "a spacing of %.6g mm does not divide the way round the ring: the "
                           "plate has %lld ridges, one every %.4g mm",
                           1e3 * asked, (long long)r->plate_ridges, 1e3 * r->ridge_spacing);
    }
}

/** Name of the key by which contacts of a pair pull; NULL: they do not. */
static const char *pull_key(const clod_case_contact *pair)
{
    return pair->k_adh > 0.0            ? "k_adh"
           : pair->surface_energy > 0.0 ? "surface_energy"
           : pair->pull_off_force > 0.0 ? "pull_off_force"
                                        : NULL;
}

/**
 * Adhesion of a flat plate that its Coulomb limit does not count. The forces of the contacts add up to
 * the load whatever they pull, so that friction that goes with the force has nothing of the pull.
 * Source  docs/theory/wall-friction.md, "Adhesion".
 * Test    tests/cli/test_wall_friction.py; that it is so: tests/python/test_wall_contacts.py
 */
static void warn_adhesion(const clod_case *from, clod_check_report *r)
{
    const clod_case_wall_friction *test = &from->wall_friction;
    const clod_case_contact *pair =
        clod_case_pair(from, clod_case_material_index(from, test->grain_material),
                       clod_case_material_index(from, test->plate_material));
    const char *key = pull_key(pair);
    if (key != NULL && pair->coulomb != CLOD_COULOMB_ADHESIVE && r->plate_ridges == 0) {
        clod_check_warning(
            r,
            "%s of %s and %s gives next to no wall adhesion: with coulomb: %s friction goes with "
            "the force of a contact, and the forces on a flat plate add up to the load, whatever "
            "they pull. Only contacts that are drawn apart feel it, few on a smooth plate. Write "
            "coulomb: adhesive for this pair of contacts, or leave %s out",
            key, test->grain_material, test->plate_material,
            pair->coulomb == CLOD_COULOMB_FORCE ? "force" : "paper", key);
    }
}

void clod_check_wall_warn(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case_wall_friction *test = &subject->from->wall_friction;
    const double across = fmin(r->across_width, r->across_depth);
    if (r->inertial_preshear > CLOD_LIMITS_INERTIA) {
        clod_check_warning(
            r,
            "inertial number %.3g: the grains' inertia adds to the shear stress of a rough wall "
            "(%.2g is quasi-static). Lower wall_friction.speed to %.2g mm/s",
            r->inertial_preshear, CLOD_LIMITS_INERTIA_GOOD,
            1e3 * test->speed * CLOD_LIMITS_INERTIA_GOOD / r->inertial_preshear);
    }
    if (across < CLOD_LIMITS_WALL_GRAINS) {
        clod_check_warning(
            r,
            "only %.1f grain diameters across the %s of the specimen (at least %.0f): use a "
            "larger cell or smaller grains",
            across, r->across_width < r->across_depth ? "width" : "depth",
            CLOD_LIMITS_WALL_GRAINS);
    }
    if (clod_wall_cell_of(test)->bars && r->bar_diameters < BAR_LIMIT) {
        clod_check_warning(
            r,
            "the bars of the lid are %.2f grain diameters high: the solid may slip along the "
            "lid, not along the plate. Raise wall_friction.bar_height to %.3g mm%s",
            r->bar_diameters, 2e3 * r->radius_mean,
            test->bar_count == 0 ? ", and bar_count to 20" : "");
    }
    if (r->plate_ridges > 0) {
        warn_ridges(test, r);
    }
    const double ridges = test->plate_ridges.height / (2.0 * r->radius_mean);
    const double gap = r->across_depth - r->bar_diameters - ridges;
    if (r->bar_diameters > 0.0 && gap < CLOD_LIMITS_BARS_GRAINS) {
        clod_check_warning(
            r,
            "only %.1f grain diameters between the bars of the lid and the plate (at least "
            "%.0f): grains roll there and the plate feels too little. Raise "
            "wall_friction.depth, or lower bar_height",
            gap, CLOD_LIMITS_BARS_GRAINS);
    }
    warn_adhesion(subject->from, r);
    char text[512];
    if (clod_wall_shear_lever(subject->from, text, sizeof text)) {
        clod_check_warning(r, "%s", text);
    }
    if (clod_wall_shear_rough(subject->from, text, sizeof text)) {
        clod_check_warning(r, "%s", text);
    }
    if (test->wall_stress_count < 3) {
        clod_check_warning(r, "2 stresses: a line needs three or more to show its error; add "
                              "some to wall_friction.wall_stresses");
    }
}
