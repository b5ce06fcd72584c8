#include "report/run_kinds.h"

#include <string.h>

#include "analysis/measured_header.h"
#include "config/testers.h"
#include "report/cards.h"
#include "report/compare_figures.h"
#include "report/compare_free.h"
#include "report/compare_tables.h"
#include "report/run_pages.h"
#include "report/shear.h"
#include "report/wall_compare.h"
#include "report/wall_page.h"

static const clod_run_kind ROWS[CLOD_CASE_KINDS] = {
    [CLOD_CASE_FREE] = {.text = "Free run",
                        .cards = clod_cards_free,
                        .put = clod_run_pages_free,
                        .results = clod_compare_free_results,
                        .figures = clod_compare_figures_free},
    [CLOD_CASE_RING_SHEAR] = {.text = "Ring shear test",
                              .checked = true,
                              .cards = clod_cards_shear,
                              .put = clod_shear_put,
                              .lab = clod_shear_lab,
                              .stress = CLOD_MEASURED_OF_SHEAR,
                              .results = clod_compare_tables_shear,
                              .figures = clod_compare_figures_shear},
    [CLOD_CASE_JENIKE] = {.text = "Jenike shear test",
                          .checked = true,
                          .cards = clod_cards_shear,
                          .put = clod_shear_put,
                          .lab = clod_shear_lab,
                          .stress = CLOD_MEASURED_OF_SHEAR,
                          .results = clod_compare_tables_shear,
                          .figures = clod_compare_figures_shear},
    [CLOD_CASE_UNIAXIAL] = {.text = "Uniaxial test",
                            .checked = true,
                            .cards = clod_cards_uniaxial,
                            .put = clod_run_pages_uniaxial,
                            .results = clod_compare_tables_uniaxial,
                            .figures = clod_compare_figures_uniaxial},
    [CLOD_CASE_WALL_FRICTION] = {.text = "Wall friction test",
                                 .checked = true,
                                 .cards = clod_cards_wall,
                                 .put = clod_wall_page_put,
                                 .lab = clod_wall_page_lab,
                                 .stress = CLOD_MEASURED_OF_WALL,
                                 .results = clod_compare_tables_wall,
                                 .figures = clod_wall_compare_figures},
};

/** Whether a complete case has a section. */
static bool has_section(const char *complete, const char *key)
{
    const size_t length = strlen(key);
    for (const char *at = strstr(complete, key); at != NULL; at = strstr(at + 1, key)) {
        if (at > complete && at[-1] == '\n' && at[length] == ':') {
            return true;
        }
    }
    return false;
}

const clod_run_kind *clod_run_kinds_of(const char *complete)
{
    for (size_t k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_config_tester *tester = &CLOD_CONFIG_TESTER[k];
        if (tester->cell && has_section(complete, tester->key)) {
            return &ROWS[k];
        }
    }
    return &ROWS[CLOD_CASE_FREE];
}

/** Whether a laboratory's table is not plainly of another kind than the run; its reader tells the rest. */
static bool is_of_kind(const char *path, const clod_run_files *run, clod_status *status)
{
    const clod_measured_stress found = clod_measured_stress_in(path);
    return found == CLOD_MEASURED_OF_NONE || found == run->kind->stress ||
           clod_status_fail(status, CLOD_USAGE,
                            "--lab %s: is a table of %s; the page of %s (%s) takes %s.", path,
                            CLOD_MEASURED_STRESS_NAMES[found], run->folder, run->kind->text,
                            CLOD_MEASURED_STRESS_NAMES[run->kind->stress]);
}

json_t *clod_run_kinds_lab(const char *path, const clod_run_files *run, clod_status *status)
{
    if (run->kind->lab == NULL) {
        clod_status_fail(
            status, CLOD_USAGE,
            "--lab %s: %s is no shear or wall friction test: only their pages have yield loci to "
            "lay laboratory points over.",
            path, run->folder);
        return NULL;
    }
    return is_of_kind(path, run, status) ? run->kind->lab(path, status) : NULL;
}
