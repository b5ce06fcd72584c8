// The results folder: made, locked, cleared of what clod wrote and of nothing else.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "output/folder.h"

#include "temp_folder.h"

static void the_default_name_is_that_of_the_case(void **folder)
{
    (void)folder;
    const char *const names[][2] = {{"cases/copper-ore/five.yaml", "run/five"},
                                    {"five.yaml", "run/five"},
                                    {"/a.b/five", "run/five"},
                                    {"five.5.yml", "run/five.5"},
                                    {".yaml", "run/.yaml"}};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        char *path = clod_folder_default(names[n][0]);
        assert_string_equal(path, names[n][1]);
        clod_memory_free(path);
    }
}

static void a_folder_is_made_with_its_parents(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    struct stat info;
    temp_path(path, folder, "run/deep/name/");
    assert_true(clod_folder_make(path, &status));
    assert_true(clod_folder_make(path, &status)); // again is fine
    assert_int_equal(stat(path, &info), 0);
    assert_true(S_ISDIR(info.st_mode));
    temp_write(folder, "file", "", 0);
    assert_false(clod_folder_make(temp_path(path, folder, "file/name"), &status));
    char text[2 * PATH_MAX];
    snprintf(text, sizeof text, "Cannot make the folder %s/file: File exists.",
             (char *)*folder);
    assert_string_equal(status.text, text);
}

static void two_runs_do_not_share_a_folder(void **folder)
{
    clod_status status;
    char path[PATH_MAX], text[2 * PATH_MAX];
    temp_path(path, folder, "run/name");
    clod_folder *first = clod_folder_open(path, &status);
    assert_non_null(first);
    assert_string_equal(clod_folder_path(first), path);
    assert_null(clod_folder_open(path, &status));
    snprintf(
        text, sizeof text,
        "Another run (process %ld) is writing into %s. Wait for its end, or choose another "
        "folder with -o.",
        (long)getpid(), path);
    assert_string_equal(status.text, text);
    assert_int_equal(status.code, CLOD_USAGE);
    clod_folder_close(&first);
    assert_null(first);
    clod_folder *second = clod_folder_open(path, &status);
    assert_non_null(second);
    clod_folder_close(&second);
    clod_folder_close(&second); // NULL is fine
}

static void clearing_removes_only_what_clod_wrote(void **folder)
{
    const char *const own[] = {
        "log.jsonl",           "summary.json",
        "series.csv",          "restart_a.h5",
        "restart_b.h5",        "restart_b.h5.part",
        "snap_000123.hdf",     "walls_000000.hdf",
        "contacts_000001.hdf", "seed1_snap_000001.hdf",
        "run.hdf.series",      "run_walls.hdf.series",
        "point_1.csv",         "x_snap_000001.hdf",
    };
    const char *const foreign[] = {"case.yaml",   "case-complete.yaml", "notes.txt",
                                   "snap_1.hdf",  "points.csv",         "measured_a.h5",
                                   "my.hdf",      "series.csv.bak",     "figure.png",
                                   "point_x.csv", "seed1_snap_0000.hdf"};
    clod_status status;
    for (size_t n = 0; n < sizeof own / sizeof *own; n++) {
        temp_write(folder, own[n], "x", 1);
    }
    for (size_t n = 0; n < sizeof foreign / sizeof *foreign; n++) {
        temp_write(folder, foreign[n], "x", 1);
    }
    const char *begin = "clod checkpoint: HDF5 behind 512 bytes\nformat 7\n";
    temp_write(folder, "preshear_a.h5", begin, strlen(begin));
    char path[PATH_MAX];
    assert_int_equal(mkdir(temp_path(path, folder, "log.jsonl.d"), 0777), 0);
    const char *const more[] = {"point_[0-9].csv"};
    assert_true(clod_folder_clear(*folder, more, 1, &status));
    for (size_t n = 0; n < sizeof own / sizeof *own; n++) {
        assert_false(temp_exists(folder, own[n]));
    }
    for (size_t n = 0; n < sizeof foreign / sizeof *foreign; n++) {
        assert_true(temp_exists(folder, foreign[n]));
    }
    assert_false(temp_exists(folder, "preshear_a.h5"));
    assert_true(temp_exists(folder, "log.jsonl.d"));
    assert_true(clod_folder_clear(temp_path(path, folder, "missing"), NULL, 0, &status));
}

static void texts_json_and_case_are_written(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    size_t size;
    assert_true(clod_folder_write_case(*folder, "given: 1\n", "given: 1\nrest: 2\n", &status));
    char *text = temp_read(folder, "case.yaml", &size);
    assert_string_equal(text, "given: 1\n");
    clod_memory_free(text);
    text = temp_read(folder, "case-complete.yaml", &size);
    assert_string_equal(text, "given: 1\nrest: 2\n");
    clod_memory_free(text);
    json_t *json = json_pack("{s:f, s:[i,i]}", "phi_lin_deg", 44.6, "seeds", 1, 2);
    temp_path(path, folder, "summary.json");
    assert_true(clod_folder_write_json(path, json, &status));
    json_t *back = json_load_file(path, 0, NULL);
    assert_true(json_equal(json, back));
    json_decref(json);
    json_decref(back);
    text = temp_read(folder, "summary.json", &size);
    assert_int_equal(text[size - 1], '\n');
    clod_memory_free(text);
    assert_false(clod_folder_write(temp_path(path, folder, "missing/file"), "x", &status));
}

static void free_space_is_that_of_the_nearest_folder(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    double here = -1.0, below = -1.0, relative = -1.0;
    assert_true(clod_folder_space(*folder, &here, &status));
    assert_true(here > 0.0);
    assert_true(clod_folder_space(temp_path(path, folder, "not/yet/there"), &below, &status));
    assert_true(below > 0.5 * here && below < 2.0 * here); // others write meanwhile
    assert_true(clod_folder_space("not-yet/there", &relative, &status));
    assert_true(relative >= 0.0);
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(the_default_name_is_that_of_the_case),
        FOLDER_TEST(a_folder_is_made_with_its_parents),
        FOLDER_TEST(two_runs_do_not_share_a_folder),
        FOLDER_TEST(clearing_removes_only_what_clod_wrote),
        FOLDER_TEST(texts_json_and_case_are_written),
        FOLDER_TEST(free_space_is_that_of_the_nearest_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
