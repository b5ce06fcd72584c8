/**
 * @file result_json.c
 * A calibration for other programs: JSON with everything.
 */

#include <jansson.h>
#include <math.h>
#include <string.h>

#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "calibrate/result.h"
#include "clod/version.h"

#define SECTION 40 ///< steps of a section

static json_t *parameter(const clod_result *self, size_t k)
{
    const clod_posterior *from = self->study->posterior;
    const clod_posterior_parameter *one = &from->parameters[k];
    const clod_plan_parameter *of = &self->plan->parameters[k];
    json_t *tied = json_object();
    for (size_t m = 0; m < from->dimensions; m++) {
        json_object_set_new(tied, self->plan->parameters[m].name,
                            clod_json_number(from->correlation[k * from->dimensions + m]));
    }
    json_t *made = json_pack(
        "{s:s, s:s, s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:s, s:o, s:o, s:o}", "key", of->key,
        "unit", of->unit, "scale", of->scale == CLOD_PLAN_LOG ? "log" : "linear", "from",
        clod_json_number(of->low), "to", clod_json_number(of->high), "mean",
        clod_json_number(clod_plan_number(of, one->mean)), "low",
        clod_json_number(clod_plan_number(of, one->low)), "high",
        clod_json_number(clod_plan_number(of, one->high)), "relative_width",
        clod_json_number(one->width), "identified",
        CLOD_RESULT_IDENTIFIED_NAMES[clod_result_identified_of(from, k)], "rhat",
        clod_json_number(one->rhat), "effective_samples", clod_json_number(one->effective),
        "correlations", tied);
    json_object_set_new(made, "card", clod_json_number(clod_plan_number(of, from->card[k])));
    if (of->multiple_count > 0) {
        json_t *multiples = json_object();
        for (size_t m = 1; m <= of->multiple_count; m++) {
            json_object_set_new(multiples, clod_plan_key(of, m),
                                clod_json_number(clod_plan_factor(of, m)));
        }
        json_object_set_new(made, "multiples", multiples);
    }
    if (of->base != NULL) {
        json_object_set_new(made, "times", json_string(of->base->name));
    }
    return made;
}

/** The surrogate along one parameter, the others at the posterior's means. */
static json_t *section(const clod_result *self, size_t t, size_t k, double factor, double *room)
{
    const clod_posterior *from = self->study->posterior;
    double place[CLOD_PLAN_PARAMETERS];
    json_t *at = json_array();
    json_t *mean = json_array();
    json_t *deviation = json_array();
    for (size_t m = 0; m < from->dimensions; m++) {
        place[m] = from->parameters[m].mean;
    }
    for (int i = 0; i <= SECTION; i++) {
        place[k] = (double)i / SECTION;
        const clod_surrogate_value told = clod_posterior_told(from, t, place, room);
        json_array_append_new(
            at, clod_json_number(clod_plan_number(&self->plan->parameters[k], place[k])));
        json_array_append_new(mean, clod_json_number(factor * told.mean));
        json_array_append_new(deviation, clod_json_number(factor * sqrt(told.variance)));
    }
    return json_pack("{s:o, s:o, s:o}", "at", at, "mean", mean, "deviation", deviation);
}

static json_t *sections(const clod_result *self, size_t t, double factor)
{
    json_t *all = json_object();
    double *room = clod_posterior_room(self->study->posterior);
    const size_t count = self->study->posterior->apart ? 0 : self->plan->parameter_count;
    for (size_t k = 0; room != NULL && k < count; k++) {
        json_object_set_new(all, self->plan->parameters[k].name,
                            section(self, t, k, factor, room));
    }
    clod_memory_free(room);
    return all;
}

