#pragma once
/**
 * @file eventlog.h
 * log.jsonl: one JSON object per line, {"time": "2026-01-31T12:00:00.000Z", "event": ..., ...}.
 *
 * A log that cannot be written does not stop a run: the first error is kept and reported when
 * the log is closed.
 */

#include <jansson.h>

#include "base/bytes.h"
#include "output/folder.h"

typedef struct clod_eventlog clod_eventlog;

/**
 * Open a log; lines are added behind what is there, after a newline if the last run was cut
 * off. The folder is borrowed until the log is closed.
 * @return  owned log (clod_eventlog_close), or NULL
 * Errors  CLOD_FAILED: cannot be opened.   Threads  the log may be shared by threads.
 * Test    tests/output/test_eventlog.c
 */
clod_eventlog *clod_eventlog_open(const clod_folder *folder, const char *name,
                                  clod_status *status);

/** A log whose lines are collected, for that of another process; NULL without memory. The bytes are
 *  borrowed. */
clod_eventlog *clod_eventlog_collect(clod_bytes *lines);

/** Lines that another log has collected. */
void clod_eventlog_append(clod_eventlog *self, const char *lines, size_t bytes);

/**
 * Write one line.
 *
 * @param self    NULL is fine: nothing is written
 * @param event   what happened
 * @param format  json_pack format of an object with the fields, e.g. "{s:i, s:f}"; NULL: none
 */
void clod_eventlog_write(clod_eventlog *self, const char *event, const char *format, ...);

/** The same with ready fields; takes over the reference to `fields`, which may be NULL. */
void clod_eventlog_write_json(clod_eventlog *self, const char *event, json_t *fields);

/** The same, unless the log has that event with those fields already: a run that goes on from an
 *  earlier checkpoint comes by it again. */
void clod_eventlog_write_once(clod_eventlog *self, const char *event, json_t *fields);

/** Close and null the pointer; false with the first error since the log was opened. */
bool clod_eventlog_close(clod_eventlog **self, clod_status *status);
