/**
 * @file plan_conflicts_wall.c
 * Targets of one wall friction test that cannot be true together: the line of its wall yield locus goes through the points
 * at the wall_stresses of the case, whose shear stresses rise with the normal stress. What targets leave open of the points
 * leaves a range of lines.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "analysis/angles.h"
#include "base/memory.h"
#include "base/text.h"
#include "calibrate/number.h"
#include "calibrate/plan_check.h"
#include "calibrate/test_kinds.h"

#define FIRM CLOD_PLAN_FIRM_ERRORS

/** A number and its standard error; SI. */
typedef struct known {
    double value, error;
} known;

static bool is(const clod_plan_target *self, size_t test, const char *number)
{
    return self->test == test && strcmp(self->number, number) == 0;
}

/** Times a stress: of a phi_x the shear stress of its point, of a phi_w the slope of the line (stress 1). */
static known times_tangent(const clod_plan_target *angle, double stress)
{
    const double t = tan(angle->value);
    return (known){stress * t, stress * (1.0 + t * t) * clod_plan_conflicts_error(angle)};
}

/** Two phi_x whose shear stresses fall; of two points of a table the table itself is looked at (clod locus). */
static void check_fall(clod_loader *loader, const clod_plan *self, const clod_plan_target *low,
                       const clod_plan_target *high)
{
    const known less = times_tangent(low, low->normal_stress);
    const known more = times_tangent(high, high->normal_stress);
    if (self->wishes[low->entry].locus != NULL && self->wishes[high->entry].locus != NULL) {
        return;
    }
    if (less.value - more.value > FIRM * hypot(less.error, more.error)) {
        clod_check_fail(
            loader, "targets",
            "test %s: the shear stress falls from %.4g kPa (phi_x %.1f deg at %.4g kPa in targets.%zu) to %.4g kPa "
            "(phi_x %.1f deg at %.4g kPa in targets.%zu), and that of a wall rises with the normal stress; are angles or "
            "stresses interchanged?",
            self->tests[low->test].name, 1e-3 * less.value, low->value / CLOD_NUMBER_DEGREE,
            1e-3 * low->normal_stress, low->entry, 1e-3 * more.value,
            high->value / CLOD_NUMBER_DEGREE, 1e-3 * high->normal_stress, high->entry);
    }
}

static void check_falls(clod_loader *loader, const clod_plan *self, size_t test)
{
    for (size_t k = 0; k < self->target_count; k++) {
        for (size_t m = 0; m < self->target_count && is(&self->targets[k], test, "phi_x");
             m++) {
            if (is(&self->targets[m], test, "phi_x") &&
                self->targets[k].normal_stress < self->targets[m].normal_stress) {
                check_fall(loader, self, &self->targets[k], &self->targets[m]);
            }
        }
    }
}

// ---- the line

/** What is known of the shear stress at one of the stresses: between those of the targets next to it. */
typedef struct point {
    known ends[2];                   ///< least and most
    const clod_plan_target *from[2]; ///< of the ends; NULL: none, and 0 or the largest angle
} point;

static point look(const clod_plan *self, size_t test, double stress)
{
    const double most = stress * tan(CLOD_ANGLES_MOST * CLOD_NUMBER_DEGREE);
    point found = {{{0.0, 0.0}, {most, 0.0}}, {NULL, NULL}};
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *one = &self->targets[k];
        if (!is(one, test, "phi_x")) {
            continue;
        }
        const known here = times_tangent(one, one->normal_stress);
        const double away = one->normal_stress / stress - 1.0;
        if (away < CLOD_NUMBER_SAME_STRESS &&
            (found.from[0] == NULL || here.value > found.ends[0].value)) {
            found.ends[0] = here;
            found.from[0] = one;
        }
        if (away > -CLOD_NUMBER_SAME_STRESS &&
            (found.from[1] == NULL || here.value < found.ends[1].value)) {
            found.ends[1] = here;
            found.from[1] = one;
        }
    }
    if (found.ends[0].value > found.ends[1].value) { // within errors: a fall is refused
        return (point){{found.ends[1], found.ends[0]}, {found.from[1], found.from[0]}};
    }
    return found;
}

/** The least (end 0) or the most (end 1) that a sum of so many times the shear stresses can be. */
static known reach(const clod_plan *self, const point *points, const double *times,
                   size_t count, size_t end)
{
    known sum = {0.0, 0.0};
    double square = 0.0;
    for (size_t t = 0; t < self->target_count; t++) {
        double of_target = 0.0; // one target may be an end of several points
        for (size_t i = 0; i < count; i++) {
            const size_t side = times[i] > 0.0 ? end : 1 - end;
            of_target += points[i].from[side] == &self->targets[t]
                             ? times[i] * points[i].ends[side].error
                             : 0.0;
        }
        square += of_target * of_target;
    }
    for (size_t i = 0; i < count; i++) {
        sum.value += times[i] * points[i].ends[times[i] > 0.0 ? end : 1 - end].value;
    }
    sum.error = sqrt(square);
    return sum;
}

