#include "sim/uniaxial_warnings.h"

#include <math.h>

#include "analysis/warnings.h"
#include "base/memory.h"
#include "sim/warning_box.h"
#include "tester/limits.h"
#include "tester/uniaxial.h"

#define SERVO_LIMIT 0.02 ///< relative error of the consolidation stress of a lid at rest
#define MOULD_LIMIT 0.05 ///< of sigma_1 that the mould carries
#define WEIGHT_LIMIT 0.1 ///< of the strength that the specimen's own weight is
#define LATE_STRAIN 0.05 ///< at the peak: by then a loose specimen has got denser

static void add_flags(json_t *list, const clod_case *from, const clod_part *part)
{
    const clod_uniaxial *t = part->test;
    if ((t->flags & CLOD_UNIAXIAL_NOT_SETTLED) != 0) {
        const bool filling = part->point < 0;
        clod_warning_box_add(
            list, "%s: %s did not come to rest within uniaxial.%s (%.3g s): raise it%s",
            part->name, filling ? "filling" : "consolidation",
            filling ? "fill_max" : "settle_max",
            filling ? from->uniaxial.fill_max : from->uniaxial.settle_max,
            filling ? "" : ", or uniaxial.lid_damping if the lid swings");
    }
    if ((t->flags & CLOD_UNIAXIAL_NOT_FREE) != 0) {
        clod_warning_box_add(list,
                             "%s: grains still moved when the specimen without its mould was "
                             "crushed, %.3g s after it was taken away: raise "
                             "uniaxial.settle_max, unless the specimen falls apart",
                             part->name, from->uniaxial.settle_max);
    }
    if ((t->flags & CLOD_UNIAXIAL_NO_PEAK) != 0) {
        clod_warning_box_add(list,
                             "%s: no peak within %.0f %% of strain; the largest smoothed value "
                             "is taken. Raise uniaxial.crush_max",
                             part->name, 100.0 * from->uniaxial.crush_max);
    }
    if (t->peak_strain > LATE_STRAIN) {
        clod_warning_box_add(list,
                             "%s: the largest stress came at %.1f %% of strain only: the loose "
                             "specimen was compacted while it was crushed, and was stronger "
                             "than as it was consolidated. Look at %s.csv for the stress at "
                             "which it yields first",
                             part->name, 100.0 * t->peak_strain, part->name);
    }
    if ((t->flags & CLOD_UNIAXIAL_COLLAPSED) != 0) {
        clod_warning_box_add(list,
                             "%s: the specimen did not stand without its mould; its strength "
                             "counts as 0. That is right for a solid that flows freely; if it "
                             "should stand, raise its adhesion (k_adh) or the consolidation "
                             "stress, or lower uniaxial.height",
                             part->name);
    }
}

/** The lid's stress, the mould's friction and the weight: is sigma_1 one number? */
static void add_stresses(json_t *list, const clod_case *from, const clod_part *part)
{
    const clod_uniaxial *t = part->test;
    const double weight = -t->grain_mass * from->gravity[2] / t->area;
    const double mould = (t->sigma_1 + weight - t->sigma_base) / t->sigma_1;
    if (fabs(t->sigma_1 / t->stress - 1.0) > SERVO_LIMIT) {
        // at rest is within this limit: the lid still moved, as another warning says
        clod_warning_box_add(list,
                             "%s: the consolidation stress was %.4g kPa instead of %.4g kPa, "
                             "since the specimen still gave way or the lid swung: raise "
                             "uniaxial.settle_max or lid_damping. The strength is that of "
                             "%.4g kPa",
                             part->name, 1e-3 * t->sigma_1, 1e-3 * t->stress,
                             1e-3 * t->sigma_1);
    }
    if (mould > MOULD_LIMIT) {
        clod_warning_box_add(
            list,
            "%s: the mould carried %.0f %% of the lid's load, so sigma_1 falls "
            "from %.4g kPa at the lid to %.4g kPa at the base (with the "
            "weight). Lower its friction or uniaxial.height",
            part->name, 100.0 * mould, 1e-3 * t->sigma_1, 1e-3 * t->sigma_base);
    }
    if (t->strength > 0.0 && weight > WEIGHT_LIMIT * t->strength) {
        clod_warning_box_add(
            list,
            "%s: the solid's own weight presses with %.3g kPa on the base, "
            "%.0f %% of the strength, which is the lid's stress alone. A lower "
            "specimen is less in doubt",
            part->name, 1e-3 * weight, 100.0 * weight / t->strength);
    }
}

/** I = strain rate d sqrt(rho/sigma) at the strength. */
static void add_inertia(json_t *list, const clod_case *from, const clod_part *part)
{
    const clod_uniaxial *t = part->test;
    const clod_case_material *ore =
        &from->materials[clod_case_material_index(from, from->uniaxial.grain_material)];
    const double number = t->speed / t->unloaded_height * 2.0 * from->uniaxial.radius_mean *
                          sqrt(ore->density / t->strength);
    if (t->strength > 0.0 && number > CLOD_LIMITS_INERTIA) {
        clod_warning_box_add(list,
                             "%s: inertial number %.2g: not quasi-static (%.0e); lower "
                             "uniaxial.speed",
                             part->name, number, CLOD_LIMITS_INERTIA_GOOD);
    }
}

/** Remark on a strength that falls while the consolidation rises; false without memory. */
static bool add_fall(json_t *list, const clod_part *part, int parts)
{
    char text[CLOD_LOCUS_WARNING_TEXT] = "";
    clod_warnings_strength *points = clod_memory_alloc((size_t)parts, sizeof *points);
    size_t count = 0;
    if (points == NULL) {
        return false;
    }
    for (int p = 0; p < parts; p++) {
        const clod_uniaxial *t = part[p].test;
        if (part[p].point >= 0) {
            points[count++] =
                (clod_warnings_strength){t->sigma_1, t->strength, t->strength_error};
        }
    }
    clod_warnings_strength_falls(points, count, text);
    if (text[0] != '\0') {
        clod_warning_box_add(list, "%s", text);
    }
    clod_memory_free(points);
    return true;
}

json_t *clod_uniaxial_warnings(const clod_case *from, const clod_part *part, int parts)
{
    json_t *list = json_array();
    for (int p = 0; p < parts; p++) {
        add_flags(list, from, &part[p]);
        if (part[p].point >= 0) {
            add_stresses(list, from, &part[p]);
            add_inertia(list, from, &part[p]);
        }
        clod_parts_warn_end(list, &part[p]);
    }
    if (!add_fall(list, part, parts)) {
        json_decref(list);
        return NULL;
    }
    const double across = from->uniaxial.diameter / (2.0 * from->uniaxial.radius_mean);
    if (across < CLOD_LIMITS_FREE_GRAINS) {
        clod_warning_box_add(list,
                             "only %.1f grain diameters across the specimen; %.0f are "
                             "wanted. Use a larger mould or smaller grains",
                             across, CLOD_LIMITS_FREE_GRAINS);
    }
    return list;
}
