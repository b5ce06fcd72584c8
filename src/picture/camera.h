#pragma once
/**
 * @file camera.h
 * Where a picture is taken from: a perspective camera, and one that shows given spheres whole.
 */

#include <stdbool.h>

#include "base/vec3.h"

typedef struct clod_camera {
    clod_vec3 eye;              ///< m
    clod_vec3 right, up, ahead; ///< unit vectors, right = ahead x up
    double half_width;          ///< tangent of half the angle of view, to a side
    double half_height;         ///< upwards
} clod_camera;

/**
 * A camera at `eye` that looks in a direction, z of space upwards in the picture (y when it
 * looks along z).
 *
 * @param direction  need not have length 1, must not be 0
 * @param angle      of view from bottom to top [rad], below pi
 * @param aspect     width of the picture over its height
 * Errors  none.   Threads  pure.   Test  tests/picture/test_camera.c
 */
clod_camera clod_camera_make(clod_vec3 eye, clod_vec3 direction, double angle, double aspect);

/**
 * Where a point is in the picture.
 *
 * @param x, y  [out] -1 at the left and lower edge, 1 at the right and upper one
 * @return      distance along the direction of view [m]; not above 0: behind the camera, and x
 *              and y mean nothing
 */
double clod_camera_project(const clod_camera *self, clod_vec3 point, double *x, double *y);

/** Bounds of what a camera must show; clod_camera_bound adds to those that begin as here. */
typedef struct clod_camera_bounds {
    double right, left, top, bottom;
} clod_camera_bounds;

#define CLOD_CAMERA_BOUNDS_NONE                                                                \
    ((clod_camera_bounds){-HUGE_VAL, -HUGE_VAL, -HUGE_VAL, -HUGE_VAL})

/** A sphere is to be seen whole by a camera with the directions and angles of `self`. */
void clod_camera_bound(const clod_camera *self, clod_camera_bounds *bounds, clod_vec3 center,
                       double radius);

/** Move the camera, without turning it, to the nearest place from which all bounds are seen. */
void clod_camera_fit(clod_camera *self, const clod_camera_bounds *bounds);
