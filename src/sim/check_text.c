#include <jansson.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "base/plural.h"
#include "sim/check.h"

/** Text that grows in the caller's buffer. */
typedef struct page {
    char *text;
    size_t used;
} page;

__attribute__((format(printf, 3, 4))) static void line(page *to, const char *name,
                                                       const char *format, ...)
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

/** A time on the clock in words, such as "2 h 05 min". */
static const char *clock_words(double seconds, char words[32])
{
    if (seconds < 90.0) {
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

static const char *byte_words(double bytes, char words[32])
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

static void write_grains(page *to, const clod_check_report *r)
{
    line(to, "grains", "%s%zu, radius %.4g .. %.4g mm, mean %.4g mm",
         r->sampled > 0 ? "about " : "", r->grains, 1e3 * r->radius_min, 1e3 * r->radius_max,
         1e3 * r->radius_mean);
    line(to, "", "mass %.4g kg, solid volume %.4g cm3", r->mass, 1e6 * r->solid_volume);
}

static void write_step(page *to, const clod_check_report *r)
{
    line(to, "time step", "%.4g s (%s)", r->step, r->step_given ? "given by the case" : "auto");
    if (r->step_given) {
        line(to, "", "auto would take %.4g s", r->automatic);
    }
    if (r->pair_wall) {
        line(to, "", "set by the %s between %s (radius %.4g mm) and %s (wall)", r->reason,
             r->pair_1, 1e3 * r->pair_radius_1, r->pair_2);
    } else {
        line(to, "", "set by the %s between %s (radius %.4g mm) and %s (radius %.4g mm)",
             r->reason, r->pair_1, 1e3 * r->pair_radius_1, r->pair_2, 1e3 * r->pair_radius_2);
    }
    line(to, "stiffest contact", "%.4g N/m on %.4g kg: critical step %.4g s", r->stiffness,
         r->spring_mass, r->critical);
    line(to, "collision",
         "of these two: %.3g steps; restitution %.4g to %.4g where the case asks for %.3g",
         r->collision_steps, r->restitution_least, r->restitution_most, r->restitution);
    if (r->rayleigh > 0.0) {
        line(to, "Rayleigh time", "%.4g s; the step is %.3g %% of it%s", r->rayleigh,
             100.0 * r->rayleigh_fraction,
             r->rayleigh_imposed ? ""
                                 : " (for comparison: the stiffness is given, E is not used)");
    }
    if (r->servo_period > 0.0) {
        line(to, "loaded wall",
             "oscillates on the bed with a period of about %.3g s, %.3g time steps",
             r->servo_period, r->servo_period / r->step);
    }
}

static bool is_shear(const clod_check_report *r)
{
    return r->kind == CLOD_CHECK_RING_SHEAR || r->kind == CLOD_CHECK_JENIKE;
}

/** A test of several parts, whose length is a guess. */
static bool is_test(const clod_check_report *r)
{
    return is_shear(r) || r->kind == CLOD_CHECK_UNIAXIAL;
}

static void write_contact(page *to, const clod_check_report *r)
{
    if (is_test(r)) {
        line(to, is_shear(r) ? "preshear stress" : "largest stress",
             "%.4g kPa: %.4g N on a contact", 1e-3 * r->stress, r->contact_force);
    } else {
        line(to, "largest load", "%.4g N on a contact, as under %.4g kPa", r->contact_force,
             1e-3 * r->stress);
    }
    line(to, "overlap", "%.4g um under this force, %.3g %% of the radius", 1e6 * r->overlap,
         100.0 * r->overlap_ratio);
    if (r->weight > 0.0) {
        line(to, "Bond number", "%.4g (largest pull %.4g N over a grain's weight)", r->bond,
             r->pull_off);
    }
}

static void write_shear(page *to, const clod_check_report *r)
{
    line(to, "inertial number",
         "%.3g if the specimen settles to %.3g mm, the height that fill_fraction aims at;",
         r->inertial_preshear, 1e3 * r->height_aimed);
    line(to, "", "%.3g at the filling height, %.3g mm; a cohesive bed ends between the two",
         r->inertial_loose, 1e3 * r->height_loose);
    line(to, "",
         "the lowest point, %.4g kPa, is sheared at %.3g mm/s: the same inertial number",
         1e-3 * r->lowest_stress, 1e3 * r->lowest_speed);
    if (r->kind == CLOD_CHECK_JENIKE) {
        line(to, "cell", "%.1f grain diameters wide, %.1f deep", r->across_width,
             r->across_depth);
        return;
    }
    line(to, "cell", "%.1f grain diameters wide, %.1f deep; bars %.2f high", r->across_width,
         r->across_depth, r->bar_diameters);
}

static void write_uniaxial(page *to, const clod_check_report *r)
{
    line(to, "inertial number",
         "%.3g at %.4g kPa, the lowest consolidation stress, and a height of %.3g mm;",
         r->inertial_lowest, 1e-3 * r->lowest_stress, 1e3 * r->height_aimed);
    line(to, "", "the filling height is %.3g mm; a cohesive bed ends between the two",
         1e3 * r->height_loose);
    line(to, "mould", "%.1f grain diameters wide, %.1f high", r->across_width, r->across_depth);
}

/** What was timed; nothing when that went wrong, which a note says. */
static void write_rate(page *to, const clod_check_report *r)
{
    char a[32], b[32];
    if (!(r->rate > 0.0)) {
        return;
    }
    line(to, "rate", "%.3g grain-steps/s with %d thread%s (%s, measured on %zu grains;",
         r->rate, r->threads, clod_plural(r->threads), r->simd, r->timed_grains);
    line(to, "", "the slowest of five measurements gave %.3g)", r->rate_slowest);
    if (r->threads > 1) {
        line(to, "", "%.3g with 1 thread", r->rate_one);
    }
    if (r->busy) {
        line(
            to, "",
            "other programs are running: one thread got %.0f %% of a processor. The rates hold "
            "for an idle machine;",
            100.0 * r->processor_share);
        if (r->threads > 1) {
            line(to, "",
                 "the gain of %d threads is partly assumed. While these programs run, threads "
                 "wait for each other: --threads 1 may be several times faster",
                 r->threads);
        } else {
            line(to, "", "while these programs run, it takes %.1f times as long",
                 1.0 / r->processor_share);
        }
    }
    if (is_test(r)) {
        line(to, "wall-clock", "likely %s, at most %s; up to %d part%s side by side",
             clock_words(r->clock_likely, a), clock_words(r->clock_most, b), r->side_by_side,
             clod_plural(r->side_by_side));
    } else {
        line(to, "wall-clock", "%s at most", clock_words(r->clock_most, a));
    }
    line(to, "memory", "%s", byte_words(r->memory, a));
}

static void write_cost(page *to, const clod_check_report *r)
{
    char a[32], b[32], c[32], d[32];
    if (is_test(r)) {
        line(to, "simulated time", "likely %.3g s, at most %.3g s, all parts together",
             r->time_likely, r->time_most);
        line(to, "steps", "likely %.3g, at most %.3g", r->steps_likely, r->steps_most);
    } else {
        line(to, "simulated time", "%.3g s at most, %.3g steps", r->time_most, r->steps_most);
    }
    write_rate(to, r);
    line(to, "disk", "%s: series %s, snapshots %s, checkpoints %s", byte_words(r->disk, a),
         byte_words(r->disk_series, b), byte_words(r->disk_snapshots, c),
         byte_words(r->disk_checkpoints, d));
    line(to, "", "%s free", byte_words(r->disk_free, a));
    line(to, "outputs", "%.0f rows and %.0f snapshots%s", r->rows_most, r->snapshots_most,
         is_test(r) ? " at most" : ", fewer when a stage ends early");
}

void clod_check_report_text(const clod_check_report *r, char text[CLOD_CHECK_TEXT])
{
    page to = {text, 0};
    text[0] = '\0';
    line(&to, "case", "%s", r->path != NULL ? r->path : "");
    if (r->title != NULL) {
        line(&to, "", "%s", r->title);
    }
    if (r->kind == CLOD_CHECK_CONTACT_BENCH) {
        line(&to, "contact bench", "nothing to estimate; clod contact runs it at once");
        return;
    }
    write_grains(&to, r);
    write_step(&to, r);
    write_contact(&to, r);
    if (is_shear(r)) {
        write_shear(&to, r);
    }
    if (r->kind == CLOD_CHECK_UNIAXIAL) {
        write_uniaxial(&to, r);
    }
    write_cost(&to, r);
    for (size_t w = 0; w < r->warning_count; w++) {
        line(&to, "WARNING", "%s", r->warning[w]);
    }
    if (r->warning_count == 0) {
        line(&to, "warnings", "none");
    }
    for (size_t n = 0; n < r->note_count; n++) {
        line(&to, "note", "%s", r->note[n]);
    }
}

/** A number of the report and its key. */
typedef struct entry {
    const char *key;
    size_t offset;
} entry;

#define REAL(key, field)                                                                       \
    {                                                                                          \
        key, offsetof(clod_check_report, field)                                                \
    }

static const entry REALS[] = {
    REAL("radius_min_m", radius_min),
    REAL("radius_mean_m", radius_mean),
    REAL("radius_max_m", radius_max),
    REAL("mass_kg", mass),
    REAL("solid_volume_m3", solid_volume),
    REAL("step_s", step),
    REAL("step_auto_s", automatic),
    REAL("step_critical_s", critical),
    REAL("stiffest_radius_1_m", pair_radius_1),
    REAL("stiffest_radius_2_m", pair_radius_2),
    REAL("stiffness_N_per_m", stiffness),
    REAL("spring_mass_kg", spring_mass),
    REAL("collision_steps", collision_steps),
    REAL("restitution", restitution),
    REAL("restitution_least", restitution_least),
    REAL("restitution_most", restitution_most),
    REAL("rayleigh_time_s", rayleigh),
    REAL("rayleigh_fraction", rayleigh_fraction),
    REAL("stress_Pa", stress),
    REAL("contact_force_N", contact_force),
    REAL("overlap_m", overlap),
    REAL("overlap_ratio", overlap_ratio),
    REAL("pull_off_N", pull_off),
    REAL("weight_N", weight),
    REAL("bond_number", bond),
    REAL("servo_period_s", servo_period),
    REAL("time_likely_s", time_likely),
    REAL("time_most_s", time_most),
    REAL("steps_likely", steps_likely),
    REAL("steps_most", steps_most),
    REAL("rate_one_thread_per_s", rate_one),
    REAL("rate_per_s", rate),
    REAL("rate_slowest_per_s", rate_slowest),
    REAL("processor_share", processor_share),
    REAL("wall_clock_likely_s", clock_likely),
    REAL("wall_clock_most_s", clock_most),
    REAL("memory_bytes", memory),
    REAL("rows_most", rows_most),
    REAL("snapshots_most", snapshots_most),
    REAL("disk_series_bytes", disk_series),
    REAL("disk_snapshots_bytes", disk_snapshots),
    REAL("disk_checkpoints_bytes", disk_checkpoints),
    REAL("disk_bytes", disk),
    REAL("disk_free_bytes", disk_free),
};

static const entry SHEAR_REALS[] = {
    REAL("inertial_number_preshear", inertial_preshear),
    REAL("inertial_number_loose", inertial_loose),
    REAL("inertial_number_lowest", inertial_lowest),
    REAL("height_aimed_m", height_aimed),
    REAL("height_loose_m", height_loose),
    REAL("lowest_stress_Pa", lowest_stress),
    REAL("lowest_speed_m_per_s", lowest_speed),
    REAL("diameters_across_width", across_width),
    REAL("diameters_across_depth", across_depth),
};

static const entry RING_REALS[] = {REAL("bar_height_diameters", bar_diameters)};

static const entry UNIAXIAL_REALS[] = {
    REAL("inertial_number_lowest", inertial_lowest),
    REAL("height_aimed_m", height_aimed),
    REAL("height_loose_m", height_loose),
    REAL("lowest_stress_Pa", lowest_stress),
    REAL("diameters_across_width", across_width),
    REAL("diameters_across_depth", across_depth),
};

static void put_reals(json_t *to, const clod_check_report *r, const entry *entries,
                      size_t count)
{
    for (size_t e = 0; e < count; e++) {
        double value;
        memcpy(&value, (const char *)r + entries[e].offset, sizeof value);
        json_object_set_new(to, entries[e].key,
                            isfinite(value) ? json_real(value) : json_null());
    }
}

static void put_text(json_t *to, const char *key, const char *text)
{
    json_object_set_new(to, key, text != NULL ? json_string(text) : json_null());
}

static void put_list(json_t *to, const char *key, const char (*texts)[CLOD_CHECK_WARNING_TEXT],
                     size_t count)
{
    json_t *list = json_array();
    for (size_t n = 0; n < count; n++) {
        json_array_append_new(list, json_string(texts[n]));
    }
    json_object_set_new(to, key, list);
}

static json_t *make_json(const clod_check_report *r)
{
    static const char *const KINDS[] = {"free_run", "ring_shear", "jenike", "uniaxial",
                                        "contact_bench"};
    json_t *to = json_object();
    put_text(to, "case", r->path);
    put_text(to, "title", r->title);
    put_text(to, "kind", KINDS[r->kind]);
    if (r->kind == CLOD_CHECK_CONTACT_BENCH) {
        return to;
    }
    json_object_set_new(to, "grains", json_integer((json_int_t)r->grains));
    json_object_set_new(to, "grains_sampled", json_integer((json_int_t)r->sampled));
    json_object_set_new(to, "step_given", json_boolean(r->step_given));
    put_text(to, "step_reason", r->reason);
    put_text(to, "stiffest_material_1", r->pair_1);
    put_text(to, "stiffest_material_2", r->pair_2);
    json_object_set_new(to, "stiffest_is_wall", json_boolean(r->pair_wall));
    json_object_set_new(to, "rayleigh_imposed", json_boolean(r->rayleigh_imposed));
    json_object_set_new(to, "machine_busy", json_boolean(r->busy));
    json_object_set_new(to, "processors", json_integer(r->processors));
    json_object_set_new(to, "threads", json_integer(r->threads));
    json_object_set_new(to, "parts_side_by_side", json_integer(r->side_by_side));
    put_text(to, "simd", r->simd);
    put_reals(to, r, REALS, sizeof REALS / sizeof REALS[0]);
    if (is_shear(r)) {
        put_reals(to, r, SHEAR_REALS, sizeof SHEAR_REALS / sizeof SHEAR_REALS[0]);
    }
    if (r->kind == CLOD_CHECK_RING_SHEAR) {
        put_reals(to, r, RING_REALS, sizeof RING_REALS / sizeof RING_REALS[0]);
    }
    if (r->kind == CLOD_CHECK_UNIAXIAL) {
        put_reals(to, r, UNIAXIAL_REALS, sizeof UNIAXIAL_REALS / sizeof UNIAXIAL_REALS[0]);
    }
    put_list(to, "warnings", r->warning, r->warning_count);
    put_list(to, "notes", r->note, r->note_count);
    return to;
}

bool clod_check_report_json(const clod_check_report *r, char text[CLOD_CHECK_TEXT])
{
    json_t *json = make_json(r);
    char *whole = clod_json_text(json, JSON_INDENT(2));
    json_decref(json);
    const size_t length = whole != NULL ? strlen(whole) : CLOD_CHECK_TEXT;
    const bool good = length < CLOD_CHECK_TEXT;
    memcpy(text, good ? whole : "", good ? length + 1 : 1);
    clod_memory_free(whole);
    return good;
}
