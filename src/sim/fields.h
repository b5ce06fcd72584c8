#pragma once
/**
 * @file fields.h
 * Fields of the case (docs/fields.md): a measure of free runs, and of the parts of a test
 * (part_measures.h). Each is sampled at intervals of its own; a grid only in the steady time, since
 * all that it tells is its mean over that.
 */

#include "measure/continuum.h"
#include "sim/free_measures.h"

/** What one field remembers; plain data. The sums of the grids lie behind all of them. */
typedef struct clod_field_memory {
    int64_t next;        ///< step of the next sample
    int64_t row_samples; ///< of `row`
    int64_t row_told;    ///< `row` stands in the series: the next sample begins a new one
    int64_t samples[CLOD_STEADY_BLOCKS];
    double frame_time;               ///< s, of the last frame of a grid
    uint64_t frame_sum;              ///< checksum of the list of frames; 0: none yet
    double row[CLOD_CONTINUUM_SUMS]; ///< of a mean, since the last row
    double block[CLOD_STEADY_BLOCKS][CLOD_CONTINUUM_SUMS]; ///< of a mean, in the steady time
} clod_field_memory;

/** A field of the case. Threads: pure. */
clod_continuum clod_fields_make(const clod_case_field *from);

/** Number of a field among the memories; sums of a grid over its samples [points], in the steady
 *  time. Threads: pure. */
const clod_field_memory *clod_fields_memory(const void *memory, size_t number);
const double (*clod_fields_grid(const void *memory, const clod_case *from,
                                size_t number))[CLOD_CONTINUUM_SUMS];

/** Samples of the steady time. */
int64_t clod_fields_samples(const clod_field_memory *self);

/** Cells of a grid that a grain or a contact has ever reached (fields_files.c). */
int64_t clod_fields_used(const clod_continuum *field,
                         const double (*sums)[CLOD_CONTINUUM_SUMS]);

/** In a test: sums over samples begin anew, and the next row has a sample of each grid. */
void clod_fields_restart(void *memory, const clod_case *from, const clod_state *state);

/** In a test: frames that were written are another part's. */
void clod_fields_leave_frames(void *memory, const clod_case *from);

/** Put where a grid lies, and how many of its cells have something, into an object of the summary. */
void clod_fields_put_grid(json_t *object, const void *memory, const clod_case *from,
                          size_t number);

/** Put the means over a region, their deviations and its volume there.
 *  @param mean, deviation  [CLOD_CONTINUUM_NUMBERS] */
void clod_fields_put_means(json_t *object, const clod_case_field *asked, const double *mean,
                           const double *deviation);

/** Lines of the report, object of the summary (fields_report.c). */
void clod_fields_report(FILE *out, const void *memory, const clod_free_moment *now);
json_t *clod_fields_json(const void *memory, const clod_free_moment *now);

void clod_fields_paths(const clod_case *from, const clod_state *state, clod_free_paths *paths);

/** Files of the grids: at the end, and at a snapshot (fields_files.c). */
bool clod_fields_picture(void *memory, const clod_free_moment *now, const clod_frame *frame,
                         clod_status *status);
bool clod_fields_write(const clod_folder *folder, const void *memory,
                       const clod_free_moment *now, clod_status *status);

/** The same at the end of a part of a test, whose name is in `to`. */
bool clod_fields_write_part(const clod_frame *to, const void *memory,
                            const clod_free_moment *now, clod_status *status);

/**
 * Errors  CLOD_FAILED: memory.   Threads  one per state.
 * Test    tests/cli/test_fields.py
 */
extern const clod_free_measure CLOD_MEASURE_FIELDS;
