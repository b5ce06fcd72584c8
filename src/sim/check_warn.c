#include <math.h>
#include <stdarg.h>
#include <stdio.h>

#include "base/plural.h"
#include "config/grain_solid.h"
#include "parallel/threads.h"
#include "setup/grains.h"
#include "sim/check_testers.h"
#include "sim/outputs.h"
#include "sim/testers.h"
#include "tester/limits.h"

#define RAYLEIGH_LIMIT 0.2
#define RESTITUTION_MOST 1.01 ///< without a dash-pot 10 steps a collision return up to 1.012
#define SERVO_STEPS 20.0      ///< steps in one period of a loaded wall

void clod_check_warning(clod_check_report *report, const char *format, ...)
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

/** What brings the step below one that a bed bears; rounded down to three digits. */
static void say_lower(const clod_case_time *time, const clod_check_report *r, double good,
                      char text[64])
{
    const double part = 0.995 * good / r->step;
    if (r->step_given) {
        snprintf(text, 64, "time.step to %.3g s%s", part * r->step,
                 r->automatic < good ? ", or write auto" : "");
    } else if (r->rayleigh_imposed) {
        snprintf(text, 64, "time.rayleigh_limit to %.3g", part * time->rayleigh_limit);
    } else {
        snprintf(text, 64, "time.safety to %.3g", part * time->safety);
    }
}

/** A step that a bed may not bear (docs/theory/stability.md), or that is larger than auto. */
static void warn_bed(const clod_case *from, clod_check_report *r)
{
    const double good = CLOD_LIMITS_STABLE * r->stable;
    if (r->stable > 0.0 && r->step > good) {
        char lower[64];
        say_lower(&from->time, r, good, lower);
        clod_check_warning(
            r,
            "the step %.3g s is more than nine tenths of %.3g s, the largest stable one estimated for "
            "the bed%s: beyond it grains jitter and press each other, and nothing stops the run. "
            "Lower %s, unless results show that the bed bears it",
            r->step, r->stable, r->sheared ? " when sheared" : "", lower);
    } else if (r->step_given && r->step > 1.001 * r->automatic) {
        clod_check_warning(
            r,
            "time.step %.3g s is above the safe step %.3g s: grains with several contacts may "
            "gain energy. Use auto",
            r->step, r->automatic);
    }
    if (r->restitution_most > RESTITUTION_MOST) {
        clod_check_warning(
            r,
            "with %.2g steps a collision may return %.3g of its speed: grains gain energy. Lower the "
            "step",
            r->collision_steps, r->restitution_most);
    }
}

static void warn_step(const clod_case *from, clod_check_report *r)
{
    warn_bed(from, r);
    if (r->rayleigh_imposed && r->rayleigh_fraction > RAYLEIGH_LIMIT) {
        clod_check_warning(
            r,
            "the step is %.0f %% of the Rayleigh time: waves are not resolved. Stay below "
            "%.0f %%: lower time.rayleigh_limit or time.step",
            100.0 * r->rayleigh_fraction, 100.0 * RAYLEIGH_LIMIT);
    }
    if (r->servo_period > 0.0 && r->servo_period < SERVO_STEPS * r->step) {
        clod_check_warning(
            r,
            "a loaded wall oscillates on the bed with a period of %.3g s, %.1f steps: its "
            "servo may be unstable. Raise its mass or lower time.step",
            r->servo_period, r->servo_period / r->step);
    }
}

/** What makes contacts stiffer. */
static const char *stiffen(const clod_check_report *r)
{
    return r->soften > 1.0 ? "Lower contacts.soften" : "Raise the stiffness";
}

