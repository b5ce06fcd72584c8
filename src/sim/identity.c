#include "sim/identity.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "output/file.h"

#define GRAINS "# grains[" ///< the comments stand behind everything else

/** The comment of group g, with its newline. */
static bool print_grains(FILE *out, const clod_case *from, size_t g, clod_status *status)
{
    void *bytes;
    size_t size;
    if (!clod_file_read(from->grains[g].file, &bytes, &size, status)) {
        status->code = CLOD_USAGE; // the case names it
        return false;
    }
    fprintf(out, GRAINS "%zu].file has %zu bytes with the hash %016" PRIx64 "\n", g, size,
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
    for (size_t g = 0; good && g < from->grains_count; g++) {
        good = from->grains[g].file == NULL || print_grains(out, from, g, status);
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
            begins(line, "  energy:")) {
            memcpy(text + used, line, whole);
            used += whole;
        }
        line += whole;
    }
    return text; // clod_memory_alloc gave zeros
}

/** Length of the text before the comments of the grain files. */
static size_t length_of_case(const char *text)
{
    const char *grains = strstr(text, "\n" GRAINS);
    return grains == NULL ? strlen(text) : (size_t)(grains - text) + 1;
}

const char *clod_identity_changed_grains(const clod_case *from, const char *before,
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
        char *end;
        const size_t group = begins(is + at, GRAINS)
                                 ? strtoul(is + at + strlen(GRAINS), &end, 10)
                                 : from->grains_count;
        changed = group < from->grains_count ? from->grains[group].file : NULL;
    }
    clod_memory_free(was);
    clod_memory_free(is);
    return changed;
}
