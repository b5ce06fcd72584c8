#pragma once
/**
 * @file summary_tables.h
 * Parts of summary.json as tables: a list of objects, or an object of them, whatever their keys.
 */

#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "report/figure.h"

/**
 * Write a table with a column for each object and a row for each of their numbers; nothing when
 * there are none, or all are zero. Objects with mean and deviation are one cell; the title of a
 * cell is the number as the file has it. Means of vectors and tensors have a row for each component,
 * along x, y, z, or r, t, z where the object says `components: cylindrical` (field_axes.h).
 *
 * @param title  heading; NULL: none
 * @param note   what the numbers behind +- are, HTML, below a table that has one; NULL: nothing
 * @param from   array or object of objects; borrowed; NULL is fine
 * Test  tests/report/test_summary_tables.c, tests/report/test_free_page.py
 */
void clod_summary_tables_put(FILE *out, const char *title, const char *note, json_t *from);

/** What a cell of such a table has. */
typedef struct clod_summary_cell {
    const char *of;    ///< whose: the name of the object
    const char *key;   ///< in the summary
    const char *axes;  ///< of a component: "x", "xy"; "": it is none
    double value;      ///< NaN: none
    double error;      ///< behind +-; NaN: none
    const char *words; ///< in place of a number; NULL: it is one
} clod_summary_cell;

/**
 * Tell every cell of the table, one object after the other; vectors are told as their components.
 *
 * @return  false: there are more objects, or numbers of them, than a table has place for
 * Threads  safe.   Test  tests/report/test_summary_tables.c
 */
bool clod_summary_tables_each(json_t *from, void *context,
                              void (*take)(void *context, const clod_summary_cell *cell));

/** Split a key, "mass_flow_kg_per_s", into "mass flow" and "kg/s"; a unit "" if it has none. */
void clod_summary_tables_name(const char *key, char name[CLOD_FIGURE_NAME], char unit[16]);
