#pragma once
/**
 * @file plan_lab.h
 * Plans of one test of the name lab, with measured tables in files, for tests.
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "calibrate/plan.h"
#include "output/temp_folder.h"

#define RING "cases/calibrate-kadh/ring.yaml"

static inline void lab_write_file(void **state, const char *name, const char *text)
{
    char path[PATH_MAX];
    FILE *out = fopen(temp_path(path, state, name), "w");
    assert_non_null(out);
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
}

/** Load a plan with one test, one parameter and one target; the table is lab.csv. */
static inline bool lab_load_range(void **state, const char *from, const char *key,
                                  const char *low, const char *high, const char *target,
                                  clod_plan *plan, clod_status *status)
{
    char text[2048];
    char path[PATH_MAX];
    snprintf(text, sizeof text,
             "points: 5\ntests: {lab: {case: %s/%s}}\n"
             "parameters: {p: {key: %s, from: %s, to: %s}}\ntargets: [{test: lab, %s}]\n",
             CLOD_SOURCE_DIR, from, key, low, high, target);
    lab_write_file(state, "plan.yaml", text);
    return clod_plan_load(temp_path(path, state, "plan.yaml"), NULL, 0, plan, status);
}

/** The same of a parameter from 0.1 to 0.2. */
static inline bool lab_load(void **state, const char *from, const char *key, const char *target,
                            clod_plan *plan, clod_status *status)
{
    return lab_load_range(state, from, key, "0.1", "0.2", target, plan, status);
}

static inline void lab_check_target(const clod_plan_target *target, const char *name,
                                    double stress, double value, double error)
{
    assert_string_equal(target->name, name);
    assert_true(fabs(target->normal_stress / stress - 1.0) < 1e-12);
    assert_true(fabs(target->value / value - 1.0) < 1e-9);
    assert_true(fabs(target->error / error - 1.0) < 1e-9);
}

static inline void lab_refuse_of(void **state, const char *from, const char *key,
                                 const char *target, const char *words)
{
    clod_plan plan;
    clod_status status = {CLOD_OK, ""};
    assert_false(lab_load(state, from, key, target, &plan, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    if (strstr(status.text, words) == NULL) {
        fail_msg("%s: not in: %s", words, status.text);
    }
    clod_plan_fini(&plan);
}

// ---- plans of one parameter, rolling friction

#define UNIAXIAL "cases/copper-ore-uniaxial/case.yaml" // consolidated at 20 and 54.8 kPa
#define ROLLING "contacts.default.rolling_friction"

static inline void lab_load_good(void **state, const char *from, const char *target,
                                 clod_plan *plan)
{
    clod_status status = {CLOD_OK, ""};
    if (!lab_load(state, from, ROLLING, target, plan, &status)) {
        fail_msg("%s", status.text);
    }
}

static inline void lab_refuse(void **state, const char *from, const char *target,
                              const char *words)
{
    lab_refuse_of(state, from, ROLLING, target, words);
}
