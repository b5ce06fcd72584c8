#include "report/report.h"

#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "output/folder.h"
#include "report/calibration_page.h"
#include "report/cards.h"
#include "report/grain_view.h"
#include "report/head.h"
#include "report/hopper_page.h"
#include "report/run_damage.h"
#include "report/run_kinds.h"
#include "report/scripts.h"
#include "report/sheet.h"
#include "report/warnings_section.h"

static bool fail_memory(clod_status *status)
{
    return clod_status_fail(status, CLOD_FAILED, "No memory for the report.");
}

static bool put_run(clod_sheet *sheet, clod_run_files *run, const json_t *lab,
                    clod_status *status)
{
    clod_grain_view view;
    if (!clod_grain_view_make(&view, run, status)) {
        return false;
    }
    clod_head_put(sheet->body, run);
    bool good =
        clod_warnings_section_put(clod_writer_page(sheet->body), run, 1, false, lab, status);
    clod_cards_put(sheet->body, run);
    good = good && run->kind->put(sheet, run, lab, status);
    clod_grain_view_put(sheet, &view);
    clod_grain_view_fini(&view);
    clod_head_sources(sheet->body, run);
    return good;
}

/** Owned name of the page. */
static char *name_page(const clod_report_options *options)
{
    const char *folder = options->runs[0];
    const size_t size = strlen(folder) + sizeof "/report.html";
    char *path = options->output != NULL ? clod_memory_text(options->output)
                                         : clod_memory_alloc(size, 1);
    if (path != NULL && options->output == NULL) {
        snprintf(path, size, "%s/report.html", folder);
    }
    return path;
}

/** The page of a calibration, which is no run of a case. */
static bool write_calibration(const clod_report_options *options, const char *path,
                              clod_status *status)
{
    clod_sheet sheet = {0};
    char *title = NULL;
    const bool good =
        (options->lab == NULL ||
         clod_status_fail(
             status, CLOD_USAGE,
             "%s is a calibration: its plan names what was measured; leave out --lab",
             options->runs[0])) &&
        clod_sheet_open(&sheet, status) &&
        clod_calibration_page_put(&sheet, options->runs[0], &title, status) &&
        clod_sheet_write(&sheet, title, path, status);
    clod_sheet_fini(&sheet);
    clod_memory_free(title);
    return good;
}

/** The page of a run. */
static bool write_run(const clod_report_options *options, const char *path, clod_status *status)
{
    clod_run_files run;
    clod_sheet sheet = {0};
    json_t *lab = NULL;
    bool good = clod_run_files_open(&run, options->runs[0], status);
    if (good && options->lab != NULL) {
        lab = clod_run_kinds_lab(options->lab, &run, status);
        good = lab != NULL;
    }
    good = good && clod_sheet_open(&sheet, status) && put_run(&sheet, &run, lab, status) &&
           clod_sheet_write(&sheet, run.title, path, status);
    if (good) {
        clod_run_damage_tell(&run, options);
    }
    clod_sheet_fini(&sheet);
    json_decref(lab);
    clod_run_files_fini(&run);
    return good;
}

bool clod_report_write(const clod_report_options *options, char **path, clod_status *status)
{
    *path = name_page(options);
    if (*path == NULL) {
        return fail_memory(status);
    }
    const bool good = clod_calibration_page_is(options->runs[0])
                          ? write_calibration(options, *path, status)
                          : write_run(options, *path, status);
    if (!good) {
        clod_memory_free(*path);
        *path = NULL;
    }
    return good;
}

bool clod_report_hopper(const clod_hopper *design, const char *path, size_t *figures,
                        clod_status *status)
{
    clod_sheet sheet = {0};
    bool good = clod_sheet_open(&sheet, status);
    if (good) {
        clod_hopper_page_put(&sheet, design);
        good = clod_sheet_write(&sheet, clod_hopper_page_title(design), path, status);
    }
    *figures = sheet.file_count;
    clod_sheet_fini(&sheet);
    return good;
}

const char *clod_report_lacks(void)
{
    return clod_scripts_bundle() != NULL
               ? NULL
               : "This clod was built without the scripts of its pages: figures do not zoom, and "
                 "there is no 3-D view. To get them, install Node.js with npm (Debian: apt "
                 "install nodejs npm, or make setup-report in the sources), connect to a "
                 "network, and build clod again";
}

char *clod_report_folder(const char *case_path, clod_status *status)
{
    return clod_folder_default(case_path, status);
}

void clod_report_free(char *text)
{
    clod_memory_free(text);
}
