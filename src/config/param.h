#pragma once
/**
 * @file param.h
 * Parameter tables: one row per key of a case file. Loading, units, ranges, defaults, the echo,
 * `clod explain`, the JSON Schema and the manual all read these rows and nothing else.
 */

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "clod/case.h"
#include "clod/schema.h"
#include "law/law_kinds.h"

typedef enum clod_param_kind {
    CLOD_PARAM_REAL,      ///< double; number with unit
    CLOD_PARAM_STIFFNESS, ///< double; N/m^n with n at `exponent`
    CLOD_PARAM_INTEGER,   ///< int64_t
    CLOD_PARAM_BOOL,      ///< bool
    CLOD_PARAM_FLAGS,     ///< bool[3]
    CLOD_PARAM_TEXT,      ///< owned char *
    CLOD_PARAM_FILE,      ///< owned char *; path, resolved against the case
    CLOD_PARAM_CHOICE,    ///< int; index into `choices`
    CLOD_PARAM_VECTOR,    ///< double[3] (or `length`)
    CLOD_PARAM_REALS,     ///< owned double *, number of them at `count`
    CLOD_PARAM_SECTION,   ///< a table whose offsets count from `offset`
    CLOD_PARAM_LIST,      ///< owned array of the table's structs, number at `count`
    CLOD_PARAM_MAP,       ///< the same with names; the struct starts with an owned char *name
    CLOD_PARAM_PAIRS,     ///< the contact laws of material pairs (contacts.h)
    CLOD_PARAM_SETTINGS,  ///< owned array of clod_setting, number at `count` (settings.h)
} clod_param_kind;

typedef enum clod_param_need {
    CLOD_PARAM_REQUIRED,
    CLOD_PARAM_OPTIONAL,  ///< takes its default; without one it stays zero, "not given"
    CLOD_PARAM_DEFAULTED, ///< section that is filled with its defaults when it is left out
} clod_param_need;

typedef struct clod_param {
    const char *key;
    clod_param_kind kind;
    clod_param_need need;
    const char *unit;     ///< SI; "1" for a pure number
    double min, max;      ///< SI, allowed range
    bool above_min;       ///< min itself is not allowed
    bool nonzero;         ///< vector: must have a direction
    const char *fallback; ///< default, as a user would write it
    const char *example;  ///< for a key without default
    const char *help;     ///< one sentence or two
    const char *source;   ///< equation, standard, or page of docs/theory
    size_t offset;
    size_t count;               ///< offset of the number of items
    size_t given;               ///< offset of a bool that is set when the key is there; 0: none
    size_t exponent;            ///< stiffness: offset of the exponent, in a row above
    size_t length;              ///< vector: number of components
    const char *const *choices; ///< ended by NULL
    const char *zero_word;      ///< word that stands for 0, for instance "auto"
    bool bare_unit;             ///< a unit alone stands for one of it: "mm"
    const struct clod_table *table; ///< section, list, map
    bool any_name;                  ///< map: names are any text, as files have them
    /** Pairs: keys that stand beside the sections, in the struct that holds the pairs. */
    const struct clod_table *beside;
    /** Whether the value has any effect, and so whether the echo writes it; NULL: always. */
    bool (*used)(const clod_case *whole, const void *self);
    const char *formerly; ///< its name in earlier versions: an error that tells the new one
    const char *unused; ///< error for a key that is written but not used; NULL: told elsewhere
    /** Whether a contact law has the key; NULL: all do. Help and error name those that have it,
     * and `unused` says why the others do not: ": a reason", or "". */
    bool (*law_has)(const clod_law_keys *law);
} clod_param;

typedef struct clod_table {
    const char *title; ///< one line, for the manual
    const clod_param *params;
    size_t count;
    size_t size; ///< of the struct, for lists and maps
    bool one_of; ///< exactly one of the keys is given; its index goes to `kind`
    size_t kind; ///< offset of the int
} clod_table;

/** Keys of a kind of file: clod_schema of clod/schema.h. */
struct clod_schema {
    const char *keys; ///< "Keys of a case file"
    const char *name; ///< where a key is, behind its path; NULL: in a case, as most
    const char *top;  ///< heading of the table of its topmost keys
    const char *verb; ///< that reads such a file
    const clod_table *table;
    void (*head)(FILE *out); ///< writes what the manual says before the tables
};

extern const clod_table CLOD_TABLE_CASE;
extern const clod_table CLOD_TABLE_MATERIAL;
extern const clod_table CLOD_TABLE_CONTACT;
extern const clod_table CLOD_TABLE_CONTACTS;
extern const clod_table CLOD_TABLE_GRAINS;
extern const clod_table CLOD_TABLE_REGION;
extern const clod_table CLOD_TABLE_OUTLET;
extern const clod_table CLOD_TABLE_GAUGE;
extern const clod_table CLOD_TABLE_FIELD;
extern const clod_table CLOD_TABLE_MIXING;
extern const clod_table CLOD_TABLE_REPOSE;
extern const clod_table CLOD_TABLE_CLUMPS;
extern const clod_table CLOD_TABLE_BUILD_UP;
extern const clod_table CLOD_TABLE_HISTORY_MAP;
extern const clod_table CLOD_TABLE_WALL;
extern const clod_table CLOD_TABLE_SHAPE;
extern const clod_table CLOD_TABLE_BELT;
extern const clod_table CLOD_TABLE_ROTATION;
extern const clod_table CLOD_TABLE_STAGE;
extern const clod_table CLOD_TABLE_DOMAIN;
extern const clod_table CLOD_TABLE_TIME;
extern const clod_table CLOD_TABLE_OUTPUT;
extern const clod_table CLOD_TABLE_RING_SHEAR;
extern const clod_table CLOD_TABLE_JENIKE;
extern const clod_table CLOD_TABLE_UNIAXIAL;
extern const clod_table CLOD_TABLE_WALL_FRICTION;
extern const clod_table CLOD_TABLE_CONTACT_BENCH;

/** Row of a table by key, or NULL. */
const clod_param *clod_param_find(const clod_table *table, const char *key);

/** True for sections, lists, maps and pairs: rows with a table below. */
bool clod_param_is_group(const clod_param *param);

/** Help of a row; of a key that not all contact laws have, with the names of those that do. */
const char *clod_param_help(const clod_param *param, char *buffer, size_t size);

/** Short text of a row's kind and unit, for instance "pressure [Pa]". */
const char *clod_param_kind_text(const clod_param *param, char *buffer, size_t size);

/** Default of a row, or that it must be given or may be left out. */
const char *clod_param_default_text(const clod_param *param);

/** Whether a number is in the range of a row; one that is not a number never is. */
bool clod_param_allows(const clod_param *param, double number);

/** Allowed range of a row, for instance "above 0 m and at most 1 m"; "" when anything goes. */
const char *clod_param_range_text(const clod_param *param, char *buffer, size_t size);

// How rows are written: CLOD_AT(struct, field) says where the value goes.
#define CLOD_AT(type, field) .offset = offsetof(type, field)
#define CLOD_COUNT(type, field) .count = offsetof(type, field)
#define CLOD_FROM(low, high) .min = (low), .max = (high)
#define CLOD_ABOVE(low, high) .min = (low), .max = (high), .above_min = true
#define CLOD_ANY .min = -HUGE_VAL, .max = HUGE_VAL
#define CLOD_ROWS(rows) .params = (rows), .count = sizeof(rows) / sizeof((rows)[0])
