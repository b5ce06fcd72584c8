/**
 * @file duration.h
 * A duration on the clock, as batch systems and people write it.
 */
#pragma once

#include <stdbool.h>

/**
 * Read "90 s", "30 min", "2.5 h", "1 d", or [DAYS-]HOURS:MINUTES[:SECONDS] as Slurm and PBS do.
 *
 * @param seconds  [out] > 0
 * @return         false: it is none of these
 */
bool clod_duration_read(const char *text, double *seconds);
