/**
 * @file schema.c
 * The parameter tables as a JSON Schema (draft 2020-12), for editors that know YAML.
 */

#include "clod/schema.h"

#include <jansson.h>
#include <stdio.h>
#include <string.h>

#include "base/json.h"
#include "base/memory.h"
#include "config/param.h"

#define NUMBER "[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?"
#define UNIT " *[A-Za-z\\u00b0\\u00b5\\u03bc][^,]*"

static json_t *table_schema(const clod_table *table);
static json_t *param_schema(const clod_param *param);

static void set_text(json_t *object, const char *key, const char *text)
{
    json_object_set_new(object, key, json_string(text));
}

static json_t *constant(json_t *value)
{
    json_t *object = json_object();
    json_object_set_new(object, "const", value);
    return object;
}

static json_t *pattern(const char *text)
{
    json_t *object = json_object();
    set_text(object, "type", "string");
    set_text(object, "pattern", text);
    return object;
}

static json_t *any_of(json_t *first, json_t *second)
{
    json_t *object = json_object();
    json_t *list = json_array();
    json_array_append_new(list, first);
    json_array_append_new(list, second);
    json_object_set_new(object, "anyOf", list);
    return object;
}

static json_t *number_schema(const clod_param *param, const char *type)
{
    json_t *object = json_object();
    set_text(object, "type", type);
    if (isfinite(param->min)) {
        json_object_set_new(object, param->above_min ? "exclusiveMinimum" : "minimum",
                            json_real(param->min));
    }
    if (isfinite(param->max)) {
        json_object_set_new(object, "maximum", json_real(param->max));
    }
    return object;
}

static bool is_pure(const clod_param *param)
{
    return param->kind != CLOD_PARAM_STIFFNESS && strcmp(param->unit, "1") == 0;
}

/** One number: with its unit as text, or 0; a pure number also as a percentage. */
static json_t *real_schema(const clod_param *param)
{
    if (is_pure(param)) {
        return any_of(number_schema(param, "number"), pattern("^" NUMBER " *%$"));
    }
    return any_of(pattern(param->bare_unit ? "^(" NUMBER ")?" UNIT "$" : "^" NUMBER UNIT "$"),
                  constant(json_integer(0)));
}

/** A list of numbers, or a text of numbers with one unit behind them. */
static json_t *reals_schema(const clod_param *param)
{
    json_t *list = json_object();
    set_text(list, "type", "array");
    json_object_set_new(list, "items", real_schema(param));
    if (param->kind == CLOD_PARAM_VECTOR) {
        json_object_set_new(list, "minItems", json_integer((json_int_t)param->length));
        json_object_set_new(list, "maxItems", json_integer((json_int_t)param->length));
    } else {
        json_object_set_new(list, "minItems", json_integer(1));
    }
    return any_of(list, pattern("^" NUMBER "([ ,]+" NUMBER ")* *[^ ,0-9]*.*$"));
}

static json_t *flags_schema(void)
{
    json_t *list = json_object();
    json_t *item = json_object();
    set_text(item, "type", "boolean");
    set_text(list, "type", "array");
    json_object_set_new(list, "items", item);
    json_object_set_new(list, "minItems", json_integer(3));
    json_object_set_new(list, "maxItems", json_integer(3));
    return list;
}

static json_t *choice_schema(const clod_param *param)
{
    json_t *object = json_object();
    json_t *list = json_array();
    for (size_t i = 0; param->choices[i] != NULL; i++) {
        json_array_append_new(list, json_string(param->choices[i]));
    }
    json_object_set_new(object, "enum", list);
    return object;
}

