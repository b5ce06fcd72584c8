/**
 * @file plan_doubts.c
 * Targets that are possible and hardly meant: warnings.
 */

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "calibrate/plan_check.h"
#include "calibrate/plan_loci.h"
#include "calibrate/test_kinds.h"
#include "config/testers.h"

#define STORED                                                                                 \
    0.1 ///< of tau_p: peaks that are so much higher are no scatter, as clod locus has it

// ---- an error above its value

static void warn_of_errors(clod_plan *self)
{
    size_t next = 0; // entry that has had no warning yet: targets come in the order of theirs
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *one = &self->targets[k];
        if (one->entry < next || one->value == 0.0 || one->error <= fabs(one->value)) {
            continue;
        }
        next = one->entry + 1;
        const clod_plan_measure *unit = &one->measure;
        clod_warning_list_add(
            &self->warnings,
            "targets.%zu: the error of %s, %.4g %s, is larger than its value, %.4g %s, so it tells hardly anything. "
            "Is the unit forgotten, or another one? Where the value is 0 within its error, all is well.",
            one->entry, one->name, unit->factor * one->error, unit->unit,
            unit->factor * one->value, unit->unit);
    }
}

// ---- tests of one solid at several consolidations

/** A number of a test at its consolidation; SI. */
typedef struct statement {
    size_t test, entry;
    double stress, value;
    double error; ///< 0: not known
} statement;

/** Normal stress that consolidates the solid of a test; 0: it is none of shear or uniaxial. */
static double stress_of(const clod_plan *self, size_t test, double normal_stress)
{
    const clod_case *from = self->tests[test].middle;
    const clod_number *numbers = clod_test_kinds_of(from)->numbers;
    if (numbers == CLOD_NUMBERS_SHEAR) {
        return clod_case_shear(from)->preshear_stress;
    }
    return numbers == CLOD_NUMBERS_UNIAXIAL ? normal_stress : 0.0;
}

/** Whether a number is an angle of a line from the origin. */
static bool is_angle(clod_field_index number)
{
    return number == CLOD_FIELD_PHI_E || number == CLOD_FIELD_PHI_SF;
}

/** What the plan says of a number: the k-th of its targets, behind them of its yield loci; false: nothing. */
static bool say(const clod_plan *self, size_t k, clod_field_index number, statement *to)
{
    if (k < self->target_count) {
        const clod_plan_target *one = &self->targets[k];
        *to = (statement){one->test, one->entry, stress_of(self, one->test, one->normal_stress),
                          one->value, one->error};
        return to->stress > 0.0 && strcmp(one->number, CLOD_FIELDS[number].key) == 0;
    }
    const clod_plan_locus *locus = self->loci;
    for (size_t n = self->target_count; n < k; n++) {
        locus = locus->next;
    }
    const clod_locus_value *value = &locus->values[number];
    *to = (statement){locus->test, locus->entry, stress_of(self, locus->test, 0.0),
                      value->value, value->error > 0.0 ? value->error : 0.0};
    return isfinite(value->value);
}

/** What a plan says of a shear stress: of an angle that of its line at the preshear stress, of phi_sf tau_p. */
static bool say_stress(const clod_plan *self, size_t k, clod_field_index number, statement *to)
{
    if (!say(self, k, number, to)) {
        return false;
    }
    if (is_angle(number)) {
        const double t = tan(to->value);
        to->value = to->stress * t;
        to->error *= to->stress * (1.0 + t * t);
    }
    return true;
}

/** Whether two tests are of one tester and of a material of one name. */
static bool one_solid(const clod_plan *self, size_t a, size_t b)
{
    const clod_case *one = self->tests[a].middle, *other = self->tests[b].middle;
    const clod_config_tester *tester = clod_config_tester_of(one);
    return tester == clod_config_tester_of(other) &&
           strcmp(tester->materials(one).grain, tester->materials(other).grain) == 0;
}

