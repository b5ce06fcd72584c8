#pragma once
/**
 * @file flush_walls.h
 * Walls at rest beside each other that have a face in common: facets that lie over or beside those of another wall
 * in one plane, or in a plane or a box's face. A grain there is pushed by both.
 *
 * Facets of the meshes of one wall are one surface; those of different walls, which may part, are not, and
 * facets on a plane or a box are not either, whose wall ever it is. Where two bodies lie face to face no grain comes;
 * that a sheet stands on a plane or two walls cross is fine too.
 */

#include "clod/case.h"
#include "state/walls.h"

/** What is told of two walls: a text of at most CLOD_SETUP_FLUSH_TEXT bytes. */
typedef void (*clod_setup_flush_tell)(void *context, const char *text);

#define CLOD_SETUP_FLUSH_TEXT 512

/**
 * Tell of walls with a face in common, as they are now, whose distance no stage changes.
 *
 * @param radius  m, of a mean grain: gaps of less than CLOD_SURFACE_CRACK of it are none. 0: that of the smallest
 *                of the case
 * Threads  pure.   Test  tests/setup/test_flush_walls.c
 */
void clod_setup_flush_doubts(const clod_case *from, const clod_walls *walls, double radius,
                             clod_setup_flush_tell tell, void *context);
