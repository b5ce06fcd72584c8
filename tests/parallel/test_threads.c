// Chunks that cover everything once, jobs that all run, barrier and gate. Jobs with threads of
// their own: tests/step/test_side_by_side.c.

#include <pthread.h>
#include <stdatomic.h>
#include <time.h>

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

static void no_more_threads_than_processors(void **state)
{
    (void)state;
    const int all = clod_threads_available();
    assert_int_equal(clod_threads_take(0), all);
    assert_int_equal(clod_threads_take(1), 1);
    assert_int_equal(clod_threads_take(all), all);
    assert_int_equal(clod_threads_take(all + 1), all);
    assert_int_equal(clod_threads_take(1024), all > 1024 ? 1024 : all);
}

static void few_grains_are_worth_few_threads(void **state)
{
    (void)state;
    assert_int_equal(clod_threads_worth(8, 0), 1);
    assert_int_equal(clod_threads_worth(8, 999), 1);
    assert_int_equal(clod_threads_worth(8, 1000), 2);
    assert_int_equal(clod_threads_worth(8, 3999), 7);
    assert_int_equal(clod_threads_worth(8, 4000), 8);
    assert_int_equal(clod_threads_worth(8, SIZE_MAX), 8);
    assert_int_equal(clod_threads_worth(1, SIZE_MAX), 1);
}

typedef struct jobs {
    atomic_int runs[50];
    atomic_int running, most;
} jobs;

static void job(void *context, int number)
{
    jobs *self = context;
    const int running = atomic_fetch_add(&self->running, 1) + 1;
    int most = atomic_load(&self->most);
    while (running > most && !atomic_compare_exchange_weak(&self->most, &most, running)) {
    }
    atomic_fetch_add(&self->runs[number], 1);
    atomic_fetch_sub(&self->running, 1);
}

/** Every job runs once, at most `workers` at a time. */
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
    }
    jobs none = {0};
    clod_threads_run(0, 2, job, &none);
    assert_int_equal(atomic_load(&none.most), 0);
}

#define ROUNDS 500

typedef struct meeting {
    clod_barrier barrier;
    int written[4]; ///< not atomic: the barrier orders them
} meeting;

typedef struct member {
    meeting *meeting;
    int number;
    int wrong;
} member;

static void *take_part(void *argument)
{
    member *self = argument;
    meeting *all = self->meeting;
    for (int round = 1; round <= ROUNDS; round++) {
        all->written[self->number] = round;
        clod_barrier_wait(&all->barrier);
        for (int t = 0; t < all->barrier.threads; t++) {
            self->wrong += all->written[t] != round;
        }
        clod_barrier_wait(&all->barrier);
    }
    return NULL;
}

/** Behind the barrier everybody sees what was written before it, round after round. */
static void a_barrier_separates_rounds(void **state)
{
    (void)state;
    for (int threads = 1; threads <= 4; threads++) {
        meeting all = {0};
        member members[4];
        pthread_t thread[4];
        clod_barrier_init(&all.barrier, threads, threads);
        for (int t = 0; t < threads; t++) {
            members[t] = (member){&all, t, 0};
            assert_int_equal(pthread_create(&thread[t], NULL, take_part, &members[t]), 0);
        }
        for (int t = 0; t < threads; t++) {
            assert_int_equal(pthread_join(thread[t], NULL), 0);
            assert_int_equal(members[t].wrong, 0);
            assert_int_equal(all.written[t], ROUNDS);
        }
    }
}

typedef struct chain {
    clod_gate gate[3];
    int64_t written[ROUNDS + 1]; ///< not atomic: the gates order them
} chain;

typedef struct link {
    chain *chain;
    int number; ///< opens this gate, after the one before
} link;

static void *pass_on(void *argument)
{
    const link *self = argument;
    chain *all = self->chain;
    for (int round = 1; round <= ROUNDS; round++) {
        if (self->number > 0) {
            clod_gate_wait(&all->gate[self->number - 1], (uint64_t)round);
        }
        if (round % 100 == 0 && self->number == 0) {
            nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL); // the others fall asleep
        }
        all->written[round] = 10 * all->written[round] + self->number + 1;
        clod_gate_open(&all->gate[self->number]);
    }
    return NULL;
}

/** A gate of more threads than processors yields in place of spinning. */
static void a_gate_knows_whether_each_thread_has_a_processor(void **state)
{
    (void)state;
    clod_gate own, shared;
    clod_gate_init(&own, clod_threads_available());
    clod_gate_init(&shared, clod_threads_available() + 1);
    assert_false(own.crowded);
    assert_true(shared.crowded);
}

/** Who waits for a count sees what was written before it was reached, awake or asleep; who
 * opens does not wait for those behind. */
static void a_gate_lets_pass_what_it_has_opened_for(void **state)
{
    (void)state;
    chain all = {0};
    pthread_t thread[3];
    link links[3];
    for (int t = 0; t < 3; t++) {
        clod_gate_init(&all.gate[t], 3);
    }
    for (int t = 2; t >= 0; t--) {
        links[t] = (link){&all, t};
        assert_int_equal(pthread_create(&thread[t], NULL, pass_on, &links[t]), 0);
    }
    for (int t = 0; t < 3; t++) {
        assert_int_equal(pthread_join(thread[t], NULL), 0);
        assert_int_equal(clod_gate_opened(&all.gate[t]), ROUNDS);
    }
    for (int round = 1; round <= ROUNDS; round++) {
        assert_int_equal(all.written[round], 123);
    }
    clod_gate_wait(&all.gate[0], ROUNDS - 1); // has been opened more often: passes
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chunks_cover_all_items_once_and_evenly),
        cmocka_unit_test(there_is_a_processor),
        cmocka_unit_test(no_more_threads_than_processors),
        cmocka_unit_test(few_grains_are_worth_few_threads),
        cmocka_unit_test(every_job_runs_once),
        cmocka_unit_test(a_barrier_separates_rounds),
        cmocka_unit_test(a_gate_lets_pass_what_it_has_opened_for),
        cmocka_unit_test(a_gate_knows_whether_each_thread_has_a_processor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
