#pragma once
/**
 * @file bench_path.h
 * The contact bench along a path given as text, with all rows kept.
 */

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support/case_of.h"
#include "tester/contact_bench.h"

#define ROWS 4096

typedef struct path {
    clod_contact_bench_row row[ROWS];
    size_t count;
    clod_contact_bench_summary summary;
} path;

static inline bool keep(void *context, const clod_contact_bench_row *row, clod_status *status)
{
    path *self = context;
    (void)status;
    assert_true(self->count < ROWS);
    self->row[self->count++] = *row;
    return true;
}

/** A bench's case with one change of a key, or NULL. */
static inline clod_case *parse_changed(const char *contact, const char *bench,
                                       const char *change)
{
    char text[4096];
    const int length = snprintf(text, sizeof text,
                                "materials:\n"
                                "  ore: {density: 2481.3 kg/m3, youngs_modulus: 119 GPa,"
                                " poissons_ratio: 0.34}\n"
                                "  light: {}\n"
                                "contacts:\n"
                                "  default: {%s}\n"
                                "contact_bench:\n"
                                "  material_1: ore\n"
                                "%s",
                                contact, bench);
    assert_in_range(length, 1, sizeof text - 1);
    return case_of(text, change);
}

static inline clod_case *parse(const char *contact, const char *bench)
{
    return parse_changed(contact, bench, NULL);
}

/** Run the bench of a case, which is destroyed. */
static inline void drive_case(clod_case *from, path *result)
{
    clod_status status = {CLOD_OK, ""};
    result->count = 0;
    if (!clod_contact_bench_run(from, keep, result, &result->summary, &status)) {
        fail_msg("%s", status.text);
    }
    clod_case_destroy(&from);
}

/** Run a bench; static, so that the rows need no heap. */
static inline const path *drive(const char *contact, const char *bench)
{
    static path result;
    drive_case(parse(contact, bench), &result);
    return &result;
}

static inline void near(double value, double expected, double relative)
{
    if (!(fabs(value - expected) <= relative * fabs(expected))) {
        fail_msg("%.15g is not %.15g", value, expected);
    }
}

#define TWO "  material_2: ore\n  radius_1: 3 mm\n  radius_2: 6 mm\n  legs:\n"
