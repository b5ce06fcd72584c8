#include "report/wall_compare.h"

#include "base/memory.h"
#include "report/series_compare.h"
#include "report/slice_compare.h"
#include "report/wall_page.h"

/** The loci of all runs that have one, and the laboratory's; owned, or NULL with status. */
static clod_wall_page_locus *list_loci(const clod_run_files *runs, size_t count,
                                       const json_t *lab, size_t *used, clod_status *status)
{
    clod_wall_page_locus *loci = clod_memory_alloc(count + 1, sizeof *loci);
    *used = 0;
    if (loci == NULL) {
        clod_status_fail(status, CLOD_FAILED, "No memory for the comparison.");
        return NULL;
    }
    for (size_t k = 0; k < count; k++) {
        const json_t *locus = json_object_get(runs[k].summary, "wall_locus");
        if (json_is_object(locus)) {
            loci[(*used)++] = (clod_wall_page_locus){.of = runs[k].name, .locus = locus};
        }
    }
    if (lab != NULL) {
        loci[(*used)++] = (clod_wall_page_locus){.of = "laboratory", .locus = lab, .lab = true};
    }
    return loci;
}

bool clod_wall_compare_figures(clod_sheet *sheet, const clod_run_files *runs, size_t count,
                               const json_t *lab, clod_status *status)
{
    size_t used;
    clod_wall_page_locus *loci = list_loci(runs, count, lab, &used, status);
    if (loci == NULL) {
        return false;
    }
    clod_wall_page_figures(sheet, loci, used);
    clod_memory_free(loci);
    clod_sheet_columns(sheet, true);
    const clod_series_curves shear = {
        .part = "wall", .over = "displacement", .column = "shear_stress"};
    const bool good = clod_series_compare_parts(sheet, runs, count, &shear, status);
    clod_sheet_columns(sheet, false);
    return good && clod_slice_compare_put(sheet, runs, count, status);
}
