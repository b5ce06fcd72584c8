#include <math.h>

#include "setup/uniaxial_cell.h"
#include "sim/check_testers.h"
#include "tester/limits.h"

#define CRUSH_LIKELY 0.03 ///< strain at the peak

/** Crushed at the lowest consolidation stress, as if the strength were as much. */
bool clod_check_uniaxial_look(const clod_check_subject *subject, clod_check_report *report,
                              clod_status *status)
{
    const clod_case_uniaxial *test = &subject->from->uniaxial;
    const double area = clod_uniaxial_cell_area(test);
    if (!clod_check_heights(subject, test->height, area, report, status)) {
        return false;
    }
    const double diameter = 2.0 * report->radius_mean;
    double lowest = report->stress;
    for (size_t s = 0; s < test->consolidation_stress_count; s++) {
        lowest = fmin(lowest, test->consolidation_stresses[s]);
    }
    report->lowest_stress = lowest;
    report->inertial_lowest =
        clod_check_inertia(subject, diameter, test->speed / report->height_aimed, lowest);
    report->across_width = test->diameter / diameter;
    return true;
}

static clod_check_batch filling(const clod_case_uniaxial *test, bool most)
{
    const double time = most ? test->fill_max : CLOD_CHECK_FILL_LIKELY;
    return (clod_check_batch){1, time, time};
}

/** Consolidations of a uniaxial test, each crushed. */
static clod_check_batch crushings(const clod_case_uniaxial *test, bool most)
{
    const double strain =
        most ? test->crush_max : fmin(CRUSH_LIKELY + test->beyond_peak, test->crush_max);
    const double rests = 2.0 * (most ? test->settle_max : CLOD_CHECK_LOAD_LIKELY);
    const double time = (most ? test->height / CLOD_LIMITS_LOWER_SPEED : 0.0) + rests +
                        strain * test->height / test->speed;
    const int count = (int)test->consolidation_stress_count;
    return (clod_check_batch){count, count * time, time};
}

int clod_check_uniaxial_batches(const clod_case *from, bool most,
                                clod_check_batch all[CLOD_CHECK_BATCHES])
{
    all[0] = filling(&from->uniaxial, most);
    all[1] = crushings(&from->uniaxial, most);
    return 2;
}

void clod_check_uniaxial_write(clod_check_page *to, const clod_check_report *r)
{
    clod_check_line(
        to, "inertial number",
        "%.3g at %.4g kPa, the lowest consolidation stress, and a height of %.3g mm;",
        r->inertial_lowest, 1e-3 * r->lowest_stress, 1e3 * r->height_aimed);
    clod_check_line(to, "",
                    "the filling height is %.3g mm; a cohesive bed ends between the two",
                    1e3 * r->height_loose);
    clod_check_line(to, "mould", "%.1f grain diameters wide, %.1f high", r->across_width,
                    r->across_depth);
}

static const clod_check_real UNIAXIAL_REALS[] = {
    CLOD_CHECK_REAL("inertial_number_lowest", inertial_lowest),
    CLOD_CHECK_REAL("height_aimed_m", height_aimed),
    CLOD_CHECK_REAL("height_loose_m", height_loose),
    CLOD_CHECK_REAL("lowest_stress_Pa", lowest_stress),
    CLOD_CHECK_REAL("diameters_across_width", across_width),
    CLOD_CHECK_REAL("diameters_across_depth", across_depth),
};

void clod_check_uniaxial_put(json_t *to, const clod_check_report *r)
{
    clod_check_put(to, r, UNIAXIAL_REALS, sizeof UNIAXIAL_REALS / sizeof UNIAXIAL_REALS[0]);
}

void clod_check_uniaxial_warn(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case_uniaxial *test = &subject->from->uniaxial;
    if (r->inertial_lowest > CLOD_LIMITS_INERTIA) {
        clod_check_warning(
            r,
            "inertial number %.3g at %.4g kPa: the grains' inertia adds to the strength (%.2g "
            "is quasi-static). Lower uniaxial.speed to %.2g mm/s",
            r->inertial_lowest, 1e-3 * r->lowest_stress, CLOD_LIMITS_INERTIA_GOOD,
            1e3 * test->speed * CLOD_LIMITS_INERTIA_GOOD / r->inertial_lowest);
    }
    if (r->across_width < CLOD_LIMITS_FREE_GRAINS) {
        clod_check_warning(
            r,
            "only %.1f grain diameters across the specimen (at least %.0f): single grains set "
            "its strength. Use a larger mould or smaller grains",
            r->across_width, CLOD_LIMITS_FREE_GRAINS);
    }
}
