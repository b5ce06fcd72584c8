#pragma once
/**
 * @file origin.h
 * Another run from whose grains and histories this one begins (clod run CASE --from FOLDER).
 *
 * A test takes over its finished preparation and goes on with its own points; its case may
 * differ in what comes after. A free run takes grains, histories and the positions of walls of
 * the same name and shapes, and begins its own stages there.
 */

#include <limits.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdio.h>

#include "sim/job.h"
#include "state/state.h"

/** Borrowed by the run. */
typedef struct clod_origin {
    char folder[PATH_MAX];      ///< of the other run
    double time;                ///< s, of the moment that was asked for; below 0: none
    char text[CLOD_JOB_ORIGIN]; ///< its whole path and, if asked for, the time
    clod_folder *shelf;         ///< the same, open to be read; NULL: not opened; owned
    char stem[64];              ///< of its checkpoint that a free run begins with
    clod_case *from;            ///< its case, owned
    char *differences;          ///< a line for each key that is not the same; owned
    bool same_law;              ///< materials, contacts and time are the same
    bool same_domain;           ///< the domain is the same
    atomic_bool told;           ///< a part of a test has told in what the cases differ
} clod_origin;

/**
 * Which run options->from names. That is all a run needs of it that has taken over what it
 * begins with: the other one may be gone by then.
 *
 * @param self  [out] clod_origin_fini in any case
 * Errors  CLOD_USAGE: no time behind the @, the run's own folder.
 */
bool clod_origin_name(clod_origin *self, const clod_job_shared *sim, clod_status *status);

/**
 * Open that run unless it is open, and see in what its case differs from this one's.
 *
 * Errors  CLOD_USAGE: no results folder, a time at which nothing was kept, a case that cannot
 *         begin there.   Threads  safe.   Test  tests/restart/test_from.py
 */
bool clod_origin_open(clod_origin *self, const clod_job_shared *sim, clod_status *status);

void clod_origin_fini(clod_origin *self);

/**
 * The state of a free run that begins from the other run's grains.
 *
 * @param state  [out] owned by the caller (clod_state_fini), also after a failure
 * @param told   [out] owned text (clod_memory_free): what was taken over, what not, what
 * differs Errors  CLOD_USAGE: a material that is not there, grains outside the domain; a
 * checkpoint that cannot be used.   Test  tests/restart/test_from.py
 */
bool clod_origin_state(const clod_origin *self, const clod_case *from, clod_state *state,
                       char **told, clod_status *status);

/**
 * Try the first step of such a state: the grains may overlap its walls too far.
 *
 * Errors  CLOD_USAGE: it cannot be stepped.
 */
bool clod_origin_try(const clod_origin *self, const clod_case *from,
                     const clod_run_options *options, clod_status *status);

/** Print in what the cases differ, or that they do not; the origin is open. */
void clod_origin_print_differences(const clod_origin *self, FILE *out);

/** Refuse to go on with a run that began from another one than `self` (NULL: not asked). */
bool clod_origin_is_that(const clod_origin *self, const char *text, const char *directory,
                         clod_status *status);

/** Say that what went wrong is in the other run's folder; returns false. */
bool clod_origin_fail(const clod_origin *self, clod_status *status);
