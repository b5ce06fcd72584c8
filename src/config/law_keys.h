#pragma once
/**
 * @file law_keys.h
 * Contact laws as the case file sees them: names and keys of the rows in src/law/law_kinds.c.
 * Loading, checks, echo and help read them here.
 */

#include "law/law_kinds.h"

/**
 * Keys of a law.
 *
 * @param law  clod_law_kind
 * @return     never NULL
 * Errors  none.   Threads  pure.   Test  tests/law/test_law_kinds.c
 */
const clod_law_keys *clod_law_keys_of(int law);

#define CLOD_LAW_KEYS_TEXT 128

/**
 * Names of the laws that have a key, as "law eepa" or "the laws mepa, luding and eepa".
 *
 * @param has   whether the law of a row has the key
 * @param text  [out]
 * @return      how many have it
 * Errors  none.   Threads  pure.   Test  tests/config/test_wrong.c
 */
int clod_law_keys_list(bool (*has)(const clod_law_keys *law), char text[CLOD_LAW_KEYS_TEXT]);

/** Exponent that the law of this name always has; 0 when it is free or there is no such law. */
double clod_law_keys_exponent(const char *name);

#define CLOD_LAW_KEYS_ABOUT 512

/** What each law is, as "mepa (elasto-plastic with adhesion), hertz (...)". */
void clod_law_keys_about(char text[CLOD_LAW_KEYS_ABOUT]);
