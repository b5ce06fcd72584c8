#pragma once
/**
 * @file parts.h
 * A test of several parts: preparations, and what begins from the state that they leave. The
 * parts of a batch run side by side where cores allow.
 */

#include <jansson.h>

#include "sim/job.h"

/** One part of a test, and what is known of it when it is finished. */
typedef struct clod_part {
    char name[48];
    char from[48]; ///< name of the part whose end this one begins with; "" for a preparation
    int64_t seed;
    int64_t point;     ///< which of the points; below 0 for a preparation
    void *test;        ///< the procedure's data, and behind them those of measures; borrowed
    int64_t steps;     ///< of this part
    double dt;         ///< s
    double wall_clock; ///< s
    char version[CLOD_JOB_VERSION]; ///< of the clod that began this part
    char origin[CLOD_JOB_ORIGIN];   ///< of its specimen, if that is another run's
    size_t grains;
    double coordination;              ///< grain-grain contacts of a grain at the end
    double max_overlap, mean_overlap; ///< fraction of a radius, at the end
    double stable_step;               ///< s, largest stable time step at the end; 0: not known
    bool ok;
    clod_status status;
} clod_part;

/** What the tester does. */
typedef struct clod_parts_tester {
    clod_procedure procedure; ///< without data, which is each part's own
    /** Begin with the cell (setup/begin.h), or with the end of the part before it; the part
     *  with point -1 is the first. */
    void (*begin)(const clod_case *from, const clod_part *part, clod_state *state);
    /** The preparation is another run's: give it what this case says of all that follows. */
    void (*adopt)(const clod_case *from, const clod_part *part);
} clod_parts_tester;

/** Parts, each with room for the data of its test and what its measures remember; owned
 *  (clod_parts_destroy).   Errors  CLOD_FAILED: no memory, then NULL. */
clod_part *clod_parts_create(const clod_parts_tester *tester, const clod_case *from, int count,
                             clod_status *status);

/** Free; NULL is fine. */
void clod_parts_destroy(clod_part *self);

/** What the contacts at its end say against a part, in words: an overlap beyond what the laws are
 *  made for, a time step too near the largest stable one. */
void clod_parts_warn_end(json_t *list, const clod_part *part);

/**
 * Run a batch of parts side by side: in threads, or on groups of ranks.
 *
 * @return  false: the first part that failed gives the status, an interruption last
 */
bool clod_parts_run(const clod_parts_tester *tester, const clod_job_shared *sim,
                    clod_part *part, int count, clod_status *status);

/** Run one part with the ranks of `sim`; its status says how. */
void clod_parts_run_one(const clod_parts_tester *tester, const clod_job_shared *sim,
                        clod_part *part);

/** Whether every preparation of a batch can be taken over from another run; writes nothing. */
bool clod_parts_try_origin(const clod_parts_tester *tester, const clod_job_shared *sim,
                           clod_part *part, int count, clod_status *status);

/** What every tester's summary says of a part; a new object. */
json_t *clod_parts_json(const clod_part *part);

/** Put what a finished part has of fields and mixing (part_measures.h) into that object.
 *  Errors  CLOD_FAILED: its series cannot be read; no memory. */
bool clod_parts_put_measures(json_t *object, const clod_job_shared *sim, const clod_part *part,
                             clod_status *status);

/** Set a number, null when there is none. */
void clod_parts_set_number(json_t *object, const char *key, double value);

/**
 * Write summary.json: title, version, the parts, the tester's results, the warnings.
 *
 * @param results     under the key `name`; the reference is taken, as that of the parts
 * @param warnings    list of texts, borrowed
 * @param incomplete  why parts or results are missing; NULL when none are
 */
bool clod_parts_write_summary(const clod_job_shared *sim, json_t *parts, const char *name,
                              json_t *results, json_t *warnings, const char *incomplete,
                              clod_status *status);

/** What a summary says of a part, and the key of the locus of all. */
typedef struct clod_parts_locus {
    const char *name;
    json_t *(*part)(const clod_part *part);
} clod_parts_locus;

/**
 * The same for a tester whose result is a locus.
 *
 * @param text  the locus as JSON, taken and freed by clod_locus_free; NULL: none is known where
 *              `incomplete` says why, else there was no memory for it
 */
bool clod_parts_write_locus(const clod_job_shared *sim, const clod_parts_locus *how,
                            const clod_part *part, int parts, char *text, json_t *warnings,
                            const char *incomplete, clod_status *status);

/** A flag and what it says. */
typedef struct clod_parts_flag {
    int64_t flag;
    const char *word;
} clod_parts_flag;

/** The words of the flags that are set; a new list. @param words  [count] */
json_t *clod_parts_flags(int64_t flags, const clod_parts_flag *words, size_t count);

/**
 * Copy the parts that are finished, in their order.
 *
 * @param finished  [count] [out] what they point to is borrowed
 * @param count     of all parts
 * @return          how many are finished
 */
int clod_parts_finished(const clod_part *part, int count, clod_part *finished);

/** Tell the user that the results of `count` finished parts are in the folder. */
void clod_parts_tell_finished(const clod_job_shared *sim, int count, const char *table);

/** "1234 grains, dt ..., coordination ..., largest overlap at the end of WHAT ..." of part 0.
 */
int clod_parts_headline(const clod_part *part, int parts, const char *title, const char *what,
                        char *text, size_t size);
