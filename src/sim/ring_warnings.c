#include "sim/ring_warnings.h"

#include <math.h>
#include <stdio.h>

#include "sim/shear_cell.h"
#include "sim/warning_box.h"
#include "tester/limits.h"
#include "tester/shear_tester.h"

#define SERVO_LIMIT 0.01    ///< relative error of the mean normal stress
#define DILATION_LIMIT 0.01 ///< change of height per shear displacement

const char *clod_ring_preshear_words(const clod_ring_shear *test,
                                     char text[CLOD_RING_WORDS_SIZE])
{
    const double rate = 1e-6 * test->preshear_rate; // kPa/mm
    const double error = 1e-6 * test->preshear_rate_error;
    const double way = 1e3 * test->preshear_displacement;
    if ((test->flags & CLOD_RING_SHEAR_NOT_STEADY) == 0) {
        snprintf(text, CLOD_RING_WORDS_SIZE,
                 "steady after %.3g mm of shear, its slope %+.2g ± %.1g kPa/mm", way, rate,
                 error);
    } else if (fabs(rate) > 2.0 * error) {
        snprintf(text, CLOD_RING_WORDS_SIZE,
                 "still %s by %.2g ± %.1g kPa/mm after %.3g mm of shear",
                 rate > 0.0 ? "rising" : "falling", fabs(rate), error, way);
    } else {
        snprintf(text, CLOD_RING_WORDS_SIZE,
                 "uneven after %.3g mm of shear, without a trend that could be told (%+.2g ± "
                 "%.1g kPa/mm)",
                 way, rate, error);
    }
    return text;
}

static void add_flags(json_t *list, const clod_shear_cell *cell, const clod_part *part)
{
    const clod_ring_shear *t = part->test;
    const clod_shear_tester *tester = clod_shear_tester_of(t);
    const int64_t flags = t->flags;
    if ((flags & CLOD_RING_SHEAR_NOT_STEADY) != 0) {
        char words[CLOD_RING_WORDS_SIZE];
        clod_warning_box_add(list,
                             "%s: shear stress %s; tau_p is where a line through the last "
                             "blocks ends. %s",
                             part->name, clod_ring_preshear_words(t, words),
                             tester->if_not_steady);
    }
    if ((flags & CLOD_RING_SHEAR_NOT_SETTLED) != 0) {
        clod_warning_box_add(
            list,
            "%s: %s did not come to rest in time. Raise %s.settle_max (%.3g s)%s, or "
            "lid_damping "
            "if the lid swings",
            part->name,
            part->point < 0 ? "filling or consolidation" : "the lid under the reduced load",
            cell->key, cell->settle_max, part->point < 0 ? " or fill_max" : "");
    }
    if ((flags & CLOD_RING_SHEAR_NO_REVERSAL) != 0) {
        clod_warning_box_add(
            list,
            "%s: the shear stress did not fall to zero when sheared back: the points begin "
            "under shear. Look at %s.csv: if it still falls at the end, raise the stiffness%s; "
            "if it is level, use a larger cell or smaller grains",
            part->name, part->name, tester->to_reverse);
    }
    if ((flags & CLOD_RING_SHEAR_NO_PEAK) != 0) {
        clod_warning_box_add(
            list,
            "%s: no peak within %.3g mm of shear; the largest smoothed value is taken. Raise "
            "%s.shear_max%s",
            part->name, 1e3 * cell->programme->shear_max, cell->key, tester->to_go_further);
    }
}

/** The height decides nothing in preshear, but critical state means that it is constant. */
static void add_dilation(json_t *list, const clod_shear_cell *cell, const clod_part *part)
{
    const clod_ring_shear *t = part->test;
    const char *further = clod_shear_tester_of(t)->to_go_further;
    const double rate = t->preshear_dilation;
    if (part->point < 0 && fabs(rate) > DILATION_LIMIT) {
        const bool steady = (t->flags & CLOD_RING_SHEAR_NOT_STEADY) == 0;
        clod_warning_box_add(
            list,
            "%s: %sthe specimen still %s by %.3f mm per mm of shear: not the critical state. "
            "Raise %s.%s to go further%s%s",
            part->name, steady ? "the shear stress is steady, but " : "",
            rate > 0.0 ? "dilates" : "contracts", fabs(rate), cell->key,
            steady ? "steady_blocks" : "preshear_max", further[0] != '\0' ? "," : "", further);
    }
}

static void add_servo(json_t *list, const clod_shear_cell *cell, const clod_part *part)
{
    const clod_ring_shear *t = part->test;
    const double aim = part->point >= 0 ? t->shear_stress : t->preshear_stress;
    const double mean = part->point >= 0 ? t->point_normal : t->preshear_normal;
    if (fabs(mean / aim - 1.0) > SERVO_LIMIT) {
        clod_warning_box_add(
            list,
            "%s: the mean normal stress %s was %.4g kPa instead of %.4g kPa; lower "
            "%s.lid_damping or speed",
            part->name, part->point >= 0 ? "at the peak" : "of the last blocks", 1e-3 * mean,
            1e-3 * aim, cell->key);
    }
}

/** I = shear rate d sqrt(rho/sigma), the shear spread over the whole height. */
static double inertial_number(const clod_case *from, const clod_shear_cell *cell,
                              const clod_part *part)
{
    const clod_ring_shear *t = part->test;
    const clod_case_material *ore =
        &from->materials[clod_case_material_index(from, cell->grain_material)];
    const double speed = part->point >= 0 ? t->shear_speed : t->speed;
    const double stress = part->point >= 0 ? t->shear_stress : t->preshear_stress;
    return speed / t->preshear_height * 2.0 * cell->radius_mean * sqrt(ore->density / stress);
}

static void add_part(json_t *list, const clod_case *from, const clod_shear_cell *cell,
                     const clod_part *part)
{
    const bool sheared = part->point != CLOD_RING_REVERSE;
    const double inertia = sheared ? inertial_number(from, cell, part) : 0.0;
    add_flags(list, cell, part);
    if (sheared) {
        add_servo(list, cell, part);
        add_dilation(list, cell, part);
    }
    clod_parts_warn_end(list, part);
    if (inertia > CLOD_LIMITS_INERTIA) {
        clod_warning_box_add(
            list, "%s: inertial number %.2g: not quasi-static (%.0e); lower %s.speed",
            part->name, inertia, CLOD_LIMITS_INERTIA_GOOD, cell->key);
    }
}

json_t *clod_ring_warnings(const clod_case *from, const clod_part *part, int parts)
{
    const clod_shear_cell cell = clod_shear_cell_of(from);
    json_t *list = json_array();
    for (int p = 0; p < parts; p++) {
        add_part(list, from, &cell, &part[p]);
    }
    const clod_ring_shear *first = part[0].test;
    const double gap = fmin(cell.width, first->preshear_height);
    const double across = gap / (2.0 * cell.radius_mean);
    if (across < CLOD_LIMITS_ACROSS) {
        clod_warning_box_add(list,
                             "only %.1f grain diameters across the specimen; %.0f are wanted. "
                             "Use a larger cell or smaller grains",
                             across, CLOD_LIMITS_ACROSS);
    }
    return list;
}
