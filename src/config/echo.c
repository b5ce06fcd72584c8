/**
 * @file echo.c
 * Structs -> a complete YAML text, by the parameter tables; it loads again to the same structs.
 */

#include "config/echo.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/given.h"
#include "base/memory.h"
#include "base/text.h"

/** Where the text goes, and the case it is of. */
typedef struct echo {
    FILE *out;
    const clod_case *whole;
} echo;

static const void *at(const void *target, size_t offset)
{
    return (const char *)target + offset;
}

static void indent(FILE *out, int depth)
{
    fprintf(out, "%*s", 2 * depth, "");
}

/** Shortest decimal number that reads back to the same bits. */
static void print_number(FILE *out, double value)
{
    char text[40];
    for (int digits = 15; digits <= 17; digits++) {
        snprintf(text, sizeof text, "%.*g", digits, value);
        if (strtod(text, NULL) == value) {
            break;
        }
    }
    fputs(text, out);
}

static void print_quantity(FILE *out, const clod_param *param, const void *target, double value)
{
    print_number(out, value);
    if (param->kind == CLOD_PARAM_STIFFNESS) {
        const double *exponent = at(target, param->exponent);
        fputs(" N/m", out);
        if (*exponent != 1.0) {
            fputc('^', out);
            print_number(out, *exponent);
        }
    } else if (strcmp(param->unit, "1") != 0) {
        fprintf(out, " %s", param->unit);
    }
}

static void print_text(FILE *out, const char *text)
{
    fputc('"', out);
    for (; *text != '\0'; text++) {
        if (*text == '"' || *text == '\\') {
            fprintf(out, "\\%c", *text);
        } else if ((unsigned char)*text < ' ' || *text == 127) {
            fprintf(out, "\\x%02X", (unsigned)(unsigned char)*text);
        } else {
            fputc(*text, out);
        }
    }
    fputc('"', out);
}

static void print_list(FILE *out, const clod_param *param, const void *target,
                       const double *values, size_t count)
{
    fputc('[', out);
    for (size_t i = 0; i < count; i++) {
        fputs(i == 0 ? "" : ", ", out);
        print_quantity(out, param, target, values[i]);
    }
    fputc(']', out);
}

static void print_value(FILE *out, const clod_param *param, const void *target)
{
    const void *value = at(target, param->offset);
    const bool *flags = value;
    switch (param->kind) {
    case CLOD_PARAM_INTEGER:
        fprintf(out, "%" PRId64, *(const int64_t *)value);
        break;
    case CLOD_PARAM_BOOL:
        fputs(*flags ? "true" : "false", out);
        break;
    case CLOD_PARAM_FLAGS:
        fprintf(out, "[%s, %s, %s]", flags[0] ? "true" : "false", flags[1] ? "true" : "false",
                flags[2] ? "true" : "false");
        break;
    case CLOD_PARAM_TEXT:
    case CLOD_PARAM_FILE:
        print_text(out, *(char *const *)value);
        break;
    case CLOD_PARAM_CHOICE:
        fputs(param->choices[*(const int *)value], out);
        break;
    case CLOD_PARAM_VECTOR:
        print_list(out, param, target, value, param->length);
        break;
    case CLOD_PARAM_REALS:
        print_list(out, param, target, *(double *const *)value,
                   *(const size_t *)at(target, param->count));
        break;
    default:
        print_quantity(out, param, target, *(const double *)value);
        break;
    }
}

/** Whether a row holds zero although it has no default: it was not given. */
static bool is_zero(const clod_param *param, const void *target)
{
    const void *value = at(target, param->offset);
    switch (param->kind) {
    case CLOD_PARAM_REAL:
    case CLOD_PARAM_STIFFNESS:
        return *(const double *)value == 0.0;
    case CLOD_PARAM_INTEGER:
        return *(const int64_t *)value == 0;
    case CLOD_PARAM_TEXT:
    case CLOD_PARAM_FILE:
    case CLOD_PARAM_LIST:
    case CLOD_PARAM_MAP:
    case CLOD_PARAM_REALS:
        return *(void *const *)value == NULL;
    default:
        return false;
    }
}

