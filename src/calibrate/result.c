#include "calibrate/result.h"

#include <math.h>
#include <stdio.h>

#include "base/plural.h"
#include "base/text.h"
#include "calibrate/posterior_card.h"

#define SAMPLES 1000 // of posterior.csv
#define CONTRADICTION 0.05
#define EDGE_SHARE 0.3    // of the samples in the last 5 % of a range
#define LARGEST_RHAT 1.05 // Gelman et al. (2013) ask for 1.1 at most; many now for 1.01 to 1.05
#define LEAST_EFFECTIVE                                                                        \
    400 // samples: 100 a chain (Vehtari et al., Bayesian Anal. 16 (2021) 667)
#define LEAST_INDEPENDENT 0.25 // of the draws of a surrogate
#define TOLD 0.25              // of the range: the targets tell the parameter
#define WEAKLY_TOLD 0.6
#define TIED 0.9
#define MOVED                                                                                  \
    2.0 // deviations that a target changes by, over the range of a parameter that it tells
#define WEAKLY_MOVED 1.0

const char *const CLOD_RESULT_IDENTIFIED_NAMES[] = {[CLOD_RESULT_IDENTIFIED] = "yes",
                                                    [CLOD_RESULT_WEAKLY] = "weakly",
                                                    [CLOD_RESULT_NOT_IDENTIFIED] = "no",
                                                    [CLOD_RESULT_MISSED] = "missed",
                                                    [CLOD_RESULT_APART] = "apart"};

bool clod_result_missed(const clod_posterior *self)
{
    return self->p_value < CONTRADICTION;
}

bool clod_result_misses(const clod_result *self, size_t target)
{
    const double value = self->plan->targets[target].value;
    const clod_posterior_target *of = &self->study->posterior->targets[target];
    return value < of->low || value > of->high;
}

clod_result_identified clod_result_identified_of(const clod_posterior *self, size_t k)
{
    const clod_posterior_parameter *of = &self->parameters[k];
    if (self->apart) {
        return CLOD_RESULT_APART;
    }
    if (clod_result_missed(self)) {
        return CLOD_RESULT_MISSED;
    }
    clod_posterior_split split;
    if (!(of->width < WEAKLY_TOLD && of->moved > MOVED) ||
        clod_posterior_is_split(self, k, &split)) {
        return CLOD_RESULT_NOT_IDENTIFIED;
    }
    return of->width < TOLD && self->predictive ? CLOD_RESULT_IDENTIFIED : CLOD_RESULT_WEAKLY;
}

const char *clod_result_number(const clod_plan_parameter *self, double place, char *buffer,
                               size_t size)
{
    snprintf(buffer, size, "%.4g%s%s", clod_plan_number(self, place),
             self->unit[0] == '\0' ? "" : " ", self->unit);
    return buffer;
}

const char *clod_result_measured(const clod_plan_measure *measure, double value, char *buffer,
                                 size_t size)
{
    const double told = measure->factor * value;
    if (!isfinite(told)) {
        snprintf(buffer, size, "-");
    } else if (measure->digits == CLOD_PLAN_FIGURES) {
        snprintf(buffer, size, "%.4g", told);
    } else if (told != 0.0 && fabs(told) < pow(10.0, 1 - measure->digits)) {
        snprintf(buffer, size, "%.3g", told); // its decimals would show one figure or none
    } else {
        snprintf(buffer, size, "%.*f", measure->digits, told);
    }
    return buffer;
}

/** Used target that is farthest from what the posterior predicts. */
static size_t farthest(const clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    size_t found = 0;
    double most = -1.0;
    for (size_t t = 0; t < from->target_count; t++) {
        if (!self->plan->targets[t].held_back && fabs(from->targets[t].off) > most) {
            most = fabs(from->targets[t].off);
            found = t;
        }
    }
    return found;
}

/** Parameter about which the chains disagree most. */
static size_t most_apart(const clod_posterior *self)
{
    size_t found = 0;
    for (size_t k = 1; k < self->dimensions; k++) {
        found = self->parameters[k].rhat > self->parameters[found].rhat ? k : found;
    }
    return found;
}

/** Chains that lie apart: all else is of no use. Where their mean p is so small, that of each chain is. */
static void warn_apart(clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    const size_t k = most_apart(from);
    clod_warning_list_add(
        &self->warnings,
        "The Markov chains lie apart (R-hat %.3g of %s, above %.2g; %.0f %% of the places that they begin at and step "
        "between are beyond all samples): there is no result, and no mean, interval or value of the card is told. %s",
        from->parameters[k].rhat, self->plan->parameters[k].name, CLOD_POSTERIOR_APART,
        100.0 * from->missed,
        from->p_value < CONTRADICTION / CLOD_POSTERIOR_CHAINS
            ? "All of them miss the targets (posterior predictive p below 0.05), which contradict each other or are out of "
              "reach of the model within these ranges: look at the measurements, widen ranges, free another parameter, or "
              "state a discrepancy."
            : "Several separate answers may suit the targets: give another target that tells them apart, narrower ranges, "
              "or fewer parameters.");
}

