#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "sim/check.h"

#define INERTIAL_LIMIT 1.2e-3 ///< as in the result: quasi-static up to about 1e-3 (PHYSICS 5)
#define OVERLAP_LIMIT 0.01    ///< of a radius
#define RAYLEIGH_LIMIT 0.2
#define BAR_LIMIT 0.98      ///< grain diameters, as good as one
#define ACROSS_LIMIT 5.0    ///< grain diameters
#define SERVO_STEPS 20.0    ///< steps in one period of a loaded wall
#define THREAD_GRAINS 500.0 ///< grains below which a further thread does not pay
#define WEAK_STRESS 0.1     ///< points below this part of the preshear stress are unsafe

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

static void warn_step(clod_check_report *r)
{
    if (r->step > r->critical) {
        warn(r,
             "time.step %.3g s is beyond the critical step %.3g s of the stiffest contact: the "
             "run will blow up. Use auto (%.3g s)",
             r->step, r->critical, r->automatic);
    } else if (r->step > 1.001 * r->automatic) {
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
             "a loaded wall swings on the bed in %.3g s, that is %.1f steps: its servo may not "
             "be stable. Raise its mass or lower time.step",
             r->servo_period, r->servo_period / r->step);
    }
}

static void warn_contact(clod_check_report *r)
{
    if (r->overlap_ratio > OVERLAP_LIMIT) {
        warn(r,
             "grains overlap by %.2f %% of their radius at %.4g kPa: density and contacts are "
             "no longer those of spheres (below %.0f %% is good). Raise the stiffness",
             100.0 * r->overlap_ratio, 1e-3 * r->stress, 100.0 * OVERLAP_LIMIT);
    }
}

static void warn_ring(const clod_case_ring_shear *ring, clod_check_report *r)
{
    const double worst = fmax(r->inertial_preshear, r->inertial_lowest);
    if (worst > INERTIAL_LIMIT) {
        warn(r,
             "inertial number %.3g: the grains' inertia adds to the shear stress (1e-3 is "
             "quasi-static). Lower ring_shear.speed to %.2g mm/s",
             worst, 1e3 * ring->speed * 1e-3 / worst);
    }
    const double across = fmin(r->across_width, r->across_depth);
    if (across < ACROSS_LIMIT) {
        warn(r,
             "only %.1f grain diameters across the %s of the specimen (at least %.0f): walls, "
             "not the solid, set the strength. Use a larger cell or smaller grains",
             across, r->across_width < r->across_depth ? "width" : "depth", ACROSS_LIMIT);
    }
    if (ring->bar_count == 0) {
        warn(r, "ring_shear.bar_count is 0: lid and base grip by friction alone and the solid "
                "may slip along them");
    } else if (r->bar_diameters < BAR_LIMIT) {
        warn(r,
             "the bars are %.2f grain diameters high: grains slip over them. Raise "
             "ring_shear.bar_height to %.3g mm",
             r->bar_diameters, 2e3 * r->radius_mean);
    }
    if (r->lowest_stress < WEAK_STRESS * ring->preshear_stress) {
        warn(r,
             "the lowest shear point is %.1f %% of the preshear stress: it is hard to hold and "
             "bends the yield locus. 20 to 80 %% is usual",
             100.0 * r->lowest_stress / ring->preshear_stress);
    }
    if (ring->shear_stress_count < 3) {
        warn(r,
             "%zu shear points: a line needs three or more to show its error; add some to "
             "ring_shear.shear_stresses",
             ring->shear_stress_count);
    }
}

static void warn_lid(const clod_check_subject *subject, clod_check_report *r)
{
    const clod_case_ring_shear *ring = &subject->from->ring_shear;
    const double area = M_PI * (ring->outer_radius * ring->outer_radius -
                                ring->inner_radius * ring->inner_radius);
    const double weight = -ring->lid_mass * subject->from->gravity[2] / area;
    if (weight > r->lowest_stress) {
        warn(r,
             "the lid alone weighs %.3g kPa, more than the lowest shear point, %.3g kPa: its "
             "servo cannot lift it. Lower ring_shear.lid_mass",
             1e-3 * weight, 1e-3 * r->lowest_stress);
    }
}

static void warn_machine(clod_check_report *r)
{
    if (r->disk > r->disk_free) {
        warn(r,
             "results may need %.3g GB, the disk has %.3g GB free: the run would stop. Raise "
             "output.snapshot_interval or output.series_interval, or use another folder (-o)",
             1e-9 * r->disk, 1e-9 * r->disk_free);
    }
    if (r->threads > r->processors) {
        warn(r, "%d threads on %d processors slow each other down. Use --threads %d",
             r->threads, r->processors, r->processors);
    }
    if (r->rate < r->rate_one) {
        warn(
            r,
            "%d threads were slower than one when measured: the machine is busy, or the grains "
            "are too few. Run when it is quiet, or use --threads 1",
            r->threads);
    }
    const double each = (double)r->grains * r->side_by_side / r->threads;
    if (r->threads > 1 && each < THREAD_GRAINS) {
        warn(r,
             "%.0f grains for each thread: threads wait for each other. --threads %.0f is "
             "likely as fast",
             each, fmax(1.0, floor((double)r->grains * r->side_by_side / THREAD_GRAINS)));
    }
}

void clod_check_warn(const clod_check_subject *subject, clod_check_report *report)
{
    warn_step(report);
    warn_contact(report);
    if (report->kind == CLOD_CHECK_RING_SHEAR) {
        warn_ring(&subject->from->ring_shear, report);
        warn_lid(subject, report);
    }
    warn_machine(report);
}
