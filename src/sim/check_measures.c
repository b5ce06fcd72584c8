// Warnings of fields, mixing indices and angles of repose that will say little or nothing.

#include <math.h>

#include "config/region.h"
#include "sim/check_testers.h"
#include "sim/steady_time.h"

static void warn_fields(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_steady_time steady =
        clod_steady_time_of(subject->from, subject->state.time, subject->state.dt);
    const bool test = clod_case_tester(subject->from) != NULL; // its means are its rows
    const double length = test ? HUGE_VAL : steady.block * CLOD_STEADY_BLOCKS;
    for (size_t k = 0; k < subject->from->field_count; k++) {
        const clod_case_field *field = &subject->from->fields[k];
        if (field->cell > 0.0 && field->width < 2.0 * r->radius_max) {
            clod_check_warning(
                r,
                "fields.%s.width %.3g m is less than the largest grain, %.3g m across: the grid "
                "will show single grains. Two to four diameters show a continuum",
                field->name, field->width, 2.0 * r->radius_max);
        }
        if (field->interval > length) {
            clod_check_warning(
                r,
                "fields.%s.interval %.3g s is longer than the steady time of %.3g s, over "
                "which means are taken: it has one sample or none. Make it %.2g s or less",
                field->name, field->interval, length, 0.1 * length);
        }
    }
}

/** Grains of the first kind. */
static size_t count_first(const clod_check_subject *subject, const clod_case_mixing *mixing)
{
    const clod_grains *grains = &subject->state.grains;
    const int material = mixing->material != NULL
                             ? clod_case_material_index(subject->from, mixing->material)
                             : -1;
    size_t first = 0;
    for (size_t g = 0; g < grains->count; g++) {
        first += material >= 0 ? grains->material[g] == material
                               : grains->position[g][3] > mixing->above;
    }
    return first;
}

static void warn_mixing(const clod_check_subject *subject, clod_check_report *r)
{
    for (size_t k = 0; k < subject->from->mixing_count; k++) {
        const clod_case_mixing *mixing = &subject->from->mixings[k];
        const size_t first = count_first(subject, mixing);
        if (first > 0 && first < subject->state.grains.count) {
            continue;
        }
        const char *share = first > 0 ? "all" : "no";
        if (mixing->material != NULL) {
            clod_check_warning(
                r,
                "mixing.%s.material: %s grains are of %s: grains of one kind have no mixing "
                "index. Give groups of grains two materials, or tell them apart by above",
                mixing->name, share, mixing->material);
        } else {
            clod_check_warning(
                r,
                "mixing.%s.above: %s grains have a radius above %.3g m: grains of one kind have "
                "no mixing index. Radii are %.3g m to %.3g m: choose one between",
                mixing->name, share, mixing->above, r->radius_min, r->radius_max);
        }
    }
}

/** A heap without a centre has its axis where its mass is, about the middle of the region: three strips from there
 *  outwards. What can never have them is refused (config/check_mixing.c). */
static void warn_flank(const clod_case_repose *angle, clod_check_report *r)
{
    double low[3], high[3];
    clod_region_bounds(&angle->region, low, high);
    const bool round = clod_region_row(&angle->region)->upright;
    const double length =
        0.5 * (round ? high[0] - low[0] : hypot(high[0] - low[0], high[1] - low[1]));
    if (!angle->has_direction && !angle->has_center && length < 3.0 * angle->cell) {
        clod_check_warning(
            r,
            "repose.%s.cell %.3g m: from the middle of the region, about which a heap has its axis, to its "
            "farthest point are %.3g m, fewer than the three strips that an angle needs. Make it "
            "%.3g m or less",
            angle->name, angle->cell, length, 0.33 * length);
    }
}

static void warn_repose(const clod_check_subject *subject, clod_check_report *r)
{
    for (size_t k = 0; k < subject->from->repose_count; k++) {
        const clod_case_repose *angle = &subject->from->reposes[k];
        if (angle->cell < 2.0 * r->radius_max * (1.0 - 1e-12)) {
            clod_check_warning(
                r,
                "repose.%s.cell %.3g m is less than the largest grain, %.3g m across: strips "
                "share grains, and the standard error of the angle will be too small. Make it "
                "one to one and a half diameters",
                angle->name, angle->cell, 2.0 * r->radius_max);
        }
        warn_flank(angle, r);
    }
}

/** Where grains are along an axis [m]. */
typedef struct extent {
    double low, high;
} extent;

static extent extent_of(const clod_state *state, int axis)
{
    extent all = {HUGE_VAL, -HUGE_VAL};
    for (size_t g = 0; g < state->grains.count; g++) {
        const double *p = state->grains.position[g];
        all.low = fmin(all.low, p[axis] - p[3]);
        all.high = fmax(all.high, p[axis] + p[3]);
    }
    return all;
}

/** A region of a test, `reach` [m] about it counted too, that no grain comes to: above or below the bed, which only
 *  gets lower, or a bed's width beside it, further than any cell is sheared. */
static void warn_empty(const clod_check_subject *subject, const char *section, const char *name,
                       const clod_case_region *region, double reach, clod_check_report *r)
{
    double low[3], high[3];
    clod_region_bounds(region, low, high);
    for (int a = 2; a >= 0; a--) {
        const extent bed = extent_of(&subject->state, a);
        const double room = reach + (a == 2 ? 0.0 : bed.high - bed.low);
        if (low[a] >= bed.high + room || high[a] <= bed.low - room) {
            clod_check_warning(
                r,
                "%s.%s.region is from %.4g m to %.4g m along %c, where no grain comes: they are "
                "filled in between %.4g m and %.4g m. It would have no numbers",
                section, name, low[a], high[a], "xyz"[a], bed.low, bed.high);
            return;
        }
    }
}

/** Regions of a test, which has no domain that they could be held against before. */
static void warn_places(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case *from = subject->from;
    if (clod_case_tester(from) == NULL || r->sampled > 0) {
        return;
    }
    for (size_t k = 0; k < from->field_count; k++) {
        const clod_case_field *field = &from->fields[k];
        warn_empty(subject, "fields", field->name, &field->region, field->width, r);
    }
    for (size_t k = 0; k < from->mixing_count; k++) {
        const clod_case_mixing *mixing = &from->mixings[k];
        warn_empty(subject, "mixing", mixing->name, &mixing->region, 0.0, r);
    }
}

void clod_check_measures_warn(const clod_check_subject *subject, clod_check_report *r)
{
    warn_fields(subject, r);
    warn_mixing(subject, r);
    warn_repose(subject, r);
    warn_places(subject, r);
}
