#include "output/checkpoint_file.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "output/checkpoint.h"
#include "output/file.h"
#include "output/folder_files.h"

uint64_t clod_checkpoint_file_case_hash(const char *case_text)
{
    const char *text = case_text == NULL ? "" : case_text;
    return clod_file_hash(CLOD_FILE_HASH_START, text, strlen(text));
}

void clod_checkpoint_file_print_head(char text[CLOD_CHECKPOINT_HEAD_BYTES],
                                     const clod_checkpoint_head *head, const void *data)
{
    memset(text, 0, CLOD_CHECKPOINT_HEAD_BYTES);
    const int length = snprintf(text, CLOD_CHECKPOINT_HEAD_BYTES,
                                "clod checkpoint: HDF5 behind %d bytes\nformat %" PRId64
                                "\nsequence %" PRId64 "\nstep %" PRId64 "\ntime %.17g s\n"
                                "case %016" PRIx64 "\nbytes %" PRIu64 "\n",
                                CLOD_CHECKPOINT_HEAD_BYTES, head->format, head->sequence,
                                head->step, head->time, head->case_hash, head->bytes);
    uint64_t hash = clod_file_hash(CLOD_FILE_HASH_START, text, (size_t)length);
    hash = clod_file_hash(hash, data, head->bytes);
    snprintf(text + length, CLOD_CHECKPOINT_HEAD_BYTES - (size_t)length,
             "hash %016" PRIx64 "\n", hash);
}

static bool scan_head(const char text[CLOD_CHECKPOINT_HEAD_BYTES], clod_checkpoint_head *head)
{
    char line[CLOD_CHECKPOINT_HEAD_BYTES + 1];
    memcpy(line, text, CLOD_CHECKPOINT_HEAD_BYTES);
    line[CLOD_CHECKPOINT_HEAD_BYTES] = '\0';
    // a number out of range is found by printing the head again: NOLINTNEXTLINE(cert-err34-c)
    return sscanf(line,
                  "clod checkpoint: HDF5 behind 512 bytes format %" SCNd64 " sequence %" SCNd64
                  " step %" SCNd64 " time %lf s case %" SCNx64 " bytes %" SCNu64
                  " hash %" SCNx64,
                  &head->format, &head->sequence, &head->step, &head->time, &head->case_hash,
                  &head->bytes, &head->hash) == 7;
}

/** Whether a file of `size` bytes is whole; else `reason` says why not. */
static bool check_whole(const char *bytes, size_t size, clod_checkpoint_head *head,
                        char *reason, size_t reason_size)
{
    if (size < CLOD_CHECKPOINT_HEAD_BYTES) {
        snprintf(reason, reason_size, "it has only %zu bytes, it was cut off", size);
        return false;
    }
    if (!scan_head(bytes, head)) {
        snprintf(reason, reason_size, "it does not begin like a checkpoint of clod");
        return false;
    }
    if (head->bytes != size - CLOD_CHECKPOINT_HEAD_BYTES) {
        snprintf(reason, reason_size, "it has %zu bytes, its head says %" PRIu64, size,
                 head->bytes + CLOD_CHECKPOINT_HEAD_BYTES);
        return false;
    }
    char again[CLOD_CHECKPOINT_HEAD_BYTES];
    clod_checkpoint_file_print_head(again, head, bytes + CLOD_CHECKPOINT_HEAD_BYTES);
    if (memcmp(again, bytes, CLOD_CHECKPOINT_HEAD_BYTES) != 0) {
        snprintf(reason, reason_size, "its content does not fit its checksum, it is damaged");
        return false;
    }
    return true;
}

static bool set_name(clod_checkpoint_file *file, const clod_folder *folder, const char *stem,
                     char letter, clod_status *status)
{
    const int length = snprintf(file->name, sizeof file->name, "%s_%c.h5", stem, letter);
    snprintf(file->path, sizeof file->path, "%s/%s", folder->path, file->name);
    return (size_t)length < sizeof file->name ||
           clod_file_fail(status, "name a checkpoint", stem, ENAMETOOLONG);
}

/** Whether an error is the disk's: the content is lost, and no second try brings it. */
static bool is_of_disk(int error)
{
    return error == EIO || error == EUCLEAN || error == EBADMSG;
}

bool clod_checkpoint_file_find(clod_checkpoint_file files[2], const clod_folder *folder,
                               const char *stem, clod_status *status)
{
    memset(files, 0, 2 * sizeof *files);
    for (int f = 0; f < 2; f++) {
        clod_checkpoint_file *file = &files[f];
        if (!set_name(file, folder, stem, "ab"[f], status)) {
            return false;
        }
        size_t size = 0;
        const int error = clod_file_load(folder->descriptor, file->name, &file->bytes, &size);
        file->there = error != ENOENT;
        if (error == 0) {
            file->whole =
                check_whole(file->bytes, size, &file->head, file->reason, sizeof file->reason);
        } else if (is_of_disk(error)) {
            snprintf(file->reason, sizeof file->reason, "it cannot be read: %s",
                     strerror(error));
        } else if (file->there) {
            return clod_folder_fail(folder, "read", file->name, error, status);
        }
    }
    return true;
}

void clod_checkpoint_file_release(clod_checkpoint_file files[2])
{
    for (int f = 0; f < 2; f++) {
        clod_memory_free(files[f].bytes);
        files[f].bytes = NULL;
    }
}

int clod_checkpoint_file_newest(const clod_checkpoint_file files[2])
{
    if (files[0].whole && files[1].whole) {
        return files[1].head.sequence > files[0].head.sequence ? 1 : 0;
    }
    return files[0].whole ? 0 : files[1].whole ? 1 : -1;
}

bool clod_checkpoint_exists(const clod_folder *folder, const char *stem, bool *exists,
                            clod_status *status)
{
    clod_checkpoint_file file;
    *exists = false;
    for (int f = 0; f < 2 && !*exists; f++) {
        if (!set_name(&file, folder, stem, "ab"[f], status) ||
            !clod_folder_has(folder, file.name, exists, status)) {
            return false;
        }
    }
    return true;
}
