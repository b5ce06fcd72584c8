#pragma once
/**
 * @file part_curves.h
 * Columns of the tables of a test's parts over one of them: a figure for each column, a curve for each part.
 */

#include "report/run_files.h"
#include "report/sheet.h"

#define CLOD_PART_CURVES_MOST 8 ///< columns

/** A column that is drawn. Numbers of the files are times `factor` in `unit`. */
typedef struct clod_part_column {
    const char *column, *text, *unit;
    double factor;
} clod_part_column;

typedef struct clod_part_curves {
    const char *part;      ///< parts that have this in their name
    clod_part_column over; ///< the x axis
    const char *behind;    ///< what a title has behind the column's text: ", preshear"
    bool named_by_title;   ///< a figure's file; else by its column
    const clod_part_column *columns;
    size_t count; ///< at most CLOD_PART_CURVES_MOST
    /** Mark what was read from a part's curve of the first column; NULL: nothing. */
    void (*mark)(clod_figure *figure, const clod_run_files *run, const char *part, int number);
    const char *marks; ///< a sentence about the marks
} clod_part_curves;

/** Put the figures. Errors  CLOD_USAGE: a damaged table. */
bool clod_part_curves_put(clod_sheet *sheet, const clod_run_files *run,
                          const clod_part_curves *curves, clod_status *status);
