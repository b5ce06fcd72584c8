// What gauges report at the end: lines of the report, and their object in the summary.

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "analysis/prose.h"
#include "base/json.h"
#include "base/plural.h"
#include "sim/gauges_plane.h"

#define DEGREE (180.0 / M_PI)

/** Means over the steady time, and the standard deviation of those of its blocks. */
typedef struct means {
    int samples;
    double mean[CLOD_GAUGE_VALUES];
    double deviation[CLOD_GAUGE_VALUES];
    double belt_speed; ///< m/s, of the gauge's belt, by the mass that was inside
} means;

static means means_of(const clod_gauge *gauge, const clod_gauge_memory *memory)
{
    means self;
    double whole[CLOD_GAUGE_SUMS] = {0};
    double values[CLOD_GAUGE_VALUES], each[CLOD_GAUGE_VALUES][CLOD_STEADY_BLOCKS];
    for (int b = 0; b < CLOD_STEADY_BLOCKS; b++) {
        for (int k = 0; k < CLOD_GAUGE_SUMS; k++) {
            whole[k] += memory->block[b][k];
        }
        clod_gauge_values(gauge, memory->block[b], values);
        for (int v = 0; v < CLOD_GAUGE_VALUES; v++) {
            each[v][b] = values[v];
        }
    }
    clod_gauge_values(gauge, whole, self.mean);
    self.samples = (int)whole[CLOD_GAUGE_SAMPLES];
    self.belt_speed = whole[CLOD_GAUGE_BELT_SPEED] / whole[CLOD_GAUGE_MASS]; // NAN: of nothing
    for (int v = 0; v < CLOD_GAUGE_VALUES; v++) {
        self.deviation[v] = clod_steady_time_deviation(each[v], CLOD_STEADY_BLOCKS);
    }
    return self;
}

// ---- the report

/** Text of a value with its deviation: "2.5 +- 0.1 m/s". */
static const char *text_of(const means *self, int value, char *text, size_t size)
{
    char spread[32];
    snprintf(text, size, "%.4g%s%s%s", self->mean[value],
             clod_prose_deviation(spread, self->mean[value], self->deviation[value]),
             CLOD_GAUGE_VALUE[value].unit[0] == '1' ? "" : " ", // "1": a pure number
             CLOD_GAUGE_VALUE[value].unit[0] == '1' ? "" : CLOD_GAUGE_VALUE[value].unit);
    return text;
}
#define TEXT 64

static void report_stream(FILE *out, const clod_case *from, const clod_case_gauge *gauge,
                          const means *self)
{
    char a[TEXT], b[TEXT];
    fprintf(out, "  gauge %-15s %s inside", gauge->name,
            text_of(self, CLOD_GAUGE_OF_MASS, a, sizeof a));
    if (clod_gauges_has(from, gauge, CLOD_GAUGE_OF_FLOW)) {
        fprintf(out, ", %s", text_of(self, CLOD_GAUGE_OF_FLOW, a, sizeof a));
    }
    if (isnan(self->mean[CLOD_GAUGE_OF_SPEED])) {
        fprintf(out, "\n");
        return;
    }
    fprintf(out, ", %s", text_of(self, CLOD_GAUGE_OF_SPEED, a, sizeof a));
    if (clod_gauges_has(from, gauge, CLOD_GAUGE_OF_ANGLE)) {
        fprintf(out, ", %s off direction", text_of(self, CLOD_GAUGE_OF_ANGLE, a, sizeof a));
    }
    fprintf(out, "\n");
    if (clod_gauges_has(from, gauge, CLOD_GAUGE_OF_OFFSET)) {
        fprintf(out, "  %-21s %s off its middle across, standard deviation %s", "",
                text_of(self, CLOD_GAUGE_OF_OFFSET, a, sizeof a),
                text_of(self, CLOD_GAUGE_OF_WIDTH, b, sizeof b));
        if (!isnan(self->mean[CLOD_GAUGE_OF_SORTING])) { // of one size it has no value
            fprintf(out, ", sorting %s", text_of(self, CLOD_GAUGE_OF_SORTING, a, sizeof a));
        }
        fprintf(out, "\n");
    }
}

static clod_gauge_section section_of(const clod_case_gauge *from, const clod_gauge *gauge,
                                     const clod_gauge_memory *memory)
{
    const clod_gauge_axis axis = clod_gauge_axis_of(gauge, gauge->across, from->profile_bins);
    return clod_gauge_bins_section(&memory->profile, &axis);
}

/** How the stream meets the belt that takes it. */
typedef struct landing {
    double along; ///< m/s, the gauge's direction
    double into;  ///< m/s, across that, downwards
    double belt;  ///< m/s, speed of the belt, a mean by mass as the stream's
} landing;

