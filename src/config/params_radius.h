#pragma once
/**
 * @file params_radius.h
 * The rows of a normal distribution of radii, for every struct with radius_mean, radius_sd,
 * radius_min and radius_max.
 */

#include "config/param.h"

#define CLOD_RADIUS_ROWS(type, mean_need)                                                      \
    {.key = "mean",                                                                            \
     .kind = CLOD_PARAM_REAL,                                                                  \
     .need = (mean_need),                                                                      \
     .unit = "m",                                                                              \
     CLOD_FROM(1e-9, 10),                                                                      \
     .example = "3.175 mm",                                                                    \
     CLOD_AT(type, radius_mean),                                                               \
     .help = "Mean of the normal distribution of radii before it is cut.",                     \
     .source = "docs/theory/copper-ore.md"},                                                   \
        {.key = "sd",                                                                          \
         .kind = CLOD_PARAM_REAL,                                                              \
         .need = (mean_need),                                                                  \
         .unit = "m",                                                                          \
         CLOD_ABOVE(0, 10),                                                                    \
         .example = "0.16 mm",                                                                 \
         CLOD_AT(type, radius_sd),                                                             \
         .help = "Standard deviation of the normal distribution before it is cut.",            \
         .source = "docs/theory/copper-ore.md"},                                               \
        {.key = "min",                                                                         \
         .kind = CLOD_PARAM_REAL,                                                              \
         .need = CLOD_PARAM_REQUIRED,                                                          \
         .unit = "m",                                                                          \
         CLOD_FROM(1e-9, 10),                                                                  \
         .example = "2.85 mm",                                                                 \
         CLOD_AT(type, radius_min),                                                            \
         .help = "Smallest radius.",                                                           \
         .source = "docs/theory/copper-ore.md"},                                               \
    {                                                                                          \
        .key = "max", .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_REQUIRED, .unit = "m",       \
        CLOD_FROM(1e-9, 10), .example = "3.49 mm", CLOD_AT(type, radius_max),                  \
        .help = "Largest radius.", .source = "docs/theory/copper-ore.md"                       \
    }
