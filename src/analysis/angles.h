#pragma once
/**
 * @file angles.h
 * Angles of measured yield loci that no solid has, preshear points far below their line, and points above their preshear: columns are
 * exchanged, or have another unit.
 * A simulation is never refused for them, nor the points.csv of its results folder: a specimen of few
 * grains may have any. Its loci have a warning (warnings.h).
 */

#include "clod/locus.h"

// The least solids, spheres without friction, have 5.8 deg (Peyneau & Roux, Phys. Rev. E 78 (2008)
// 011307). Warnings begin at 5 and 65 deg; points that scatter may be on the far side of these.
#define CLOD_ANGLES_LEAST 1.0 ///< deg
#define CLOD_ANGLES_MOST 80.0 ///< deg, as of wall friction

/** Of the line at sigma_pre: less is no tau_pre. After 4 mm of preshear 0.56, docs/theory/yield-locus.md. */
#define CLOD_ANGLES_SHARE_LEAST 0.4

/** A file of points: those before `end` that no earlier file has. */
typedef struct clod_angles_source {
    const char *path;
    size_t end;
} clod_angles_source;

/**
 * Refuse measured yield loci of which phi_lin, or the angle phi_sf of preshear, is not 1 to 80 deg, those of which tau_pre is less
 * than 0.4 of the line at sigma_pre, and those with a point sheared at more than 1 % above its own preshear stress.
 *
 * @param study    of `points`
 * @param sources  [source_count] at least one; the last ends with the points
 * Errors  CLOD_USAGE with file, lines, preshear stress, value, range and what to look at; CLOD_FAILED: a folder cannot be looked at.
 * Threads pure.   Test  tests/analysis/test_angles.c, test_far_below.c
 */
bool clod_angles_check(const clod_locus_study *study, const clod_locus_point *points,
                       const clod_angles_source *sources, size_t source_count,
                       clod_status *status);
