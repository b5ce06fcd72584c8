#include <math.h>

#include "base/plural.h"
#include "sim/check_testers.h"
#include "sim/shear_cell.h"
#include "tester/limits.h"

#define BAR_LIMIT 0.98 ///< grain diameters, as good as one
#define FEW_GRAINS 0.6 ///< of those that fill the depth
#define MANY_GRAINS 1.4
#define WEAK_STRESS 0.1 ///< points below this part of the preshear stress are unsafe

/** A dry bed settles to about the height aimed at; a cohesive one stays looser and higher. The speed advised is slow
 *  enough for either: the number goes with 1/height, and none settles lower. */
static void warn_inertia(const clod_shear_cell *cell, clod_check_report *r)
{
    const double speed = cell->programme->speed;
    const bool cohesive = r->pull_off > 0.0;
    const double number = cohesive ? r->inertial_loose : r->inertial_preshear;
    const double slow = 1e3 * speed * CLOD_LIMITS_INERTIA_GOOD / r->inertial_preshear;
    if (number > CLOD_LIMITS_INERTIA) {
        clod_check_warning(
            r,
            "inertial number %.3g%s: the grains' inertia adds to the shear stress (%.2g is "
            "quasi-static). Lower %s.speed to %.2g mm/s%s",
            number, cohesive ? " even at the filling height" : "", CLOD_LIMITS_INERTIA_GOOD,
            cell->key, slow, cohesive ? ", slow enough wherever the bed settles" : "");
    } else if (r->inertial_preshear > CLOD_LIMITS_INERTIA) {
        const double height = r->height_aimed * r->inertial_preshear / CLOD_LIMITS_INERTIA;
        clod_check_note(
            r,
            "%.3g mm/s may be too fast if the bed settles below %.3g mm (inertial number above "
            "%.2g): the results state the height and warn if so. %.2g mm/s is slow enough at "
            "any height",
            1e3 * speed, 1e3 * height, CLOD_LIMITS_INERTIA, slow);
    }
}

static void warn_count(const clod_shear_cell *cell, clod_check_report *r)
{
    const double part = (double)r->grains / (double)r->full_grains;
    if (part < FEW_GRAINS || part > MANY_GRAINS) {
        clod_check_warning(
            r,
            "%zu grain%s %.0f %% of those that fill the depth (%zu): the specimen will be "
            "some %.3g mm high, not %.3g mm. Change %s.grain_count, or write auto",
            r->grains, r->grains == 1 ? " is" : "s are", 100.0 * part, r->full_grains,
            1e3 * r->height_aimed, 1e3 * cell->height, cell->key);
    }
}

/** What a ring has to grip the solid with. */
static void warn_bars(const clod_shear_cell *cell, clod_check_report *r)
{
    if (cell->bar_count == 0) {
        clod_check_warning(
            r, "ring_shear.bar_count is 0: lid and base grip by friction alone and the solid "
               "may slip along them. Raise it: 20 is usual");
    } else if (r->bar_diameters < BAR_LIMIT) {
        clod_check_warning(
            r,
            "the bars are %.2f grain diameters high: grains slip over them. Raise "
            "ring_shear.bar_height to %.3g mm",
            r->bar_diameters, 2e3 * r->radius_mean);
    }
}

static void warn_points(const clod_shear_cell *cell, clod_check_report *r)
{
    const clod_case_programme *shear = cell->programme;
    if (r->lowest_stress < WEAK_STRESS * shear->preshear_stress) {
        clod_check_warning(
            r,
            "the lowest shear point is %.1f %% of the preshear stress: so low a stress is hard "
            "to hold and bends the yield locus. 20 to 80 %% is usual: raise or remove it in "
            "%s.shear_stresses",
            100.0 * r->lowest_stress / shear->preshear_stress, cell->key);
    }
    if (shear->shear_stress_count < 3) {
        clod_check_warning(
            r,
            "%zu shear point%s: a line needs three or more to show its error; add some to "
            "%s.shear_stresses",
            shear->shear_stress_count, clod_plural((double)shear->shear_stress_count),
            cell->key);
    }
}

/** The load of the run is the force between lid and solid: no weight acts beside it. */
static void note_lid(const clod_check_subject *subject, const clod_shear_cell *cell,
                     clod_check_report *r)
{
    const double weight = -cell->lid_mass * subject->from->gravity[2] / cell->area;
    if (weight > r->lowest_stress) {
        clod_check_note(r,
                        "a lid of this mass would press with %.3g kPa by its weight, more than "
                        "the lowest shear point, %.3g kPa: the run holds that stress all the "
                        "same, but in a laboratory the lid needs a counterweight. With a lower "
                        "%s.lid_mass it needs none",
                        1e-3 * weight, 1e-3 * r->lowest_stress, cell->key);
    }
}

/** Of the specimen in a ring or in a Jenike cell. */
static void warn_specimen(const clod_shear_cell *cell, clod_check_report *r)
{
    warn_inertia(cell, r);
    warn_count(cell, r);
    const double across = fmin(r->across_width, r->across_depth);
    if (across < CLOD_LIMITS_ACROSS) {
        clod_check_warning(
            r,
            "only %.1f grain diameters across the %s of the specimen (at least %.0f): walls, "
            "not the solid, set the strength. Use a larger cell or smaller grains",
            across, r->across_width < r->across_depth ? "width" : "depth", CLOD_LIMITS_ACROSS);
    }
}

void clod_check_ring_warn(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_shear_cell cell = clod_shear_cell_of(subject->from);
    warn_specimen(&cell, r);
    warn_bars(&cell, r);
    warn_points(&cell, r);
    note_lid(subject, &cell, r);
}

void clod_check_jenike_warn(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_shear_cell cell = clod_shear_cell_of(subject->from);
    warn_specimen(&cell, r);
    warn_points(&cell, r);
    note_lid(subject, &cell, r);
}
