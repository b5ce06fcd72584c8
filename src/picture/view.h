#pragma once
/**
 * @file view.h
 * Directions of view by name, for a box of space.
 */

#include "picture/camera.h"

/**
 * Direction of a view: of the oblique one three quarters along the longer side.
 *
 * @param view       clod_picture_view
 * @param low, high  [3] m, of the box
 * Errors  none.   Threads  pure.
 */
clod_vec3 clod_view_direction(int view, const double low[3], const double high[3]);
