/**
 * @file plan_conflicts_shear.c
 * Targets of one shear test that no solid has together, and shear stresses that fall.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "base/text.h"
#include "calibrate/nearest_solid.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

#define FIRM CLOD_PLAN_FIRM_ERRORS
#define NAME 48 ///< bytes of a number's name
#define NAMED                                                                                  \
    0.5 ///< of the largest difference, in errors: what is nearer to the nearest solid is not named

// ---- points of the line

/** Whether it is a shear stress of the line that was given as a number. */
static bool is_point(const clod_plan *self, size_t test, const clod_plan_target *target)
{
    return target->test == test && strcmp(target->number, "tau") == 0 &&
           self->wishes[target->entry].locus == NULL;
}

/** Shear stresses of one line rise with the normal stress; of a table the line itself is looked at (clod locus). */
static void check_points(clod_loader *loader, const clod_plan *self, size_t test)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *low = &self->targets[k];
        for (size_t m = 0; m < self->target_count && is_point(self, test, low); m++) {
            const clod_plan_target *high = &self->targets[m];
            if (is_point(self, test, high) && high->normal_stress > low->normal_stress &&
                low->value - high->value > FIRM * hypot(clod_plan_conflicts_error(low),
                                                        clod_plan_conflicts_error(high))) {
                clod_check_fail(
                    loader, "targets",
                    "test %s: tau falls from %.4g kPa at %.4g kPa in targets.%zu to %.4g kPa at %.4g kPa in "
                    "targets.%zu, and a yield locus rises with the normal stress; are the stresses interchanged, "
                    "or of different consolidations?",
                    self->tests[test].name, 1e-3 * low->value, 1e-3 * low->normal_stress,
                    low->entry, 1e-3 * high->value, 1e-3 * high->normal_stress, high->entry);
            }
        }
    }
}

// ---- numbers of a test

/** Numbers of one test, and their targets. */
typedef struct numbers {
    const char *test;
    double preshear;
    const clod_plan_target **of; ///< [count] owned, with room for all targets
    clod_nearest_number *items;  ///< [count] likewise
    size_t count;
    bool lost; ///< no memory
} numbers;

static void init(numbers *self, const clod_plan *plan, size_t test)
{
    *self = (numbers){plan->tests[test].name,
                      clod_case_shear(plan->tests[test].middle)->preshear_stress,
                      clod_memory_alloc(plan->target_count, sizeof(const clod_plan_target *)),
                      clod_memory_alloc(plan->target_count, sizeof(clod_nearest_number)),
                      0,
                      false};
    self->lost = self->of == NULL || self->items == NULL;
}

static void fini(numbers *self)
{
    clod_memory_free(self->of);
    clod_memory_free(self->items);
}

/** Whether a number is there already: what is there twice is looked at elsewhere, since specimens differ. */
static bool has(const numbers *self, const clod_plan_target *target)
{
    bool found = false;
    for (size_t k = 0; k < self->count; k++) {
        found = found || strcmp(self->of[k]->name, target->name) == 0;
    }
    return found;
}

static void append(numbers *self, const clod_plan_target *target)
{
    self->of[self->count] = target;
    self->items[self->count++] =
        (clod_nearest_number){target->number, target->normal_stress, target->value,
                              clod_plan_conflicts_error(target), 0.0};
}

/** Those of the yield locus that a test has; none that goes along a table over sigma_1, and none of the points of a table,
 *  which may bend and whose line is compared elsewhere (plan_loci.c). */
static void collect(numbers *self, const clod_plan *plan, size_t test, bool held_back)
{
    self->count = 0;
    for (size_t k = 0; k < plan->target_count; k++) {
        const clod_plan_target *one = &plan->targets[k];
        const bool tau = strcmp(one->number, "tau") == 0;
        if (one->test == test && one->curve == NULL && clod_nearest_has(one->number) &&
            (!tau || is_point(plan, test, one)) && (held_back || !one->held_back) &&
            !has(self, one)) {
            append(self, one);
        }
    }
}

