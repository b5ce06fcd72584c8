#include "calibrate/plan.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/input.h"
#include "base/memory.h"
#include "base/text.h"
#include "calibrate/params.h"
#include "calibrate/plan_check.h"
#include "calibrate/plan_loci.h"
#include "config/file_kind.h"
#include "config/load.h"
#include "config/override.h"
#include "config/yaml.h"

size_t clod_plan_least_points(size_t parameters)
{
    return 2 * (parameters + 1) + 1;
}

size_t clod_plan_design_points(size_t parameters, size_t points)
{
    const size_t least = clod_plan_least_points(parameters);
    const size_t part = points - points / 3;
    return part < least ? least : part;
}

double clod_plan_number(const clod_plan_parameter *self, double place)
{
    if (self->scale == CLOD_PLAN_LOG) {
        return self->low * pow(self->high / self->low, place);
    }
    return self->low + place * (self->high - self->low);
}

/** Whether settings replace a key of the plan. */
static bool is_set(const char *const *overrides, size_t count, const char *key)
{
    const size_t length = strlen(key);
    bool found = false;
    for (size_t i = 0; i < count; i++) {
        found =
            found || (strncmp(overrides[i], key, length) == 0 && overrides[i][length] == '=');
    }
    return found;
}

/** A budget or points by a setting take the place of the other one in the file. */
static void replace_amount(const clod_loader *loader, size_t overrides, clod_plan *self)
{
    const bool points = is_set(loader->report->overrides, overrides, "points");
    const bool budget = is_set(loader->report->overrides, overrides, "budget");
    self->budget = points && !budget ? 0.0 : self->budget;
    self->points = budget && !points ? 0 : self->points;
}

/** Tree -> struct -> checks. */
static void build(clod_loader *loader, size_t overrides, clod_plan *self)
{
    if (!clod_file_kind_check(loader, CLOD_FILE_PLAN)) {
        return;
    }
    clod_load_section(loader, &CLOD_TABLE_PLAN, loader->root, loader->root->place, self);
    replace_amount(loader, overrides, self);
    if (!loader->report->lost && loader->report->count == 0) {
        clod_plan_check(loader, self);
    }
}

/** The text of the file, below the settings that replace some of it as comments; owned, NULL without memory. */
static char *join(const char *text, const char *const *overrides, size_t count)
{
    clod_text made;
    FILE *out = clod_text_open(&made);
    if (out == NULL) {
        return NULL;
    }
    for (size_t i = 0; i < count; i++) {
        fputs("# --set ", out);
        for (const char *at = overrides[i]; *at != '\0'; at++) {
            fputc(*at == '\n' || *at == '\r' ? ' ' : *at, out);
        }
        fputc('\n', out);
    }
    fputs(text, out);
    return clod_text_close(&made);
}

static bool read_text(const clod_report *of, size_t overrides, clod_plan *self,
                      clod_status *status)
{
    clod_report report = *of;
    clod_arena arena = {0};
    char folder[PATH_MAX];
    clod_load_folder(of->name, folder);
    clod_loader loader = {.report = &report, .arena = &arena, .folder = folder};
    loader.root = clod_yaml_read(&arena, of->text, of->length, 0, &report);
    if (loader.root != NULL) {
        for (size_t i = 0; i < overrides; i++) {
            clod_override_apply(&loader, i);
        }
        build(&loader, overrides, self);
    } else if (report.count == 0) {
        const clod_place start = {.line = 1, .column = 1, .width = 1};
        clod_report_add(&report, start, "", "is empty; clod new calibrate writes an example");
    }
    const bool good = clod_report_finish(&report, status);
    clod_report_fini(&report);
    clod_arena_fini(&arena);
    return good;
}

bool clod_plan_load(const char *path, const char *const *overrides, size_t override_count,
                    clod_plan *self, clod_status *status)
{
    *self = (clod_plan){0};
    char *text;
    size_t length;
    if (!clod_input_read(path, CLOD_YAML_BYTES + 1, &text, &length, status)) {
        return false;
    }
    self->path = clod_memory_text(path);
    self->text = join(text, overrides, override_count);
    const clod_report report = {
        .name = path, .text = text, .length = length, .overrides = overrides};
    const bool good = ((self->path != NULL && self->text != NULL) ||
                       clod_status_fail(status, CLOD_FAILED, "No memory for the plan.")) &&
                      read_text(&report, override_count, self, status);
    clod_memory_free(text);
    return good;
}

void clod_plan_fini(clod_plan *self)
{
    for (size_t k = 0; k < self->test_count; k++) {
        clod_case_destroy(&self->tests[k].middle);
        clod_free_paths_fini(&self->tests[k].paths);
    }
    clod_memory_free(self->targets);
    while (self->curves != NULL) {
        clod_plan_curve *first = self->curves;
        self->curves = first->next;
        clod_curve_fini(&first->curve);
        clod_memory_free(first);
    }
    clod_plan_loci_free(self);
    clod_memory_free(self->path);
    clod_memory_free(self->text);
    clod_load_free(&CLOD_TABLE_PLAN, self);
    *self = (clod_plan){0};
}
