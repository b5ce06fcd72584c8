#include "sim/ranks_check.h"

static bool has_surfaces(const clod_case *from)
{
    return from->output.surfaces;
}

/** A key that only one rank can do. */
typedef struct alone_row {
    const char *key;
    bool (*present)(const clod_case *from);
} alone_row;

static const alone_row ALONE[] = {
    {"output.surfaces", has_surfaces},
};

bool clod_ranks_check(const clod_case *from, clod_status *status)
{
    const char *key = NULL;
    for (size_t k = 0; key == NULL && k < sizeof ALONE / sizeof *ALONE; k++) {
        key = ALONE[k].present(from) ? ALONE[k].key : NULL;
    }
    return key == NULL ||
           clod_status_fail(status, CLOD_USAGE,
                            "%s: %s does not work on more than one rank yet: run it without "
                            "mpirun, with --threads",
                            from->path, key);
}
