// Sums over a bed that ranks have are those of one process, bit by bit, without a gather.
#include "measure/contacts.h"
#include "measure/continuum_pass.h"
#include "measure/gauge_pass.h"
#include "measure/mixing_grid.h"
#include "measure/repose.h"
#include "measure/resting_mass.h"
#include "measure/stock.h"
#include "measure/strength_grid.h"
#include "step/crew_part.h"

#include "support/bed.h"
#include "support/ranks_crew.h"
#include "support/sanitized.h"

#define LOOKS 4
#define BINS 5
#define EDGE 0.005 // of cells, m
#define GRID 8     // cells along an edge of the box
#define POINTS (GRID * GRID * GRID)

static const clod_outlet BOX = {
    {-0.02, -0.02, -0.02}, {0.02, 0.02, 0.02}, {0.0, 0.0}, 0.0, 0.0};
static const clod_outlet RING = {
    {-0.02, -0.02, -0.01}, {0.02, 0.02, 0.01}, {0.0, 0.0}, 0.004, 0.016};

/** All that is asked at a moment. */
typedef struct told {
    clod_measure_motion motion;
    clod_measure_contacts contacts;
    double gauge[2][CLOD_GAUGE_SUMS];
    clod_gauge_bins profile, trajectory;
    double region[CLOD_CONTINUUM_SUMS], grid[POINTS][CLOD_CONTINUUM_SUMS];
    clod_mixing_sample mixing[POINTS];
    clod_mixing_weighed weighed[POINTS];
    clod_repose_angle repose;
    double center[2];
    clod_stock stock[3];
    clod_strength_cell strength[POINTS];
    double resting[2][SCENE_WALLS]; ///< kg, slow and at any speed
} told;

typedef struct surveyed_bed {
    bed_kind kind;
    bool ledger;
    int threads;
    told *to; ///< [LOOKS] of rank 0
} surveyed_bed;

static void ask_gauges(const clod_survey *survey, told *to)
{
    clod_status status = {0};
    const double along[3] = {1.0, 0.0, 0.0}, none[3] = {0.0}, down[3] = {0.0, 0.0, -9.81};
    const clod_gauge box = clod_gauge_of(&BOX, along, none, down);
    const clod_gauge ring = clod_gauge_of(&RING, none, none, down);
    const clod_gauge_part parts[2] = {{.gauge = box,
                                       .sums = to->gauge[0],
                                       .profile = &to->profile,
                                       .trajectory = &to->trajectory,
                                       .across = clod_gauge_axis_of(&box, box.across, BINS),
                                       .along = clod_gauge_axis_of(&box, box.direction, BINS)},
                                      {.gauge = ring, .sums = to->gauge[1]}};
    assert_true(clod_gauge_pass(parts, 2, survey, &status));
}

static void ask_fields(const clod_survey *survey, told *to)
{
    clod_status status = {0};
    const clod_continuum region = clod_continuum_make(&RING, 0.0, 0.0);
    const clod_continuum grid = clod_continuum_make(&BOX, EDGE, 2.0 * EDGE);
    assert_int_equal(clod_continuum_points(&grid), POINTS);
    const clod_continuum_part parts[2] = {{&region, &to->region}, {&grid, to->grid}};
    assert_true(clod_continuum_pass(parts, 2, survey, &status));
}

static void ask_stock(const clod_survey *survey, told *to)
{
    clod_status status = {0};
    assert_true(clod_stock_take(to->stock, 3, survey, &status));
}

static void ask_strength(const clod_survey *survey, told *to)
{
    clod_status status = {0};
    const clod_strength_grid grid = {
        .low = {-0.02, -0.02, -0.02}, .edge = EDGE, .cells = {GRID, GRID, GRID}};
    assert_true(clod_strength_grid_add(&grid, survey, to->strength, &status));
}