bool clod_echo_shows(const clod_case *whole, const clod_param *param, const void *target)
{
    if (param->given != 0) {
        return *(const bool *)at(target, param->given);
    }
    if (param->used != NULL) {
        return param->used(whole, target);
    }
    return param->need == CLOD_PARAM_REQUIRED || param->fallback != NULL ||
           !is_zero(param, target);
}

void clod_echo_value(FILE *out, const clod_param *param, const void *target)
{
    if (param->zero_word != NULL && is_zero(param, target)) {
        fputs(param->zero_word, out);
    } else {
        print_value(out, param, target);
    }
}

static void print_table(const echo *to, const clod_table *table, const void *target, int depth,
                        bool first_in_place);

static void print_items(const echo *to, const clod_param *param, const void *target, int depth)
{
    const char *items = *(const char *const *)at(target, param->offset);
    const size_t count = *(const size_t *)at(target, param->count);
    fputc('\n', to->out);
    for (size_t i = 0; i < count; i++) {
        const void *item = items + i * param->table->size;
        indent(to->out, depth + 1);
        if (param->kind == CLOD_PARAM_LIST) {
            fputs("- ", to->out);
            print_table(to, param->table, item, depth + 2, true);
        } else {
            if (param->any_name) {
                print_text(to->out, *(char *const *)item);
            } else {
                fputs(*(char *const *)item, to->out);
            }
            fputs(":\n", to->out);
            print_table(to, param->table, item, depth + 2, false);
        }
    }
}

static void print_pairs(const echo *to, const clod_param *param, const void *target, int depth)
{
    FILE *out = to->out;
    const clod_case *self = to->whole;
    const size_t n = self->material_count;
    fputc('\n', out);
    print_table(to, param->beside, target, depth + 1, false);
    for (size_t a = 0; a < n; a++) {
        for (size_t b = a; b < n; b++) {
            const clod_case_contact *contact = &self->pairs[a * n + b];
            if (contact->exponent == 0.0) {
                continue; // this pair has no law and never meets
            }
            indent(out, depth + 1);
            fprintf(out, "%s-%s:\n", self->materials[a].name, self->materials[b].name);
            for (size_t i = 0; i < param->table->count; i++) {
                const clod_param *row = &param->table->params[i];
                if (clod_echo_shows(self, row, contact)) {
                    indent(out, depth + 2);
                    fprintf(out, "%s: ", row->key);
                    print_value(out, row, contact);
                    fputc('\n', out);
                }
            }
        }
    }
}

static void print_row(const echo *to, const clod_param *param, const void *target, int depth)
{
    FILE *out = to->out;
    fprintf(out, "%s:", param->key);
    switch (param->kind) {
    case CLOD_PARAM_SECTION:
        fputc('\n', out);
        print_table(to, param->table, at(target, param->offset), depth + 1, false);
        break;
    case CLOD_PARAM_LIST:
    case CLOD_PARAM_MAP:
        print_items(to, param, target, depth);
        break;
    case CLOD_PARAM_PAIRS:
        print_pairs(to, param, target, depth);
        break;
    default:
        fputc(' ', out);
        clod_echo_value(out, param, target);
        fputc('\n', out);
        break;
    }
}

/** All rows of a struct; `first_in_place`: the first key stands behind "- " already. */
static void print_table(const echo *to, const clod_table *table, const void *target, int depth,
                        bool first_in_place)
{
    bool placed = first_in_place;
    for (size_t i = 0; i < table->count; i++) {
        const clod_param *param = &table->params[i];
        const bool chosen = !table->one_of || *(const int *)at(target, table->kind) == (int)i;
        if (!chosen || !clod_echo_shows(to->whole, param, target)) {
            continue;
        }
        if (!placed) {
            indent(to->out, depth);
        }
        placed = false;
        print_row(to, param, target, depth);
    }
}

char *clod_case_echo(const clod_case *self)
{
    CLOD_NEED(self);
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fputs("# The complete case: every default filled in, in SI units. It loads again.\n", out);
    print_table(&(echo){out, self}, &CLOD_TABLE_CASE, self, 0, false);
    return clod_text_close(&text);
}
