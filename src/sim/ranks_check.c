#include "sim/ranks_check.h"

bool clod_ranks_check(const clod_case *from, clod_status *status)
{
    return !from->output.surfaces ||
           clod_status_fail(
               status, CLOD_USAGE,
               "%s: output.surfaces does not work on more than one rank yet: leave "
               "it out, or run without mpirun, with --threads",
               from->path);
}
