#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "base/plural.h"
#include "parallel/threads.h"
#include "setup/grains.h"
#include "sim/check.h"
#include "sim/outputs.h"
#include "sim/shear_cell.h"
#include "tester/limits.h"

#define RAYLEIGH_LIMIT 0.2
#define BAR_LIMIT 0.98 ///< grain diameters, as good as one
#define FEW_GRAINS 0.6 ///< of those that fill the depth
#define MANY_GRAINS 1.4
#define SERVO_STEPS 20.0 ///< steps in one period of a loaded wall
#define WEAK_STRESS 0.1  ///< points below this part of the preshear stress are unsafe

__attribute__((format(printf, 2, 3))) static void warn(clod_check_report *report,
                                                       const char *format, ...)
{
    if (report->warning_count < CLOD_CHECK_WARNINGS) {
        va_list args;
        va_start(args, format);
        vsnprintf(report->warning[report->warning_count++], CLOD_CHECK_WARNING_TEXT, format,
                  args);
        va_end(args);
    }
}

void clod_check_note(clod_check_report *report, const char *format, ...)
{
    if (report->note_count < CLOD_CHECK_NOTES) {
        va_list args;
        va_start(args, format);
        vsnprintf(report->note[report->note_count++], CLOD_CHECK_WARNING_TEXT, format, args);
        va_end(args);
    }
}

static void warn_step(clod_check_report *r)
{
    if (r->step > 1.001 * r->automatic) {
        warn(r,
             "time.step %.3g s is above the safe step %.3g s: grains with several contacts may "
             "gain energy. Use auto",
             r->step, r->automatic);
    }
    if (r->rayleigh_imposed && r->rayleigh_fraction > RAYLEIGH_LIMIT) {
        warn(r,
             "the step is %.0f %% of the Rayleigh time: waves are not resolved. Stay below "
             "%.0f %%: lower time.rayleigh_limit or time.step",
             100.0 * r->rayleigh_fraction, 100.0 * RAYLEIGH_LIMIT);
    }
    if (r->servo_period > 0.0 && r->servo_period < SERVO_STEPS * r->step) {
        warn(r,
             "a loaded wall oscillates on the bed with a period of %.3g s, %.1f steps: its "
             "servo may be unstable. Raise its mass or lower time.step",
             r->servo_period, r->servo_period / r->step);
    }
}

static void warn_contact(const clod_case *from, clod_check_report *r)
{
    const bool known = clod_case_tester(from) != NULL || from->time.design_stress > 0.0;
    if (r->overlap_ratio > from->time.overlap_limit) {
        warn(r,
             "grains %s overlap by %.3g %% of their radius, and a run stops at %.3g %%. Raise "
             "the stiffness%s",
             known ? "will" : "may", 100.0 * r->overlap_ratio, 100.0 * from->time.overlap_limit,
             r->overlap_ratio < CLOD_CASE_OVERLAP_MOST
                 ? " or, if so deep contacts are meant, time.overlap_limit"
                 : "");
    } else if (r->overlap_ratio > CLOD_LIMITS_OVERLAP_MEAN && known) {
        warn(r,
             "grains overlap by %.2f %% of their radius at %.4g kPa: density and contacts are "
             "no longer those of spheres (below %.0f %% is good). Raise the stiffness",
             100.0 * r->overlap_ratio, 1e-3 * r->stress, 100.0 * CLOD_LIMITS_OVERLAP_MEAN);
    } else if (r->overlap_ratio > CLOD_LIMITS_OVERLAP_MEAN) {
        warn(r,
             "grains may overlap by %.2f %% of their radius: under weight and wall loads, or "
             "in a head-on collision at the highest speed of the case. Below %.0f %% density "
             "and contacts are those of spheres. If they do overlap so far, raise the "
             "stiffness",
             100.0 * r->overlap_ratio, 100.0 * CLOD_LIMITS_OVERLAP_MEAN);
    }
}

