#pragma once
/**
 * @file region.h
 * Where the regions of a case are: one row for each clod_region_kind. How grains are put into
 * each is in src/setup/insertion_space.c.
 */

#include <stdbool.h>

#include "clod/case.h"

/** A rule between the keys of a region that its section breaks. */
typedef struct clod_region_fault {
    const char *key;  ///< "kind.key"; NULL: no rule is broken
    const char *text; ///< what is wrong with it, for the user
} clod_region_fault;

typedef struct clod_region_kind_row {
    const char *name; ///< as the case file says it
    bool face;        ///< grains come through it; else they are put into it
    bool upright;     ///< between circles about a vertical axis; only without `face`
    double (*area)(const clod_case_region *self); ///< clod_region_area
    double (*top)(const clod_case_region *self);  ///< m, of a face its centre
    /** Sizes along x, y and z [m]; NULL: a face. */
    void (*size)(const clod_case_region *self, double size[3]);
    void (*bounds)(const clod_case_region *self, double low[3], double high[3]);
    /** A direction in a face, its length, and half its extent along and across it [m]; NULL: no
     *  face. */
    void (*axis)(const clod_case_region *self, const double normal[3], double axis[3]);
    void (*half)(const clod_case_region *self, double half[2]);
    clod_region_fault (*fault)(
        const clod_case_region *self); ///< the first; NULL: no rules here
} clod_region_kind_row;

/** Row of a region's kind. Threads: pure. Test tests/config/test_region.c */
const clod_region_kind_row *clod_region_row(const clod_case_region *self);

/** Whether it is a disc or a rectangle. Threads: pure. */
bool clod_region_is_face(const clod_case_region *self);

/** Way of the grains through it [m]: its height, of a face its depth. Threads: pure. */
double clod_region_height(const clod_case_region *self);

/** Axes of a face: two in it, of a rectangle along its edges, and its normal; unit vectors.
 *  Threads: pure. */
void clod_region_axes(const clod_case_region *self, double axis[3][3]);

/** Half the extent of a face along its two axes in it [m]. Threads: pure. */
void clod_region_half(const clod_case_region *self, double half[2]);

/** Area across which grains come of a face, or the base of a box or annulus [m2]. Threads:
 *  pure. */
double clod_region_area(const clod_case_region *self);

/** Box around a region [m]; of a face around its depth. Threads: pure. */
void clod_region_bounds(const clod_case_region *self, double low[3], double high[3]);

/**
 * Whether two regions have space in common: exact for two boxes and for two annuli about one
 * axis, by the boxes around them otherwise. Regions that only touch have none.
 *
 * Threads  pure.   Test  tests/config/test_region.c
 */
bool clod_region_overlap(const clod_case_region *a, const clod_case_region *b);
