#pragma once
/**
 * @file hopper.h
 * Design of a hopper from what was measured of a bulk solid and its wall: half angle for mass flow,
 * smallest outlet without an arch, rathole, with intervals by propagation of the errors.
 * docs/theory/hopper.md has the equations, docs/howto/hopper.md the case file. A NULL where an
 * argument is needed: see clod/status.h.
 */

#include <stddef.h>

#include "clod/schema.h"
#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** A finished design; opaque. */
typedef struct clod_hopper clod_hopper;

/**
 * Read the case file of a hopper and the tables it names, and design.
 *
 * @param path       the case file
 * @param overrides  [override_count] texts key.path=value in place of what the file says
 * @return           owned design (clod_hopper_destroy), or NULL
 * Errors  CLOD_USAGE: a NULL, case or tables are wrong, with file, line, value and what to do;
 *         CLOD_FAILED: memory.
 * Threads safe; uses all processors for the samples, with the same result on any number.
 * Test    tests/hopper/test_hopper.py
 */
clod_hopper *clod_hopper_create(const char *path, const char *const *overrides,
                                size_t override_count, clod_status *status);

/** Keys of the case file, for clod_schema_explain. Threads  pure. */
const clod_schema *clod_hopper_schema(void);

/** Free and null; NULL is fine. */
void clod_hopper_destroy(clod_hopper **self);

/** Results for people: aligned tables with units, intervals, warnings; owned, or NULL. */
char *clod_hopper_table(const clod_hopper *self);

/** Everything as JSON, units in the names; owned text (clod_hopper_free), or NULL. */
char *clod_hopper_json(const clod_hopper *self);

/** The design chart as SVG: flow function with flow factors, and limits of mass flow; owned text
 *  (clod_hopper_free), or NULL. */
char *clod_hopper_chart(const clod_hopper *self);

/** Free a text of this header; NULL is fine. */
void clod_hopper_free(char *text);

#ifdef __cplusplus
}
#endif
