#pragma once
/**
 * @file impact.h
 * Which contacts with walls begin with an impact.
 *
 * A contact that begins while the grain comes closer is one, unless the grain touches a wall
 * elsewhere in nearly the same direction (CLOD_SURFACE_CRACK_COSINE): then it goes on from one
 * place to the next, over a seam between two shapes. Of contacts that begin in the same step in
 * nearly the same direction the first of the list counts. Seams and edges within a mesh need no
 * rule: there the history goes on, so no contact begins (docs/adr/0033).
 *
 * Source  docs/theory/wear.md.   Test  tests/step/test_impact.c
 */

#include "step/near.h"

/**
 * Whether a contact that has closed in this step begins with an impact.
 *
 * @param part    of the near list
 * @param group   of the part's contacts with walls
 * @param number  of the contact in its group
 * Errors  none.   Threads  after the walls' contacts of all threads.
 */
bool clod_impact_begins(const clod_near *near, int part, size_t group, size_t number);
