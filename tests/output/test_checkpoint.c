// Checkpoints: every field bit for bit, two in turn, damage of every kind found, disk full.

#include <inttypes.h>
#include <math.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <hdf5.h>

#include "output/checkpoint.h"
#include "output/checkpoint_file.h"

#include "support/sanitized.h"
#include "temp_folder.h"

#include "random_state.h"

#define CASE "grains:\n  - count: 37\n"

static bool write_one(void **folder, const clod_state *state, clod_status *status)
{
    uint64_t detector[2] = {(uint64_t)state->step, 77};
    const clod_checkpoint_part part = {"detector", detector, sizeof detector};
    return clod_checkpoint_write(temp_folder(folder), "restart", state, NULL, &part, 1, CASE,
                                 status);
}

/** Write the states of the given seeds one after the other. */
static void write_seeds(void **folder, uint64_t first, uint64_t last)
{
    for (uint64_t seed = first; seed <= last; seed++) {
        clod_status status;
        clod_state state = random_state(seed);
        assert_true(write_one(folder, &state, &status));
        clod_state_fini(&state);
    }
}

static bool read_one(void **folder, clod_state *state, char notice[2048], clod_status *status)
{
    uint64_t detector[2] = {0, 0};
    clod_checkpoint_part part = {"detector", detector, sizeof detector};
    const bool done = clod_checkpoint_read(temp_folder(folder), "restart", state, &part, 1,
                                           CASE, notice, 2048, status);
    if (done) {
        assert_int_equal(detector[0], state->step);
        assert_int_equal(detector[1], 77);
    }
    return done;
}

/** Read and expect the state of a seed; `notice` gets what the user is told. */
static void expect_seed(void **folder, uint64_t seed, char notice[2048])
{
    clod_status status;
    clod_state expected = random_state(seed);
    clod_state found = bare_state();
    assert_true(read_one(folder, &found, notice, &status));
    assert_states_equal(&found, &expected);
    clod_state_fini(&found);
    clod_state_fini(&expected);
}

/** Read and expect a failure with this code and text. */
static void expect_failure(void **folder, clod_code code, const char *text)
{
    clod_status status;
    char notice[2048];
    clod_state found = bare_state();
    assert_false(read_one(folder, &found, notice, &status));
    assert_int_equal(status.code, code);
    assert_string_equal(status.text, text);
    assert_string_equal(notice, "");
    clod_state_fini(&found);
}

static void every_field_comes_back_bit_for_bit(void **folder)
{
    char notice[2048];
    write_seeds(folder, 1, 1);
    expect_seed(folder, 1, notice);
    assert_string_equal(notice, "");
}

static void a_state_in_use_is_overwritten(void **folder)
{
    clod_status status;
    char notice[2048];
    write_seeds(folder, 1, 1);
    clod_state expected = random_state(1);
    clod_state found = random_state(2); // grains, contacts and all, to be replaced
    assert_true(read_one(folder, &found, notice, &status));
    assert_states_equal(&found, &expected);
    clod_state_fini(&found);
    clod_state_fini(&expected);
}

static void an_empty_state_comes_back_empty(void **folder)
{
    clod_status status;
    char notice[2048];
    const clod_state empty = {.step = 5};
    clod_state found = {0};
    assert_true(
        clod_checkpoint_write(temp_folder(folder), "e", &empty, NULL, NULL, 0, NULL, &status));
    assert_true(clod_checkpoint_read(temp_folder(folder), "e", &found, NULL, 0, NULL, notice,
                                     sizeof notice, &status));
    assert_int_equal(found.step, 5);
    assert_int_equal(found.grains.count, 0);
    assert_int_equal(found.contact_count, 0);
    assert_null(found.build_position);
    assert_null(found.build_walls);
    clod_state_fini(&found);
}

static bool is_there(void **folder, const char *stem)
{
    clod_status status;
    bool exists;
    assert_true(clod_checkpoint_exists(temp_folder(folder), stem, &exists, &status));
    return exists;
}

