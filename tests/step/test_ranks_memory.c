// A rank that has no memory: in an order that cannot say so all ranks learn of it in the next one; a
// bed that cannot be dealt anew steps no more; one that cannot be spread anew is written all the same.
#include <math.h>
#include <string.h>

#include "measure/contacts.h"
#include "output/checkpoint.h"
#include "step/crew_part.h"

#include "../output/temp_folder.h"
#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"

/** What rank 1 cannot do in its second order of a kind. */
typedef enum lack {
    LACK_MEMORY,  ///< its next allocation fails
    LACK_MESSAGES ///< its next list of messages is not kept
} lack;

typedef struct lacking_bed {
    lack what;
    const char *text; ///< of the failure
    scene *into;      ///< of rank 0
} lacking_bed;

static _Thread_local clod_crew_order_kind kind; ///< orders of a rank that count
static _Thread_local int orders;                ///< how many of them have come
static _Thread_local bool lacks_memory, lacks_messages;
static _Thread_local int asks_before_it; ///< for memory, that are granted

void *__real_aligned_alloc(size_t alignment, size_t size); // the linker names it
void *__wrap_aligned_alloc(size_t alignment, size_t size);

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    const bool lacks = lacks_memory && asks_before_it == 0;
    asks_before_it -= lacks_memory && !lacks;
    lacks_memory = lacks_memory && !lacks;
    return lacks ? NULL : __real_aligned_alloc(alignment, size);
}

/** Whether what came is an order that counts. */
static bool is_order(const clod_message *in, int ins)
{
    clod_crew_order order;
    if (ins != 1 || in->bytes != sizeof order) {
        return false;
    }
    memcpy(&order, in->data, sizeof order);
    return order.what == kind;
}

static bool is_second_order(const clod_ranks *self, const clod_message *in, int ins)
{
    const bool counts = is_order(in, ins);
    orders += counts;
    return self->rank == 1 && counts && orders == 2;
}

static void exchange_without_memory(clod_ranks *self, const clod_message *out, int outs,
                                    const clod_message *in, int ins)
{
    ranks_exchange(self, out, outs, in, ins);
    lacks_memory = lacks_memory || is_second_order(self, in, ins);
}

static void exchange_without_messages(clod_ranks *self, const clod_message *out, int outs,
                                      const clod_message *in, int ins)
{
    ranks_exchange(self, out, outs, in, ins);
    lacks_messages = lacks_messages || is_second_order(self, in, ins);
}

static bool keep(clod_ranks *self, const clod_message *out, int outs, const clod_message *in,
                 int ins)
{
    const bool lacks = lacks_messages;
    lacks_messages = false;
    return !lacks && ranks_keep(self, out, outs, in, ins);
}

/** Rank 0 is to go on; the others have served. */
static bool begin(clod_ranks *ranks, lack what, clod_crew_order_kind order)
{
    kind = order;
    ranks->keep = keep;
    ranks->exchange = what == LACK_MEMORY ? exchange_without_memory : exchange_without_messages;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
    }
    return ranks->rank == 0;
}

/** No step is made. */
static void check_no_step(scene *s, const char *text)
{
    const int64_t step = s->state.step;
    for (int k = 0; k < 2; k++) { // for good
        clod_status status = {0};
        assert_false(clod_step_advance(&s->step, 10, &status));
        assert_int_equal(status.code, CLOD_FAILED);
        assert_non_null(strstr(status.text, text));
    }
    assert_int_equal(s->state.step, step);
}

/** No step is made, and nothing is lost. */
static void check_failure(scene *s, const char *text)
{
    check_no_step(s, text);
    assert_true(clod_step_export(&s->step, &(clod_status){0})); // for a checkpoint of it
}

// ---- the energy ledger

