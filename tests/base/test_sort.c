// The radix sort against the C library's sort, with stability.

#include <stdlib.h>
#include <string.h>

#include "base/sort.h"
#include "support/check.h"
#include "support/dice.h"
#include "support/sort_reference.h"

static void check_sort(size_t count, uint64_t mask, uint64_t seed)
{
    dice roll = {seed};
    clod_sort_item *found = calloc(count + 1, sizeof *found);
    clod_sort_item *expected = calloc(count + 1, sizeof *expected);
    clod_sort_item *scratch = calloc(count + 1, sizeof *scratch);
    for (size_t k = 0; k < count; k++) {
        found[k] = expected[k] = (clod_sort_item){dice_bits(&roll) & mask, k};
    }
    found[count] = scratch[count] = (clod_sort_item){77, 78}; // not to be touched
    qsort(expected, count, sizeof *expected, sort_compare);
    clod_sort(found, scratch, count);
    assert_memory_equal(found, expected, count * sizeof *found);
    assert_true(found[count].key == 77 && found[count].index == 78);
    assert_true(scratch[count].key == 77 && scratch[count].index == 78);
    free(found);
    free(expected);
    free(scratch);
}

static void random_keys_come_out_as_qsort_has_them(void **state)
{
    (void)state;
    const uint64_t masks[] = {UINT64_MAX,     0xff,       0x3,
                              0xff00000000ff, 1ull << 63, 0xffffffff00000000};
    for (int m = 0; m < 6; m++) {
        check_sort(0, masks[m], 1);
        check_sort(1, masks[m], 2);
        check_sort(2, masks[m], 3);
        check_sort(255, masks[m], 4);
        check_sort(20000, masks[m], 5);
    }
}

static void equal_keys_keep_their_order(void **state)
{
    (void)state;
    check_sort(5000, 0, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_keys_come_out_as_qsort_has_them),
        cmocka_unit_test(equal_keys_keep_their_order),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
