// A rank that has no memory: in an order that cannot say so all ranks learn of it in the next one; a
// bed that cannot be dealt anew steps no more.
#include <string.h>

#include "step/crew_part.h"

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

void *__real_aligned_alloc(size_t alignment, size_t size); // the linker names it
void *__wrap_aligned_alloc(size_t alignment, size_t size);

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    const bool lacks = lacks_memory;
    lacks_memory = false;
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

/** No step is made, and nothing is lost. */
static void check_failure(scene *s, const char *text)
{
    const int64_t step = s->state.step;
    for (int k = 0; k < 2; k++) { // for good
        clod_status status = {0};
        assert_false(clod_step_advance(&s->step, 10, &status));
        assert_int_equal(status.code, CLOD_FAILED);
        assert_non_null(strstr(status.text, text));
    }
    assert_int_equal(s->state.step, step);
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
    check_failure(s, how->text);
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

static void check_told(lack what, const char *text)
{
    scene one, several;
    lacking_bed how = {what, text, &several};
    bed_init(&one, BED_CLUSTER, 1);
    scene_start_with(&one, (clod_step_options){.threads = 1});
    scene_open_ledger(&one);
    assert_true(clod_step_export(&one.step, &(clod_status){0}));
    ranks_run(3, store_without_memory, &how);
    check_same_bits(&one.state, &several.state);
    scene_end(&several);
    scene_end(&one);
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ledger_that_a_rank_has_no_room_for_is_told),
        cmocka_unit_test(messages_that_a_rank_has_no_room_for_are_told),
        cmocka_unit_test(a_bed_that_a_rank_has_no_room_for_steps_no_more),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
