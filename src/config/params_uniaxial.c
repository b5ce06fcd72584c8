/**
 * @file params_uniaxial.c
 * Table of the virtual uniaxial test.
 */

#include "config/params_radius.h"
#include "config/params_tester.h"

#define U clod_case_uniaxial

#define REAL(name, si, range, value, text, where)                                              \
    CLOD_TESTER_REAL(U, name, si, value, text, where, range)

static bool is_filled_by_height(const clod_case *whole, const void *self)
{
    (void)whole;
    return ((const U *)self)->grain_count == 0;
}

static const clod_param RADIUS[] = {CLOD_RADIUS_ROWS(U, CLOD_PARAM_REQUIRED)};
static const clod_table RADIUS_TABLE = CLOD_TESTER_RADIUS_TABLE(RADIUS);

static const clod_param ROWS[] = {
    CLOD_TESTER_MATERIAL(U, grain_material, "Material of the grains.", "ore"),
    CLOD_TESTER_MATERIAL(U, side_material, "Material of the mould, the side wall.", "side"),
    CLOD_TESTER_MATERIAL(U, base_material, "Material of the base.", "base"),
    CLOD_TESTER_MATERIAL(U, lid_material, "Material of the lid.", "base"),
    CLOD_TESTER_RADIUS(RADIUS_TABLE),
    REAL(diameter, "m", CLOD_ABOVE(0, 10), "80 mm", "Inner diameter of the mould.",
         "our choice; at least ten grains of 6.35 mm across"),
    REAL(height, "m", CLOD_ABOVE(0, 10), "100 mm",
         "Height of the specimen that filling aims at; 1 to 2 diameters is usual.",
         "our choice"),
    CLOD_TESTER_LID(U),
    CLOD_TESTER_FILLING(U, "height", is_filled_by_height, "2000"),
    {.key = "consolidation_stresses",
     .kind = CLOD_PARAM_REALS,
     .need = CLOD_PARAM_REQUIRED,
     .unit = "Pa",
     CLOD_FROM(10, 1e8),
     .example = "[20 kPa, 50 kPa]",
     CLOD_AT(U, consolidation_stresses),
     CLOD_COUNT(U, consolidation_stress_count),
     .help = "Axial stresses of consolidation under the lid; each is a point of the flow "
             "function, made from the same filled mould.",
     .source = "docs/theory/uniaxial.md"},
    REAL(speed, "m/s", CLOD_ABOVE(0, 1), "10 mm/s",
         "Speed of the lid while it unloads and crushes; the inertial number should stay below "
         "1e-3.",
         "docs/theory/time-step.md"),
    REAL(crush_max, "1", CLOD_ABOVE(0, 0.9), "15 %",
         "Axial strain at most in search of the peak.", "docs/theory/uniaxial.md"),
    REAL(beyond_peak, "1", CLOD_ABOVE(0, 0.9), "2 %",
         "Axial strain that is recorded beyond the peak.", "docs/theory/uniaxial.md"),
};

const clod_table CLOD_TABLE_UNIAXIAL = {
    .title = "Virtual uniaxial test: consolidated in a mould, crushed without it.",
    CLOD_ROWS(ROWS)};
