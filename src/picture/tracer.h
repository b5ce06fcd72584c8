#pragma once
/**
 * @file tracer.h
 * A scene as an image, by the ray tracer Tachyon: the only file that knows it.
 */

#include <stdbool.h>
#include <stdint.h>

#include "clod/status.h"
#include "picture/camera.h"
#include "picture/scene.h"

/** How much work goes into an image. */
typedef enum clod_tracer_quality {
    CLOD_TRACER_DRAFT,  ///< one ray for each pixel
    CLOD_TRACER_NORMAL, ///< smooth edges
    CLOD_TRACER_HIGH,   ///< light from the whole sky as well
} clod_tracer_quality;

typedef struct clod_tracer_order {
    int width, height; ///< pixels; width / height is that of the camera
    clod_tracer_quality quality;
    int threads;
} clod_tracer_order;

/**
 * Draw a scene on white.
 *
 * @param image  [out] [height][width][3] red, green, blue, from the upper left
 * Errors  CLOD_FAILED: no memory; when Tachyon has none, it ends the program.
 * Threads one at a time.   Test  tests/cli/test_picture.py
 */
bool clod_tracer_draw(const clod_scene *scene, const clod_camera *camera,
                      const clod_tracer_order *order, uint8_t *image, clod_status *status);
