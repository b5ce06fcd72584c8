/**
 * Wrong case files and the exact message for each: wrong/NAME.yaml, its message in NAME.txt,
 * and overrides, one a line, in NAME.set when there are any. The messages were read one by one
 * by a person when they were added: true, at the right line and column, and saying what to do.
 * <laws> stands for a list of laws, which tests/law/test_law_kinds.c has.
 */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "clod/case.h"

#define FOLDER CLOD_SOURCE_DIR "/tests/config/wrong/"
#define FEWEST 40
#define SIZE 65536
#define MOST_OVERRIDES 8

/** Read FOLDER/name.ending; false when there is no such file. */
static bool read_file(const char *name, const char *ending, char text[SIZE], size_t *length)
{
    char path[512];
    snprintf(path, sizeof path, FOLDER "%s.%s", name, ending);
    FILE *in = fopen(path, "rb");
    if (in == NULL) {
        return false;
    }
    *length = fread(text, 1, SIZE - 1, in);
    text[*length] = '\0';
    fclose(in);
    return true;
}

/** Split into lines; returns their number. */
static size_t split(char *text, const char *lines[MOST_OVERRIDES])
{
    size_t count = 0;
    for (char *at = strtok(text, "\n"); at != NULL; at = strtok(NULL, "\n")) {
        assert_true(count < MOST_OVERRIDES);
        lines[count++] = at;
    }
    return count;
}

/** Whether a text is as expected, where <laws> is any words up to what comes behind it. */
static bool is_as_expected(const char *text, const char *expected)
{
    static const char LAWS[] = "<laws>";
    const char *list = strstr(expected, LAWS);
    if (list == NULL) {
        return strcmp(text, expected) == 0;
    }
    const size_t before = (size_t)(list - expected);
    bool same = strncmp(text, expected, before) == 0;
    bool good = false;
    const char *rest = text + before;
    for (bool ends = !same; !ends && !good; rest++) { // a list ends in its line
        good = is_as_expected(rest, list + strlen(LAWS));
        ends = *rest == '\0' || *rest == '\n';
    }
    return good;
}

/** Whether a file gives its message; prints both when it does not. */
static bool gives_message(const char *name)
{
    static char text[SIZE], expected[SIZE], sets[SIZE];
    size_t length = 0;
    size_t expected_length = 0;
    size_t set_length = 0;
    assert_true(read_file(name, "yaml", text, &length));
    if (!read_file(name, "txt", expected, &expected_length)) {
        print_error("%s.txt is missing\n", name);
        return false;
    }
    const char *overrides[MOST_OVERRIDES];
    const size_t count = read_file(name, "set", sets, &set_length) ? split(sets, overrides) : 0;
    if (expected_length > 0 && expected[expected_length - 1] == '\n') {
        expected[expected_length - 1] = '\0';
    }
    static clod_status status;
    status = (clod_status){CLOD_OK, ""};
    clod_case *parsed = clod_case_parse("case.yaml", text, length, overrides, count, &status);
    const bool good =
        parsed == NULL && status.code == CLOD_USAGE && is_as_expected(status.text, expected);
    if (!good) {
        print_error("%s: expected\n%s\nbut got code %d and\n%s\n", name, expected,
                    (int)status.code, status.text);
    }
    clod_case_destroy(&parsed);
    return good;
}

static void every_wrong_case_gives_its_message(void **state)
{
    (void)state;
    DIR *folder = opendir(FOLDER);
    assert_non_null(folder);
    size_t count = 0;
    size_t wrong = 0;
    for (const struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        char name[256];
        snprintf(name, sizeof name, "%s", entry->d_name);
        char *dot = strrchr(name, '.');
        if (dot != NULL && strcmp(dot, ".yaml") == 0) {
            *dot = '\0';
            count++;
            wrong += !gives_message(name);
        }
    }
    closedir(folder);
    assert_int_equal(wrong, 0);
    assert_true(count >= FEWEST);
}

static void a_file_that_is_not_there_is_named(void **state)
{
    (void)state;
    static clod_status status;
    assert_null(clod_case_load("no/such/case.yaml", NULL, 0, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text,
                        "no/such/case.yaml: cannot be opened: No such file or directory");
}

static void too_long_a_file_is_refused(void **state)
{
    (void)state;
    static clod_status status;
    const size_t length = ((size_t)1 << 20) + 1;
    char *text = malloc(length);
    assert_non_null(text);
    memset(text, ' ', length);
    assert_null(clod_case_parse("case.yaml", text, length, NULL, 0, &status));
    free(text);
    assert_non_null(strstr(status.text, "1048577 bytes are too long for a case file"));
}

/** 2000 unknown keys: what does not fit is counted, and the text still ends in a whole line. */
static void more_errors_than_fit_are_counted(void **state)
{
    (void)state;
    static clod_status status;
    static char text[SIZE];
    size_t used = 0;
    for (int i = 0; i < 2000; i++) {
        used += (size_t)snprintf(text + used, sizeof text - used, "wrong_%d: 1\n", i);
    }
    assert_null(clod_case_parse("case.yaml", text, used, NULL, 0, &status));
    size_t shown = 0;
    for (const char *at = strstr(status.text, "case.yaml:"); at != NULL;
         at = strstr(at + 1, "case.yaml:")) {
        shown++;
    }
    unsigned more = 0;
    const char *last = strrchr(status.text, '\n');
    assert_non_null(last);
    assert_int_equal(sscanf(last, "\nand %u more errors", &more), 1);
    assert_true(shown > 50);
    assert_int_equal(shown + more, 2000 + 2); // and materials and contacts are missing
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_wrong_case_gives_its_message),
        cmocka_unit_test(a_file_that_is_not_there_is_named),
        cmocka_unit_test(too_long_a_file_is_refused),
        cmocka_unit_test(more_errors_than_fit_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