/** A dry bed settles to about the height aimed at; a cohesive one stays looser and higher. */
static void warn_inertia(const clod_shear_cell *cell, clod_check_report *r)
{
    const double speed = cell->programme->speed;
    const bool cohesive = r->pull_off > 0.0;
    const double number = cohesive ? r->inertial_loose : r->inertial_preshear;
    if (number > CLOD_LIMITS_INERTIA) {
        warn(r,
             "inertial number %.3g%s: the grains' inertia adds to the shear stress (%.2g is "
             "quasi-static). Lower %s.speed to %.2g mm/s",
             number, cohesive ? " even at the filling height" : "", CLOD_LIMITS_INERTIA_GOOD,
             cell->key, 1e3 * speed * CLOD_LIMITS_INERTIA_GOOD / number);
    } else if (r->inertial_preshear > CLOD_LIMITS_INERTIA) {
        const double height = // the number goes with 1/height
            r->height_aimed * r->inertial_preshear / CLOD_LIMITS_INERTIA;
        clod_check_note(
            r,
            "%.3g mm/s may be too fast if the bed settles below %.3g mm (inertial number above "
            "%.2g): the results state the height and warn if so. %.2g mm/s is slow enough at "
            "any height",
            1e3 * speed, 1e3 * height, CLOD_LIMITS_INERTIA,
            1e3 * speed * CLOD_LIMITS_INERTIA_GOOD / r->inertial_preshear);
    }
}

static void warn_count(const clod_shear_cell *cell, clod_check_report *r)
{
    const double part = (double)r->grains / (double)r->full_grains;
    if (part < FEW_GRAINS || part > MANY_GRAINS) {
        warn(r,
             "%zu grain%s %.0f %% of those that fill the depth (%zu): the specimen will be "
             "some %.3g mm high, not %.3g mm. Change %s.grain_count, or write auto",
             r->grains, r->grains == 1 ? " is" : "s are", 100.0 * part, r->full_grains,
             1e3 * r->height_aimed, 1e3 * cell->height, cell->key);
    }
}

/** What a ring has to grip the solid with. */
static void warn_bars(const clod_case_ring_shear *ring, clod_check_report *r)
{
    if (ring->bar_count == 0) {
        warn(r, "ring_shear.bar_count is 0: lid and base grip by friction alone and the solid "
                "may slip along them. Raise it: 20 is usual");
    } else if (r->bar_diameters < BAR_LIMIT) {
        warn(r,
             "the bars are %.2f grain diameters high: grains slip over them. Raise "
             "ring_shear.bar_height to %.3g mm",
             r->bar_diameters, 2e3 * r->radius_mean);
    }
}

