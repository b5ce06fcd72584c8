#pragma once
/**
 * @file html.h
 * Pieces of HTML: texts escaped, tables.
 */

#include <stdio.h>

/** Write a text so that it stands in HTML, SVG or an attribute as it is; NULL: a dash. */
void clod_html_text(FILE *out, const char *text);

/** Write a table cell, `tag` th or td. */
void clod_html_cell(FILE *out, const char *tag, const char *text);

/** A row of a table of facts: what, and its text. */
void clod_html_fact(FILE *out, const char *name, const char *text);

/** Begin a section with a heading. */
void clod_html_section(FILE *out, const char *id, const char *title);

/** Write "details" that open on a click, with a text as it is. */
void clod_html_folded(FILE *out, const char *title, const char *text);
