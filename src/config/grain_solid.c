#include "config/grain_solid.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "config/echo.h"
#include "config/testers.h"
#include "config/unit.h"

#define SAME 1e-9 ///< relative: another unit may round otherwise

static const char *material_of(const clod_case *from)
{
    const clod_config_tester *tester = clod_config_tester_of(from);
    if (tester->materials != NULL) {
        return tester->materials(from).grain;
    }
    return from->grains_count > 0 ? from->grains[0].material : NULL;
}

static bool add(clod_grain_solid *self, const clod_case *from, const clod_param *param,
                const void *target)
{
    if (!clod_echo_shows(from, param, target)) {
        return true;
    }
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return false;
    }
    clod_echo_value(out, param, target);
    return clod_settings_add(&self->keys, &self->count, param->key, clod_text_close(&text));
}

bool clod_grain_solid_init(clod_grain_solid *self, const clod_case *from)
{
    *self = (clod_grain_solid){.material = material_of(from)};
    const int index =
        self->material != NULL ? clod_case_material_index(from, self->material) : -1;
    if (index < 0) {
        self->material = NULL;
        return true;
    }
    const clod_param *density = clod_param_find(&CLOD_TABLE_MATERIAL, "density");
    bool good = add(self, from, density, &from->materials[index]) &&
                add(self, from, clod_param_find(&CLOD_TABLE_CONTACTS, "soften"), from);
    const clod_case_contact *pair = clod_case_pair(from, index, index);
    for (size_t k = 0; k < CLOD_TABLE_CONTACT.count && good; k++) {
        good = add(self, from, &CLOD_TABLE_CONTACT.params[k], pair);
    }
    return good;
}

void clod_grain_solid_fini(clod_grain_solid *self)
{
    clod_settings_free(self->keys, self->count);
    *self = (clod_grain_solid){0};
}

static const char *value_of(const clod_grain_solid *self, const char *key)
{
    for (size_t k = 0; k < self->count; k++) {
        if (strcmp(self->keys[k].key, key) == 0) {
            return self->keys[k].value;
        }
    }
    return NULL;
}

/** Whether two values are one: the same words, or numbers with one unit. */
static bool is_same(const char *one, const char *other)
{
    double a, b;
    const char *unit = clod_unit_number(one, &a);
    const char *same = clod_unit_number(other, &b);
    return strcmp(one, other) == 0 ||
           (unit != NULL && same != NULL && strcmp(unit, same) == 0 &&
            fabs(a - b) <= SAME * fmax(fabs(a), fabs(b)));
}

/** Whether a key of a card tells how its calibration went, and nothing of the solid. */
static bool is_verdict(const char *key)
{
    return strcmp(key, CLOD_SOLID_TARGETS) == 0 || strcmp(key, CLOD_SOLID_HELD_BACK) == 0;
}

/** "friction 0.9 (card: 0.4), soften 1 (card: 10)"; "": all is the same. */
static void list_others(const clod_grain_solid *self, const clod_case *from, char *text,
                        size_t size)
{
    clod_text_names names = clod_text_names_begin(text, size);
    for (size_t k = 0; k < from->calibrated_with_count; k++) {
        const clod_setting *wanted = &from->calibrated_with[k];
        const char *here = value_of(self, wanted->key);
        if (!is_verdict(wanted->key) && (here == NULL || !is_same(here, wanted->value))) {
            char one[160];
            snprintf(one, sizeof one, "%.40s %.40s (card: %.40s)", wanted->key,
                     here != NULL ? here : "none", wanted->value);
            clod_text_names_add(&names, one);
        }
    }
    clod_text_names_end(&names);
}

bool clod_grain_solid_differs(const clod_case *from, char *text, size_t size)
{
    char others[300] = "";
    clod_grain_solid solid;
    text[0] = '\0';
    if (from->calibrated_with_count > 0 && clod_grain_solid_init(&solid, from) &&
        solid.material != NULL) {
        list_others(&solid, from, others, sizeof others);
    }
    if (others[0] != '\0') {
        snprintf(
            text, size,
            "the included card was calibrated with another solid than %.40s is here: %s. Its values belong "
            "together with those; give the card's here, or calibrate with these",
            solid.material, others);
    }
    if (from->calibrated_with_count > 0) {
        clod_grain_solid_fini(&solid);
    }
    return text[0] != '\0';
}

static bool says(const clod_case *from, const char *key, const char *word)
{
    for (size_t k = 0; k < from->calibrated_with_count; k++) {
        const clod_setting *one = &from->calibrated_with[k];
        if (strcmp(one->key, key) == 0 && strcmp(one->value, word) == 0) {
            return true;
        }
    }
    return false;
}

bool clod_grain_solid_missed(const clod_case *from, char *text, size_t size)
{
    static const struct {
        const char *key, *word, *text;
    } ROWS[] = {
        // the worst first
        {CLOD_SOLID_TARGETS, CLOD_SOLID_MISSED,
         "the included card misses the targets that it was calibrated with (calibrated_with.targets: missed): "
         "its values are not those of the solid that was measured. Its comments say what was missed; calibrate again, "
         "with other ranges, parameters or targets"},
        {CLOD_SOLID_TARGETS, CLOD_SOLID_UNTOLD,
         "whether the included card meets the targets that it was calibrated with is not told (calibrated_with.targets: "
         "untold): the surrogates of its calibration know less than the laboratory. Its comments say of what; run those "
         "tests with the card, or calibrate again, with more points, packings or narrower ranges"},
        {CLOD_SOLID_HELD_BACK, CLOD_SOLID_MISSED,
         "the included card misses measurements that were held back from its calibration "
         "(calibrated_with.held_back: missed): it need not predict what it was not fitted to. Its comments say what "
         "was missed"},
        {CLOD_SOLID_HELD_BACK, CLOD_SOLID_UNTOLD,
         "whether the included card predicts the measurements that were held back from its calibration is not told "
         "(calibrated_with.held_back: untold): its surrogates know less than the laboratory. Its comments say of what"}};
    text[0] = '\0';
    for (size_t k = 0; k < sizeof ROWS / sizeof ROWS[0] && text[0] == '\0'; k++) {
        if (says(from, ROWS[k].key, ROWS[k].word)) {
            snprintf(text, size, "%s", ROWS[k].text);
        }
    }
    return text[0] != '\0';
}
