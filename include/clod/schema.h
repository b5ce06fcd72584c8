#pragma once
/**
 * @file schema.h
 * The keys of the files that clod reads explained: for people, for editors, as a manual.
 * A NULL where an argument is needed: see clod/status.h.
 */

#include "clod/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The keys of one kind of file; opaque and static. Of a hopper: clod_hopper_schema. */
typedef struct clod_schema clod_schema;

/** Those of a case file. Threads  pure. */
const clod_schema *clod_schema_case(void);

/**
 * What a key means: kind, unit, allowed range, default, source.
 *
 * @param schemas kinds of file in which it is looked for, NULL behind the last; NULL: case files
 * @param key     path such as "ring_shear.depth" or "grains.0.count", the last part of one such
 * as "k_adh"; either behind the verb that reads the file, "hopper.wall_friction", where several files have a
 * key of that name; a verb that reads one of these files ("run", "hopper", "calibrate"), for the topmost
 * keys of that file, where no key is called so; or NULL for a list of all keys
 * @param status  [out] when there is no such key: what may have been meant
 * @return        owned text (clod_schema_free), or NULL
 * Errors  CLOD_USAGE, CLOD_FAILED.   Threads  pure.   Test  tests/config/test_schema.c
 */
char *clod_schema_explain(const clod_schema *const *schemas, const char *key,
                          clod_status *status);

/** The JSON Schema (draft 2020-12) of case files, for editors; owned text, NULL without memory.
 */
char *clod_schema_json(void);

/** The manual of all keys in Markdown, `schemas` as above; owned text, NULL without memory. */
char *clod_schema_manual(const clod_schema *const *schemas);

/** Free a text of this header or of clod_case_echo; NULL is fine. */
void clod_schema_free(char *text);

#ifdef __cplusplus
}
#endif
