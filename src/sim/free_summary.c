#include "sim/free_summary.h"

/** As free_run.c writes them. */
static const char OWN[] =
    "time_s dt_s steps grains contacts coordination max_overlap stable_step_s "
    "kinetic_energy_J wall_clock_s stages.*.end_s";

bool clod_free_summary_path(const clod_case *from, size_t k, clod_free_path *path)
{
    return clod_free_paths_pick(OWN, NULL, &k, path) || clod_free_measures_path(from, k, path);
}
