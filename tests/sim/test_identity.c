// What makes a run the same run: text against text, both written by hand.

#include <glob.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "base/memory.h"
#include "config/testers.h"
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

/** Groups of ranks read the complete case (sim/group.h): it is a case with that complete text. */
static void a_complete_case_is_complete(void **state)
{
    (void)state;
    static const char *const PATTERNS[] = {"cases/*/case.yaml",
                                           "cases/calibrate-kadh/ring.yaml", "tests/cli/*.yaml",
                                           "tests/restart/ring.yaml", "tests/parallel/*.yaml"};
    size_t read = 0;
    for (size_t k = 0; k < sizeof PATTERNS / sizeof *PATTERNS; k++) {
        glob_t found;
        char pattern[512];
        snprintf(pattern, sizeof pattern, "%s/%s", CLOD_SOURCE_DIR, PATTERNS[k]);
        assert_int_equal(glob(pattern, 0, NULL, &found), 0);
        for (size_t f = 0; f < found.gl_pathc; f++) {
            clod_status status;
            clod_case *first = clod_case_load(found.gl_pathv[f], NULL, 0, &status);
            if (first == NULL || clod_case_tester(first) == NULL) { // it has no parts
                clod_case_destroy(&first);
                continue;
            }
            char *complete = clod_identity_complete(first, &status);
            if (complete == NULL) {
                fail_msg("%s", status.text);
            }
            clod_case *second = clod_case_parse(found.gl_pathv[f], complete, strlen(complete),
                                                NULL, 0, &status);
            if (second == NULL) {
                fail_msg("%s", status.text);
            }
            char *again = clod_identity_complete(second, &status);
            assert_string_equal(again, complete);
            clod_memory_free(again);
            clod_memory_free(complete);
            clod_case_destroy(&first);
            clod_case_destroy(&second);
            read++;
        }
        globfree(&found);
    }
    assert_true(read >= 10);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(keys_of_output_that_change_no_bit_are_left_out),
        cmocka_unit_test(the_grain_file_that_differs_is_named),
        cmocka_unit_test(a_complete_case_is_complete),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
