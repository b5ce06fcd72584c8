#include "parallel/gate.h"

#include <stdbool.h>

#include "parallel/threads.h"

#define SPINS 2000 ///< about 20 microseconds
#define PROBE 256  ///< waits after which a gate that gave up spinning tries again

void clod_gate_init(clod_gate *self, int threads)
{
    self->most = threads > clod_threads_available() ? 0 : SPINS;
    atomic_init(&self->spins, self->most);
    atomic_init(&self->waits, 0);
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

/**
 * Where the one that is waited for has lost its processor to another program, spinning is in
 * vain and keeps the processor from it: each time halves the looks, each success doubles them,
 * and now and then all are tried again.
 */
void clod_gate_wait(clod_gate *self, uint64_t times)
{
    const int now = atomic_load_explicit(&self->spins, memory_order_relaxed);
    const bool full = now == self->most;
    const bool probe =
        !full && atomic_fetch_add_explicit(&self->waits, 1, memory_order_relaxed) % PROBE == 0;
    const int looks = probe ? self->most : now;
    for (int spins = 0; spins < looks; spins++) {
        if (clod_gate_opened(self) >= times) {
            if (!full) {
                const int more = 2 * looks < self->most ? 2 * looks : self->most;
                atomic_store_explicit(&self->spins, more, memory_order_relaxed);
            }
            return;
        }
        relax();
    }
    if (looks > 0) {
        atomic_store_explicit(&self->spins, now / 2, memory_order_relaxed);
    }
    sleep_until(self, times);
}