static void warn_contact(const clod_case *from, clod_check_report *r)
{
    const bool known = clod_case_tester(from) != NULL || from->time.design_stress > 0.0;
    if (r->overlap_ratio > from->time.overlap_limit) {
        clod_check_warning(
            r, "grains %s overlap by %.3g %% of their radius, and a run stops at %.3g %%. %s%s",
            known ? "will" : "may", 100.0 * r->overlap_ratio, 100.0 * from->time.overlap_limit,
            stiffen(r),
            r->overlap_ratio < CLOD_CASE_OVERLAP_MOST
                ? " or, if so deep contacts are meant, time.overlap_limit"
                : "");
    } else if (r->overlap_ratio > CLOD_LIMITS_OVERLAP_MEAN && known) {
        clod_check_warning(
            r,
            "grains overlap by %.2f %% of their radius at %.4g kPa: density and contacts are "
            "no longer those of spheres (below %.0f %% is good). %s",
            100.0 * r->overlap_ratio, 1e-3 * r->stress, 100.0 * CLOD_LIMITS_OVERLAP_MEAN,
            stiffen(r));
    } else if (r->overlap_ratio > CLOD_LIMITS_OVERLAP_MEAN) {
        clod_check_warning(
            r,
            "grains may overlap by %.2f %% of their radius: under weight and wall loads, or "
            "in a head-on collision at the highest speed of the case. Below %.0f %% density "
            "and contacts are those of spheres. %s if they do overlap so far",
            100.0 * r->overlap_ratio, 100.0 * CLOD_LIMITS_OVERLAP_MEAN, stiffen(r));
    }
}

static void warn_machine(const clod_check_subject *subject, clod_check_report *r)
{
    if (r->disk > r->disk_free) {
        clod_check_warning(
            r,
            "results may need %.3g GB, the disk has %.3g GB free: the run would stop. Raise "
            "output.snapshot_interval or output.series_interval, or use another folder (-o)",
            1e-9 * r->disk, 1e-9 * r->disk_free);
    }
    if (subject->options->threads > r->processors) {
        clod_check_warning(
            r, "%d threads on %d processor%s slow each other down: a run uses %d",
            subject->options->threads, r->processors, clod_plural(r->processors), r->threads);
    }
    const double grains = (double)r->grains * r->side_by_side;
    if (r->threads > 1 && grains / r->threads < CLOD_THREADS_GRAINS) {
        clod_check_warning(
            r,
            "less than %d grains for each thread: threads wait for each other. --threads %.0f "
            "is likely as fast",
            CLOD_THREADS_GRAINS, fmax(1.0, floor(grains / CLOD_THREADS_GRAINS)));
    }
}

/** Whole grains do not make up every mass. */
static void warn_mass(const clod_check_subject *subject, clod_check_report *r)
{
    char text[CLOD_CHECK_WARNING_TEXT];
    const clod_setup_bed bed = clod_setup_bed_of(&subject->state);
    if (r->sampled == 0 && clod_setup_grains_say_off(subject->from, &bed, text, sizeof text)) {
        clod_check_warning(r, "%s", text);
    }
}

/** What is not known of a case with too many grains to make them all. */
static void note_sample(const clod_case *from, clod_check_report *r)
{
    if (r->sampled > 0 && clod_setup_grains_coming(from) > 0) {
        clod_check_note(r,
                        "grains come during the run: the number is that of all that can be in "
                        "at once if none leaves, and cost and memory are as if they were in "
                        "from the start. Sizes and time step are those of %zu that stand for "
                        "them; the rate is that of a slow bed without walls. No step was tried",
                        r->sampled);
    } else if (r->sampled > 0) {
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
        clod_check_warning(r, "%s", text);
    }
}

/** A card that was calibrated with another solid, or in vain. */
static void warn_solid(const clod_case *from, clod_check_report *r)
{
    char text[CLOD_CHECK_WARNING_TEXT];
    if (clod_grain_solid_differs(from, text, sizeof text)) {
        clod_check_warning(r, "%s", text);
    }
    if (clod_grain_solid_missed(from, text, sizeof text)) {
        clod_check_warning(r, "%s", text);
    }
}

void clod_check_warn(const clod_check_subject *subject, clod_check_report *report)
{
    const clod_tester_row *tester = clod_testers_row(report->kind);
    warn_outputs(subject->from, report);
    warn_step(subject->from, report);
    warn_contact(subject->from, report);
    warn_solid(subject->from, report);
    clod_check_soften_warn(subject, report);
    if (tester->warn != NULL) {
        tester->warn(subject, report);
    }
    warn_mass(subject, report);
    clod_check_streams_warn(subject, report);
    clod_check_measures_warn(subject, report);
    warn_machine(subject, report);
    clod_check_ranks_warn(report);
    note_sample(subject->from, report);
}
