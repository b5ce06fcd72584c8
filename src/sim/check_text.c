#include <stdarg.h>
#include <stdio.h>

#include "base/given.h"
#include "base/plural.h"
#include "sim/check_testers.h"
#include "sim/testers.h"

void clod_check_line(clod_check_page *to, const char *name, const char *format, ...)
{
    va_list args;
    char words[1024];
    va_start(args, format);
    vsnprintf(words, sizeof words, format, args);
    va_end(args);
    const size_t room = CLOD_CHECK_TEXT - to->used;
    const int length = snprintf(to->text + to->used, room, "%-18s %s\n", name, words);
    to->used += length > 0 && (size_t)length < room ? (size_t)length : 0;
}

#define YEAR 31557600.0 ///< s

const char *clod_check_clock_words(double seconds, char words[32])
{
    if (seconds < 600.0) {
        snprintf(words, 32, "%.0f s", seconds);
    } else if (seconds < 5400.0) {
        snprintf(words, 32, "%.0f min", seconds / 60.0);
    } else if (seconds < 2.0 * 86400.0) {
        const int minutes = (int)(seconds / 60.0);
        snprintf(words, 32, "%d h %02d min", minutes / 60, minutes % 60);
    } else if (seconds < 2.0 * YEAR) {
        snprintf(words, 32, "%.1f days", seconds / 86400.0);
    } else {
        snprintf(words, 32, "%.3g years", seconds / YEAR);
    }
    return words;
}

const char *clod_check_byte_words(double bytes, char words[32])
{
    static const char *const UNITS[] = {"B", "kB", "MB", "GB", "TB"};
    int unit = 0;
    while (bytes >= 999.5 && unit < 4) {
        bytes /= 1000.0;
        unit++;
    }
    snprintf(words, 32, "%.3g %s", bytes, UNITS[unit]);
    return words;
}

static void write_grains(clod_check_page *to, const clod_check_report *r)
{
    clod_check_line(to, "grains", "%s%zu, radius %.4g .. %.4g mm, mean %.4g mm",
                    r->sampled > 0 ? "about " : "", r->grains, 1e3 * r->radius_min,
                    1e3 * r->radius_max, 1e3 * r->radius_mean);
    clod_check_line(to, "", "mass %.4g kg, solid volume %.4g cm3", r->mass,
                    1e6 * r->solid_volume);
}

static void write_step(clod_check_page *to, const clod_check_report *r)
{
    clod_check_line(to, "time step", "%.4g s (%s)", r->step,
                    r->step_given ? "given by the case" : "auto");
    if (r->step_given) {
        clod_check_line(to, "", "auto would take %.4g s", r->automatic);
    }
    if (r->pair_wall) {
        clod_check_line(to, "", "set by the %s between %s (radius %.4g mm) and %s (wall)",
                        r->reason, r->pair_1, 1e3 * r->pair_radius_1, r->pair_2);
    } else {
        clod_check_line(
            to, "", "set by the %s between %s (radius %.4g mm) and %s (radius %.4g mm)",
            r->reason, r->pair_1, 1e3 * r->pair_radius_1, r->pair_2, 1e3 * r->pair_radius_2);
    }
    clod_check_line(to, "stiffest contact", "%.4g N/m on %.4g kg: critical step %.4g s",
                    r->stiffness, r->spring_mass, r->critical);
    if (r->stable > 0.0) {
        clod_check_line(
            to, "stable step",
            "some %.3g s by an estimate for the bed %s; beds that were measured bore 0.9 to 4 times theirs, and the",
            r->stable, r->sheared ? "when sheared" : "under its mean load");
        clod_check_line(to, "", "results have the measured one");
    }
    clod_check_line(
        to, "collision",
        "of these two: %.3g steps; restitution %.4g to %.4g where the case asks for %.3g",
        r->collision_steps, r->restitution_least, r->restitution_most, r->restitution);
    if (r->rayleigh > 0.0) {
        clod_check_line(
            to, "Rayleigh time", "%.4g s%s; the step is %.3g %% of it%s", r->rayleigh,
            r->soften > 1.0 ? " with softened E" : "", 100.0 * r->rayleigh_fraction,
            r->rayleigh_imposed ? ""
                                : " (for comparison: the stiffness is given, E is not used)");
    }
    if (r->servo_period > 0.0) {
        clod_check_line(to, "loaded wall",
                        "oscillates on the bed with a period of about %.3g s, %.3g time steps",
                        r->servo_period, r->servo_period / r->step);
    }
}

/** A test of several parts, whose length is a guess. */
static bool is_test(const clod_check_report *r)
{
    return clod_testers_row(r->kind)->write != NULL;
}

static void write_contact(clod_check_page *to, const clod_check_report *r)
{
    if (is_test(r)) {
        clod_check_line(to, clod_testers_row(r->kind)->stress, "%.4g kPa: %.4g N on a contact",
                        1e-3 * r->stress, r->contact_force);
    } else {
        clod_check_line(to, "largest load", "%.4g N on a contact, as under %.4g kPa",
                        r->contact_force, 1e-3 * r->stress);
    }
    clod_check_line(to, "overlap", "%.4g um under this force, %.3g %% of the radius",
                    1e6 * r->overlap, 100.0 * r->overlap_ratio);
    if (r->weight > 0.0) {
        clod_check_line(to, "Bond number", "%.4g (largest pull %.4g N over a grain's weight)",
                        r->bond, r->pull_off);
    }
}

