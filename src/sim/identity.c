#include "sim/identity.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "output/file.h"

/** A file that a case names: grains or a mesh. */
typedef struct named_file {
    const char *path; ///< borrowed from the case
    char key[160];    ///< of the case
} named_file;

/** The comments stand behind everything else, those of grains first. */
static const char *const COMMENTS[] = {"\n# grains[", "\n# walls."};

/** File k of a case; false: it has no more. */
static bool file_of(const clod_case *from, size_t k, named_file *file)
{
    for (size_t g = 0; g < from->grains_count; g++) {
        if (from->grains[g].file != NULL && k-- == 0) {
            file->path = from->grains[g].file;
            snprintf(file->key, sizeof file->key, "grains[%zu].file", g);
            return true;
        }
    }
    for (size_t w = 0; w < from->wall_count; w++) {
        for (size_t s = 0; s < from->walls[w].shape_count; s++) {
            if (from->walls[w].shapes[s].file != NULL && k-- == 0) {
                file->path = from->walls[w].shapes[s].file;
                snprintf(file->key, sizeof file->key, "walls.%.100s.shapes[%zu].mesh.file",
                         from->walls[w].name, s);
                return true;
            }
        }
    }
    return false;
}

/** The comment of a file, with its newline. */
static bool print_file(FILE *out, const named_file *file, clod_status *status)
{
    void *bytes;
    size_t size;
    if (!clod_file_read(file->path, &bytes, &size, status)) {
        status->code = CLOD_USAGE; // the case names it
        return false;
    }
    fprintf(out, "# %s has %zu bytes with the hash %016" PRIx64 "\n", file->key, size,
            clod_file_hash(CLOD_FILE_HASH_START, bytes, size));
    clod_memory_free(bytes);
    return true;
}

char *clod_identity_complete(const clod_case *from, clod_status *status)
{
    clod_text text;
    char *echo = clod_case_echo(from);
    FILE *out = echo == NULL ? NULL : clod_text_open(&text);
    bool good = out != NULL;
    if (!good) {
        clod_status_fail(status, CLOD_FAILED, "no memory for %s", from->path);
        clod_memory_free(echo);
        return NULL;
    }
    fputs(echo, out);
    clod_memory_free(echo);
    named_file file;
    for (size_t k = 0; good && file_of(from, k, &file); k++) {
        good = print_file(out, &file, status);
    }
    char *whole = clod_text_close(&text);
    if (!good) {
        clod_memory_free(whole);
        return NULL;
    }
    if (whole == NULL) {
        clod_status_fail(status, CLOD_FAILED, "no memory for %s", from->path);
    }
    return whole;
}

static bool begins(const char *line, const char *with)
{
    return strncmp(line, with, strlen(with)) == 0;
}

char *clod_identity_text(const char *complete)
{
    char *text = clod_memory_alloc(strlen(complete) + 1, 1);
    size_t used = 0;
    bool output = false;
    for (const char *line = complete; text != NULL && *line != '\0';) {
        const size_t length = strcspn(line, "\n");
        const size_t whole = length + (line[length] == '\n' ? 1 : 0);
        if (*line != ' ') {
            output = begins(line, "output:");
        }
        if (!output || *line != ' ' || begins(line, "  series_interval:") ||
            begins(line, "  energy:") || begins(line, "  leavers:")) {
            memcpy(text + used, line, whole);
            used += whole;
        }
        line += whole;
    }
    return text; // clod_memory_alloc gave zeros
}

/** Length of the text before the comments of the files. */
static size_t length_of_case(const char *text)
{
    size_t length = strlen(text);
    for (size_t k = 0; k < sizeof COMMENTS / sizeof *COMMENTS; k++) {
        const char *comment = strstr(text, COMMENTS[k]);
        if (comment != NULL && (size_t)(comment - text) + 1 < length) {
            length = (size_t)(comment - text) + 1;
        }
    }
    return length;
}

/** The file of a case whose comment begins at `line`; NULL: none. */
static const char *path_of(const clod_case *from, const char *line)
{
    named_file file;
    for (size_t k = 0; file_of(from, k, &file); k++) {
        const size_t length = strlen(file.key);
        if (strncmp(line, "# ", 2) == 0 && strncmp(line + 2, file.key, length) == 0 &&
            line[2 + length] == ' ') {
            return file.path;
        }
    }
    return NULL;
}

const char *clod_identity_changed_file(const clod_case *from, const char *before,
                                       const char *now)
{
    char *was = clod_identity_text(before);
    char *is = clod_identity_text(now);
    const char *changed = NULL;
    if (was != NULL && is != NULL && length_of_case(was) == length_of_case(is) &&
        memcmp(was, is, length_of_case(is)) == 0) {
        size_t at = length_of_case(is); // the comments are there in both, in the same order
        while (is[at] != '\0' && is[at] == was[at]) {
            at++;
        }
        while (at > 0 && is[at - 1] != '\n') {
            at--;
        }
        changed = path_of(from, is + at);
    }
    clod_memory_free(was);
    clod_memory_free(is);
    return changed;
}
