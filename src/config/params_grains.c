/**
 * @file params_grains.c
 * Tables of grains: sizes, amounts, where they are put.
 */

#include "config/param.h"
#include "config/params_corner.h"
#include "config/params_radius.h"

#define G clod_case_grains
#define R clod_case_region
#define I clod_case_inlet

static const char *const DISTRIBUTIONS[] = {
    [CLOD_SIZE_NORMAL] = "normal", [CLOD_SIZE_UNIFORM] = "uniform", NULL};

static const clod_param RADIUS[] = {
    {.key = "distribution",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = DISTRIBUTIONS,
     .fallback = "normal",
     CLOD_AT(G, sizes),
     .help = "Distribution by number: normal, cut to [min, max], or uniform between them.",
     .source = "docs/theory/copper-ore.md"},
    CLOD_RADIUS_ROWS(G, CLOD_PARAM_OPTIONAL),
};
static const clod_table RADIUS_TABLE = {.title = "Radii drawn by number.", CLOD_ROWS(RADIUS)};

static const clod_param SIEVE[] = {
    {.key = "size",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_FROM(2e-9, 10),
     .example = "6.3 mm",
     CLOD_AT(clod_case_sieve, size),
     .help = "Opening of the sieve; grains just passing have this diameter.",
     .source = "ISO 3310"},
    {.key = "passing",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "1",
     CLOD_FROM(0, 1),
     .example = "45 %",
     CLOD_AT(clod_case_sieve, passing),
     .help = "Fraction of the whole mass that passes this sieve.",
     .source = "ISO 3310"},
};
static const clod_table SIEVE_TABLE = {
    .title = "One sieve.", CLOD_ROWS(SIEVE), .size = sizeof(clod_case_sieve)};

static const clod_param SIZES[] = {
    {.key = "sieve",
     .kind = CLOD_PARAM_LIST,
     .need = CLOD_PARAM_REQUIRED,
     .table = &SIEVE_TABLE,
     CLOD_AT(G, sieve),
     CLOD_COUNT(G, sieve_count),
     .help = "Sieve analysis by mass, fine to coarse, from 0 % to 100 % passing.",
     .source = "ISO 3310"},
};
static const clod_table SIZES_TABLE = {.title = "Sizes by mass.", CLOD_ROWS(SIZES)};

static const clod_param BOX[] = {
    CLOD_CORNER_ROW("min", "smallest", R, min, "[0 mm, 0 mm, 0 mm]"),
    CLOD_CORNER_ROW("max", "largest", R, max, "[50 mm, 50 mm, 80 mm]"),
};
static const clod_table BOX_TABLE = {.title = "A box along x, y, z.", CLOD_ROWS(BOX)};

static const clod_param ANNULUS[] = {
    {.key = "center",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .fallback = "0 0 0 m",
     CLOD_AT(R, center),
     .help = "Centre of the bottom; the axis points along z.",
     .source = "convention"},
    {.key = "inner_radius",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(0, 1e4),
     .fallback = "0 m",
     CLOD_AT(R, inner_radius),
     .help = "Inner radius; 0 is a full cylinder.",
     .source = "convention"},
    {.key = "outer_radius",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "100 mm",
     CLOD_AT(R, outer_radius),
     .help = "Outer radius.",
     .source = "convention"},
    {.key = "height",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "80 mm",
     CLOD_AT(R, height),
     .help = "Height above the bottom.",
     .source = "convention"},
};
static const clod_table ANNULUS_TABLE = {.title = "An upright annulus or cylinder.",
                                         CLOD_ROWS(ANNULUS)};

static const clod_param DISC[] = {
    {.key = "center",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .example = "[0 mm, 0 mm, 2 m]",
     CLOD_AT(R, center),
     .help = "Centre.",
     .source = "convention"},
    {.key = "radius",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "100 mm",
     CLOD_AT(R, outer_radius),
     .help = "Radius.",
     .source = "convention"},
    {.key = "normal",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .example = "[0, 0, -1]",
     CLOD_AT(R, normal),
     .help = "Direction across the disc, to the side on which the grains come in.",
     .source = "convention"},
};
static const clod_table DISC_TABLE = {
    .title = "A disc through which the grains of an inlet come.", CLOD_ROWS(DISC)};

