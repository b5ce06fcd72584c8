#pragma once
/**
 * @file touch_lists.h
 * What the near list keeps of contacts with meshes (touch.h).
 */

#include "mesh/surface_touch.h"
#include "step/touch_facets.h"

/** A grain near the meshes of a wall. */
typedef struct clod_touch_site {
    int32_t i; ///< row of the grain
    int32_t wall;
    int32_t pose;        ///< first row of one of the wall's shapes, with its pose
    int32_t plane;       ///< all there is near it; -1: the facets say more
    size_t lane, lanes;  ///< contacts that there can be, in the part's list
    size_t near, facets; ///< facets near it, in the part's list
} clod_touch_site;

/** A contact that there can be: one with a patch of a mesh, in a slot. */
typedef struct clod_touch_lane {
    const clod_surface *surface; ///< borrowed
    int32_t patch, slot;
    int32_t lane;
    size_t block; ///< of the list of walls
} clod_touch_lane;

/** Those of the grains of a part; arrays are kept. */
typedef struct clod_touch_part {
    clod_touch_site *site;
    clod_touch_lane *lane;
    clod_touch_facets table;
    uint32_t *near;        ///< [nears] places in the table
    clod_surface_hit *hit; ///< scratch, [hit_room]
    size_t sites, lanes, nears;
    size_t site_room, lane_room, near_room, hit_room;
    size_t placed; ///< lanes that have their block
    size_t row;    ///< of the first lane
    bool lacks_memory;
} clod_touch_part;

typedef struct clod_touch {
    clod_touch_part *part; ///< [parts]
    double (*row)[4];      ///< [1 + lanes] direction, and distance [m]; the first for padding
    size_t row_room;
    int32_t *facet; ///< [1 + lanes] nearest facet of each contact; NULL: nobody asks
    size_t facet_room;
} clod_touch;
