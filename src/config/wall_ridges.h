#pragma once
/**
 * @file wall_ridges.h
 * Ridges on the plate of a wall friction test: what their keys come to.
 */

#include "clod/case.h"

/** Ridges as the plate has them; straight, so their section is the same all along. */
typedef struct clod_wall_ridges {
    int64_t count;  ///< 0: the plate is flat
    double spacing; ///< m, from crest to crest, in a ring at r_m
    double height;  ///< m
    double width;   ///< m, at the foot
    double crest;   ///< m
    double flank;   ///< rad, rise of a flank above the floor
    double room;    ///< m, width of ridges that meet
    double from;    ///< m; ring: radius at which a ridge begins; straight: least x of the plate
    double to;      ///< m; ring: radius at which it ends; straight: greatest x
    double volume;  ///< m3 of all ridges within the specimen; straight: mean over a spacing
} clod_wall_ridges;

/**
 * Ridges of the plate of a test.
 * Threads: pure.   Source  docs/theory/wall-friction.md#a-plate-with-ridges
 * Test     tests/config/test_wall_ridges.c
 */
clod_wall_ridges clod_wall_ridges_of(const clod_case_wall_friction *test);

/** Way at most of the plate in all of the programme [m]. */
double clod_wall_ridges_way(const clod_case_wall_friction *test);

/**
 * Roughness over the diameter of a grain, Rmax(L = d)/d: the largest difference of heights within a
 * length L = d along the way, over d.
 *
 * @param diameter  m, mean of the grains
 * Source  Uesugi & Kishida, Soils and Foundations 26 (1986) no. 4, 139-149.
 * Test    tests/config/test_wall_ridges.c
 */
double clod_wall_ridges_roughness(const clod_wall_ridges *self, double diameter);

/**
 * How deep a ball sinks between two ridges, from where it lies on a crest [m]. It rests on the floor, two
 * flanks or two edges.
 * Test  tests/config/test_wall_ridges.c
 */
double clod_wall_ridges_sink_depth(const clod_wall_ridges *self, double radius);
