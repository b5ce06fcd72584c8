// Warnings of fields, mixing indices and angles of repose that will say little or nothing.

#include <math.h>

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
    }
}

void clod_check_measures_warn(const clod_check_subject *subject, clod_check_report *r)
{
    warn_fields(subject, r);
    warn_mixing(subject, r);
    warn_repose(subject, r);
}
