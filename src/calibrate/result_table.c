/**
 * @file result_table.c
 * A calibration for people: aligned tables with units, intervals and warnings.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "calibrate/result.h"

#define WIDTH 100 ///< of a line of text
#define CELL 48   ///< bytes of a number

/** A text, broken between words, behind a mark. */
static void put_text(FILE *out, const char *text)
{
    fputs("  - ", out);
    while (strlen(text) > WIDTH - 4) {
        size_t end = WIDTH - 4;
        while (end > 0 && text[end] != ' ') {
            end--;
        }
        end = end == 0 ? WIDTH - 4 : end;
        fprintf(out, "%.*s\n    ", (int)end, text);
        text += end + (text[end] == ' ' ? 1 : 0);
    }
    fprintf(out, "%s\n", text);
}

/** A number in a column of this width, with four figures, or with as many digits behind the point; "-" where there is none. */
static void put_number(FILE *out, int width, int digits, double value)
{
    char text[CELL] = "-";
    if (isfinite(value) && digits == CLOD_PLAN_FIGURES) {
        snprintf(text, sizeof text, "%.4g", value);
    } else if (isfinite(value)) {
        snprintf(text, sizeof text, "%.*f", digits, value);
    }
    fprintf(out, "%*s", width, text);
}

static void put_parameters(FILE *out, const clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    const double tail = 50.0 * (1.0 - self->plan->sampling.level);
    fprintf(out,
            "\nParameters\n  %-16s %12s %11.3g %% %10.3g %% %12s  %-10s %6s  %-10s %7s %8s\n",
            "", "mean", tail, 100.0 - tail, "card", "unit", "width", "identified", "R-hat",
            "samples");
    for (size_t k = 0; k < from->dimensions; k++) {
        const clod_posterior_parameter *one = &from->parameters[k];
        const clod_plan_parameter *of = &self->plan->parameters[k];
        fprintf(out, "  %-16s ", of->name);
        put_number(out, 12, CLOD_PLAN_FIGURES, clod_plan_number(of, one->mean));
        put_number(out, 14, CLOD_PLAN_FIGURES, clod_plan_number(of, one->low));
        put_number(out, 13, CLOD_PLAN_FIGURES, clod_plan_number(of, one->high));
        put_number(out, 13, CLOD_PLAN_FIGURES, clod_plan_number(of, from->card[k]));
        fprintf(out, "  %-10s ", of->unit);
        put_number(out, 6, 2, one->width);
        fprintf(out, "  %-10s %7.3f %8.0f\n",
                CLOD_RESULT_IDENTIFIED_NAMES[clod_result_identified_of(from, k)], one->rhat,
                one->effective);
    }
    fputs(
        "  width: of the interval over that of the range alone; 1 and more: the targets do not narrow it.\n"
        "  Of a range with scale: log the mean is that of the logarithm. card: what card.yaml has.\n",
        out);
    if (from->apart) {
        fputs("  apart: the Markov chains lie apart, so there is no mean and no interval.\n",
              out);
    } else if (clod_result_missed(from)) {
        fputs(
            "  missed: the model does not give the targets, so nothing identifies a parameter.\n",
            out);
    }
}

static void put_correlations(FILE *out, const clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    const size_t d = from->dimensions;
    if (d < 2 || from->apart) {
        return;
    }
    fprintf(out, "\nCorrelations\n  %-16s", "");
    for (size_t k = 0; k + 1 < d; k++) {
        fprintf(out, " %9.9s", self->plan->parameters[k].name);
    }
    for (size_t k = 1; k < d; k++) {
        fprintf(out, "\n  %-16s", self->plan->parameters[k].name);
        for (size_t m = 0; m < k; m++) {
            fprintf(out, " %+9.2f", from->correlation[k * d + m]);
        }
    }
    fputs("\n", out);
}

static void put_target(FILE *out, const clod_result *self, size_t t)
{
    const clod_plan_target *of = &self->plan->targets[t];
    const clod_posterior_target *one = &self->study->posterior->targets[t];
    const double values[] = {of->value, of->error, of->discrepancy, one->mean,
                             one->low,  one->high, one->at_card};
    static const int WIDTHS[] = {10, 8, 8, 10, 10, 10, 10};
    fprintf(out, "  %-34s", of->name);
    for (size_t k = 0; k < sizeof values / sizeof values[0]; k++) {
        char text[CELL];
        fprintf(out, " %*s", WIDTHS[k],
                clod_result_measured(&of->measure, values[k], text, sizeof text));
    }
    if (!isfinite(one->mean)) { // no surrogate, or chains that lie apart
        fprintf(out, "  %-6s -        -\n", of->measure.unit);
        return;
    }
    const bool inside = of->value >= one->low && of->value <= one->high;
    fprintf(out, "  %-6s %-4s %+5.1f\n", of->measure.unit, inside ? "yes" : "NO", one->off);
}

static void put_targets(FILE *out, const clod_result *self, bool held_back, const char *title)
{
    bool begun = false;
    for (size_t t = 0; t < self->plan->target_count; t++) {
        if (self->plan->targets[t].held_back != held_back) {
            continue;
        }
        if (!begun) {
            const double tail = 50.0 * (1.0 - self->plan->sampling.level);
            fprintf(out,
                    "\n%s\n  %-34s %10s %8s %8s %10s %8.3g %% %8.3g %% %10s  %-6s %-4s %5s\n",
                    title, "", "measured", "error", "discr.", "model", tail, 100.0 - tail,
                    "card", "unit", "in", "off");
            begun = true;
        }
        put_target(out, self, t);
    }
}