static json_t *surrogate(const clod_result *self, size_t t)
{
    const clod_plan *plan = self->plan;
    const clod_posterior_target *one = &self->study->posterior->targets[t];
    const double factor = plan->targets[t].measure.factor;
    double least, greatest;
    clod_surrogate_noise_ends(one->surrogate, &least, &greatest);
    json_t *lengths = json_object();
    for (size_t k = 0; k < plan->parameter_count; k++) {
        json_object_set_new(lengths, plan->parameters[k].name,
                            clod_json_number(clod_surrogate_length(one->surrogate, k)));
    }
    const double noise = clod_posterior_noise(self->study->posterior, t);
    json_t *made = json_pack("{s:s, s:I, s:o, s:o, s:o, s:o}", "kind",
                             CLOD_SURROGATE_NAMES[clod_surrogate_kind_of(one->surrogate)],
                             "runs", (json_int_t)one->runs, "packing_deviation",
                             clod_json_number(factor * noise), "least_packing_deviation",
                             clod_json_number(factor * least), "greatest_packing_deviation",
                             clod_json_number(factor * greatest), "relative_lengths", lengths);
    json_object_set_new(made, "draws", json_integer((json_int_t)self->study->posterior->draws));
    json_object_set_new(made, "independent_draws", clod_json_number(one->independent));
    if (one->checked) {
        json_object_set_new(made, "left_out_error",
                            clod_json_number(factor * one->check.error));
        json_object_set_new(made, "q2", clod_json_number(one->check.q2));
        json_object_set_new(made, "within_two_deviations",
                            clod_json_number(one->check.covered));
    }
    json_object_set_new(made, "sections", sections(self, t, factor));
    return made;
}

static json_t *target(const clod_result *self, size_t t)
{
    const clod_plan_target *of = &self->plan->targets[t];
    const clod_posterior_target *one = &self->study->posterior->targets[t];
    const double f = of->measure.factor;
    json_t *made =
        json_pack("{s:s, s:s, s:s, s:s, s:b, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o}", "name",
                  of->name, "test", self->plan->tests[of->test].name, "number", of->number,
                  "unit", of->measure.unit, "held_back", of->held_back, "measured",
                  clod_json_number(f * of->value), "error", clod_json_number(f * of->error),
                  "discrepancy", clod_json_number(f * of->discrepancy), "model",
                  clod_json_number(f * one->mean), "low", clod_json_number(f * one->low),
                  "high", clod_json_number(f * one->high), "off", clod_json_number(one->off),
                  "surrogate", one->surrogate != NULL ? surrogate(self, t) : json_null());
    json_object_set_new(made, "card", clod_json_number(f * one->at_card));
    json_object_set_new(made, "card_deviation", clod_json_number(f * one->unsure));
    if (of->normal_stress > 0.0) {
        json_object_set_new(made, "normal_stress_Pa", clod_json_number(of->normal_stress));
    }
    return made;
}

/** What is known of the card and its targets: "met", "missed", "untold"; null where there is none. */
static json_t *verdict(const clod_result *self, bool held_back)
{
    clod_result_verdict found;
    return !self->study->posterior->apart && clod_result_verdict_of(self, held_back, &found)
               ? json_string(CLOD_RESULT_VERDICT_NAMES[found])
               : json_null();
}

char *clod_result_json(const clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    json_t *parameters = json_object();
    for (size_t k = 0; k < from->dimensions; k++) {
        json_object_set_new(parameters, self->plan->parameters[k].name, parameter(self, k));
    }
    json_t *targets = json_array();
    for (size_t t = 0; t < from->target_count; t++) {
        json_array_append_new(targets, target(self, t));
    }
    json_t *warnings = json_array();
    for (size_t k = 0; k < self->warnings.count; k++) {
        json_array_append_new(warnings, json_string(self->warnings.text[k]));
    }
    char now[CLOD_CLOCK_TEXT];
    clod_clock_date(now);
    json_t *all = json_pack(
        "{s:s, s:s, s:s?, s:s, s:I, s:I, s:I, s:I, s:f, s:b, s:o, s:o, s:o, s:o, s:o, s:o}",
        "version", clod_version_text(), "written", now, "title", self->plan->title, "plan",
        self->plan->path, "points", (json_int_t)self->study->points, "designed_points",
        (json_int_t)self->study->designed, "packings", (json_int_t)self->plan->seeds,
        "failed_runs", (json_int_t)clod_runs_failed(self->runs), "level",
        self->plan->sampling.level, "chains_apart", from->apart, "chi_square",
        clod_json_number(from->chi_square), "p_value", clod_json_number(from->p_value),
        "accepted", clod_json_number(from->accepted), "parameters", parameters, "targets",
        targets, "warnings", warnings);
    json_object_set_new(all, "card_is_mean", json_boolean(from->card_is_mean && !from->apart));
    json_object_set_new(all, "card_targets", verdict(self, false));
    json_object_set_new(all, "card_held_back", verdict(self, true));
    char *text = clod_json_text(all, JSON_INDENT(2) | JSON_REAL_PRECISION(17));
    json_decref(all);
    return text;
}