static void warn_missed(clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    const size_t t = farthest(self);
    clod_warning_list_add(
        &self->warnings,
        "The targets contradict each other, or the model cannot reach them within these ranges: "
        "chi-square %.3g of %zu target%s, posterior predictive p = %.2g. Farthest off is %s, "
        "measured %+.1f deviations from what the model gives. Intervals below are then too narrow, and tell no "
        "parameter: "
        "look at the measurements, widen ranges, free another parameter, or state a discrepancy.",
        from->chi_square, from->used, clod_plural((double)from->used), from->p_value,
        self->plan->targets[t].name, from->targets[t].off);
}

/** A surrogate that cannot bend as a Gaussian process can, of too few points. */
static void warn_stiff(clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    const size_t needed = clod_surrogate_gaussian_points(from->dimensions);
    for (size_t t = 0; t < from->target_count; t++) {
        const clod_posterior_target *one = &from->targets[t];
        if (one->surrogate != NULL && !one->held_back &&
            clod_surrogate_kind_of(one->surrogate) != CLOD_SURROGATE_GAUSSIAN) {
            clod_warning_list_add(
                &self->warnings,
                "%s has a %s surrogate, of %zu points: how else results may bend over the ranges "
                "it cannot tell, and counts as scatter. From %zu points on it is a Gaussian "
                "process.",
                self->plan->targets[t].name,
                CLOD_SURROGATE_NAMES[clod_surrogate_kind_of(one->surrogate)], one->check.points,
                needed);
            return; // one says it for all
        }
    }
}

static void warn_targets(clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    if (from->apart) {
        warn_apart(self);
    } else if (clod_result_missed(from)) {
        warn_missed(self);
    }
    for (size_t t = 0; t < from->target_count; t++) {
        const clod_posterior_target *one = &from->targets[t];
        const size_t all = self->study->points * (size_t)self->plan->seeds;
        char reason[CLOD_RUNS_REASON];
        if (one->surrogate == NULL) {
            clod_warning_list_add(
                &self->warnings,
                "%s was held back and cannot be predicted: %zu of %zu runs have this number. %s",
                self->plan->targets[t].name, one->runs, all, one->why);
            continue;
        }
        if (one->runs < all) {
            clod_warning_list_add(
                &self->warnings,
                "%s: only %zu of %zu runs have this number; the others failed or do not define it%s%s.",
                self->plan->targets[t].name, one->runs, all,
                clod_runs_lacks(self->runs, t, reason) ? ", the first of these " : "", reason);
        }
        const clod_plan_target *of = &self->plan->targets[t];
        if (of->held_back && clod_result_misses(self, t)) {
            clod_warning_list_add(
                &self->warnings,
                "%s was held back and is missed: measured %.4g, predicted %.4g to %.4g %s.",
                of->name, of->measure.factor * of->value, of->measure.factor * one->low,
                of->measure.factor * one->high, of->measure.unit);
        }
        if (one->independent < LEAST_INDEPENDENT * (double)from->draws) {
            clod_warning_list_add(
                &self->warnings,
                "%s: of the %zu draws of its surrogate's lengths and noise only some %.0f are "
                "independent: %s.",
                of->name, from->draws, one->independent,
                of->held_back
                    ? "its predicted interval may be too narrow, and it may be missed for that "
                      "reason alone. Free fewer parameters"
                    : "intervals may be too narrow. Free fewer parameters, or hold this target "
                      "back");
        }
        if (one->checked && one->check.q2 < CLOD_POSTERIOR_LEAST_Q2) {
            clod_warning_list_add(
                &self->warnings,
                "%s: its surrogate predicts points that are left out hardly better than their mean "
                "(Q2 %.2f): the parameters do not move it much, or more points or seeds are needed.",
                self->plan->targets[t].name, one->check.q2);
        }
    }
}

/** Whether many of the samples lie at an end of the range. */
static bool is_pressed(const clod_posterior_parameter *self)
{
    return self->below > EDGE_SHARE || self->above > EDGE_SHARE;
}

/** A parameter at an end of its range, or with a wide interval, or a narrow one for no reason. */
static void warn_width(clod_result *self, size_t k)
{
    const clod_posterior_parameter *one = &self->study->posterior->parameters[k];
    const char *name = self->plan->parameters[k].name;
    const char *end = one->above > one->below ? "upper" : "lower";
    const double share = 100.0 * fmax(one->above, one->below);
    const bool still =
        one->moved <= MOVED; // not so where chains lie apart, and nothing is known of it
    if (is_pressed(one) && !still) {
        clod_warning_list_add(
            &self->warnings,
            "%s wants to go beyond the %s end of its range (%.0f %% of the samples lie in the "
            "last 5 %% before it).",
            name, end, share);
    }
    clod_posterior_split split; // between separate answers there is a warning of its own
    if (one->width >= WEAKLY_TOLD &&
        !clod_posterior_is_split(self->study->posterior, k, &split)) {
        clod_warning_list_add(
            &self->warnings,
            "These targets hardly narrow %s: its %.3g %% interval is %.0f %% as wide as if nothing were measured.",
            name, 100.0 * self->plan->sampling.level, 100.0 * one->width);
    } else if (still) {
        clod_warning_list_add(
            &self->warnings,
            "These targets do not tell %s: over its range none changes by more than two deviations of its surrogate "
            "(%.1f). Its interval is where surrogates are least sure, not where %s is.",
            name, one->moved, name);
    }
}

