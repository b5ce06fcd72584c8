#pragma once
/**
 * @file params_corner.h
 * The row of a corner of a box along x, y, z; `word` is smallest or largest.
 */

#include "config/param.h"

#define CLOD_CORNER_ROW(name, word, type, field, text)                                         \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_VECTOR, .length = 3, .need = CLOD_PARAM_REQUIRED,      \
        .unit = "m", CLOD_FROM(-1e4, 1e4), .example = text, CLOD_AT(type, field),              \
        .help = "Corner with the " word " x, y, z.", .source = "convention"                    \
    }
