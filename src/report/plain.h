#pragma once
/**
 * @file plain.h
 * Tables and notes as text for a terminal.
 */

#include <stdio.h>

/**
 * Write a text with its tables laid out: names begin a line, numbers end below each other.
 *
 * @param text  is used up; a tab ends each cell of a table, a line end each row, a form feed the table; lines of other text
 *              have none of them. What would spoil a terminal becomes ?
 * Threads  safe.   Test  tests/report/test_plain.c
 */
void clod_plain_put(FILE *out, char *text);
