#include "report/free_warnings.h"

#include <stdbool.h>

#include "report/shear_rows.h"

static size_t put(FILE *out, const char *text)
{
    fprintf(out, "%s%c", text, '\0');
    return 1;
}

/** What waits at an inlet now and waited at most: its keys tell the unit. */
static bool find_backlog(const json_t *inlet, double *now, double *most, const char **unit)
{
    static const struct {
        const char *now, *most, *unit;
    } KEYS[] = {{"backlog_kg", "most_backlog_kg", "kg"},
                {"backlog_grains", "most_backlog_grains", "grains"}};
    for (size_t k = 0; k < sizeof KEYS / sizeof *KEYS; k++) {
        if (json_is_number(json_object_get(inlet, KEYS[k].now))) {
            *now = clod_shear_number(inlet, KEYS[k].now);
            *most = clod_shear_number(inlet, KEYS[k].most);
            *unit = KEYS[k].unit;
            return true;
        }
    }
    return false;
}

static size_t put_inlets(FILE *out, const json_t *summary)
{
    size_t count = 0;
    size_t k;
    const json_t *inlet;
    json_array_foreach(json_object_get(summary, "inlets"), k, inlet)
    {
        const json_t *since = json_object_get(inlet, "blocked_since_s");
        const json_int_t times =
            json_integer_value(json_object_get(inlet, "blocked_insertions"));
        double now, most;
        const char *unit;
        char text[256];
        if (times == 0 || !find_backlog(inlet, &now, &most, &unit)) {
            continue;
        }
        if (json_is_number(since)) {
            snprintf(text, sizeof text,
                     "Inlet %zu has been blocked since %.6g s: %.4g %s wait for a place.",
                     k + 1, json_number_value(since), now, unit);
        } else {
            snprintf(text, sizeof text,
                     "Inlet %zu was blocked for a time: up to %.4g %s waited for a place; %.4g "
                     "wait at the end.",
                     k + 1, most, unit, now);
        }
        count += put(out, text);
    }
    return count;
}

static size_t put_alarms(FILE *out, const json_t *summary)
{
    size_t count = 0;
    const char *name;
    json_t *gauge;
    json_object_foreach(json_object_get(summary, "gauges"), name, gauge)
    {
        const json_int_t alarms = json_integer_value(json_object_get(gauge, "alarms"));
        const json_t *first = json_object_get(gauge, "blocked_since_s");
        const json_t *last = json_object_get(gauge, "blocked_at_end_since_s");
        char from[64] = "", end[64] = "", text[512];
        if (alarms <= 0) {
            continue;
        }
        if (json_is_number(first)) {
            snprintf(from, sizeof from, "%s from %.6g s on", alarms > 1 ? ", the first" : "",
                     json_number_value(first));
        }
        if (json_is_number(last)) {
            snprintf(end, sizeof end, ", and is blocked at the end, since %.6g s",
                     json_number_value(last));
        } else if (json_is_true(json_object_get(gauge, "blocked_at_end"))) {
            snprintf(end, sizeof end, ", and is blocked at the end");
        }
        snprintf(text, sizeof text, "Gauge %.100s gave alarm of blocking %lld time%s%s%s.",
                 name, (long long)alarms, alarms > 1 ? "s" : "", from, end);
        count += put(out, text);
    }
    return count;
}

static size_t put_spillage(FILE *out, const json_t *summary)
{
    const json_t *balance = json_object_get(summary, "balance");
    const json_t *spilled = json_object_get(balance, "spillage");
    const json_int_t grains = json_integer_value(json_object_get(spilled, "grains"));
    const double mass = clod_shear_number(spilled, "mass_kg");
    const double came = clod_shear_number(json_object_get(balance, "in"), "mass_kg");
    char share[64] = "", text[256];
    if (grains <= 0) {
        return 0;
    }
    if (came > 0.0) {
        snprintf(share, sizeof share, ", %.2g %% of what came in", 100.0 * mass / came);
    }
    snprintf(text, sizeof text, "%lld grain%s spilled: %.4g kg%s.", (long long)grains,
             grains > 1 ? "s were" : " was", mass, share);
    return put(out, text);
}

size_t clod_free_warnings_put(FILE *out, const json_t *summary)
{
    return put_inlets(out, summary) + put_alarms(out, summary) + put_spillage(out, summary);
}
