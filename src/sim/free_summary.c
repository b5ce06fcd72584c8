#include "sim/free_summary.h"

#include "setup/walls.h"

/** As free_run.c writes them. */
static void own_paths(const clod_case *from, clod_free_paths *paths)
{
    clod_free_paths_add(paths, NULL,
                        "time_s dt_s steps grains contacts coordination max_overlap "
                        "stable_step_s kinetic_energy_J wall_clock_s");
    if (from->stage_count > 0) {
        clod_free_paths_add(paths, NULL, "stages.[0-%zu].end_s", from->stage_count - 1);
    }
}

bool clod_free_summary_paths(const clod_case *from, clod_free_paths *paths, clod_status *status)
{
    clod_state walls_only = {0};
    *paths = (clod_free_paths){0};
    bool good = clod_setup_walls(from, &walls_only.walls, status);
    if (good) {
        own_paths(from, paths);
        clod_free_measures_paths(from, &walls_only, paths);
        good = !paths->lost ||
               clod_status_fail(status, CLOD_FAILED, "no memory for the names of summary.json");
    }
    clod_walls_fini(&walls_only.walls);
    return good;
}
