// Tables of gauges: gauge_NAME-profile.csv, gauge_NAME-trajectory.csv.

#include "base/memory.h"
#include "base/text.h"
#include "output/folder_files.h"
#include "output/series.h"
#include "sim/gauges.h"

/** Of a table. */
#define COLUMNS 6

/** Owned text of a table; NULL without memory. */
static char *make_table(const char *at, const clod_gauge_bins *bins,
                        const clod_gauge_axis *axis)
{
    clod_text text;
    FILE *out = clod_text_open(&text);
    if (out == NULL) {
        return NULL;
    }
    fprintf(out, "%s [m],lower [m],mean [m],upper [m],mass [kg],share [1]\n", at);
    for (int k = 0; k < axis->count; k++) {
        const clod_gauge_bin bin = clod_gauge_bins_of(bins, axis, k);
        const double row[COLUMNS] = {bin.at,    bin.lower, bin.mean,
                                     bin.upper, bin.mass,  bin.share};
        for (int c = 0; c < COLUMNS; c++) {
            char number[CLOD_SERIES_NUMBER];
            clod_series_number(number, row[c]);
            fprintf(out, "%s%s", number, c + 1 < COLUMNS ? "," : "\n");
        }
    }
    return clod_text_close(&text);
}

/** Write a table; nothing without bins. */
static bool write_table(const clod_folder *folder, const char *gauge, const char *kind,
                        const char *at, const clod_gauge_bins *bins,
                        const clod_gauge_axis *axis, clod_status *status)
{
    if (axis->count == 0) {
        return true;
    }
    char name[80];
    snprintf(name, sizeof name, "gauge_%s-%s.csv", gauge, kind);
    char *text = make_table(at, bins, axis);
    const bool good = clod_folder_write(folder, name, text, status);
    clod_memory_free(text);
    return good;
}

bool clod_gauges_write(const clod_folder *folder, const void *memory,
                       const clod_free_moment *now, clod_status *status)
{
    const clod_gauges *all = memory;
    const clod_case *from = now->from;
    bool good = true;
    for (size_t k = 0; good && k < from->gauge_count; k++) {
        const clod_case_gauge *mine = &from->gauges[k];
        const clod_gauge gauge = clod_gauges_make(from, mine);
        const clod_gauge_axis across =
            clod_gauge_axis_of(&gauge, gauge.across, mine->profile_bins);
        const clod_gauge_axis along =
            clod_gauge_axis_of(&gauge, gauge.direction, mine->trajectory_bins);
        good = write_table(folder, mine->name, "profile", "across", &all->gauge[k].profile,
                           &across, status) &&
               write_table(folder, mine->name, "trajectory", "along", &all->gauge[k].trajectory,
                           &along, status);
    }
    return good;
}
