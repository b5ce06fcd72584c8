// A bed spread over ranks has the bits of one process, whatever their number.
#include "step/crew.h"

#include "state/wear.h"

#include "support/bed.h"
#include "support/bits.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

#define STEPS 1500

/** A bed, stepped by rank 0 and those that serve it. */
typedef struct rank_bed {
    bed_kind kind;
    bool ledger;
    bool open; ///< grains leave through a side and an outlet, some are removed, and some come
    bool streams; ///< grains come
    bool wear;    ///< walls have the sums of surfaces
    clod_step_options options;
    scene *into; ///< of rank 0
} rank_bed;

/** Grains leave through a side along x, and into a box in a corner. */
static void open_bed(clod_domain *domain)
{
    domain->periodic[0] = false;
    domain->min[0] = -0.0195;
    domain->max[0] = 0.0199;
    domain->removes = true;
    domain->outlets = 1;
    domain->outlet[0] =
        (clod_outlet){{-1.0, 0.012, -1.0}, {1.0, 1.0, 0.008}, {0.0, 0.0}, 0.0, 0.0};
}

static bool is_free(const clod_grains *grains, const double place[4])
{
    bool free = true;
    for (size_t g = 0; g < grains->count; g++) {
        const double *p = grains->position[g];
        free = free && hypot(hypot(p[0] - place[0], p[1] - place[1]), p[2] - place[2]) >
                           p[3] + place[3];
    }
    return free;
}

/** A small grain comes where there is room; only what is near is looked at. */
static void ask_for_a_grain(clod_step *step, int k)
{
    clod_status status = {0};
    clod_state *state = step->state;
    dice roll = {(uint64_t)k + 77};
    const clod_domain_box box = {{-0.01, -0.01, 0.01}, {0.015, 0.015, 0.05}};
    clod_new_grain grain = {.id = (uint64_t)(2000 + k),
                            .velocity = {-0.5, 1.0, -1.5},
                            .density = 9000.0,
                            .material = 2};
    if (!clod_step_see_near(step, &box, 1, &status)) {
        fail_msg("%s", status.text);
    }
    grain.position[3] = 1.5e-3;
    do {
        for (int a = 0; a < 3; a++) {
            grain.position[a] = dice_real(&roll, box.low[a], box.high[a]);
        }
    } while (!is_free(&state->grains, grain.position));
    clod_changes_add_grain(&state->changes, &grain);
    if (!clod_step_change(step, &status)) {
        fail_msg("%s", status.text);
    }
}

/** Two grains go, and smaller ones come in their places. */
static void ask_for_changes(clod_state *state, int k)
{
    const clod_grains *grains = &state->grains;
    for (int n = 0; n < 2; n++) {
        const size_t row = (grains->count - 1) / (size_t)(n + 1);
        const double *p = grains->position[row];
        const clod_new_grain grain = {.id = (uint64_t)(1000 + 2 * k + n),
                                      .position = {p[0], p[1], p[2], 2e-3},
                                      .velocity = {0.1, 0.2, -0.5},
                                      .density = 2000.0,
                                      .material = 1};
        clod_changes_remove_grain(&state->changes, grains->id[row]);
        clod_changes_add_grain(&state->changes, &grain);
    }
}

static void see(clod_step *step)
{
    clod_status status = {0};
    if (!clod_step_see(step, &status)) {
        fail_msg("%s", status.text);
    }
}

static void run_bed(scene *s, const rank_bed *how)
{
    clod_status status = {0};
    bed_init(s, how->kind, 1);
    if (how->open) {
        open_bed(&s->state.domain);
    }
    for (int32_t w = 0; how->wear && w < s->state.walls.count; w++) {
        assert_true(clod_wear_begin(&s->state.walls.wall[w]));
    }
    scene_start_with(s, how->options);
    if (how->ledger) {
        scene_open_ledger(s);
    }
    for (int k = 0; k < 5; k++) { // looks do not matter
        scene_run(s, STEPS / 5);
        if (how->streams && k < 4) {
            ask_for_a_grain(&s->step, k);
        }
        if (k % 2 == 0 || how->open) {
            see(&s->step);
        }
        if (how->open && k < 4) {
            ask_for_changes(&s->state, k);
        }
    }
    if (!clod_step_export(&s->step, &status)) {
        fail_msg("%s", status.text);
    }
}

static void run_rank(clod_ranks *ranks, void *context)
{
    rank_bed how = *(const rank_bed *)context;
    if (ranks->rank == 0) {
        how.options.ranks = ranks;
        run_bed(how.into, &how);
        clod_crew_end(&how.into->step.crew);
        clod_crew_dismiss(ranks);
    } else {
        clod_crew_serve(ranks);
    }
}

/** Contacts with walls that began, all walls together. */
static double impacts_of(const clod_walls *walls)
{
    double sum = 0.0;
    for (int32_t w = 0; w < walls->count; w++) {
        for (int32_t p = 0; p < walls->wall[w].wear_places; p++) {
            sum += walls->wall[w].wear[p][CLOD_WEAR_IMPACTS];
        }
    }
    return sum;
}

