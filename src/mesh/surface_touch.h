#pragma once
/**
 * @file surface_touch.h
 * Which facets a grain touches, each place once (docs/adr/0033).
 *
 * Contacts are the places of the surface that are nearer to the grain's centre than all around
 * them. Facets are taken from the nearest on. A facet is no contact of its own
 * 1. when a facet that is nearer holds its closest point, which is on a common edge or corner,
 *    or on a line along which facets of other sizes meet;
 * 2. when it is of the same smooth piece as a contact, and their directions differ by less than
 *    the smooth angle: a bend inwards of a smooth surface;
 * 3. when a nearer facet lies between it and the centre: the other side of a plate;
 * 4. when its patch has a nearer contact in the same slot;
 * 5. when a crack lies between it and a nearer facet, narrower than CLOD_SURFACE_CRACK of the
 *    grain's radius, and it is in nearly the same direction as the contact of that one: sheets that
 *    should meet, of one file or several.
 * It goes with the contact for which it was left out, which takes over its history.
 */

#include "mesh/surface_facet.h"

/** Width of a crack that a grain does not feel, as a fraction of its radius. */
#define CLOD_SURFACE_CRACK 0.02

/** Cosine of the angle by which the directions of both sides of a crack may differ at a rim, 20 deg:
 *  those of a plane do at an overlap of 6 % of the radius. */
#define CLOD_SURFACE_CRACK_COSINE 0.94

/** Contacts that a grain can have with one patch at the same time. */
#define CLOD_SURFACE_SLOTS 4

/** A facet that overlaps a grain. */
typedef struct clod_surface_hit {
    clod_surface_closest at;
    const clod_surface_facet *of; ///< borrowed from the list
    uint32_t facet;
    uint32_t patch;
    int32_t slot; ///< of its patch
    int32_t root; ///< the contact with which it goes: a hit; its own number if it is one
} clod_surface_hit;

/**
 * Find the contacts of a grain with the surfaces of one wall.
 *
 * @param facets  a table
 * @param near    [count] places in it of near ones, of which those that overlap are looked at
 * @param p       centre, in the surfaces' frame [m]
 * @param hits    [count] [out] facets that overlap, from the nearest on
 * @return        how many those are
 * Errors  none.   Threads  pure.   Test  tests/mesh/test_surface_touch.c
 */
int32_t clod_surface_touch(const clod_surface_facet *facets, const uint32_t *near,
                           int32_t count, clod_vec3 p, double radius, clod_surface_hit *hits);

/**
 * Closest point of a patch.
 *
 * @param most  m, farther ones do not count
 * @param slot  [out] of a contact there
 * @return      infinitely far where there is none
 * Threads  pure.   Test  tests/sim/test_sim_mesh_ledger.c
 */
clod_surface_closest clod_surface_place_closest(const clod_surface *self, int32_t patch,
                                                clod_vec3 p, double most, int32_t *slot);

/**
 * Closest point of a patch among those whose contacts have a slot: where its contact in that slot
 * is.
 *
 * @param most  m, farther ones do not count
 * @return      infinitely far where there is none
 * Threads  pure.   Test  tests/sim/test_sim_mesh_force.c
 */
clod_surface_closest clod_surface_slot_closest(const clod_surface *self, int32_t patch,
                                               int32_t slot, clod_vec3 p, double most);
