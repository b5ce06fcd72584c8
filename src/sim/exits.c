#include "sim/exits.h"

#include <stdio.h>

static const char *const SIDE[CLOD_FACES] = {"x_min", "x_max", "y_min",
                                             "y_max", "z_min", "z_max"};

const char *clod_exits_name(const clod_case *from, int way)
{
    return way < CLOD_FACES   ? SIDE[way]
           : way < CLOD_EXITS ? from->outlets[way - CLOD_FACES].name
                              : "removed";
}

const char *clod_exits_key(const clod_case *from, int way, char *text, size_t size)
{
    snprintf(text, size, "%s%s",
             way < CLOD_FACES   ? "left_"
             : way < CLOD_EXITS ? "outlet_"
                                : "",
             clod_exits_name(from, way));
    return text;
}
