#include <jansson.h>
#include <math.h>
#include <string.h>

#include "base/given.h"
#include "base/json.h"
#include "base/memory.h"
#include "config/testers.h"
#include "sim/check_testers.h"
#include "sim/testers.h"

static const clod_check_real REALS[] = {
    CLOD_CHECK_REAL("radius_min_m", radius_min),
    CLOD_CHECK_REAL("radius_mean_m", radius_mean),
    CLOD_CHECK_REAL("radius_max_m", radius_max),
    CLOD_CHECK_REAL("mass_kg", mass),
    CLOD_CHECK_REAL("solid_volume_m3", solid_volume),
    CLOD_CHECK_REAL("step_s", step),
    CLOD_CHECK_REAL("step_auto_s", automatic),
    CLOD_CHECK_REAL("step_critical_s", critical),
    CLOD_CHECK_REAL("stable_step_estimate_s", stable),
    CLOD_CHECK_REAL("stiffest_radius_1_m", pair_radius_1),
    CLOD_CHECK_REAL("stiffest_radius_2_m", pair_radius_2),
    CLOD_CHECK_REAL("stiffness_N_per_m", stiffness),
    CLOD_CHECK_REAL("spring_mass_kg", spring_mass),
    CLOD_CHECK_REAL("collision_steps", collision_steps),
    CLOD_CHECK_REAL("restitution", restitution),
    CLOD_CHECK_REAL("restitution_least", restitution_least),
    CLOD_CHECK_REAL("restitution_most", restitution_most),
    CLOD_CHECK_REAL("rayleigh_time_s", rayleigh),
    CLOD_CHECK_REAL("rayleigh_fraction", rayleigh_fraction),
    CLOD_CHECK_REAL("stress_Pa", stress),
    CLOD_CHECK_REAL("contact_force_N", contact_force),
    CLOD_CHECK_REAL("overlap_m", overlap),
    CLOD_CHECK_REAL("overlap_ratio", overlap_ratio),
    CLOD_CHECK_REAL("pull_off_N", pull_off),
    CLOD_CHECK_REAL("weight_N", weight),
    CLOD_CHECK_REAL("bond_number", bond),
    CLOD_CHECK_REAL("servo_period_s", servo_period),
    CLOD_CHECK_REAL("time_likely_s", time_likely),
    CLOD_CHECK_REAL("time_most_s", time_most),
    CLOD_CHECK_REAL("steps_likely", steps_likely),
    CLOD_CHECK_REAL("steps_most", steps_most),
    CLOD_CHECK_REAL("rate_one_thread_per_s", rate_one),
    CLOD_CHECK_REAL("rate_per_s", rate),
    CLOD_CHECK_REAL("rate_slowest_per_s", rate_slowest),
    CLOD_CHECK_REAL("processor_share", processor_share),
    CLOD_CHECK_REAL("wall_clock_likely_s", clock_likely),
    CLOD_CHECK_REAL("wall_clock_most_s", clock_most),
    CLOD_CHECK_REAL("memory_bytes", memory),
    CLOD_CHECK_REAL("memory_facets_bytes", memory_facets),
    CLOD_CHECK_REAL("fields_clock_s", fields_clock),
    CLOD_CHECK_REAL("fields_memory_bytes", fields_memory),
    CLOD_CHECK_REAL("rows_most", rows_most),
    CLOD_CHECK_REAL("snapshots_most", snapshots_most),
    CLOD_CHECK_REAL("disk_series_bytes", disk_series),
    CLOD_CHECK_REAL("disk_snapshots_bytes", disk_snapshots),
    CLOD_CHECK_REAL("disk_checkpoints_bytes", disk_checkpoints),
    CLOD_CHECK_REAL("disk_bytes", disk),
    CLOD_CHECK_REAL("disk_free_bytes", disk_free),
};

void clod_check_put(json_t *to, const clod_check_report *r, const clod_check_real *entries,
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
    const char *key = CLOD_CONFIG_TESTER[r->kind].key;
    const clod_tester_row *tester = clod_testers_row(r->kind);
    json_t *to = json_object();
    put_text(to, "case", r->path);
    put_text(to, "title", r->title);
    put_text(to, "kind", key != NULL ? key : "free_run");
    if (tester->run == NULL) {
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
    clod_check_put(to, r, REALS, sizeof REALS / sizeof REALS[0]);
    clod_check_soften_put(to, r);
    if (tester->put != NULL) {
        tester->put(to, r);
    }
    clod_check_ranks_put(to, r);
    put_list(to, "warnings", r->warning, r->warning_count);
    put_list(to, "notes", r->note, r->note_count);
    return to;
}

bool clod_check_report_json(const clod_check_report *report, char text[CLOD_CHECK_TEXT])
{
    CLOD_NEED(report);
    CLOD_NEED(text);
    json_t *json = make_json(report);
    char *whole = clod_json_text(json, JSON_INDENT(2));
    json_decref(json);
    const size_t length = whole != NULL ? strlen(whole) : CLOD_CHECK_TEXT;
    const bool good = length < CLOD_CHECK_TEXT;
    memcpy(text, good ? whole : "", good ? length + 1 : 1);
    clod_memory_free(whole);
    return good;
}
