#include "parallel/barrier.h"

void clod_barrier_init(clod_barrier *self, int threads, int all)
{
    atomic_init(&self->arrived, 0);
    clod_gate_init(&self->round, all);
    self->threads = threads;
}

void clod_barrier_wait(clod_barrier *self)
{
    if (self->threads == 1) {
        return;
    }
    const uint64_t round = clod_gate_opened(&self->round);
    if (atomic_fetch_add_explicit(&self->arrived, 1, memory_order_acq_rel) + 1 ==
        self->threads) {
        atomic_store_explicit(&self->arrived, 0, memory_order_relaxed);
        clod_gate_open(&self->round);
    } else {
        clod_gate_wait(&self->round, round + 1);
    }
}
