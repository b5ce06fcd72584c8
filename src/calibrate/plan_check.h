#pragma once
/**
 * @file plan_check.h
 * What a plan must be beyond its keys; for plan.c alone.
 */

#include "calibrate/plan.h"
#include "config/load.h"

/** Numbers of ranges, cases of the tests at both ends of all ranges, then the targets; errors in the
 *  report with their places. */
void clod_plan_check(clod_loader *loader, clod_plan *self);

/** Targets from wishes (plan_targets.c). */
void clod_plan_make_targets(clod_loader *loader, clod_plan *self);

/** Complain about a value: at its place, with its path. */
void clod_plan_complain(clod_loader *loader, const char *path, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
