#pragma once
/**
 * @file checkpoint_file.h
 * The two files of a checkpoint from outside: their heads, and which of them is whole.
 */

#include <limits.h>
#include <stdint.h>

#include "output/folder_files.h"
#include "state/bed_source.h"

/**
 * Raise it with every change of what a checkpoint holds or means: columns, and the plain data
 * of the parts (clod_checkpoint_part), of which a checkpoint knows only name and size. Test
 * tests/output/test_checkpoint_parts.py fails when their structs change and this does not.
 */
#define CLOD_CHECKPOINT_FORMAT 29
#define CLOD_CHECKPOINT_HEAD_BYTES 512 ///< HDF5 looks for its own start at this byte too

/** The text in front of the HDF5 data; every other byte of the file is in its hash. */
typedef struct clod_checkpoint_head {
    int64_t format, sequence, step;
    double time;
    uint64_t case_hash, bytes, hash;
} clod_checkpoint_head;

/** One of the two files, as found. */
typedef struct clod_checkpoint_file {
    char name[NAME_MAX + 1];            ///< in the folder
    char path[PATH_MAX + NAME_MAX + 2]; ///< for messages
    bool there, whole;
    char reason[512]; ///< why it is not whole
    clod_checkpoint_head head;
    int descriptor; ///< owned; of the open file when it is whole, else -1
} clod_checkpoint_file;

/** A file that is read through, and who helps. */
typedef struct clod_checkpoint_reader {
    const clod_folder *folder;
    const char *part;           ///< its name in the folder now
    const clod_bed_source *bed; ///< whose `hash` is asked; NULL: nobody helps
} clod_checkpoint_reader;

/** Hash of a case's text; NULL counts as the empty text. */
uint64_t clod_checkpoint_file_case_hash(const char *case_text);

/**
 * Print the head; its hash is made of the lines before it and head->bytes of the open file
 * behind CLOD_CHECKPOINT_HEAD_BYTES.
 *
 * @return  0 or the errno value of a read that failed
 */
int clod_checkpoint_file_print_head(char text[CLOD_CHECKPOINT_HEAD_BYTES],
                                    const clod_checkpoint_head *head, int descriptor,
                                    const clod_checkpoint_reader *reader);

/** What of a draft several processes look for; false: it cannot be told. */
bool clod_checkpoint_file_name(const clod_folder_draft *draft, clod_bed_file *file);

/** Put the head before what was written into a draft. */
bool clod_checkpoint_file_seal(const clod_folder_draft *draft, const clod_checkpoint_head *head,
                               const clod_bed_source *bed, clod_status *status);

/**
 * Find the whole file that was written last; call clod_checkpoint_file_release in any case. It is read through and
 * checked, and the other one if it is not whole.
 *
 * @param both  check the other one in any case, to tell what is wrong with it; else it may count as not
 *              whole unread
 * @param bed   who helps to read; NULL: nobody
 *
 * A file that the disk cannot read (EIO) is there and not whole; the other one may do. Every
 * other error but ENOENT (no right, no memory) fails: the file may be good.
 */
bool clod_checkpoint_file_find(clod_checkpoint_file files[2], const clod_folder *folder,
                               const char *stem, bool both, const clod_bed_source *bed,
                               clod_status *status);

void clod_checkpoint_file_release(clod_checkpoint_file files[2]);

/** Index of the whole file written last, of those found, or -1. */
int clod_checkpoint_file_newest(const clod_checkpoint_file files[2]);
