#pragma once
/**
 * @file check_ranks.h
 * What ranks would cost: the closed form of docs/scaling.md, for an even bed whose cube is halved
 * across its longest axis until each rank has a box.
 *
 * Errors  none.   Threads  pure.   Source  docs/scaling.md, bench/scaling/model.py.
 * Test    tests/sim/test_check_ranks.c, tests/cli/test_check_ranks.py
 */

#include <stdbool.h>

/** An even bed on ranks. */
typedef struct clod_check_ranks_bed {
    double grains;
    int ranks;     ///< that step it
    double layers; ///< reach of a box: edge of the cube that a grain has in the mean is 1
} clod_check_ranks_bed;

/** Of the rank that has most. */
typedef struct clod_check_ranks_share {
    double own, ghosts; ///< grains
    double neighbours;  ///< ranks that it sends to in each step
} clod_check_ranks_share;

/** What computes, and what lies between. */
typedef struct clod_check_ranks_machine {
    double row, row_one; ///< s of an own row, with all threads of a rank and with one
    int node;            ///< ranks that one machine holds
} clod_check_ranks_machine;

/** What decides how the bed begins, and whether it is gathered. */
typedef struct clod_check_ranks_start {
    double made;   ///< grains that rank 0 makes
    double solid;  ///< fraction of their regions that is solid
    bool whole;    ///< rank 0 has the whole bed at the start
    bool gathered; ///< and while it steps
} clod_check_ranks_start;

/** Bytes beyond the empty program. */
typedef struct clod_check_ranks_memory {
    double begin_0, begin; ///< of rank 0 and of another, while the bed is made and dealt
    double steps_0, steps; ///< and in steps, with a rebuild
} clod_check_ranks_memory;

/**
 * How far a rank sees beyond its box: a mean and a largest radius and the wide skin, over the edge
 * of the cube that a grain has in the mean.
 *
 * @param volume    m3, mean of a grain
 * @param fraction  solid fraction of the bed
 */
double clod_check_ranks_layers(double radius_mean, double radius_max, double volume,
                               double fraction);

clod_check_ranks_share clod_check_ranks_share_of(const clod_check_ranks_bed *bed);

/** s of one merge of all ranks. */
double clod_check_ranks_merge(int ranks, int node);

/** s of a step of the rank that has most; without imbalance and rebuilds. */
double clod_check_ranks_step(const clod_check_ranks_bed *bed,
                             const clod_check_ranks_machine *machine);

/** s in which rank 0 makes its grains: those of one process. */
double clod_check_ranks_making(const clod_check_ranks_start *start);

/** s of a checkpoint of so many bytes: rank 0 writes it, and collects it from the others. */
double clod_check_ranks_writing(const clod_check_ranks_bed *bed, double bytes);

clod_check_ranks_memory clod_check_ranks_memory_of(const clod_check_ranks_bed *bed,
                                                   const clod_check_ranks_start *start);
