#pragma once
/**
 * @file scan.h
 * A first look at all snapshots that are to be drawn: what there is, where it is, and the range
 * of its values.
 */

#include "picture/picture.h"
#include "picture/stage.h"

#define CLOD_SCAN_WALLS 10000

typedef struct clod_scan {
    clod_film film[2];
    size_t film_count;
    size_t *frame[2]; ///< [count] owned: numbers of the frames to draw, of each film
    size_t count;
    clod_channel grains, walls;
    clod_cutaway_box seen;     ///< of the grains; of the walls where there are none
    clod_cutaway_box seen_now; ///< of the grains of the frame that is looked at
    clod_cutaway_box planes;   ///< where planes at the sides of all grains end each other
    clod_stage_hidden hidden;
    clod_stage stage; ///< points to what is above
} clod_scan;

/**
 * Look at the snapshots that the options ask for. The scan must stay where it is.
 *
 * @param self  [out] owned content (clod_scan_fini), also after a failure
 * Errors  as clod_picture_open.
 */
bool clod_scan_make(clod_scan *self, const clod_picture_options *options, clod_status *status);

/** Frame number k to draw, of a film. */
const clod_film_frame *clod_scan_frame(const clod_scan *self, size_t film, size_t k);

/** Free the content; an empty scan is fine. */
void clod_scan_fini(clod_scan *self);
