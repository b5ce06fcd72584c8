#include "config/value.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "config/suggest.h"
#include "config/unit.h"

#define MOST_REALS 10000

static void *at(void *target, size_t offset)
{
    return (char *)target + offset;
}

/** "a pressure", "a list of numbers": what a row takes, for messages. */
static const char *noun_of(const clod_param *param)
{
    switch (param->kind) {
    case CLOD_PARAM_REAL:
        return clod_unit_describe(param->unit)->noun;
    case CLOD_PARAM_STIFFNESS:
        return "a stiffness";
    case CLOD_PARAM_INTEGER:
        return "a whole number";
    case CLOD_PARAM_VECTOR:
        return param->length == 2 ? "two numbers" : "a vector x y z";
    case CLOD_PARAM_REALS:
        return "a list of numbers";
    case CLOD_PARAM_FLAGS:
        return "a list of three true or false";
    default:
        return "a single value";
    }
}

static const char *example_of(const clod_param *param)
{
    return param->example != NULL ? param->example : param->fallback;
}

static void fail_kind(clod_loader *self, const clod_param *param, const clod_node *node)
{
    const bool empty = node->kind != CLOD_NODE_SCALAR && node->count == 0;
    clod_report_add(self->report, node->place, self->path,
                    "must be %s, for instance %s, not %s", noun_of(param),
                    param->kind == CLOD_PARAM_CHOICE ? param->choices[0] : example_of(param),
                    empty ? "empty" : clod_tree_kind_name(node->kind));
}

static bool check_range(clod_loader *self, const clod_param *param, clod_place place,
                        const char *text, double value)
{
    if (clod_param_allows(param, value)) {
        return true;
    }
    char range[128];
    clod_report_add(self->report, place, self->path, "%s is out of range; allowed is %s", text,
                    clod_param_range_text(param, range, sizeof range));
    return false;
}

/** Unit that a message shows where one is missing: times of a simulation are ms, but a budget is none of those. */
static const char *example_unit(const clod_param *param)
{
    const char *example = example_of(param);
    double number;
    const char *unit = example != NULL && strcmp(param->unit, "s") == 0
                           ? clod_unit_number(example, &number)
                           : NULL;
    return unit != NULL && unit[0] != '\0' ? unit : NULL;
}

/** Convert a number with the rest of its text, which is the unit. */
static bool convert(clod_loader *self, const clod_param *param, clod_place place,
                    const char *unit, void *target, double *value)
{
    char message[CLOD_UNIT_MESSAGE];
    bool good;
    if (param->kind == CLOD_PARAM_STIFFNESS) {
        const double *exponent = at(target, param->exponent);
        good = *exponent < 1.0 || clod_unit_stiffness(unit, *exponent, value, message);
    } else {
        good = clod_unit_convert_like(unit, param->unit, example_unit(param), value, message);
    }
    if (!good) {
        clod_report_add(self->report, place, self->path, "%s", message);
    }
    return good;
}

/** Whether a text is a unit of a row's kind. */
static bool is_unit(const clod_param *param, const char *text)
{
    char message[CLOD_UNIT_MESSAGE];
    double one = 1.0;
    return text[0] != '\0' && clod_unit_convert(text, param->unit, &one, message);
}

static bool read_real(clod_loader *self, const clod_param *param, const clod_node *node,
                      void *target, double *value)
{
    if (node->kind != CLOD_NODE_SCALAR) {
        fail_kind(self, param, node);
        return false;
    }
    if (param->zero_word != NULL && strcmp(node->text, param->zero_word) == 0) {
        *value = 0.0;
        return true;
    }
    double number = 0.0;
    const char *unit = clod_unit_number(node->text, &number);
    if (unit == NULL && param->bare_unit && is_unit(param, node->text)) {
        unit = node->text;
        number = 1.0;
    }
    if (unit == NULL) {
        clod_report_add(self->report, node->place, self->path,
                        "\"%s\" is not a number; write for instance %s", node->text,
                        example_of(param));
        return false;
    }
    if (!convert(self, param, node->place, unit, target, &number) ||
        !check_range(self, param, node->place, node->text, number)) {
        return false;
    }
    *value = number;
    return true;
}