/** By how many standard errors a number falls from one consolidation to a larger one; 0: not that it were known. */
static double fall(const clod_plan *self, const statement *from, const statement *to)
{
    if (from->stress * (1.0 + CLOD_NUMBER_SAME_STRESS) >= to->stress ||
        !one_solid(self, from->test, to->test)) {
        return 0.0;
    }
    // an error that is not known is taken to be that of the other
    const double error = hypot(from->error > 0.0 ? from->error : to->error,
                               to->error > 0.0 ? to->error : from->error);
    return error > 0.0 ? (from->value - to->value) / error : 0.0;
}

static void warn_of_fall(clod_plan *self, clod_field_index number, const statement *from,
                         const statement *to, double errors)
{
    const char *key = CLOD_FIELDS[number].key;
    const clod_plan_measure *unit = &clod_number_find(&self->tests[from->test], key)->measure;
    clod_warning_list_add(
        &self->warnings,
        "%s falls from %.4g %s at %.4g kPa of consolidation (test %.40s, targets.%zu) to %.4g %s at %.4g kPa "
        "(test %.40s, targets.%zu), by %.1f standard errors: no solid gets weaker or looser by more "
        "consolidation. Are values, or stresses of the cases, interchanged, or are these two solids?",
        key, unit->factor * from->value, unit->unit, 1e-3 * from->stress,
        self->tests[from->test].name, from->entry, unit->factor * to->value, unit->unit,
        1e-3 * to->stress, self->tests[to->test].name, to->entry, errors);
}

/** The same of an angle, whose shear stress falls. */
static void warn_of_flat(clod_plan *self, clod_field_index number, const statement *from,
                         const statement *to, double errors)
{
    const char *key = CLOD_FIELDS[number].key;
    clod_warning_list_add(
        &self->warnings,
        "%s falls from %.1f deg at %.4g kPa of consolidation (test %.40s, targets.%zu) to %.1f deg at %.4g kPa (test "
        "%.40s, targets.%zu), so fast that stress times tan(%s) falls as well, by %.1f standard errors: no solid bears less "
        "by more consolidation. Are values, or stresses of the cases, interchanged, or are these two solids?",
        key, atan(from->value / from->stress) / CLOD_NUMBER_DEGREE, 1e-3 * from->stress,
        self->tests[from->test].name, from->entry,
        atan(to->value / to->stress) / CLOD_NUMBER_DEGREE, 1e-3 * to->stress,
        self->tests[to->test].name, to->entry, key, errors);
}

/** Targets and yield loci. */
static size_t statements(const clod_plan *self)
{
    size_t count = self->target_count;
    for (const clod_plan_locus *locus = self->loci; locus != NULL; locus = locus->next) {
        count++;
    }
    return count;
}

/** Warn of the firmest fall of a number. */
static void warn_of_number(clod_plan *self, clod_field_index number)
{
    const size_t count = statements(self);
    statement from, to, worst[2] = {{0}};
    double most = CLOD_PLAN_FIRM_ERRORS;
    for (size_t k = 0; k < count; k++) {
        for (size_t m = 0; m < count && say_stress(self, k, number, &from); m++) {
            const double errors =
                say_stress(self, m, number, &to) ? fall(self, &from, &to) : 0.0;
            if (errors > most) {
                most = errors;
                worst[0] = from;
                worst[1] = to;
            }
        }
    }
    if (most > CLOD_PLAN_FIRM_ERRORS) {
        (is_angle(number) ? warn_of_flat : warn_of_fall)(self, number, &worst[0], &worst[1],
                                                         most);
    }
}

// ---- a peak above preshear

/** Warn of a shear stress below the preshear stress that is above what preshear bore; whether there was a reason. */
static bool warn_of_peak(clod_plan *self, const clod_plan_target *peak, clod_field_index number)
{
    statement of;
    for (size_t k = 0; k < statements(self); k++) {
        if (!say_stress(self, k, number, &of) || of.test != peak->test ||
            of.entry == peak->entry || peak->normal_stress >= of.stress) {
            continue;
        }
        const double errors = CLOD_PLAN_FIRM_ERRORS * hypot(peak->error, of.error);
        if (peak->value - of.value > fmax(errors, STORED * of.value)) {
            clod_warning_list_add(
                &self->warnings,
                "targets.%zu: %s, %.4g kPa, is above the shear stress of preshear, %.4g kPa (%s in targets.%zu): below the "
                "preshear stress a solid bears less than that, unless it was stored in between. Is it of another "
                "preshear, or has one of them another unit?",
                peak->entry, peak->name, 1e-3 * peak->value, 1e-3 * of.value,
                CLOD_FIELDS[number].key, of.entry);
            return true;
        }
    }
    return false;
}

