#pragma once
/**
 * @file crew_slabs.h
 * A bed that ranks step on its way into a file: in the order of one process, slab by slab, so that no
 * rank ever has more than its part and a slab (who writes side by side hands over a slab for each rank at a time). First every own grain gets its number in that order
 * (crew_number.c); then rank 0 asks for the grains with the next numbers, and for their contacts.
 *
 * Threads  thread 0 of each rank, all ranks at the same time.   Test  tests/step/test_ranks_slabs.c
 */

#include "base/bytes.h"
#include "state/bed_source.h"
#include "state/contact_walk.h"
#include "step/step.h"

typedef struct clod_crew clod_crew;

/** Grains of a slab. */
#define CLOD_CREW_SLAB 16384

/** What of the bed is asked for. */
typedef struct clod_crew_range {
    uint64_t first, count; ///< numbers of grains
    int64_t what;          ///< 0: these grains; 1: their contacts with grains; 2: with walls
} clod_crew_range;

/** All zero: nobody writes. */
typedef struct clod_crew_slabs {
    size_t own;       ///< rows
    int32_t *row;     ///< [own] they ascend; owned, as the next
    uint64_t *number; ///< [own] in the order of all grains: they ascend
    int32_t *each;    ///< [own] contacts with grains and walls; NULL: not wanted
    bool lines;       ///< are wanted with contacts of grains
    // contacts on their way out
    clod_step_reader reader;
    clod_contact_source contacts;
    clod_contact_walk walk;
    const clod_contact *due; ///< the next one; NULL: none is left
    size_t at;               ///< place in `row` of the last one's grain
    clod_bytes out, in;
    size_t *begin; ///< [ranks + 1]
    // of rank 0, and of every rank that writes
    clod_state rows; ///< of the last slab
    int32_t *rows_each;
    size_t each_room;
    clod_bed_counts all;
    clod_crew_range range;       ///< of the contacts that are there
    struct clod_sort_item *item; ///< [items] of them, in order
    size_t item_room, items, next;
} clod_crew_slabs;

/** How many of the numbers, which ascend, are smaller than a limit.  Threads: pure. */
size_t clod_crew_below(const uint64_t *number, size_t count, uint64_t limit);

/** Number the own rows of all ranks (crew_number.c). False on all alike: no memory, or rows that a
 *  failed rebuild has left in no order. */
bool clod_crew_number(clod_crew *self, clod_status *status);

/**
 * Number grains, and begin with the first contact.
 *
 * @param wants  of rank 0
 * @param all   [out] counts of the bed
 * @return      false on all alike: no memory, or a crew that is broken; then clod_crew_slabs_end
 */
bool clod_crew_slabs_begin(clod_crew *self, clod_bed_wants wants, clod_bed_counts *all,
                           clod_status *status);

/** Bring rank 0 what it asks for, into `in`: records of each rank. False on all alike. */
bool clod_crew_slabs_bring(clod_crew *self, const clod_crew_range *range, clod_status *status);

/**
 * Pack own grains of a range, or the next contacts of such grains, each with the number of its (first) grain: those
 * of the first CLOD_CREW_SLAB numbers into out[0], of the next ones into out[1], and so on.
 */
void clod_crew_slabs_pack(clod_crew *self, const clod_crew_range *range, clod_bytes *out);

/** Room for so many rows of a slab, with the columns that this rank's part has; false without memory. */
bool clod_crew_slabs_room(clod_crew *self, size_t count, clod_status *status);

/** Put grains that came, `in`, into the rows of the slab from number `first` on; false: it is not they. */
bool clod_crew_slabs_take(clod_crew_slabs *self, size_t first);

/** Order of contacts that came, `in`: by number of the first grain; those of one come in order. */
bool clod_crew_slabs_sort(clod_crew_slabs *self, clod_status *status);

/** Contact number k of them in that order. */
void clod_crew_slabs_contact(const clod_crew_slabs *self, size_t k, clod_contact *to,
                             uint64_t partners[2]);

/** Every rank writes its slabs into a file, and brings them to the disk (crew_write.c). */
bool clod_crew_write(clod_crew *self, clod_bed_layout *layout, bool *done, clod_status *status);

/** Every rank hashes its blocks of a file, whose hashes rank 0 gets; false on all alike: it is not known
 *  (crew_write.c). */
bool clod_crew_hash(clod_crew *self, clod_bed_file *file, uint64_t *hash);

/** Nothing is left of it. */
void clod_crew_slabs_end(clod_crew *self);
