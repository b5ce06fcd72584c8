/**
 * @file params_ring_shear.c
 * Table of the virtual Schulze ring shear test.
 */

#include "config/params_radius.h"
#include "config/params_tester.h"

#define R clod_case_ring_shear

#define REAL(name, si, range, value, text, where)                                              \
    CLOD_TESTER_REAL(R, name, si, value, text, where, range)
#define WHOLE(name, range, value, text, where)                                                 \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_INTEGER, .need = CLOD_PARAM_OPTIONAL, .unit = "1",    \
        range, .fallback = value, CLOD_AT(R, name), .help = text, .source = where              \
    }

static bool has_bars(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const R *)self)->bar_count > 0;
}

static bool is_filled_by_depth(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const R *)self)->grain_count == 0;
}

static const clod_param RADIUS[] = {CLOD_RADIUS_ROWS(R, CLOD_PARAM_REQUIRED)};
static const clod_table RADIUS_TABLE = {
    .title = "Normal distribution of grain radii by number, cut to [min, max].",
    CLOD_ROWS(RADIUS)};

static const clod_param ROWS[] = {
    CLOD_TESTER_MATERIAL(R, grain_material, "Material of the grains.", "ore"),
    CLOD_TESTER_MATERIAL(R, side_material, "Material of the inner and outer side walls.",
                         "side"),
    CLOD_TESTER_MATERIAL(R, base_material, "Material of the base and its bars.", "base"),
    CLOD_TESTER_MATERIAL(R, lid_material, "Material of the lid and its bars.", "base"),
    CLOD_TESTER_RADIUS(RADIUS_TABLE),
    REAL(inner_radius, "m", CLOD_ABOVE(0, 10), "50 mm", "Inner radius of the annulus.",
         "PHYSICS 7 (RST-01)"),
    REAL(outer_radius, "m", CLOD_ABOVE(0, 10), "100 mm", "Outer radius of the annulus.",
         "PHYSICS 7 (RST-01)"),
    REAL(depth, "m", CLOD_ABOVE(0, 10), "40 mm", "Height of the specimen that filling aims at.",
         "PHYSICS 7 (RST-01)"),
    WHOLE(bar_count, CLOD_FROM(0, 1000), "20",
          "Radial bars on the lid, and as many on the base.", "PHYSICS 7 (RST-01)"),
    REAL(bar_height, "m", CLOD_ABOVE(0, 1), "6.35 mm",
         "Height of a bar; at least one grain diameter grips well.", "PHYSICS 7"),
    {.key = "bar_width",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1),
     .fallback = "3 mm",
     CLOD_AT(R, bar_width),
     .used = has_bars,
     .unused = "bar_count is 0: there are no bars; remove this key",
     .help = "Thickness of a bar.",
     .source = "PHYSICS 7"},
    CLOD_TESTER_LID(R),
    CLOD_TESTER_FILLING(R, "depth", is_filled_by_depth, "4000"),
    {.key = "preshear_stress",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "Pa",
     CLOD_FROM(10, 1e8),
     .example = "54.8 kPa",
     CLOD_AT(R, preshear_stress),
     .help = "Normal stress of consolidation and preshear at the shear plane.",
     .source = "PHYSICS 6; ASTM D6773"},
    {.key = "shear_stresses",
     .kind = CLOD_PARAM_REALS,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "Pa",
     CLOD_FROM(1, 1e8),
     .example = "[10.96 kPa, 21.92 kPa, 32.88 kPa, 43.84 kPa]",
     CLOD_AT(R, shear_stresses),
     CLOD_COUNT(R, shear_stress_count),
     .help = "Normal stresses of the points of the yield locus, each below preshear_stress; 20 "
             "to 80 % of it is usual.",
     .source = "PHYSICS 7; ASTM D6773"},
    REAL(speed, "m/s", CLOD_ABOVE(0, 1), "30 mm/s",
         "Speed of shear at the mean radius r_m; the inertial number should stay below 1e-3.",
         "PHYSICS 5, 7"),
    REAL(block_displacement, "m", CLOD_ABOVE(0, 1), "2 mm",
         "Shear displacement at r_m over which one block average of the shear stress goes.",
         "PHYSICS 7"),
    WHOLE(steady_blocks, CLOD_FROM(3, 64), "5",
          "Number of blocks in a row that must agree for preshear to count as steady.",
          "PHYSICS 7"),
    REAL(steady_tolerance, "1", CLOD_ABOVE(0, 1), "2 %",
         "How well the blocks must agree, relative to their mean.", "PHYSICS 7"),
    REAL(preshear_max, "m", CLOD_ABOVE(0, 100), "120 mm",
         "Preshear stops here at the latest and the result says that it was not steady.",
         "PHYSICS 7"),
    REAL(shear_max, "m", CLOD_ABOVE(0, 100), "15 mm",
         "Longest shear of a point in search of its peak.", "PHYSICS 7"),
    REAL(beyond_peak, "m", CLOD_ABOVE(0, 100), "2 mm",
         "Shear that is recorded beyond the peak.", "PHYSICS 7"),
    REAL(
        peak_window, "m", CLOD_ABOVE(0, 1), "0.2 mm",
        "Shear over which the curve is smoothed to find its peak. A wide window lowers a sharp "
        "peak, a narrow one takes noise for it: compare 0.2 and 1 mm.",
        "PHYSICS 7; docs/theory/ring-shear.md"),
    WHOLE(
        seeds, CLOD_FROM(1, 1000), "1",
        "Number of repeats with seed, seed + 1, ...; from two on the error bars come from the "
        "scatter between them, with one from the points about their line.",
        "PHYSICS 7"),
};

const clod_table CLOD_TABLE_RING_SHEAR = {.title = "Virtual Schulze ring shear test.",
                                          CLOD_ROWS(ROWS)};
