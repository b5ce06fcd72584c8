#include "verify/case_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static bool make_folder(const char *path, clod_status *status)
{
    return mkdir(path, 0777) == 0 || errno == EEXIST ||
           clod_status_fail(status, CLOD_FAILED, "%s: cannot be made: %s", path,
                            strerror(errno));
}

static bool write_text(const char *path, const char *text, clod_status *status)
{
    FILE *out = fopen(path, "w");
    bool written = out != NULL && fputs(text, out) >= 0;
    if (out != NULL) {
        written = fclose(out) == 0 && written;
    }
    return written || clod_status_fail(status, CLOD_FAILED, "%s: cannot be written: %s", path,
                                       strerror(errno));
}

bool clod_verify_case_file(const char *directory, const char *name, const char *text,
                           char path[4096], clod_status *status)
{
    char folder[3072];
    snprintf(folder, sizeof folder, "%s/cases", directory);
    if (!make_folder(folder, status)) {
        return false;
    }
    snprintf(folder, sizeof folder, "%s/cases/%s", directory, name);
    snprintf(path, 4096, "%s/case.yaml", folder);
    return make_folder(folder, status) && write_text(path, text, status);
}
