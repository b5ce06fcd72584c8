#include "report/compare_figures.h"

#include "base/memory.h"
#include "report/series_compare.h"
#include "report/shear.h"
#include "report/slice_compare.h"

bool clod_compare_figures_shear(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                                const json_t *lab, clod_status *status)
{
    clod_shear_loci *sets = clod_memory_alloc(count + 1, sizeof *sets);
    size_t used = 0;
    if (sets == NULL) {
        return clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
    }
    for (size_t k = 0; k < count; k++) {
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
    const bool good = clod_series_compare_parts(sheet, runs, count, "preshear", "displacement",
                                                "shear_stress", status) &&
                      clod_series_compare_parts(sheet, runs, count, "preshear", "displacement",
                                                "bulk_density", status);
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
