#pragma once
/**
 * @file run.h
 * Run a case: a free run, a shear test from filling to yield locus, a uniaxial test from
 * filling to flow function, or a wall friction test from filling to wall yield locus. The same call goes on from the checkpoints that an interrupted
 * run left in its folder. A NULL where an argument is needed: see clod/status.h.
 */

#ifdef __cplusplus
#include <atomic>
#else
#include <stdatomic.h>
#endif
#include <stdbool.h>
#include <stdint.h>

#include "clod/case.h"
#include "clod/status.h"

/** A number that a signal handler or another thread may set. */
#ifdef __cplusplus
typedef std::atomic<int> clod_run_signal; // laid out as the one of C (gcc, clang)
#else
typedef atomic_int clod_run_signal;
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** How far a part of a run is; parts of a test run side by side. */
typedef struct clod_progress {
    const char *part;         ///< name of the part, for instance "preshear"
    const char *phase;        ///< what it is doing
    double time;              ///< s simulated
    int64_t step;             ///< steps done
    double grain_steps_per_s; ///< rate since the last call
    double fraction;          ///< of the part that is done, 0 to 1; at least this much
    double remaining;         ///< s of wall-clock time, at most; < 0 = not known
    bool finished;
} clod_progress;

typedef struct clod_run_options {
    const char *directory; ///< results folder; NULL = run/NAME for NAME.yaml
    int threads;           ///< 0 = all processors; never more than there are
    const char *simd;      ///< instruction set; NULL = the best
    bool fresh;            ///< forget earlier results of this folder
    const char *from; ///< begin with the grains of the run in this folder, or of its moment
                      ///< that was kept, FOLDER@SECONDS; NULL: with grains of its own
    struct clod_ranks
        *ranks;            ///< that compute it together (clod/ranks.h): this is rank 0; or NULL
    clod_run_signal *stop; ///< not zero: write checkpoints and return; or NULL
    clod_run_signal *save; ///< another number than before: each part that is running writes a
                           ///< checkpoint, to be kept, and a snapshot, and goes on; or NULL
    void (*progress)(void *context, const clod_progress *now); ///< any thread; or NULL
    void (*notice)(void *context, const char *text); ///< a sentence for the user; or NULL
    void *context;
    double time_limit; ///< s from this call on, before which it stops as by `stop`; 0: none
} clod_run_options;

/**
 * Run a case to its end, or until *stop.
 *
 * @param self     checked case
 * @param options  how; all zero: the defaults
 * @param report   [out] owned text for people: result table and warnings (clod_run_free)
 * @return         false: CLOD_INTERRUPTED when stopped (the same call goes on later), else what
 *                 went wrong; checkpoints are written in either case
 * Errors  CLOD_USAGE: a NULL, the case cannot be built, the folder is in use or of another case;
 *         CLOD_FAILED: disk, memory, physics gone wrong.   Threads  one per folder.
 * Test    tests/sim/, tests/cli/
 */
bool clod_run(const clod_case *self, const clod_run_options *options, char **report,
              clod_status *status);

/** Free the report; NULL is fine. */
void clod_run_free(char *report);

#ifdef __cplusplus
}
#endif
