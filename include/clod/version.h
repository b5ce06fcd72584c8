#pragma once
/**
 * @file version.h
 * Which clod this is.
 */

#ifdef __cplusplus
extern "C" {
#endif

/**
 * Version, commit, compiler and flags of this build, in one line.
 *
 * @return static text, e.g. "clod 0.1.0 (1a2b3c4d5e6f), GNU 12.2.0, Release: -O3 -g"
 * Errors  none.   Threads  pure.
 * Test    tests/base/test_version.c
 */
const char *clod_version_text(void);

#ifdef __cplusplus
}
#endif
