/**
 * @file result_card.c
 * The material card: calibrated keys as YAML that a case includes.
 */

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "calibrate/result.h"

#define COMMENT 6000 ///< bytes of a line: more than a path

/** Length of a key's part up to the dot number `depth` + 1, or of all. */
static size_t prefix(const char *key, size_t depth)
{
    size_t at = 0;
    for (size_t dots = 0; key[at] != '\0'; at++) {
        dots += key[at] == '.' ? 1 : 0;
        if (dots > depth) {
            break;
        }
    }
    return at;
}

static size_t depth_of(const char *key)
{
    size_t depth = 0;
    for (const char *at = strchr(key, '.'); at != NULL; at = strchr(at + 1, '.')) {
        depth++;
    }
    return depth;
}

/** Whether a parameter before this one begins with the first `length` bytes of its key, and a dot. */
static bool opened(const clod_plan *plan, size_t number, size_t length)
{
    const char *key = plan->parameters[number].key;
    for (size_t m = 0; m < number; m++) {
        const char *other = plan->parameters[m].key;
        if (strncmp(key, other, length) == 0 && other[length] == '.') {
            return true;
        }
    }
    return false;
}

static void put_value(FILE *out, const clod_result *self, size_t k, size_t depth)
{
    const clod_plan_parameter *of = &self->plan->parameters[k];
    const clod_posterior_parameter *one = &self->study->posterior->parameters[k];
    char low[64];
    char high[64];
    const char *dot = strrchr(of->key, '.');
    fprintf(out, "%*s%s: %.4g%s%s # %.3g %%: %s to %s", (int)(2 * depth), "",
            dot == NULL ? of->key : dot + 1, clod_plan_number(of, one->mean),
            of->unit[0] == '\0' ? "" : " ", of->unit, 100.0 * self->plan->sampling.level,
            clod_result_number(of, one->low, low, sizeof low),
            clod_result_number(of, one->high, high, sizeof high));
    const clod_result_identified told = clod_result_identified_of(self->study->posterior, k);
    if (told == CLOD_RESULT_MISSED) {
        fputs("; not identified: the targets are missed", out);
    } else if (told != CLOD_RESULT_IDENTIFIED) {
        fprintf(out, "; identified by the targets: %s", CLOD_RESULT_IDENTIFIED_NAMES[told]);
    }
    fputc('\n', out);
}

/** All parameters below the section that the first `length` bytes of the key of `first` name; "" with 0.
 */
static void put_section(FILE *out, const clod_result *self, size_t first, size_t length,
                        size_t depth)
{
    const clod_plan *plan = self->plan;
    const char *of = plan->parameters[first].key;
    for (size_t k = first; k < plan->parameter_count; k++) {
        const char *key = plan->parameters[k].key;
        if (length > 0 && (strncmp(key, of, length) != 0 || key[length] != '.')) {
            continue;
        }
        if (depth_of(key) == depth) {
            put_value(out, self, k, depth);
            continue;
        }
        const size_t below = prefix(key, depth);
        if (!opened(plan, k, below)) {
            const size_t skip = length == 0 ? 0 : length + 1;
            fprintf(out, "%*s%.*s:\n", (int)(2 * depth), "", (int)(below - skip), key + skip);
            put_section(out, self, k, below, depth + 1);
        }
    }
}

/** A line of a comment: whatever a title, name or path holds, nothing of it begins another line. */
static void put_comment(FILE *out, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void put_comment(FILE *out, const char *format, ...)
{
    char text[COMMENT];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    for (char *at = text; *at != '\0'; at++) {
        const unsigned char byte = (unsigned char)*at;
        if (byte < 0x20 || byte == 0x7F) {
            *at = ' ';
        }
    }
    fprintf(out, "# %s\n", text);
}

/** How the card is used. */
static void put_use(FILE *out, const clod_result *self)
{
    const clod_plan *plan = self->plan;
    put_comment(
        out,
        "Means, with %.3g %% intervals. calibration.json has everything, posterior.csv samples.",
        100.0 * plan->sampling.level);
    put_comment(out, "Use it: include: card.yaml in a case, which then must not give these "
                     "keys itself.");
    put_comment(out, "All that is not here is as in the cases of the tests:");
    for (size_t t = 0; t < plan->test_count; t++) {
        put_comment(out, "  %s: %s", plan->tests[t].name, plan->tests[t].path);
    }
}

static void put_correlations(FILE *out, const clod_result *self)
{
    const clod_posterior *from = self->study->posterior;
    for (size_t k = 0; k < from->dimensions; k++) {
        for (size_t m = 0; m < k; m++) {
            put_comment(out, "correlation of %s and %s: %+.2f", self->plan->parameters[m].name,
                        self->plan->parameters[k].name,
                        from->correlation[k * from->dimensions + m]);
        }
    }
}

char *clod_result_card(const clod_result *self)
{
    const bool apart = self->study->posterior->apart;
    const char *title = self->plan->title;
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    put_comment(out, "Material card%s%s, by clod calibrate from %s.", title == NULL ? "" : ": ",
                title == NULL ? "" : title, self->plan->path);
    if (apart) {
        put_comment(out, "NO RESULT: the Markov chains lie apart, so this card has no values.");
    } else {
        put_use(out, self);
    }
    for (size_t k = 0; k < self->warnings.count; k++) {
        put_comment(out, "WARNING: %s", self->warnings.text[k]);
    }
    if (!apart) {
        put_correlations(out, self);
        put_section(out, self, 0, 0, 0);
    }
    return clod_text_close(&text);
}
