#include "config/walk.h"

#include <stdio.h>

const char *clod_walk_step(const clod_param *param)
{
    switch (param->kind) {
    case CLOD_PARAM_LIST:
        return "N";
    case CLOD_PARAM_MAP:
        return "NAME";
    case CLOD_PARAM_PAIRS:
        return "PAIR";
    default:
        return NULL;
    }
}

static void walk(const clod_table *table, const char *above, clod_walk_visit visit,
                 void *context)
{
    for (size_t i = 0; i < table->count; i++) {
        const clod_param *param = &table->params[i];
        const char *step = clod_walk_step(param);
        char path[CLOD_WALK_PATH];
        snprintf(path, sizeof path, "%s%s%s", above, above[0] == '\0' ? "" : ".", param->key);
        visit(context, path, param);
        if (param->beside != NULL) {
            walk(param->beside, path, visit, context);
        }
        if (param->table != NULL) {
            char below[CLOD_WALK_PATH + 8];
            snprintf(below, sizeof below, "%s%s%s", path, step == NULL ? "" : ".",
                     step == NULL ? "" : step);
            walk(param->table, below, visit, context);
        }
    }
}

void clod_walk(const clod_table *table, clod_walk_visit visit, void *context)
{
    walk(table, "", visit, context);
}
