#pragma once
/**
 * @file free_warnings.h
 * What is wrong with the streams of a free run: inlets without room, alarms of gauges, spillage.
 */

#include <jansson.h>
#include <stddef.h>
#include <stdio.h>

/**
 * Write the warnings, each text with a 0 at its end.
 *
 * @param summary  of the run; NULL: none
 * @return         number of warnings
 * Test  tests/report/test_free_page.py
 */
size_t clod_free_warnings_put(FILE *out, const json_t *summary);
