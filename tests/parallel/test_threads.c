// Chunks that cover everything once, jobs that all run, and the barrier.

#include <omp.h>
#include <stdatomic.h>

#include "parallel/barrier.h"
#include "parallel/threads.h"
#include "support/check.h"

static void chunks_cover_all_items_once_and_evenly(void **state)
{
    (void)state;
    for (size_t count = 0; count < 70; count++) {
        for (int parts = 1; parts < 20; parts++) {
            size_t next = 0;
            for (int p = 0; p < parts; p++) {
                const clod_chunk c = clod_threads_chunk(count, p, parts);
                assert_int_equal(c.begin, next);
                assert_true(c.end >= c.begin);
                assert_in_range(c.end - c.begin, count / (size_t)parts,
                                count / (size_t)parts + 1);
                next = c.end;
            }
            assert_int_equal(next, count);
        }
    }
}

static void there_is_a_processor(void **state)
{
    (void)state;
    assert_true(clod_threads_available() >= 1);
}

typedef struct jobs {
    atomic_int runs[50];
    atomic_int running, most;
    atomic_int inner; ///< threads seen inside the jobs
} jobs;

static void job(void *context, int number)
{
    jobs *self = context;
    const int running = atomic_fetch_add(&self->running, 1) + 1;
    int most = atomic_load(&self->most);
    while (running > most && !atomic_compare_exchange_weak(&self->most, &most, running)) {
    }
    atomic_fetch_add(&self->runs[number], 1);
#pragma omp parallel num_threads(2)
    {
        if (omp_get_thread_num() == 0) {
            atomic_fetch_add(&self->inner, omp_get_num_threads());
        }
    }
    atomic_fetch_sub(&self->running, 1);
}

/** Every job runs once, at most `workers` at a time, and may use threads of its own. */
static void every_job_runs_once(void **state)
{
    (void)state;
    for (int workers = 1; workers <= 3; workers++) {
        jobs all = {0};
        clod_threads_run(50, workers, job, &all);
        for (int k = 0; k < 50; k++) {
            assert_int_equal(atomic_load(&all.runs[k]), 1);
        }
        assert_true(atomic_load(&all.most) <= workers);
        assert_int_equal(atomic_load(&all.inner), 100);
    }
    jobs none = {0};
    clod_threads_run(0, 2, job, &none);
    assert_int_equal(atomic_load(&none.most), 0);
}

/** Behind the barrier everybody sees what was written before it, round after round. */
static void a_barrier_separates_rounds(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 4; threads++) {
        clod_barrier barrier;
        clod_barrier_init(&barrier, threads);
        int written[4] = {0}; // not atomic: the barrier orders them
        int wrong = 0;
#pragma omp parallel num_threads(threads) reduction(+ : wrong)
        {
            const int me = omp_get_thread_num();
            for (int round = 1; round <= 500; round++) {
                written[me] = round;
                clod_barrier_wait(&barrier);
                for (int t = 0; t < threads; t++) {
                    wrong += written[t] != round;
                }
                clod_barrier_wait(&barrier);
            }
        }
        assert_int_equal(wrong, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chunks_cover_all_items_once_and_evenly),
        cmocka_unit_test(there_is_a_processor),
        cmocka_unit_test(every_job_runs_once),
        cmocka_unit_test(a_barrier_separates_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
