// Heap memory: zeroed, aligned, counted, and NULL where there is none.

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "base/memory.h"
#include "support/check.h"

static void memory_is_zero_and_aligned(void **state)
{
    (void)state;
    for (size_t size = 0; size < 300; size++) {
        unsigned char *memory = clod_memory_alloc(size, 3);
        assert_non_null(memory);
        assert_int_equal((uintptr_t)memory % CLOD_MEMORY_ALIGNMENT, 0);
        for (size_t k = 0; k < 3 * size; k++) {
            assert_int_equal(memory[k], 0);
        }
        memset(memory, 0xff, 3 * size); // so that the next one gets used memory
        clod_memory_free(memory);
    }
    clod_memory_free(NULL);
}

/** From 2 MiB on an array begins at a huge page of 2 MiB, and is zero to its end. */
static void large_memory_begins_at_a_huge_page(void **state)
{
    (void)state;
    for (size_t size = 2097152; size < 2097152 + 3; size++) {
        unsigned char *memory = clod_memory_alloc(size, 1);
        assert_non_null(memory);
        assert_int_equal((uintptr_t)memory % 2097152, 0);
        for (size_t k = 0; k < size; k++) {
            assert_true(memory[k] == 0);
        }
        memset(memory, 0xff, size);
        clod_memory_free(memory);
    }
}

#if defined(__linux__)
/** Memory of this process in pages that are there. */
static int64_t pages_here(void)
{
    long all = 0, here = 0;
    FILE *file = fopen("/proc/self/statm", "r");
    assert_non_null(file);
    assert_int_equal(fscanf(file, "%ld %ld", &all, &here), 2);
    fclose(file);
    return here;
}

/** 256 MiB of which 16 are written: the rest is not taken from the system. */
static void large_memory_is_taken_as_it_is_used(void **state)
{
    (void)state;
    const size_t size = 268435456, used = 16777216, page = 4096;
    const int64_t before = pages_here();
    unsigned char *memory = clod_memory_alloc(size, 1);
    assert_non_null(memory);
    memset(memory, 1, used);
    const int64_t taken = pages_here() - before;
    assert_in_range(taken, used / page, (used + size / 4) / page);
    clod_memory_free(memory);
}

/** Pages of an array that are there. */
static size_t pages_of(unsigned char *memory, size_t size)
{
    static unsigned char here[16384];
    unsigned char *first = memory - (uintptr_t)memory % 4096;
    size_t count = 0;
    assert_true(size / 4096 <= sizeof here);
    assert_int_equal(mincore(first, size, here), 0);
    for (size_t p = 0; p < size / 4096; p++) {
        count += here[p] & 1;
    }
    return count;
}

/** What is given back is there no more, comes again as zeros, and its neighbours stay. */
static void large_memory_is_given_back(void **state)
{
    (void)state;
    const size_t sizes[] = {67108864, 1572864}, page[] = {2097152, 4096};
    for (int k = 0; k < 2; k++) {
        const size_t size = sizes[k], begin = size / 4 + 1, bytes = size / 2;
        unsigned char *memory = clod_memory_alloc(size, 1);
        assert_non_null(memory);
        memset(memory, 7, size);
        assert_int_equal(pages_of(memory, size), size / 4096);
        clod_memory_give_back(memory + begin, bytes, size);
        const size_t gone = size / 4096 - pages_of(memory, size);
        assert_in_range(gone, (bytes - 2 * page[k]) / 4096, bytes / 4096);
        size_t zeros = 0;
        for (size_t b = 0; b < size; b++) {
            assert_true(memory[b] == 7 || (b >= begin && b < begin + bytes));
            zeros += memory[b] == 0;
        }
        assert_true(zeros > bytes - 2 * page[k]);
        clod_memory_free(memory);
    }
}

/** The whole of an array is given back, its end in small pages too. */
static void a_whole_array_is_given_back(void **state)
{
    (void)state;
    const size_t size = 7340032; // three huge pages and a half
    unsigned char *memory = clod_memory_alloc(size, 1);
    assert_non_null(memory);
    memset(memory, 7, size);
    assert_int_equal(pages_of(memory, size), size / 4096);
    clod_memory_give_back(memory, size, size);
    assert_int_equal(pages_of(memory, size), 0);
    for (size_t b = 0; b < size; b++) {
        assert_true(memory[b] == 0);
    }
    clod_memory_free(memory);
}

/** Arrays below 1 MiB stay as they are. */
static void small_memory_is_kept(void **state)
{
    (void)state;
    const size_t size = 1048575;
    unsigned char *memory = clod_memory_alloc(size, 1);
    assert_non_null(memory);
    memset(memory, 7, size);
    clod_memory_give_back(memory, size, size);
    for (size_t b = 0; b < size; b++) {
        assert_true(memory[b] == 7);
    }
    clod_memory_free(memory);
}
#endif

static void growing_keeps_the_old_and_zeroes_the_new(void **state)
{
    (void)state;
    int *items = clod_memory_grow(NULL, 0, 10, sizeof *items);
    assert_non_null(items);
    for (int k = 0; k < 10; k++) {
        assert_int_equal(items[k], 0);
        items[k] = k + 1;
    }
    items = clod_memory_grow(items, 10, 1000, sizeof *items);
    assert_non_null(items);
    for (int k = 0; k < 1000; k++) {
        assert_int_equal(items[k], k < 10 ? k + 1 : 0);
    }
    clod_memory_free(items);
}

static void sizes_beyond_all_memory_give_null(void **state)
{
    (void)state;
    int item = 5;
    assert_null(clod_memory_alloc(SIZE_MAX, 2));
    assert_null(clod_memory_alloc(SIZE_MAX / 8 + 1, 8));
    assert_null(clod_memory_alloc(2, SIZE_MAX));
    assert_null(clod_memory_alloc(SIZE_MAX, 1));
    assert_null(clod_memory_grow(&item, 1, SIZE_MAX, 8)); // the old memory is kept
    assert_int_equal(item, 5);
}

static void texts_are_copied(void **state)
{
    (void)state;
    char text[] = "copper ore";
    char *copy = clod_memory_text(text);
    text[0] = 'k';
    assert_string_equal(copy, "copper ore");
    clod_memory_free(copy);
    copy = clod_memory_text("");
    assert_string_equal(copy, "");
    clod_memory_free(copy);
    assert_null(clod_memory_text(NULL));
}

static void allocations_are_counted(void **state)
{
    (void)state;
    const uint64_t before = clod_memory_count();
    void *a = clod_memory_alloc(1, 1);
    void *b = clod_memory_grow(a, 1, 2, 1);
    char *c = clod_memory_text("x");
    assert_int_equal(clod_memory_count() - before, 3);
    clod_memory_free(b);
    clod_memory_free(c);
    assert_int_equal(clod_memory_count() - before, 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(memory_is_zero_and_aligned),
        cmocka_unit_test(large_memory_begins_at_a_huge_page),
#if defined(__linux__)
        cmocka_unit_test(large_memory_is_taken_as_it_is_used),
        cmocka_unit_test(large_memory_is_given_back),
        cmocka_unit_test(a_whole_array_is_given_back),
        cmocka_unit_test(small_memory_is_kept),
#endif
        cmocka_unit_test(growing_keeps_the_old_and_zeroes_the_new),
        cmocka_unit_test(sizes_beyond_all_memory_give_null),
        cmocka_unit_test(texts_are_copied),
        cmocka_unit_test(allocations_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
