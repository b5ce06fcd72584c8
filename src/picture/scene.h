#pragma once
/**
 * @file scene.h
 * What a picture shows, ready to be drawn: spheres, triangles and lines with their colours.
 */

#include <stddef.h>
#include <stdint.h>

#include "picture/colour_map.h"

/** Numbers of colours beside the two maps. */
enum {
    CLOD_SCENE_GRAIN = 0,                       ///< first of the map of grains
    CLOD_SCENE_WALL = CLOD_COLOUR_MAP_SIZE,     ///< first of the map of walls
    CLOD_SCENE_NONE = 2 * CLOD_COLOUR_MAP_SIZE, ///< a value that is no number
    CLOD_SCENE_STILL,                           ///< walls that stay
    CLOD_SCENE_MOVING,                          ///< walls whose surface moves
    CLOD_SCENE_LINE,                            ///< edges
    CLOD_SCENE_MARK,                            ///< first of two kinds of marked edges
    CLOD_SCENE_COLOURS = CLOD_SCENE_MARK + 2,
};

/** Everything owned (clod_scene_fini). */
typedef struct clod_scene {
    size_t spheres;
    double (*center)[3]; ///< m
    double *radius;      ///< m
    uint16_t *shade;     ///< number of the colour
    size_t triangles;
    double (*corner)[3][3]; ///< m
    double (*normal)[3][3]; ///< of the surface at the corners
    uint16_t *paint;        ///< number of the colour
    int32_t *wall;          ///< number of the wall
    int32_t *part;          ///< number of the named part of a mesh or belt; -1: none
    uint8_t *veiled;        ///< shown as a veil, so that the grains behind are seen
    size_t lines;
    double (*end)[2][3]; ///< m
    size_t marks;
    double (*mark)[2][3]; ///< m; broader lines, in exactly their colour
    uint16_t *ink;        ///< number of the colour
    double colour[CLOD_SCENE_COLOURS][3];
} clod_scene;

void clod_scene_fini(clod_scene *self);
