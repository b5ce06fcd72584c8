// What makes a run the same run: text against text, both written by hand.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "sim/identity.h"

#define HEAD "# The complete case\ntitle: \"a\"\nstages:\n  - name: \"output:\"\n"
#define LAST "# grains[1].file has 3 bytes with the hash 0000000000000001\n"

static void expect(const char *complete, const char *identity)
{
    char *text = clod_identity_text(complete);
    assert_non_null(text);
    assert_string_equal(text, identity);
    clod_memory_free(text);
}

static void keys_of_output_that_change_no_bit_are_left_out(void **state)
{
    (void)state;
    expect(HEAD "output:\n  series_interval: 0.001 s\n  snapshot_interval: 0.02 s\n"
                "  checkpoint_interval: 300 s\n  contacts: true\n" LAST,
           HEAD "output:\n  series_interval: 0.001 s\n" LAST);
    expect(HEAD "output:\n  snapshot_interval: 0.02 s\n  contacts: true\n", HEAD "output:\n");
    expect(HEAD LAST, HEAD LAST);
    expect("no newline", "no newline");
    expect("", "");
}

static void the_grain_file_that_differs_is_named(void **state)
{
    (void)state;
    char first[] = "first.csv", second[] = "second.csv";
    clod_case_grains grains[2] = {{.file = first}, {.file = second}};
    const clod_case from = {.grains = grains, .grains_count = 2};
    static const char BEFORE[] =
        HEAD "output:\n  contacts: true\n"
             "# grains[0].file has 7 bytes with the hash 00000000000000ff\n" LAST;
    // one has other bytes, the second another length, a third differs in the case as well
    assert_ptr_equal(clod_identity_changed_file(
                         &from, BEFORE,
                         HEAD
                         "output:\n  contacts: false\n"
                         "# grains[0].file has 7 bytes with the hash 00000000000000fe\n" LAST),
                     first);
    assert_ptr_equal(clod_identity_changed_file(
                         &from, BEFORE,
                         HEAD "output:\n  contacts: true\n"
                              "# grains[0].file has 7 bytes with the hash 00000000000000ff\n"
                              "# grains[1].file has 4 bytes with the hash 0000000000000001\n"),
                     second);
    assert_null(clod_identity_changed_file(
        &from, BEFORE,
        "seed: 4\noutput:\n"
        "# grains[0].file has 7 bytes with the hash 00000000000000fe\n" LAST));
    assert_null(clod_identity_changed_file(&from, BEFORE, BEFORE));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_of_output_that_change_no_bit_are_left_out),
        cmocka_unit_test(the_grain_file_that_differs_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
