#pragma once
/**
 * @file value.h
 * One scalar of a case file -> one checked value.
 */

#include "config/load.h"

/**
 * Read the value of one row that is not a group.
 *
 * @param self    loader; errors go to its report under its path
 * @param param   the row
 * @param node    what the user wrote, or the default
 * @param target  [in,out] struct to which the row's offsets belong
 */
void clod_value_load(clod_loader *self, const clod_param *param, const clod_node *node,
                     void *target);
