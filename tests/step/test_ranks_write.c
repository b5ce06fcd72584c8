// Ranks that write one checkpoint side by side: where one of them does not see the file rank 0 writes it alone,
// to the same bytes; where one has no memory or its disk is full all fail with that, and what was complete stays.
#include <errno.h>

#include "output/checkpoint.h"
#include "output/file.h"
#include "step/crew_part.h"

#include "../output/temp_folder.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_crew.h"
#include "support/sanitized.h"

#define RANKS 3

/** What goes wrong on one rank. */
typedef enum fault { NOTHING, OPENS, SWAPS, WRITES, SYNCS, ASKS } fault;

static fault what;                 ///< it is
static int whose;                  ///< rank
static int granted;                ///< of its calls before it
static bool came;                  ///< it came to that
static const char *other;          ///< path of a file in place of the one that is opened
static _Thread_local int own = -1; ///< rank of this thread

/** Whether this call fails. One rank alone counts. */
static bool fails(fault kind)
{
    if (kind != what || own != whose) {
        return false;
    }
    const bool now = granted == 0;
    granted -= granted >= 0;
    came = came || now;
    return now;
}

void *__real_aligned_alloc(size_t alignment, size_t size); // the linker names them
void *__wrap_aligned_alloc(size_t alignment, size_t size);
int __real_clod_file_open(int folder, const char *name, int flags);
int __wrap_clod_file_open(int folder, const char *name, int flags);
int __real_clod_file_write_at(int descriptor, uint64_t at, const void *bytes, size_t size);
int __wrap_clod_file_write_at(int descriptor, uint64_t at, const void *bytes, size_t size);
int __real_clod_file_sync(int descriptor);
int __wrap_clod_file_sync(int descriptor);

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return fails(ASKS) ? NULL : __real_aligned_alloc(alignment, size);
}

int __wrap_clod_file_open(int folder, const char *name, int flags)
{
    if (fails(OPENS)) {
        errno = ENOENT;
        return -1;
    }
    if (fails(SWAPS)) { // another file of the same name, as on another machine
        return __real_clod_file_open(folder, other, flags & ~O_NOFOLLOW);
    }
    return __real_clod_file_open(folder, name, flags);
}

int __wrap_clod_file_write_at(int descriptor, uint64_t at, const void *bytes, size_t size)
{
    return fails(WRITES) ? ENOSPC : __real_clod_file_write_at(descriptor, at, bytes, size);
}

int __wrap_clod_file_sync(int descriptor)
{
    return fails(SYNCS) ? EDQUOT : __real_clod_file_sync(descriptor);
}

// ---- a bed that is written three times, the second time with a fault

typedef struct faulty_bed {
    void **folder;
    bool large; ///< two slabs
    fault kind;
    int rank, after;
    bool good, came; ///< [out] of the second time
    clod_status status;
    char *bytes[3]; ///< owned; NULL: not written
    size_t size[3];
} faulty_bed;

static bool write_one(scene *s, void **folder, clod_status *status)
{
    clod_step_bed view;
    const clod_bed_source bed = clod_step_bed_source(&s->step, &view);
    return clod_checkpoint_write(temp_folder(folder), "restart", &s->state, &bed, NULL, 0, NULL,
                                 status);
}

static void read_one(faulty_bed *how, int k)
{
    how->bytes[k] =
        temp_read(how->folder, k == 1 ? "restart_b.h5" : "restart_a.h5", &how->size[k]);
}

#define EDGE 30 ///< grains along each edge of a large bed
#define RADIUS 1e-3

/** Grains in a lattice that touch along z, or a sheared bed. */
static void make_bed(scene *s, bool large, clod_ranks *ranks)
{
    const clod_step_options options = {.threads = 1, .ranks = ranks};
    if (!large) {
        bed_init(s, BED_SLIT, 1);
        scene_start_with(s, options);
        scene_run(s, 60);
        return;
    }
    const clod_case_contact ore = contact_ore();
    scene_init(s, 1e-7, &ore);
    for (int k = 0; k < EDGE * EDGE * EDGE; k++) {
        const int x = k % EDGE, y = k / EDGE % EDGE, z = k / (EDGE * EDGE);
        scene_grain(s, 2.1 * RADIUS * x, 2.1 * RADIUS * y, 1.999 * RADIUS * z, RADIUS);
    }
    scene_start_with(s, options);
    scene_run(s, 2);
}

static void write_three(void *context, clod_ranks *ranks)
{
    faulty_bed *how = context;
    scene s;
    clod_status status = {0};
    make_bed(&s, how->large, ranks);
    if (!write_one(&s, how->folder, &status)) {
        fail_msg("%s", status.text);
    }
    read_one(how, 0);
    came = false;
    whose = how->rank;
    granted = how->after;
    what = how->kind;
    how->good = write_one(&s, how->folder, &how->status);
    what = NOTHING;
    how->came = came;
    if (how->good) {
        read_one(how, 1);
    } else { // the first is untouched, and nothing is left of the second
        assert_int_equal(how->status.code, CLOD_FAILED);
        read_one(how, 2);
        assert_int_equal(how->size[2], how->size[0]);
        assert_memory_equal(how->bytes[2], how->bytes[0], how->size[0]);
        clod_memory_free(how->bytes[2]);
        char path[PATH_MAX];
        assert_int_not_equal(access(temp_path(path, how->folder, "restart_b.h5"), F_OK), 0);
        assert_int_not_equal(access(temp_path(path, how->folder, "restart_b.h5.part"), F_OK),
                             0);
        status = (clod_status){0};
        if (!write_one(&s, how->folder, &status)) { // and it can be written again
            fail_msg("%s", status.text);
        }
        read_one(how, 1);
    }
    char path[PATH_MAX];
    unlink(temp_path(path, how->folder, "restart_a.h5"));
    unlink(temp_path(path, how->folder, "restart_b.h5"));
    clod_crew_end(&s.step.crew);
    scene_end(&s);
}

