#pragma once
/**
 * @file figure_files.h
 * The SVG files of a page's figures, beside it: PAGE without .html, -NAME.svg. Each ends with a line
 * that has its figure's name and a checksum, so that a file of this kind is known from a user's own, a copy
 * under another name or one that was edited.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

/** A figure as SVG. */
typedef struct clod_figure_file {
    char name[128];
    char *svg; ///< owned
} clod_figure_file;

/**
 * See that no figure would take the place of a file that is not clod's. `report.html` of a results folder
 * has the names of its figures to itself.
 *
 * @param page  path of the page, which need not be there
 * Errors  CLOD_USAGE: there is such a file; CLOD_FAILED: disk, memory.
 * Test    tests/report/test_figure_files.c
 */
bool clod_figure_files_check(const char *page, const clod_figure_file *files, size_t count,
                             clod_status *status);

/**
 * Write all figures of a page, and remove those that an earlier page of this name had and it has not:
 * files that end as clod wrote them, and no others.
 *
 * Errors  CLOD_FAILED: disk, memory.
 * Test    tests/report/test_figure_files.c
 */
bool clod_figure_files_write(const char *page, const clod_figure_file *files, size_t count,
                             clod_status *status);