static void the_files_take_turns_and_the_newest_is_read(void **folder)
{
    char notice[2048];
    assert_false(is_there(folder, "restart"));
    write_seeds(folder, 1, 1);
    assert_true(is_there(folder, "restart"));
    assert_false(is_there(folder, "other"));
    assert_true(temp_exists(folder, "restart_a.h5"));
    assert_false(temp_exists(folder, "restart_b.h5"));
    size_t size_1, size_2, size_3;
    char *first = temp_read(folder, "restart_a.h5", &size_1);
    write_seeds(folder, 2, 2);
    char *kept = temp_read(folder, "restart_a.h5", &size_2);
    assert_int_equal(size_1, size_2);
    assert_memory_equal(first, kept, size_1);
    expect_seed(folder, 2, notice);
    char *second = temp_read(folder, "restart_b.h5", &size_2);
    write_seeds(folder, 3, 3);
    char *still = temp_read(folder, "restart_b.h5", &size_3);
    assert_int_equal(size_2, size_3);
    assert_memory_equal(second, still, size_2);
    expect_seed(folder, 3, notice);
    assert_string_equal(notice, "");
    clod_memory_free(first);
    clod_memory_free(kept);
    clod_memory_free(second);
    clod_memory_free(still);
}

/** What the user reads when restart_b.h5 (seed 2) is bad and restart_a.h5 (seed 1) is not. */
static void expect_older(void **folder, const char *reason)
{
    char notice[2048], expected[2048];
    const clod_state older = random_state(1);
    snprintf(expected, sizeof expected,
             "%s/restart_b.h5 cannot be used: %s. Going on from %s/restart_a.h5, step %" PRId64
             ", time %.9g s.",
             (char *)*folder, reason, (char *)*folder, older.step, older.time);
    expect_seed(folder, 1, notice);
    assert_string_equal(notice, expected);
    clod_state_fini(&(clod_state){.grains = older.grains,
                                  .walls = older.walls,
                                  .build_position = older.build_position,
                                  .build_walls = older.build_walls,
                                  .contacts = older.contacts});
}

static void a_file_cut_at_any_length_is_not_used(void **folder)
{
    write_seeds(folder, 1, 2);
    size_t size;
    char *whole = temp_read(folder, "restart_b.h5", &size);
    const size_t lengths[] = {0, 1, 100, 511, 512, 513, 2000, size / 2, size - 1};
    for (size_t l = 0; l < sizeof lengths / sizeof *lengths; l++) {
        char reason[256];
        if (lengths[l] < 512) {
            snprintf(reason, sizeof reason, "it has only %zu bytes, it was cut off",
                     lengths[l]);
        } else {
            snprintf(reason, sizeof reason, "it has %zu bytes, its head says %zu", lengths[l],
                     size);
        }
        temp_write(folder, "restart_b.h5", whole, lengths[l]);
        expect_older(folder, reason);
    }
    clod_memory_free(whole);
}

static void a_flipped_bit_anywhere_is_found(void **folder)
{
    write_seeds(folder, 1, 2);
    size_t size;
    char *whole = temp_read(folder, "restart_b.h5", &size);
    // every byte of the head, then every 211th
    const size_t apart = sanitized() ? 631 : 211;
    for (size_t at = 0; at < size; at += at < 512 ? 1 : apart) {
        char notice[2048];
        const char mask = (char)(1 << (at % 8));
        whole[at] ^= mask;
        temp_write(folder, "restart_b.h5", whole, size);
        whole[at] ^= mask;
        if (at >= 512) {
            expect_older(folder, "its content does not fit its checksum, it is damaged");
        } else {
            expect_seed(folder, 1, notice); // the reason depends on the line that was hit
            assert_non_null(strstr(notice, "restart_b.h5 cannot be used: it"));
        }
    }
    clod_memory_free(whole);
}

static void a_damaged_file_is_the_next_to_be_overwritten(void **folder)
{
    char notice[2048];
    write_seeds(folder, 1, 2);
    temp_write(folder, "restart_b.h5", "rubbish", 7);
    expect_seed(folder, 1, notice);
    write_seeds(folder, 3, 3);
    temp_write(folder, "restart_a.h5", "rubbish", 7); // so b must be the one just written
    expect_seed(folder, 3, notice);
}

static void a_newest_file_with_one_wrong_byte_is_overwritten(void **folder)
{
    char notice[2048];
    size_t size;
    write_seeds(folder, 1, 2);
    char *newest = temp_read(folder, "restart_b.h5", &size);
    newest[size - 9] ^= 1;
    temp_write(folder, "restart_b.h5", newest, size);
    clod_memory_free(newest);
    write_seeds(folder, 3, 3);
    expect_seed(folder, 3, notice);
    temp_write(folder, "restart_b.h5", "rubbish", 7);
    expect_seed(folder, 1, notice);
}

