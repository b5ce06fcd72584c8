/**
 * @file params_mixing.c
 * Tables of mixing indices and angles of repose.
 */

#include "config/param.h"

#define M clod_case_mixing
#define A clod_case_repose

static const char *const BY[] = {[CLOD_MIXING_BY_NUMBER] = "number",
                                 [CLOD_MIXING_BY_MASS] = "mass",
                                 [CLOD_MIXING_BY_MASS + 1] = NULL};

static bool has_material(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const M *)self)->material != NULL;
}

static bool has_above(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const M *)self)->above > 0.0;
}

static const clod_param MIXING[] = {
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_REQUIRED,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(M, region),
     .example = "{box: {min: [0 m, 0 m, 0 m], max: [0.2 m, 0.2 m, 0.1 m]}}",
     .help = "Grains count whose centre is in it. The box about it is cut into cells from its "
             "least corner on: the samples.",
     .source = "docs/mixing.md"},
    {.key = "cell",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "20 mm",
     CLOD_AT(M, cell),
     .help = "Edge of a sample: the scale on which the mixture is judged. Ten grains and more "
             "should fit.",
     .source = "Lacey 1954"},
    {.key = "material",
     .kind = CLOD_PARAM_TEXT,
     .need = CLOD_PARAM_OPTIONAL,
     .example = "red",
     CLOD_AT(M, material),
     .used = has_material,
     .help = "Grains of this material are the first kind, all others the second (one of "
             "material, above).",
     .source = "docs/mixing.md"},
    {.key = "above",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "3 mm",
     CLOD_AT(M, above),
     .used = has_above,
     .help = "Grains with a larger radius are the first kind, all others the second (one of "
             "material, above).",
     .source = "docs/mixing.md"},
    {.key = "by",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = BY,
     .fallback = "number",
     .example = "mass",
     CLOD_AT(M, by),
     .help =
         "Whether shares are those of the number of grains or of their mass, as a laboratory "
         "weighs samples.",
     .source = "Lacey 1954; Stange 1954"},
};
const clod_table CLOD_TABLE_MIXING = {
    .title = "Mixing indices, by name.", CLOD_ROWS(MIXING), .size = sizeof(M)};

static bool has_center(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const A *)self)->has_center;
}

static bool has_direction(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const A *)self)->has_direction;
}

static const clod_param REPOSE[] = {
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_REQUIRED,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(A, region),
     .example = "{box: {min: [0 m, 0 m, 0 m], max: [0.2 m, 0.2 m, 0.1 m]}}",
     .help =
         "Grains count whose centre is in it. Heights count from its bottom: let that be the "
         "ground.",
     .source = "docs/mixing.md"},
    {.key = "cell",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "6 mm",
     CLOD_AT(A, cell),
     .help = "Edge of the cells in each of which the highest grain makes the surface: about a "
             "grain diameter.",
     .source = "docs/mixing.md"},
    {.key = "center",
     .kind = CLOD_PARAM_VECTOR,
     .length = 2,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_FROM(-1e4, 1e4),
     .example = "[0 mm, 0 mm]",
     CLOD_AT(A, center),
     .given = offsetof(A, has_center),
     .used = has_center,
     .help = "Axis of a round heap, x and y. Without it the centre of mass of the grains.",
     .source = "docs/mixing.md"},
    {.key = "direction",
     .kind = CLOD_PARAM_VECTOR,
     .length = 3,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(-1e4, 1e4),
     .nonzero = true,
     .example = "[1, 0, 0]",
     CLOD_AT(A, direction),
     .given = offsetof(A, has_direction),
     .used = has_direction,
     .help = "Level direction along which a slope falls, of any length. Without it the heap is "
             "round.",
     .source = "docs/mixing.md"},
    {.key = "from",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1),
     .fallback = "10 %",
     .example = "20 %",
     CLOD_AT(A, from),
     .help = "Height of the flank's lower end over that of the heap.",
     .source = "our choice"},
    {.key = "to",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1),
     .fallback = "75 %",
     .example = "80 %",
     CLOD_AT(A, to),
     .help = "Height of the flank's upper end over that of the heap.",
     .source = "our choice"},
};
const clod_table CLOD_TABLE_REPOSE = {
    .title = "Angles of repose, by name.", CLOD_ROWS(REPOSE), .size = sizeof(A)};