#define EDGE(name, text)                                                                       \
    {                                                                                          \
        .key = #name, .kind = CLOD_PARAM_VECTOR, .length = 3, .need = CLOD_PARAM_REQUIRED,     \
        .unit = "m", CLOD_FROM(-1e4, 1e4), .nonzero = true, .example = text, CLOD_AT(R, name), \
        .help = "An edge, as a vector of its length; across the other one.",                   \
        .source = "convention"                                                                 \
    }

static const clod_param RECTANGLE[] = {
    {.key = "center",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .example = "[0 mm, 0 mm, 2 m]",
     CLOD_AT(R, center),
     .help = "Centre.",
     .source = "convention"},
    EDGE(edge_1, "[0.4 m, 0 m, 0 m]"),
    EDGE(edge_2, "[0 m, 0.2 m, 0 m]"),
};
static const clod_table RECTANGLE_TABLE = {
    .title = "A rectangle through which the grains of an inlet come.", CLOD_ROWS(RECTANGLE)};

#define REGION_ROW(name, sub, field_help)                                                      \
    {                                                                                          \
        .key = name, .kind = CLOD_PARAM_SECTION, .need = CLOD_PARAM_OPTIONAL, .table = &(sub), \
        .help = field_help, .source = "convention"                                             \
    }

// in the order of clod_region_kind
static const clod_param PLACE[] = {
    REGION_ROW("box", BOX_TABLE, "A box along x, y, z."),
    REGION_ROW("annulus", ANNULUS_TABLE, "An upright annulus or cylinder."),
    REGION_ROW("disc", DISC_TABLE, "A disc through which the grains of an inlet come."),
    REGION_ROW("rectangle", RECTANGLE_TABLE,
               "A rectangle through which the grains of an inlet come."),
};
static const clod_table PLACE_TABLE = {.title = "Where grains are put: one of these.",
                                       CLOD_ROWS(PLACE),
                                       .one_of = true,
                                       .kind = offsetof(R, kind)};

static const clod_param REGION[] = {
    REGION_ROW("box", BOX_TABLE, "A box along x, y, z."),
    REGION_ROW("annulus", ANNULUS_TABLE, "An upright annulus or cylinder."),
};
const clod_table CLOD_TABLE_REGION = {.title = "A region: one of these.",
                                      CLOD_ROWS(REGION),
                                      .one_of = true,
                                      .kind = offsetof(R, kind)};

static bool has_radius(const clod_case *whole, const void *self)
{
    (void)whole;
    const G *grains = self;
    return grains->file == NULL && grains->sizes != CLOD_SIZE_SIEVE;
}

static bool has_sieve(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const G *)self)->sizes == CLOD_SIZE_SIEVE;
}

static bool has_region(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const G *)self)->file == NULL;
}

static bool has_fill_height(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const G *)self)->fill_height > 0.0;
}

static bool comes(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const G *)self)->comes;
}

static const clod_param INLET[] = {
    {.key = "mass_flow",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "kg/s",
     CLOD_ABOVE(0, 1e9),
     .example = "250 t/h",
     CLOD_AT(I, mass_flow),
     .help = "Mass that comes in a time (one of mass_flow, number_flow).",
     .source = "docs/inlets.md"},
    {.key = "number_flow",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1/s",
     CLOD_ABOVE(0, 1e12),
     .example = "2000 1/s",
     CLOD_AT(I, number_flow),
     .help = "Grains that come in a time (one of mass_flow, number_flow).",
     .source = "docs/inlets.md"},
    {.key = "start",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_FROM(0, 1e9),
     .fallback = "0 s",
     CLOD_AT(I, start),
     .help = "Time at which the first grain is due.",
     .source = "docs/inlets.md"},
    {.key = "end",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_ABOVE(0, 1e9),
     .example = "5 s",
     CLOD_AT(I, end),
     .help = "Time from which on no more are due; without it they come until the run ends.",
     .source = "docs/inlets.md"},
};
static const clod_table INLET_TABLE = {
    .title = "An inlet: the grains of the group come during the run.", CLOD_ROWS(INLET)};

