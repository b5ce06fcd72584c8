#include "config/range.h"

#include <stdio.h>
#include <string.h>

#define KEY_SIZE 96

/** Numbers of one row, all with its unit. */
static bool row_holds(const clod_param *row, const double *numbers, size_t count,
                      const char *key, const char *what, clod_status *status)
{
    bool zero = true;
    for (size_t k = 0; k < count; k++) {
        zero = zero && numbers[k] == 0.0;
    }
    if (zero && row->need == CLOD_PARAM_OPTIONAL && row->fallback == NULL) {
        return true; // not given
    }
    if (zero && row->nonzero) {
        return clod_status_fail(status, CLOD_USAGE, "%s: %s is zero; give it a direction", what,
                                key);
    }
    for (size_t k = 0; k < count; k++) {
        if (!clod_param_allows(row, numbers[k])) {
            char range[128];
            const bool pure = strcmp(row->unit, "1") == 0;
            return clod_status_fail(
                status, CLOD_USAGE, "%s: %s has %g%s%s, which is out of range; allowed is %s",
                what, key, numbers[k], pure ? "" : " ", pure ? "" : row->unit,
                clod_param_range_text(row, range, sizeof range));
        }
    }
    return true;
}

/** The same of a section whose keys stand behind `path`. */
static bool holds(const clod_table *table, const char *self, const char *path, const char *what,
                  clod_status *status)
{
    bool good = true;
    for (size_t i = 0; good && i < table->count; i++) {
        const clod_param *row = &table->params[i];
        const char *value = self + row->offset;
        if (row->used != NULL && !row->used(NULL, self)) {
            continue;
        }
        char key[KEY_SIZE];
        snprintf(key, sizeof key, "%s%s%s", path, path[0] != '\0' ? "." : "", row->key);
        if (row->kind == CLOD_PARAM_SECTION) {
            good = holds(row->table, value, key, what, status);
        } else if (row->kind == CLOD_PARAM_REAL || row->kind == CLOD_PARAM_VECTOR) {
            const size_t count = row->kind == CLOD_PARAM_VECTOR ? row->length : 1;
            good =
                row_holds(row, (const double *)(const void *)value, count, key, what, status);
        }
    }
    return good;
}

bool clod_range_holds(const clod_table *table, const void *self, const char *what,
                      clod_status *status)
{
    return holds(table, self, "", what, status);
}
