#pragma once
/**
 * @file result_table.h
 * Results side by side: quantities of runs, a laboratory, means. Few of them stand in columns, many in rows.
 */

#include <jansson.h>
#include <stdbool.h>

#include "report/writer.h"

/** A quantity. */
typedef struct clod_result_row {
    const char *
        key; ///< of the JSON: a number, or an object with value, error and scatter; of a measured one also with
             ///< `off` and `off_error`, the share by which the simulation is off
    const char *text;    ///< as clod_writer_words takes it
    const char *symbol;  ///< "sigma_1"; "": none
    const char *unit;    ///< "": none
    double factor;       ///< brings the JSON's number to this unit
    int digits;          ///< behind the point where there is no error
    const char *error;   ///< key of its error, where that stands beside it; NULL: it does not
    const char *missing; ///< what is said where there is no number; NULL: "undefined";
                         ///< "": nothing, and no row where nobody has the number
    bool words;          ///< a text, no number
} clod_result_row;

/** Whose numbers. */
typedef struct clod_result_of {
    const char *name;   ///< text
    const json_t *from; ///< borrowed
    bool mean;          ///< of several
} clod_result_of;

#define CLOD_RESULT_COLUMNS 7 ///< as many of them stand in columns; more stand in rows
#define CLOD_RESULT_NUMBERS                                                                    \
    16 ///< as many quantities stand side by side; of more, and of many whose, there are several tables

/** A number, or the `value` of an object with one; NaN where there is none. */
double clod_result_table_number(const json_t *object, const char *key);

/** Write a value with its error, and its scatter if `all`, rounded; full numbers are the title of `tag`,
 *  which is begun on the page. */
void clod_result_table_value(clod_writer out, const char *tag, const json_t *from,
                             const clod_result_row *row, bool all);

/** The table. Test  tests/report/test_compare.py */
void clod_result_table_put(clod_writer out, const clod_result_row *rows, size_t row_count,
                           const clod_result_of *of, size_t count);
