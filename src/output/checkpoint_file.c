#include "output/checkpoint_file.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>

#include "base/memory.h"
#include "output/checkpoint.h"
#include "output/file.h"

uint64_t clod_checkpoint_file_case_hash(const char *case_text)
{
    const char *text = case_text == NULL ? "" : case_text;
    return clod_file_hash(CLOD_FILE_HASH_START, text, strlen(text));
}

/** What of an open file several processes look for; false: it cannot be told. */
static bool name_file(const clod_folder *folder, const char *part, const char *name,
                      int descriptor, clod_bed_file *file)
{
    struct stat info;
    char *real = realpath(folder->path, NULL);
    *file = (clod_bed_file){.number = 0};
    const bool good =
        real != NULL && fstat(descriptor, &info) == 0 &&
        (size_t)snprintf(file->path, sizeof file->path, "%s/%s", real, part) <
            sizeof file->path &&
        (size_t)snprintf(file->folder, sizeof file->folder, "%s", folder->path) <
            sizeof file->folder &&
        (size_t)snprintf(file->name, sizeof file->name, "%s", name) < sizeof file->name;
    if (good) {
        file->number = (uint64_t)info.st_ino;
        file->size = (uint64_t)info.st_size;
        file->start = CLOD_CHECKPOINT_HEAD_BYTES;
    }
    free(real); // the C library's own
    return good && file->size >= sizeof file->head &&
           clod_file_read_at(descriptor, 0, file->head, sizeof file->head) == 0;
}

bool clod_checkpoint_file_name(const clod_folder_draft *draft, clod_bed_file *file)
{
    char mark[16]; // of this draft alone, until it has its head
    return getrandom(mark, sizeof mark, 0) == (ssize_t)sizeof mark &&
           clod_file_write_at(draft->descriptor, 0, mark, sizeof mark) == 0 &&
           name_file(draft->folder, draft->part, draft->name, draft->descriptor, file);
}

/** Hashes of all blocks behind the head, by all who help, or here; 0 or an errno value. */
static int hash_blocks(const clod_checkpoint_reader *reader, int descriptor, uint64_t bytes,
                       uint64_t *block)
{
    const clod_bed_source *bed = reader->bed;
    clod_bed_file file;
    if (bed != NULL && bed->hash != NULL &&
        name_file(reader->folder, reader->part, reader->part, descriptor, &file) &&
        file.size == file.start + bytes && bed->hash(bed->context, &file, block)) {
        return 0;
    }
    int error = 0;
    for (uint64_t k = 0; error == 0 && k < clod_file_blocks(bytes); k++) {
        error =
            clod_file_hash_block(descriptor, CLOD_CHECKPOINT_HEAD_BYTES, bytes, k, &block[k]);
    }
    return error;
}

/** Continue a hash over the hashes of so many bytes behind the head; 0 or an errno value. */
static int hash_file(const clod_checkpoint_reader *reader, uint64_t *hash, int descriptor,
                     uint64_t bytes)
{
    const size_t blocks = (size_t)clod_file_blocks(bytes);
    uint64_t *block = clod_memory_alloc(blocks + 1, sizeof *block);
    const int error = block != NULL ? hash_blocks(reader, descriptor, bytes, block) : ENOMEM;
    if (error == 0) {
        *hash = clod_file_hash_words(*hash, block, blocks * sizeof *block);
        *hash = clod_file_hash_end(*hash, bytes);
    }
    clod_memory_free(block);
    return error;
}

int clod_checkpoint_file_print_head(char text[CLOD_CHECKPOINT_HEAD_BYTES],
                                    const clod_checkpoint_head *head, int descriptor,
                                    const clod_checkpoint_reader *reader)
{
    memset(text, 0, CLOD_CHECKPOINT_HEAD_BYTES);
    const int length = snprintf(text, CLOD_CHECKPOINT_HEAD_BYTES,
                                "clod checkpoint: HDF5 behind %d bytes\nformat %" PRId64
                                "\nsequence %" PRId64 "\nstep %" PRId64 "\ntime %.17g s\n"
                                "case %016" PRIx64 "\nbytes %" PRIu64 "\n",
                                CLOD_CHECKPOINT_HEAD_BYTES, head->format, head->sequence,
                                head->step, head->time, head->case_hash, head->bytes);
    uint64_t hash = clod_file_hash(CLOD_FILE_HASH_START, text, (size_t)length);
    const int error = hash_file(reader, &hash, descriptor, head->bytes);
    snprintf(text + length, CLOD_CHECKPOINT_HEAD_BYTES - (size_t)length,
             "hash %016" PRIx64 "\n", hash);
    return error;
}

