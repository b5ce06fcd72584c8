#pragma once
/**
 * @file colour_map.h
 * Colour maps whose equal steps look equally large: computed, each a path through OKLab, the
 * space of colours in which distance is what the eye sees.
 *
 * Source  B. Ottosson, A perceptual color space for image processing, 2020,
 *         https://bottosson.github.io/posts/oklab: matrices from OKLab to linear sRGB.
 */

#include <stddef.h>

#include "clod/status.h"

#define CLOD_COLOUR_MAP_SIZE 256

/** Colours from the smallest value to the largest; red, green, blue of sRGB in 0 ... 1. */
typedef struct clod_colour_map {
    double colour[CLOD_COLOUR_MAP_SIZE][3];
} clod_colour_map;

/**
 * Compute a colour map.
 *
 * @param name  sea (blue to yellow), ember (purple to yellow), balance (blue, white, red: for
 *              numbers about zero) or grey
 * Errors  CLOD_USAGE: no such map; those that exist are named.   Threads  pure.
 * Test    tests/picture/test_colour_map.c
 */
bool clod_colour_map_make(clod_colour_map *self, const char *name, clod_status *status);

/** Number of the colour of a value between min and max; below and above: that of the end. */
int clod_colour_map_index(double value, double min, double max);

/** A colour that tells one kind of several from its neighbours, number k; it repeats. */
void clod_colour_map_kind(size_t k, double colour[3]);