/** "targets.1, targets.2", each entry with a phi_x once. */
static void list_entries(const clod_plan *self, size_t test, char *text, size_t size)
{
    clod_text_names names = clod_text_names_begin(text, size);
    size_t next = 0;
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *one = &self->targets[k];
        if (is(one, test, "phi_x") && one->entry >= next) {
            char entry[32];
            snprintf(entry, sizeof entry, "targets.%zu", one->entry);
            clod_text_names_add(&names, entry);
            next = one->entry + 1;
        }
    }
    clod_text_names_end(&names);
}

/** A number of the line, as it is given and as the points let it be. */
typedef struct claim {
    const clod_plan_target *of;
    known given, least, most;
} claim;

static void compare(clod_loader *loader, const clod_plan *self, const claim *it)
{
    const bool angle = strcmp(it->of->number, "phi_w") == 0;
    const double above = it->given.value - it->most.value;
    const double below = it->least.value - it->given.value;
    if (above <= FIRM * hypot(it->given.error, it->most.error) &&
        below <= FIRM * hypot(it->given.error, it->least.error)) {
        return;
    }
    char path[48], entries[160];
    const clod_plan_measure *unit = &it->of->measure;
    snprintf(path, sizeof path, "targets.%zu.value", it->of->entry);
    list_entries(self, it->of->test, entries, sizeof entries);
    clod_check_fail(
        loader, path,
        "%s %.4g %s contradicts phi_x in %s: with these, and shear stresses that rise with the normal stress, the line "
        "through the points at the wall_stresses of test %s has a %s of %.4g to %.4g %s. Correct or leave out one of "
        "them",
        it->of->number, unit->factor * it->of->value, unit->unit, entries,
        self->tests[it->of->test].name, it->of->number,
        unit->factor * (angle ? atan(it->least.value) : it->least.value),
        unit->factor * (angle ? atan(it->most.value) : it->most.value), unit->unit);
}

/** phi_w and tau_ad are slope and end of the line through the points. `points`, `times` [count] room */
static void check_line(clod_loader *loader, const clod_plan *self, size_t test, point *points,
                       double *times)
{
    const clod_case *from = self->tests[test].middle;
    const double *stresses = from->wall_friction.wall_stresses;
    const size_t count = from->wall_friction.wall_stress_count;
    double mean = 0.0, spread = 0.0;
    for (size_t i = 0; i < count; i++) {
        mean += stresses[i] / (double)count;
        points[i] = look(self, test, stresses[i]);
    }
    for (size_t i = 0; i < count; i++) {
        spread += (stresses[i] - mean) * (stresses[i] - mean);
    }
    for (size_t k = 0; k < self->target_count && spread > 0.0; k++) {
        const clod_plan_target *one = &self->targets[k];
        const bool slope = is(one, test, "phi_w");
        if (!slope && !is(one, test, "tau_ad")) {
            continue;
        }
        for (size_t i = 0; i < count; i++) {
            const double of_slope = (stresses[i] - mean) / spread;
            times[i] = slope ? of_slope : 1.0 / (double)count - mean * of_slope;
        }
        claim it = {one,
                    slope ? times_tangent(one, 1.0)
                          : (known){one->value, clod_plan_conflicts_error(one)},
                    reach(self, points, times, count, 0), reach(self, points, times, count, 1)};
        // a line below the origin has no adhesion: what is told of it is 0
        it.most.value = slope ? it.most.value : fmax(it.most.value, 0.0);
        it.least.value = fmax(it.least.value, 0.0);
        compare(loader, self, &it);
    }
}

void clod_plan_conflicts_wall(clod_loader *loader, const clod_plan *self)
{
    for (size_t t = 0; t < self->test_count; t++) {
        const clod_case *from = self->tests[t].middle;
        bool angles = false;
        for (size_t k = 0; k < self->target_count; k++) {
            angles = angles || is(&self->targets[k], t, "phi_x");
        }
        if (clod_test_kinds_of(from)->numbers != CLOD_NUMBERS_WALL || !angles) {
            continue;
        }
        const size_t count = from->wall_friction.wall_stress_count;
        point *points = clod_memory_alloc(count, sizeof *points);
        double *times = clod_memory_alloc(count, sizeof *times);
        check_falls(loader, self, t);
        if (points != NULL && times != NULL) {
            check_line(loader, self, t, points, times);
        }
        loader->report->lost = loader->report->lost || points == NULL || times == NULL;
        clod_memory_free(points);
        clod_memory_free(times);
    }
}
