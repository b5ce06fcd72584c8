/**
 * @file plan_doubts_keys.c
 * Parameters that are none of a material: the card sets their keys in every case that includes it.
 */

#include <string.h>

#include "calibrate/plan_check.h"

/** The word of a key behind so many points; "" where it has fewer. */
static const char *word_of(const char *key, size_t number)
{
    for (size_t k = 0; k < number; k++) {
        const char *point = strchr(key, '.');
        key = point != NULL ? point + 1 : "";
    }
    return key;
}

static bool begins(const char *key, const char *word)
{
    const size_t length = strlen(word);
    return strncmp(key, word, length) == 0 && key[length] == '.';
}

/** Whether it tells sizes of grains: grains.N.radius.mean, grains.N.sizes.sieve.N.size, ring_shear.radius.mean. */
static bool is_size(const char *key)
{
    const char *word = word_of(key, begins(key, "grains") ? 2 : 1);
    return !begins(key, "walls") && (begins(word, "radius") || begins(word, "sizes"));
}

static void warn_of_key(clod_plan *self, const char *name, const char *key)
{
    if (strcmp(key, "contacts.soften") == 0) {
        clod_warning_list_add(
            &self->warnings,
            "parameters.%.60s: contacts.soften is no property of a material: it divides stiffnesses for a longer time "
            "step, and the card then sets it in every case that includes it. Give it in the cases, and calibrate "
            "stiffnesses themselves",
            name);
    } else if (!begins(key, "materials") && !begins(key, "contacts") && !is_size(key)) {
        clod_warning_list_add(
            &self->warnings,
            "parameters.%.60s: %.100s is no property of a material, as keys below materials and contacts are: the card "
            "then sets it in every case that includes it, or is refused there. Give it in the case of the test, unless "
            "that is what the card is for",
            name, key);
    }
}

void clod_plan_warn_keys(clod_plan *self)
{
    for (size_t k = 0; k < self->parameter_count; k++) {
        const clod_plan_parameter *one = &self->parameters[k];
        for (size_t m = 0; m <= one->multiple_count; m++) {
            warn_of_key(self, one->name, clod_plan_key(one, m));
        }
    }
}