/** Those of another list but for one of them (count: none), or its points of the line alone. */
static void take(numbers *self, const numbers *from, size_t without, bool points)
{
    self->count = 0;
    for (size_t k = 0; k < from->count; k++) {
        if (k != without && (!points || strcmp(from->of[k]->number, "tau") == 0)) {
            append(self, from->of[k]);
        }
    }
}

// ---- what no solid has

/** How far numbers are from the nearest solid: beyond what their points alone are, which bend on curved loci. */
typedef struct distance {
    double chi_square, freedom;
    bool far;
} distance;

/** @param room  has room for the points; `lost` without memory, and then nothing is far */
static distance measure(numbers *self, numbers *room)
{
    take(room, self, self->count, true);
    const clod_nearest all = clod_nearest_fit(self->preshear, self->items, self->count);
    const clod_nearest points = clod_nearest_fit(room->preshear, room->items, room->count);
    distance made = {all.chi_square - points.chi_square,
                     fmax(all.freedom - points.freedom, 1.0), false};
    made.far = made.chi_square > clod_nearest_limit(made.freedom);
    room->lost = room->lost || isnan(made.chi_square);
    return made;
}

/** How far a number is from the nearest solid, in errors. */
static double errors_of(const numbers *self, size_t k)
{
    const clod_nearest_number *one = &self->items[k];
    return fabs(one->value - one->nearest) / one->error;
}

/** Put the number that is farthest from the nearest solid first, and so on. */
static void sort(numbers *self)
{
    for (size_t n = 0; n < self->count; n++) {
        size_t next = n;
        for (size_t k = n + 1; k < self->count; k++) {
            next = errors_of(self, k) > errors_of(self, next) ? k : next;
        }
        const clod_plan_target *of = self->of[n];
        const clod_nearest_number item = self->items[n];
        self->of[n] = self->of[next];
        self->items[n] = self->items[next];
        self->of[next] = of;
        self->items[next] = item;
    }
}

/** "tau at 27.4 kPa" */
static const char *name_of(const numbers *self, size_t k, char text[NAME])
{
    const clod_plan_target *one = self->of[k];
    const int length = snprintf(text, NAME, "%.16s", one->number);
    if (one->normal_stress > 0.0) {
        snprintf(text + length, NAME - (size_t)length, " at %.4g kPa",
                 1e-3 * one->normal_stress);
    }
    return text;
}

/** "ffc 3 in targets.0 (nearest 3.8, 8.0 errors away)" */
static void describe(const numbers *self, size_t k, char *text, size_t size)
{
    const clod_plan_target *one = self->of[k];
    const clod_plan_measure *unit = &one->measure;
    char name[NAME];
    snprintf(text, size, "%s %.4g%s%s in targets.%zu (nearest %.4g, %.1f errors away)",
             name_of(self, k, name), unit->factor * one->value,
             unit->unit[0] != '\0' ? " " : "", unit->unit, one->entry,
             unit->factor * self->items[k].nearest, errors_of(self, k));
}

/** Those that are farthest, two at least. */
static void list_farthest(const numbers *self, char *text, size_t size)
{
    clod_text_names names = clod_text_names_begin(text, size);
    for (size_t k = 0; k < self->count; k++) {
        char one[160];
        if (k < 2 || errors_of(self, k) > NAMED * errors_of(self, 0)) {
            describe(self, k, one, sizeof one);
            clod_text_names_add(&names, one);
        }
    }
    clod_text_names_end(&names);
}

/** What may be wrong: the numbers without any one of which the others go together, if these are not all of them. */
static void list_wrong(const numbers *self, numbers *without, numbers *room, char *text,
                       size_t size)
{
    char list[200], name[NAME];
    clod_text_names names = clod_text_names_begin(list, sizeof list);
    size_t found = 0;
    for (size_t k = 0; k < self->count; k++) {
        take(without, self, k, false);
        if (!measure(without, room).far) {
            clod_text_names_add(&names, name_of(self, k, name));
            found++;
        }
    }
    clod_text_names_end(&names);
    snprintf(text, size, "%s%s",
             found == 0             ? "Correct or leave out some of them"
             : found == self->count ? "Correct or leave out one of them"
                                    : "The others go together without one of these, so correct "
                                      "or leave out one of them: ",
             found == self->count ? "" : list);
}