/** "1.2 to 6.5": noise of packings in the ranges. */
static void put_noise_ends(FILE *out, const clod_plan_target *of,
                           const clod_posterior_target *one)
{
    double least, greatest;
    char low[CELL], high[CELL], both[2 * CELL + 8];
    clod_surrogate_noise_ends(one->surrogate, &least, &greatest);
    snprintf(both, sizeof both, "%s to %s",
             clod_result_measured(&of->measure, least, low, sizeof low),
             clod_result_measured(&of->measure, greatest, high, sizeof high));
    fprintf(out, " %18s", both);
}

/** A text within single quotes, in which a shell takes everything else as it is. */
static void put_quoted(FILE *out, const char *text)
{
    for (; *text != '\0'; text++) {
        fputs(*text == '\'' ? "'\\''" : (char[]){*text, '\0'}, out);
    }
}

/** Commands that run the tests with the card. A file that a case includes itself would be dropped by --set include. */
static void put_commands(FILE *out, const clod_plan *plan)
{
    fputs(
        "\nThe card was not run: what is told of it comes from surrogates. FOLDER stands for the whole path of this\n"
        "folder:\n",
        out);
    for (size_t t = 0; t < plan->test_count; t++) {
        const clod_plan_test *test = &plan->tests[t];
        const char *own = test->middle->include;
        if (own != NULL) {
            fprintf(
                out,
                "  (test %s includes %s, and one file only can be included: copy the keys of that and of card.yaml\n"
                "  into FOLDER/card-%s.yaml)\n",
                test->name, own, test->name);
        }
        fputs("  clod run '", out);
        put_quoted(out, test->path);
        fputs("'", out);
        for (size_t k = 0; k < test->set_count; k++) {
            if (strcmp(test->set[k].key, "include") != 0) {
                fprintf(out, " --set '%s=", test->set[k].key);
                put_quoted(out, test->set[k].value);
                fputs("'", out);
            }
        }
        fprintf(out, " --set 'include=FOLDER/card%s%s.yaml' -o 'FOLDER/card-%s'\n",
                own != NULL ? "-" : "", own != NULL ? test->name : "", test->name);
    }
}

static void put_surrogates(FILE *out, const clod_result *self)
{
    fprintf(
        out,
        "\nSurrogates, each point predicted by the others\n  %-34s %-16s %5s %10s %18s %10s %7s %9s\n",
        "", "kind", "runs", "packings", "in the ranges", "error", "Q2", "in 2 dev.");
    for (size_t t = 0; t < self->plan->target_count; t++) {
        const clod_plan_target *of = &self->plan->targets[t];
        const clod_posterior_target *one = &self->study->posterior->targets[t];
        char text[CELL];
        if (one->surrogate == NULL) {
            fprintf(out, "  %-34s %-16s %5zu\n", of->name, "-", one->runs);
            continue;
        }
        fprintf(out, "  %-34s %-16s %5zu %10s", of->name,
                CLOD_SURROGATE_NAMES[clod_surrogate_kind_of(one->surrogate)], one->runs,
                clod_result_measured(&of->measure,
                                     clod_posterior_noise(self->study->posterior, t), text,
                                     sizeof text));
        put_noise_ends(out, of, one);
        if (one->checked) {
            fprintf(out, " %10s %7.2f %7.0f %%\n",
                    clod_result_measured(&of->measure, one->check.error, text, sizeof text),
                    one->check.q2, 100.0 * one->check.covered);
        } else {
            fputs("          -       -         -\n", out);
        }
    }
    fputs(
        "  packings: standard deviation between packings of one point, at the means of the parameters;\n"
        "  in the ranges: its least and greatest; error: root of the mean square of a left-out point's\n"
        "  error; Q2: 1 where it is exact, 0 where the mean would do as well.\n",
        out);
}

char *clod_result_table(const clod_result *self)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    const clod_posterior *from = self->study->posterior;
    const char *title = self->plan->title;
    fputs(from->apart ? "NO RESULT: the Markov chains lie apart, see the warnings.\n\n" : "",
          out);
    fprintf(
        out,
        "Calibration%s%s: %zu points of %lld packing%s, %zu of them added where the posterior is\n",
        title == NULL ? "" : ": ", title == NULL ? "" : title, self->study->points,
        (long long)self->plan->seeds, self->plan->seeds == 1 ? "" : "s",
        self->study->points - self->study->designed);
    fputs(self->warnings.count > 0 ? "\nWarnings\n" : "", out);
    for (size_t k = 0; k < self->warnings.count; k++) {
        put_text(out, self->warnings.text[k]);
    }
    put_parameters(out, self);
    put_correlations(out, self);
    put_targets(out, self, false, "Targets that were used");
    put_targets(out, self, true, "Targets that were held back, predicted");
    fprintf(
        out,
        "  %.3g %% interval of what a laboratory would measure; card: the model at the values of card.yaml;\n"
        "  off: (measured - model) over its deviation.\n  chi-square %.3g of %zu, posterior predictive p = %.2g\n",
        100.0 * self->plan->sampling.level, from->chi_square, from->used, from->p_value);
    if (!from->apart) {
        put_commands(out, self->plan);
    }
    put_surrogates(out, self);
    return clod_text_close(&text);
}
