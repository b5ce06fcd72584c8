// The results folder: made, locked, cleared of what clod wrote and of nothing else.

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "output/folder_files.h"
#include "output/folder_names.h"

#include "temp_folder.h"

static void the_default_name_is_that_of_the_case(void **folder)
{
    (void)folder;
    const char *const names[][2] = {{"cases/copper-ore/five.yaml", "run/five"},
                                    {"five.yaml", "run/five"},
                                    {"/a.b/five", "run/five"},
                                    {"five.5.yml", "run/five.5"},
                                    {".yaml", "run/.yaml"},
                                    {"cases/copper-ore-5/case.yaml", "run/copper-ore-5"},
                                    {"src/../cases/free-run/./case.yaml", "run/free-run"},
                                    {"cases/copper-ore-5/../case.yaml", "run/cases"},
                                    {"/case.yaml", "run/case"},
                                    {"missing/case.yaml", "run/case"}};
    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        clod_status status;
        char *path = clod_folder_default(names[n][0], &status);
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
    snprintf(text, sizeof text,
             "%s/file is there and is not a folder: results cannot be written into it. Choose "
             "another folder with -o, or move it away.",
             (char *)*folder);
    assert_string_equal(status.text, text);
    assert_int_equal(status.code, CLOD_USAGE);
}