/** False where the stream is not known, or no direction is upwards. */
static bool landing_of(const clod_gauge *gauge, const means *self, landing *to)
{
    const clod_vec3 velocity = {self->mean[CLOD_GAUGE_OF_VELOCITY],
                                self->mean[CLOD_GAUGE_OF_VELOCITY + 1],
                                self->mean[CLOD_GAUGE_OF_VELOCITY + 2]};
    *to = (landing){.along = clod_vec3_dot(velocity, gauge->direction),
                    .into = -clod_vec3_dot(velocity, gauge->up),
                    .belt = self->belt_speed};
    return !isnan(to->along) && clod_vec3_length(gauge->up) > 0.0;
}

static void report_landing(FILE *out, const clod_gauge *gauge, const means *self)
{
    landing it;
    if (landing_of(gauge, self, &it)) {
        fprintf(out,
                "  %-21s %.4g m/s along its direction, %.4g m/s into the belt; along less the "
                "belt's %.4g m/s: %.4g m/s\n",
                "", it.along, it.into, it.belt, it.along - it.belt);
    }
}

static void report_extras(FILE *out, const clod_case_gauge *from, const clod_gauge *gauge,
                          const clod_gauge_memory *memory, const means *self)
{
    if (from->profile_bins > 0) {
        const clod_gauge_section section = section_of(from, gauge, memory);
        fprintf(out, "  %-21s cross-section %.4g m2, ", "", section.area);
        if (section.width > 0.0) {
            fprintf(out, "%.4g m wide", section.width);
        } else { // no bin had grains in half of the samples
            fputs("width -", out);
        }
        if (!isnan(section.surcharge)) {
            fprintf(out, ", surcharge angle %.3g deg", section.surcharge * DEGREE);
        }
        fprintf(out, "\n");
    }
    if (from->belt != NULL) {
        report_landing(out, gauge, self);
        fprintf(
            out, "  %-21s belt %s %.4g W: lifting %.4g W, acceleration %.4g W, heat %.4g W\n",
            "", from->belt, self->mean[CLOD_GAUGE_OF_POWER], self->mean[CLOD_GAUGE_OF_LIFTING],
            self->mean[CLOD_GAUGE_OF_ACCELERATION], self->mean[CLOD_GAUGE_OF_HEAT]);
    }
}

static void report_alarm(FILE *out, const clod_gauge_alarm *alarm, double dt)
{
    if (alarm->alarms > 0) {
        fprintf(out, "  WARNING               it was blocked, the first time from %.6g s on",
                (double)alarm->first * dt);
        if (alarm->on != 0) {
            fprintf(out, "; it is, since %.6g s", (double)alarm->slow_since * dt);
        }
        fprintf(out, " (%" PRId64 " alarm%s)\n", alarm->alarms,
                clod_plural((double)alarm->alarms));
    }
}

void clod_gauges_report(FILE *out, const void *memory, const clod_free_moment *now)
{
    const clod_gauges *all = memory;
    const clod_case *from = now->from;
    if (from->gauge_count > 0) {
        fprintf(out,
                "  gauges                means from %.4g s on; +- is the standard deviation of "
                "those of %d blocks\n",
                now->steady.since, CLOD_STEADY_BLOCKS);
    }
    for (size_t k = 0; k < from->gauge_count; k++) {
        const clod_case_gauge *mine = &from->gauges[k];
        const clod_gauge gauge = clod_gauges_make(from, mine);
        const means found = means_of(&gauge, &all->gauge[k]);
        if (found.samples > 0) {
            report_stream(out, from, mine, &found);
            report_extras(out, mine, &gauge, &all->gauge[k], &found);
        } else {
            fprintf(out, "  gauge %-15s no means: the run ended before %.6g s\n", mine->name,
                    now->steady.since);
        }
        clod_gauges_plane_report(out, all, now, k);
        report_alarm(out, &all->gauge[k].alarm, now->state->dt);
    }
}

// ---- the summary

static json_t *bins_json(const clod_gauge_bins *bins, const clod_gauge_axis *axis)
{
    json_t *at = json_array(), *lower = json_array(), *mean = json_array();
    json_t *upper = json_array(), *mass = json_array(), *share = json_array();
    for (int k = 0; k < axis->count; k++) {
        const clod_gauge_bin bin = clod_gauge_bins_of(bins, axis, k);
        json_array_append_new(at, clod_json_number(bin.at));
        json_array_append_new(lower, clod_json_number(bin.lower));
        json_array_append_new(mean, clod_json_number(bin.mean));
        json_array_append_new(upper, clod_json_number(bin.upper));
        json_array_append_new(mass, clod_json_number(bin.mass));
        json_array_append_new(share, clod_json_number(bin.share));
    }
    return json_pack("{s:o, s:o, s:o, s:o, s:o, s:o}", "at_m", at, "lower_m", lower, "mean_m",
                     mean, "upper_m", upper, "mass_kg", mass, "share", share);
}

