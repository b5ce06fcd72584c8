#pragma once
/**
 * @file stop.h
 * Whether someone wants a calibration to stop: asked in every loop that may take long.
 */

#include <stdbool.h>
#include <stddef.h>

#include "clod/status.h"

typedef struct clod_stop {
    bool (*asked)(void *context);
    void *context;
} clod_stop;

/** Whether to stop; never with NULL. */
static inline bool clod_stop_asked(const clod_stop *self)
{
    return self != NULL && self->asked(self->context);
}

/** Say that it was stopped; false. */
static inline bool clod_stop_fail(clod_status *status)
{
    return clod_status_fail(status, CLOD_INTERRUPTED, "Interrupted; the same command goes on.");
}
