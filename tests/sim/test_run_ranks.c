// Whole runs of cases on ranks that are threads, groups of ranks among them: the files of one process,
// where ThreadSanitizer and a debugger see all ranks.
#include <dirent.h>
#include <stdio.h>
#include <string.h>

#include "base/memory.h"
#include "clod/run.h"
#include "output/folder_files.h"
#include "output/temp_folder.h"
#include "sim/ranks.h"
#include "step/crew.h"
#include "support/check.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

#define OVERRIDES 8

/** A run of a case of the tests. */
typedef struct whole_run {
    const char *file, *overrides[OVERRIDES];
    const char *from; ///< folder of another run; NULL: none
    char folder[PATH_MAX];
} whole_run;

static void run_case(const whole_run *self, clod_ranks *ranks)
{
    char path[PATH_MAX];
    clod_status status = {0};
    char *report = NULL;
    size_t overrides = 0;
    while (overrides < OVERRIDES && self->overrides[overrides] != NULL) {
        overrides++;
    }
    snprintf(path, sizeof path, "%s/tests/%s", CLOD_SOURCE_DIR, self->file);
    clod_case *from = clod_case_load(path, self->overrides, overrides, &status);
    const clod_run_options options = {
        .directory = self->folder, .from = self->from, .threads = 1, .ranks = ranks};
    if (from == NULL || !clod_run(from, &options, &report, &status)) {
        fail_msg("%s", status.text);
    }
    clod_run_free(report);
    clod_case_destroy(&from);
}

static atomic_int splits;

static bool split(clod_ranks *self, int colour, clod_ranks *part, clod_status *status)
{
    atomic_fetch_add(&splits, 1);
    return ranks_split(self, colour, part, status);
}

static void run_rank(clod_ranks *ranks, void *context)
{
    ranks->split = split;
    if (ranks->rank > 0) {
        clod_ranks_serve(ranks);
        return;
    }
    run_case(context, ranks);
    clod_crew_dismiss(ranks);
    clod_ranks_word(ranks, CLOD_RANKS_LEAVE);
}

/** Whether a file has the time of the clock in it, or the path of its folder. */
static bool has_clock_or_folder(const char *name)
{
    static const char *const STARTS[] = {".", "log", "summary", "report", "restart"};
    bool found = strstr(name, ".pvsm") != NULL;
    for (size_t k = 0; k < sizeof STARTS / sizeof *STARTS; k++) {
        found = found || strncmp(name, STARTS[k], strlen(STARTS[k])) == 0;
    }
    return found;
}

static void check_same_file(const clod_folder *one, const clod_folder *other, const char *name)
{
    void *bytes[2];
    size_t size[2];
    clod_status status = {0};
    assert_true(clod_folder_read(one, name, &bytes[0], &size[0], &status));
    assert_true(clod_folder_read(other, name, &bytes[1], &size[1], &status));
    if (bytes[1] == NULL || size[0] != size[1] || memcmp(bytes[0], bytes[1], size[0]) != 0) {
        fail_msg("%s is another file", name);
    }
    clod_memory_free(bytes[0]);
    clod_memory_free(bytes[1]);
}

/** Tables and pictures of two folders are the same bytes. @return how many */
static int check_same_files(const char *one, const char *other)
{
    clod_status status = {0};
    clod_folder *first = clod_folder_look(one, &status);
    clod_folder *second = clod_folder_look(other, &status);
    assert_true(first != NULL && second != NULL);
    DIR *all = opendir(one);
    int files = 0;
    assert_non_null(all);
    for (struct dirent *entry; (entry = readdir(all)) != NULL;) {
        if (!has_clock_or_folder(entry->d_name)) {
            check_same_file(first, second, entry->d_name);
            files++;
        }
    }
    closedir(all);
    clod_folder_close(&first);
    clod_folder_close(&second);
    return files;
}

/** Run the case alone and on so many ranks. */
static void compare(void **state, whole_run run, int ranks, int files)
{
    whole_run several = run;
    const char *kind = run.from != NULL ? "-from" : "";
    snprintf(run.folder, sizeof run.folder, "%s/one%s", (const char *)*state, kind);
    snprintf(several.folder, sizeof several.folder, "%s/ranks-%d%s", (const char *)*state,
             ranks, kind);
    run_case(&run, NULL);
    ranks_run(ranks, run_rank, &several);
    assert_true(check_same_files(run.folder, several.folder) >= files);
}

/** Ranks of a bed; with sanitizers only the chute is run, which has inlets, an outlet, a mesh and those that leave. */
static int many(void)
{
    return sanitized() ? 3 : 16;
}

static void a_drum_of_a_mesh_is_the_same_on_ranks(void **state)
{
    if (sanitized()) {
        skip(); // the others are enough there
    }
    compare(state, (whole_run){.file = "parallel/drum.yaml"}, many(), 15);
}

static void a_hopper_that_empties_is_the_same_on_ranks(void **state)
{
    if (sanitized()) {
        skip();
    }
    compare(state, (whole_run){.file = "parallel/hopper.yaml"}, many(), 10);
}

static void a_chute_that_is_empty_between_is_the_same_on_ranks(void **state)
{
    if (looks_for_races()) {
        skip(); // step/test_ranks has streams, step/test_ranks_empty beds without grains
    }
    compare(state, (whole_run){.file = "parallel/chute.yaml"}, many(), 10);
}

/** Two seeds, on two groups, of one rank and of two; then from these fillings. */
static void seeds_on_groups_are_the_same(void **state)
{
    whole_run run = {.file = "parallel/wall_friction.yaml",
                     .overrides = {"wall_friction.seeds=2", "wall_friction.shear_min=1 mm",
                                   "wall_friction.shear_max=1.5 mm",
                                   "wall_friction.block_displacement=0.2 mm",
                                   "output.contacts=false", "output.snapshot_interval=0.2 s",
                                   "output.checkpoint_interval=1 s"}}; // on the clock
    char first[PATH_MAX];
    atomic_store(&splits, 0);
    compare(state, run, 3, 20);
    assert_int_equal(atomic_load(&splits), 2 * 3); // fillings and shear tests, by each rank
    if (looks_for_races()) {
        return; // the same groups do less
    }
    snprintf(first, sizeof first, "%s/one", (const char *)*state);
    run.from = first;
    run.overrides[7] = "wall_friction.wall_stresses=[1 kPa, 0.8 kPa]";
    atomic_store(&splits, 0);
    compare(state, run, 3, 20);
    assert_int_equal(atomic_load(&splits), 3); // fillings are taken over by rank 0
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_drum_of_a_mesh_is_the_same_on_ranks),
        TEST(a_hopper_that_empties_is_the_same_on_ranks),
        TEST(a_chute_that_is_empty_between_is_the_same_on_ranks),
        TEST(seeds_on_groups_are_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