static void without_a_whole_file_the_reasons_are_told(void **folder)
{
    char text[2048];
    const char *at = *folder;
    snprintf(text, sizeof text,
             "There is no checkpoint to go on from: neither %s/restart_a.h5 nor "
             "%s/restart_b.h5 is there. Start over with --fresh.",
             at, at);
    expect_failure(folder, CLOD_FAILED, text);
    char rubbish[600] = "rubbish";
    temp_write(folder, "restart_a.h5", "", 0);
    temp_write(folder, "restart_b.h5", rubbish, sizeof rubbish);
    snprintf(text, sizeof text,
             "%s/restart_a.h5 cannot be used: it has only 0 bytes, it was cut off.\n"
             "%s/restart_b.h5 cannot be used: it does not begin like a checkpoint of clod.\n"
             "There is no other checkpoint to go on from. Start over with --fresh.",
             at, at);
    expect_failure(folder, CLOD_FAILED, text);
}

static void a_changed_case_is_refused(void **folder)
{
    clod_status status;
    char notice[2048], text[2048];
    write_seeds(folder, 1, 1);
    clod_state found = bare_state();
    const clod_state stored = random_state(1);
    assert_false(clod_checkpoint_read(temp_folder(folder), "restart", &found, NULL, 0,
                                      CASE "# changed\n", notice, sizeof notice, &status));
    snprintf(text, sizeof text,
             "The case has changed since %s/restart_a.h5 was written (step %" PRId64
             ", time %.9g s); a run cannot go on with another case. Write to another folder "
             "with -o, or start over with --fresh.",
             (char *)*folder, stored.step, stored.time);
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, text);
    clod_state_fini(&found);
    found = stored;
    clod_state_fini(&found);
}

static void another_format_is_refused_and_not_taken_for_damage(void **folder)
{
    write_seeds(folder, 1, 2);
    // a file of a later clod: the same data behind a head with the next format
    clod_status status;
    clod_checkpoint_file files[2];
    assert_true(
        clod_checkpoint_file_find(files, temp_folder(folder), "restart", true, NULL, &status));
    assert_int_equal(clod_checkpoint_file_newest(files), 1);
    size_t size;
    char *bytes = temp_read(folder, "restart_b.h5", &size);
    files[1].head.format = CLOD_CHECKPOINT_FORMAT + 1;
    assert_int_equal(clod_checkpoint_file_print_head(bytes, &files[1].head, files[1].descriptor,
                                                     &(clod_checkpoint_reader){0}),
                     0);
    temp_write(folder, "restart_b.h5", bytes, size);
    clod_memory_free(bytes);
    clod_checkpoint_file_release(files);
    char text[2048];
    snprintf(
        text, sizeof text,
        "%s/restart_b.h5 has checkpoint format %d, this clod reads format %d. Go on with the "
        "clod that wrote it, or start over with --fresh.",
        (char *)*folder, CLOD_CHECKPOINT_FORMAT + 1, CLOD_CHECKPOINT_FORMAT);
    expect_failure(folder, CLOD_FAILED, text);
}

static void other_parts_are_refused(void **folder)
{
    clod_status status;
    char notice[2048];
    write_seeds(folder, 1, 1);
    clod_state found = bare_state();
    uint64_t larger[3];
    clod_checkpoint_part part = {"detector", larger, sizeof larger};
    assert_false(clod_checkpoint_read(temp_folder(folder), "restart", &found, &part, 1, CASE,
                                      notice, sizeof notice, &status));
    assert_non_null(strstr(status.text, "parts/detector"));
    part = (clod_checkpoint_part){"tester", larger, sizeof larger};
    assert_false(clod_checkpoint_read(temp_folder(folder), "restart", &found, &part, 1, CASE,
                                      notice, sizeof notice, &status));
    assert_non_null(strstr(status.text, "parts/tester"));
    assert_true(read_one(folder, &found, notice, &status));
    clod_state_fini(&found);
}

static void a_part_file_left_by_a_killed_run_does_no_harm(void **folder)
{
    char notice[2048];
    write_seeds(folder, 1, 2);
    temp_write(folder, "restart_a.h5.part", "half", 4);
    expect_seed(folder, 2, notice);
    assert_string_equal(notice, "");
    write_seeds(folder, 3, 3);
    expect_seed(folder, 3, notice);
    assert_false(temp_exists(folder, "restart_a.h5.part"));
}