static const clod_param GRAINS[] = {
    {.key = "material",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "ore",
     CLOD_AT(G, material),
     .help = "Name of a material; with a file it may stand there instead.",
     .source = "convention"},
    {.key = "count",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(1, 1e9),
     .example = "4000",
     CLOD_AT(G, count),
     .help = "Number of grains (one of count, mass, fill_height, file).",
     .source = "convention"},
    {.key = "mass",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "kg",
     CLOD_ABOVE(0, 1e9),
     .example = "1.2 kg",
     CLOD_AT(G, mass),
     .help = "Mass of all grains together (one of count, mass, fill_height, file).",
     .source = "convention"},
    {.key = "fill_height",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "40 mm",
     CLOD_AT(G, fill_height),
     .help = "Height of the bed after settling, from the region's base area and fill_fraction "
             "(one of count, mass, fill_height, file).",
     .source = "convention"},
    {.key = "fill_fraction",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0.05, 0.74),
     .fallback = "0.6",
     CLOD_AT(G, fill_fraction),
     .used = has_fill_height,
     .unused = "only fill_height asks for it; remove this key",
     .help = "Solid fraction assumed for fill_height.",
     .source = "convention"},
    {.key = "file",
     .kind = CLOD_PARAM_FILE,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "grains.csv",
     CLOD_AT(G, file),
     .help = "CSV with one grain a row (one of count, mass, fill_height, file). The first line "
             "names the columns in any order, each quantity with its unit: x [mm], y [mm], "
             "z [mm], radius [mm] and, when wanted, vx [m/s], vy [m/s], vz [m/s], wx [rad/s], "
             "wy [rad/s], wz [rad/s], id, material. Lines that begin with # are skipped.",
     .source = "convention"},
    {.key = "radius",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &RADIUS_TABLE,
     .used = has_radius,
     .help = "Grain radii by number (one of radius, sizes).",
     .source = "docs/theory/copper-ore.md"},
    {.key = "sizes",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &SIZES_TABLE,
     .used = has_sieve,
     .help = "Grain sizes by mass (one of radius, sizes).",
     .source = "ISO 3310"},
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &PLACE_TABLE,
     CLOD_AT(G, region),
     .used = has_region,
     .help = "Where grains are put, at random and without overlap: a box or an annulus, or "
             "a disc or rectangle through which those of an inlet come.",
     .source = "convention"},
    {.key = "inlet",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &INLET_TABLE,
     CLOD_AT(G, inlet),
     .given = offsetof(G, comes),
     .used = comes,
     .help = "Lets the grains come during the run, into the region, and no more than count or "
             "mass, where one of them is given.",
     .source = "docs/inlets.md"},
    {.key = "velocity",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m/s",
     CLOD_FROM(-1e3, 1e3),
     .fallback = "0 0 0 m/s",
     CLOD_AT(G, velocity),
     .used = has_region,
     .help = "Velocity of every grain of this group at the start.",
     .source = "convention"},
};

const clod_table CLOD_TABLE_GRAINS = {
    .title = "Groups of grains.", CLOD_ROWS(GRAINS), .size = sizeof(G)};

static bool removes_in_region(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const clod_case_outlet *)self)->has_region;
}

static const clod_param OUTLET[] = {
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_OPTIONAL,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(clod_case_outlet, region),
     .given = offsetof(clod_case_outlet, has_region),
     .used = removes_in_region,
     .help =
         "Where grains are removed: when their centre is in it. Thicker than a grain (one of "
         "region, wall).",
     .source = "docs/inlets.md"},
    {.key = "wall",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "exit",
     CLOD_AT(clod_case_outlet, wall),
     .help = "Name of a wall: grains that touch it are removed, and it does not push them (one "
             "of region, wall).",
     .source = "docs/inlets.md"},
    {.key = "part",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "mouth",
     CLOD_AT(clod_case_outlet, part),
     .help = "A part of the wall's mesh by its name (clod mesh FILE lists them); without it "
             "all of the wall removes grains.",
     .source = "docs/inlets.md"},
    {.key = "spillage",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     CLOD_AT(clod_case_outlet, spillage),
     .help = "Whether what leaves here has missed its way; the balance tells it apart.",
     .source = "docs/gauges.md"},
};
const clod_table CLOD_TABLE_OUTLET = {
    .title = "Outlets, by name: regions and surfaces where grains are removed and counted.",
    CLOD_ROWS(OUTLET),
    .size = sizeof(clod_case_outlet)};
