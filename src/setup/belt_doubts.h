#pragma once
/**
 * @file belt_doubts.h
 * Conveyor belts that lie with another side up than gravity has it.
 */

#include "clod/case.h"

/** What is told of a wall with a belt: a text of at most CLOD_CHECK_WARNING_TEXT bytes. */
typedef void (*clod_setup_belts_tell)(void *context, const char *text);

/**
 * Tell of each wall whose belt takes z as up while gravity points elsewhere: neither along -z nor
 * out of the underside of the belt as its wall is turned. Without gravity there is no doubt.
 *
 * Errors  none.   Threads  pure.   Test  tests/cli/test_check.py
 */
void clod_setup_belts_doubts(const clod_case *from, clod_setup_belts_tell tell, void *context);