static void warn_of_peaks(clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *one = &self->targets[k];
        if (strcmp(one->number, "tau") == 0 && self->wishes[one->entry].locus == NULL &&
            !warn_of_peak(self, one, CLOD_FIELD_TAU_P)) {
            warn_of_peak(self, one, CLOD_FIELD_PHI_SF);
        }
    }
}

// ---- a target that is there twice

/** Whether two targets of different entries are equal to the last digit. */
static bool is_copy(const clod_plan_target *a, const clod_plan_target *b)
{
    return a->entry != b->entry && a->test == b->test && !a->held_back && !b->held_back &&
           strcmp(a->number, b->number) == 0 && a->normal_stress == b->normal_stress &&
           a->value == b->value && a->error == b->error;
}

/** Two specimens may have one rounded value, so it is no refusal. */
static void warn_of_copies(clod_plan *self)
{
    size_t next = 0; // entry that has had no warning yet
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *one = &self->targets[k];
        for (size_t m = 0; m < k && one->entry >= next; m++) {
            if (is_copy(&self->targets[m], one)) {
                next = one->entry + 1;
                clod_warning_list_add(
                    &self->warnings,
                    "targets.%zu: %s has the value and the error of targets.%zu to the last digit, and counts as a second "
                    "measurement, which makes intervals narrower. If it is the same one, leave it out; if two specimens "
                    "gave it, all is well.",
                    one->entry, one->name, self->targets[m].entry);
            }
        }
    }
}

// ---- density away from the walls

static bool is_of(const clod_plan_target *self, const clod_plan_target *other,
                  const char *number)
{
    return self->test == other->test && strcmp(self->number, number) == 0 &&
           fabs(self->normal_stress - other->normal_stress) <=
               CLOD_NUMBER_SAME_STRESS * other->normal_stress;
}

/** Warn of a solid that is looser inside than with the gaps that grains leave at walls. */
static void warn_of_inside(clod_plan *self)
{
    for (size_t k = 0; k < self->target_count; k++) {
        const clod_plan_target *whole = &self->targets[k];
        for (size_t m = 0; m < self->target_count && strcmp(whole->number, "rho_b") == 0; m++) {
            const clod_plan_target *inside = &self->targets[m];
            const double errors =
                (whole->value - inside->value) / hypot(whole->error, inside->error);
            if (is_of(inside, whole, "rho_inside") && errors > CLOD_PLAN_FIRM_ERRORS) {
                clod_warning_list_add(
                    &self->warnings,
                    "test %s: rho_inside %.0f kg/m3 in targets.%zu is below rho_b %.0f kg/m3 in targets.%zu, by "
                    "%.1f standard errors: grains leave gaps at the walls of a cell, so the whole of it is the "
                    "looser one. Are the two interchanged?",
                    self->tests[whole->test].name, inside->value, inside->entry, whole->value,
                    whole->entry, errors);
            }
        }
    }
}

void clod_plan_warn_doubts(clod_plan *self)
{
    // a warning, not a refusal: that two cases name their material alike does not make them one solid
    static const clod_field_index RISING[] = {CLOD_FIELD_TAU_P,   CLOD_FIELD_SIGMA_1,
                                              CLOD_FIELD_SIGMA_C, CLOD_FIELD_RHO_B,
                                              CLOD_FIELD_PHI_E,   CLOD_FIELD_PHI_SF};
    warn_of_errors(self);
    for (size_t k = 0; k < sizeof RISING / sizeof RISING[0]; k++) {
        warn_of_number(self, RISING[k]);
    }
    warn_of_inside(self);
    warn_of_peaks(self);
    warn_of_copies(self);
    clod_plan_warn_values(self);
    clod_plan_warn_keys(self);
    clod_plan_warn_count(self);
    clod_plan_warn_shared_specimens(self);
}
