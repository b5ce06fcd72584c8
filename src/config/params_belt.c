/**
 * @file params_belt.c
 * Tables of conveyor belts.
 */

#include "config/param.h"
#include "config/unit.h"

#define B clod_case_belt
#define RUN clod_case_belt_run
#define PULLEY_OF clod_case_belt_pulley
#define SKIRTS_OF clod_case_belt_skirts

#define LENGTH(type, name, field, text, words)                                                 \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_REQUIRED, .unit = "m",        \
        CLOD_ABOVE(0, 1e4), .example = text, CLOD_AT(type, field), .help = words,              \
        .source = "docs/belts.md"                                                              \
    }
#define LENGTH_OR_0(type, name, field, words)                                                  \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_OPTIONAL, .unit = "m",        \
        CLOD_FROM(0, 1e4), .fallback = "0 m", CLOD_AT(type, field), .help = words,             \
        .source = "docs/belts.md"                                                              \
    }

static bool is_troughed(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const B *)self)->idler_angle != 0.0;
}

static bool has_pulley(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const B *)self)->pulley.radius != 0.0;
}

static bool has_skirts(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const B *)self)->skirts.height != 0.0;
}

static const clod_param RUNS[] = {
    LENGTH(RUN, "length", length, "3 m", "Length along the run."),
    {.key = "rise",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_FROM(-60 * CLOD_UNIT_DEGREE, 60 * CLOD_UNIT_DEGREE),
     .fallback = "0 deg",
     CLOD_AT(RUN, rise),
     .help = "Angle above the horizontal; below 0 the run falls.",
     .source = "docs/belts.md"},
};
static const clod_table RUN_TABLE = {
    .title = "A straight run of a belt.", CLOD_ROWS(RUNS), .size = sizeof(RUN)};

static const clod_param PULLEY[] = {
    LENGTH(PULLEY_OF, "radius", radius, "250 mm",
           "Radius of the belt's outer side on it: of the pulley, and the belt's thickness."),
    {.key = "wrap",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_ABOVE(0, 240 * CLOD_UNIT_DEGREE),
     .fallback = "180 deg",
     CLOD_AT(PULLEY_OF, wrap),
     .help = "Angle of the belt about it, from the end of the last run.",
     .source = "docs/belts.md"},
    LENGTH_OR_0(PULLEY_OF, "return", return_length,
                "Length of the belt that is made behind it, straight: what sticks goes on."),
};
static const clod_table PULLEY_TABLE = {
    .title = "The pulley at the end of the last run: head pulley.", CLOD_ROWS(PULLEY)};

static const clod_param SKIRTS[] = {
    {.key = "material",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "steel",
     CLOD_AT(SKIRTS_OF, material),
     .help = "Name of a material; without it that of the wall.",
     .source = "docs/belts.md"},
    LENGTH_OR_0(SKIRTS_OF, "from", from, "Where along the belt they begin."),
    LENGTH(SKIRTS_OF, "to", to, "2 m", "Where along the belt they end."),
    LENGTH(SKIRTS_OF, "distance", distance, "500 mm", "Distance between the two."),
    LENGTH_OR_0(SKIRTS_OF, "gap", gap, "Gap between the belt and their lower edges."),
    LENGTH(SKIRTS_OF, "height", height, "200 mm", "Height of the plates."),
};
static const clod_table SKIRTS_TABLE = {
    .title = "Skirts: upright plates along both sides of a belt, at rest.", CLOD_ROWS(SKIRTS)};

static const clod_param BELT[] = {
    {.key = "from",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .example = "[0 m, 0 m, 1 m]",
     CLOD_AT(B, from),
     .help = "Middle of the belt's upper side where it begins.",
     .source = "docs/belts.md"},
    {.key = "heading",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .fallback = "1 0 0",
     CLOD_AT(B, heading),
     .help = "Direction in which it runs, seen from above; level.",
     .source = "docs/belts.md"},
    {.key = "runs",
     .kind = CLOD_PARAM_LIST,
     .need = CLOD_PARAM_REQUIRED,
     .table = &RUN_TABLE,
     CLOD_AT(B, runs),
     CLOD_COUNT(B, run_count),
     .help = "Straight runs, one behind the other.",
     .source = "docs/belts.md"},
    LENGTH(B, "width", width, "800 mm", "Width of the belt, laid flat."),
    {.key = "idler_angle",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_FROM(0, 70 * CLOD_UNIT_DEGREE),
     .fallback = "0 deg",
     CLOD_AT(B, idler_angle),
     .help = "Angle of the wing rolls above the middle roll; 0 is a flat belt.",
     .source = "ISO 5048"},
    {.key = "middle_roll",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(0, 1e4),
     .fallback = "0 m",
     CLOD_AT(B, middle_roll),
     .used = is_troughed,
     .unused = "a flat belt has no wing rolls; remove this key, or give idler_angle",
     .help = "Length of the middle roll of three; 0 is a trough of two rolls.",
     .source = "ISO 5048"},
    {.key = "transition",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(0, 1e4),
     .fallback = "0 m",
     CLOD_AT(B, transition),
     .used = is_troughed,
     .unused = "a flat belt has no trough that flattens; remove this key, or give idler_angle",
     .help = "Length at the end of the last run over which the trough flattens.",
     .source = "docs/belts.md"},
    {.key = "facet",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(0, 1e4),
     .fallback = "0 m",
     CLOD_AT(B, facet),
     .help =
         "Cuts belt and skirts into pieces no longer and no wider than this, of two facets "
         "each, so that maps of pressure and wear are as fine; 0: as large as they can be. "
         "On the pulley facets stay 3 degrees long. Changes no force but on the transition of "
         "a trough, whose twisted plates become smoother.",
     .source = "docs/belts.md"},
    {.key = "speed",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .example = "2.5 m/s",
     CLOD_AT(B, speed),
     .help = "Speed of the belt along its runs (start_up of the wall: how it begins).",
     .source = "docs/belts.md"},
    {.key = "pulley",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &PULLEY_TABLE,
     CLOD_AT(B, pulley),
     .used = has_pulley,
     .help = "Head pulley; without it the belt ends in an edge.",
     .source = "docs/belts.md"},
    {.key = "skirts",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &SKIRTS_TABLE,
     CLOD_AT(B, skirts),
     .used = has_skirts,
     .help = "Plates along both sides.",
     .source = "docs/belts.md"},
};
const clod_table CLOD_TABLE_BELT = {.title = "A conveyor belt.", CLOD_ROWS(BELT)};
