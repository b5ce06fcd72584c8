// A checkpoint that several ranks get while it is read: the run goes on with the bits of one process,
// with contacts and their histories, the energy ledger and clumps.
#include "sim/deal.h"

#include "output/checkpoint.h"
#include "step/crew.h"

#include "../output/temp_folder.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

#define BEFORE 900 ///< steps
#define AFTER 500

/** A run that goes on from a checkpoint. */
typedef struct again_bed {
    bed_kind kind;
    void **folder;
    size_t most_rows; ///< of rank 0 while the file is read
    bool foreign;     ///< a contact of a grain that nobody has is among them
    const char *text; ///< that it fails with; NULL: it goes on
    scene *into;      ///< of rank 0
} again_bed;

/** The checkpoint of a bed that has been stepped. */
static void write_bed(bed_kind kind, void **folder)
{
    scene s;
    clod_status status = {0};
    bed_init(&s, kind, 1);
    scene_start(&s);
    scene_open_ledger(&s);
    assert_true(clod_grains_keep_clumps(&s.state.grains, &status));
    for (size_t g = 0; g < s.state.grains.count; g++) {
        s.state.grains.clump[g].since = (double)s.state.grains.id[g];
    }
    scene_run(&s, BEFORE);
    clod_step_bed view;
    const clod_bed_source bed = clod_step_bed_source(&s.step, &view);
    if (!clod_checkpoint_write(temp_folder(folder), "restart", &s.state, &bed, NULL, 0, NULL,
                               &status)) {
        fail_msg("%s", status.text);
    }
    scene_end(&s);
}

/** Read it, into the state or for somebody. */
static void read_bed(scene *s, bed_kind kind, void **folder, const clod_bed_taker *taker)
{
    char notice[256];
    clod_status status = {0};
    const clod_checkpoint_wanted wanted = {.taker = taker};
    bed_init(s, kind, 1); // its walls
    if (!clod_checkpoint_get(temp_folder(folder), "restart", &s->state, &wanted, notice,
                             sizeof notice, &status)) {
        fail_msg("%s", status.text);
    }
}

static void finish(scene *s)
{
    clod_status status = {0};
    scene_run(s, AFTER);
    if (!clod_step_export(&s->step, &status)) {
        fail_msg("%s", status.text);
    }
}

/** A contact whose first grain is in no bed of these. */
static void deal_foreign(clod_ranks *ranks, clod_crew_share *share)
{
    clod_status status = {0};
    const clod_contact contact = {.shape = -1};
    const uint64_t partners[1][2] = {{123456789, 1}};
    assert_true(clod_crew_deal_contacts(ranks, share, &contact, partners, 1, &status));
}

static void go_on(clod_ranks *ranks, void *context)
{
    again_bed *how = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    scene *s = how->into;
    clod_deal deal;
    clod_status status = {0};
    clod_crew_share share = {0};
    const int64_t finished = 0;
    const clod_bed_taker *taker = clod_deal_again(&deal, ranks, &share, &finished);
    assert_non_null(taker);
    read_bed(s, how->kind, how->folder, taker);
    how->most_rows = s->state.grains.count;
    if (how->foreign) {
        deal_foreign(ranks, &share);
    }
    const clod_step_options options = {.threads = 1, .ranks = ranks, .dealt = &share};
    const bool good = clod_step_init(&s->step, &s->state, &s->laws, &options, &status);
    assert_int_equal(good, how->text == NULL);
    if (good) {
        finish(s);
    } else {
        assert_non_null(strstr(status.text, how->text));
    }
    clod_crew_end(&s->step.crew);
    clod_crew_share_fini(&share);
    clod_deal_fini(&deal);
    clod_crew_dismiss(ranks);
}

static void check_same_clumps(const clod_grains *one, const clod_grains *several)
{
    for (size_t g = 0; g < one->count; g++) {
        assert_true(one->clump[g].since == (double)one->id[g]);
        assert_true(several->clump[g].since == one->clump[g].since);
    }
}

static void compare(bed_kind kind, void **folder)
{
    static const int RANKS[] = {2, 3, 4, 7};
    scene one, several;
    write_bed(kind, folder);
    read_bed(&one, kind, folder, NULL);
    assert_true(one.state.contact_count > 100);
    scene_start(&one);
    finish(&one);
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k += sanitized() ? 2 : 1) {
        again_bed how = {.kind = kind, .folder = folder, .into = &several};
        ranks_run(RANKS[k], go_on, &how);
        assert_in_range(how.most_rows, 1, one.state.grains.count / (size_t)RANKS[k] + 1);
        check_same_bits(&one.state, &several.state);
        check_same_clumps(&one.state.grains, &several.state.grains);
        scene_end(&several);
    }
    scene_end(&one);
}

static void a_drum_goes_on_with_the_bits_of_one_process(void **folder)
{
    compare(BED_DRUM, folder);
}

static void a_periodic_slit_goes_on_with_the_bits_of_one_process(void **folder)
{
    compare(BED_SLIT, folder);
}

static void a_cluster_goes_on_with_the_bits_of_one_process(void **folder)
{
    compare(BED_CLUSTER, folder);
}

static void a_hopper_goes_on_with_the_bits_of_one_process(void **folder)
{
    compare(BED_HOPPER, folder);
}

/** A run that is finished is kept whole, to be reported. */
static void a_finished_run_is_not_dealt(void **folder)
{
    scene one, kept;
    clod_deal deal;
    clod_crew_share share = {0};
    const int64_t finished = 1;
    clod_ranks two = {.size = 2}; // that nobody calls
    write_bed(BED_CLUSTER, folder);
    read_bed(&one, BED_CLUSTER, folder, NULL);
    read_bed(&kept, BED_CLUSTER, folder, clod_deal_again(&deal, &two, &share, &finished));
    check_same_bits(&one.state, &kept.state);
    clod_deal_fini(&deal);
    scene_end(&one);
    scene_end(&kept);
}

static void a_contact_of_no_grain_is_told(void **folder)
{
    scene s;
    again_bed how = {.kind = BED_CLUSTER,
                     .folder = folder,
                     .foreign = true,
                     .text = "contacts of grains that it does not have",
                     .into = &s};
    write_bed(BED_CLUSTER, folder);
    ranks_run(3, go_on, &how);
    scene_end(&s);
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, temp_folder_make, temp_folder_remove)

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(a_drum_goes_on_with_the_bits_of_one_process),
        TEST(a_periodic_slit_goes_on_with_the_bits_of_one_process),
        TEST(a_cluster_goes_on_with_the_bits_of_one_process),
        TEST(a_hopper_goes_on_with_the_bits_of_one_process),
        TEST(a_finished_run_is_not_dealt),
        TEST(a_contact_of_no_grain_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
