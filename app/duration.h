/**
 * @file duration.h
 * A duration on the clock, as batch systems and people write it.
 */
#pragma once

#include <stdbool.h>

/**
 * Read "90 s", "30 min", "2.5 h", "1 d", or as Slurm and PBS write it: MINUTES:SECONDS,
 * HOURS:MINUTES:SECONDS, DAYS-HOURS[:MINUTES[:SECONDS]].
 *
 * @param seconds  [out] > 0
 * @return         false: it is none of these
 */
bool clod_duration_read(const char *text, double *seconds);
