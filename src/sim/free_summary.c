#include "sim/free_summary.h"

/** As free_run.c writes them. */
static const char *const OWN[CLOD_FREE_SUMMARY_OWN] = {
    "time_s",           "dt_s",         "steps",       "grains",
    "contacts",         "coordination", "max_overlap", "stable_step_s",
    "kinetic_energy_J", "wall_clock_s", "stages"};

size_t clod_free_summary_names(const clod_case *from, const char *names[CLOD_FREE_SUMMARY_MOST])
{
    for (size_t k = 0; k < CLOD_FREE_SUMMARY_OWN; k++) {
        names[k] = OWN[k];
    }
    return CLOD_FREE_SUMMARY_OWN +
           clod_free_measures_sections(from, names + CLOD_FREE_SUMMARY_OWN);
}
