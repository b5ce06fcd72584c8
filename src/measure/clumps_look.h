#pragma once
/**
 * @file clumps_look.h
 * A look at the clumps of a bed, wherever its grains are: what they are, by several choices, and how
 * long grains have been in some. Grains know their clumps afterwards.
 */

#include "measure/clumps.h"
#include "parallel/exact.h"
#include "state/time_class.h"

/** Most choices of a look. */
#define CLOD_CLUMPS_CHOICES 9

/** What is looked for. The grains keep clumps. */
typedef struct clod_clumps_look {
    double bond;  ///< number of clod_bonds_find
    bool follows; ///< how long grains have been in clumps, since the last look that did
    int32_t choices;
    clod_clump_choice choice[CLOD_CLUMPS_CHOICES]; ///< grains know the clumps of the first
} clod_clumps_look;

/** Times that grains were in clumps, until they were in none; all zero: there is no such grain. */
typedef struct clod_clump_lives {
    int64_t grains;
    clod_exact sum;                   ///< s
    double least, most;               ///< s
    int64_t count[CLOD_TIME_CLASSES]; ///< how many were for so long
} clod_clump_lives;

/** Add others. Bits do not depend on how they were grouped. */
void clod_clump_lives_merge(clod_clump_lives *self, const clod_clump_lives *other);

/** Clumps of a choice. */
typedef struct clod_clumps_found {
    clod_clump_stats stats;
    clod_clump_sizes sizes;
} clod_clumps_found;

/** All that is found. */
typedef struct clod_clumps_seen {
    clod_clump_lives lives; ///< that ended
    clod_clumps_found found[CLOD_CLUMPS_CHOICES];
} clod_clumps_seen;

/**
 * Look.
 *
 * @param seen  [out]
 * Errors  CLOD_FAILED: memory.   Threads  one per bed.   Test  tests/step/test_ranks_clumps.c
 */
bool clod_clumps_look_at(const clod_clumps_look *self, const clod_survey *survey,
                         clod_clumps_seen *seen, clod_status *status);

extern const clod_survey_way CLOD_CLUMPS_LOOK_WAY;
