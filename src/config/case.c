#include "clod/case.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/assert.h"
#include "base/given.h"
#include "base/input.h"
#include "base/memory.h"
#include "config/check.h"
#include "config/contacts.h"
#include "config/file_kind.h"
#include "config/include.h"
#include "config/load.h"
#include "config/override.h"
#include "config/param.h"
#include "config/report.h"
#include "config/source.h"
#include "config/yaml.h"

/** Absolute folder of the case file, so that an echo that moves elsewhere still finds files. */
static char *folder_of(const char *path, clod_arena *arena)
{
    char here[PATH_MAX] = "";
    if (path[0] != '/' && getcwd(here, sizeof here) == NULL) {
        here[0] = '\0';
    }
    const char *slash = strrchr(path, '/');
    const size_t length = slash == NULL ? 0 : (size_t)(slash - path);
    const size_t size = strlen(here) + length + 2;
    char *folder = clod_arena_alloc(arena, size);
    if (folder != NULL) {
        snprintf(folder, size, "%s%s%.*s", here, here[0] != '\0' && length > 0 ? "/" : "",
                 (int)length, path);
    }
    return folder;
}

/** Tree -> structs -> checks; errors go to the report. */
static void build(clod_loader *loader, clod_case *self)
{
    if (!clod_file_kind_check(loader, CLOD_FILE_CASE)) {
        return;
    }
    clod_load_section(loader, &CLOD_TABLE_CASE, loader->root, loader->root->place, self);
    if (!loader->report->lost) {
        clod_contacts_load(loader, self);
        clod_check_case(loader, self);
    }
}

/** Apply those that name a file to include, or the others. */
static void apply_overrides(clod_loader *loader, size_t overrides, bool include)
{
    static const char KEY[] = "include=";
    for (size_t i = 0; i < overrides && loader->root != NULL && !loader->report->lost; i++) {
        if ((strncmp(loader->report->overrides[i], KEY, strlen(KEY)) == 0) == include) {
            clod_override_apply(loader, i);
        }
    }
}

static void read_tree(clod_loader *loader, const char *text, size_t length, size_t overrides)
{
    clod_report *report = loader->report;
    loader->root = clod_yaml_read(loader->arena, text, length, 0, report);
    if (loader->root == NULL && report->count == 0 && !report->lost) {
        const clod_place start = {.line = 1, .column = 1, .width = 1};
        clod_report_add(report, start, "", "is empty; clod new writes an example");
    }
    apply_overrides(loader, overrides, true);
    clod_include_merge(loader);
    apply_overrides(loader, overrides, false);
}

static clod_case *make_case(const char *path, const char *text, size_t length)
{
    clod_case *self = clod_memory_alloc(1, sizeof *self);
    if (self == NULL) {
        return NULL;
    }
    self->path = clod_memory_text(path);
    self->text = clod_memory_alloc(length + 1, 1);
    if (self->path == NULL || self->text == NULL) {
        clod_case_destroy(&self);
        return NULL;
    }
    memcpy(self->text, text, length);
    return self;
}

/** Whether as many overrides are there as were said. */
static bool overrides_given(const char *const *overrides, size_t count, const char *function,
                            clod_status *status)
{
    bool given = count == 0 || clod_given(overrides != NULL, function, "overrides", status);
    for (size_t k = 0; given && k < count; k++) {
        given = clod_given(overrides[k] != NULL, function, "one of overrides", status);
    }
    return given;
}

clod_case *clod_case_parse(const char *path, const char *text, size_t length,
                           const char *const *overrides, size_t override_count,
                           clod_status *status)
{
    if (!CLOD_GIVEN(path, status) || !CLOD_GIVEN(text, status) ||
        !overrides_given(overrides, override_count, __func__, status)) {
        return NULL;
    }
    clod_report report = {.name = path, .text = text, .length = length, .overrides = overrides};
    clod_arena arena = {0};
    clod_loader loader = {
        .report = &report, .arena = &arena, .folder = folder_of(path, &arena)};
    clod_case *self = make_case(path, text, length);
    if (self == NULL || loader.folder == NULL) {
        report.lost = true;
    } else {
        read_tree(&loader, text, length, override_count);
        if (loader.root != NULL) {
            build(&loader, self);
        }
    }
    if (self != NULL && report.count == 0 && !report.lost) {
        clod_source_keep(self, &loader, override_count);
    }
    if (!clod_report_finish(&report, status)) {
        clod_case_destroy(&self);
    }
    clod_report_fini(&report);
    clod_arena_fini(&arena);
    return self;
}

clod_case *clod_case_load(const char *path, const char *const *overrides, size_t override_count,
                          clod_status *status)
{
    if (!CLOD_GIVEN(path, status) ||
        !overrides_given(overrides, override_count, __func__, status)) {
        return NULL;
    }
    size_t length = 0;
    char *text;
    if (!clod_input_read(path, CLOD_YAML_BYTES + 1, &text, &length, status)) {
        return NULL;
    }
    clod_case *self = clod_case_parse(path, text, length, overrides, override_count, status);
    clod_memory_free(text);
    return self;
}

void clod_case_destroy(clod_case **self)
{
    if (self == NULL || *self == NULL) {
        return;
    }
    clod_load_free(&CLOD_TABLE_CASE, *self);
    clod_source_destroy(&(*self)->source);
    clod_memory_free((*self)->path);
    clod_memory_free((*self)->text);
    clod_memory_free(*self);
    *self = NULL;
}

int clod_case_material_index(const clod_case *self, const char *name)
{
    CLOD_NEED(self);
    CLOD_NEED(name);
    for (size_t i = 0; i < self->material_count; i++) {
        if (strcmp(self->materials[i].name, name) == 0) {
            return (int)i;
        }
    }
    return -1;
}

const clod_case_contact *clod_case_pair(const clod_case *self, int a, int b)
{
    CLOD_NEED(self);
    CLOD_ASSERT(a >= 0 && b >= 0 && (size_t)a < self->material_count &&
                (size_t)b < self->material_count);
    return &self->pairs[(size_t)a * self->material_count + (size_t)b];
}
