/**
 * @file result_verdict.c
 * Whether a card meets its targets, or whether surrogates know too little to tell.
 */

#include <math.h>
#include <stdio.h>

#include "base/text.h"
#include "calibrate/result.h"
#include "config/grain_solid.h"

#define NAMED 250       ///< bytes of the targets that a warning names, whose end must have room
#define MOST_ERRORS 3.0 ///< of the laboratory, however wide the ranges are

const char *const CLOD_RESULT_VERDICT_NAMES[] = {[CLOD_RESULT_MET] = CLOD_SOLID_MET,
                                                 [CLOD_RESULT_MISSES] = CLOD_SOLID_MISSED,
                                                 [CLOD_RESULT_UNTOLD] = CLOD_SOLID_UNTOLD};

bool clod_result_tells(const clod_plan_target *target, const clod_posterior_target *self)
{
    const double variance = self->unsure * self->unsure;
    const double scatter = self->check.scatter;
    const double measured = clod_posterior_variance(target);
    return variance <= measured ||
           (self->checked && self->check.q2 >= CLOD_POSTERIOR_LEAST_Q2 &&
            variance <= MOST_ERRORS * MOST_ERRORS * measured &&
            variance <= (1.0 - CLOD_POSTERIOR_LEAST_Q2) * scatter * scatter);
}

bool clod_result_verdict_of(const clod_result *self, bool held_back,
                            clod_result_verdict *verdict)
{
    const clod_posterior *from = self->study->posterior;
    bool any = false, missed = !held_back && clod_result_missed(from), told = true;
    for (size_t t = 0; t < from->target_count; t++) {
        const clod_plan_target *target = &self->plan->targets[t];
        const clod_posterior_target *one = &from->targets[t];
        if (target->held_back == held_back && one->surrogate != NULL) {
            any = true;
            missed = missed || (held_back && clod_result_misses(self, t));
            told = told && clod_result_tells(target, one);
        }
    }
    *verdict = missed ? CLOD_RESULT_MISSES : told ? CLOD_RESULT_MET : CLOD_RESULT_UNTOLD;
    return any;
}

/** "crush: sigma_c 0.12 +- 0.60 kPa (measured 1.00 +- 0.20), ..." */
static void name_untold(const clod_result *self, bool held_back, char text[NAMED])
{
    clod_text_names names = clod_text_names_begin(text, NAMED);
    for (size_t t = 0; t < self->plan->target_count; t++) {
        const clod_plan_target *of = &self->plan->targets[t];
        const clod_posterior_target *at = &self->study->posterior->targets[t];
        if (of->held_back != held_back || at->surrogate == NULL || clod_result_tells(of, at)) {
            continue;
        }
        const double numbers[] = {at->at_card, at->unsure, of->value,
                                  sqrt(clod_posterior_variance(of))};
        char told[4][48], one[CLOD_PLAN_NAME + 4 * 48 + 32];
        for (size_t k = 0; k < 4; k++) {
            clod_result_measured(&of->measure, numbers[k], told[k], sizeof told[k]);
        }
        snprintf(one, sizeof one, "%s %s +- %s %s (measured %s +- %s)", of->name, told[0],
                 told[1], of->measure.unit, told[2], told[3]);
        clod_text_names_add(&names, one);
    }
    clod_text_names_end(&names);
}

void clod_result_verdict_warn(const clod_result *self, clod_warning_list *to)
{
    char names[NAMED];
    clod_result_verdict verdict;
    if (clod_result_verdict_of(self, false, &verdict) && verdict == CLOD_RESULT_UNTOLD) {
        name_untold(self, false, names);
        clod_warning_list_add(
            to,
            "Whether the card meets its targets is not told (targets: untold): p cannot tell it where surrogates are less sure "
            "than the laboratory, and at the card's values they give %s. Run the tests with the card (report.txt says "
            "how), or give more points, packings or narrower ranges.",
            names);
    }
    if (clod_result_verdict_of(self, true, &verdict) && verdict == CLOD_RESULT_UNTOLD) {
        name_untold(self, true, names);
        clod_warning_list_add(
            to,
            "Whether the card predicts what was held back is not told (held_back: untold): surrogates are less sure than the "
            "laboratory, and at the card's values they give %s.",
            names);
    }
}