static void put_bins(json_t *object, const clod_case_gauge *from, const clod_gauge *gauge,
                     const clod_gauge_memory *memory)
{
    if (from->profile_bins > 0) {
        const clod_gauge_axis axis =
            clod_gauge_axis_of(gauge, gauge->across, from->profile_bins);
        const clod_gauge_section section = section_of(from, gauge, memory);
        json_t *profile = bins_json(&memory->profile, &axis);
        json_object_set_new(profile, "area_m2", clod_json_number(section.area));
        json_object_set_new(profile, "width_m", clod_json_number(section.width));
        json_object_set_new(profile, "surcharge_deg",
                            clod_json_number(section.surcharge * DEGREE));
        json_object_set_new(object, "profile", profile);
    }
    if (from->trajectory_bins > 0) {
        const clod_gauge_axis axis =
            clod_gauge_axis_of(gauge, gauge->direction, from->trajectory_bins);
        json_object_set_new(object, "trajectory", bins_json(&memory->trajectory, &axis));
    }
}

static void put_alarm(json_t *object, const clod_gauge_alarm *alarm, double dt)
{
    json_object_set_new(object, "alarms", json_integer(alarm->alarms));
    json_object_set_new(object, "blocked_since_s",
                        alarm->first < 0 ? json_null() : json_real((double)alarm->first * dt));
    json_object_set_new(object, "blocked_at_end", json_boolean(alarm->on != 0));
    json_object_set_new(object, "blocked_at_end_since_s",
                        alarm->on == 0 ? json_null()
                                       : json_real((double)alarm->slow_since * dt));
}

static void put_landing(json_t *object, const clod_gauge *gauge, const means *self)
{
    landing it;
    if (landing_of(gauge, self, &it)) {
        json_object_set_new(object, "landing",
                            json_pack("{s:f, s:f, s:f}", "along_m_per_s", it.along,
                                      "into_m_per_s", it.into, "along_less_belt_m_per_s",
                                      it.along - it.belt));
    }
}

/** Of the classes of a profile or a trajectory. */
static void bin_paths(const clod_case_gauge *mine, const char *what, int64_t bins,
                      clod_free_paths *paths)
{
    static const char *const OF_BIN[] = {"at_m",    "lower_m", "mean_m",
                                         "upper_m", "mass_kg", "share"};
    for (size_t k = 0; bins > 0 && k < sizeof OF_BIN / sizeof *OF_BIN; k++) {
        clod_free_paths_add(paths, mine->name, "%s.%s.[0-%" PRId64 "]", what, OF_BIN[k],
                            bins - 1);
    }
}

void clod_gauges_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths)
{
    (void)state;
    for (size_t g = 0; g < from->gauge_count; g++) {
        const clod_case_gauge *mine = &from->gauges[g];
        clod_free_paths_add(paths, mine->name, "since_s samples");
        for (int v = 0; v < CLOD_GAUGE_VALUES; v++) {
            const char *key = CLOD_GAUGE_VALUE[v].key;
            if (clod_gauges_has(from, mine, v)) {
                clod_free_paths_add(paths, mine->name, "%s.mean %s.deviation", key, key);
            }
        }
        if (mine->belt != NULL) {
            clod_free_paths_add(paths, mine->name,
                                "landing.along_m_per_s landing.into_m_per_s "
                                "landing.along_less_belt_m_per_s");
        }
        clod_gauges_plane_paths(mine, paths);
        bin_paths(mine, "profile", mine->profile_bins, paths);
        if (mine->profile_bins > 0) {
            clod_free_paths_add(paths, mine->name,
                                "profile.area_m2 profile.width_m profile.surcharge_deg");
        }
        bin_paths(mine, "trajectory", mine->trajectory_bins, paths);
        if (mine->has_blocked) {
            clod_free_paths_add(paths, mine->name,
                                "alarms blocked_since_s blocked_at_end_since_s");
        }
    }
}

json_t *clod_gauges_json(const void *memory, const clod_free_moment *now)
{
    const clod_gauges *all = memory;
    const clod_case *from = now->from;
    json_t *object = json_object();
    for (size_t k = 0; k < from->gauge_count; k++) {
        const clod_case_gauge *mine = &from->gauges[k];
        const clod_gauge gauge = clod_gauges_make(from, mine);
        const means found = means_of(&gauge, &all->gauge[k]);
        json_t *one =
            json_pack("{s:f, s:i}", "since_s", now->steady.since, "samples", found.samples);
        for (int v = 0; v < CLOD_GAUGE_VALUES; v++) {
            if (clod_gauges_has(from, mine, v)) {
                json_object_set_new(one, CLOD_GAUGE_VALUE[v].key,
                                    json_pack("{s:o, s:o}", "mean",
                                              clod_json_number(found.mean[v]), "deviation",
                                              clod_json_number(found.deviation[v])));
            }
        }
        if (mine->belt != NULL) {
            put_landing(one, &gauge, &found);
        }
        clod_gauges_plane_json(one, all, now, k);
        put_bins(one, mine, &gauge, &all->gauge[k]);
        if (mine->has_blocked) {
            put_alarm(one, &all->gauge[k].alarm, now->state->dt);
        }
        json_object_set_new(object, mine->name, one);
    }
    return object;
}
