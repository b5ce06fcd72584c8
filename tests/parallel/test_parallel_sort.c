// The sort by several threads against the C library's sort, with stability: whatever the number of
// items, parts and threads.

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "parallel/parallel_sort.h"
#include "support/check.h"
#include "support/dice.h"
#include "support/sort_reference.h"

#define MOST_THREADS 4
#define MOST_PARTS 9

typedef struct member {
    const clod_parallel_sort *job;
    clod_barrier *barrier;
    int number;
    clod_sort_item *sorted;
} member;

static void *take_part(void *argument)
{
    member *self = argument;
    const clod_chunk parts =
        clod_threads_chunk((size_t)self->job->parts, self->number, self->barrier->threads);
    self->sorted = clod_parallel_sort_do(self->job, parts, self->barrier);
    return NULL;
}

/** Where all threads say that the sorted items are. */
static clod_sort_item *sort_together(const clod_parallel_sort *job, int threads)
{
    clod_barrier barrier;
    pthread_t thread[MOST_THREADS];
    member members[MOST_THREADS];
    clod_barrier_init(&barrier, threads, threads);
    for (int t = 0; t < threads; t++) {
        members[t] = (member){.job = job, .barrier = &barrier, .number = t};
        assert_int_equal(pthread_create(&thread[t], NULL, take_part, &members[t]), 0);
    }
    for (int t = 0; t < threads; t++) {
        assert_int_equal(pthread_join(thread[t], NULL), 0);
    }
    for (int t = 1; t < threads; t++) {
        assert_ptr_equal(members[t].sorted, members[0].sorted);
    }
    return members[0].sorted;
}

typedef struct sample {
    size_t count;
    clod_sort_item *items, *expected, *found, *scratch; ///< one more than count
} sample;

static sample sample_of(size_t count, uint64_t mask)
{
    dice roll = {count};
    const sample self = {.count = count,
                         .items = calloc(count + 1, sizeof *self.items),
                         .expected = calloc(count + 1, sizeof *self.items),
                         .found = calloc(count + 1, sizeof *self.items),
                         .scratch = calloc(count + 1, sizeof *self.items)};
    for (size_t k = 0; k < count; k++) {
        self.items[k] = (clod_sort_item){dice_bits(&roll) & mask, k};
    }
    memcpy(self.expected, self.items, count * sizeof *self.items);
    qsort(self.expected, count, sizeof *self.expected, sort_compare);
    return self;
}

static void check(const sample *self, int parts, int threads)
{
    const size_t count = self->count;
    clod_sort_part part[MOST_PARTS];
    const clod_parallel_sort job = {self->found, self->scratch, count, part, parts};
    memcpy(self->found, self->items, count * sizeof *self->items);
    self->found[count] = self->scratch[count] = (clod_sort_item){77, 78}; // not to be touched
    const clod_sort_item *sorted = sort_together(&job, threads);
    assert_true(sorted == self->found || sorted == self->scratch);
    assert_memory_equal(sorted, self->expected, count * sizeof *sorted);
    assert_true(self->found[count].key == 77 && self->found[count].index == 78);
    assert_true(self->scratch[count].key == 77 && self->scratch[count].index == 78);
}

static void check_all(size_t count, uint64_t mask)
{
    const sample self = sample_of(count, mask);
    for (int threads = 1; threads <= MOST_THREADS; threads++) {
        check(&self, threads, threads);
        check(&self, MOST_PARTS, threads);
    }
    check(&self, 1, 2); // a thread without parts
    free(self.items);
    free(self.expected);
    free(self.found);
    free(self.scratch);
}

/** All bits; one digit; bits of two digits; the top; digits that lie across bytes; few keys; and one. */
static void keys_come_out_as_qsort_has_them(void **state)
{
    (void)state;
    const uint64_t masks[] = {UINT64_MAX, 0xff,           0xff00000000ff, 1ull << 63,
                              0x7f8ull,   0x1f0000003ff8, 0x8000000001,   0};
    for (size_t m = 0; m < sizeof masks / sizeof *masks; m++) {
        check_all(255, masks[m]);
        check_all(6000, masks[m]);
    }
}

/** None, one, two, and fewer than there are parts. */
static void few_items_are_sorted(void **state)
{
    (void)state;
    for (size_t count = 0; count < MOST_PARTS; count++) {
        check_all(count, UINT64_MAX);
        check_all(count, 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_come_out_as_qsort_has_them),
        cmocka_unit_test(few_items_are_sorted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
