#pragma once
/**
 * @file bed_source.h
 * A bed as files want it: grains and contacts in their order, slab by slab, wherever they are. Who
 * writes them needs no list of all.
 */

#include "state/contact_source.h"

typedef struct clod_bed_counts {
    size_t grains, pairs, walls; ///< the last two are contacts
} clod_bed_counts;

/** Some grains in a row. */
typedef struct clod_bed_slab {
    const clod_state *rows;  ///< they are its grains; borrowed until the next slab
    const int32_t *contacts; ///< [rows->grains.count] of each with grains and walls, if wanted
} clod_bed_slab;

/** What is wanted beside grains and contacts. */
typedef struct clod_bed_wants {
    bool each;  ///< numbers of contacts of each grain
    bool lines; ///< where the grains of contacts are
} clod_bed_wants;

/** A contact of two grains as a picture has it. */
typedef struct clod_bed_line {
    double place[2][4]; ///< m, centres and radii of both grains
    double pull_off;    ///< N; 0 too where nobody knows the laws
} clod_bed_line;

#define CLOD_BED_COLUMNS 32
#define CLOD_BED_PATH 4352

#define CLOD_BED_HEAD 512

/** A file that several processes look for by its path: whether it is the same, its number, size and first bytes
 *  tell. */
typedef struct clod_bed_file {
    char path[CLOD_BED_PATH];
    char folder[CLOD_BED_PATH]; ///< as the user gave it, for messages
    char name[256];             ///< of the file that will have its content, likewise
    uint64_t number, size;      ///< in its file system; bytes
    uint64_t start;             ///< of them that are a head
    char head[CLOD_BED_HEAD];   ///< the first of them
} clod_bed_file;

/** Where columns of grains and contacts lie in a file, as plain data. */
typedef struct clod_bed_layout {
    clod_bed_file file;
    clod_bed_counts all;
    size_t grain_columns, contact_columns;
    uint64_t grain[CLOD_BED_COLUMNS],
        contact[CLOD_BED_COLUMNS]; ///< first bytes, from the file's
} clod_bed_layout;

typedef struct clod_bed_source {
    void *context; ///< of the functions, borrowed

    /**
     * Go before the first grain and contact. Then `end`, in any case.
     *
     * Errors  CLOD_FAILED: memory, as of the next two.
     */
    bool (*begin)(void *context, clod_bed_wants wants, clod_bed_counts *all,
                  clod_status *status);

    /** Get the grains [first, first + count); `first` rises, or begins anew. */
    bool (*grains)(void *context, size_t first, size_t count, clod_bed_slab *slab,
                   clod_status *status);

    /**
     * Copy the next contacts, ascending: pairs, then walls.
     *
     * @param count     [in,out] room; how many there were: 0 only at the end
     * @param partners  [room] [out] ids of both grains; id of the grain and number of the wall
     * @param lines     [room] [out] of pairs, if they are wanted; else NULL
     */
    bool (*contacts)(void *context, size_t *count, clod_contact *to, uint64_t (*partners)[2],
                     clod_bed_line *lines, clod_status *status);

    void (*end)(void *context);

    /**
     * All who have a part of the bed write it at its places side by side, and bring it to the disk, between
     * `begin` and `end`, before the first `contacts`. NULL: nobody but the caller has any.
     *
     * @param done  [out] false: not all of them see the file; nothing was written
     * Errors  CLOD_FAILED: memory, the disk.
     */
    bool (*write)(void *context, clod_bed_layout *layout, bool *done, clod_status *status);

    /**
     * They hash the blocks of a file behind its first `start` bytes side by side; NULL with `write`.
     *
     * @param hash  [clod_file_blocks(size - start)] [out]
     * @return      false: not all of them see the file, or can read it; nothing is known
     */
    bool (*hash)(void *context, clod_bed_file *file, uint64_t *hash);
} clod_bed_source;

/** A bed that is in a state. */
typedef struct clod_bed_view {
    const clod_state *state; ///< borrowed
    clod_contact_list list;
    clod_contact_source contacts;
    clod_state rows; ///< of the slab; nothing in it is owned
    int32_t *each;   ///< [grains] owned
    size_t pairs;    ///< that are still to come
} clod_bed_view;

/**
 * A contact of two grains as a line.
 *
 * @param state  its rows
 * @param from   whose `strength` counts; it may be NULL
 * Threads  pure.
 */
clod_bed_line clod_bed_line_of(const clod_state *state, const clod_contact_source *from,
                               const clod_contact *contact);

/**
 * The grains and contacts of a state.
 *
 * @param self      [out] borrowed as long as the source is used
 * @param contacts  all its contacts; NULL: those of state->contacts
 * Test  tests/output/test_checkpoint_stream.c
 */
clod_bed_source clod_bed_source_of(clod_bed_view *self, const clod_state *state,
                                   const clod_contact_source *contacts);
