#pragma once
/**
 * @file output.h
 * Standard output and standard error of every verb, watched in one place.
 */

#include <stdbool.h>

/**
 * Call first in main. Streams that came closed are held by what can be neither read nor
 * written, so that no file of the program gets their number. When the program ends, standard
 * output is closed: what could not be written there is told, and an exit status of 0 becomes 1,
 * also when messages on standard error were lost.
 *
 * @return  false: the streams cannot be watched, the program should end
 * Test     tests/cli/test_streams.py
 */
bool clod_output_watch(void);

/** Write a text to standard output. A failure is told when the program ends. */
void clod_output_put(const char *text);
