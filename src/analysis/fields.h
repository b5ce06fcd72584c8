#pragma once
/**
 * @file fields.h
 * The results of a yield locus in one table, which drives combining, table, JSON and CSV.
 */

#include <stddef.h>

#include "clod/locus.h"

typedef enum clod_field_kind {
    CLOD_FIELD_STRESS,  ///< Pa
    CLOD_FIELD_ANGLE,   ///< rad
    CLOD_FIELD_NUMBER,  ///< -
    CLOD_FIELD_DENSITY, ///< kg/m3
} clod_field_kind;

typedef struct clod_field {
    const char *key;  ///< name in JSON and CSV, without unit
    const char *text; ///< name for people
    clod_field_kind kind;
    size_t offset; ///< of the clod_locus_value in clod_locus
} clod_field;

/** The rows of CLOD_FIELDS, in the order of the values in clod_locus. */
typedef enum clod_field_index {
    CLOD_FIELD_SIGMA_P,
    CLOD_FIELD_TAU_P,
    CLOD_FIELD_C,
    CLOD_FIELD_PHI_LIN,
    CLOD_FIELD_PHI_E,
    CLOD_FIELD_PHI_SF,
    CLOD_FIELD_SIGMA_1,
    CLOD_FIELD_SIGMA_2,
    CLOD_FIELD_SIGMA_C,
    CLOD_FIELD_FFC,
    CLOD_FIELD_RHO_B,
    CLOD_FIELD_RHO_INSIDE,
    CLOD_FIELD_COUNT,
} clod_field_index;

extern const clod_field CLOD_FIELDS[CLOD_FIELD_COUNT];

/** A pair of CLOD_LOCUS_PAIRS. */
typedef struct clod_field_pair {
    clod_field_index a, b;
} clod_field_pair;

extern const clod_field_pair CLOD_FIELD_PAIRS[CLOD_LOCUS_PAIRS];

/** The value of a field in a locus. */
clod_locus_value *clod_field_of(clod_locus *locus, clod_field_index index);

/** The same of a locus that is only looked at. */
clod_locus_value clod_field_get(const clod_locus *locus, clod_field_index index);
