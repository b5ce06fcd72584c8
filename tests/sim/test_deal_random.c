// Grains at random positions that several ranks get: the bed of one process, bit by bit, no rank has a
// list of their places, and one that lacks memory is an error of all.
#include "dealt_bed.h"

// ---- beds

/** Grains of very different sizes among others, so dense that many places are tried for the last of them. */
static const char CROWD[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm], periodic: [true, true, false]}\n"
    "grains:\n"
    "  - material: ore\n    count: 500\n    radius: {distribution: uniform, min: 0.6 mm, max: 0.7 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 1 mm], max: [20 mm, 20 mm, 9 mm]}}\n"
    "  - material: sand\n    count: 1100\n    radius: {distribution: uniform, min: 0.3 mm, max: 1.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 4 mm], max: [20 mm, 20 mm, 30 mm]}}\n" FLOOR STAGES;

/** Grains of one size. */
static const char EQUAL[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm]}\n"
    "grains:\n"
    "  - material: ore\n    count: 1000\n    radius: {distribution: uniform, min: 0.7 mm, max: 0.7 mm}\n"
    "    region: {annulus: {center: [10 mm, 10 mm, 1 mm], inner_radius: 0 mm, outer_radius: 9 mm, height: 22 mm}}\n" FLOOR
        STAGES;

/** A third of the region at random would do, but a wall takes a part of it: the last grain finds none of
 *  its 4000 places free, and all are put in layers. */
static const char HIDDEN[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm]}\n"
    "grains:\n"
    "  - material: ore\n    count: 610\n    radius: {distribution: uniform, min: 0.99 mm, max: 1 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, -4 mm], max: [20 mm, 20 mm, 16 mm]}}\n" FLOOR STAGES;

/** So many at random places that a list of them is seen. */
static const char LOOSE[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, 0 mm], max: [100 mm, 100 mm, 300 mm], periodic: [true, true, true]}\n"
    "grains:\n"
    "  - material: ore\n    count: 240000\n    radius: {distribution: uniform, min: 0.7 mm, max: 0.8 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [100 mm, 100 mm, 300 mm]}}\n" STAGES;

// ---- tests

static void a_crowd_at_random_places_has_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(CROWD, 100);
}

static void grains_of_one_size_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(EQUAL, 100);
}

static void grains_that_find_no_random_place_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(HIDDEN, 100);
}

// Rows of its share and of a piece; 120 bytes of places, cells and sizes for each grain of its share; and less
// than half of a place, 32 bytes, for each of all grains: a list of them would be seen.
static void no_rank_has_a_list_of_all_random_places(void **state)
{
    (void)state;
    const int64_t grains = 240000;
    if (sanitized()) {
        skip(); // it counts bytes
    }
    const byte_counts found = count_bytes(LOOSE, (size_t)grains);
    assert_true(found.made < ROW_BYTES * (grains / LIST_RANKS + LIST_PIECE) +
                                 120 * grains / LIST_RANKS + 16 * grains);
}

// ---- a rank without memory

/** Few grains at random positions among others. */
static const char SOME[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm], periodic: [true, true, false]}\n"
    "grains:\n"
    "  - material: ore\n    count: 20\n    radius: {distribution: uniform, min: 0.9 mm, max: 1 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 1 mm], max: [20 mm, 20 mm, 20 mm]}}\n"
    "  - material: sand\n    count: 40\n    radius: {distribution: uniform, min: 0.6 mm, max: 1.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 4 mm], max: [20 mm, 20 mm, 20 mm]}}\n" FLOOR STAGES;

/** One rank lacks memory once, after some that it got. */
typedef struct poor_rank {
    const clod_case *from;
    int rank, granted;
    bool refused; ///< it came to that
} poor_rank;

static void make_in_need(clod_ranks *ranks, void *context)
{
    poor_rank *how = context;
    const bool poor = ranks->rank == how->rank;
    asks = poor ? how->granted : -1;
    refused = false;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
    } else {
        clod_status status = {0};
        made_bed made = {0};
        dealt_bed bed = {.from = how->from, .piece = 16, .into = &made};
        const bool good = give(&bed, ranks, &status);
        if (!good) { // all know of it, and the next one is made
            assert_int_equal(status.code, CLOD_FAILED);
            assert_non_null(strstr(status.text, "memory"));
            clod_state_fini(&made.state);
            asks = -1;
            status = (clod_status){0};
            assert_true(give(&bed, ranks, &status));
        }
        clod_state_fini(&made.state);
        clod_crew_dismiss(ranks);
        assert_true(good || poor || how->rank > 0);
    }
    if (poor) {
        how->refused = refused;
    }
    asks = -1;
}

static void a_rank_without_memory_is_an_error_of_all(void **state)
{
    (void)state;
    clod_case *from = case_of(SOME, NULL);
    for (int rank = 0; rank < 3; rank++) {
        poor_rank how = {.from = from, .rank = rank, .refused = true};
        for (; how.refused; how.granted += sanitized() ? 5 : 1) {
            how.refused = false;
            ranks_run(3, make_in_need, &how);
        }
        assert_true(how.granted > 40);
    }
    clod_case_destroy(&from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_crowd_at_random_places_has_the_bits_of_one_process),
        cmocka_unit_test(grains_of_one_size_have_the_bits_of_one_process),
        cmocka_unit_test(grains_that_find_no_random_place_have_the_bits_of_one_process),
        cmocka_unit_test(no_rank_has_a_list_of_all_random_places),
        cmocka_unit_test(a_rank_without_memory_is_an_error_of_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
