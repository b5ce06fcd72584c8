#pragma once
/**
 * @file fields.h
 * The numbers of a shape in one table, which drives the writers.
 */

#include "hopper/result.h"

typedef struct clod_hopper_field {
    const char *key;  ///< name in JSON, with unit
    const char *text; ///< for people
    const char *unit; ///< for people
    double scale;     ///< from SI to that unit
    double json;      ///< from SI to the unit of the key
    int digits;
    const char *zero; ///< what people read for 0 and for infinity; NULL: the number, "infinite"
} clod_hopper_field;

/** By clod_hopper_number. */
extern const clod_hopper_field CLOD_HOPPER_FIELDS[CLOD_HOPPER_NUMBERS];

/** Of one number of a shape: a limit that is given is called so, and in funnel flow no outlet is the critical one. */
const clod_hopper_field *clod_hopper_field_of(const clod_hopper_found *found,
                                              clod_hopper_number number);

/** Width of a slot in funnel flow. */
extern const clod_hopper_field CLOD_HOPPER_FIELD_SLOT;

/** "cone", "wedge": by clod_radial_shape. */
extern const char *const CLOD_HOPPER_SHAPE_NAMES[CLOD_HOPPER_SHAPES];

/** What an outcome is called in JSON. */
extern const char *const CLOD_HOPPER_OUTCOME_NAMES[CLOD_HOPPER_OUTCOMES];

/** Measured curves in JSON, by their place in clod_solid. */
extern const char *const CLOD_HOPPER_CURVE_KEYS[CLOD_SOLID_CURVES];

/** "arnold", "rhodes": by clod_hopper_arch. */
extern const char *const CLOD_HOPPER_ARCH_NAMES[];
