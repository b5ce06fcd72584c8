#pragma once
/**
 * @file barrier.h
 * Meeting point of the threads of a step, several times per step: it spins for the few
 * microseconds that chunks differ, then sleeps, so that a run shares a busy machine with others
 * instead of fighting them.
 */

#include <pthread.h>
#include <stdatomic.h>

typedef struct clod_barrier {
    _Alignas(64) atomic_int arrived;
    _Alignas(64) atomic_uint round;
    atomic_int sleepers;
    int threads;
    pthread_mutex_t lock; ///< of the sleepers only
    pthread_cond_t woken;
} clod_barrier;

void clod_barrier_init(clod_barrier *self, int threads);

/** Wait until all threads are here; what they wrote before is visible after. */
void clod_barrier_wait(clod_barrier *self);
