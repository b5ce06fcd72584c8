// Grains of a free run that several ranks get while they are made: the bed of one process, bit by bit,
// and no rank ever has all of it.
#include "dealt_bed.h"

// ---- beds

/** Two groups in layers: the second finds its places between and above the grains of the first. A
 *  loaded lid is damped by what all of them weigh. */
static const char LAYERS[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [30 mm, 30 mm, 90 mm], periodic: [true, true, false]}\n"
    "grains:\n"
    "  - material: ore\n    count: 1500\n    radius: {distribution: uniform, min: 0.9 mm, max: 1 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 1 mm], max: [30 mm, 30 mm, 17 mm]}}\n"
    "    velocity: [0 m/s, 0.1 m/s, -1 m/s]\n"
    "  - material: sand\n    mass: 30 g\n    radius: {distribution: uniform, min: 1.28 mm, max: 1.3 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 12 mm], max: [30 mm, 30 mm, 50 mm]}}\n" FLOOR
    "  lid:\n    material: steel\n"
    "    load: {force: 2 N, axis: [0, 0, -1], mass: 50 g, damping: 0.5}\n"
    "    shapes: [{disc: {center: [15 mm, 15 mm, 80 mm], normal: [0, 0, -1], radius: 12 mm}}]\n" STAGES;

/** Rings about a post, and grains at random among them; no domain is given. */
static const char RINGS[] = MATERIALS
    "grains:\n"
    "  - material: ore\n    count: 900\n    radius: {distribution: uniform, min: 0.95 mm, max: 1 mm}\n"
    "    region: {annulus: {center: [0 mm, 0 mm, 1 mm], inner_radius: 4 mm, outer_radius: 14 mm, height: 17 mm}}\n"
    "  - material: sand\n    count: 300\n    radius: {distribution: uniform, min: 0.6 mm, max: 1.2 mm}\n"
    "    region: {box: {min: [-16 mm, -16 mm, 4 mm], max: [16 mm, 16 mm, 40 mm]}}\n" FLOOR
        STAGES;

/** Fewer grains than ranks. */
static const char FEW[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [30 mm, 30 mm, 90 mm]}\n"
    "grains:\n"
    "  - material: ore\n    count: 3\n    radius: {distribution: uniform, min: 0.9 mm, max: 1 mm}\n"
    "    region: {box: {min: [1 mm, 1 mm, 1 mm], max: [29 mm, 29 mm, 17 mm]}}\n" FLOOR STAGES;

/** So many that layers are looked at in several bands. */
static const char MANY[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, 0 mm], max: [100 mm, 100 mm, 110 mm], periodic: [true, true, true]}\n"
    "grains:\n"
    "  - material: ore\n    count: 136000\n    radius: {distribution: uniform, min: 0.78 mm, max: 0.8 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [100 mm, 100 mm, 60 mm]}}\n"
    "  - material: sand\n    count: 116000\n    radius: {distribution: uniform, min: 0.76 mm, max: 0.79 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 50 mm], max: [100 mm, 100 mm, 110 mm]}}\n" STAGES;

static void groups_in_layers_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(LAYERS, 300);
}

static void rings_and_random_places_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(RINGS, 300);
}

static void more_ranks_than_grains_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(FEW, 100);
}

static void no_rank_has_a_list_of_all_grains(void **state)
{
    (void)state;
    const int64_t grains = 252000;
    if (sanitized()) {
        skip(); // it counts bytes
    }
    const byte_counts found = count_bytes(MANY, (size_t)grains);
    // rows of its share and of a piece, and less than a place of each grain for what it looks at
    assert_true(found.made < ROW_BYTES * (grains / LIST_RANKS + LIST_PIECE) + 32 * grains);
    assert_true(found.first < found.others + ROW_BYTES * grains / 4);
    assert_true(found.others < ROW_BYTES * grains); // its eighth, with ghosts and lists
}

/** A case that cannot be made leaves nothing behind: the next one is whole. */
static void fail_first(clod_ranks *ranks, void *context)
{
    dealt_bed *how = context;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        return;
    }
    clod_status status = {0}, alone = {0};
    made_bed none = {0};
    clod_case *full = case_of(LAYERS, NULL);
    full->grains[1].count = 9000; // in place of the mass
    dealt_bed too_many = {.from = full, .piece = 100, .into = &none};
    assert_false(give(&too_many, ranks, &status));
    clod_state_fini(&none.state);
    assert_false(clod_setup_state_give(full, 3, NULL, &none.state, &none.bed, &alone));
    assert_int_equal(status.code, CLOD_USAGE);
    assert_string_equal(status.text, alone.text);
    assert_non_null(strstr(alone.text, "grains.1: only "));
    clod_state_fini(&none.state);
    clod_case_destroy(&full);
    run_rank(ranks, how);
}

static void a_bed_that_cannot_be_made_leaves_nothing_behind(void **state)
{
    (void)state;
    clod_case *from = case_of(RINGS, NULL);
    made_bed one, several;
    make_alone(&one, from, 10);
    dealt_bed how = {.from = from, .steps = 10, .piece = 64, .into = &several};
    ranks_run(3, fail_first, &how);
    check_same_bed(&one, &several);
    end(&several);
    end(&one);
    clod_case_destroy(&from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_in_layers_have_the_bits_of_one_process),
        cmocka_unit_test(rings_and_random_places_have_the_bits_of_one_process),
        cmocka_unit_test(more_ranks_than_grains_have_the_bits_of_one_process),
        cmocka_unit_test(no_rank_has_a_list_of_all_grains),
        cmocka_unit_test(a_bed_that_cannot_be_made_leaves_nothing_behind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
