#pragma once
/**
 * @file free_measures.h
 * What a free run measures beside its stages: one row of a table each. The series, the report,
 * the summary and the checkpoint read that table.
 *
 * A measure looks at the state at moments of its own (`act`, `plan`) and whenever a row of the
 * series is due (`look`, `row`). What it remembers is plain data without pointers, part of the
 * checkpoint; so it must not depend on the order of rows or contacts, nor on threads.
 */

#include <jansson.h>
#include <stdint.h>
#include <stdio.h>

#include "clod/case.h"
#include "measure/contacts.h"
#include "output/folder.h"
#include "sim/frame.h"
#include "sim/free_paths.h"
#include "sim/news.h"
#include "sim/sight.h"
#include "sim/steady_time.h"
#include "state/wear.h"

/** What a measure looks at. */
typedef struct clod_free_moment {
    const clod_case *from;
    clod_state *state;         ///< a measure changes only what is its own, or asks for changes
    const clod_survey *survey; ///< of the bed at this moment; NULL in sight, report and json
    const clod_measure_motion *motion; ///< of the bed, in row; else NULL
    clod_steady_time steady;           ///< of this run: all means are those over it
} clod_free_moment;

/** The bed that a run begins with, wherever its grains are. */
typedef struct clod_free_start {
    int64_t grains;
    double mass;      ///< kg
    uint64_t last_id; ///< the largest; 0: there is none
} clod_free_start;

/** That of a state that has all grains. Threads: pure. */
clod_free_start clod_free_start_of(const clod_state *state);

/** One measure. Members may be NULL where nothing is to be done. */
typedef struct clod_free_measure {
    const char *key; ///< of its object in summary.json
    /** Bytes that it remembers in this case; NULL: none, and its memory is NULL. */
    size_t (*size)(const clod_case *from);
    /** The run begins; its memory is all zero. */
    void (*begin)(void *memory, const clod_case *from, const clod_state *state,
                  const clod_free_start *bed);
    /** What of the bed must be in the state, and not only in the survey's sums, to act at this step,
     *  into `sees`. NULL: nothing of it. */
    void (*sight)(const void *memory, const clod_free_moment *now, clod_sight *sees);
    /** Before every plan, at steps of its own: once for a step, however often it is called. */
    bool (*act)(void *memory, const clod_free_moment *now, clod_status *status);
    /** Steps until it must act; 1 or more. */
    int64_t (*plan)(const void *memory, const clod_case *from, const clod_state *state,
                    const clod_steady_time *steady);
    /** Whether what it remembers hangs on the wall of this name, which can neither go nor come while
     *  it measures; what needs it, into `text`. NULL: it goes on with the walls that there are. */
    bool (*needs)(const clod_case *from, const char *wall, char *text, size_t size);
    /** After every act: something that is to be said at once; false when there is nothing more.
     *  What was said is remembered. */
    bool (*news)(void *memory, const clod_case *from, const clod_state *state, clod_news *news);
    /** A row is due: look at the bed. */
    bool (*look)(void *memory, const clod_free_moment *now, clod_status *status);
    /** A snapshot is due: have the columns of grains that it shows filled, wherever these are; write
     *  what is shown beside it. */
    bool (*picture)(void *memory, const clod_free_moment *now, const clod_frame *frame,
                    clod_status *status);
    /** Number of its columns in the series. */
    size_t (*columns)(const clod_case *from, const clod_state *state);
    /** Header text of column k, with its unit: "exit.mass_flow [kg/s]". */
    void (*column)(const clod_case *from, const clod_state *state, size_t k, char *text,
                   size_t size);
    /** Values of its columns, after `look`; means over the time since the last row end here. */
    void (*row)(void *memory, const clod_free_moment *now, double *row);
    /** The sums of walls begin anew, and not by a row: take what they have. */
    void (*sums_end)(void *memory, const clod_free_moment *now);
    /** Lines for people at the end. */
    void (*report)(FILE *out, const void *memory, const clod_free_moment *now);
    /** Warnings about what it reports: texts into a list. */
    void (*warn)(json_t *list, const void *memory, const clod_free_moment *now);
    /** Whether summary.json of a run of this case has its object; NULL: always. */
    bool (*told)(const clod_case *from);
    /** The same as the report for programs, where it is told: a new object or array; NULL when there is nothing yet. */
    json_t *(*json)(const void *memory, const clod_free_moment *now);
    /** Paths of the numbers that its object may have, all of them, before a run: `state` has only the
     *  walls. Of a measure with json. */
    void (*paths)(const clod_case *from, const clod_state *state, clod_free_paths *paths);
    /** Files of its own at the end; their names stand in output/folder_names.c. */
    bool (*write)(const clod_folder *folder, const void *memory, const clod_free_moment *now,
                  clod_status *status);
} clod_free_measure;

