#pragma once
/**
 * @file exits.h
 * Names of the ways out of a case: sides of its domain, then its outlets.
 */

#include <stddef.h>

#include "clod/case.h"
#include "state/changes.h"

/** The name of a way out alone; CLOD_EXITS is "removed", by the run itself. Borrowed. */
const char *clod_exits_name(const clod_case *from, int way);

/** As columns and keys have it: left_x_min, outlet_NAME. @return text */
const char *clod_exits_key(const clod_case *from, int way, char *text, size_t size);
