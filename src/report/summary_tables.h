#pragma once
/**
 * @file summary_tables.h
 * Parts of summary.json as tables: a list of objects, or an object of them, whatever their keys.
 */

#include <jansson.h>
#include <stdio.h>

#include "report/figure.h"

/**
 * Write a table with a column for each object and a row for each of their numbers; nothing when
 * there are none, or all are zero. Objects with mean and deviation are one cell; the title of a
 * cell is the number as the file has it. Means of vectors and tensors have a row for each component,
 * along x, y, z, or r, t, z where the object says `components: cylindrical` (field_axes.h).
 *
 * @param title  heading; NULL: none
 * @param from   array or object of objects; borrowed; NULL is fine
 * Test  tests/report/test_summary_tables.c, tests/report/test_free_page.py
 */
void clod_summary_tables_put(FILE *out, const char *title, json_t *from);

/** Split a key, "mass_flow_kg_per_s", into "mass flow" and "kg/s"; a unit "" if it has none. */
void clod_summary_tables_name(const char *key, char name[CLOD_FIGURE_NAME], char unit[16]);
