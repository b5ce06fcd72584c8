#include "parallel/threads.h"

#include <omp.h>
#include <pthread.h>
#include <stdatomic.h>

#include "base/assert.h"

#define WORKERS_MAX 256

/** What the workers share. */
typedef struct job_queue {
    int count;
    atomic_int next;
    void (*job)(void *context, int number);
    void *context;
} job_queue;

int clod_threads_available(void)
{
    return omp_get_num_procs();
}

int clod_threads_take(int wanted)
{
    const int most = clod_threads_available();
    return wanted > 0 && wanted < most ? wanted : most;
}

int clod_threads_worth(int threads, size_t grains)
{
    const size_t most = grains / CLOD_THREADS_GRAINS;
    return most >= (size_t)threads ? threads : most > 1 ? (int)most : 1;
}

static void *work(void *argument)
{
    job_queue *queue = argument;
    for (int number = atomic_fetch_add(&queue->next, 1); number < queue->count;
         number = atomic_fetch_add(&queue->next, 1)) {
        queue->job(queue->context, number);
    }
    return NULL;
}

// Plain threads, not OpenMP's: each keeps an OpenMP team of its own for the steps of its job.
void clod_threads_run(int count, int workers, void (*job)(void *context, int number),
                      void *context)
{
    job_queue queue = {.count = count, .job = job, .context = context};
    pthread_t thread[WORKERS_MAX];
    int started = 0;
    workers = workers > WORKERS_MAX ? WORKERS_MAX : workers;
    while (started < workers - 1 && pthread_create(&thread[started], NULL, work, &queue) == 0) {
        started++;
    }
    work(&queue); // this thread works too, and alone when no other could be started
    for (int t = 0; t < started; t++) {
        CLOD_ASSERT(pthread_join(thread[t], NULL) == 0);
    }
}
