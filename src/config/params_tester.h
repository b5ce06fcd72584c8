#pragma once
/**
 * @file params_tester.h
 * Rows that the tables of the testers share; `type` is the tester's struct.
 */

#include "config/param.h"

#define CLOD_TESTER_MATERIAL(type, name, text, word)                                           \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_TEXT, .need = CLOD_PARAM_REQUIRED, .example = word,   \
        CLOD_AT(type, name), .help = text, .source = "docs/theory/copper-ore.md"               \
    }
/** The range comes last, for its commas. */
#define CLOD_TESTER_REAL(type, name, si, value, text, where, ...)                              \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_OPTIONAL, .unit = si,        \
        __VA_ARGS__, .fallback = value, CLOD_AT(type, name), .help = text, .source = where     \
    }
#define CLOD_TESTER_RADIUS_TABLE(rows)                                                         \
    {                                                                                          \
        .title = "Normal distribution of grain radii by number, cut to [min, max].",           \
        CLOD_ROWS(rows)                                                                        \
    }
#define CLOD_TESTER_RADIUS(rows)                                                               \
    {                                                                                          \
        .key = "radius", .kind = CLOD_PARAM_SECTION, .need = CLOD_PARAM_REQUIRED,              \
        .table = &(rows), .help = "Grain radii.", .source = "docs/theory/copper-ore.md"        \
    }
#define CLOD_TESTER_LID(type)                                                                  \
    CLOD_TESTER_REAL(                                                                          \
        type, lid_mass, "kg", "1 kg",                                                          \
        "Mass with which the lid moves; its weight is part of the normal stress.",             \
        "docs/theory/ring-shear.md", CLOD_ABOVE(0, 1e4)),                                      \
        CLOD_TESTER_REAL(                                                                      \
            type, lid_damping, "1", "0.002",                                                   \
            "Damping of the lid as a fraction of critical against the stiffness of the bed.",  \
            "docs/theory/ring-shear.md", CLOD_FROM(0, 100))
/** How many grains: `room` is what auto fills, `by_room` tells whether auto is asked. */
#define CLOD_TESTER_FILLING(type, room, by_room, number)                                       \
    {.key = "grain_count",                                                                     \
     .kind = CLOD_PARAM_INTEGER,                                                               \
     .need = CLOD_PARAM_OPTIONAL,                                                              \
     .unit = "1",                                                                              \
     CLOD_FROM(1, 1e8),                                                                        \
     .zero_word = "auto",                                                                      \
     .fallback = "auto",                                                                       \
     .example = number,                                                                        \
     CLOD_AT(type, grain_count),                                                               \
     .help = "Number of grains, or auto: as many as fill the " room ".",                       \
     .source = "docs/theory/ring-shear.md"},                                                   \
        {.key = "fill_fraction",                                                               \
         .kind = CLOD_PARAM_REAL,                                                              \
         .need = CLOD_PARAM_OPTIONAL,                                                          \
         .unit = "1",                                                                          \
         CLOD_FROM(0.05, 0.74),                                                                \
         .fallback = "0.6",                                                                    \
         CLOD_AT(type, fill_fraction),                                                         \
         .used = by_room,                                                                      \
         .unused = "grain_count says how many grains there are; remove one of the two",        \
         .help = "Solid fraction from which auto takes the number of grains.",                 \
         .source = "docs/theory/ring-shear.md"},                                               \
        CLOD_TESTER_REAL(type, fill_adhesion, "1", "10 %",                                     \
                         "k_adh while filling, as a fraction of its value in contacts.",       \
                         "docs/theory/copper-ore.md", CLOD_FROM(0, 1)),                        \
        CLOD_TESTER_REAL(type, fill_max, "s", "0.6 s",                                         \
                         "Simulated time at most until the filled grains rest. Copper ore "    \
                         "takes some 0.2 s; high beds and elastic grains take longer.",        \
                         "docs/theory/ring-shear.md", CLOD_ABOVE(0, 1e3)),                     \
        CLOD_TESTER_REAL(type, settle_max, "s", "0.3 s",                                       \
                         "Simulated time at most until lid and specimen rest under a new "     \
                         "load, its ramp of 20 ms included. Copper ore takes some 0.06 s; "    \
                         "soft grains, a heavy lid or little lid_damping take longer.",        \
                         "docs/theory/ring-shear.md", CLOD_ABOVE(0.02, 1e3))