static void ask_resting(const clod_survey *survey, told *to)
{
    clod_status status = {0};
    const size_t walls = (size_t)survey->state->walls.count;
    clod_resting_question *asked =
        clod_memory_alloc(1, sizeof *asked + SCENE_WALLS * sizeof *asked->target);
    clod_exact mass[SCENE_WALLS];
    for (size_t w = 0; w < walls; w++) {
        asked->target[w] = (clod_resting_target){(int32_t)w, 0, -1};
    }
    asked->count = walls;
    for (int k = 0; k < 2; k++) {
        asked->speed = k == 0 ? 1.0 : 100.0;
        assert_true(clod_resting_mass(asked, survey, mass, &status));
        for (size_t w = 0; w < walls; w++) {
            to->resting[k][w] = clod_exact_value(&mass[w]);
        }
    }
    clod_memory_free(asked);
}

static void ask(clod_step *step, told *to)
{
    clod_status status = {0};
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    const clod_survey survey = clod_step_survey(step, &contacts);
    const clod_mixing_grid mixing = {
        .region = BOX, .cell = EDGE, .cells = {GRID, GRID, GRID}, .material = 1, .unit = 1e-4};
    clod_repose heap = {.region = BOX, .cell = EDGE, .from = 0.1, .to = 1.0};
    memset(to, 0, sizeof *to);
    to->motion = clod_measure_motion_from(&survey);
    assert_true(clod_measure_contacts_from(&survey, &to->contacts, &status));
    ask_strength(&survey,
                 to); // first: it needs motions of ghosts, and is the first to ask for them
    ask_gauges(&survey, to);
    ask_fields(&survey, to);
    ask_stock(&survey, to);
    ask_resting(&survey, to);
    assert_true(clod_mixing_grid_count(&mixing, &survey, to->mixing, &status));
    assert_true(clod_mixing_grid_weigh(&mixing, &survey, to->weighed, &status));
    assert_true(clod_repose_center(&BOX, &survey, to->center, &status));
    memcpy(heap.center, to->center, sizeof heap.center);
    assert_true(clod_repose_find(&heap, &survey, &to->repose, &status));
}

/** Looks between steps; before the third somebody changes adhesion and how fast walls are. */
static void run_bed(void *context, clod_ranks *ranks)
{
    const surveyed_bed *how = context;
    scene s;
    bed_init(&s, how->kind, 1);
    scene_start_with(&s, (clod_step_options){.threads = how->threads, .ranks = ranks});
    if (how->ledger) {
        scene_open_ledger(&s);
    }
    for (int k = 0; k < LOOKS; k++) {
        scene_run(&s, 400 + k);
        if (k == 2) {
            s.state.adhesion = 0.25;
            clod_laws_set_adhesion(&s.laws, s.state.adhesion);
            for (int32_t w = 0; w < s.state.walls.count; w++) {
                s.state.walls.wall[w].velocity.x += 0.5;
            }
        }
        ask(&s.step, &how->to[k]);
        assert_true(ranks == NULL || s.step.crew->stale); // nothing was gathered
    }
    clod_crew_end(&s.step.crew);
    scene_end(&s);
}

/** Contacts of all beds and looks that were pressed harder than ever: a few of some hundred. */
static int64_t gained;

