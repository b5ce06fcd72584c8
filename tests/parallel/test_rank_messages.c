// What ranks say to each other arrives, whole and in the order of ranks.
#include "support/ranks_threads.h"

#define SIZE 5

static void append(const void *context, void *into, const void *from)
{
    (void)context;
    int64_t *mine = into;
    *mine = 10 * *mine + *(const int64_t *)from;
}

/** Digits 0 1 2 3 4 of the ranks, in this order on all of them. */
static void merge_in_order(clod_ranks *ranks, void *context)
{
    int64_t *found = context;
    found[ranks->rank] = ranks->rank;
    clod_ranks_merge(ranks, &found[ranks->rank], sizeof *found, append, NULL);
}

static void sums_are_merged_in_the_order_of_ranks(void **state)
{
    (void)state;
    int64_t found[SIZE] = {0};
    ranks_run(SIZE, merge_in_order, found);
    for (int r = 0; r < SIZE; r++) {
        assert_int_equal(found[r], 1234);
    }
}

/** What rank `from` has for rank `to`: as many letters as the two numbers say. */
static size_t letters(int from, int to)
{
    return (size_t)(from * to % 4) * 1000;
}

static char letter(int from, int to)
{
    return (char)('a' + 5 * from + to);
}

static void swap_letters(clod_ranks *ranks, void *context)
{
    bool *good = context;
    clod_status status = {0};
    clod_bytes out[SIZE] = {0}, in = {0};
    size_t begin[SIZE + 1];
    for (int r = 0; r < ranks->size; r++) {
        const char c = letter(ranks->rank, r);
        for (size_t k = 0; k < letters(ranks->rank, r); k++) {
            clod_bytes_put(&out[r], &c, 1);
        }
    }
    bool same = clod_ranks_swap(ranks, out, &in, begin, &status);
    for (int r = 0; same && r < ranks->size; r++) {
        same = begin[r + 1] - begin[r] == letters(r, ranks->rank);
        for (size_t k = begin[r]; same && k < begin[r + 1]; k++) {
            same = in.data[k] == letter(r, ranks->rank);
        }
        clod_bytes_fini(&out[r]);
    }
    clod_bytes_fini(&in);
    good[ranks->rank] = same;
}

static void bytes_arrive_at_whom_they_are_for(void **state)
{
    (void)state;
    bool good[SIZE] = {false};
    ranks_run(SIZE, swap_letters, good);
    for (int r = 0; r < SIZE; r++) {
        assert_true(good[r]);
    }
}

typedef struct agreement {
    bool agreed;
    clod_status status;
} agreement;

/** Ranks 2 and 3 have a failure each: the first of them counts. */
static void agree(clod_ranks *ranks, void *context)
{
    agreement *found = (agreement *)context + ranks->rank;
    const bool good = ranks->rank < 2 || ranks->rank > 3 ||
                      clod_status_fail(&found->status, CLOD_FAILED, "rank %d", ranks->rank);
    found->agreed = clod_ranks_agree(ranks, true, &found->status);
    found->agreed = found->agreed && !clod_ranks_agree(ranks, good, &found->status);
}

static void all_learn_of_the_first_failure(void **state)
{
    (void)state;
    agreement found[SIZE] = {0};
    ranks_run(SIZE, agree, found);
    for (int r = 0; r < SIZE; r++) {
        assert_true(found[r].agreed);
        assert_int_equal(found[r].status.code, CLOD_FAILED);
        assert_string_equal(found[r].status.text, "rank 2");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_are_merged_in_the_order_of_ranks),
        cmocka_unit_test(bytes_arrive_at_whom_they_are_for),
        cmocka_unit_test(all_learn_of_the_first_failure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
