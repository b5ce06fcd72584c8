/**
 * @file params_ring_shear.c
 * Table of the virtual Schulze ring shear test.
 */

#include "config/params_programme.h"
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
static const clod_table RADIUS_TABLE = CLOD_TESTER_RADIUS_TABLE(RADIUS);

static const clod_param ROWS[] = {
    CLOD_TESTER_MATERIAL(R, grain_material, "Material of the grains.", "ore"),
    CLOD_TESTER_MATERIAL(R, side_material, "Material of the inner and outer side walls.",
                         "side"),
    CLOD_TESTER_MATERIAL(R, base_material, "Material of the base and its bars.", "base"),
    CLOD_TESTER_MATERIAL(R, lid_material, "Material of the lid and its bars.", "base"),
    CLOD_TESTER_RADIUS(RADIUS_TABLE),
    REAL(inner_radius, "m", CLOD_ABOVE(0, 10), "50 mm", "Inner radius of the annulus.",
         "docs/theory/ring-shear.md (RST-01)"),
    REAL(outer_radius, "m", CLOD_ABOVE(0, 10), "100 mm", "Outer radius of the annulus.",
         "docs/theory/ring-shear.md (RST-01)"),
    REAL(depth, "m", CLOD_ABOVE(0, 10), "40 mm", "Height of the specimen that filling aims at.",
         "docs/theory/ring-shear.md (RST-01)"),
    WHOLE(bar_count, CLOD_FROM(0, 1000), "20",
          "Radial bars on the lid, and as many on the base.",
          "docs/theory/ring-shear.md (RST-01)"),
    REAL(bar_height, "m", CLOD_ABOVE(0, 1), "6.35 mm",
         "Height of a bar; at least one grain diameter grips well.",
         "docs/theory/ring-shear.md"),
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
     .source = "docs/theory/ring-shear.md"},
    CLOD_TESTER_LID(R),
    CLOD_TESTER_FILLING(R, "depth", is_filled_by_depth, "4000"),
    CLOD_PROGRAMME_STRESSES(R),
    CLOD_PROGRAMME_REAL(R, speed, "m/s", "30 mm/s",
                        "Speed of shear at the mean radius r_m; the inertial number should "
                        "stay below 1e-3.",
                        "docs/theory/time-step.md, ring-shear.md", CLOD_ABOVE(0, 1)),
    CLOD_PROGRAMME_REAL(
        R, block_displacement, "m", "2 mm",
        "Shear displacement at r_m over which one block average of the shear stress goes.",
        "docs/theory/ring-shear.md", CLOD_ABOVE(0, 1)),
    CLOD_PROGRAMME_STEADY(R),
    CLOD_PROGRAMME_PRESHEAR(R, "12 mm", "25 mm",
                            "Its length is our choice; no source gives one for a ring."),
    CLOD_PROGRAMME_WAYS(R, "15 mm", "2 mm", "1 mm",
                        "A cell of some thousand grains slips and sticks over 0.5 to 2 mm."),
    CLOD_PROGRAMME_SEEDS(R),
};

const clod_table CLOD_TABLE_RING_SHEAR = {.title = "Virtual Schulze ring shear test.",
                                          CLOD_ROWS(ROWS)};