static void warn_points(const clod_shear_cell *cell, clod_check_report *r)
{
    const clod_case_programme *shear = cell->programme;
    if (r->lowest_stress < WEAK_STRESS * shear->preshear_stress) {
        warn(
            r,
            "the lowest shear point is %.1f %% of the preshear stress: so low a stress is hard "
            "to hold and bends the yield locus. 20 to 80 %% is usual: raise or remove it in "
            "%s.shear_stresses",
            100.0 * r->lowest_stress / shear->preshear_stress, cell->key);
    }
    if (shear->shear_stress_count < 3) {
        warn(r,
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
    if (across < CLOD_LIMITS_GRAINS) {
        warn(r,
             "only %.1f grain diameters across the %s of the specimen (at least %.0f): walls, "
             "not the solid, set the strength. Use a larger cell or smaller grains",
             across, r->across_width < r->across_depth ? "width" : "depth", CLOD_LIMITS_GRAINS);
    }
}

static void warn_ring(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_shear_cell cell = clod_shear_cell_of(subject->from);
    warn_specimen(&cell, r);
    warn_bars(&subject->from->ring_shear, r);
    warn_points(&cell, r);
    note_lid(subject, &cell, r);
}

static void warn_jenike(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_shear_cell cell = clod_shear_cell_of(subject->from);
    warn_specimen(&cell, r);
    warn_points(&cell, r);
    note_lid(subject, &cell, r);
}

static void warn_uniaxial(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case_uniaxial *test = &subject->from->uniaxial;
    if (r->inertial_lowest > CLOD_LIMITS_INERTIA) {
        warn(r,
             "inertial number %.3g at %.4g kPa: the grains' inertia adds to the strength (%.2g "
             "is quasi-static). Lower uniaxial.speed to %.2g mm/s",
             r->inertial_lowest, 1e-3 * r->lowest_stress, CLOD_LIMITS_INERTIA_GOOD,
             1e3 * test->speed * CLOD_LIMITS_INERTIA_GOOD / r->inertial_lowest);
    }
    if (r->across_width < CLOD_LIMITS_FREE_GRAINS) {
        warn(r,
             "only %.1f grain diameters across the specimen (at least %.0f): single grains set "
             "its strength. Use a larger mould or smaller grains",
             r->across_width, CLOD_LIMITS_FREE_GRAINS);
    }
}

static void warn_machine(const clod_check_subject *subject, clod_check_report *r)
{
    if (r->disk > r->disk_free) {
        warn(r,
             "results may need %.3g GB, the disk has %.3g GB free: the run would stop. Raise "
             "output.snapshot_interval or output.series_interval, or use another folder (-o)",
             1e-9 * r->disk, 1e-9 * r->disk_free);
    }
    if (subject->options->threads > r->processors) {
        warn(r, "%d threads on %d processor%s slow each other down: a run uses %d",
             subject->options->threads, r->processors, clod_plural(r->processors), r->threads);
    }
    const double grains = (double)r->grains * r->side_by_side;
    if (r->threads > 1 && grains / r->threads < CLOD_THREADS_GRAINS) {
        warn(r,
             "less than %d grains for each thread: threads wait for each other. --threads %.0f "
             "is likely as fast",
             CLOD_THREADS_GRAINS, fmax(1.0, floor(grains / CLOD_THREADS_GRAINS)));
    }
}

/** Whole grains do not make up every mass. */
static void warn_mass(const clod_check_subject *subject, clod_check_report *r)
{
    char text[CLOD_CHECK_WARNING_TEXT];
    if (r->sampled == 0 &&
        clod_setup_grains_say_off(subject->from, &subject->state.grains, text, sizeof text)) {
        warn(r, "%s", text);
    }
}

/** What is not known of a case with too many grains to make them all. */
static void note_sample(clod_check_report *r)
{
    if (r->sampled > 0) {
        clod_check_note(r,
                        "%zu grains are too many to insert for an estimate: sizes and time "
                        "step are those of %zu of them, and no step was tried. Only the run "
                        "will show whether all of them fit",
                        r->grains, r->sampled);
    }
}

static void warn_outputs(const clod_case *from, clod_check_report *r)
{
    char text[CLOD_CHECK_WARNING_TEXT];
    if (clod_outputs_say_short(from, r->step, text, sizeof text)) {
        warn(r, "%s", text);
    }
}

/** What may go wrong with each kind of case alone; NULL: nothing. */
static void (*const WARN[CLOD_CASE_KINDS])(const clod_check_subject *subject,
                                           clod_check_report *r) = {
    [CLOD_CASE_RING_SHEAR] = warn_ring,
    [CLOD_CASE_JENIKE] = warn_jenike,
    [CLOD_CASE_UNIAXIAL] = warn_uniaxial,
};

void clod_check_warn(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_case_kind kind = clod_case_kind_of(subject->from);
    warn_outputs(subject->from, report);
    warn_step(report);
    warn_contact(subject->from, report);
    if (WARN[kind] != NULL) {
        WARN[kind](subject, report);
    }
    warn_mass(subject, report);
    warn_machine(subject, report);
    note_sample(report);
}
