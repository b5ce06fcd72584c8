#pragma once
/**
 * @file surface_tree.h
 * The tree of boxes by which facets near a point are found.
 */

#include "mesh/surface.h"

/** Make the tree of a surface that has its facets; false without memory. */
bool clod_surface_tree_make(clod_surface *self);
