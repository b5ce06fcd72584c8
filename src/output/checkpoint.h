#pragma once
/**
 * @file checkpoint.h
 * The state on disk: two files in turn, each whole or not there at all, every byte checked.
 *
 * The format is described in docs/results-folder.md.
 */

#include "output/folder.h"
#include "state/bed_source.h"
#include "state/bed_taker.h"
#include "state/state.h"

/**
 * A named blob of plain data that belongs to the run beside the state (tester, detectors).
 *
 * Its bytes are stored as they are, so a struct that is stored as a part has no pointers and no
 * gaps with chance bytes in them. Only the format number tells another layout: whoever changes
 * such a struct raises CLOD_CHECKPOINT_FORMAT. The structs are listed in
 * tests/output/test_checkpoint_parts.py, which watches over this.
 */
typedef struct clod_checkpoint_part {
    const char *name;
    void *data;
    size_t size;
} clod_checkpoint_part;

/**
 * Write the older of `<stem>_a.h5` and `<stem>_b.h5` anew, slab by slab straight into the file:
 * memory does not grow with the number of grains.
 *
 * @param stem        start of the files' names
 * @param state       what to store; its walls' shapes are not stored
 * @param bed         its grains and contacts; NULL: those of the state itself
 * @param parts       [part_count] further data of the run
 * @param case_text   whole text of the case; NULL stores none
 * @param status      [out] on failure both files of before are untouched
 * Errors  CLOD_FAILED: no folder, disk full, no memory.   Threads  one per stem.
 * Test    tests/output/test_checkpoint.c
 */
bool clod_checkpoint_write(const clod_folder *folder, const char *stem, const clod_state *state,
                           const clod_bed_source *bed, const clod_checkpoint_part *parts,
                           size_t part_count, const char *case_text, clod_status *status);

/**
 * Fill the state from the newest checkpoint that is whole.
 *
 * @param state        [in,out] its walls (names, shapes) must stand as the case gives them;
 *                     everything that changes in a run is filled in
 * @param parts        [part_count] data is filled; names and sizes must be the written ones
 * @param case_text    compared with the stored text; NULL: not compared
 * @param notice       [out] empty, or what the user should know: a file that could not be used
 * @param status       [out] why there is nothing to go on from; the state is then half filled
 * Errors  CLOD_USAGE: the case changed.  CLOD_FAILED: no whole checkpoint, another format,
 *         other walls or parts, no memory.   Threads  one per stem.
 * Test    tests/output/test_checkpoint.c
 */
bool clod_checkpoint_read(const clod_folder *folder, const char *stem, clod_state *state,
                          clod_checkpoint_part *parts, size_t part_count, const char *case_text,
                          char *notice, size_t notice_size, clod_status *status);

/** What is read of a checkpoint. */
typedef struct clod_checkpoint_wanted {
    const clod_checkpoint_part *parts; ///< [part_count] as above
    size_t part_count;
    const char *case_text;       ///< as above
    const clod_bed_taker *taker; ///< of grains and contacts; NULL: the state gets them
} clod_checkpoint_wanted;

/**
 * The same, with grains and contacts for somebody who takes them slab by slab.
 *
 * @param state  what the taker leaves of the grains; no contacts
 * Errors  as above, and those of the taker.   Test  tests/sim/test_deal_again.c
 */
bool clod_checkpoint_get(const clod_folder *folder, const char *stem, clod_state *state,
                         const clod_checkpoint_wanted *wanted, char *notice, size_t notice_size,
                         clod_status *status);

/** Whether one of the two files is there, whole or not. */
bool clod_checkpoint_exists(const clod_folder *folder, const char *stem, bool *exists,
                            clod_status *status);
