#include <math.h>

#include "sim/check_testers.h"
#include "sim/shear_cell.h"
#include "tester/limits.h"

// Duration of the phases of a shear test, besides preshear and shear: what copper ore needs;
// their limits are those of the procedure (tester/limits.h).
#define LOWER_MOST 6e-3     ///< m of the lid until it carries
#define REVERSE_LIKELY 2e-4 ///< m
#define PRESHEAR_LIKELY 5.0 ///< times the blocks that must agree
#define PEAK_LIKELY 4e-3    ///< m of shear

bool clod_check_shear_look(const clod_check_subject *subject, clod_check_report *report,
                           clod_status *status)
{
    const clod_shear_cell cell = clod_shear_cell_of(subject->from);
    const clod_case_programme *shear = cell.programme;
    if (!clod_check_heights(subject, cell.height, cell.area, report, status)) {
        return false;
    }
    const double diameter = 2.0 * report->radius_mean;
    double lowest = shear->preshear_stress;
    for (size_t s = 0; s < shear->shear_stress_count; s++) {
        lowest = fmin(lowest, shear->shear_stresses[s]);
    }
    report->lowest_stress = lowest;
    report->lowest_speed = shear->speed * sqrt(lowest / shear->preshear_stress);
    report->inertial_preshear = clod_check_inertia(
        subject, diameter, shear->speed / report->height_aimed, shear->preshear_stress);
    report->inertial_loose = clod_check_inertia(
        subject, diameter, shear->speed / report->height_loose, shear->preshear_stress);
    report->inertial_lowest = clod_check_inertia(
        subject, diameter, report->lowest_speed / report->height_aimed, lowest);
    report->across_width = cell.width / diameter;
    report->bar_diameters = cell.bar_count > 0 ? cell.bar_height / diameter : 0.0;
    return true;
}

static clod_check_batch preparations(const clod_shear_cell *cell, bool most)
{
    const clod_case_programme *test = cell->programme;
    const double blocks = (double)test->steady_blocks * test->block_displacement;
    const double likely = fmax(PRESHEAR_LIKELY * blocks, test->preshear_min);
    const double shear = most ? test->preshear_max : fmin(likely, test->preshear_max);
    const double time =
        (most ? cell->fill_max + LOWER_MOST / CLOD_LIMITS_LOWER_SPEED + cell->settle_max
              : CLOD_CHECK_FILL_LIKELY + CLOD_CHECK_LOAD_LIKELY) +
        cell->twisting + shear / test->speed;
    return (clod_check_batch){(int)test->seeds, (double)test->seeds * time, time};
}

static clod_check_batch reversals(const clod_case_programme *test, bool most)
{
    const double time = (most ? CLOD_LIMITS_REVERSE_MAX : REVERSE_LIKELY) /
                        (CLOD_LIMITS_REVERSE_FRACTION * test->speed);
    return (clod_check_batch){(int)test->seeds, (double)test->seeds * time, time};
}

static clod_check_batch points(const clod_shear_cell *cell, bool most)
{
    const clod_case_programme *test = cell->programme;
    clod_check_batch all = {(int)(test->seeds * (int64_t)test->shear_stress_count), 0.0, 0.0};
    const double peak = fmin(PEAK_LIKELY + test->beyond_peak, test->shear_max);
    for (size_t s = 0; s < test->shear_stress_count; s++) {
        const double speed =
            test->speed * sqrt(test->shear_stresses[s] / test->preshear_stress);
        const double time = (most ? cell->settle_max : CLOD_CHECK_LOAD_LIKELY) +
                            (most ? test->shear_max : peak) / speed;
        all.time += (double)test->seeds * time;
        all.longest = fmax(all.longest, time);
    }
    return all;
}

int clod_check_shear_batches(const clod_case *from, bool most,
                             clod_check_batch all[CLOD_CHECK_BATCHES])
{
    const clod_shear_cell cell = clod_shear_cell_of(from);
    all[0] = preparations(&cell, most);
    all[1] = reversals(cell.programme, most);
    all[2] = points(&cell, most);
    return 3;
}

static void write_shear(clod_check_page *to, const clod_check_report *r)
{
    clod_check_line(
        to, "inertial number",
        "%.3g if the specimen settles to %.3g mm, the height that fill_fraction aims at;",
        r->inertial_preshear, 1e3 * r->height_aimed);
    clod_check_line(to, "",
                    "%.3g at the filling height, %.3g mm; a cohesive bed ends between the two",
                    r->inertial_loose, 1e3 * r->height_loose);
    clod_check_line(
        to, "", "the lowest point, %.4g kPa, is sheared at %.3g mm/s: the same inertial number",
        1e-3 * r->lowest_stress, 1e3 * r->lowest_speed);
}

void clod_check_ring_write(clod_check_page *to, const clod_check_report *r)
{
    write_shear(to, r);
    clod_check_line(to, "cell", "%.1f grain diameters wide, %.1f deep; bars %.2f high",
                    r->across_width, r->across_depth, r->bar_diameters);
}

void clod_check_jenike_write(clod_check_page *to, const clod_check_report *r)
{
    write_shear(to, r);
    clod_check_line(to, "cell", "%.1f grain diameters wide, %.1f deep", r->across_width,
                    r->across_depth);
}

static const clod_check_real SHEAR_REALS[] = {
    CLOD_CHECK_REAL("inertial_number_preshear", inertial_preshear),
    CLOD_CHECK_REAL("inertial_number_loose", inertial_loose),
    CLOD_CHECK_REAL("inertial_number_lowest", inertial_lowest),
    CLOD_CHECK_REAL("height_aimed_m", height_aimed),
    CLOD_CHECK_REAL("height_loose_m", height_loose),
    CLOD_CHECK_REAL("lowest_stress_Pa", lowest_stress),
    CLOD_CHECK_REAL("lowest_speed_m_per_s", lowest_speed),
    CLOD_CHECK_REAL("diameters_across_width", across_width),
    CLOD_CHECK_REAL("diameters_across_depth", across_depth),
};

static const clod_check_real RING_REALS[] = {
    CLOD_CHECK_REAL("bar_height_diameters", bar_diameters)};

void clod_check_shear_put(json_t *to, const clod_check_report *r)
{
    clod_check_put(to, r, SHEAR_REALS, sizeof SHEAR_REALS / sizeof SHEAR_REALS[0]);
}

void clod_check_ring_put(json_t *to, const clod_check_report *r)
{
    clod_check_shear_put(to, r);
    clod_check_put(to, r, RING_REALS, sizeof RING_REALS / sizeof RING_REALS[0]);
}
