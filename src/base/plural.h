#pragma once
/**
 * @file plural.h
 * Nouns behind numbers in texts for the user.
 */

/** Ending of a noun behind a number: "1 grain", "2 grains". */
static inline const char *clod_plural(double count)
{
    return count == 1.0 ? "" : "s";
}
