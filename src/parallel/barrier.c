#include "parallel/barrier.h"

#define SPINS 2000 ///< about 20 microseconds

void clod_barrier_init(clod_barrier *self, int threads)
{
    atomic_init(&self->arrived, 0);
    atomic_init(&self->round, 0);
    atomic_init(&self->sleepers, 0);
    self->threads = threads;
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

/** The last one opens the next round. Whoever falls asleep meanwhile has said so before it
 * looks at the round again, and both are in one total order: it sees the round, or is seen.
 * An exchange, not a store: qemu's ARM on x86 lets the load overtake a store (docs/adr/0014).
 */
static void open_round(clod_barrier *self, unsigned round)
{
    atomic_store_explicit(&self->arrived, 0, memory_order_relaxed);
    atomic_exchange(&self->round, round + 1);
    if (atomic_load(&self->sleepers) > 0) {
        pthread_mutex_lock(&self->lock);
        pthread_cond_broadcast(&self->woken);
        pthread_mutex_unlock(&self->lock);
    }
}

static void sleep_until(clod_barrier *self, unsigned round)
{
    pthread_mutex_lock(&self->lock);
    atomic_fetch_add(&self->sleepers, 1);
    while (atomic_load(&self->round) == round) {
        pthread_cond_wait(&self->woken, &self->lock);
    }
    atomic_fetch_sub(&self->sleepers, 1);
    pthread_mutex_unlock(&self->lock);
}

void clod_barrier_wait(clod_barrier *self)
{
    if (self->threads == 1) {
        return;
    }
    const unsigned round = atomic_load_explicit(&self->round, memory_order_relaxed);
    if (atomic_fetch_add_explicit(&self->arrived, 1, memory_order_acq_rel) + 1 ==
        self->threads) {
        open_round(self, round);
        return;
    }
    for (int spins = 0; spins < SPINS; spins++) {
        if (atomic_load_explicit(&self->round, memory_order_acquire) != round) {
            return;
        }
        relax();
    }
    sleep_until(self, round);
}
