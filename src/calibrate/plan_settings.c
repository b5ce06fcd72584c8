/**
 * @file plan_settings.c
 * What a plan changes in a case: keys of the test, and of the parameters at a point.
 */

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/plan.h"

const char *clod_plan_key(const clod_plan_parameter *self, size_t m)
{
    return m == 0 ? self->key : self->multiples[m - 1].key;
}

double clod_plan_factor(const clod_plan_parameter *self, size_t m)
{
    return m == 0 ? 1.0 : strtod(self->multiples[m - 1].value, NULL);
}

static double number_at(const clod_plan *self, const clod_plan_parameter *of,
                        const double *place)
{
    return clod_plan_number(of, place != NULL ? place[of - self->parameters] : 0.5);
}

double clod_plan_key_value(const clod_plan *self, size_t k, size_t m, const double *place)
{
    const clod_plan_parameter *of = &self->parameters[k];
    const double number = clod_plan_factor(of, m) * number_at(self, of, place);
    return of->base != NULL ? number * number_at(self, of->base, place) : number;
}

const char *clod_plan_key_unit(const clod_plan_parameter *self)
{
    return self->base != NULL ? self->base->unit : self->unit;
}

/** Append "key=value unit". */
static bool add(clod_plan_settings *self, const char *key, const char *value, const char *unit)
{
    char **grown =
        clod_memory_grow(self->items, self->count, self->count + 1, sizeof *self->items);
    const size_t size = strlen(key) + strlen(value) + strlen(unit) + 3;
    char *text = grown != NULL ? clod_memory_alloc(size, 1) : NULL;
    self->items = grown != NULL ? grown : self->items;
    if (text == NULL) {
        return false;
    }
    snprintf(text, size, "%s=%s%s%s", key, value, unit[0] == '\0' ? "" : " ", unit);
    self->items[self->count++] = text;
    return true;
}

bool clod_plan_settings_of_test(const clod_plan_test *test, clod_plan_settings *self)
{
    *self = (clod_plan_settings){0};
    bool good = true;
    for (size_t k = 0; k < test->set_count && good; k++) {
        good = add(self, test->set[k].key, test->set[k].value, "");
    }
    return good;
}

bool clod_plan_settings_at(const clod_plan *plan, const clod_plan_test *test,
                           const double *place, clod_plan_settings *self)
{
    bool good = clod_plan_settings_of_test(test, self);
    for (size_t k = 0; k < plan->parameter_count; k++) {
        const clod_plan_parameter *of = &plan->parameters[k];
        for (size_t m = 0; m <= of->multiple_count && good; m++) {
            char value[40];
            snprintf(value, sizeof value, "%.9g", clod_plan_key_value(plan, k, m, place));
            good = add(self, clod_plan_key(of, m), value, clod_plan_key_unit(of));
        }
    }
    return good;
}

void clod_plan_settings_fini(clod_plan_settings *self)
{
    for (size_t k = 0; k < self->count; k++) {
        clod_memory_free(self->items[k]);
    }
    clod_memory_free(self->items);
    *self = (clod_plan_settings){0};
}
