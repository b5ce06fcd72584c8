#include "base/json.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/input.h"
#include "base/memory.h"

#define MOST_BYTES ((size_t)1 << 26) ///< of a file

static _Thread_local bool lost; ///< jansson was left without memory since the last text

static void *allocate(size_t size)
{
    void *memory = malloc(size);
    lost = lost || memory == NULL;
    return memory;
}

/** Before main: jansson must not change its functions while it has values. */
__attribute__((constructor)) static void watch_memory(void)
{
    json_set_alloc_funcs(allocate, free);
}

char *clod_json_text(const json_t *value, size_t flags)
{
    char *text = value != NULL ? json_dumps(value, flags) : NULL;
    if (lost) {
        free(text);
        text = NULL;
    }
    lost = false;
    return text;
}

bool clod_json_lacks_memory(void)
{
    return lost;
}

json_t *clod_json_number(double value)
{
    return isfinite(value) ? json_real(value) : json_null();
}

json_t *clod_json_parse(const char *text, size_t length, json_error_t *error)
{
    lost = false;
    json_t *found = json_loadb(text, length, 0, error);
    if (lost) {
        json_decref(found);
        return NULL;
    }
    return found;
}

json_t *clod_json_read(const char *folder, const char *name, clod_status *status)
{
    char path[PATH_MAX];
    char *text;
    size_t length;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (!clod_input_read_regular(path, MOST_BYTES, &text, &length, status)) {
        return NULL;
    }
    json_error_t error;
    json_t *found = clod_json_parse(text, length, &error);
    clod_memory_free(text);
    if (lost) {
        clod_status_fail(status, CLOD_FAILED, "No memory for %s.", path);
    } else if (found == NULL) {
        clod_status_fail(status, CLOD_USAGE, "%s:%d: damaged: %s", path, error.line,
                         error.text);
    }
    return found;
}
