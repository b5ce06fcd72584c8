// Figures beside a page: which files of their names are clod's and may go, and which are a user's.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>
#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "output/temp_folder.h"
#include "report/figure_files.h"

static char first[] = "<svg>first</svg>\n", second[] = "<svg>second</svg>\n";
static const clod_figure_file FILES[] = {{"flow-function", first}, {"out--lets", second}};

/** Write a page's figures as a page is written; the page itself is not needed. */
static bool write_page(void **folder, const char *page, size_t count, clod_status *status)
{
    char path[PATH_MAX];
    temp_path(path, folder, page);
    return clod_figure_files_check(path, FILES, count, status) &&
           clod_figure_files_write(path, FILES, count, status);
}

static void put(void **folder, const char *name, const char *text)
{
    char path[PATH_MAX];
    clod_status status;
    temp_path(path, folder, name);
    assert_true(clod_file_replace(path, text, strlen(text), NULL, 0, &status));
}

static void has(void **folder, const char *name, const char *text)
{
    size_t size;
    char *found = temp_read(folder, name, &size);
    assert_string_equal(found, text);
    clod_memory_free(found);
}

static void figures_of_an_earlier_page_go(void **folder)
{
    clod_status status;
    assert_true(write_page(folder, "out.html", 2, &status));
    assert_true(temp_exists(folder, "out-out--lets.svg"));
    size_t size;
    char *text = temp_read(folder, "out-out--lets.svg", &size);
    assert_null(strstr(text, "<!--")); // a comment must have no "--" in it
    clod_memory_free(text);
    assert_true(write_page(folder, "out.html", 1, &status));
    assert_true(temp_exists(folder, "out-flow-function.svg"));
    assert_false(temp_exists(folder, "out-out--lets.svg"));
    assert_true(write_page(folder, "out.html", 0, &status));
    assert_false(temp_exists(folder, "out-flow-function.svg"));
}

static void other_files_stay(void **folder)
{
    clod_status status;
    size_t size;
    char outlets[200], edited[200];
    assert_true(write_page(folder, "out.html", 2, &status));
    assert_true(write_page(folder, "out-2.html", 2, &status)); // out-2-out--lets.svg
    char *text = temp_read(folder, "out-out--lets.svg", &size);
    snprintf(outlets, sizeof outlets, "%s", text);
    clod_memory_free(text);
    snprintf(edited, sizeof edited, "%s", outlets);
    *strstr(edited, "second") = 'S';
    put(folder, "out-for-paper.svg", outlets); // a copy under another name
    put(folder, "out-out--lets.svg", edited);
    put(folder, "out-mine.svg", "<svg/>\n");
    put(folder, "out-.svg", "<svg/>\n");
    put(folder, "out-empty.svg", "");
    assert_true(write_page(folder, "out.html", 0, &status));
    assert_false(temp_exists(folder, "out-flow-function.svg"));
    has(folder, "out-out--lets.svg", edited);
    has(folder, "out-for-paper.svg", outlets);
    has(folder, "out-2-out--lets.svg", outlets);
    has(folder, "out-mine.svg", "<svg/>\n");
    assert_true(temp_exists(folder, "out-.svg") && temp_exists(folder, "out-empty.svg"));
}

static void a_file_of_the_user_is_not_overwritten(void **folder)
{
    clod_status status;
    put(folder, "out-out--lets.svg", "<svg>mine</svg>\n");
    assert_false(write_page(folder, "out.html", 2, &status));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_non_null(strstr(status.text, "out-out--lets.svg is in the way of a figure of "));
    has(folder, "out-out--lets.svg", "<svg>mine</svg>\n");
    assert_false(temp_exists(folder, "out-flow-function.svg"));
    assert_true(write_page(folder, "out.html", 1, &status)); // that figure is not wanted
    has(folder, "out-out--lets.svg", "<svg>mine</svg>\n");
}

static void a_results_folder_has_the_names_of_its_report(void **folder)
{
    clod_status status;
    put(folder, ".clod-lock", "");
    put(folder, "report-out--lets.svg", "<svg>of an older clod</svg>\n");
    put(folder, "other-out--lets.svg", "<svg>mine</svg>\n");
    assert_true(write_page(folder, "report.html", 2, &status));
    assert_false(write_page(folder, "other.html", 2, &status));
    size_t size;
    char *found = temp_read(folder, "report-out--lets.svg", &size);
    assert_ptr_equal(strstr(found, second), found);
    clod_memory_free(found);
}

/** SIGALRM ends the program should a pipe be waited for; a file of 3 GB would show in its memory. */
static void what_is_no_figure_is_not_read(void **folder)
{
    clod_status status;
    char pipe[PATH_MAX], large[PATH_MAX];
    assert_true(write_page(folder, "out.html", 1, &status));
    temp_path(pipe, folder, "out-pipe.svg");
    temp_path(large, folder, "out-large.svg");
    assert_int_equal(mkfifo(pipe, 0600), 0);
    const int file = open(large, O_WRONLY | O_CREAT, 0600);
    assert_int_equal(ftruncate(file, (off_t)3 << 30), 0);
    assert_int_equal(close(file), 0);
    struct rusage before, after;
    getrusage(RUSAGE_SELF, &before);
    alarm(10);
    assert_true(write_page(folder, "out.html", 0, &status));
    temp_path(pipe, folder, "out-out--lets.svg");
    assert_int_equal(mkfifo(pipe, 0600), 0);
    assert_false(write_page(folder, "out.html", 2, &status)); // a pipe is in the way
    alarm(0);
    getrusage(RUSAGE_SELF, &after);
    assert_true(after.ru_maxrss - before.ru_maxrss < 32 << 10); // KiB
    assert_non_null(strstr(status.text, "out-out--lets.svg is in the way of a figure of "));
    assert_false(temp_exists(folder, "out-flow-function.svg"));
    assert_true(temp_exists(folder, "out-pipe.svg") && temp_exists(folder, "out-large.svg"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(figures_of_an_earlier_page_go, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(other_files_stay, temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_file_of_the_user_is_not_overwritten, temp_folder_make,
                                        temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_results_folder_has_the_names_of_its_report,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(what_is_no_figure_is_not_read, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