bool clod_checkpoint_file_seal(const clod_folder_draft *draft, const clod_checkpoint_head *head,
                               const clod_bed_source *bed, clod_status *status)
{
    char text[CLOD_CHECKPOINT_HEAD_BYTES];
    const clod_checkpoint_reader reader = {draft->folder, draft->part, bed};
    int error = clod_checkpoint_file_print_head(text, head, draft->descriptor, &reader);
    if (error == 0) {
        error = clod_file_write_at(draft->descriptor, 0, text, sizeof text);
    }
    return error == 0 || clod_folder_fail(draft->folder, "write", draft->name, error, status);
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

/**
 * Read the head of an open file of `size` bytes; when it is not one, or not of so many bytes, `reason`
 * says so.
 *
 * @return  0 or an errno value
 */
static int read_head(clod_checkpoint_file *file, size_t size)
{
    if (size < CLOD_CHECKPOINT_HEAD_BYTES) {
        snprintf(file->reason, sizeof file->reason, "it has only %zu bytes, it was cut off",
                 size);
        return 0;
    }
    char text[CLOD_CHECKPOINT_HEAD_BYTES];
    clod_checkpoint_head *head = &file->head;
    const int error = clod_file_read_at(file->descriptor, 0, text, sizeof text);
    if (error != 0) {
        return error;
    }
    if (!scan_head(text, head)) {
        *head = (clod_checkpoint_head){0};
        snprintf(file->reason, sizeof file->reason,
                 "it does not begin like a checkpoint of clod");
    } else if (head->bytes != size - CLOD_CHECKPOINT_HEAD_BYTES) {
        snprintf(file->reason, sizeof file->reason, "it has %zu bytes, its head says %" PRIu64,
                 size, head->bytes + CLOD_CHECKPOINT_HEAD_BYTES);
    }
    return 0;
}

/** Open a file and read its head; 0 or an errno value. */
static int open_head(clod_checkpoint_file *file, const clod_folder *folder)
{
    file->descriptor = clod_file_open(folder->descriptor, file->name, O_RDONLY);
    if (file->descriptor < 0) {
        return errno;
    }
    struct stat info;
    return fstat(file->descriptor, &info) == 0 ? read_head(file, (size_t)info.st_size) : errno;
}

/** Read a file with a good head through; else its `reason` says why it is not whole. 0 or an errno value. */
static int check_whole(clod_checkpoint_file *file, const clod_checkpoint_reader *reader)
{
    char text[CLOD_CHECKPOINT_HEAD_BYTES], again[CLOD_CHECKPOINT_HEAD_BYTES] = "";
    int error = clod_file_read_at(file->descriptor, 0, text, sizeof text);
    if (error == 0) {
        error = clod_checkpoint_file_print_head(again, &file->head, file->descriptor, reader);
    }
    file->whole = error == 0 && memcmp(again, text, sizeof text) == 0;
    if (error == 0 && !file->whole) {
        snprintf(file->reason, sizeof file->reason,
                 "its content does not fit its checksum, it is damaged");
    }
    return error;
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

/** What an error means for a file: it is not there, the disk cannot read it, or the search fails. */
static bool take_error(clod_checkpoint_file *file, const clod_folder *folder, int error,
                       clod_status *status)
{
    if (is_of_disk(error)) {
        snprintf(file->reason, sizeof file->reason, "it cannot be read: %s", strerror(error));
    } else if (error != 0 && error != ENOENT) {
        return clod_folder_fail(folder, "read", file->name, error, status);
    }
    return true;
}

static void close_file(clod_checkpoint_file *file)
{
    if (file->descriptor >= 0) {
        clod_file_close(file->descriptor); // nothing was written
        file->descriptor = -1;
    }
}

/** Names and heads of both files. */
static bool open_both(clod_checkpoint_file files[2], const clod_folder *folder,
                      const char *stem, clod_status *status)
{
    for (int f = 0; f < 2; f++) {
        files[f] = (clod_checkpoint_file){.descriptor = -1};
    }
    for (int f = 0; f < 2; f++) {
        if (!set_name(&files[f], folder, stem, "ab"[f], status)) {
            return false;
        }
        const int error = open_head(&files[f], folder);
        files[f].there = error != ENOENT;
        if (!take_error(&files[f], folder, error, status)) {
            return false;
        }
    }
    return true;
}

bool clod_checkpoint_file_find(clod_checkpoint_file files[2], const clod_folder *folder,
                               const char *stem, bool both, const clod_bed_source *bed,
                               clod_status *status)
{
    if (!open_both(files, folder, stem, status)) {
        return false;
    }
    const int first = files[1].head.sequence > files[0].head.sequence ? 1 : 0;
    for (int k = 0; k < 2; k++) {
        clod_checkpoint_file *file = &files[k == 0 ? first : 1 - first];
        const bool wanted = k == 0 || both || !files[first].whole;
        const bool good = file->descriptor >= 0 && file->reason[0] == '\0';
        const clod_checkpoint_reader reader = {folder, file->name, bed};
        const int error = good && wanted ? check_whole(file, &reader) : 0;
        if (!file->whole) {
            close_file(file);
        }
        if (!take_error(file, folder, error, status)) {
            return false;
        }
    }
    return true;
}

void clod_checkpoint_file_release(clod_checkpoint_file files[2])
{
    for (int f = 0; f < 2; f++) {
        close_file(&files[f]);
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
