#include "config/law_keys.h"

#include <stdio.h>
#include <string.h>

#include "base/assert.h"

const char *const CLOD_LAW_NAMES[CLOD_LAW_KINDS + 1] = {
    [CLOD_LAW_MEPA] = "mepa",     [CLOD_LAW_HERTZ] = "hertz", [CLOD_LAW_HOOKE] = "hooke",
    [CLOD_LAW_LUDING] = "luding", [CLOD_LAW_EEPA] = "eepa",
};

static const clod_law_keys LAWS[CLOD_LAW_KINDS] = {
    [CLOD_LAW_MEPA] = {.k1 = "4.75e8", .k2 = "2.37e9", .k_adh = true},
    [CLOD_LAW_HERTZ] = {.exponent = 1.5, .elastic_moduli = true},
    [CLOD_LAW_HOOKE] = {.exponent = 1.0, .k1 = "4.75e8"},
    [CLOD_LAW_LUDING] = {.exponent = 1.0,
                         .k1 = "4.75e5",
                         .k2 = "2.37e6",
                         .plasticity_depth = "0.05",
                         .k_adh = true,
                         .k2_above = true},
    [CLOD_LAW_EEPA] = {.k1 = "4.75e8",
                       .k2 = "2.37e9",
                       .k_adh = true,
                       .pull_off_force = true,
                       .surface_energy = true},
};

const clod_law_keys *clod_law_keys_of(int law)
{
    CLOD_ASSERT(law >= 0 && law < CLOD_LAW_KINDS);
    return &LAWS[law];
}

int clod_law_keys_list(bool (*has)(const clod_law_keys *law), char text[CLOD_LAW_KEYS_TEXT])
{
    int count = 0;
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        count += has(&LAWS[law]);
    }
    int used = snprintf(text, CLOD_LAW_KEYS_TEXT, count == 1 ? "law" : "the laws");
    for (int law = 0, named = 0; law < CLOD_LAW_KINDS; law++) {
        if (has(&LAWS[law])) {
            named++;
            const char *before = named == 1 ? " " : named == count ? " and " : ", ";
            used += snprintf(text + used, CLOD_LAW_KEYS_TEXT - (size_t)used, "%s%s", before,
                             CLOD_LAW_NAMES[law]);
        }
    }
    return count;
}

double clod_law_keys_exponent(const char *name)
{
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        if (strcmp(name, CLOD_LAW_NAMES[law]) == 0) {
            return LAWS[law].exponent;
        }
    }
    return 0.0;
}
