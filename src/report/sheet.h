#pragma once
/**
 * @file sheet.h
 * The page that is being written: its body, its figures, and the file that they become.
 */

#include <stdbool.h>
#include <stdio.h>

#include "base/text.h"
#include "clod/status.h"
#include "report/figure.h"
#include "report/figure_files.h"

typedef struct clod_sheet {
    FILE *body;    ///< HTML
    FILE *figures; ///< JSON: the figures, with commas between
    FILE *views;   ///< JSON: the 3-D views, with commas between
    clod_text body_text, figures_text, views_text;
    clod_figure_file *files; ///< [file_count] owned
    size_t file_count, view_count;
    bool lost; ///< there was no memory for something
} clod_sheet;

/** Begin a page, which must stay where it is. Errors  CLOD_FAILED: no memory. */
bool clod_sheet_open(clod_sheet *self, clod_status *status);

/**
 * Put a figure into the page; nothing when it shows nothing. One whose name an earlier figure has gets
 * a number behind it. Frees its content.
 */
void clod_sheet_figure(clod_sheet *self, clod_figure *figure);

/** Begin or end a run of figures that stand side by side where there is room. */
void clod_sheet_columns(clod_sheet *self, bool begin);

/** Begin the JSON of a 3-D view, and put its place into the body. */
FILE *clod_sheet_view(clod_sheet *self);

/**
 * Write the page to `path`, and each figure beside it: PATH without .html, -NAME.svg. Figures that an
 * earlier page of this name had, and this one has not, are removed. The page comes last: one that is
 * there for the first time has its figures.
 * Errors  CLOD_USAGE: a file that is not clod's has the name of a figure; CLOD_FAILED: disk, memory.
 */
bool clod_sheet_write(clod_sheet *self, const char *title, const char *path,
                      clod_status *status);

/** Free the content; one that was not opened is fine. */
void clod_sheet_fini(clod_sheet *self);