/** Chains that have not come far enough; of those that lie apart there is a word already. */
static void warn_chains(clod_result *self, size_t k)
{
    const clod_posterior_parameter *one = &self->study->posterior->parameters[k];
    const char *name = self->plan->parameters[k].name;
    if (!(one->rhat <= LARGEST_RHAT)) {
        clod_warning_list_add(
            &self->warnings,
            "The Markov chains do not agree about %s (R-hat %.3f, %.0f independent samples): "
            "give more sampling.samples.",
            name, one->rhat, one->effective);
    } else if (!(one->effective >= LEAST_EFFECTIVE)) {
        clod_warning_list_add(
            &self->warnings,
            "Only %.0f samples of %s are independent (%d wanted): give more sampling.samples.",
            one->effective, name, LEAST_EFFECTIVE);
    }
}

/** Whether the means miss what samples meet, and nothing else says why: against an end of its range a parameter has all
 *  samples on one side, and targets out of reach are missed everywhere. */
static bool means_surprise(const clod_posterior *self)
{
    bool plain = clod_result_missed(self);
    for (size_t k = 0; k < self->dimensions; k++) {
        plain = plain || is_pressed(&self->parameters[k]);
    }
    return !self->card_is_mean && !plain;
}

/** Answers that lie apart, and a card that is not of the means. */
static void warn_card(clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    for (size_t k = 0; k < from->dimensions; k++) {
        char below[64], above[64];
        clod_posterior_split split;
        const clod_plan_parameter *of = &self->plan->parameters[k];
        if (clod_posterior_is_split(from, k, &split)) {
            clod_warning_list_add(
                &self->warnings,
                "The targets allow separate answers: %s near %s (%.0f %% of the samples) or near %s, and next to nothing "
                "between them, where the mean may be. Give another target that tells them apart, or narrower ranges.",
                of->name, clod_result_number(of, split.below, below, sizeof below),
                100.0 * split.share, clod_result_number(of, split.above, above, sizeof above));
        }
    }
    if (means_surprise(from)) {
        clod_warning_list_add(
            &self->warnings,
            "The means of the parameters together miss the targets by more than samples do, as on a bent ridge or between "
            "separate answers, so the card is not of them: it has a sample of the posterior near them, of the tenth that "
            "misses the targets least (column card).");
    }
}

static void warn_parameters(clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    if (!from->apart) {
        warn_card(self);
    }
    for (size_t k = 0; k < from->dimensions; k++) {
        const clod_posterior_parameter *one = &from->parameters[k];
        const char *name = self->plan->parameters[k].name;
        if (one->rhat <= CLOD_POSTERIOR_APART) {
            warn_width(self, k);
        }
        if (!from->apart) {
            warn_chains(self, k);
        }
        for (size_t m = 0; m < k; m++) {
            const double tie = from->correlation[k * from->dimensions + m];
            if (fabs(tie) > TIED) {
                clod_warning_list_add(
                    &self->warnings,
                    "%s and %s are tied (correlation %+.2f): the targets tell a combination of "
                    "them, not each.",
                    self->plan->parameters[m].name, name, tie);
            }
        }
    }
}

void clod_result_warn(clod_result *self)
{
    warn_targets(self);
    if (!self->study->posterior->apart) {
        clod_result_verdict_warn(self, &self->warnings);
    }
    warn_stiff(self);
    warn_parameters(self);
    const size_t failed = clod_runs_failed(self->runs);
    if (failed > 0) {
        clod_warning_list_add(&self->warnings,
                              "%zu run%s failed and %s not used; runs.csv has the reasons.",
                              failed, clod_plural((double)failed), failed == 1 ? "is" : "are");
    }
    clod_runs_warn(self->runs, &self->warnings);
    clod_runs_warn_outside(self->runs, &self->warnings);
    clod_runs_warn_zeros(self->runs, &self->warnings);
    for (size_t k = 0; k < self->plan->warnings.count; k++) {
        clod_warning_list_add(&self->warnings, "%s", self->plan->warnings.text[k]);
    }
}

char *clod_result_samples(const clod_result *self)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    const clod_posterior *from = self->study->posterior;
    const size_t d = from->dimensions;
    for (size_t k = 0; k < d; k++) {
        const clod_plan_parameter *one = &self->plan->parameters[k];
        fprintf(out, "%s%s [%s]", k == 0 ? "" : ",", one->name,
                one->unit[0] == '\0' ? "1" : one->unit);
    }
    fputc('\n', out);
    for (size_t i = 0; i < SAMPLES && !from->apart; i++) {
        const double *place = clod_posterior_sample(from, i, SAMPLES);
        for (size_t k = 0; k < d; k++) {
            fprintf(out, "%s%.9g", k == 0 ? "" : ",",
                    clod_plan_number(&self->plan->parameters[k], place[k]));
        }
        fputc('\n', out);
    }
    return clod_text_close(&text);
}