static json_t *group_schema(const clod_param *param)
{
    json_t *object = json_object();
    if (param->kind == CLOD_PARAM_LIST) {
        set_text(object, "type", "array");
        json_object_set_new(object, "items", table_schema(param->table));
        json_object_set_new(object, "minItems", json_integer(1));
        return object;
    }
    json_t *names = json_object();
    const bool pairs = param->kind == CLOD_PARAM_PAIRS;
    json_object_set_new(names,
                        pairs             ? "^(default|[A-Za-z_]\\w*-[A-Za-z_]\\w*)$"
                        : param->any_name ? "^.+$"
                                          : "^[A-Za-z_]\\w*$",
                        table_schema(param->table));
    set_text(object, "type", "object");
    if (pairs) {
        json_t *beside = json_object();
        for (size_t i = 0; i < param->beside->count; i++) {
            const clod_param *row = &param->beside->params[i];
            json_object_set_new(beside, row->key, param_schema(row));
        }
        json_object_set_new(object, "properties", beside);
    }
    json_object_set_new(object, "patternProperties", names);
    json_object_set_new(object, "additionalProperties", json_false());
    return object;
}

static json_t *plain_schema(const clod_param *param)
{
    json_t *object = json_object();
    switch (param->kind) {
    case CLOD_PARAM_BOOL:
        set_text(object, "type", "boolean");
        break;
    case CLOD_PARAM_FILE:
        set_text(object, "type", "string");
        break;
    case CLOD_PARAM_SETTINGS:
        set_text(object, "type", "object");
        break;
    default: { // a text may look like a number: title: 42
        json_t *types = json_array();
        json_array_append_new(types, json_string("string"));
        json_array_append_new(types, json_string("number"));
        json_object_set_new(object, "type", types);
        break;
    }
    }
    return object;
}

static json_t *value_schema(const clod_param *param)
{
    switch (param->kind) {
    case CLOD_PARAM_REAL:
    case CLOD_PARAM_STIFFNESS:
        return real_schema(param);
    case CLOD_PARAM_INTEGER:
        return number_schema(param, "integer");
    case CLOD_PARAM_FLAGS:
        return flags_schema();
    case CLOD_PARAM_CHOICE:
        return choice_schema(param);
    case CLOD_PARAM_VECTOR:
    case CLOD_PARAM_REALS:
        return reals_schema(param);
    case CLOD_PARAM_SECTION:
        return table_schema(param->table);
    case CLOD_PARAM_LIST:
    case CLOD_PARAM_MAP:
    case CLOD_PARAM_PAIRS:
        return group_schema(param);
    default:
        return plain_schema(param);
    }
}

static void describe(json_t *object, const clod_param *param)
{
    char text[640];
    char help[512];
    char range[128];
    clod_param_range_text(param, range, sizeof range);
    snprintf(text, sizeof text, "%s%s%s%s%s%s%s%s", clod_param_help(param, help, sizeof help),
             range[0] == '\0' ? "" : " Allowed: ", range, range[0] == '\0' ? "" : ".",
             param->fallback == NULL ? "" : " Default: ",
             param->fallback == NULL ? "" : param->fallback, param->fallback == NULL ? "" : ".",
             param->need == CLOD_PARAM_REQUIRED ? " Must be given." : "");
    set_text(object, "description", text);
}

/** The schema of one key. */
static json_t *param_schema(const clod_param *param)
{
    json_t *object = value_schema(param);
    if (param->zero_word != NULL) {
        object = any_of(object, constant(json_string(param->zero_word)));
    }
    describe(object, param);
    return object;
}

static json_t *table_schema(const clod_table *table)
{
    json_t *object = json_object();
    json_t *keys = json_object();
    json_t *required = json_array();
    for (size_t i = 0; i < table->count; i++) {
        const clod_param *param = &table->params[i];
        json_object_set_new(keys, param->key, param_schema(param));
        if (param->need == CLOD_PARAM_REQUIRED) {
            json_array_append_new(required, json_string(param->key));
        }
    }
    set_text(object, "type", "object");
    json_object_set_new(object, "properties", keys);
    json_object_set_new(object, "additionalProperties", json_false());
    json_object_set_new(object, "required", required);
    if (table->one_of) {
        json_object_set_new(object, "minProperties", json_integer(1));
        json_object_set_new(object, "maxProperties", json_integer(1));
    }
    return object;
}

char *clod_schema_json(void)
{
    json_t *schema = table_schema(&CLOD_TABLE_CASE);
    set_text(schema, "$schema", "https://json-schema.org/draft/2020-12/schema");
    set_text(schema, "title", "Case file of clod");
    char *text = clod_json_text(schema, JSON_INDENT(1));
    json_decref(schema);
    return text;
}
