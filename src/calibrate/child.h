#pragma once
/**
 * @file child.h
 * One `clod run` in a process of its own.
 */

#include <stdbool.h>
#include <sys/types.h>

#include "clod/status.h"

#define CLOD_CHILD_LOST (-1) ///< result of a process whose end the system does not tell

typedef struct clod_child {
    pid_t process; ///< 0: none
    double began;  ///< s on clod_clock_now
} clod_child;

/**
 * Start a program with its output in a file. It is told to end (SIGTERM) when this process dies.
 *
 * @param arguments  ended by NULL, the program's path first
 * @param log        path of the file for standard output and error
 * Errors  CLOD_FAILED: no process, no such program.   Threads  any.   Test  tests/calibrate/test_child.c
 */
bool clod_child_start(clod_child *self, char *const *arguments, const char *log,
                      clod_status *status);

/** Whether it has ended; then `result` is as waitpid gives it, or CLOD_CHILD_LOST. */
bool clod_child_ended(clod_child *self, int *result);

/** Ask it to stop with a checkpoint. */
void clod_child_stop(const clod_child *self);
