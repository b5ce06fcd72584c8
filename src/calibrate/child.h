#pragma once
/**
 * @file child.h
 * One `clod run` in a process of its own.
 */

#include <stdbool.h>
#include <sys/types.h>

#include "clod/status.h"

typedef struct clod_child {
    pid_t process; ///< 0: none
    double began;  ///< s on clod_clock_now
} clod_child;

/**
 * Start a program with its output in a file. It is told to end (SIGTERM) when this process dies.
 *
 * @param arguments  ended by NULL, the program's path first
 * @param log        path of the file for standard output and error
 * Errors  CLOD_FAILED: no process.   Threads  any.
 */
bool clod_child_start(clod_child *self, char *const *arguments, const char *log,
                      clod_status *status);

/** Whether it has ended; then `result` is as waitpid gives it. */
bool clod_child_ended(clod_child *self, int *result);

/** Ask it to stop with a checkpoint. */
void clod_child_stop(const clod_child *self);
