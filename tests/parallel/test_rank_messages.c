// What ranks say to each other arrives, whole and in the order of ranks.
#include "support/check.h"
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

static void count_letters(clod_ranks *ranks, void *context)
{
    clod_ranks_count *count = context;
    bool good[SIZE];
    swap_letters(ranks, good);
    count[ranks->rank] = ranks->count;
}

static void what_is_said_is_counted(void **state)
{
    (void)state;
    clod_ranks_count count[SIZE];
    ranks_run(SIZE, count_letters, count);
    for (int r = 0; r < SIZE; r++) {
        size_t messages = SIZE - 1, bytes = (SIZE - 1) * sizeof(size_t); // how many, first
        for (int to = 0; to < SIZE; to++) {
            messages += to != r && letters(r, to) > 0;
            bytes += to != r ? letters(r, to) : 0;
        }
        assert_int_equal(count[r].messages, messages);
        assert_int_equal(count[r].bytes, bytes);
        assert_int_equal(count[r].exchanges, 2);
        assert_int_equal(count[r].shares, 1); // whether all have memory
        assert_int_equal(count[r].share_bytes, 1);
        assert_true(count[r].waited > 0.0 && count[r].waited < 100.0);
    }
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

/** Rounds of messages around the ranks that are kept once; then others the other way. */
static void repeat_rounds(clod_ranks *ranks, void *context)
{
    clod_ranks_count *count = context;
    clod_status status = {0};
    int64_t sent = 0, got = -1;
    for (int way = 1; way < SIZE; way += SIZE - 2) {
        const int from = (ranks->rank + SIZE - way) % SIZE;
        const clod_message out = {(ranks->rank + way) % SIZE, &sent, sizeof sent};
        const clod_message in = {from, &got, sizeof got};
        CLOD_ASSERT(clod_ranks_keep(ranks, &out, 1, &in, 1, &status));
        for (int k = 0; k < 3; k++) {
            sent = 10 * k + ranks->rank; // what is in their places then
            clod_ranks_repeat(ranks);
            CLOD_ASSERT(got == 10 * k + from);
        }
    }
    count[ranks->rank] = ranks->count;
}

static void messages_that_are_kept_are_repeated(void **state)
{
    (void)state;
    clod_ranks_count count[SIZE];
    ranks_run(SIZE, repeat_rounds, count);
    for (int r = 0; r < SIZE; r++) {
        assert_int_equal(count[r].exchanges, 6);
        assert_int_equal(count[r].messages, 6);
        assert_int_equal(count[r].bytes, 6 * sizeof(int64_t));
    }
}

/** As if every other rank had so many bytes for this one: more together than any address. */
#define ENORMOUS ((size_t)5 << 45)

static void announce_much(clod_ranks *self, const clod_message *out, int outs,
                          const clod_message *in, int ins)
{
    (void)self;
    (void)out;
    (void)outs;
    const size_t bytes = ENORMOUS;
    for (int k = 0; k < ins; k++) {
        if (in[k].bytes == sizeof bytes) { // not the text of the failure
            memcpy(in[k].data, &bytes, sizeof bytes);
        }
    }
}

static void share_alone(clod_ranks *self, const void *mine, size_t bytes, void *all)
{
    for (int r = 0; r < self->size; r++) {
        memcpy((char *)all + (size_t)r * bytes, mine, bytes);
    }
}

/** Where each rank's bytes begin, far beyond 2^31, and that there is no room for them. */
static void more_bytes_than_an_int_counts(void **state)
{
    (void)state;
    clod_ranks ranks = {.size = SIZE, .share = share_alone, .exchange = announce_much};
    clod_status status = {0};
    clod_bytes out[SIZE] = {0}, in = {0};
    size_t begin[SIZE + 1];
    assert_true(clod_ranks_init(&ranks, &status));
    assert_false(clod_ranks_swap(&ranks, out, &in, begin, &status));
    assert_non_null(strstr(status.text, "no memory for 703687441776640 bytes")); // 4 x 5 x 2^45
    assert_true(begin[1] == 0 && begin[2] == ENORMOUS && begin[SIZE] == 4 * ENORMOUS);
    clod_bytes_fini(&in);
    clod_ranks_fini(&ranks);
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
        cmocka_unit_test(messages_that_are_kept_are_repeated),
        cmocka_unit_test(bytes_arrive_at_whom_they_are_for),
        cmocka_unit_test(what_is_said_is_counted),
        cmocka_unit_test(more_bytes_than_an_int_counts),
        cmocka_unit_test(all_learn_of_the_first_failure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
