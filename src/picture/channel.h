#pragma once
/**
 * @file channel.h
 * One quantity on its way into colours: the values of all frames give the range, the range and a
 * map the colours and the bar.
 */

#include "picture/field.h"
#include "picture/film.h"
#include "picture/page.h"

#define CLOD_CHANNEL_KINDS 32

typedef struct clod_channel {
    const char *field; ///< borrowed; NULL: the walls have none
    clod_vtkhdf_place place;
    clod_page_bar bar;
    double low, high; ///< smallest and largest value
    double *sample;   ///< [count] owned
    size_t count, capacity;
    char units[32];
    bool used[CLOD_CHANNEL_KINDS];        ///< kinds that occur
    char text[CLOD_CHANNEL_KINDS][32];    ///< their names
    const char *name[CLOD_CHANNEL_KINDS]; ///< those that occur, for the bar
    double colour[CLOD_CHANNEL_KINDS][3]; ///< the same
} clod_channel;

/** Note the values of a frame, of which there are so many in all. */
bool clod_channel_add(clod_channel *self, const clod_vtkhdf *file, size_t frames,
                      clod_status *status);

/**
 * Settle range, map and bar. The channel must stay where it is from here on.
 *
 * @param range  min and max; NULL: as the values are
 * @param map    NULL: sea for grains, ember for walls, balance where zero is in the middle
 * @param film   gives the kinds their names
 * Errors  CLOD_USAGE: no such map.   Threads  pure.   Test  tests/cli/test_picture.py
 */
bool clod_channel_settle(clod_channel *self, const double *range, const char *map,
                         const clod_film *film, clod_status *status);

/** Number of the colour of a value in a scene. */
int clod_channel_colour(const clod_channel *self, double value);

void clod_channel_fini(clod_channel *self);
