/**
 * @file result_card.c
 * The material card: calibrated keys as YAML that a case includes.
 */

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "calibrate/result.h"
#include "config/grain_solid.h"

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

/** A key of the card: which one of which parameter. */
typedef struct entry {
    size_t parameter, m; ///< as of clod_plan_key
    const char *key;     ///< of the plan
} entry;

typedef struct card {
    const clod_result *result;
    entry *entries; ///< [count] owned
    size_t count;
} card;

/** All keys of all parameters; false without memory. */
static bool collect(card *self)
{
    const clod_plan *plan = self->result->plan;
    size_t room = 0;
    for (size_t k = 0; k < plan->parameter_count; k++) {
        room += 1 + plan->parameters[k].multiple_count;
    }
    self->entries = clod_memory_alloc(room, sizeof *self->entries);
    for (size_t k = 0; k < plan->parameter_count && self->entries != NULL; k++) {
        for (size_t m = 0; m <= plan->parameters[k].multiple_count; m++) {
            self->entries[self->count++] =
                (entry){k, m, clod_plan_key(&plan->parameters[k], m)};
        }
    }
    return self->entries != NULL;
}

/** Whether an entry before this one begins with the first `length` bytes of its key, and a dot. */
static bool opened(const card *self, size_t number, size_t length)
{
    const char *key = self->entries[number].key;
    for (size_t m = 0; m < number; m++) {
        const char *other = self->entries[m].key;
        if (strncmp(key, other, length) == 0 && other[length] == '.') {
            return true;
        }
    }
    return false;
}

/** What stands behind a value: the interval of its parameter, or what it is a multiple of. */
static void put_reason(FILE *out, const clod_result *self, const entry *of)
{
    const size_t k = of->parameter;
    const clod_plan_parameter *parameter = &self->plan->parameters[k];
    const clod_posterior_parameter *one = &self->study->posterior->parameters[k];
    const clod_result_identified identified =
        clod_result_identified_of(self->study->posterior, k);
    char low[64], high[64];
    if (of->m > 0) {
        fprintf(out, "%.6g times %s", clod_plan_factor(parameter, of->m), parameter->key);
        return;
    }
    if (parameter->base != NULL) {
        fprintf(out, "%.4g times %s; ",
                clod_plan_number(parameter, self->study->posterior->card[k]),
                parameter->base->key);
    }
    fprintf(out, "%.3g %%: %s to %s%s", 100.0 * self->plan->sampling.level,
            clod_result_number(parameter, one->low, low, sizeof low),
            clod_result_number(parameter, one->high, high, sizeof high),
            parameter->base != NULL ? " times" : "");
    if (identified == CLOD_RESULT_MISSED) {
        fputs("; not identified: the targets are missed", out);
    } else if (identified != CLOD_RESULT_IDENTIFIED) {
        fprintf(out, "; identified by the targets: %s",
                CLOD_RESULT_IDENTIFIED_NAMES[identified]);
    }
}

static void put_value(FILE *out, const card *self, const entry *of, size_t depth)
{
    const clod_plan *plan = self->result->plan;
    const char *unit = clod_plan_key_unit(&plan->parameters[of->parameter]);
    const char *dot = strrchr(of->key, '.');
    fprintf(
        out, "%*s%s: %.4g%s%s # ", (int)(2 * depth), "", dot == NULL ? of->key : dot + 1,
        clod_plan_key_value(plan, of->parameter, of->m, self->result->study->posterior->card),
        unit[0] == '\0' ? "" : " ", unit);
    put_reason(out, self->result, of);
    fputc('\n', out);
}

