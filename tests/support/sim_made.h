#pragma once
/**
 * @file sim_made.h
 * Simulations of the library, and what its calls say when they fail, for tests.
 */

#include <string.h>

#include "clod/sim.h"
#include "support/check.h"

static clod_status status;

/** The call succeeds; else its text is told. */
#define CHECK(call)                                                                            \
    do {                                                                                       \
        if (!(call)) {                                                                         \
            fail_msg("%s", status.text);                                                       \
        }                                                                                      \
    } while (0)

/** A call that returned `done` was refused, with these words in its text. */
static inline void expect_refused(bool done, const char *words)
{
    assert_false(done);
    assert_int_equal(status.code, CLOD_USAGE);
    if (strstr(status.text, words) == NULL) {
        fail_msg("'%s' does not say '%s'", status.text, words);
    }
}

/** The simulation of a case, owned. */
static inline clod_sim *sim_made(const char *text, int threads)
{
    const clod_sim_options options = {.threads = threads};
    clod_sim *sim = clod_sim_create_from_text("case.yaml", text, &options, &status);
    CHECK(sim != NULL);
    return sim;
}

/** Numbers of all grains. */
static inline clod_sim_view sim_view(clod_sim *sim, const char *name)
{
    clod_sim_view view;
    CHECK(clod_sim_array(sim, name, &view, &status));
    return view;
}
