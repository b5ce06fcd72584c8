#pragma once
/**
 * @file params_programme.h
 * Rows of the programme of a shear test, for every tester's struct with a clod_case_programme
 * named programme; `type` is the tester's struct. Displacements have defaults of their own in
 * every tester: a ring turns for ever, a straight cell has a few millimetres.
 */

#include "config/param.h"

/** The range comes last, for its commas. */
#define CLOD_PROGRAMME_REAL(type, name, si, value, text, where, ...)                           \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_OPTIONAL, .unit = si,        \
        __VA_ARGS__, .fallback = value, CLOD_AT(type, programme.name), .help = text,           \
        .source = where                                                                        \
    }
#define CLOD_PROGRAMME_WHOLE(type, name, value, text, ...)                                     \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_INTEGER, .need = CLOD_PARAM_OPTIONAL, .unit = "1",    \
        __VA_ARGS__, .fallback = value, CLOD_AT(type, programme.name), .help = text,           \
        .source = "docs/theory/ring-shear.md"                                                  \
    }
#define CLOD_PROGRAMME_STRESSES(type)                                                          \
    {.key = "preshear_stress",                                                                 \
     .kind = CLOD_PARAM_REAL,                                                                  \
     .need = CLOD_PARAM_REQUIRED,                                                              \
     .unit = "Pa",                                                                             \
     CLOD_FROM(10, 1e8),                                                                       \
     .example = "54.8 kPa",                                                                    \
     CLOD_AT(type, programme.preshear_stress),                                                 \
     .help = "Normal stress of consolidation and preshear at the shear plane.",                \
     .source = "docs/theory/copper-ore.md; ring-shear.md"},                                    \
    {                                                                                          \
        .key = "shear_stresses", .kind = CLOD_PARAM_REALS, .need = CLOD_PARAM_REQUIRED,        \
        .unit = "Pa", CLOD_FROM(1, 1e8),                                                       \
        .example = "[10.96 kPa, 21.92 kPa, 32.88 kPa, 43.84 kPa]",                             \
        CLOD_AT(type, programme.shear_stresses),                                               \
        CLOD_COUNT(type, programme.shear_stress_count),                                        \
        .help = "Normal stresses of the points of the yield locus, at least two, each below "  \
                "preshear_stress; 20 to 80 % of it is usual.",                                 \
        .source = "docs/theory/ring-shear.md#what-is-from-where"                               \
    }
#define CLOD_PROGRAMME_STEADY(type)                                                            \
    CLOD_PROGRAMME_WHOLE(                                                                      \
        type, steady_blocks, "5",                                                              \
        "Number of blocks in a row that must agree for preshear to count as steady.",          \
        CLOD_FROM(3, 64)),                                                                     \
        CLOD_PROGRAMME_REAL(type, steady_tolerance, "1", "2 %",                                \
                            "How well the blocks must agree, relative to their mean.",         \
                            "docs/theory/ring-shear.md", CLOD_ABOVE(0, 1))
#define CLOD_PROGRAMME_PRESHEAR(type, least, most, why)                                          \
    CLOD_PROGRAMME_REAL(                                                                         \
        type, preshear_min, "m", least,                                                          \
        "Preshear goes on until here even when the shear stress is level already; then it ends " \
        "with a block. " why,                                                                    \
        "docs/theory/ring-shear.md", CLOD_FROM(0, 100)),                                         \
        CLOD_PROGRAMME_REAL(                                                                     \
            type, preshear_max, "m", most,                                                       \
            "Preshear stops here at the latest, whatever the speed: blocks are counted back "    \
            "from here. When the shear stress is not steady by then, the result tells how "      \
            "fast it still changes. " why,                                                       \
            "docs/theory/ring-shear.md", CLOD_ABOVE(0, 100))
#define CLOD_PROGRAMME_WAYS(type, shear, beyond, window, why)                                  \
    CLOD_PROGRAMME_REAL(type, shear_max, "m", shear,                                           \
                        "Longest shear of a point in search of its peak.",                     \
                        "docs/theory/ring-shear.md", CLOD_ABOVE(0, 100)),                      \
        CLOD_PROGRAMME_REAL(type, beyond_peak, "m", beyond,                                    \
                            "Shear that is recorded beyond the peak.",                         \
                            "docs/theory/ring-shear.md", CLOD_ABOVE(0, 100)),                  \
        CLOD_PROGRAMME_REAL(                                                                   \
            type, peak_window, "m", window,                                                    \
            "Shear over which the curve is smoothed to find its peak, by a moving average. "   \
            "A wide window lowers a sharp peak, a narrow one takes noise for it. " why,        \
            "docs/theory/ring-shear.md", CLOD_ABOVE(0, 1))
#define CLOD_PROGRAMME_SEEDS(type)                                                             \
    CLOD_PROGRAMME_WHOLE(type, seeds, "1",                                                     \
                         "Number of repeats with seed, seed + 1, ...; from two on the error "  \
                         "bars come from the "                                                 \
                         "scatter between them, with one from the points about their line.",   \
                         CLOD_FROM(1, 1000))
