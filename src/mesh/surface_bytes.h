#pragma once
/**
 * @file surface_bytes.h
 * A surface as bytes that another rank, of the same program, unpacks.
 *
 * Test  tests/parallel/test_mpirun.py
 */

#include "base/bytes.h"
#include "mesh/surface.h"

/** Append a surface. Threads: pure. */
void clod_surface_pack(const clod_surface *self, clod_bytes *to);

/**
 * Take the next surface, with one user.
 *
 * @param at  [in,out] where it begins; then where it ends
 * @return    clod_surface_release, or NULL without memory
 */
clod_surface *clod_surface_unpack(const char **at);