/** Of fields, where there are any. */
static void write_fields(clod_check_page *to, const clod_check_report *r)
{
    char a[32], b[32];
    if (r->fields_memory > 0.0) {
        clod_check_line(to, "", "fields take %s of it at most, on one thread, and %s",
                        clod_check_clock_words(r->fields_clock, a),
                        clod_check_byte_words(r->fields_memory, b));
    }
}

/** What was timed; nothing when that went wrong, which a note says. */
static void write_rate(clod_check_page *to, const clod_check_report *r)
{
    char a[32], b[32];
    if (!(r->rate > 0.0)) {
        return;
    }
    clod_check_line(to, "rate",
                    "%.3g grain-steps/s with %d thread%s (%s, measured on %zu grains;", r->rate,
                    r->threads, clod_plural(r->threads), r->simd, r->timed_grains);
    clod_check_line(to, "", "the slowest of five measurements gave %.3g)", r->rate_slowest);
    if (r->threads > 1) {
        clod_check_line(to, "", "%.3g with 1 thread", r->rate_one);
    }
    if (r->busy) {
        clod_check_line(
            to, "",
            "other programs are running: one thread got %.0f %% of a processor. The rates hold "
            "for an idle machine;",
            100.0 * r->processor_share);
        if (r->threads > 1) {
            clod_check_line(
                to, "",
                "the gain of %d threads is partly assumed. While these programs run, threads "
                "wait for each other: --threads 1 may be several times faster",
                r->threads);
        } else {
            clod_check_line(to, "", "while these programs run, it takes %.1f times as long",
                            1.0 / r->processor_share);
        }
    }
    if (is_test(r)) {
        clod_check_line(to, "wall-clock", "likely %s, at most %s; up to %d part%s side by side",
                        clod_check_clock_words(r->clock_likely, a),
                        clod_check_clock_words(r->clock_most, b), r->side_by_side,
                        clod_plural(r->side_by_side));
    } else if (r->clock_most > r->clock_likely) {
        clod_check_line(to, "wall-clock", "%s at this rate, at most %s in a dense fast stream",
                        clod_check_clock_words(r->clock_likely, a),
                        clod_check_clock_words(r->clock_most, b));
    } else {
        clod_check_line(to, "wall-clock", "%s at most, at this rate",
                        clod_check_clock_words(r->clock_most, a));
    }
    clod_check_line(to, "memory", "%s", clod_check_byte_words(r->memory, a));
    if (r->facets > 0) {
        clod_check_line(to, "", "walls have %zu facets in %zu pieces of smooth surface: %s",
                        r->facets, r->patches, clod_check_byte_words(r->memory_facets, a));
    }
    write_fields(to, r);
}

static void write_cost(clod_check_page *to, const clod_check_report *r)
{
    char a[32], b[32], c[32], d[32];
    if (is_test(r)) {
        clod_check_line(to, "simulated time",
                        "likely %.3g s, at most %.3g s, all parts together", r->time_likely,
                        r->time_most);
        clod_check_line(to, "steps", "likely %.3g, at most %.3g", r->steps_likely,
                        r->steps_most);
    } else {
        clod_check_line(to, "simulated time", "%.3g s at most, %.3g steps", r->time_most,
                        r->steps_most);
    }
    write_rate(to, r);
    clod_check_ranks_write(to, r);
    clod_check_line(to, "disk", "%s: series %s, snapshots %s, checkpoints %s",
                    clod_check_byte_words(r->disk, a), clod_check_byte_words(r->disk_series, b),
                    clod_check_byte_words(r->disk_snapshots, c),
                    clod_check_byte_words(r->disk_checkpoints, d));
    clod_check_line(to, "", "%s free", clod_check_byte_words(r->disk_free, a));
    clod_check_line(to, "outputs", "%.0f rows and %.0f snapshots%s", r->rows_most,
                    r->snapshots_most,
                    is_test(r) ? " at most" : ", fewer when a stage ends early");
}

void clod_check_report_text(const clod_check_report *report, char text[CLOD_CHECK_TEXT])
{
    CLOD_NEED(report);
    CLOD_NEED(text);
    clod_check_page to = {text, 0};
    text[0] = '\0';
    clod_check_line(&to, "case", "%s", report->path != NULL ? report->path : "");
    if (report->title != NULL) {
        clod_check_line(&to, "", "%s", report->title);
    }
    if (clod_testers_row(report->kind)->run == NULL) {
        clod_check_line(&to, "contact bench",
                        "nothing to estimate; clod contact runs it at once");
        return;
    }
    write_grains(&to, report);
    write_step(&to, report);
    write_contact(&to, report);
    clod_check_soften_write(&to, report);
    if (is_test(report)) {
        clod_testers_row(report->kind)->write(&to, report);
    }
    write_cost(&to, report);
    for (size_t w = 0; w < report->warning_count; w++) {
        clod_check_line(&to, "WARNING", "%s", report->warning[w]);
    }
    if (report->warning_count == 0) {
        clod_check_line(&to, "warnings", "none");
    }
    for (size_t n = 0; n < report->note_count; n++) {
        clod_check_line(&to, "note", "%s", report->note[n]);
    }
}
