#include "parallel/barrier.h"

#include <sched.h>

#define SPINS 2000 ///< about 20 microseconds

void clod_barrier_init(clod_barrier *self, int threads)
{
    atomic_init(&self->arrived, 0);
    atomic_init(&self->round, 0);
    self->threads = threads;
}

static inline void relax(void)
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
}

void clod_barrier_wait(clod_barrier *self)
{
    if (self->threads == 1) {
        return;
    }
    const unsigned round = atomic_load_explicit(&self->round, memory_order_relaxed);
    if (atomic_fetch_add_explicit(&self->arrived, 1, memory_order_acq_rel) + 1 ==
        self->threads) {
        atomic_store_explicit(&self->arrived, 0, memory_order_relaxed);
        atomic_store_explicit(&self->round, round + 1, memory_order_release);
        return;
    }
    for (int spins = 0; atomic_load_explicit(&self->round, memory_order_acquire) == round;
         spins++) {
        if (spins < SPINS) {
            relax();
        } else {
            sched_yield();
        }
    }
}