/** It is opened, with a store, and its first row, another one, comes before the first step. */
static void store_without_memory(clod_ranks *ranks, void *context)
{
    const lacking_bed *how = context;
    if (!begin(ranks, how->what, CLOD_CREW_STORE)) {
        return;
    }
    scene *s = how->into;
    bed_init(s, BED_CLUSTER, 1);
    scene_start_with(s, (clod_step_options){.threads = 1, .ranks = ranks});
    scene_open_ledger(s);
    const clod_energies row = clod_step_energies(&s->step);
    assert_true(clod_energies_sum(&row) == s->state.ledger.start);
    check_no_step(s, how->text);
    clod_status status = {0}; // the start is lost: ranks have it, with other columns each
    assert_false(clod_step_export(&s->step, &status));
    assert_non_null(strstr(status.text, how->text));
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

static void check_told(lack what, const char *text)
{
    scene several;
    lacking_bed how = {what, text, &several};
    ranks_run(3, store_without_memory, &how);
    scene_end(&several);
}

static void a_ledger_that_a_rank_has_no_room_for_is_told(void **state)
{
    (void)state;
    check_told(LACK_MEMORY, "no memory for the loads of");
}

static void messages_that_a_rank_has_no_room_for_are_told(void **state)
{
    (void)state;
    check_told(LACK_MESSAGES, "messages between ranks");
}

// ---- sums over the bed

static void sum_without_memory(clod_ranks *ranks, void *context)
{
    const lacking_bed *how = context;
    if (!begin(ranks, how->what, CLOD_CREW_SURVEY)) {
        return;
    }
    scene *s = how->into;
    bed_init(s, BED_CLUSTER, 1);
    scene_start_with(s, (clod_step_options){.threads = 1, .ranks = ranks});
    scene_run(s, 10);
    const clod_survey survey = clod_step_survey(&s->step, NULL);
    assert_true(clod_measure_motion_from(&survey).grains > 300);
    assert_true(isnan(clod_measure_motion_from(&survey).mass));
    check_failure(s, how->text);
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

static void sums_that_a_rank_has_no_room_for_are_told(void **state)
{
    (void)state;
    scene one, several;
    lacking_bed how = {LACK_MEMORY, "no memory for sums over the bed", &several};
    bed_init(&one, BED_CLUSTER, 1);
    scene_start_with(&one, (clod_step_options){.threads = 1});
    scene_run(&one, 10);
    assert_true(clod_step_export(&one.step, &(clod_status){0}));
    ranks_run(3, sum_without_memory, &how);
    check_same_bits(&one.state, &several.state);
    scene_end(&several);
    scene_end(&one);
}

// ---- a bed that is dealt anew

/** A grain is to go after some steps. */
static void change(scene *s, clod_step_options options)
{
    bed_init(s, BED_CLUSTER, 1);
    scene_start_with(s, options);
    const uint64_t goes = s->state.grains.id[0];
    scene_run(s, 200);
    clod_changes_remove_grain(&s->state.changes, goes);
}

static void deal_without_memory(clod_ranks *ranks, void *context)
{
    const lacking_bed *how = context;
    if (!begin(ranks, how->what, CLOD_CREW_BEGIN)) {
        return;
    }
    change(how->into, (clod_step_options){.threads = 1, .ranks = ranks});
    check_failure(how->into, how->text);
    assert_null(how->into->step.crew);
    clod_crew_dismiss(ranks);
}

static void a_bed_that_a_rank_has_no_room_for_steps_no_more(void **state)
{
    (void)state;
    clod_status status = {0};
    scene one, several;
    lacking_bed how = {LACK_MEMORY, "no memory for", &several};
    change(&one, (clod_step_options){.threads = 1});
    assert_true(clod_step_change(&one.step, &status) && clod_step_export(&one.step, &status));
    assert_true(one.state.contact_count > 0);
    ranks_run(3, deal_without_memory, &how);
    check_same_bits(&one.state, &several.state);
    scene_end(&several);
    scene_end(&one);
}

// ---- a bed that is spread anew

static _Thread_local int cuts; ///< of a rank, until it lacks memory; 0: never

void __real_clod_spread_cut(clod_spread *self, const clod_state *state);
void __wrap_clod_spread_cut(clod_spread *self, const clod_state *state);

void __wrap_clod_spread_cut(clod_spread *self, const clod_state *state)
{
    __real_clod_spread_cut(self, state);
    lacks_memory = lacks_memory || cuts == 1;
    cuts -= cuts > 0;
}

typedef struct unspread_bed {
    void **folder;
    int asks;     ///< for memory after the cut, that rank 1 is granted
    bool gathers; ///< before it is written
    bool written;
    char *bytes; ///< of the checkpoint; owned
    size_t size;
    scene *into; ///< of rank 0
} unspread_bed;

static bool write_bed(scene *s, void **folder, clod_status *status)
{
    clod_step_bed view;
    const clod_bed_source bed = clod_step_bed_source(&s->step, &view);
    return clod_checkpoint_write(temp_folder(folder), "restart", &s->state, &bed, NULL, 0, NULL,
                                 status);
}

/** Let the first and the last row of a rank change places, for the order. */
static void change_places(clod_state *state)
{
    double place[4];
    double *first = state->build_position[0];
    double *last = state->build_position[state->grains.count - 1];
    memcpy(place, first, sizeof place);
    memcpy(first, last, sizeof place);
    memcpy(last, place, sizeof place);
}

/** Rows in no order are no reason to wait for ever, nor to write outside of them. */
static void check_told_unsorted(scene *s, void **folder)
{
    clod_status status = {0};
    s->step.failed = false; // as if nobody knew
    assert_true(s->step.crew->stale);
    change_places(&s->step.crew->state);
    assert_false(write_bed(s, folder, &status));
    change_places(&s->step.crew->state);
    assert_string_equal(status.text, "the grains of a rank are not in their order");
    s->step.failed = true;
}

static void spread_without_memory(clod_ranks *ranks, void *context)
{
    unspread_bed *how = context;
    cuts = ranks->rank == 1 ? 3 : 0; // dealt, spread anew once, and then no more
    asks_before_it = ranks->rank == 1 ? how->asks : 0;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    clod_status status = {0};
    scene *s = how->into;
    bed_init(s, BED_CLUSTER, 1);
    scene_start_with(s, (clod_step_options){.threads = 1, .ranks = ranks});
    assert_false(clod_step_advance(&s->step, 10000, &status));
    assert_non_null(strstr(status.text, "no memory"));
    if (how->gathers) {
        assert_true(clod_step_export(&s->step, &status));
    } else if (how->asks == 0) {
        check_told_unsorted(s, how->folder);
    }
    how->written = write_bed(s, how->folder, &status);
    assert_true(s->step.crew->stale != how->written);
    if (how->written) {
        char path[PATH_MAX];
        how->bytes = temp_read(how->folder, "restart_a.h5", &how->size);
        unlink(temp_path(path, how->folder, "restart_a.h5"));
    } else {
        assert_string_equal(status.text, "the bed of steps that failed cannot be gathered");
    }
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

/** The same grains with the same places, in any order. */
static void check_same_places(const clod_state *one, const clod_state *several)
{
    const size_t count = one->grains.count;
    assert_true(count > 300 && several->grains.count == count);
    for (size_t g = 0; g < count; g++) {
        size_t h = 0;
        while (h < count && several->grains.id[h] != one->grains.id[g]) {
            h++;
        }
        assert_true(h < count);
        assert_memory_equal(several->grains.position[h], one->grains.position[g],
                            sizeof *one->grains.position);
    }
}

static void start_one(scene *one)
{
    bed_init(one, BED_CLUSTER, 1);
    scene_start_with(one, (clod_step_options){.threads = 1});
}

static void a_bed_that_cannot_be_spread_is_written(void **folder)
{
    scene one, gathered, written;
    unspread_bed how[2] = {{.folder = folder, .gathers = true, .into = &gathered},
                           {.folder = folder, .into = &written}};
    for (int k = 0; k < 2; k++) {
        ranks_run(3, spread_without_memory, &how[k]);
        assert_true(how[k].written);
    }
    assert_int_equal(how[0].size, how[1].size);
    assert_memory_equal(how[0].bytes, how[1].bytes, how[1].size);
    start_one(&one);
    scene_run(&one, written.state.step + 1); // the next one had moved them
    check_same_places(&one.state, &written.state);
    for (int k = 0; k < 2; k++) {
        clod_memory_free(how[k].bytes);
        scene_end(how[k].into);
    }
    scene_end(&one);
}

/** One process to a step, from the start where it is beyond: measured costs cut a bed, so that the
    same number of asks can end at an earlier step. */
static void go_to(scene *one, int64_t step)
{
    if (one->state.step > step) {
        scene_end(one);
        start_one(one);
    }
    scene_run(one, step - one->state.step);
}

/** Wherever memory ends: the bed is written as it is, or its loss is told. */
static void a_bed_is_written_or_its_loss_told(void **folder)
{
    int written = 0, lost = 0;
    scene one;
    start_one(&one);
    for (int asks = 0; asks < 36; asks++) {
        scene several;
        unspread_bed how = {.folder = folder, .asks = asks, .into = &several};
        ranks_run(3, spread_without_memory, &how);
        if (how.written) {
            go_to(&one, several.state.step + 1);
            check_same_places(&one.state, &several.state);
        }
        written += how.written;
        lost += !how.written;
        clod_memory_free(how.bytes);
        scene_end(&several);
    }
    assert_true(written > 0 && lost > 0);
    scene_end(&one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ledger_that_a_rank_has_no_room_for_is_told),
        cmocka_unit_test(messages_that_a_rank_has_no_room_for_are_told),
        cmocka_unit_test(sums_that_a_rank_has_no_room_for_are_told),
        cmocka_unit_test(a_bed_that_a_rank_has_no_room_for_steps_no_more),
        cmocka_unit_test_setup_teardown(a_bed_that_cannot_be_spread_is_written,
                                        temp_folder_make, temp_folder_remove),
        cmocka_unit_test_setup_teardown(a_bed_is_written_or_its_loss_told, temp_folder_make,
                                        temp_folder_remove),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
