#pragma once
/**
 * @file gate.h
 * A count that one thread raises and others wait for: they spin for the few microseconds that
 * threads differ, or yield where there are more of them than processors, then sleep, so that a run shares a busy machine with others instead of
 * fighting them (docs/adr/0008).
 */

#include <pthread.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

typedef struct clod_gate {
    _Alignas(64) atomic_uint_fast64_t opened; ///< how many times
    atomic_int sleepers;
    pthread_mutex_t lock; ///< of the sleepers only
    pthread_cond_t woken;
    bool crowded; ///< more threads than processors
} clod_gate;

/** @param threads  of the team, and of all teams with the same processors; more than there are processors
 * yield in place of spinning: whoever spins keeps the one that is waited for from its processor */
void clod_gate_init(clod_gate *self, int threads);

/** How many times it has been opened. */
uint64_t clod_gate_opened(const clod_gate *self);

/** Open it once more; what was written before is visible to those who waited for it. */
void clod_gate_open(clod_gate *self);

/** Wait until it has been opened `times` times. */
void clod_gate_wait(clod_gate *self, uint64_t times);