/** All entries below the section that the first `length` bytes of the key of `first` name; "" with 0. */
static void put_section(FILE *out, const card *self, size_t first, size_t length, size_t depth)
{
    const char *of = self->entries[first].key;
    for (size_t k = first; k < self->count; k++) {
        const char *key = self->entries[k].key;
        if (length > 0 && (strncmp(key, of, length) != 0 || key[length] != '.')) {
            continue;
        }
        if (depth_of(key) == depth) {
            put_value(out, self, &self->entries[k], depth);
            continue;
        }
        const size_t below = prefix(key, depth);
        if (!opened(self, k, below)) {
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
        "%s, with %.3g %% intervals. calibration.json has everything, posterior.csv samples.",
        self->study->posterior->card_is_mean
            ? "Means"
            : "A sample near the means, which misses the targets less",
        100.0 * plan->sampling.level);
    put_comment(out, "Use it: include: card.yaml in a case, which then must not give these "
                     "keys itself; or --set include=card.yaml, which replaces them.");
    put_comment(
        out,
        "Sizes of grains, walls and all else that is not here are as in the cases of the tests:");
    for (size_t t = 0; t < plan->test_count; t++) {
        put_comment(out, "  %s: %s%s", plan->tests[t].name, plan->tests[t].path,
                    plan->tests[t].set_count > 0 ? ", with the set of plan.yaml" : "");
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

/** Whether the card gives a key of the solid: of its material, of its contact, or of all contacts. */
static bool gives(const card *self, const char *material, const char *key)
{
    for (size_t k = 0; k < self->count; k++) {
        const char *given = self->entries[k].key;
        char paths[4][CLOD_LOAD_PATH];
        snprintf(paths[0], sizeof paths[0], "contacts.default.%s", key);
        snprintf(paths[1], sizeof paths[1], "contacts.%s-%s.%s", material, material, key);
        snprintf(paths[2], sizeof paths[2], "contacts.%s", key);
        snprintf(paths[3], sizeof paths[3], "materials.%s.%s", material, key);
        for (size_t m = 0; m < 4; m++) {
            if (strcmp(given, paths[m]) == 0) {
                return true;
            }
        }
    }
    return false;
}

/** Whether the targets are met, those used and those held back, for who includes the card. */
static void put_verdict(FILE *out, const clod_result *self)
{
    static const char *const KEYS[] = {CLOD_SOLID_TARGETS, CLOD_SOLID_HELD_BACK};
    for (int held_back = 0; held_back < 2; held_back++) {
        clod_result_verdict verdict;
        if (clod_result_verdict_of(self, held_back == 1, &verdict)) {
            fprintf(out, "  %s: %s\n", KEYS[held_back], CLOD_RESULT_VERDICT_NAMES[verdict]);
        }
    }
}

/** How the calibration went, and what else the grains of the first test are made of; false without memory. */
static bool put_solid(FILE *out, const card *self)
{
    const clod_plan_test *test = &self->result->plan->tests[0];
    clod_grain_solid solid;
    const bool good = clod_grain_solid_init(&solid, test->middle);
    fprintf(
        out,
        "calibrated_with: # sets nothing; clod check warns of targets that are not met%s%s%s%s\n",
        solid.material != NULL ? ", and where a case that includes this has others than " : "",
        solid.material != NULL ? solid.material : "",
        solid.material != NULL ? " in the test " : "",
        solid.material != NULL ? test->name : "");
    put_verdict(out, self->result);
    for (size_t k = 0; k < solid.count && good; k++) {
        if (!gives(self, solid.material, solid.keys[k].key)) {
            fprintf(out, "  %s: %s\n", solid.keys[k].key, solid.keys[k].value);
        }
    }
    clod_grain_solid_fini(&solid);
    return good;
}

char *clod_result_card(const clod_result *self)
{
    const bool apart = self->study->posterior->apart;
    const char *title = self->plan->title;
    card all = {.result = self};
    clod_text text;
    FILE *out = collect(&all) ? clod_text_open(&text) : NULL;
    if (out != NULL) {
        put_comment(out, "Material card%s%s, by clod calibrate from %s.",
                    title == NULL ? "" : ": ", title == NULL ? "" : title, self->plan->path);
        if (apart) {
            put_comment(out,
                        "NO RESULT: the Markov chains lie apart, so this card has no values.");
        } else {
            put_use(out, self);
        }
        for (size_t k = 0; k < self->warnings.count; k++) {
            put_comment(out, "WARNING: %s", self->warnings.text[k]);
        }
        if (!apart) {
            put_correlations(out, self);
            put_section(out, &all, 0, 0, 0);
            text.lost = !put_solid(out, &all) || text.lost;
        }
    }
    clod_memory_free(all.entries);
    return out != NULL ? clod_text_close(&text) : NULL;
}