/** There is something to compare: at the last look, and somewhere a contact with a wall. */
static void check_full(const told looks[LOOKS], bool walls)
{
    const told *of = &looks[LOOKS - 1];
    int touched = 0;
    double slow = 0.0, resting = 0.0;
    for (int l = 0; l < LOOKS; l++) {
        touched += looks[l].contacts.walls > 0;
        for (int w = 0; w < SCENE_WALLS; w++) {
            slow += looks[l].resting[0][w];
            resting += looks[l].resting[1][w];
        }
    }
    assert_true(touched > 0 || !walls);
    assert_true(resting > slow || !walls);
    assert_true(of->motion.grains > 100 && of->motion.loaded > 20 &&
                of->motion.max_speed > 0.0);
    assert_true(of->contacts.pairs > 50);
    assert_true(of->gauge[0][CLOD_GAUGE_GRAINS] > 50.0 && of->gauge[1][CLOD_GAUGE_MASS] > 0.0);
    assert_true(of->profile.seen[BINS / 2] > 0.0 && of->trajectory.mass[BINS / 2] > 0.0);
    assert_true(of->region[CLOD_CONTINUUM_MASS] > 0.0);
    assert_true(of->region[CLOD_CONTINUUM_CONTACT] != 0.0);
    assert_true(of->region[CLOD_CONTINUUM_PARTNERS] > 0.0);
    int64_t contacts = 0, gaining = 0;
    double pressed = 0.0;
    for (int k = 0; k < POINTS; k++) {
        contacts += of->strength[k].contacts;
        pressed = fmax(pressed, of->strength[k].most_pressed);
        for (int l = 0; l < LOOKS; l++) {
            gaining += looks[l].strength[k].gaining;
        }
    }
    assert_true(contacts > 20 && contacts < (int64_t)of->contacts.pairs && pressed > 0.0);
    gained += gaining;
    assert_true(of->repose.height > 0.0 && of->stock[2].count > 10.0);
}

static void check_same(const told *one, const told *other)
{
    assert_memory_equal(&one->motion, &other->motion, sizeof one->motion);
    assert_memory_equal(&one->contacts, &other->contacts, sizeof one->contacts);
    assert_memory_equal(one->gauge, other->gauge, sizeof one->gauge);
    assert_memory_equal(&one->profile, &other->profile, sizeof one->profile);
    assert_memory_equal(&one->trajectory, &other->trajectory, sizeof one->trajectory);
    assert_memory_equal(one->region, other->region, sizeof one->region);
    assert_memory_equal(one->grid, other->grid, sizeof one->grid);
    assert_memory_equal(one->mixing, other->mixing, sizeof one->mixing);
    assert_memory_equal(one->weighed, other->weighed, sizeof one->weighed);
    assert_memory_equal(&one->repose, &other->repose, sizeof one->repose);
    assert_memory_equal(one->center, other->center, sizeof one->center);
    assert_memory_equal(one->stock, other->stock, sizeof one->stock);
    assert_memory_equal(one->strength, other->strength, sizeof one->strength);
    assert_memory_equal(one->resting, other->resting, sizeof one->resting);
}

static void compare(surveyed_bed how)
{
    static const int RANKS[] = {2, 3, 4, 7};
    static told one[LOOKS], several[LOOKS];
    how.to = one;
    run_bed(&how, NULL);
    check_full(one, how.kind != BED_CLUSTER);
    how.to = several;
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k++) {
        if (left_out(k, how.kind == BED_SLIT ? 3 : 1)) {
            continue;
        }
        ranks_crew_run(RANKS[k], run_bed, &how);
        for (int l = 0; l < LOOKS; l++) {
            check_same(&one[l], &several[l]);
        }
    }
}

static void a_slit(void **state)
{
    (void)state;
    compare((surveyed_bed){.kind = BED_SLIT, .threads = 1});
}

static void a_drum_with_the_ledger(void **state)
{
    (void)state;
    compare((surveyed_bed){.kind = BED_DRUM, .ledger = true, .threads = 1});
}

static void a_hopper_on_two_threads_each(void **state)
{
    (void)state;
    compare((surveyed_bed){.kind = BED_HOPPER, .threads = 2});
}

static void a_cluster_without_walls(void **state)
{
    (void)state;
    compare((surveyed_bed){.kind = BED_CLUSTER, .threads = 1});
}

/** The beds before have been compared: they had some. */
static void some_contacts_gained_strength(void **state)
{
    (void)state;
    assert_true(gained > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slit),
        cmocka_unit_test(a_drum_with_the_ledger),
        cmocka_unit_test(a_hopper_on_two_threads_each),
        cmocka_unit_test(a_cluster_without_walls),
        cmocka_unit_test(some_contacts_gained_strength),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
