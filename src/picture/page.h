#pragma once
/**
 * @file page.h
 * The page of a picture: one image or two side by side, with title, time, colour bars, length
 * scale and axes, drawn with cairo and written as PNG.
 */

#include <cairo.h>
#include <stdbool.h>
#include <stdint.h>

#include "clod/status.h"
#include "picture/axis.h"
#include "picture/camera.h"
#include "picture/colour_map.h"

/** A rectangle in pixels from the upper left corner. */
typedef struct clod_page_box {
    int x, y, width, height;
} clod_page_box;

/** A colour bar, or a list of kinds with their colours. */
typedef struct clod_page_bar {
    clod_axis axis;
    clod_colour_map map;
    bool below, above;   ///< there are values beyond its ends
    size_t kinds;        ///< 0: a bar
    const char **name;   ///< [kinds] borrowed
    double (*colour)[3]; ///< [kinds] borrowed
} clod_page_bar;

typedef struct clod_page {
    int width, height;
    double font;              ///< height of letters, pixels
    int panels;               ///< images: 1 or 2
    clod_page_box panel[2];   ///< where they are
    clod_page_box bars;       ///< where the colour bars are
    cairo_surface_t *surface; ///< owned
    cairo_t *cairo;           ///< owned
} clod_page;

/**
 * Begin a page: white, and divided.
 *
 * @param bar  [bar_count] what will be drawn at the right, to see how much room it takes
 * Errors  CLOD_FAILED: cairo has no memory.   Threads  one at a time.
 * Test    tests/cli/test_picture.py
 */
bool clod_page_begin(clod_page *self, int width, int height, int panels,
                     const clod_page_bar *bar, size_t bar_count, clod_status *status);

/** Put an image [height][width][3] into its panel, with its title and a line under that above. */
void clod_page_put_image(clod_page *self, int panel, const uint8_t *image, const char *title,
                         const char *under);

/** Draw the length scale at the distance of a point, and the directions of the axes. */
void clod_page_put_scale(clod_page *self, int panel, const clod_camera *camera,
                         clod_vec3 point);

/** Draw the colour bars. */
void clod_page_put_bars(clod_page *self, const clod_page_bar *bar, size_t bar_count);

/** Write the page as PNG, replacing the file at one stroke.
 *  Errors  CLOD_FAILED: disk, no folder, no memory. */
bool clod_page_write(clod_page *self, const char *path, clod_status *status);

/** Free the content; an empty page is fine. */
void clod_page_fini(clod_page *self);
