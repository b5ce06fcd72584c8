#pragma once
/**
 * @file grains.h
 * All groups of grains of a case: inserted at random, or read one by one from a file.
 */

#include "clod/case.h"
#include "setup/pieces.h"

/** How many groups come during the run, through an inlet. Threads: pure. */
size_t clod_setup_grains_coming(const clod_case *from);

/**
 * Whether every inlet opens before the stages end.
 * Errors  CLOD_USAGE, of the inlet's start.   Threads  pure.   Test  tests/cli/test_check.py
 */
bool clod_setup_grains_open(const clod_case *from, clod_status *status);

/** Of the smallest grain of a group, how many are due through its inlet until the run ends: below 0.5 none comes.
 *  Threads: pure. */
double clod_setup_grains_due(const clod_case *from, size_t k);

/**
 * Number of grains to expect of all groups, without making one; those of files do not count.
 *
 * @param share  of them, that this machine has to hold; 0: none
 * Errors  CLOD_USAGE: more than this machine can hold; CLOD_FAILED.   Threads  pure.
 */
bool clod_setup_grains_expect(const clod_case *from, double share, double *grains,
                              clod_status *status);

/**
 * Mass of all grains that the case asks for [kg]; 0 when a group does not say one, neither by
 * mass nor by fill_height.
 */
double clod_setup_grains_mass(const clod_case *from);

/**
 * Say so when the grains weigh 5 % more or less than the case asks for: whole grains do not
 * make up every mass.
 *
 * @return  false: nothing to say
 * Threads  pure.   Test  tests/sim/test_check_amount.c, tests/cli/test_messages.py
 */
bool clod_setup_grains_say_off(const clod_case *from, const clod_setup_bed *bed, char *text,
                               size_t size);

/**
 * Append the grains of a case to a state whose walls and domain are there.
 *
 * Ids go from 1 upwards, group after group; a file may bring its own.
 *
 * @param seed   of sizes and positions
 * @param tally  [out] of them (clod_setup_tally_fini, also after a failure; zero before)
 * Errors  CLOD_USAGE: grains that do not fit, an amount below one grain or beyond memory, a
 *         wrong file, a grain outside the domain, an id twice; CLOD_FAILED.
 * Threads pure.   Test  tests/setup/test_setup_state.c
 */
bool clod_setup_grains(const clod_case *from, int64_t seed, clod_state *state,
                       clod_setup_tally *tally, clod_status *status);

/** Whether the grains of a case can be made piece by piece: none is read from a file. Threads: pure. */
bool clod_setup_grains_in_pieces(const clod_case *from);

/**
 * Make the same grains piece by piece, for somebody who takes each piece. Of groups in layers only
 * some layers are in memory; of those at random positions their places, some 150 bytes a grain of
 * the group.
 *
 * @param state  what the taker leaves of them
 * Errors  as above.   Threads  pure.   Test  tests/sim/test_deal.c
 */
bool clod_setup_grains_give(const clod_case *from, int64_t seed, const clod_setup_taker *taker,
                            clod_state *state, clod_setup_tally *tally, clod_status *status);

/** The pair of grains with the largest overlap. */
typedef struct clod_setup_overlap {
    uint64_t id_a, id_b; ///< 0, 0 when no grains overlap
    double overlap;      ///< m
    double ratio;        ///< overlap / smaller radius
} clod_setup_overlap;

/**
 * Look for the worst overlap of any two grains; packings from files have many.
 * Errors  CLOD_FAILED without memory.   Threads  pure.
 */
bool clod_setup_worst_overlap(const clod_state *state, clod_setup_overlap *worst,
                              clod_status *status);
