/**
 * @file params_wall_friction.c
 * Table of the virtual wall friction test.
 */

#include "config/params_radius.h"
#include "config/params_tester.h"
#include "config/wall_cells.h"

#define W clod_case_wall_friction

#define REAL(name, si, range, value, text, where)                                              \
    CLOD_TESTER_REAL(W, name, si, value, text, where, range)
#define WHOLE(name, range, value, text)                                                        \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_INTEGER, .need = CLOD_PARAM_OPTIONAL, .unit = "1",    \
        range, .fallback = value, CLOD_AT(W, name), .help = text,                              \
        .source = "docs/theory/wall-friction.md"                                               \
    }
/** A length that not every cell has. */
#define OF_SOME(name, range, value, when, why, text, where)                                    \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_REAL, .need = CLOD_PARAM_OPTIONAL, .unit = "m",       \
        range, .fallback = value, CLOD_AT(W, name), .used = when, .unused = why, .help = text, \
        .source = where                                                                        \
    }

static bool is_annulus(const clod_case *whole, const void *self)
{
    (void)whole;
    return clod_wall_cell_of(self)->annulus;
}

static bool may_have_bars(const clod_case *whole, const void *self)
{
    (void)whole;
    return clod_wall_cell_of(self)->bars;
}

static bool has_bars(const clod_case *whole, const void *self)
{
    (void)whole;
    return clod_wall_cell_bars(self) > 0;
}

static bool has_ridges(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->plate_ridges.height != 0.0;
}

static bool is_filled_by_depth(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const W *)self)->grain_count == 0;
}

static const clod_param RADIUS[] = {CLOD_RADIUS_ROWS(W, CLOD_PARAM_REQUIRED)};
static const clod_table RADIUS_TABLE = CLOD_TESTER_RADIUS_TABLE(RADIUS);

#define RIDGE(name, needed, range, text, more)                                                 \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_REAL, .need = (needed), .unit = "m", range, more,     \
        CLOD_AT(clod_case_ridges, name), .help = text,                                         \
        .source = "docs/theory/wall-friction.md#a-plate-with-ridges"                           \
    }

static const clod_param RIDGES[] = {
    RIDGE(height, CLOD_PARAM_REQUIRED, CLOD_ABOVE(0, 1),
          "Height of a crest above the floor between the ridges: the roughness height Rz of "
          "the plate.",
          .example = "2 mm"),
    RIDGE(spacing, CLOD_PARAM_REQUIRED, CLOD_ABOVE(0, 1),
          "From crest to crest along the way of the plate; in a ring at the mean radius r_m, "
          "and the ridges are the whole number that comes nearest.",
          .example = "6 mm"),
    {.key = "width",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1),
     .zero_word = "auto",
     .fallback = "auto",
     .example = "3 mm",
     CLOD_AT(clod_case_ridges, width),
     .help = "Width of a ridge at its foot, or auto: the ridges meet, in a ring at its inner "
             "wall. Flanks rise at 2 height/(width - crest).",
     .source = "docs/theory/wall-friction.md#a-plate-with-ridges"},
    RIDGE(crest, CLOD_PARAM_OPTIONAL, CLOD_FROM(0, 1),
          "Width of a ridge's flat top: 0 is an edge, the width itself an upright bar.",
          .fallback = "0 mm"),
};
static const clod_table RIDGES_TABLE = {
    .title = "Ridges across the way of the plate: its geometrical roughness.",
    CLOD_ROWS(RIDGES)};

