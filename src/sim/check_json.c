#include <jansson.h>
#include <math.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "sim/check.h"

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

static void put_shear(json_t *to, const clod_check_report *r)
{
    put_reals(to, r, SHEAR_REALS, sizeof SHEAR_REALS / sizeof SHEAR_REALS[0]);
}

static void put_ring(json_t *to, const clod_check_report *r)
{
    put_shear(to, r);
    put_reals(to, r, RING_REALS, sizeof RING_REALS / sizeof RING_REALS[0]);
}

static void put_uniaxial(json_t *to, const clod_check_report *r)
{
    put_reals(to, r, UNIAXIAL_REALS, sizeof UNIAXIAL_REALS / sizeof UNIAXIAL_REALS[0]);
}

/** Name of each kind, and what it alone has; NULL: nothing. */
static const struct {
    const char *name;
    void (*put)(json_t *to, const clod_check_report *r);
} KIND[] = {
    [CLOD_CASE_FREE] = {"free_run", NULL},
    [CLOD_CASE_RING_SHEAR] = {"ring_shear", put_ring},
    [CLOD_CASE_JENIKE] = {"jenike", put_shear},
    [CLOD_CASE_UNIAXIAL] = {"uniaxial", put_uniaxial},
    [CLOD_CASE_CONTACT_BENCH] = {"contact_bench", NULL},
};

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
    json_t *to = json_object();
    put_text(to, "case", r->path);
    put_text(to, "title", r->title);
    put_text(to, "kind", KIND[r->kind].name);
    if (r->kind == CLOD_CASE_CONTACT_BENCH) {
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
    if (KIND[r->kind].put != NULL) {
        KIND[r->kind].put(to, r);
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
