// Which ranks share a host, and how many processors they have there.
#include "parallel/rank_places.h"

#include <string.h>
#include <unistd.h>

#include "parallel/ranks.h"
#include "parallel/threads.h"
#include "support/check.h"

/** Ranks 0, 1 and 3 on one host with processors 0, 0, and 5 and 70; rank 2 on another with two. */
static const clod_rank_place PLACE[] = {{.host = "a", .processor = {1}},
                                        {.host = "a", .processor = {1}},
                                        {.host = "b", .processor = {3}},
                                        {.host = "a", .processor = {1 << 5, 1 << 6}}};

static void ranks_are_counted_by_host(void **state)
{
    (void)state;
    clod_rank_host host;
    assert_true(clod_rank_places_host(PLACE, 4, 0, &host));
    assert_string_equal(host.name, "a");
    assert_int_equal(host.ranks, 3);
    assert_int_equal(host.processors, 3);
    assert_false(clod_rank_places_host(PLACE, 4, 1, &host));
    assert_false(clod_rank_places_host(PLACE, 4, 3, &host));
    assert_true(clod_rank_places_host(PLACE, 4, 2, &host));
    assert_int_equal(host.ranks, 1);
    assert_int_equal(host.processors, 2);
}

static int crowd(const clod_rank_place *place, int ranks, int threads, int *processors)
{
    clod_rank_host host;
    assert_true(clod_rank_places_host(place, ranks, 0, &host));
    const bool any = clod_rank_places_crowded(place, ranks, 0, threads, &host);
    *processors = host.processors;
    return any ? host.ranks : 0;
}

/** Hosts with enough processors for all ranks, of which some ranks may use too few. */
static void ranks_that_share_some_processors_are_found(void **state)
{
    (void)state;
    int processors;
    static const clod_rank_place TWO_ON_ONE[] = {{.host = "a", .processor = {0xe}},
                                                 {.host = "b", .processor = {1}},
                                                 {.host = "a", .processor = {1}},
                                                 {.host = "a", .processor = {1}}};
    assert_int_equal(crowd(TWO_ON_ONE, 4, 1, &processors), 2);
    assert_int_equal(processors, 1);
    assert_int_equal(crowd(TWO_ON_ONE, 3, 1, &processors), 0); // one on 0, one on 1 to 3
    assert_int_equal(crowd(TWO_ON_ONE, 3, 2, &processors), 1); // that on 0 has two threads
    static const clod_rank_place NESTED[] = {{.host = "a", .processor = {0xf}},
                                             {.host = "a", .processor = {3}},
                                             {.host = "a", .processor = {1}},
                                             {.host = "a", .processor = {2}}};
    assert_int_equal(crowd(NESTED, 4, 1, &processors), 3); // all but the first on 0 and 1
    assert_int_equal(processors, 2);
    assert_int_equal(crowd(NESTED, 2, 2, &processors), 0);
    assert_int_equal(crowd(NESTED, 4, 2, &processors), 4);
    assert_int_equal(processors, 4);
    static const clod_rank_place UNKNOWN[] = {{.host = "a"}, {.host = "a"}};
    assert_int_equal(crowd(UNKNOWN, 2, 1, &processors), 0);
}

/** Ranks that can only be where one of them is, by counting the sets above. */
static void ranks_with_no_other_processors_are_counted(void **state)
{
    (void)state;
    for (int r = 0; r < 4; r++) {
        assert_int_equal(clod_rank_places_beside(PLACE, 4, r), r < 2 ? 2 : 1);
    }
    static const clod_rank_place NESTED[] = {{.host = "a", .processor = {0xf}},
                                             {.host = "a", .processor = {3}},
                                             {.host = "a", .processor = {1}},
                                             {.host = "b", .processor = {3}}};
    static const int BESIDE[] = {3, 2, 1, 1};
    for (int r = 0; r < 4; r++) {
        assert_int_equal(clod_rank_places_beside(NESTED, 4, r), BESIDE[r]);
    }
    const clod_ranks unknown = {.rank = 1, .size = 5};
    const clod_ranks known = {.rank = 1, .size = 4, .place = (clod_rank_place *)NESTED};
    assert_int_equal(clod_ranks_beside(&unknown), 5);
    assert_int_equal(clod_ranks_beside(&known), 2);
}

/** As taskset and the kernel's Cpus_allowed_list write them. */
static void processors_are_listed(void **state)
{
    (void)state;
    char list[CLOD_PLACE_LIST];
    static const struct {
        clod_rank_place place;
        const char *list;
    } CASE[] = {
        {{.host = "a"}, ""},
        {{.processor = {1}}, "0"},
        {{.processor = {0x10f}}, "0-3,8"},
        {{.processor = {UINT64_C(3) << 62, 3}}, "62-65"},
        {{.processor = {0x15, [15] = UINT64_C(3) << 62}}, "0,2,4,1022-1023"},
    };
    for (size_t k = 0; k < sizeof CASE / sizeof *CASE; k++) {
        clod_rank_place_list(&CASE[k].place, list);
        assert_string_equal(list, CASE[k].list);
    }
    clod_rank_place odd;
    memset(&odd, 0xaa, sizeof odd); // every second one: the longest list
    clod_rank_place_list(&odd, list);
    assert_string_equal(list + strlen(list) - 10, ",1021,1023");
}

/** A kernel of more processors than the mask has says none of them. */
static void processors_of_one_rank_that_are_not_known_are_not_counted(void **state)
{
    (void)state;
    static const clod_rank_place SOME[] = {{.host = "a", .processor = {3}}, {.host = "a"}};
    clod_rank_host host;
    assert_true(clod_rank_places_host(SOME, 2, 0, &host));
    assert_int_equal(host.ranks, 2);
    assert_int_equal(host.processors, 0);
}

/** Names of 64 letters, the longest that Linux knows, which differ in the last. */
static void long_names_are_told_apart(void **state)
{
    (void)state;
    clod_rank_place place[2] = {0};
    for (int r = 0; r < 2; r++) {
        memset(place[r].host, 'n', 64);
        place[r].host[63] = (char)('0' + r);
    }
    clod_rank_host host;
    assert_true(clod_rank_places_host(place, 2, 0, &host));
    assert_int_equal(host.ranks, 1);
    assert_int_equal(strlen(host.name), 64);
    assert_true(clod_rank_places_host(place, 2, 1, &host));
}

static void this_process_has_a_host_and_processors(void **state)
{
    (void)state;
    char name[64] = "";
    const clod_rank_place here = clod_rank_place_here();
    assert_int_equal(gethostname(name, sizeof name - 1), 0);
    assert_string_equal(here.host, name);
    assert_int_equal(clod_rank_place_processors(&here), clod_threads_available());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranks_are_counted_by_host),
        cmocka_unit_test(ranks_that_share_some_processors_are_found),
        cmocka_unit_test(ranks_with_no_other_processors_are_counted),
        cmocka_unit_test(processors_are_listed),
        cmocka_unit_test(processors_of_one_rank_that_are_not_known_are_not_counted),
        cmocka_unit_test(long_names_are_told_apart),
        cmocka_unit_test(this_process_has_a_host_and_processors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
