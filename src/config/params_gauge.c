/**
 * @file params_gauge.c
 * Table of gauges: regions in which the stream is measured.
 */

#include "config/param.h"

#define G clod_case_gauge

static const clod_param BLOCKED[] = {
    {.key = "mass_above",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "kg",
     CLOD_ABOVE(0, 1e9),
     .example = "2 kg",
     CLOD_AT(G, blocked.mass_above),
     .help = "Mass inside from which on the gauge can be blocked.",
     .source = "docs/gauges.md"},
    {.key = "speed_below",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m/s",
     CLOD_ABOVE(0, 1e3),
     .example = "0.1 m/s",
     CLOD_AT(G, blocked.speed_below),
     .help = "Mean speed of what is inside, by mass, up to which it can be blocked.",
     .source = "docs/gauges.md"},
    {.key = "for",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_FROM(0, 1e6),
     .fallback = "0.3 s",
     CLOD_AT(G, blocked.duration),
     .help = "Time for which both must hold without a break.",
     .source = "docs/gauges.md"},
};
static const clod_table BLOCKED_TABLE = {
    .title = "Alarm: much is inside, and it hardly moves, for a time.", CLOD_ROWS(BLOCKED)};

#define BINS(field, words)                                                                     \
    {                                                                                          \
        .key = "bins", .kind = CLOD_PARAM_INTEGER, .need = CLOD_PARAM_REQUIRED, .unit = "1",   \
        CLOD_FROM(2, CLOD_CASE_GAUGE_BINS), .example = "20", CLOD_AT(G, field), .help = words, \
        .source = "docs/gauges.md"                                                             \
    }

static const clod_param PROFILE[] = {
    BINS(profile_bins, "Bins of equal width across the region."),
};
static const clod_table PROFILE_TABLE = {.title = "Cross-section of the load.",
                                         CLOD_ROWS(PROFILE)};

static const clod_param TRAJECTORY[] = {
    BINS(trajectory_bins, "Bins of equal width along direction."),
};
static const clod_table TRAJECTORY_TABLE = {.title = "Path of the stream.",
                                            CLOD_ROWS(TRAJECTORY)};

static const clod_param PLANE[] = {
    {.key = "at",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_FROM(-1e6, 1e6),
     .example = "1.05 m",
     CLOD_AT(G, plane_at),
     .help = "Place of the plane along the axis of space that is nearest to direction; within "
             "the region.",
     .source = "docs/gauges.md"},
};
static const clod_table PLANE_TABLE = {
    .title = "A plane through the region, at right angles to the axis of space that is nearest "
             "to direction.",
    CLOD_ROWS(PLANE)};

static bool is_given(const double v[3])
{
    return v[0] != 0.0 || v[1] != 0.0 || v[2] != 0.0;
}

static bool has_direction(const clod_case *whole, const void *self)
{
    (void)whole;
    return is_given(((const G *)self)->direction);
}

static bool has_across(const clod_case *whole, const void *self)
{
    (void)whole;
    return is_given(((const G *)self)->across);
}

static bool has_profile(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const G *)self)->profile_bins > 0;
}

static bool has_trajectory(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const G *)self)->trajectory_bins > 0;
}

static const clod_param GAUGE[] = {
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_REQUIRED,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(G, region),
     .example = "{box: {min: [1 m, -0.4 m, 0 m], max: [1.1 m, 0.4 m, 0.5 m]}}",
     .help = "Grains count whose centre is in it.",
     .source = "docs/gauges.md"},
    {.key = "direction",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .example = "[1, 0, 0]",
     CLOD_AT(G, direction),
     .used = has_direction,
     .help = "Direction of the stream, of any length: gives mass flow and angle.",
     .source = "docs/gauges.md"},
    {.key = "across",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .example = "[0, 1, 0]",
     CLOD_AT(G, across),
     .used = has_across,
     .help = "Direction across the stream, of any length: gives offset, width and sorting. "
             "Without it the level one at right angles to direction, to the left of the "
             "stream; an upright direction has none.",
     .source = "docs/gauges.md"},
    {.key = "belt",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "feed",
     CLOD_AT(G, belt),
     .help = "Wall whose belt carries what is inside: gives the power of the belt, and what of "
             "it lifts, accelerates and becomes heat.",
     .source = "docs/belts.md"},
    {.key = "blocked",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &BLOCKED_TABLE,
     .given = offsetof(G, has_blocked),
     .help = "When the gauge counts as blocked.",
     .source = "docs/gauges.md"},
    {.key = "plane",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &PLANE_TABLE,
     .given = offsetof(G, has_plane),
     .help =
         "Count each grain whose centre passes a plane within the region, forward and back: "
         "mass flow through it, exactly. Needs direction.",
     .source = "docs/gauges.md"},
    {.key = "profile",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &PROFILE_TABLE,
     .used = has_profile,
     .help = "Measure the cross-section of the load, looking along direction.",
     .source = "docs/gauges.md"},
    {.key = "trajectory",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &TRAJECTORY_TABLE,
     .used = has_trajectory,
     .help = "Measure lower edge, mean and upper edge of the stream along direction.",
     .source = "docs/gauges.md"},
};
const clod_table CLOD_TABLE_GAUGE = {
    .title = "Gauges, by name: regions in which the stream is measured.",
    CLOD_ROWS(GAUGE),
    .size = sizeof(G)};
