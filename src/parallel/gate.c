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

static bool opened_while_spinning(const clod_gate *self, uint64_t times)
{
    for (int spins = 0; spins < SPINS; spins++) {
        if (clod_gate_opened(self) >= times) {
            return true;
        }
        relax();
    }
    return false;
}

/** Those that are waited for may have no processor: it is theirs at once, without the sleep and the
 * waking of whoever waits. */
static bool opened_while_yielding(const clod_gate *self, uint64_t times)
{
    for (int yields = 0; yields < YIELDS; yields++) {
        if (clod_gate_opened(self) >= times) {
            return true;
        }
        sched_yield();
    }
    return false;
}

void clod_gate_wait(clod_gate *self, uint64_t times)
{
    if (!(self->crowded ? opened_while_yielding(self, times)
                        : opened_while_spinning(self, times))) {
        sleep_until(self, times);
    }
}
