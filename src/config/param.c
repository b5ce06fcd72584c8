#include "config/param.h"

#include <stdio.h>
#include <string.h>

#include "config/law_keys.h"
#include "config/unit.h"

#define TURN (360 * CLOD_UNIT_DEGREE)

const clod_param *clod_param_find(const clod_table *table, const char *key)
{
    for (size_t i = 0; i < table->count; i++) {
        if (strcmp(table->params[i].key, key) == 0) {
            return &table->params[i];
        }
    }
    return NULL;
}

bool clod_param_is_group(const clod_param *param)
{
    return param->table != NULL;
}

const char *clod_param_help(const clod_param *param, char *buffer, size_t size)
{
    if (param->choices == CLOD_LAW_NAMES) {
        char about[CLOD_LAW_KEYS_ABOUT];
        clod_law_keys_about(about);
        snprintf(buffer, size, "%s It is one of %s.", param->help, about);
        return buffer;
    }
    if (param->law_has == NULL) {
        return param->help;
    }
    char laws[CLOD_LAW_KEYS_TEXT];
    clod_law_keys_list(param->law_has, laws);
    snprintf(buffer, size, param->fallback == NULL ? "%s Needed by %s." : "%s Only for %s.",
             param->help, laws);
    return buffer;
}

static const char *kind_name(clod_param_kind kind)
{
    static const char *const NAMES[] = {
        [CLOD_PARAM_REAL] = "number",
        [CLOD_PARAM_STIFFNESS] = "stiffness [N/m^n], n = exponent of the contact",
        [CLOD_PARAM_INTEGER] = "whole number",
        [CLOD_PARAM_BOOL] = "true or false",
        [CLOD_PARAM_FLAGS] = "list of three true or false, for x, y, z",
        [CLOD_PARAM_TEXT] = "text",
        [CLOD_PARAM_FILE] = "path of a file, relative to this file",
        [CLOD_PARAM_CHOICE] = "one of",
        [CLOD_PARAM_VECTOR] = "vector",
        [CLOD_PARAM_REALS] = "list of numbers",
        [CLOD_PARAM_SECTION] = "section",
        [CLOD_PARAM_LIST] = "list of sections",
        [CLOD_PARAM_MAP] = "sections by name",
        [CLOD_PARAM_PAIRS] = "sections by pair of materials (a-b), and default",
        [CLOD_PARAM_SETTINGS] = "keys with values, whichever",
    };
    return NAMES[kind];
}

static void append(char *buffer, size_t size, const char *text)
{
    const size_t used = strlen(buffer);
    snprintf(buffer + used, size - used, "%s", text);
}

const char *clod_param_kind_text(const clod_param *param, char *buffer, size_t size)
{
    const bool pure = param->unit == NULL || strcmp(param->unit, "1") == 0;
    snprintf(buffer, size, "%s", kind_name(param->kind));
    if (param->kind == CLOD_PARAM_REAL && !pure) {
        snprintf(buffer, size, "%s [%s]", clod_unit_describe(param->unit)->of, param->unit);
    } else if (param->kind == CLOD_PARAM_VECTOR) {
        snprintf(buffer, size, "%s [%s]", param->length == 2 ? "two numbers" : "vector x y z",
                 pure ? "-" : param->unit);
    } else if (param->kind == CLOD_PARAM_REALS) {
        snprintf(buffer, size, "list of numbers [%s]", pure ? "-" : param->unit);
    }
    for (size_t i = 0; param->kind == CLOD_PARAM_CHOICE && param->choices[i] != NULL; i++) {
        append(buffer, size, i == 0 ? " " : ", ");
        append(buffer, size, param->choices[i]);
    }
    return buffer;
}

bool clod_param_allows(const clod_param *param, double number)
{
    const bool low = param->above_min ? number > param->min : number >= param->min;
    return low && number <= param->max;
}

const char *clod_param_range_text(const clod_param *param, char *buffer, size_t size)
{
    const bool numeric = param->kind == CLOD_PARAM_REAL || param->kind == CLOD_PARAM_INTEGER ||
                         param->kind == CLOD_PARAM_STIFFNESS ||
                         param->kind == CLOD_PARAM_REALS || param->kind == CLOD_PARAM_VECTOR;
    const bool pure = param->unit == NULL || strcmp(param->unit, "1") == 0;
    const bool angle = !pure && strcmp(param->unit, "rad") == 0 && fabs(param->min) <= TURN &&
                       fabs(param->max) <= TURN; // people know angles in degrees
    const double scale = angle ? 1.0 / CLOD_UNIT_DEGREE : 1.0;
    char unit[16] = "";
    if (!pure) {
        snprintf(unit, sizeof unit, " %s", angle ? "deg" : param->unit);
    }
    buffer[0] = '\0';
    if (!numeric) {
        return buffer;
    }
    char low[64] = "";
    char high[64] = "";
    if (isfinite(param->min)) {
        snprintf(low, sizeof low, "%s %.*g%s", param->above_min ? "above" : "at least",
                 angle ? 4 : 6, scale * param->min, unit);
    }
    if (isfinite(param->max)) {
        snprintf(high, sizeof high, "at most %.*g%s", angle ? 4 : 6, scale * param->max, unit);
    }
    const char *join = low[0] != '\0' && high[0] != '\0' ? " and " : "";
    snprintf(buffer, size, "%s%s%s", low, join, high);
    return buffer;
}

const char *clod_param_default_text(const clod_param *param)
{
    if (param->fallback != NULL) {
        return param->fallback;
    }
    return param->need == CLOD_PARAM_REQUIRED ? "none: must be given" : "none: may be left out";
}