static void load_integer(clod_loader *self, const clod_param *param, const clod_node *node,
                         int64_t *value)
{
    if (node->kind != CLOD_NODE_SCALAR) {
        fail_kind(self, param, node);
        return;
    }
    if (param->zero_word != NULL && strcmp(node->text, param->zero_word) == 0) {
        *value = 0;
        return;
    }
    double number = 0.0;
    const char *end = clod_unit_number(node->text, &number);
    if (end == NULL || *end != '\0' || number != rint(number)) {
        clod_report_add(self->report, node->place, self->path,
                        "\"%s\" is not a whole number; write for instance %s", node->text,
                        example_of(param));
        return;
    }
    if (check_range(self, param, node->place, node->text, number)) {
        *value = (int64_t)number;
    }
}

static void load_bool(clod_loader *self, const clod_param *param, const clod_node *node,
                      bool *value)
{
    if (node->kind != CLOD_NODE_SCALAR) {
        fail_kind(self, param, node);
    } else if (strcmp(node->text, "true") == 0 || strcmp(node->text, "false") == 0) {
        *value = node->text[0] == 't';
    } else {
        clod_report_add(self->report, node->place, self->path,
                        "\"%s\" is neither true nor false", node->text);
    }
}

static void load_text(clod_loader *self, const clod_param *param, const clod_node *node,
                      char **value)
{
    if (node->kind != CLOD_NODE_SCALAR) {
        fail_kind(self, param, node);
        return;
    }
    const bool relative = param->kind == CLOD_PARAM_FILE && node->text[0] != '/';
    const char *folder = relative ? self->folder : "";
    const size_t size = strlen(folder) + strlen(node->text) + 2;
    *value = clod_memory_alloc(size, 1);
    if (*value == NULL) {
        self->report->lost = true;
        return;
    }
    snprintf(*value, size, "%s%s%s", folder, relative ? "/" : "", node->text);
}

static void load_choice(clod_loader *self, const clod_param *param, const clod_node *node,
                        int *value)
{
    if (node->kind != CLOD_NODE_SCALAR) {
        fail_kind(self, param, node);
        return;
    }
    char all[256] = "";
    char hint[64];
    clod_suggest near = clod_suggest_start(node->text);
    for (int i = 0; param->choices[i] != NULL; i++) {
        if (strcmp(node->text, param->choices[i]) == 0) {
            *value = i;
            return;
        }
        clod_suggest_offer(&near, param->choices[i]);
        const size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", i == 0 ? "" : ", ", param->choices[i]);
    }
    clod_report_add(self->report, node->place, self->path, "\"%s\" is not one of %s%s",
                    node->text, all, clod_suggest_text(&near, hint, sizeof hint));
}

/**
 * "0 0 -9.81 m/s2" -> a list of numbers with one unit behind them.
 * @return list whose scalars have the unit each, or NULL after an error
 */
static clod_node *split_numbers(clod_loader *self, const clod_param *param,
                                const clod_node *node)
{
    clod_node *list = clod_tree_node(self->arena, CLOD_NODE_LIST, node->place);
    const char *unit = node->text;
    double value;
    if (list == NULL) {
        self->report->lost = true;
        return NULL;
    }
    for (const char *next = clod_unit_number(unit, &value); next != NULL;
         next = clod_unit_number(unit, &value)) {
        clod_node *item = clod_tree_node(self->arena, CLOD_NODE_SCALAR, node->place);
        if (item == NULL || !clod_tree_append(self->arena, list, item)) {
            self->report->lost = true;
            return NULL;
        }
        item->text = clod_arena_text(self->arena, unit, (size_t)(next - unit));
        unit = next + (*next == ',');
    }
    if (list->count == 0) {
        fail_kind(self, param, node);
        return NULL;
    }
    for (size_t i = 0; i < list->count; i++) {
        const char *number = list->items[i]->text == NULL ? "" : list->items[i]->text;
        const size_t size = strlen(number) + strlen(unit) + 2;
        char *whole = clod_arena_alloc(self->arena, size);
        if (whole == NULL) {
            self->report->lost = true;
            return NULL;
        }
        snprintf(whole, size, "%s %s", number, unit);
        list->items[i]->text = whole;
    }
    return list;
}

