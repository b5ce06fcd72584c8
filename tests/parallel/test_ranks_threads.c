// Ranks that are threads form groups and post words as those of MPI do (support/ranks_threads.h).
#include <sched.h>

#include "support/check.h"
#include "support/ranks_threads.h"

#define SIZE 5
#define MOST 19 ///< ranks of the tests of several numbers of them

/** Letters of all ranks of a group, as each of them hears them, and of all. */
typedef struct grouped {
    char part[MOST][MOST], all[MOST][MOST];
    int rank[MOST], size[MOST];
} grouped;

static void group(clod_ranks *ranks, void *context)
{
    grouped *found = context;
    clod_status status = {0};
    clod_ranks part;
    const int me = ranks->rank;
    const char mine = (char)('a' + me);
    CLOD_ASSERT(ranks->split(ranks, me % 2, &part, &status));
    found->rank[me] = part.rank;
    found->size[me] = part.size;
    for (int k = 0; k < 1 + me % 2; k++) { // odd ones say it twice
        clod_ranks_gather(&part, &mine, 1, found->part[me]);
    }
    clod_ranks_gather(ranks, &mine, 1, found->all[me]);
    part.part(&part);
}

/** Ranks of even and of odd numbers at their own pace, then all together. */
static void groups_talk_among_themselves(void **state)
{
    (void)state;
    for (int size = 1; size <= MOST; size += 3) {
        grouped found;
        ranks_run(size, group, &found);
        for (int r = 0; r < size; r++) {
            const int others = r % 2 == 0 ? (size + 1) / 2 : size / 2;
            assert_int_equal(found.rank[r], r / 2);
            assert_int_equal(found.size[r], others);
            for (int k = 0; k < others; k++) {
                assert_int_equal(found.part[r][k], 'a' + r % 2 + 2 * k);
            }
            for (int k = 0; k < size; k++) {
                assert_int_equal(found.all[r][k], 'a' + k);
            }
        }
    }
}

static int next_word(clod_ranks *ranks, int from)
{
    int found = -1;
    while (!ranks->look(ranks, from, &found)) {
        sched_yield();
    }
    return found;
}

/** Rank 0 posts 1, 2, 3 to each, who answer with their number; more than a ring holds in all. */
static void post_words(clod_ranks *ranks, void *context)
{
    int *wrong = context, left;
    for (int k = 0; k < 3 * RANKS_WORDS; k++) {
        for (int r = 1; ranks->rank == 0 && r < ranks->size; r++) {
            for (int w = 1; w <= 3; w++) {
                ranks->post(ranks, r, w);
            }
        }
        for (int w = 1; ranks->rank > 0 && w <= 3; w++) {
            wrong[ranks->rank] += next_word(ranks, 0) != w;
        }
        if (ranks->rank > 0) {
            ranks->post(ranks, 0, ranks->rank);
        }
        for (int r = ranks->size - 1; ranks->rank == 0 && r > 0; r--) {
            wrong[0] += next_word(ranks, r) != r;
        }
    }
    CLOD_ASSERT(clod_ranks_agree(ranks, true, &(clod_status){0})); // all have said all
    for (int r = 0; r < ranks->size; r++) {
        wrong[ranks->rank] += ranks->look(ranks, r, &left); // none is left
    }
}

static void words_come_in_their_order(void **state)
{
    (void)state;
    int wrong[SIZE] = {0};
    ranks_run(SIZE, post_words, wrong);
    for (int r = 0; r < SIZE; r++) {
        assert_int_equal(wrong[r], 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_talk_among_themselves),
        cmocka_unit_test(words_come_in_their_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