/** What to do about phi_e beside steady flow in tension, or about c and phi_lin, which belong to one line, where both are there: a
 *  curved locus has many lines. */
static const char *advise(const numbers *self)
{
    size_t line = 0;
    bool angled = false, tension = false;
    for (size_t k = 0; k < self->count; k++) {
        const char *number = self->of[k]->number;
        const double value = self->of[k]->value;
        line += strcmp(number, "c") == 0 || strcmp(number, "phi_lin") == 0 ? 1 : 0;
        angled = angled || strcmp(number, "phi_e") == 0;
        tension = tension || (strcmp(number, "ffc") == 0 && value < 1.0) ||
                  (strcmp(number, "sigma_2") == 0 && value < 0.0);
    }
    if (angled && tension) {
        return " Steady flow in tension (ffc below 1, sigma_2 below 0) has no phi_e: leave one of them out.";
    }
    return line > 1
               ? " c and phi_lin of a curved locus? Then leave one out, hold it back, or state a discrepancy."
               : "";
}

static void refuse(clod_loader *loader, numbers *self, const distance *of, numbers *without,
                   numbers *room)
{
    char list[400], wrong[320];
    sort(self);
    list_farthest(self, list, sizeof list);
    list_wrong(self, without, room, wrong, sizeof wrong);
    clod_check_fail(
        loader, "targets",
        "test %s: no solid has all of this at the preshear stress of the case, %.4g kPa: %s. Chi-square of the nearest "
        "possible solid is %.3g, and at most %.3g is taken for chance. %s. Has one another unit, is one of another "
        "consolidation, or are two interchanged?%s",
        self->test, 1e-3 * self->preshear, list, of->chi_square,
        clod_nearest_limit(of->freedom), wrong, advise(self));
}

static void warn(clod_plan *self, numbers *of)
{
    char list[260];
    sort(of);
    list_farthest(of, list, sizeof list);
    clod_warning_list_add(
        &self->warnings,
        "test %s: no solid has all of this at the preshear stress of the case, %.4g kPa: %s. So what is held back will "
        "likely be missed.%s",
        of->test, 1e-3 * of->preshear, list, advise(of));
}

/** A number that no solid has, whatever the others are; also one that is held back. */
static bool check_alone(clod_loader *loader, const numbers *self, numbers *one, numbers *room)
{
    for (size_t k = 0; k < self->count; k++) {
        one->count = 0;
        append(one, self->of[k]);
        if (measure(one, room).far) {
            char text[160];
            const char *number = self->of[k]->number;
            describe(one, 0, text, sizeof text);
            clod_check_fail(
                loader, "targets",
                "test %s: no solid has %s at the preshear stress of the case, %.4g kPa; check its unit, or give the test "
                "the preshear stress of that %s%s",
                self->test, text, 1e-3 * self->preshear, number,
                strcmp(number, "ffc") == 0 ? ". Is it sigma_c/sigma_1?" : "");
            return false;
        }
    }
    return true;
}

/** `all`, `some`, `room` are empty and have room for all targets. */
static void check(clod_loader *loader, clod_plan *self, size_t test, numbers *all,
                  numbers *some, numbers *room)
{
    collect(all, self, test, true);
    if (!check_alone(loader, all, some, room)) {
        return;
    }
    const distance of_all = measure(all, room);
    collect(all, self, test, false);
    const distance of_used = measure(all, room);
    if (of_used.far) {
        refuse(loader, all, &of_used, some, room);
    } else if (of_all.far) {
        collect(all, self, test, true);
        measure(all, room);
        warn(self, all);
    }
}

void clod_plan_conflicts_shear(clod_loader *loader, clod_plan *self, size_t test)
{
    const size_t before = loader->report->count;
    check_points(loader, self, test);
    numbers all, some, room;
    init(&all, self, test);
    init(&some, self, test);
    init(&room, self, test);
    const bool made = !all.lost && !some.lost && !room.lost;
    if (made && loader->report->count == before) {
        check(loader, self, test, &all, &some, &room);
    }
    loader->report->lost = loader->report->lost || !made || room.lost;
    fini(&all);
    fini(&some);
    fini(&room);
}