/** Write checkpoint after checkpoint until killed. */
static _Noreturn void write_until_killed(void **folder)
{
    for (uint64_t seed = 1;; seed++) {
        clod_status status;
        clod_state state = random_state(seed);
        const clod_checkpoint_part part = {"seed", &seed, sizeof seed};
        if (!clod_checkpoint_write(temp_folder(folder), "restart", &state, NULL, &part, 1, CASE,
                                   &status)) {
            _exit(1);
        }
        clod_state_fini(&state);
    }
}

static void a_run_killed_at_any_moment_leaves_whole_checkpoints(void **folder)
{
    for (uint64_t kill_number = 0; kill_number < 20; kill_number++) {
        const double moment = clod_random_uniform(9, CLOD_RANDOM_TEST, kill_number, 0);
        const pid_t child = fork();
        assert_true(child >= 0);
        if (child == 0) {
            write_until_killed(folder);
        }
        int ended;
        for (int wait = 0; wait < 10000 && !is_there(folder, "restart"); wait++) {
            usleep(1000);
        }
        usleep((useconds_t)(moment * 20e3));
        kill(child, SIGKILL);
        assert_int_equal(waitpid(child, &ended, 0), child);
        assert_true(WIFSIGNALED(ended));
        clod_status status;
        char notice[2048];
        uint64_t seed = 0;
        clod_checkpoint_part part = {"seed", &seed, sizeof seed};
        clod_state found = bare_state();
        assert_true(clod_checkpoint_read(temp_folder(folder), "restart", &found, &part, 1, CASE,
                                         notice, sizeof notice, &status));
        assert_string_equal(notice, "");
        clod_state expected = random_state(seed);
        assert_states_equal(&found, &expected);
        clod_state_fini(&found);
        clod_state_fini(&expected);
    }
}

/** The limit on a file's size stands for a full disk, wherever it ends. */
static void a_full_disk_leaves_both_files(void **folder)
{
    clod_status status;
    char notice[2048], text[2048];
    write_seeds(folder, 1, 2);
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    const struct sigaction ignore = {.sa_handler = SIG_IGN};
    struct sigaction old;
    sigaction(SIGXFSZ, &ignore, &old);
    clod_state state = random_state(3);
    size_t size;
    clod_memory_free(temp_read(folder, "restart_b.h5", &size));
    for (rlim_t limit = 0; limit < size; limit += 4096) {
        const struct rlimit full = {limit, before.rlim_max};
        assert_int_equal(setrlimit(RLIMIT_FSIZE, &full), 0);
        const bool done = write_one(folder, &state, &status);
        setrlimit(RLIMIT_FSIZE, &before);
        assert_false(done);
        snprintf(text, sizeof text,
                 "Cannot write %s/restart_a.h5: File too large. Free some space, then give the "
                 "same command again: the run goes on from its last checkpoint. What was "
                 "complete before is untouched.",
                 (char *)*folder);
        assert_string_equal(status.text, text);
        assert_int_equal(status.code, CLOD_FAILED);
        assert_false(temp_exists(folder, "restart_a.h5.part"));
        expect_seed(folder, 2, notice);
        assert_string_equal(notice, "");
    }
    sigaction(SIGXFSZ, &old, NULL);
    clod_state_fini(&state);
    assert_int_equal(H5Fget_obj_count((hid_t)H5F_OBJ_ALL, H5F_OBJ_ALL), 0); // HDF5 let all go
    temp_write(folder, "restart_b.h5", "", 0);
    expect_seed(folder, 1, notice); // the older one is whole too
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(every_field_comes_back_bit_for_bit),
        FOLDER_TEST(a_state_in_use_is_overwritten),
        FOLDER_TEST(an_empty_state_comes_back_empty),
        FOLDER_TEST(the_files_take_turns_and_the_newest_is_read),
        FOLDER_TEST(a_file_cut_at_any_length_is_not_used),
        FOLDER_TEST(a_flipped_bit_anywhere_is_found),
        FOLDER_TEST(a_damaged_file_is_the_next_to_be_overwritten),
        FOLDER_TEST(a_newest_file_with_one_wrong_byte_is_overwritten),
        FOLDER_TEST(without_a_whole_file_the_reasons_are_told),
        FOLDER_TEST(a_changed_case_is_refused),
        FOLDER_TEST(another_format_is_refused_and_not_taken_for_damage),
        FOLDER_TEST(other_parts_are_refused),
        FOLDER_TEST(a_part_file_left_by_a_killed_run_does_no_harm),
        FOLDER_TEST(a_run_killed_at_any_moment_leaves_whole_checkpoints),
        FOLDER_TEST(a_full_disk_leaves_both_files),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