static const clod_param ROWS[] = {
    CLOD_TESTER_MATERIAL(W, grain_material, "Material of the grains.", "ore"),
    CLOD_TESTER_MATERIAL(W, side_material, "Material of the side walls.", "side"),
    CLOD_TESTER_MATERIAL(W, plate_material,
                         "Material of the plate below, the wall whose friction is measured.",
                         "plate"),
    CLOD_TESTER_MATERIAL(W, lid_material, "Material of the lid and its bars.", "base"),
    CLOD_TESTER_RADIUS(RADIUS_TABLE),
    {.key = "cell",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = CLOD_WALL_CELL_NAMES,
     .fallback = "ring",
     CLOD_AT(W, cell),
     .help = "ring: an annulus whose plate turns, as in a ring shear tester. straight: a round "
             "ring whose plate moves along x, as in a Jenike tester.",
     .source = "docs/theory/wall-friction.md#cell"},
    OF_SOME(inner_radius, CLOD_ABOVE(0, 10), "50 mm", is_annulus,
            "a straight cell has no inner radius; remove this key",
            "Inner radius of the annulus.", "docs/theory/ring-shear.md (RST-01)"),
    REAL(outer_radius, "m", CLOD_ABOVE(0, 10), "100 mm",
         "Outer radius of the annulus, or inner radius of the straight cell's ring.",
         "docs/theory/ring-shear.md (RST-01)"),
    REAL(depth, "m", CLOD_ABOVE(0, 10), "25 mm",
         "Height of the specimen that filling aims at: a flat one, for the side walls carry "
         "less of the load.",
         "docs/theory/wall-friction.md"),
    {.key = "bar_count",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1000),
     .fallback = "20",
     CLOD_AT(W, bar_count),
     .used = may_have_bars,
     .unused =
         "the ring of a straight cell holds the solid, its lid has no bars; remove this key",
     .help =
         "Radial bars on the lid, which hold the solid; those of the plate are its plate_ridges.",
     .source = "docs/theory/ring-shear.md (RST-01)"},
    OF_SOME(bar_height, CLOD_ABOVE(0, 1), "6.35 mm", has_bars,
            "there are no bars; remove this key",
            "Height of a bar; at least one grain diameter grips well.",
            "docs/theory/ring-shear.md"),
    OF_SOME(bar_width, CLOD_ABOVE(0, 1), "3 mm", has_bars, "there are no bars; remove this key",
            "Thickness of a bar.", "docs/theory/ring-shear.md"),
    {.key = "plate_ridges",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &RIDGES_TABLE,
     CLOD_AT(W, plate_ridges),
     .used = has_ridges,
     .help = "Geometrical roughness of the plate; without it the plate is flat, and its "
             "roughness is the friction of its contacts alone.",
     .source = "docs/theory/wall-friction.md#a-plate-with-ridges"},
    CLOD_TESTER_LID(W),
    CLOD_TESTER_FILLING(W, "depth", is_filled_by_depth, "2000"),
    {.key = "wall_stresses",
     .kind = CLOD_PARAM_REALS,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "Pa",
     CLOD_FROM(1, 1e8),
     .example = "[20 kPa, 16 kPa, 12 kPa, 8 kPa, 4 kPa]",
     CLOD_AT(W, wall_stresses),
     CLOD_COUNT(W, wall_stress_count),
     .help =
         "Normal stresses on the plate, two to sixteen of them: the specimen is consolidated "
         "and sheared at the largest, and sheared on at each lower one in turn.",
     .source = "docs/theory/wall-friction.md#programme"},
    REAL(speed, "m/s", CLOD_ABOVE(0, 1), "30 mm/s",
         "Speed of the plate at the largest stress, in a ring at r_m; at a lower stress it "
         "falls with its square root.",
         "docs/theory/time-step.md, wall-friction.md"),
    REAL(block_displacement, "m", CLOD_ABOVE(0, 1), "1 mm",
         "Shear displacement over which one block average of the shear stress goes; as much is "
         "sheared at each stress before the blocks count.",
         "docs/theory/wall-friction.md"),
    WHOLE(steady_blocks, CLOD_FROM(3, 64), "5",
          "Number of blocks in a row that must agree for a wall shear stress to count as "
          "steady."),
    REAL(steady_tolerance, "1", CLOD_ABOVE(0, 1), "2 %",
         "How well the blocks must agree, relative to their mean.",
         "docs/theory/wall-friction.md"),
    REAL(shear_min, "m", CLOD_FROM(0, 100), "5 mm",
         "Each stress is sheared by this much even when the shear stress is level already.",
         "docs/theory/wall-friction.md"),
    REAL(
        shear_max, "m", CLOD_ABOVE(0, 100), "20 mm",
        "Shear at each stress stops here at the latest; when the shear stress is not steady by "
        "then, the result tells how fast it still changes.",
        "docs/theory/wall-friction.md"),
    WHOLE(seeds, CLOD_FROM(1, 1000), "1",
          "Number of repeats with seed, seed + 1, ...; from two on the error bars come from "
          "the scatter between them, with one from the points about their line."),
};

const clod_table CLOD_TABLE_WALL_FRICTION = {
    .title =
        "Virtual wall friction test: a specimen sheared on a plate of the wall's material.",
    CLOD_ROWS(ROWS)};
