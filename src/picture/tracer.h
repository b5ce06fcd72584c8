#pragma once
/**
 * @file tracer.h
 * A scene as an image, by the ray tracer Tachyon: the only file that knows it.
 */

#include <stdbool.h>
#include <stdint.h>

#include "picture/camera.h"
#include "picture/scene.h"

/** How much work goes into an image. */
typedef enum clod_tracer_quality {
    CLOD_TRACER_DRAFT,  ///< one ray for each pixel, no shadows
    CLOD_TRACER_NORMAL, ///< smooth edges, shadows
    CLOD_TRACER_HIGH,   ///< light from the whole sky as well
} clod_tracer_quality;

/**
 * Draw a scene on white.
 *
 * @param width, height  pixels; width / height is that of the camera
 * @param image          [out] [height][width][3] red, green, blue, from the upper left
 * Errors  none; Tachyon ends the program when it has no memory.
 * Threads one at a time.   Test  tests/picture/test_tracer.c
 */
void clod_tracer_draw(const clod_scene *scene, const clod_camera *camera,
                      clod_tracer_quality quality, int width, int height, uint8_t *image);
