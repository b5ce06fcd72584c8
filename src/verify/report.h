#pragma once
/**
 * @file report.h
 * What a run of the suite found: rows, their verdict, and the table for people.
 */

#include "verify/verify.h"

/**
 * Judge a row and append it.
 *
 * @param row  all but `passed`; a row passes when |got - expected| <= tolerance (times
 *             |expected| when relative); NAN never does
 * Errors  CLOD_FAILED: memory.   Threads  pure.   Test  tests/verify/test_report.c
 */
bool clod_verify_report_add(clod_verify_report *self, const clod_verify_row *row,
                            clod_status *status);

/**
 * The row that was added last is known to miss, for this reason: a recorded miss, which counts
 * as a miss when it passes and not otherwise. In a slow report it may pass: beds are chaotic.
 */
void clod_verify_report_record_miss(clod_verify_report *self, const char *reason);

/** The report in Markdown; owned text (clod_memory_free), or NULL without memory. */
char *clod_verify_report_text(const clod_verify_report *self);
