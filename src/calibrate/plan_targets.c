/**
 * @file plan_targets.c
 * Targets of a plan: units, what a test can tell.
 */

#include "calibrate/plan_targets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "calibrate/test_kinds.h"
#include "config/suggest.h"
#include "config/unit.h"

typedef clod_plan_maker maker;

const char *clod_plan_targets_at(clod_plan_maker *self, const char *key)
{
    snprintf(self->path, sizeof self->path, "targets.%zu%s%s", self->number,
             key[0] == '\0' ? "" : ".", key);
    return self->path;
}

/** A quantity in the unit of the number; false after a complaint. */
static bool quantity(maker *self, const char *key, const char *text, const clod_number *kind,
                     double *value)
{
    char message[CLOD_UNIT_MESSAGE];
    const char *unit = clod_unit_number(text, value);
    if (unit == NULL) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, key), "%s is no number", text);
        return false;
    }
    if (unit[0] == '\0' && clod_number_is_path(kind)) {
        *value /= kind->measure.factor; // in the unit of the name
        return true;
    }
    if (!clod_unit_convert(unit, kind->unit, value, message)) {
        const bool told = message[0] == '-' || (message[0] >= '0' && message[0] <= '9');
        clod_check_fail(self->loader, clod_plan_targets_at(self, key), "%s%s%s",
                        told ? "" : text, told ? "" : ": ", message);
        return false;
    }
    return true;
}

bool clod_plan_targets_deviation(clod_plan_maker *self, const char *key, const char *text,
                                 const clod_number *kind, bool needed, double *value)
{
    *value = 0.0;
    if (text == NULL) {
        if (needed) {
            clod_check_fail(self->loader, clod_plan_targets_at(self, ""),
                            "needs the key error, the standard error of what was measured");
        }
        return !needed;
    }
    if (!quantity(self, key, text, kind, value)) {
        return false;
    }
    if (*value < 0.0 || (needed && *value == 0.0)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, key), "%s is not above 0",
                        text);
        return false;
    }
    if (*value > kind->most - kind->least) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, key),
                        "%s is more than all that is possible, %.6g to %.6g %s: such a target "
                        "tells nothing. Give at most a few times the scatter between specimens",
                        text, kind->measure.factor * kind->least,
                        kind->measure.factor * kind->most, kind->measure.unit);
        return false;
    }
    return true;
}

static bool find_test(maker *self, size_t *test)
{
    clod_suggest near = clod_suggest_start(self->wish->test);
    for (size_t k = 0; k < self->plan->test_count; k++) {
        if (strcmp(self->plan->tests[k].name, self->wish->test) == 0) {
            *test = k;
            return true;
        }
        clod_suggest_offer(&near, self->plan->tests[k].name);
    }
    char hint[128];
    clod_check_fail(self->loader, clod_plan_targets_at(self, "test"), "there is no test %s%s",
                    self->wish->test, clod_suggest_text(&near, hint, sizeof hint));
    return false;
}

bool clod_plan_targets_check_stress(clod_plan_maker *self, size_t test, const clod_number *kind,
                                    const char *number, double stress)
{
    const clod_case *from = self->plan->tests[test].middle;
    const clod_test_kind *of = clod_test_kinds_of(from);
    if (!kind->at_stress) {
        if (stress > 0.0) {
            clod_check_fail(self->loader, clod_plan_targets_at(self, "normal_stress"),
                            "%s has none", number);
        }
        return stress <= 0.0;
    }
    if (stress <= 0.0) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, ""),
                        "%s needs the key normal_stress", number);
        return false;
    }
    const bool there = of->has_stress(from, stress);
    if (!there) {
        clod_check_fail(
            self->loader,
            clod_plan_targets_at(self, self->wish->locus != NULL ? "locus" : "normal_stress"),
            "%.6g kPa is %s of test %s; give it there", 1e-3 * stress, of->without_stress,
            self->wish->test);
    }
    return there;
}

static void name_target(clod_plan_target *to, const char *test, const char *number)
{
    snprintf(to->number, sizeof to->number, "%s", number);
    if (to->normal_stress > 0.0) {
        snprintf(to->name, sizeof to->name, "%.40s: %.40s at %.4g kPa", test, number,
                 1e-3 * to->normal_stress);
    } else {
        snprintf(to->name, sizeof to->name, "%.40s: %.60s", test, number);
    }
}

static void write_place(clod_plan_target *to)
{
    const size_t length = strlen(to->name);
    snprintf(to->name + length, sizeof to->name - length, " (targets.%zu)", to->entry);
}

void clod_plan_targets_add(clod_plan_maker *self, const clod_plan_target *made,
                           const char *number)
{
    clod_plan *plan = self->plan;
    clod_plan_target *grown = clod_memory_grow(plan->targets, plan->target_count,
                                               plan->target_count + 1, sizeof *grown);
    if (grown == NULL) {
        self->loader->report->lost = true;
        return;
    }
    plan->targets = grown;
    grown[plan->target_count] = *made;
    grown[plan->target_count].entry = self->number;
    name_target(&grown[plan->target_count++], self->wish->test, number);
}

