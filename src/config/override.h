#pragma once
/**
 * @file override.h
 * `--set key.path=value` on the tree of a case, before anything is checked.
 */

#include "config/load.h"

/**
 * Apply one override.
 *
 * @param loader  root is the tree; errors go to the report as `--set ...`
 * @param number  index of the override in the report's list
 */
void clod_override_apply(clod_loader *loader, size_t number);
