#pragma once
/**
 * @file unit.h
 * Numbers with units, through UDUNITS-2, behind a whitelist: udunits reads `N/m^1.5` as 5 N/m.
 */

#include <stdbool.h>
#include <stddef.h>

#define CLOD_UNIT_MESSAGE 256

/** rad in a degree, as a case's "60 deg" is converted: limits of angles are round in degrees. */
#define CLOD_UNIT_DEGREE 0.017453292519943295

/** Noun and example of an SI unit for messages: "Pa" is a pressure, for instance "54.8 kPa". */
typedef struct clod_unit_kind {
    const char *unit;    ///< SI, as parameter tables write it; "1" for a pure number
    const char *noun;    ///< with article: "a pressure"
    const char *of;      ///< without: "pressure"
    const char *example; ///< unit that goes well with it: "kPa"
} clod_unit_kind;

/** The kind of an SI unit of the parameter tables and of names in files (base/unit_endings.h). */
const clod_unit_kind *clod_unit_describe(const char *unit);

/**
 * Read the number a text starts with.
 *
 * @param text   decimal number, no hexadecimal, no inf or nan
 * @param value  [out] the number
 * @return       first character behind it and behind blanks, or NULL when there is no number
 */
const char *clod_unit_number(const char *text, double *value);

/**
 * Convert a number with the unit the user wrote to SI.
 *
 * @param written  the unit as written, may be ""
 * @param unit     SI unit of the key; "1" for a pure number, which takes no unit but %
 * @param value    [in,out] the number as written -> SI
 * @param message  [out] on failure: what is wrong, as a continuation of "54.8 kPaa: "
 * @return         false when the unit is missing, unknown or of another kind
 * Errors  in message.   Threads  safe (udunits is called under a lock).
 * Test    tests/config/test_units.c
 */
bool clod_unit_convert(const char *written, const char *unit, double *value,
                       char message[CLOD_UNIT_MESSAGE]);

/** The same with another unit as the example of messages, "h" where "ms" is hardly meant; NULL: that of the kind. */
bool clod_unit_convert_like(const char *written, const char *unit, const char *example,
                            double *value, char message[CLOD_UNIT_MESSAGE]);

/**
 * Convert a contact stiffness in N/m^n to SI: prefixes k, M, G on N and m on m are read.
 *
 * @param written   the unit as written, for instance "N/m^1.5" or "kN/mm"
 * @param exponent  n of the contact
 * @param value     [in,out] the number as written -> N/m^n
 * @param message   [out] on failure
 * @return          false when the unit is no stiffness or its exponent is not n
 */
bool clod_unit_stiffness(const char *written, double exponent, double *value,
                         char message[CLOD_UNIT_MESSAGE]);