/** Bytes that all measures of a case remember, with the time at which the run began. */
size_t clod_free_measures_size(const clod_case *from);

/** Whether a measure of the case needs the wall of this name: what does, into `text` [size]. */
bool clod_free_measures_need(const clod_case *from, const char *wall, char *text, size_t size);

/** The run begins. `memory` is [clod_free_measures_size], zero; the state has all grains. */
void clod_free_measures_begin(void *memory, const clod_case *from, const clod_state *state);

/** The same where they are elsewhere. */
void clod_free_measures_begin_with(void *memory, const clod_case *from, const clod_state *state,
                                   const clod_free_start *bed);

/** What measures with this memory look at now; the survey may be NULL in report and json. */
clod_free_moment clod_free_measures_moment(const void *memory, const clod_case *from,
                                           clod_state *state, const clod_survey *survey);

void clod_free_measures_sight(const void *memory, const clod_free_moment *now,
                              clod_sight *sees);

bool clod_free_measures_act(void *memory, const clod_free_moment *now, clod_status *status);

/** Steps until one must act; INT64_MAX when none ever must. */
int64_t clod_free_measures_plan(const void *memory, const clod_case *from,
                                const clod_state *state);

bool clod_free_measures_news(void *memory, const clod_case *from, const clod_state *state,
                             clod_news *news);

bool clod_free_measures_look(void *memory, const clod_free_moment *now, clod_status *status);

bool clod_free_measures_picture(void *memory, const clod_free_moment *now,
                                const clod_frame *frame, clod_status *status);

/** Number of all columns. */
size_t clod_free_measures_columns(const clod_case *from, const clod_state *state);

/** Bytes of the header text of a column. */
#define CLOD_FREE_COLUMN_TEXT (CLOD_WEAR_NAME + 64)

/** Header text of column k of all, the only one with its name. */
void clod_free_measures_column(const clod_case *from, const clod_state *state, size_t k,
                               char *text, size_t size);

/** Number of the measure that has column k of all: two measures may name a column alike. */
int clod_free_measures_owner(const clod_case *from, const clod_state *state, size_t k);

/** Values of all columns. */
void clod_free_measures_row(void *memory, const clod_free_moment *now, double *row);

/** Before the sums of walls begin anew otherwise than by a row. */
void clod_free_measures_sums_end(void *memory, const clod_free_moment *now);

void clod_free_measures_report(FILE *out, const void *memory, const clod_free_moment *now);

/** Add the warnings of all measures to a list of texts. */
void clod_free_measures_warn(json_t *list, const void *memory, const clod_free_moment *now);

/** Add the paths of the numbers that the objects of all measures may have in the summary of a run of
 *  this case, from its top; of the state only the walls are looked at. Errors  `lost`. */
void clod_free_measures_paths(const clod_case *from, const clod_state *state,
                              clod_free_paths *paths);

/** Put each measure's object into the summary under its key. */
void clod_free_measures_json(json_t *summary, const void *memory, const clod_free_moment *now);

/** Write the files that measures have of their own. */
bool clod_free_measures_write(const clod_folder *folder, const void *memory,
                              const clod_free_moment *now, clod_status *status);
