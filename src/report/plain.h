#pragma once
/**
 * @file plain.h
 * Tables of a page as text for a terminal.
 */

#include <stdbool.h>
#include <stdio.h>

/**
 * Write headings, tables and notes of a piece of a page as text, the columns of a table aligned. Knows the HTML that pages are
 * written with: elements are closed, cells are th and td.
 *
 * @return  false: no memory   Threads  safe.   Test  tests/report/test_plain.c
 */
bool clod_plain_put(FILE *out, const char *html);
