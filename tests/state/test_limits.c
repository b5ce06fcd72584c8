/**
 * What is beyond the 32-bit numbers of rows, pairs and contacts is refused by name, before any
 * memory is asked for; no such bed is made here, only its numbers.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "setup/insertion.h"
#include "state/grains.h"
#include "state/limits.h"
#include "step/cells.h"
#include "step/neighbour.h"

/** Half rows 2 i and 2 i + 1 of the last row, which is padding, are int32. */
static void limits_fit_into_32_bits(void **state)
{
    (void)state;
    const int64_t last_row = (int64_t)CLOD_LIMITS_GRAINS + 2 - 1;
    assert_true(2 * last_row + 1 <= INT32_MAX);
    assert_true(2 * (last_row + 1) + 1 > INT32_MAX); // the limit is no lower than it must be
    assert_true(CLOD_LIMITS_PAIRS <= UINT32_MAX);
    assert_true(CLOD_LIMITS_WALL_PAIRS + (1 << 29) < INT32_MAX); // lanes of padding
    assert_true(CLOD_LIMITS_CONTACTS <= INT32_MAX);
}

static void check_limit(bool (*limit)(size_t count, clod_status *status), size_t most,
                        const char *what)
{
    clod_status status = {CLOD_OK, ""};
    assert_true(limit(0, &status));
    assert_true(limit(most, &status));
    assert_int_equal(status.code, CLOD_OK);
    assert_false(limit(most + 1, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, what));
    assert_null(strstr(status.text, "memory"));
    assert_false(limit(SIZE_MAX, &status));
}

static void each_limit_is_named(void **state)
{
    (void)state;
    check_limit(clod_limits_grains, CLOD_LIMITS_GRAINS, "1073741823 grains");
    check_limit(clod_limits_pairs, CLOD_LIMITS_PAIRS, "4294967296 pairs of grains");
    check_limit(clod_limits_wall_pairs, CLOD_LIMITS_WALL_PAIRS, "1073741825 pairs of a grain");
    check_limit(clod_limits_contacts, CLOD_LIMITS_CONTACTS, "2147483648 contacts");
}

/** The number of a cell is int32, from 2^28 grains on too: 8 cells for each would not fit. */
static void cells_are_counted(void **state)
{
    (void)state;
    assert_true(clod_cells_most(1000) == 8064.0); // coarser only where grains are scattered
    assert_true(clod_cells_most((size_t)1 << 28) < (double)INT32_MAX);
    assert_true(clod_cells_most(CLOD_LIMITS_GRAINS) < (double)INT32_MAX);
}

static void nothing_is_allocated_for_too_many(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    clod_grains grains = {0};
    const uint64_t before = clod_memory_count();
    assert_false(clod_grains_reserve(&grains, CLOD_LIMITS_GRAINS + 1, &status));
    assert_non_null(strstr(status.text, "1073741823 grains are too many"));
    clod_state bed = {.grains.count = 3};
    const clod_insertion what = {.count = CLOD_LIMITS_GRAINS - 2};
    assert_false(clod_insert_region(&bed, &what, &status));
    assert_non_null(strstr(status.text, "1073741823 grains are too many"));
    assert_int_equal(clod_memory_count(), before);
    assert_null(grains.position);
}

/** A list that is full says so, not that memory is short. */
static void a_full_list_is_no_lack_of_memory(void **state)
{
    (void)state;
    clod_status status = {CLOD_OK, ""};
    clod_neighbour neighbour = {
        .pairs = {.count = CLOD_LIMITS_PAIRS, .capacity = CLOD_LIMITS_PAIRS}};
    assert_false(clod_neighbour_add(&neighbour.pairs, 1));
    assert_false(clod_neighbour_fail_to_add(&neighbour, 5, &status));
    assert_non_null(strstr(status.text, "pairs of grains near each other are too many"));
    neighbour.pairs.count = 7;
    neighbour.walls.count = CLOD_LIMITS_WALL_PAIRS;
    assert_false(clod_neighbour_fail_to_add(&neighbour, 5, &status));
    assert_non_null(strstr(status.text, "pairs of a grain near a wall are too many"));
    neighbour.walls.count = 7;
    assert_false(clod_neighbour_fail_to_add(&neighbour, 5, &status));
    assert_non_null(strstr(status.text, "no memory"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limits_fit_into_32_bits),
        cmocka_unit_test(each_limit_is_named),
        cmocka_unit_test(cells_are_counted),
        cmocka_unit_test(nothing_is_allocated_for_too_many),
        cmocka_unit_test(a_full_list_is_no_lack_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
