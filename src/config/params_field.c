/**
 * @file params_field.c
 * Table of fields: density, velocity and stress on grids or as means over regions.
 */

#include "config/param.h"
#include "config/region.h"

#define F clod_case_field

static bool has_cell(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const F *)self)->cell > 0.0;
}

/** Whether it is a mean over a disc or ring, which has an axis. */
static bool has_axis(const clod_case *whole, const void *self)
{
    return !has_cell(whole, self) && clod_region_row(&((const F *)self)->region)->upright;
}

static const char *const COMPONENTS[] = {[CLOD_COMPONENTS_CARTESIAN] = "cartesian",
                                         [CLOD_COMPONENTS_CYLINDRICAL] = "cylindrical",
                                         [CLOD_COMPONENTS_CYLINDRICAL + 1] = NULL};

static const clod_param FIELD[] = {
    {.key = "region",
     .kind = CLOD_PARAM_SECTION,
     .need = CLOD_PARAM_REQUIRED,
     .table = &CLOD_TABLE_REGION,
     CLOD_AT(F, region),
     .example = "{box: {min: [0 m, 0 m, 0 m], max: [0.2 m, 0.2 m, 0.1 m]}}",
     .help = "Where is measured. A grid needs a box, which is cut into cells from its least "
             "corner on; in periodic directions it lies within the domain.",
     .source = "docs/fields.md"},
    {.key = "cell",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "10 mm",
     CLOD_AT(F, cell),
     .used = has_cell,
     .help =
         "Edge of a cell: values are those at the middles of the cells, in "
         "field_NAME.hdf, of each part of a test in PART_field_NAME.hdf. Without it the field is one mean over the region, in the series.",
     .source = "docs/fields.md"},
    {.key = "width",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "m",
     CLOD_ABOVE(0, 1e4),
     .example = "20 mm",
     CLOD_AT(F, width),
     .used = has_cell,
     .help = "Radius of Lucy's kernel, with which grains and contacts are spread over a grid: "
             "nothing reaches further. Two to four grain diameters show a continuum, less "
             "shows layers of grains.",
     .source = "docs/fields.md"},
    {.key = "interval",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "s",
     CLOD_ABOVE(0, 1e6),
     .fallback = "10 ms",
     .example = "20 ms",
     CLOD_AT(F, interval),
     .help = "Simulated time from one sample to the next; a test takes them at its rows.",
     .source = "docs/fields.md"},
    {.key = "frames",
     .kind = CLOD_PARAM_BOOL,
     .need = CLOD_PARAM_OPTIONAL,
     .fallback = "false",
     .example = "true",
     CLOD_AT(F, frames),
     .used = has_cell,
     .help = "Whether the grid as it is at each snapshot is written too, for a film.",
     .source = "docs/fields.md"},
    {.key = "components",
     .kind = CLOD_PARAM_CHOICE,
     .need = CLOD_PARAM_OPTIONAL,
     .choices = COMPONENTS,
     .fallback = "cartesian",
     CLOD_AT(F, components),
     .used = has_axis,
     .unused = "only a mean over an annulus has an axis; give it one, or remove this key",
     .help = "Along which directions velocities, stresses and forces are told: x, y, z, or "
             "radius r, direction of turning t and height z, about the axis of the annulus. "
             "What turns has no mean velocity along x.",
     .source = "docs/fields.md"},
};
const clod_table CLOD_TABLE_FIELD = {
    .title = "Fields, by name: density, velocity, stress and more, on a grid or as means.",
    CLOD_ROWS(FIELD),
    .size = sizeof(F)};
