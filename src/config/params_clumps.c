/**
 * @file params_clumps.c
 * Tables of what a free run tells of the graph of contacts: clumps, build-up, map of histories.
 */

#include "config/param.h"

#define K clod_case_clump_count
#define C clod_case_clumps
#define U clod_case_build_up
#define M clod_case_history_map

static const clod_param COUNT[] = {
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(K, region),
     .given = offsetof(K, has_region),
     .example = "{box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 0.1 m]}}",
     .help = "Only grains whose centre is in it, and bonds between them, count: a clump that "
             "reaches beyond it is cut. Without it all grains count.",
     .source = "docs/clumps.md"},
    {.key = "free",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     .example = "true",
     CLOD_AT(K, free),
     .help = "Whether only clumps count of which no grain touches a wall.",
     .source = "docs/clumps.md"},
};
static const clod_table COUNT_TABLE = {.title =
                                           "Clumps that are counted on their own, by name.",
                                       CLOD_ROWS(COUNT),
                                       .size = sizeof(K)};

static const clod_param CLUMPS[] = {
    {.key = "bond",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1e9),
     .fallback = "1",
     .example = "10",
     CLOD_AT(C, bond),
     .help =
         "Bond number: a closed contact joins two grains when its pull-off force exceeds so "
         "many times the weight of the lighter one. With 1 it can hang from the other.",
     .source = "docs/clumps.md"},
    {.key = "least",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(2, 1e6),
     .fallback = "2",
     .example = "5",
     CLOD_AT(C, least),
     .help = "Grains that hang together are a clump from this number on.",
     .source = "docs/clumps.md"},
    {.key = "counts",
     .kind = CLOD_PARAM_MAP,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &COUNT_TABLE,
     CLOD_AT(C, counts),
     CLOD_COUNT(C, count_count),
     .help = "Some of the clumps, by name, beside all of them: those in a region, those in "
             "flight, or both; at most 8.",
     .source = "docs/clumps.md"},
};
const clod_table CLOD_TABLE_CLUMPS = {
    .title = "Clumps: grains that hang together by adhesive contacts.", CLOD_ROWS(CLUMPS)};

static const clod_param BUILD_UP[] = {
    {.key = "speed",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_ABOVE(0, 1e3),
     .fallback = "50 mm/s",
     .example = "20 mm/s",
     CLOD_AT(U, speed),
     .help =
         "A grain rests when it is slower than this against the wall's material where it, or "
         "the grains below it, touch the wall.",
     .source = "docs/clumps.md"},
};
const clod_table CLOD_TABLE_BUILD_UP = {.title = "Solid that rests on walls.",
                                        CLOD_ROWS(BUILD_UP)};

static const clod_param MAP[] = {
    {.key = "cell",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "20 mm",
     CLOD_AT(M, cell),
     .help = "Edge of a cell of the map.",
     .source = "docs/clumps.md"},
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(M, region),
     .given = offsetof(M, has_region),
     .example = "{box: {min: [0 m, 0 m, 0 m], max: [1 m, 1 m, 0.1 m]}}",
     .help = "Box that is cut into cells from its least corner on; without it the domain.",
     .source = "docs/clumps.md"},
};
const clod_table CLOD_TABLE_HISTORY_MAP = {
    .title = "A map of what grain-grain contacts remember.", CLOD_ROWS(MAP)};
