#pragma once
/**
 * @file check_testers.h
 * What the preflight does for each kind of case alone, and what it does it with; the rows that
 * name these functions are in sim/testers.c.
 */

#include <jansson.h>

#include "sim/check.h"

#define CLOD_CHECK_FILL_LIKELY 0.2  ///< s to fill a cell, with the lid's way down
#define CLOD_CHECK_LOAD_LIKELY 0.06 ///< s to consolidate or to reduce the load

/** By so much the timed lattice is faster than a random packing between walls. */
#define CLOD_CHECK_SAMPLE_EXCESS 1.3

#define CLOD_CHECK_BATCHES 3 ///< of a run at most, each after the one before

/** What the parts of a run ask for; parts of one batch run side by side. */
typedef struct clod_check_batch {
    int count;
    double time, longest; ///< s simulated: sum over the parts, and of the longest
} clod_check_batch;

/** Text that grows in the caller's buffer of CLOD_CHECK_TEXT bytes. */
typedef struct clod_check_page {
    char *text;
    size_t used;
} clod_check_page;

/** A number of the report and its key in JSON. */
typedef struct clod_check_real {
    const char *key;
    size_t offset;
} clod_check_real;

#define CLOD_CHECK_REAL(key, field)                                                            \
    {                                                                                          \
        key, offsetof(clod_check_report, field)                                                \
    }

/** Add a warning to the report, as long as there is room. */
void clod_check_warning(clod_check_report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** Add a line to the text: its name, "" for a further one, and what it says. */
void clod_check_line(clod_check_page *to, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** A time on the clock in words, such as "152 s" or "2 h 05 min". */
const char *clod_check_clock_words(double seconds, char words[32]);

/** Bytes in words, such as "1.5 GB". */
const char *clod_check_byte_words(double bytes, char words[32]);

/** Put numbers of the report into an object; null for what JSON cannot hold. */
void clod_check_put(json_t *to, const clod_check_report *r, const clod_check_real *entries,
                    size_t count);

/** The softening of the case, for people and in JSON; nothing when there is none. */
void clod_check_soften_write(clod_check_page *to, const clod_check_report *r);
void clod_check_soften_put(json_t *to, const clod_check_report *r);

/** What ranks would cost, when that is asked: estimate, text, JSON, warnings (check_ranks_tell.c). */
void clod_check_ranks_look(const clod_check_subject *subject, clod_check_report *report);
void clod_check_ranks_write(clod_check_page *to, const clod_check_report *r);
void clod_check_ranks_put(json_t *to, const clod_check_report *r);
void clod_check_ranks_warn(clod_check_report *r);

/** I = (shear rate) d sqrt(rho/sigma) with a rate that is the same everywhere
 * (docs/theory/time-step.md). */
double clod_check_inertia(const clod_check_subject *subject, double diameter, double rate,
                          double stress);

/** Between these heights the specimen settles, how far nobody knows before it is tried. It
 * aims at filling `depth` over `area` [m, m2]. */
bool clod_check_heights(const clod_check_subject *subject, double depth, double area,
                        clod_check_report *report, clod_status *status);

/** Fields, mixing indices and angles of repose that will say little (check_measures.c). */
void clod_check_measures_warn(const clod_check_subject *subject, clod_check_report *r);

/** Streams too fast for the step, outlets over inlets, walls beyond the domain (check_streams.c). */
void clod_check_streams_warn(const clod_check_subject *subject, clod_check_report *r);

/** Batches of a free run: its stages. */
int clod_check_free_batches(const clod_case *from, bool most,
                            clod_check_batch all[CLOD_CHECK_BATCHES]);

/** A shear test, in a ring or a Jenike cell (check_shear.c, check_shear_warn.c). */
bool clod_check_shear_look(const clod_check_subject *subject, clod_check_report *report,
                           clod_status *status);
int clod_check_shear_batches(const clod_case *from, bool most,
                             clod_check_batch all[CLOD_CHECK_BATCHES]);
void clod_check_shear_put(json_t *to, const clod_check_report *r);

/** What a ring has beside that: its bars. */
void clod_check_ring_warn(const clod_check_subject *subject, clod_check_report *r);
void clod_check_ring_write(clod_check_page *to, const clod_check_report *r);
void clod_check_ring_put(json_t *to, const clod_check_report *r);

void clod_check_jenike_warn(const clod_check_subject *subject, clod_check_report *r);
void clod_check_jenike_write(clod_check_page *to, const clod_check_report *r);

/** A wall friction test (check_wall_friction.c). */
bool clod_check_wall_look(const clod_check_subject *subject, clod_check_report *report,
                          clod_status *status);
int clod_check_wall_batches(const clod_case *from, bool most,
                            clod_check_batch all[CLOD_CHECK_BATCHES]);
void clod_check_wall_warn(const clod_check_subject *subject, clod_check_report *r);
void clod_check_wall_write(clod_check_page *to, const clod_check_report *r);
void clod_check_wall_put(json_t *to, const clod_check_report *r);

/** A uniaxial test (check_uniaxial.c). */
bool clod_check_uniaxial_look(const clod_check_subject *subject, clod_check_report *report,
                              clod_status *status);
int clod_check_uniaxial_batches(const clod_case *from, bool most,
                                clod_check_batch all[CLOD_CHECK_BATCHES]);
void clod_check_uniaxial_warn(const clod_check_subject *subject, clod_check_report *r);
void clod_check_uniaxial_write(clod_check_page *to, const clod_check_report *r);
void clod_check_uniaxial_put(json_t *to, const clod_check_report *r);