static void compare(rank_bed how)
{
    static const int RANKS[] = {2, 3, 4, 7, 16};
    const size_t counts = how.kind == BED_SLIT && !how.ledger ? 5 : 4; // 16 take long
    const int threads = how.options.threads;
    scene one;
    how.options.threads = 1;
    run_bed(&one, &how);
    how.options.threads = threads;
    assert_true(!how.open || one.state.exchange.left[CLOD_FACES] > 2);
    assert_true(!how.open || one.state.exchange.left[0] + one.state.exchange.left[1] > 2);
    assert_true(!how.wear || impacts_of(&one.state.walls) >= 5.0); // enough to compare
    for (size_t k = 0; k < counts; k++) {
        if (left_out(k, how.kind == BED_SLIT ? 3 : 1)) {
            continue;
        }
        scene several;
        how.into = &several;
        ranks_run(RANKS[k], run_rank, &how);
        assert_true(several.step.rebuilds >= 2);
        assert_int_equal(several.step.rebuilds, one.step.rebuilds);
        check_same_bits(&one.state, &several.state);
        assert_memory_equal(&one.state.exchange, &several.state.exchange,
                            sizeof one.state.exchange);
        scene_end(&several);
    }
    scene_end(&one);
}

static void a_drum_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_DRUM, .options.threads = 1});
}

static void a_periodic_slit_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_SLIT, .options.threads = 1});
}

static void a_cluster_without_walls_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_CLUSTER, .options.threads = 1});
}

static void a_hopper_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_HOPPER, .options.threads = 1});
}

static void the_ledger_has_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_DRUM, .ledger = true, .options.threads = 1});
    compare((rank_bed){.kind = BED_CLUSTER, .ledger = true, .options.threads = 1});
}

static void ranks_with_threads_have_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_SLIT, .ledger = true, .options.threads = 2});
}

static void grains_that_come_and_go_have_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_SLIT, .ledger = true, .open = true, .options.threads = 1});
    compare((rank_bed){.kind = BED_CLUSTER, .open = true, .options.threads = 1});
    compare((rank_bed){.kind = BED_CLUSTER, .open = true, .options.threads = 3});
}

static void grains_that_come_are_dealt_to_their_ranks(void **state)
{
    (void)state;
    compare(
        (rank_bed){.kind = BED_SLIT, .streams = true, .ledger = true, .options.threads = 1});
    compare((rank_bed){.kind = BED_CLUSTER, .streams = true, .options.threads = 1});
}

static void sums_of_surfaces_have_the_bits_of_one_rank(void **state)
{
    (void)state;
    compare((rank_bed){.kind = BED_DRUM, .wear = true, .options.threads = 1});
    compare((rank_bed){.kind = BED_HOPPER, .wear = true, .options.threads = 2});
}

/** A grain with the id of another one is refused, whichever rank has that, and nothing changes. */
static void ask_for_a_double(clod_ranks *ranks, void *context)
{
    rank_bed how = *(const rank_bed *)context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    clod_status status = {0};
    scene *s = how.into;
    bed_init(s, how.kind, 1);
    how.options.ranks = ranks;
    scene_start_with(s, how.options);
    scene_run(s, 10);
    for (uint64_t id = 0; id < 300; id += 60) {
        const clod_new_grain grain = {
            .id = id, .position = {0.0, 0.0, 0.0, 1e-3}, .density = 2000.0};
        clod_changes_add_grain(&s->state.changes, &grain);
        assert_false(clod_step_change(&s->step, &status));
        assert_int_equal(status.code, CLOD_USAGE);
        assert_non_null(strstr(status.text, "another one has this id"));
        assert_int_equal(s->state.exchange.added, 0);
    }
    scene_run(s, 10);
    see(&s->step);
    clod_crew_end(&s->step.crew);
    clod_crew_dismiss(ranks);
}

static void a_grain_with_the_id_of_another_is_refused(void **state)
{
    (void)state;
    scene s;
    rank_bed how = {.kind = BED_CLUSTER, .options.threads = 1, .into = &s};
    ranks_run(3, ask_for_a_double, &how);
    assert_int_equal(s.state.step, 20);
    scene_end(&s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drum_has_the_bits_of_one_rank),
        cmocka_unit_test(a_periodic_slit_has_the_bits_of_one_rank),
        cmocka_unit_test(a_cluster_without_walls_has_the_bits_of_one_rank),
        cmocka_unit_test(a_hopper_has_the_bits_of_one_rank),
        cmocka_unit_test(the_ledger_has_the_bits_of_one_rank),
        cmocka_unit_test(ranks_with_threads_have_the_bits_of_one_rank),
        cmocka_unit_test(grains_that_come_and_go_have_the_bits_of_one_rank),
        cmocka_unit_test(grains_that_come_are_dealt_to_their_ranks),
        cmocka_unit_test(sums_of_surfaces_have_the_bits_of_one_rank),
        cmocka_unit_test(a_grain_with_the_id_of_another_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
