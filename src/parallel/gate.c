#include "parallel/gate.h"

#include <sched.h>

#include "parallel/threads.h"

#define SPINS 2000 ///< about 20 microseconds
#define YIELDS 30  ///< enough for 16 threads on two processors (docs/adr/0008)

void clod_gate_init(clod_gate *self, int threads)
{
    self->crowded = threads > clod_threads_available();
    atomic_init(&self->opened, 0);
    atomic_init(&self->sleepers, 0);
    self->lock = (pthread_mutex_t)PTHREAD_MUTEX_INITIALIZER;
    self->woken = (pthread_cond_t)PTHREAD_COND_INITIALIZER;
}

static inline void relax(void)
{
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

uint64_t clod_gate_opened(const clod_gate *self)
{
    return atomic_load_explicit(&self->opened, memory_order_acquire);
}

/** Whoever falls asleep meanwhile has said so before it looks at the count again, and both are
 * in one total order: it sees the new count, or is seen. A read and write in one, not a store:
 * qemu's ARM on x86 lets the load overtake a store (docs/adr/0014). */
void clod_gate_open(clod_gate *self)
{
    atomic_fetch_add(&self->opened, 1);
    if (atomic_load(&self->sleepers) > 0) {
        pthread_mutex_lock(&self->lock);
        pthread_cond_broadcast(&self->woken);
        pthread_mutex_unlock(&self->lock);
    }
}

static void sleep_until(clod_gate *self, uint64_t times)
{
    pthread_mutex_lock(&self->lock);
    atomic_fetch_add(&self->sleepers, 1);
    while (atomic_load(&self->opened) < times) {
        pthread_cond_wait(&self->woken, &self->lock);
    }
    atomic_fetch_sub(&self->sleepers, 1);
    pthread_mutex_unlock(&self->lock);
}

/** Where there are more threads than processors, those that are waited for may have none: it is
 * theirs at once, without the sleep and the waking of whoever waits. */
void clod_gate_wait(clod_gate *self, uint64_t times)
{
    const int turns = self->crowded ? YIELDS : SPINS;
    for (int turn = 0; turn < turns; turn++) {
        if (clod_gate_opened(self) >= times) {
            return;
        }
        if (self->crowded) {
            sched_yield();
        } else {
            relax();
        }
    }
    sleep_until(self, times);
}
