#pragma once
/**
 * @file barrier.h
 * Barrier of the threads of a step, waited at several times per step.
 */

#include "parallel/gate.h"

typedef struct clod_barrier {
    _Alignas(64) atomic_int arrived;
    clod_gate round; ///< opened by the last one of each round
    int threads;
} clod_barrier;

/** @param threads  that meet here
 *  @param all      threads that share their processors, these among them (clod_gate_init) */
void clod_barrier_init(clod_barrier *self, int threads, int all);

/** Wait until all threads are here; what they wrote before is visible after. */
void clod_barrier_wait(clod_barrier *self);
