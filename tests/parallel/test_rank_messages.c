// What ranks say to each other arrives, whole and in the order of ranks.
#include <math.h>
#include <string.h>

#include "parallel/ranks_collect.h"

#include "support/check.h"
#include "support/ranks_threads.h"

#define SIZE 5

#define MOST 19 ///< ranks of the tests of every number of them

/** Letters of some ranks, in order. */
typedef struct word {
    int64_t length;
    char letter[MOST];
} word;

static void append(const void *context, void *into, const void *from)
{
    (void)context;
    word *mine = into;
    const word *other = from;
    memcpy(mine->letter + mine->length, other->letter, (size_t)other->length);
    mine->length += other->length;
}

typedef struct spelled {
    word word[MOST];
    clod_ranks_count count[MOST];
} spelled;

static void spell(clod_ranks *ranks, void *context)
{
    spelled *found = context;
    word *mine = &found->word[ranks->rank];
    CLOD_ASSERT(clod_ranks_reserve(ranks, sizeof *mine, &(clod_status){0}));
    *mine = (word){1, {(char)('a' + ranks->rank)}};
    const clod_ranks_count before = ranks->count;
    clod_ranks_merge(ranks, mine, sizeof *mine, append, NULL);
    found->count[ranks->rank] = ranks->count;
    found->count[ranks->rank].merge_messages -= before.merge_messages;
    found->count[ranks->rank].merge_bytes -= before.merge_bytes;
    found->count[ranks->rank].merges -= before.merges;
}

static void merges_are_in_the_order_of_ranks(void **state)
{
    (void)state;
    for (int size = 1; size <= MOST; size++) {
        spelled found;
        ranks_run(size, spell, &found);
        for (int r = 0; r < size; r++) {
            assert_int_equal(found.word[r].length, size);
            for (int k = 0; k < size; k++) {
                assert_int_equal(found.word[r].letter[k], 'a' + k);
            }
        }
    }
}

/** log2 of the ranks, and one before or behind it where that is no whole number. */
static void messages_of_a_merge_grow_with_the_logarithm(void **state)
{
    (void)state;
    for (int size = 1; size <= MOST; size++) {
        spelled found;
        ranks_run(size, spell, &found);
        for (int r = 0; r < size; r++) {
            const clod_ranks_count *count = &found.count[r];
            const int64_t rounds = (int64_t)floor(log2(size));
            assert_int_equal(count->merges, 1);
            assert_true(count->merge_messages <= rounds + (1 << rounds < size ? 1 : 0));
            assert_int_equal(count->merge_bytes, count->merge_messages * (int64_t)sizeof(word));
        }
    }
}

typedef struct told {
    char text[MOST][8], all[MOST][MOST];
    int64_t messages[MOST];
} told;

static void tell(clod_ranks *ranks, void *context)
{
    told *found = context;
    const char mine = (char)('a' + ranks->rank);
    strcpy(found->text[ranks->rank], ranks->rank == 0 ? "hear me" : "nothing");
    clod_ranks_tell(ranks, found->text[ranks->rank], sizeof *found->text);
    found->messages[ranks->rank] = ranks->count.messages;
    clod_ranks_gather(ranks, &mine, 1, found->all[ranks->rank]);
}

