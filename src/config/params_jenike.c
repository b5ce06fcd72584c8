/**
 * @file params_jenike.c
 * Table of the virtual Jenike shear test.
 */

#include "config/params_programme.h"
#include "config/params_radius.h"
#include "config/params_tester.h"
#include "config/unit.h"

#define J clod_case_jenike

#define REAL(name, si, range, value, text, where)                                              \
    CLOD_TESTER_REAL(J, name, si, value, text, where, range)

static bool is_filled_by_height(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const J *)self)->grain_count == 0;
}

static bool is_twisted(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const J *)self)->twists > 0;
}

static const clod_param RADIUS[] = {CLOD_RADIUS_ROWS(J, CLOD_PARAM_REQUIRED)};
static const clod_table RADIUS_TABLE = CLOD_TESTER_RADIUS_TABLE(RADIUS);

static const clod_param ROWS[] = {
    CLOD_TESTER_MATERIAL(J, grain_material, "Material of the grains.", "ore"),
    CLOD_TESTER_MATERIAL(J, side_material, "Material of base ring and shear ring.", "side"),
    CLOD_TESTER_MATERIAL(J, base_material, "Material of the floor of the base ring.", "base"),
    CLOD_TESTER_MATERIAL(J, lid_material, "Material of the lid.", "base"),
    CLOD_TESTER_RADIUS(RADIUS_TABLE),
    REAL(diameter, "m", CLOD_ABOVE(0, 10), "95.25 mm",
         "Inner diameter of base ring and shear ring.", "docs/theory/jenike.md (3.75 in)"),
    REAL(base_height, "m", CLOD_ABOVE(0, 10), "12.7 mm",
         "Inner height of the base ring, from its floor to the shear plane.",
         "common cell, 1/2 in; docs/theory/jenike.md"),
    REAL(ring_height, "m", CLOD_ABOVE(0, 10), "15.9 mm",
         "Height of the shear ring, which filling aims at.",
         "common cell, 5/8 in; docs/theory/jenike.md"),
    REAL(rim, "m", CLOD_ABOVE(0, 10), "3.2 mm",
         "Thickness of the walls of both rings: no grain leaks until the shear ring is as far "
         "from the base ring.",
         "common cell, 1/8 in; docs/theory/jenike.md"),
    REAL(offset, "m", CLOD_FROM(0, 10), "3 mm",
         "How far the shear ring begins behind the base ring; it ends as far before it when "
         "preshear_max + shear_max is twice as much.",
         "common cell; docs/theory/jenike.md"),
    {.key = "twists",
     .kind = CLOD_PARAM_INTEGER,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "1",
     CLOD_FROM(0, 1000),
     .fallback = "0",
     CLOD_AT(J, twists),
     .help = "Times that the lid is twisted to and fro under preshear_stress before preshear, "
             "as the operator of a real cell does to come near the critical state.",
     .source = "docs/theory/jenike.md#procedure"},
    {.key = "twist_angle",
     .kind = CLOD_PARAM_REAL,
     .need = CLOD_PARAM_OPTIONAL,
     .unit = "rad",
     CLOD_ABOVE(0, 180 * CLOD_UNIT_DEGREE),
     .fallback = "10 deg",
     CLOD_AT(J, twist_angle),
     .used = is_twisted,
     .unused = "twists is 0: the lid is not twisted; remove this key",
     .help = "Angle of a twist, to each side; the edge of the lid moves with `speed`.",
     .source = "our choice"},
    CLOD_TESTER_LID(J),
    CLOD_TESTER_FILLING(J, "rings", is_filled_by_height, "900"),
    CLOD_PROGRAMME_STRESSES(J),
    CLOD_PROGRAMME_REAL(J, speed, "m/s", "10 mm/s",
                        "Speed of the shear ring; the inertial number should stay below 1e-3.",
                        "docs/theory/time-step.md, jenike.md", CLOD_ABOVE(0, 1)),
    CLOD_PROGRAMME_REAL(J, block_displacement, "m", "0.2 mm",
                        "Shear displacement over which one block average of the shear stress "
                        "goes.",
                        "docs/theory/jenike.md", CLOD_ABOVE(0, 1)),
    CLOD_PROGRAMME_STEADY(J),
    CLOD_PROGRAMME_PRESHEAR(
        J, "1 mm", "4 mm",
        "The displacement of a Jenike cell is limited by its offset and rim."),
    CLOD_PROGRAMME_WAYS(J, "2 mm", "0.4 mm", "0.1 mm",
                        "The displacement of a Jenike cell is too short for more."),
    CLOD_PROGRAMME_SEEDS(J),
};

const clod_table CLOD_TABLE_JENIKE = {
    .title = "Virtual Jenike shear test: a ring on a base ring, sheared straight.",
    CLOD_ROWS(ROWS)};
