#pragma once
/**
 * @file series_compare.h
 * Curves of several runs over each other.
 */

#include "report/run_files.h"
#include "report/sheet.h"

/** A column of some parts of all runs, over another. */
typedef struct clod_series_curves {
    const char *part;   ///< of the parts that have this in their name
    const char *behind; ///< what the title has behind the column's name; NULL: `part`
    bool whole;         ///< only parts that end with `part`: point-1, not point-10
    const char *over, *column;
    /** Mark what was read from a part's curve; NULL: nothing. */
    void (*mark)(clod_figure *figure, const clod_run_files *run, const char *part, int number);
    const char *marks; ///< a sentence about the marks
} clod_series_curves;

/** Put a figure of them. Errors  CLOD_USAGE: a damaged table. */
bool clod_series_compare_parts(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const clod_series_curves *curves, clod_status *status);

/** Flow functions of uniaxial tests, and their axial stresses. Errors  as above. */
bool clod_series_compare_strengths(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                   clod_status *status);

/** The columns of free runs that matter most and that all have, one figure each. Errors  as above.
 */
bool clod_series_compare_free(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                              clod_status *status);