static void what_rank_0_tells_all_hear(void **state)
{
    (void)state;
    for (int size = 1; size <= MOST; size++) {
        told found;
        int64_t messages = 0;
        ranks_run(size, tell, &found);
        for (int r = 0; r < size; r++) {
            assert_string_equal(found.text[r], "hear me");
            assert_true(found.messages[r] <= (int64_t)ceil(log2(size)));
            messages += found.messages[r];
            for (int k = 0; k < size; k++) {
                assert_int_equal(found.all[r][k], 'a' + k);
            }
        }
        assert_int_equal(messages, size - 1);
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

/** Each rank has as many letters for rank 0 as its number, and gets them back as capitals. */
static void collect_letters(clod_ranks *ranks, void *context)
{
    bool *good = context;
    clod_status status = {0};
    clod_bytes mine = {0}, all = {0};
    size_t begin[SIZE + 1] = {0};
    char back[SIZE] = {0};
    const size_t count = (size_t)ranks->rank;
    for (size_t k = 0; k < count; k++) {
        clod_bytes_put(&mine, &(char){(char)('a' + ranks->rank)}, 1);
    }
    bool same = clod_ranks_collect(ranks, &mine, &all, begin, &status);
    if (ranks->rank == 0) {
        same = same && all.count == 10 && memcmp(all.data, "bccdddeeee", 10) == 0;
        for (size_t k = 0; k < all.count; k++) {
            all.data[k] = (char)(all.data[k] - 'a' + 'A');
        }
    }
    clod_ranks_return(ranks, all.data, begin, back, count);
    for (size_t k = 0; k < SIZE; k++) {
        same = same && back[k] == (k < count ? (char)('A' + ranks->rank) : 0);
    }
    clod_bytes_fini(&mine);
    clod_bytes_fini(&all);
    good[ranks->rank] = same;
}

static void bytes_are_collected_and_come_back(void **state)
{
    (void)state;
    bool good[SIZE] = {false};
    ranks_run(SIZE, collect_letters, good);
    for (int r = 0; r < SIZE; r++) {
        assert_true(good[r]);
    }
}

/** Numbers of bytes in three rounds, by hand: of ranks 1 and 3, 2 and 3, and 4 places on. */
static void what_is_said_is_counted(void **state)
{
    (void)state;
    clod_ranks_count count[SIZE];
    ranks_run(SIZE, count_letters, count);
    for (int r = 0; r < SIZE; r++) {
        size_t messages = 3, bytes = 5 * sizeof(size_t);
        for (int to = 0; to < SIZE; to++) {
            messages += to != r && letters(r, to) > 0;
            bytes += to != r ? letters(r, to) : 0;
        }
        assert_int_equal(count[r].messages, messages);
        assert_int_equal(count[r].bytes, bytes);
        assert_int_equal(count[r].exchanges, 4);
        assert_int_equal(count[r].merges, 1); // whether all have memory
        assert_true(count[r].waited > 0.0 && count[r].waited < 100.0);
    }
}

typedef struct swapped {
    bool good[MOST];
    int64_t messages[MOST];
} swapped;

/** Every rank has 10 r + d + 1 bytes for the rank d places on, where d is a power of two. */
static size_t bytes_on(int from, int size, int to)
{
    const int d = (to - from + size) % size;
    return d > 0 && (d & (d - 1)) == 0 ? (size_t)(10 * from + d + 1) : 0;
}

static void swap_some(clod_ranks *ranks, void *context)
{
    swapped *found = context;
    const int size = ranks->size, me = ranks->rank;
    clod_status status = {0};
    clod_bytes out[MOST] = {0}, in = {0};
    size_t begin[MOST + 1];
    for (int r = 0; r < size; r++) {
        const char c = letter(me, r);
        for (size_t k = 0; k < bytes_on(me, size, r); k++) {
            clod_bytes_put(&out[r], &c, 1);
        }
    }
    bool good = clod_ranks_swap(ranks, out, &in, begin, &status);
    for (int r = 0; r < size; r++) {
        good = good && begin[r + 1] - begin[r] == bytes_on(r, size, me);
        for (size_t k = begin[r]; good && k < begin[r + 1]; k++) {
            good = in.data[k] == letter(r, me);
        }
        clod_bytes_fini(&out[r]);
    }
    clod_bytes_fini(&in);
    found->good[me] = good;
    found->messages[me] = ranks->count.messages;
}

/** A round for each bit of the number of ranks, and one to each rank that gets something. */
static void messages_of_a_swap_grow_with_the_logarithm(void **state)
{
    (void)state;
    for (int size = 1; size <= MOST; size++) {
        swapped found;
        ranks_run(size, swap_some, &found);
        const int64_t rounds = (int64_t)ceil(log2(size));
        for (int r = 0; r < size; r++) {
            assert_true(found.good[r]);
            assert_int_equal(found.messages[r], 2 * rounds); // as many neighbours
        }
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
            clod_ranks_start(ranks);
            CLOD_ASSERT(clod_ranks_agree(ranks, true, &status)); // others may come between
            clod_ranks_finish(ranks);
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
    const int good = SIZE; // the first rank on which something fails is none
    for (int k = 0; k < ins; k++) {
        if (in[k].bytes == sizeof good) {
            memcpy(in[k].data, &good, sizeof good);
        } else if (in[k].bytes < sizeof(clod_status)) { // not the text of the failure
            for (size_t at = 0; at < in[k].bytes; at += sizeof bytes) {
                memcpy((char *)in[k].data + at, &bytes, sizeof bytes);
            }
        }
    }
}

/** Where each rank's bytes begin, far beyond 2^31, and that there is no room for them. */
static void more_bytes_than_an_int_counts(void **state)
{
    (void)state;
    clod_ranks ranks = {.size = SIZE, .exchange = announce_much};
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
        cmocka_unit_test(merges_are_in_the_order_of_ranks),
        cmocka_unit_test(messages_of_a_merge_grow_with_the_logarithm),
        cmocka_unit_test(what_rank_0_tells_all_hear),
        cmocka_unit_test(messages_that_are_kept_are_repeated),
        cmocka_unit_test(bytes_arrive_at_whom_they_are_for),
        cmocka_unit_test(bytes_are_collected_and_come_back),
        cmocka_unit_test(what_is_said_is_counted),
        cmocka_unit_test(messages_of_a_swap_grow_with_the_logarithm),
        cmocka_unit_test(more_bytes_than_an_int_counts),
        cmocka_unit_test(all_learn_of_the_first_failure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