static void run_rank(clod_ranks *ranks, void *context)
{
    own = ranks->rank;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
    } else {
        write_three(context, ranks);
        clod_crew_dismiss(ranks);
    }
    own = -1;
}

/** Both files have the bytes of one process, whatever went wrong between. */
static void run_with(faulty_bed *how, const faulty_bed *one)
{
    ranks_run(RANKS, run_rank, how);
    for (int k = 0; k < 2; k++) {
        assert_int_equal(how->size[k], one->size[k]);
        assert_memory_equal(how->bytes[k], one->bytes[k], one->size[k]);
        clod_memory_free(how->bytes[k]);
    }
}

static faulty_bed write_alone(void **folder, bool large)
{
    faulty_bed one = {.folder = folder, .large = large};
    write_three(&one, NULL);
    return one;
}

static void free_alone(faulty_bed *one)
{
    clod_memory_free(one->bytes[0]);
    clod_memory_free(one->bytes[1]);
}

/** With a fault at each of a rank's calls of a kind, until there is none more, with sanitizers at some.  Returns how many there were. */
static int try_each(void **folder, fault kind, int rank, bool good)
{
    faulty_bed one = write_alone(folder, false);
    const int apart = !sanitized() ? 1 : kind == ASKS ? 7 : kind == WRITES ? 3 : 1;
    int after = 0, alone = 0;
    bool more = true;
    for (; more; after += apart) {
        faulty_bed how = {.folder = folder, .kind = kind, .rank = rank, .after = after};
        run_with(&how, &one);
        more = how.came;
        if (!good && more && kind == ASKS) {
            assert_true(how.good || strstr(how.status.text, "emory") != NULL);
        } else if (!good && more && how.good) { // the mark of a draft: rank 0 wrote it alone
            assert_true(kind == WRITES && rank == 0 && alone++ == 0);
        } else if (!good && more) {
            assert_non_null(strstr(how.status.text, "restart_b.h5: "));
            assert_non_null(
                strstr(how.status.text, strerror(kind == WRITES ? ENOSPC : EDQUOT)));
            assert_non_null(strstr(how.status.text, "Free some space"));
        } else {
            assert_true(how.good);
        }
    }
    free_alone(&one);
    return after - apart;
}

static void a_rank_that_does_not_see_the_file_leaves_it_to_rank_0(void **folder)
{
    assert_in_range(try_each(folder, OPENS, 1, true), 3, 3); // to write, and twice to hash
}

static void a_full_disk_of_a_rank_is_told_by_all(void **folder)
{
    assert_true(try_each(folder, WRITES, 1, false) ==
                0); // the bed has one slab, that of rank 0
    assert_in_range(try_each(folder, WRITES, 0, false), 20, 200);
    assert_in_range(try_each(folder, SYNCS, 2, false), 1, 1);
}

static void a_rank_without_memory_is_told_by_all(void **folder)
{
    for (int rank = 0; rank < RANKS; rank += sanitized() ? 2 : 1) {
        assert_in_range(try_each(folder, ASKS, rank, false), 5, 2000);
    }
}

/** Rank 1 sees another file: its bytes, size and head are those of a copy of an earlier one. */
static void a_rank_that_sees_another_file_leaves_it_to_rank_0(void **folder)
{
    char path[PATH_MAX];
    faulty_bed one = write_alone(folder, false);
    temp_write(folder, "other", one.bytes[1], one.size[1]);
    other = temp_path(path, folder, "other");
    free_alone(&one);
    assert_in_range(try_each(folder, SWAPS, 1, true), 3, 3);
    size_t size;
    char *bytes = temp_read(folder, "other", &size);
    assert_int_equal(size, one.size[1]); // nobody wrote into it
    clod_memory_free(bytes);
}

static void faults_of_a_rank_that_has_a_slab(void **folder)
{
    static const int AFTER[] = {0, 8, 15}; // calls that write
    faulty_bed one = write_alone(folder, true);
    assert_true(one.size[0] > RANKS * CLOD_FILE_BLOCK);
    for (size_t k = 0; k < sizeof AFTER / sizeof *AFTER; k += sanitized() ? 2 : 1) {
        faulty_bed how = {
            .folder = folder, .large = true, .kind = WRITES, .rank = 1, .after = AFTER[k]};
        run_with(&how, &one);
        assert_true(how.came);
        assert_false(how.good);
        assert_non_null(strstr(how.status.text, strerror(ENOSPC)));
    }
    free_alone(&one);
}

#define FOLDER_TEST(name)                                                                      \
    cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        FOLDER_TEST(a_rank_that_does_not_see_the_file_leaves_it_to_rank_0),
        FOLDER_TEST(a_rank_that_sees_another_file_leaves_it_to_rank_0),
        FOLDER_TEST(faults_of_a_rank_that_has_a_slab),
        FOLDER_TEST(a_full_disk_of_a_rank_is_told_by_all),
        FOLDER_TEST(a_rank_without_memory_is_told_by_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
