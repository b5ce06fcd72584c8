#include "hopper/case.h"

#include <limits.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/input.h"
#include "base/memory.h"
#include "config/file_kind.h"
#include "config/load.h"
#include "config/override.h"
#include "config/unit.h"
#include "config/yaml.h"
#include "hopper/params.h"

/** Complain about a section. */
static void complain(clod_loader *loader, const char *key, const char *text)
{
    const clod_node *node = clod_tree_nearest(loader->root, key);
    clod_report_add(loader->report, clod_load_place(node), key, "%s", text);
}

/** A test that is named twice counts twice, and makes errors smaller than they are. */
static void check_tests(clod_loader *loader, const clod_hopper_strength *self)
{
    for (size_t i = 0; i < self->test_count; i++) {
        for (size_t k = 0; k < i; k++) {
            if (strcmp(self->tests[i].points, self->tests[k].points) == 0) {
                char text[256];
                snprintf(text, sizeof text, "has %.200s twice; leave one out",
                         self->tests[i].points);
                complain(loader, "flow_function.shear_tests", text);
                return;
            }
        }
    }
}

static void check_strength(clod_loader *loader, const clod_hopper_strength *self)
{
    if (!clod_report_clean(loader->report, "flow_function")) {
        return;
    }
    if (self->file == NULL && self->test_count == 0) {
        complain(loader, "flow_function",
                 "needs file, a table with sigma_1 and f_c, or shear_tests");
    } else if (self->file != NULL && self->test_count > 0) {
        complain(loader, "flow_function",
                 "has file and shear_tests; keep the one that the design shall use");
    }
    check_tests(loader, self);
}

/** A property has a file or a value; an error goes with a value. */
static void check_property(clod_loader *loader, const clod_hopper_property *self,
                           const char *key, const char *value)
{
    if (!self->present || !clod_report_clean(loader->report, key)) {
        return;
    }
    char text[128];
    if (self->file == NULL && !self->has_value) {
        snprintf(text, sizeof text, "needs file or %s", value);
        complain(loader, key, text);
    } else if (self->file != NULL && self->has_value) {
        snprintf(text, sizeof text, "has file and %s; keep one of them", value);
        complain(loader, key, text);
    } else if (self->file != NULL && self->error > 0.0) {
        complain(loader, key,
                 "has an error beside a file; the errors of a table are a column of it");
    }
}

/** A limit from a chart has to leave room for the margin; an error goes with a limit. */
static void check_limit(clod_loader *loader, const clod_hopper_case *self)
{
    const clod_hopper_shape *wedge = &self->wedge;
    const bool clean = clod_report_clean(loader->report, "wedge") &&
                       clod_report_clean(loader->report, "margin");
    char text[128];
    if (clean && wedge->limit == 0.0 && wedge->limit_error > 0.0) {
        complain(loader, "wedge.limit_error",
                 "is the error of wedge.limit, which is not given");
    } else if (clean && wedge->limit > 0.0 && wedge->half_angle == 0.0 &&
               wedge->limit <= self->margin) {
        snprintf(text, sizeof text, "leaves no half angle below it: margin is %.4g deg",
                 self->margin / CLOD_UNIT_DEGREE);
        complain(loader, "wedge.limit", text);
    }
}

static void check(clod_loader *loader, const clod_hopper_case *self)
{
    check_strength(loader, &self->strength);
    check_property(loader, &self->phi_e, "effective_friction", "angle");
    check_property(loader, &self->phi_t, "static_friction", "angle");
    check_property(loader, &self->wall, "wall_friction", "angle");
    check_property(loader, &self->rho, "bulk_density", "value");
    check_limit(loader, self);
}

static bool read_tree(clod_loader *loader, const char *text, size_t length, size_t overrides)
{
    loader->root = clod_yaml_read(loader->arena, text, length, 0, loader->report);
    if (loader->root == NULL) {
        if (loader->report->count == 0) {
            const clod_place start = {.line = 1, .column = 1, .width = 1};
            clod_report_add(loader->report, start, "",
                            "is empty; clod new hopper writes an example");
        }
        return false;
    }
    for (size_t i = 0; i < overrides; i++) {
        clod_override_apply(loader, i);
    }
    return true;
}

/** Tree -> struct -> checks. */
static void build(clod_loader *loader, clod_hopper_case *self)
{
    if (!clod_file_kind_check(loader, CLOD_FILE_HOPPER)) {
        return;
    }
    clod_load_section(loader, &CLOD_TABLE_HOPPER, loader->root, loader->root->place, self);
    if (!loader->report->lost) {
        check(loader, self);
    }
}

bool clod_hopper_case_load(const char *path, const char *const *overrides,
                           size_t override_count, clod_hopper_case *self, clod_status *status)
{
    *self = (clod_hopper_case){0};
    char *text;
    size_t length;
    if (!clod_input_read(path, CLOD_YAML_BYTES + 1, &text, &length, status)) {
        return false;
    }
    clod_report report = {.name = path, .text = text, .length = length, .overrides = overrides};
    clod_arena arena = {0};
    char folder[PATH_MAX];
    clod_load_folder(path, folder);
    clod_loader loader = {.report = &report, .arena = &arena, .folder = folder};
    if (read_tree(&loader, text, length, override_count)) {
        build(&loader, self);
    }
    const bool good = clod_report_finish(&report, status);
    clod_report_fini(&report);
    clod_arena_fini(&arena);
    clod_memory_free(text);
    return good;
}

void clod_hopper_case_fini(clod_hopper_case *self)
{
    clod_load_free(&CLOD_TABLE_HOPPER, self);
}
