#include "calibrate/cases.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "base/input.h"
#include "base/memory.h"
#include "base/text.h"
#include "output/file.h"

#define MOST_BYTES ((size_t)1 << 32) ///< of a file that a case names

/** A file that the case names, by its hash; none is fine. */
static bool put_file(FILE *out, const char *path, clod_status *status)
{
    if (path == NULL) {
        return true;
    }
    char *bytes;
    size_t length;
    if (!clod_input_read_regular(path, MOST_BYTES, &bytes, &length, status)) {
        return false;
    }
    fprintf(out, "file %s %016" PRIx64 "\n", path,
            clod_file_hash(CLOD_FILE_HASH_START, bytes, length));
    clod_memory_free(bytes);
    return true;
}

static bool put_files(FILE *out, const clod_case *from, clod_status *status)
{
    bool good = true;
    for (size_t k = 0; k < from->grains_count && good; k++) {
        good = put_file(out, from->grains[k].file, status);
    }
    for (size_t k = 0; k < from->wall_count && good; k++) {
        for (size_t m = 0; m < from->walls[k].shape_count && good; m++) {
            good = put_file(out, from->walls[k].shapes[m].file, status);
        }
    }
    return good;
}

char *clod_cases_describe(const clod_plan *plan, size_t test, clod_status *status)
{
    clod_case *middle = clod_plan_case(plan, &plan->tests[test], NULL, status);
    if (middle == NULL) {
        return NULL;
    }
    clod_text text;
    FILE *out = clod_text_open(&text);
    char *echo = clod_case_echo(middle);
    bool good = true;
    if (out != NULL && echo != NULL) {
        fprintf(out, "\ntest %s\n%s", plan->tests[test].name, echo);
        good = put_files(out, middle, status);
    }
    char *made = out != NULL ? clod_text_close(&text) : NULL;
    if (good && (echo == NULL || made == NULL)) {
        good = clod_status_fail(status, CLOD_FAILED, "No memory for the case.");
    }
    if (!good) {
        clod_memory_free(made);
        made = NULL;
    }
    clod_memory_free(echo);
    clod_case_destroy(&middle);
    return made;
}

bool clod_cases_same(const clod_runs *runs, size_t test, clod_status *status)
{
    char *now = clod_cases_describe(runs->plan, test, status);
    const bool good =
        now != NULL &&
        (strcmp(now, runs->cases[test]) == 0 ||
         clod_status_fail(
             status, CLOD_USAGE,
             "%s, or a file that it names, has changed since the calibration began: its runs "
             "would not belong together. Restore it (%s/design.txt has the complete case), and "
             "the same command goes on; or give another folder with -o.",
             runs->plan->tests[test].path, runs->folder->path));
    clod_memory_free(now);
    return good;
}
