#pragma once
/**
 * @file unit_endings.h
 * How the name of a number in a file ends, and the unit that this means: the one table for whoever reads
 * such names.
 */

/** An ending, and the unit that a page shows. */
typedef struct clod_unit_ending {
    const char *ending, *unit;
} clod_unit_ending;

#define CLOD_UNIT_ENDINGS_DEGREE 57.295779513082321 ///< 180/pi

/** ROW(ending, SI unit, unit of the number, SI -> that unit) for each, the longer before those that it
 *  ends with. */
#define CLOD_UNIT_ENDINGS(ROW)                                                                 \
    ROW("_m2_per_s2", "m2/s2", "m2/s2", 1.0)                                                   \
    ROW("_kg_per_m3", "kg/m3", "kg/m3", 1.0)                                                   \
    ROW("_N_per_m3", "N/m3", "N/m3", 1.0)                                                      \
    ROW("_m3_per_s", "m3/s", "m3/s", 1.0)                                                      \
    ROW("_kg_per_s", "kg/s", "kg/s", 1.0)                                                      \
    ROW("_N_per_s", "N/s", "N/s", 1.0)                                                         \
    ROW("_m_per_s", "m/s", "m/s", 1.0)                                                         \
    ROW("_kg_m3", "kg/m3", "kg/m3", 1.0)                                                       \
    ROW("_per_s", "1/s", "1/s", 1.0)                                                           \
    ROW("_deg", "rad", "deg", CLOD_UNIT_ENDINGS_DEGREE)                                        \
    ROW("_rad", "rad", "rad", 1.0)                                                             \
    ROW("_m2", "m2", "m2", 1.0)                                                                \
    ROW("_m3", "m3", "m3", 1.0)                                                                \
    ROW("_kg", "kg", "kg", 1.0)                                                                \
    ROW("_Pa", "Pa", "Pa", 1.0)                                                                \
    ROW("_Nm", "N m", "N m", 1.0)                                                              \
    ROW("_N", "N", "N", 1.0)                                                                   \
    ROW("_J", "J", "J", 1.0)                                                                   \
    ROW("_W", "W", "W", 1.0)                                                                   \
    ROW("_s", "s", "s", 1.0)                                                                   \
    ROW("_m", "m", "m", 1.0)
