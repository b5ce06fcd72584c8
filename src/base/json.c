#include "base/json.h"

#include <math.h>
#include <stdlib.h>

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
