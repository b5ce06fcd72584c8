#pragma once
/**
 * @file table_kind.h
 * Which kind of table each key of a hopper's case takes.
 */

#include "hopper/case.h"

/**
 * Refuse a table that is plainly of another kind than its key takes, by its header; its reader tells the rest. Results
 * folders and pipes are not looked at.
 *
 * Errors  CLOD_USAGE with file, key, what the table is and where it belongs.
 * Threads  safe.   Test  tests/hopper/test_refusals.py
 */
bool clod_table_kind_check(const clod_hopper_case *from, clod_status *status);
