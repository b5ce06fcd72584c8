// A bed that ranks have is written slab by slab: the same bytes as of one process, and rank 0 never has
// all of it.
#include "output/checkpoint.h"
#include "output/hdf.h"
#include "output/snapshot.h"
#include "step/crew_part.h"

#include "../output/temp_folder.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_crew.h"
#include "support/sanitized.h"

// ---- what rank 0 asks for

static _Thread_local bool writes;        ///< the thread is rank 0, and writes
static _Thread_local size_t largest_ask; ///< bytes that it asked for at once

void *__real_aligned_alloc(size_t alignment, size_t size); // the linker names it
void *__wrap_aligned_alloc(size_t alignment, size_t size);

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    if (writes && size > largest_ask) {
        largest_ask = size;
    }
    return __real_aligned_alloc(alignment, size);
}

// ---- files

#define FILES 3

typedef struct files {
    char *bytes[FILES]; ///< checkpoint, picture of grains, picture of contacts; owned
    size_t size[FILES];
} files;

typedef struct written_bed {
    bed_kind kind;
    bool ledger, clumps;
    int threads;
    void **folder;
    files to[2]; ///< in the middle and at the end; of rank 0
} written_bed;

static void take(void **folder, const char *name, char **bytes, size_t *size)
{
    char path[PATH_MAX];
    *bytes = temp_read(folder, name, size);
    unlink(temp_path(path, folder, name));
}

static void write_files(scene *s, void **folder, files *to)
{
    clod_status status = {0};
    clod_step_bed view;
    clod_snapshot_film film = {{0}};
    const clod_bed_source bed = clod_step_bed_source(&s->step, &view);
    writes = true;
    if (!clod_checkpoint_write(temp_folder(folder), "restart", &s->state, &bed, NULL, 0, NULL,
                               &status) ||
        !clod_snapshot_write(temp_folder(folder), "run", 0, &s->state, &bed, true, &film,
                             &status)) {
        fail_msg("%s", status.text);
    }
    writes = false;
    take(folder, "restart_a.h5", &to->bytes[0], &to->size[0]);
    take(folder, "snap_000000.hdf", &to->bytes[1], &to->size[1]);
    take(folder, "contacts_000000.hdf", &to->bytes[2], &to->size[2]);
}

static void run_bed(void *context, clod_ranks *ranks)
{
    written_bed *how = context;
    scene s;
    bed_init(&s, how->kind, 1);
    if (how->clumps) {
        assert_true(clod_grains_keep_clumps(&s.state.grains, &(clod_status){0}));
        for (size_t g = 0; g < s.state.grains.count; g++) {
            s.state.grains.clump[g].number = 1000 - g;
            s.state.grains.clump[g].size = (int32_t)g;
        }
    }
    scene_start_with(&s, (clod_step_options){.threads = how->threads, .ranks = ranks});
    if (how->ledger) {
        scene_open_ledger(&s);
    }
    for (int k = 0; k < 2; k++) {
        scene_run(&s, 800);
        write_files(&s, how->folder, &how->to[k]);
        assert_true(ranks == NULL || s.step.crew->stale); // nothing was gathered
        assert_true(ranks == NULL || s.state.grains.count == 0);
    }
    clod_crew_end(&s.step.crew);
    scene_end(&s);
}

static void free_files(files *self)
{
    for (int f = 0; f < FILES; f++) {
        clod_memory_free(self->bytes[f]);
    }
}

static void compare(written_bed how)
{
    static const int RANKS[] = {2, 3, 4, 7};
    written_bed one = how;
    run_bed(&one, NULL);
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        if (left_out(k, how.kind == BED_SLIT ? 3 : 1)) {
            continue;
        }
        ranks_crew_run(RANKS[k], run_bed, &how);
        for (int n = 0; n < 2; n++) {
            for (int f = 0; f < FILES; f++) {
                assert_int_equal(how.to[n].size[f], one.to[n].size[f]);
                assert_memory_equal(how.to[n].bytes[f], one.to[n].bytes[f], one.to[n].size[f]);
            }
            free_files(&how.to[n]);
        }
    }
    free_files(&one.to[0]);
    free_files(&one.to[1]);
}

static void files_of_a_slit(void **folder)
{
    compare((written_bed){.kind = BED_SLIT, .threads = 1, .folder = folder});
}

static void files_of_a_drum_with_ledger_and_clumps(void **folder)
{
    compare((written_bed){
        .kind = BED_DRUM, .ledger = true, .clumps = true, .threads = 1, .folder = folder});
}

static void files_of_a_hopper_on_two_threads_each(void **folder)
{
    compare((written_bed){.kind = BED_HOPPER, .threads = 2, .folder = folder});
}

static void files_of_a_cluster(void **folder)
{
    compare((written_bed){.kind = BED_CLUSTER, .threads = 1, .folder = folder});
}

// ---- a bed of several slabs

#define EDGE 40 ///< grains along each edge: four slabs
#define RADIUS 1e-3

typedef struct large_bed {
    void **folder;
    files to;
    size_t largest; ///< that rank 0 asked for while it wrote
} large_bed;

/** Grains in a lattice that touch along z. */
static void make_large(scene *s, clod_ranks *ranks)
{
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-7, &ore);
    for (int k = 0; k < EDGE * EDGE * EDGE; k++) {
        const int x = k % EDGE, y = k / EDGE % EDGE, z = k / (EDGE * EDGE);
        scene_grain(s, 2.1 * RADIUS * x, 2.1 * RADIUS * y, 1.999 * RADIUS * z, RADIUS);
    }
    scene_start_with(s, (clod_step_options){.threads = 1, .ranks = ranks});
    scene_run(s, 2);
}

static void write_large(void *context, clod_ranks *ranks)
{
    large_bed *how = context;
    scene s;
    make_large(&s, ranks);
    largest_ask = 0;
    write_files(&s, how->folder, &how->to);
    how->largest = largest_ask;
    clod_crew_end(&s.step.crew);
    scene_end(&s);
}

static void a_bed_of_several_slabs(void **folder)
{
    large_bed one = {.folder = folder}, several = {.folder = folder};
    write_large(&one, NULL);
    for (int ranks = sanitized() ? 7 : 2; ranks <= 7; ranks += 5) {
        ranks_crew_run(ranks, write_large, &several);
        for (int f = 0; f < FILES; f++) {
            assert_int_equal(several.to.size[f], one.to.size[f]);
            assert_memory_equal(several.to.bytes[f], one.to.bytes[f], one.to.size[f]);
        }
        // no message, list or column is larger than a slab with all that belongs to a row
        assert_in_range(several.largest, 1, 300 * CLOD_HDF_SLAB);
        free_files(&several.to);
    }
    free_files(&one.to);
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(files_of_a_slit),
        FOLDER_TEST(files_of_a_drum_with_ledger_and_clumps),
        FOLDER_TEST(files_of_a_hopper_on_two_threads_each),
        FOLDER_TEST(files_of_a_cluster),
        FOLDER_TEST(a_bed_of_several_slabs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
