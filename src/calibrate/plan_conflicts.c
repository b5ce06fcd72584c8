/**
 * @file plan_conflicts.c
 * Targets that cannot be true together.
 */

#include <math.h>
#include <string.h>

#include "calibrate/plan_check.h"

#define FIRM 2.0 // standard errors that make a contradiction

/** Target of a test with this number, or NULL. */
static const clod_plan_target *with(const clod_plan *self, size_t test, const char *number)
{
    for (size_t k = 0; k < self->target_count; k++) {
        if (self->targets[k].test == test && strcmp(self->targets[k].number, number) == 0) {
            return &self->targets[k];
        }
    }
    return NULL;
}

/** The line through the origin that touches the steady circle is at least as steep as the yield locus,
 *  which touches it too, if the cohesion is not below 0. */
static void check_angles(clod_loader *loader, const clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        const clod_plan_target *line = with(self, t, "phi_lin");
        const clod_plan_target *effective = with(self, t, "phi_e");
        if (line != NULL && effective != NULL &&
            line->value - effective->value > FIRM * hypot(line->error, effective->error)) {
            clod_check_fail(
                loader, "targets",
                "test %s: phi_e %.1f deg in targets.%zu is below phi_lin %.1f deg in targets.%zu, which no "
                "yield locus with a cohesion of 0 or more can have; are they interchanged?",
                self->tests[t].name, effective->measure.factor * effective->value,
                effective->entry, line->measure.factor * line->value, line->entry);
        }
    }
}

/** The same number twice: once is enough, or the values are two specimens'. */
static void check_twice(clod_loader *loader, const clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        for (size_t m = 0; m < k; m++) {
            const clod_plan_target *a = &self->targets[m];
            const clod_plan_target *b = &self->targets[k];
            const double apart = fabs(a->value - b->value) / hypot(a->error, b->error);
            if (strcmp(a->name, b->name) == 0 && apart > 2.0 * FIRM) {
                clod_check_fail(
                    loader, "targets",
                    "%s is there as %.6g %s in targets.%zu and as %.6g %s in targets.%zu, %.1f standard errors "
                    "apart: they contradict each other; leave one of them out, or give the errors that "
                    "specimens differ by",
                    a->name, a->measure.factor * a->value, a->measure.unit, a->entry,
                    b->measure.factor * b->value, b->measure.unit, b->entry, apart);
            }
        }
    }
}

void clod_plan_check_conflicts(clod_loader *loader, const clod_plan *self)
{
    check_angles(loader, self);
    check_twice(loader, self);
}
