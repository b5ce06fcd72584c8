#include "report/compare_figures.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "report/series_compare.h"
#include "report/shear.h"
#include "report/shear_points.h"
#include "report/shear_rows.h"
#include "report/slice_compare.h"

#define MOST_SHEARS 16 ///< points of a test
#define SAME 1.01      ///< of a normal stress over another that is meant to be the same

/** Shear stress and height of a part of each run over its displacement; of preshear bulk density too, which shear to failure
 *  changes as it does the height. */
static bool put_part(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                     const char *part, const char *behind, clod_status *status)
{
    static const char *const COLUMNS[] = {"shear_stress", "height", "bulk_density"};
    const size_t columns = sizeof COLUMNS / sizeof *COLUMNS - (behind != NULL ? 1 : 0);
    bool good = true;
    for (size_t k = 0; good && k < columns; k++) {
        const clod_series_curves curves = {.part = part,
                                           .behind = behind,
                                           .whole = true,
                                           .over = "displacement",
                                           .column = COLUMNS[k],
                                           .mark = k == 0 ? clod_shear_points_mark : NULL,
                                           .marks = CLOD_SHEAR_POINTS_MARKS};
        good = clod_series_compare_parts(sheet, runs, count, &curves, status);
    }
    return good;
}

/** A shear point with its normal stress, "point-1, at 3 kPa", or those of all runs, "at 3 to 6 kPa"; false: no run has it. */
static bool name_point(const clod_run_files *runs, size_t count, const char *part,
                       char behind[96])
{
    double least = INFINITY, most = 0.0;
    for (size_t r = 0; r < count; r++) {
        size_t k;
        const json_t *one;
        json_array_foreach(json_object_get(runs[r].summary, "parts"), k, one)
        {
            const char *name = json_string_value(json_object_get(one, "part"));
            const size_t length = name != NULL ? strlen(name) : 0, wanted = strlen(part);
            const double stress = clod_shear_number(one, "normal_stress_Pa");
            if (length >= wanted && strcmp(name + length - wanted, part) == 0) {
                least = fmin(least, stress);
                most = fmax(most, stress);
            }
        }
    }
    if (most > 0.0 && most <= SAME * least) {
        snprintf(behind, 96, "%s, at %.4g kPa", part, 1e-3 * most);
    } else {
        snprintf(behind, 96, "%s, at %.4g to %.4g kPa", part, 1e-3 * least, 1e-3 * most);
    }
    return most > 0.0;
}

bool clod_compare_figures_shear(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                const json_t *lab, clod_status *status)
{
    clod_shear_loci *sets = clod_memory_alloc(count + 1, sizeof *sets);
    size_t used = 0;
    if (sets == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    }
    for (size_t k = 0; k < count; k++) {
        clod_shear_points_recall(&runs[k]);
        const json_t *study = json_object_get(runs[k].summary, "locus");
        if (study != NULL) {
            sets[used++] = (clod_shear_loci){.of = runs[k].name, .study = study};
        }
    }
    if (lab != NULL) {
        sets[used++] = (clod_shear_loci){.of = "laboratory", .study = lab, .lab = true};
    }
    if (used > 0) {
        clod_shear_figures(sheet, sets, used);
    }
    clod_memory_free(sets);
    clod_sheet_columns(sheet, true);
    bool good = put_part(sheet, runs, count, "preshear", NULL, status);
    for (int k = 1; good && k <= MOST_SHEARS; k++) {
        char part[32], behind[96];
        snprintf(part, sizeof part, "point-%d", k);
        if (name_point(runs, count, part, behind)) {
            good = put_part(sheet, runs, count, part, behind, status);
        }
    }
    clod_sheet_columns(sheet, false);
    return good && clod_slice_compare_put(sheet, runs, count, status);
}

bool clod_compare_figures_uniaxial(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                   const json_t *lab, clod_status *status)
{
    (void)lab;
    clod_sheet_columns(sheet, true);
    const bool good = clod_series_compare_strengths(sheet, runs, count, status);
    clod_sheet_columns(sheet, false);
    return good && clod_slice_compare_put(sheet, runs, count, status);
}

bool clod_compare_figures_free(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status)
{
    (void)lab;
    clod_sheet_columns(sheet, true);
    const bool good = clod_series_compare_free(sheet, runs, count, status);
    clod_sheet_columns(sheet, false);
    return good && clod_slice_compare_put(sheet, runs, count, status);
}