/** Targets of the same number at the same stress, of two specimens or from two tables, get their places
 *  in the plan behind their names: columns of runs.csv and figures are found by name. */
static void name_apart(clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const char *name = self->targets[k].name;
        bool shared = false;
        for (size_t m = k + 1; m < self->target_count; m++) {
            if (strcmp(self->targets[m].name, name) == 0) {
                write_place(&self->targets[m]);
                shared = true;
            }
        }
        if (shared) {
            write_place(&self->targets[k]);
        }
    }
}

/** Whether two targets are of one table, of one column of it or of two, both used or both held back. */
static bool one_table(const clod_plan *self, const clod_plan_target *a,
                      const clod_plan_target *b)
{
    const char *of = self->wishes[a->entry].locus;
    const char *other = self->wishes[b->entry].locus;
    return of != NULL && other != NULL && a->test == b->test && a->held_back == b->held_back &&
           strcmp(of, other) == 0;
}

/** Number the tables that targets come from. */
static void number_tables(clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        clod_plan_target *target = &self->targets[k];
        target->table = self->wishes[target->entry].locus != NULL ? k + 1 : 0;
        for (size_t m = 0; m < k; m++) {
            if (one_table(self, &self->targets[m], target)) {
                target->table = self->targets[m].table;
                break;
            }
        }
    }
}

const clod_number *clod_plan_targets_number(clod_plan_maker *self, size_t test)
{
    const clod_plan_wish *wish = self->wish;
    const clod_plan_test *of = &self->plan->tests[test];
    const clod_number *kind = clod_number_find(of, wish->number);
    if (kind == NULL) {
        char hint[500];
        clod_check_fail(self->loader, clod_plan_targets_at(self, "number"),
                        "test %s has no number %s%s", wish->test, wish->number,
                        clod_number_hint(of, wish->number, hint, sizeof hint));
    }
    return kind;
}

/** A target of a number and a value. */
static void make_number(maker *self, size_t test)
{
    const clod_plan_wish *wish = self->wish;
    if (wish->number == NULL || wish->value == NULL) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, ""), "needs %s, or locus",
                        wish->number == NULL ? "number and value" : "value");
        return;
    }
    const clod_number *kind = clod_plan_targets_number(self, test);
    if (kind == NULL) {
        return;
    }
    clod_plan_target made = {.test = test,
                             .normal_stress = wish->normal_stress,
                             .held_back = wish->held_back,
                             .measure = kind->measure};
    if (!clod_plan_targets_check_stress(self, test, kind, wish->number, wish->normal_stress) ||
        !quantity(self, "value", wish->value, kind, &made.value) ||
        !clod_plan_targets_deviation(self, "error", wish->error, kind, true, &made.error) ||
        !clod_plan_targets_deviation(self, "discrepancy", wish->discrepancy, kind, false,
                                     &made.discrepancy)) {
        return;
    }
    if (made.value < kind->least || made.value > kind->most) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "value"),
                        "%s is impossible; allowed is %.6g to %.6g %s: check its unit%s",
                        wish->value, kind->measure.factor * kind->least,
                        kind->measure.factor * kind->most, kind->measure.unit,
                        clod_number_is_path(kind)
                            ? ", which is that of the name where none is written"
                            : "");
        return;
    }
    if (made.value < 0.0 && clod_number_is_path(kind) &&
        clod_number_path_is_amount(kind, wish->number)) {
        clod_check_fail(self->loader, clod_plan_targets_at(self, "value"),
                        "%s is impossible: %s is never below 0", wish->value, wish->number);
        return;
    }
    clod_plan_targets_add(self, &made, wish->number);
}

void clod_plan_make_targets(clod_loader *loader, clod_plan *self)
{
    size_t used = 0;
    for (size_t k = 0; k < self->wish_count; k++) {
        maker make = {.loader = loader, .plan = self, .wish = &self->wishes[k], .number = k};
        size_t test;
        if (!find_test(&make, &test)) {
            continue;
        }
        if (make.wish->locus != NULL) {
            clod_plan_tables_make(&make, test);
        } else {
            make_number(&make, test);
        }
    }
    for (size_t k = 0; k < self->target_count; k++) {
        used += self->targets[k].held_back ? 0 : 1;
    }
    if (loader->report->count == 0 && used == 0) {
        clod_check_fail(loader, "targets", "are all held back; at least one must be used");
    }
    clod_plan_check_conflicts(loader, self);
    name_apart(self);
    number_tables(self);
    if (loader->report->count == 0) {
        clod_plan_warn_doubts(self);
    }
}
