#include "calibrate/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "calibrate/test_kinds.h"
#include "config/suggest.h"

const clod_number *clod_number_find(const clod_plan_test *of, const char *key)
{
    const clod_test_kind *kind = clod_test_kinds_of(of->middle);
    if (kind->paths) {
        return clod_number_path_find(&of->paths, key);
    }
    for (size_t k = 0; k < kind->number_count; k++) {
        if (strcmp(kind->numbers[k].key, key) == 0) {
            return &kind->numbers[k];
        }
    }
    return NULL;
}

bool clod_number_is_amount(const clod_plan *plan, const clod_plan_target *target)
{
    const clod_number *kind = target->test < plan->test_count
                                  ? clod_number_find(&plan->tests[target->test], target->number)
                                  : NULL; // a formula of a test
    if (kind == NULL) {
        return false;
    }
    return clod_number_is_path(kind) ? clod_number_path_is_amount(kind, target->number)
                                     : kind->amount;
}

/** The test that has a number, where the one that is asked for has not; NULL: none has. */
static const char *test_with(const char *key)
{
    for (int k = 0; k < CLOD_CASE_KINDS; k++) {
        const clod_test_kind *kind = clod_test_kinds_row((clod_case_kind)k);
        for (size_t n = 0; !kind->paths && n < kind->number_count; n++) {
            if (strcmp(kind->numbers[n].key, key) == 0) {
                return kind->name;
            }
        }
    }
    return strchr(key, '.') != NULL ? clod_test_kinds_row(CLOD_CASE_FREE)->name : NULL;
}

const char *clod_number_hint(const clod_plan_test *of, const char *key, char *buffer,
                             size_t size)
{
    const clod_test_kind *kind = clod_test_kinds_of(of->middle);
    if (kind->paths) {
        return clod_number_path_hint(&of->paths, key, buffer, size);
    }
    const char *other = test_with(key);
    if (other == NULL) {
        clod_suggest near = clod_suggest_start(key);
        for (size_t k = 0; k < kind->number_count; k++) {
            clod_suggest_offer(&near, kind->numbers[k].key);
        }
        clod_suggest_text(&near, buffer, size);
        if (buffer[0] != '\0') {
            return buffer;
        }
    }
    size_t used = (size_t)snprintf(buffer, size, "%s%s; it has",
                                   other != NULL ? ", which is one of a " : "",
                                   other != NULL ? other : "");
    for (size_t k = 0; k < kind->number_count && used < size; k++) {
        used += (size_t)snprintf(buffer + used, size - used, "%s %s", k == 0 ? "" : ",",
                                 kind->numbers[k].key);
    }
    return buffer;
}

bool clod_number_read(const clod_plan *plan, size_t test, const char *folder, double *values,
                      double *stresses, clod_status *status)
{
    return clod_test_kinds_of(plan->tests[test].middle)
        ->read(plan, test, folder, values, stresses, status);
}

double clod_number_moved(const clod_plan_target *target, double value, double sigma_1)
{
    const clod_curve *curve = target->curve;
    if (curve == NULL || curve->count < 2) { // one point has no slope
        return value;
    }
    if (!isfinite(sigma_1)) {
        return (double)NAN;
    }
    return value + clod_curve_at(curve, target->normal_stress) - clod_curve_at(curve, sigma_1);
}
