/** What goes wrong with a simulation that several ranks step: its physics, and its owner. */

#include <string.h>

#include "sim/sim.h"
#include "support/sim_ranks.h"

static void break_down(sim_trace *trace, clod_sim *sim, const char *folder)
{
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    clod_sim_view velocity = sim_view(sim, "velocity");
    clod_sim_row(&velocity, 11)[2] = -400.0; // through everything
    assert_false(clod_sim_advance(sim, 200, &status));
    fprintf(trace->out, "%d %s\n", status.code, status.text);
    if (clod_sim_advance(sim, 1, &status)) {
        fputs("it goes on\n", trace->out);
    }
    CHECK(clod_sim_read_checkpoint(sim, folder, NULL, &status));
    advance(sim, 100);
    trace_all(trace, sim, "from the checkpoint before");
}

static void what_went_wrong_is_told(void **state)
{
    (void)state;
    same_on_ranks((sim_life){.live = break_down, .text = SIM_BED, .threads = 1});
}

/** After a request that is refused the ranks go on, and not this process alone. */
static void refused(void *context, clod_ranks *ranks)
{
    (void)context;
    clod_sim *sim = made_on(SIM_BED, 1, ranks);
    advance(sim, 10);
    CHECK(clod_sim_remove_grain(sim, 77777, &status));
    expect_refused(clod_sim_advance(sim, 10, &status), "77777");
    assert_non_null(sim->step.crew);
    advance(sim, 10);
    assert_non_null(sim->step.crew);
    assert_int_equal(clod_sim_step(sim), 20);
    clod_sim_destroy(&sim);
}

static void a_refused_request_leaves_the_bed_with_the_ranks(void **state)
{
    (void)state;
    ranks_crew_run(2, refused, NULL);
}

static void one_at_a_time(void *context, clod_ranks *ranks)
{
    (void)context;
    const clod_sim_options options = {.ranks = ranks};
    for (int k = 0; k < 2; k++) { // one after the other
        clod_sim *sim = made_on(SIM_BED, 1, ranks);
        expect_refused(clod_sim_create_from_text("b.yaml", SIM_BED, &options, &status) != NULL,
                       "one at a time");
        advance(sim, 10);
        clod_sim_destroy(&sim);
    }
    clod_sim *sim = clod_sim_create_from_text("b.yaml", "title: nothing\n", &options, &status);
    assert_null(sim); // the ranks are free after it
    sim = made_on(SIM_BED, 1, ranks);
    clod_sim_destroy(&sim);
}

static void ranks_have_one_simulation_at_a_time(void **state)
{
    (void)state;
    ranks_crew_run(1, one_at_a_time, NULL);
    ranks_crew_run(2, one_at_a_time, NULL);
}

static void another_rank(clod_ranks *ranks, void *context)
{
    (void)context;
    const clod_sim_options options = {.ranks = ranks};
    if (ranks->rank == 1) { // nobody waits
        clod_status mine = {0};
        assert_null(clod_sim_create_from_text("b.yaml", SIM_BED, &options, &mine));
        assert_int_equal(mine.code, CLOD_USAGE);
        assert_non_null(strstr(mine.text, "this is rank 1 of 2"));
    }
}

static void rank_0_alone_drives(void **state)
{
    (void)state;
    ranks_run(2, another_rank, NULL);
}

/** Ranks of one process that are closed under a simulation. */
static void closed_ranks_leave_it_to_read(void **state)
{
    (void)state;
    void *folder;
    assert_int_equal(temp_folder_make(&folder), 0);
    clod_ranks *ranks = clod_ranks_open(&status);
    assert_non_null(ranks);
    clod_sim *sim = made_on(SIM_BED, 1, ranks);
    advance(sim, 100);
    CHECK(clod_sim_write_checkpoint(sim, folder, &status));
    clod_ranks_close(&ranks);
    assert_null(ranks);
    assert_int_equal(sim_view(sim, "position").rows, 240);
    expect_refused(clod_sim_advance(sim, 1, &status), "ranks of this simulation were closed");
    CHECK(clod_sim_read_checkpoint(sim, folder, NULL, &status));
    advance(sim, 1);
    clod_sim_destroy(&sim);
    temp_folder_remove(&folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_went_wrong_is_told),
        cmocka_unit_test(a_refused_request_leaves_the_bed_with_the_ranks),
        cmocka_unit_test(ranks_have_one_simulation_at_a_time),
        cmocka_unit_test(rank_0_alone_drives),
        cmocka_unit_test(closed_ranks_leave_it_to_read),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