static void two_runs_do_not_share_a_folder(void **folder)
{
    clod_status status;
    char path[PATH_MAX], text[2 * PATH_MAX];
    temp_path(path, folder, "run/name");
    clod_folder *first = clod_folder_open(path, &status);
    assert_non_null(first);
    assert_string_equal(first->path, path);
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

/** Names from docs/results-folder.md, and names that only look like them. */
static const char *const OWN[] = {
    "log.jsonl",
    "summary.json",
    "summary.json.part",
    "case-complete.yaml.part",
    "series.csv",
    "preshear.csv",
    "point-12.csv",
    "seed-3-point-1.csv",
    "points.csv",
    "points.csv.part",
    "restart_a.h5",
    "restart_b.h5.part",
    "restart-failed_a.h5",
    "restart-seed-12-point-2-failed_b.h5",
    "snap_000123.hdf",
    "walls_000000.hdf",
    "contacts_000001.hdf",
    "seed-1-preshear_snap_000001.hdf",
    "run.hdf.series",
    "point-1_walls.hdf.series.part",
    "reverse.csv",
    "fill.csv",
    "wall.csv",
    "seed-2-wall.csv",
    "wall_friction.csv",
    "residence.csv",
    "restart-seed-2-reverse_a.h5",
    "run.pvsm",
    "preshear.pvsm.part",
};
static const char *const FOREIGN[] = {
    "notes.txt",        "my.hdf",          "my.hdf.series",       "my_snap_000001.hdf",
    "snap_1.hdf",       "series.csv.bak",  "xseries.csv",         "point-x.csv",
    "point-1 copy.csv", "seed-1-data.csv", "restart-copy_a.h5",   "restart_c.h5",
    "figure.png",       "logxjsonl",       "seed1_snap_0000.hdf", "seed-1-points.csv",
    "my.pvsm",
};
static const char *const COPIES[] = {"case.yaml", "case-complete.yaml"};
#define COUNT(array) (sizeof(array) / sizeof *(array))

static void put(void **folder, const char *const *names, size_t count)
{
    for (size_t n = 0; n < count; n++) {
        temp_write(folder, names[n], "x", 1);
    }
}

static void clearing_removes_only_what_clod_wrote(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    clod_folder *self = clod_folder_open(*folder, &status);
    assert_non_null(self);
    put(folder, OWN, COUNT(OWN));
    put(folder, FOREIGN, COUNT(FOREIGN));
    put(folder, COPIES, COUNT(COPIES));
    // not even a true checkpoint, when it has another name
    const char *begin = "clod checkpoint: HDF5 behind 512 bytes\nformat 8\n";
    temp_write(folder, "kept_a.h5", begin, strlen(begin));
    assert_int_equal(mkdir(temp_path(path, folder, "preshear_snap_000001.hdf"), 0777), 0);
    assert_true(clod_folder_clear(self, &status));
    clod_folder_close(&self);
    for (size_t n = 0; n < COUNT(OWN); n++) {
        assert_false(temp_exists(folder, OWN[n]));
    }
    for (size_t n = 0; n < COUNT(FOREIGN); n++) {
        assert_true(temp_exists(folder, FOREIGN[n]));
    }
    assert_true(temp_exists(folder, "case.yaml"));
    assert_true(temp_exists(folder, "case-complete.yaml"));
    assert_true(temp_exists(folder, "kept_a.h5"));
    assert_true(temp_exists(folder, "preshear_snap_000001.hdf"));
}

/** Refused with the name, and neither touched nor marked. */
static void expect_refused(void **folder, const char *name)
{
    clod_status status;
    char text[2 * PATH_MAX];
    assert_null(clod_folder_open(*folder, &status));
    snprintf(text, sizeof text,
             "%s/%s is in the way: a run would replace it, and clod did not make this folder "
             "(there is no .clod-lock in it). Choose another folder with -o, or move the file "
             "away. If this is a copy of a results folder, copy its .clod-lock too.",
             (char *)*folder, name);
    assert_string_equal(status.text, text);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_false(temp_exists(folder, ".clod-lock"));
    assert_true(temp_exists(folder, name));
}

static void a_folder_with_files_in_the_way_is_refused(void **folder)
{
    char path[PATH_MAX];
    put(folder, FOREIGN, COUNT(FOREIGN));
    for (size_t n = 0; n < COUNT(OWN) + COUNT(COPIES); n++) {
        const char *name = n < COUNT(OWN) ? OWN[n] : COPIES[n - COUNT(OWN)];
        temp_write(folder, name, "mine", 4);
        expect_refused(folder, name);
        assert_int_equal(unlink(temp_path(path, folder, name)), 0);
    }
    assert_int_equal(mkdir(temp_path(path, folder, "series.csv"), 0777), 0);
    expect_refused(folder, "series.csv"); // not only files
    assert_int_equal(rmdir(path), 0);
    assert_int_equal(symlink("/nowhere", temp_path(path, folder, "case.yaml")), 0);
    clod_status status;
    assert_null(clod_folder_open(*folder, &status));
    assert_int_equal(unlink(path), 0);
}

static void a_folder_with_other_files_or_a_lock_is_taken(void **folder)
{
    clod_status status;
    put(folder, FOREIGN, COUNT(FOREIGN));
    clod_folder *self = clod_folder_open(*folder, &status);
    assert_non_null(self);
    clod_folder_close(&self);
    put(folder, OWN, COUNT(OWN)); // now it is marked: these are results
    put(folder, COPIES, COUNT(COPIES));
    self = clod_folder_open(*folder, &status);
    assert_non_null(self);
    clod_folder_close(&self);
}

static void texts_json_and_case_are_written(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    size_t size;
    assert_true(clod_folder_write_case(temp_folder(folder), "given: 1\n", "given: 1\nrest: 2\n",
                                       &status));
    char *text = temp_read(folder, "case.yaml", &size);
    assert_string_equal(text, "given: 1\n");
    clod_memory_free(text);
    text = temp_read(folder, "case-complete.yaml", &size);
    assert_string_equal(text, "given: 1\nrest: 2\n");
    clod_memory_free(text);
    json_t *json = json_pack("{s:f, s:[i,i]}", "phi_lin_deg", 44.6, "seeds", 1, 2);
    assert_true(clod_folder_write_json(temp_folder(folder), "summary.json", json, &status));
    json_t *back = json_load_file(temp_path(path, folder, "summary.json"), 0, NULL);
    assert_true(json_equal(json, back));
    json_decref(json);
    json_decref(back);
    text = temp_read(folder, "summary.json", &size);
    assert_int_equal(text[size - 1], '\n');
    clod_memory_free(text);
    assert_false(clod_folder_write(temp_folder(folder), "missing/file", "x", &status));
}

/** The text of a run whose folder is not in its place any more. */
static void expect_moved(const clod_folder *self)
{
    clod_status status;
    assert_false(clod_folder_check(self, &status));
    assert_int_equal(status.code, CLOD_FAILED);
    assert_non_null(strstr(status.text, self->path));
    assert_non_null(strstr(status.text, "was moved away, removed or replaced"));
}

static void a_folder_that_took_the_place_is_not_written_into(void **folder)
{
    clod_status status;
    char path[PATH_MAX], moved[PATH_MAX];
    temp_path(path, folder, "run");
    temp_path(moved, folder, "moved");
    clod_folder *self = clod_folder_open(path, &status);
    assert_true(clod_folder_check(self, &status));
    assert_true(clod_folder_write(self, "case.yaml", "old", &status));
    assert_int_equal(rename(path, moved), 0);
    expect_moved(self);
    assert_int_equal(mkdir(path, 0777), 0);
    expect_moved(self);
    assert_false(clod_folder_write(self, "case.yaml", "new", &status));
    assert_non_null(strstr(status.text, "was moved away, removed or replaced"));
    size_t size;
    char *text = temp_read(folder, "moved/case.yaml", &size);
    assert_string_equal(text, "old");
    clod_memory_free(text);
    assert_false(temp_exists(folder, "moved/case.yaml.part"));
    assert_false(temp_exists(folder, "run/case.yaml"));
    clod_folder *other = clod_folder_open(path, &status); // not the locked one
    assert_non_null(other);
    clod_folder_close(&other);
    clod_folder_close(&self);
}

static void a_lock_that_was_taken_away_is_noticed(void **folder)
{
    clod_status status;
    char path[PATH_MAX];
    clod_folder *self = clod_folder_open(*folder, &status);
    assert_int_equal(unlink(temp_path(path, folder, ".clod-lock")), 0);
    expect_moved(self);
    clod_folder *other = clod_folder_open(*folder, &status); // now there are two
    assert_non_null(other);
    expect_moved(self);
    assert_true(clod_folder_check(other, &status));
    clod_folder_close(&other);
    clod_folder_close(&self);
}

static void a_lock_is_not_written_through_a_link(void **folder)
{
    clod_status status;
    char link[PATH_MAX], other[PATH_MAX];
    size_t size;
    temp_write(folder, "other", "mine", 4);
    temp_path(link, folder, ".clod-lock");
    assert_int_equal(symlink(temp_path(other, folder, "other"), link), 0);
    assert_null(clod_folder_open(*folder, &status));
    assert_non_null(strstr(status.text, "clod does not write through symbolic links"));
    char *text = temp_read(folder, "other", &size);
    assert_string_equal(text, "mine");
    clod_memory_free(text);
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
        FOLDER_TEST(a_folder_with_files_in_the_way_is_refused),
        FOLDER_TEST(a_folder_with_other_files_or_a_lock_is_taken),
        FOLDER_TEST(texts_json_and_case_are_written),
        FOLDER_TEST(a_folder_that_took_the_place_is_not_written_into),
        FOLDER_TEST(a_lock_that_was_taken_away_is_noticed),
        FOLDER_TEST(a_lock_is_not_written_through_a_link),
        FOLDER_TEST(free_space_is_that_of_the_nearest_folder),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