/** Numbers of a vector or list into `values`, which has room for all of them. */
static bool read_items(clod_loader *self, const clod_param *param, const clod_node *list,
                       void *target, double *values)
{
    bool good = true;
    for (size_t i = 0; i < list->count; i++) {
        char key[24];
        snprintf(key, sizeof key, "%zu", i);
        const size_t length = clod_load_enter(self, key);
        good = read_real(self, param, list->items[i], target, &values[i]) && good;
        clod_load_leave(self, length);
    }
    return good;
}

static void load_vector(clod_loader *self, const clod_param *param, const clod_node *node,
                        void *target)
{
    const clod_node *list =
        node->kind == CLOD_NODE_SCALAR ? split_numbers(self, param, node) : node;
    if (list == NULL) {
        return;
    }
    if (list->kind != CLOD_NODE_LIST) {
        fail_kind(self, param, node);
        return;
    }
    if (list->count != param->length) {
        clod_report_add(self->report, node->place, self->path,
                        "has %zu number%s, must have %zu; write for instance %s", list->count,
                        list->count == 1 ? "" : "s", param->length, example_of(param));
        return;
    }
    double values[3] = {0.0, 0.0, 0.0};
    if (!read_items(self, param, list, target, values)) {
        return;
    }
    if (param->nonzero && values[0] == 0.0 && values[1] == 0.0 && values[2] == 0.0) {
        clod_report_add(self->report, node->place, self->path,
                        "has no direction; write for instance %s", example_of(param));
        return;
    }
    memcpy(at(target, param->offset), values, param->length * sizeof values[0]);
}

static void load_reals(clod_loader *self, const clod_param *param, const clod_node *node,
                       void *target)
{
    const clod_node *list =
        node->kind == CLOD_NODE_SCALAR ? split_numbers(self, param, node) : node;
    if (list == NULL) {
        return;
    }
    if (list->kind != CLOD_NODE_LIST || list->count == 0 || list->count > MOST_REALS) {
        fail_kind(self, param, node);
        return;
    }
    double *values = clod_memory_alloc(list->count, sizeof *values);
    if (values == NULL) {
        self->report->lost = true;
        return;
    }
    if (!read_items(self, param, list, target, values)) {
        clod_memory_free(values);
        return;
    }
    *(double **)at(target, param->offset) = values;
    *(size_t *)at(target, param->count) = list->count;
}

/** "[true, false, false]", or the default "false false false". */
static void load_flags(clod_loader *self, const clod_param *param, const clod_node *node,
                       bool *flags)
{
    if (node->kind == CLOD_NODE_SCALAR && strcmp(node->text, param->fallback) == 0) {
        return;
    }
    if (node->kind != CLOD_NODE_LIST || node->count != 3) {
        fail_kind(self, param, node);
        return;
    }
    for (size_t i = 0; i < 3; i++) {
        load_bool(self, param, node->items[i], &flags[i]);
    }
}

void clod_value_load(clod_loader *self, const clod_param *param, const clod_node *node,
                     void *target)
{
    void *value = at(target, param->offset);
    if (node->kind == CLOD_NODE_SCALAR && node->text[0] == '\0') {
        clod_report_add(self->report, clod_load_place(node), self->path,
                        "has no value; write for instance %s: %s", param->key,
                        example_of(param));
        return;
    }
    switch (param->kind) {
    case CLOD_PARAM_INTEGER:
        load_integer(self, param, node, value);
        break;
    case CLOD_PARAM_BOOL:
        load_bool(self, param, node, value);
        break;
    case CLOD_PARAM_FLAGS:
        load_flags(self, param, node, value);
        break;
    case CLOD_PARAM_TEXT:
    case CLOD_PARAM_FILE:
        load_text(self, param, node, value);
        break;
    case CLOD_PARAM_CHOICE:
        load_choice(self, param, node, value);
        break;
    case CLOD_PARAM_VECTOR:
        load_vector(self, param, node, target);
        break;
    case CLOD_PARAM_REALS:
        load_reals(self, param, node, target);
        break;
    default:
        read_real(self, param, node, target, value);
        break;
    }
}
