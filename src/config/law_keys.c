#include "config/law_keys.h"

#include <stdio.h>
#include <string.h>

#include "base/assert.h"

const clod_law_keys *clod_law_keys_of(int law)
{
    CLOD_ASSERT(law >= 0 && law < CLOD_LAW_KINDS);
    return &clod_law_kinds_row((clod_law_kind)law)->keys;
}

int clod_law_keys_list(bool (*has)(const clod_law_keys *law), char text[CLOD_LAW_KEYS_TEXT])
{
    int count = 0;
    for (int law = 0; law < CLOD_LAW_KINDS; law++) {
        count += has(clod_law_keys_of(law));
    }
    int used = snprintf(text, CLOD_LAW_KEYS_TEXT, count == 1 ? "law" : "the laws");
    for (int law = 0, named = 0; law < CLOD_LAW_KINDS; law++) {
        if (has(clod_law_keys_of(law))) {
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
            return clod_law_keys_of(law)->exponent;
        }
    }
    return 0.0;
}

void clod_law_keys_about(char text[CLOD_LAW_KEYS_ABOUT])
{
    int used = 0;
    for (int law = 0; law < CLOD_LAW_KINDS && used < CLOD_LAW_KEYS_ABOUT; law++) {
        used += snprintf(text + used, CLOD_LAW_KEYS_ABOUT - (size_t)used, "%s%s (%s)",
                         law > 0 ? ", " : "", CLOD_LAW_NAMES[law],
                         clod_law_kinds_row((clod_law_kind)law)->about);
    }
}
