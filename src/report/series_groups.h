#pragma once
/**
 * @file series_groups.h
 * The columns of a series sorted by what they measure: feed.power [W] and chute.power [W] are one
 * group.
 */

#include <stdbool.h>
#include <stddef.h>

#include "report/figure.h"
#include "report/table.h"

#define CLOD_SERIES_GROUPS_TITLE (2 * CLOD_FIGURE_NAME + 2) ///< a quantity, and whose it is

typedef struct clod_series_group {
    const char *quantity, *unit; ///< borrowed from the table
    int *column;                 ///< [count] borrowed
    size_t count;
} clod_series_group;

typedef struct clod_series_groups {
    clod_series_group *group; ///< [count] owned, in the order of their first columns
    int *columns;             ///< owned
    size_t count;
} clod_series_groups;

/**
 * Sort the columns; those that never change, time and phase are left out.
 *
 * @param self  [out] owned content (clod_series_groups_fini), also after a failure
 * @return      false: no memory
 * Test  tests/report/test_table.c
 */
bool clod_series_groups_make(clod_series_groups *self, const clod_table *series);

void clod_series_groups_fini(clod_series_groups *self);

/** Whose a column is, in words: "gauge head" of gauge_head.mass_flow; "" of kinetic_energy. */
void clod_series_groups_object(const char *name, char words[CLOD_FIGURE_NAME]);

/** What a column measures: "mass_flow" of gauge_head.mass_flow. Borrowed. */
const char *clod_series_groups_quantity(const char *name);

/** What a column measures and whose it is, as a title: "Mass flow: gauge head".   Test  tests/report/test_table.c */
void clod_series_groups_title(const char *quantity, const char *whose,
                              char title[CLOD_SERIES_GROUPS_TITLE]);

/** A name with blanks for underscores. */
void clod_series_groups_words(const char *name, char words[CLOD_FIGURE_NAME]);

/**
 * Whose all columns of a group are: "inlet 1" of a single one, "gauges" of those of several gauges;
 * "" when they are of several kinds, or of none.
 *
 * Test  tests/report/test_table.c
 */
void clod_series_groups_whose(const clod_series_group *group, const clod_table *series,
                              char words[CLOD_FIGURE_NAME]);
