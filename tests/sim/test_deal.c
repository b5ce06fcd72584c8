// Grains of a free run that several ranks get while they are made: the bed of one process, bit by bit,
// and no rank ever has all of it.
#include "sim/deal.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "clod/case.h"
#include "law/law.h"
#include "setup/grains.h"
#include "setup/state.h"
#include "step/crew.h"
#include "support/bits.h"
#include "support/case_of.h"
#include "support/ranks_threads.h"
#include "support/sanitized.h"

// ---- what a rank has in large blocks at most

#define LARGE 65536 ///< bytes

static _Thread_local int64_t live, most;
static _Thread_local int asks =
    -1; ///< for memory, that are granted before one is not; negative: all are
static _Thread_local bool refused;

void *__real_aligned_alloc(size_t alignment, size_t size); // the linker names them
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void __real_free(void *memory);
void __wrap_free(void *memory);

static int64_t large_bytes(void *memory)
{
    const size_t bytes = memory != NULL ? malloc_usable_size(memory) : 0;
    return bytes >= LARGE ? (int64_t)bytes : 0;
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    const bool refuse = asks == 0;
    asks -= asks >= 0;
    refused = refused || refuse;
    void *memory = refuse ? NULL : __real_aligned_alloc(alignment, size);
    live += large_bytes(memory);
    most = live > most ? live : most;
    return memory;
}

void __wrap_free(void *memory)
{
    live -= large_bytes(memory);
    __real_free(memory);
}

// ---- beds

#define MATERIALS                                                                              \
    "materials:\n"                                                                             \
    "  ore: {density: 2000 kg/m3}\n"                                                           \
    "  sand: {density: 2600 kg/m3}\n"                                                          \
    "  steel: {}\n"                                                                            \
    "contacts:\n"                                                                              \
    "  default: {law: hooke, k1: 1e4 N/m, restitution: 0.5, friction: 0.4}\n"
#define STAGES "stages:\n  - {name: settle, duration: 1 s}\n"
#define FLOOR                                                                                  \
    "walls:\n"                                                                                 \
    "  floor: {material: steel, shapes: [{plane: {point: [0 mm, 0 mm, 0 mm], normal: [0, 0, 1]}}]}\n"

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

/** Grains of very different sizes among others, so dense that many places are tried for the last of them. */
static const char CROWD[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm], periodic: [true, true, false]}\n"
    "grains:\n"
    "  - material: ore\n    count: 500\n    radius: {distribution: uniform, min: 0.6 mm, max: 0.7 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 1 mm], max: [20 mm, 20 mm, 9 mm]}}\n"
    "  - material: sand\n    count: 1100\n    radius: {distribution: uniform, min: 0.3 mm, max: 1.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 4 mm], max: [20 mm, 20 mm, 30 mm]}}\n" FLOOR STAGES;

/** Grains of one size. */
static const char EQUAL[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm]}\n"
    "grains:\n"
    "  - material: ore\n    count: 1000\n    radius: {distribution: uniform, min: 0.7 mm, max: 0.7 mm}\n"
    "    region: {annulus: {center: [10 mm, 10 mm, 1 mm], inner_radius: 0 mm, outer_radius: 9 mm, height: 22 mm}}\n" FLOOR
        STAGES;

/** A third of the region at random would do, but a wall takes a part of it: the last grain finds none of
 *  its 4000 places free, and all are put in layers. */
static const char HIDDEN[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm]}\n"
    "grains:\n"
    "  - material: ore\n    count: 610\n    radius: {distribution: uniform, min: 0.99 mm, max: 1 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, -4 mm], max: [20 mm, 20 mm, 16 mm]}}\n" FLOOR STAGES;

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

/** So many at random places that a list of them is seen. */
static const char LOOSE[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, 0 mm], max: [100 mm, 100 mm, 300 mm], periodic: [true, true, true]}\n"
    "grains:\n"
    "  - material: ore\n    count: 240000\n    radius: {distribution: uniform, min: 0.7 mm, max: 0.8 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 0 mm], max: [100 mm, 100 mm, 300 mm]}}\n" STAGES;

/** A case made into a bed, and stepped a little. */
typedef struct made_bed {
    clod_state state;
    clod_setup_bed bed;
    clod_laws laws;
    clod_step step;
} made_bed;

/** The same by ranks. */
typedef struct dealt_bed {
    const clod_case *from;
    int64_t steps;
    size_t piece;
    int64_t
        most[RANKS_MOST]; ///< bytes of each rank in large blocks, before the bed is gathered
    made_bed *into;
} dealt_bed;

static void step(made_bed *self, const clod_case *from, int64_t steps, clod_step_options how)
{
    clod_status status = {0};
    how.threads = 1;
    if (!clod_laws_init(&self->laws, from, &status) ||
        !clod_step_init(&self->step, &self->state, &self->laws, &how, &status) ||
        !clod_step_advance(&self->step, steps, &status)) {
        fail_msg("%s", status.text);
    }
}

static void gather(made_bed *self)
{
    clod_status status = {0};
    if (!clod_step_export(&self->step, &status)) {
        fail_msg("%s", status.text);
    }
}

static void end(made_bed *self)
{
    clod_step_fini(&self->step);
    clod_laws_fini(&self->laws);
    clod_state_fini(&self->state);
}

static void make_alone(made_bed *self, const clod_case *from, int64_t steps)
{
    clod_status status = {0};
    *self = (made_bed){0};
    if (!clod_setup_state_give(from, 3, NULL, &self->state, &self->bed, &status)) {
        fail_msg("%s", status.text);
    }
    step(self, from, steps, (clod_step_options){0});
    gather(self);
}

/** Make the bed and deal it. */
static bool give(dealt_bed *self, clod_ranks *ranks, clod_status *status)
{
    clod_deal deal;
    assert_non_null(clod_deal_begin(&deal, ranks, self->from));
    deal.taker.piece = self->piece;
    const bool good = clod_setup_state_give(self->from, 3, &deal.taker, &self->into->state,
                                            &self->into->bed, status);
    clod_deal_fini(&deal);
    return good;
}

static void run_rank(clod_ranks *ranks, void *context)
{
    dealt_bed *how = context;
    live = most = 0;
    asks = -1;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
        how->most[ranks->rank] = most;
        return;
    }
    clod_status status = {0};
    clod_crew_share share = {0};
    const clod_step_options options = {.ranks = ranks, .dealt = &share};
    *how->into = (made_bed){0};
    if (!give(how, ranks, &status)) {
        fail_msg("%s", status.text);
    }
    step(how->into, how->from, how->steps, options);
    how->most[0] = most;
    gather(how->into);
    clod_crew_end(&how->into->step.crew);
    clod_crew_dismiss(ranks);
}

/** All that setup has asked of the grains, and all that followed from it. */
static void check_same_bed(const made_bed *one, const made_bed *several)
{
    check_same_bits(&one->state, &several->state);
    assert_memory_equal(&one->bed, &several->bed, sizeof one->bed);
    assert_memory_equal(&one->state.domain, &several->state.domain, sizeof one->state.domain);
    assert_memory_equal(&one->state.dt, &several->state.dt, sizeof one->state.dt);
    for (int32_t w = 0; w < one->state.walls.count; w++) {
        assert_true(one->state.walls.wall[w].damping == several->state.walls.wall[w].damping);
    }
}

/** No two grains overlap. */
static void check_apart(const clod_state *state)
{
    clod_status status = {0};
    clod_setup_overlap worst;
    assert_true(clod_setup_worst_overlap(state, &worst, &status));
    assert_true(worst.overlap == 0.0);
}

static void compare(const char *text, int64_t steps)
{
    static const int RANKS[] = {2, 3, 4, 7};
    clod_case *from = case_of(text, NULL);
    made_bed one, several;
    make_alone(&one, from, steps);
    for (size_t k = 0; k < sizeof RANKS / sizeof *RANKS; k += sanitized() ? 2 : 1) {
        dealt_bed how = {.from = from, .steps = steps, .piece = 100, .into = &several};
        ranks_run(RANKS[k], run_rank, &how);
        check_same_bed(&one, &several);
        end(&several);
    }
    end(&one);
    clod_case_destroy(&from);
}

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

static void a_crowd_at_random_places_has_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(CROWD, 100);
}

static void grains_of_one_size_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(EQUAL, 100);
}

static void grains_that_find_no_random_place_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(HIDDEN, 100);
}

static void more_ranks_than_grains_have_the_bits_of_one_process(void **state)
{
    (void)state;
    compare(FEW, 100);
}

// A row has 32 bytes of position and radius, 32 of velocity and mass, 32 of spin and inertia, 64 of
// force and torque, 8 of id, 8 of birth, 2 of material, and 32 of its place at the last rebuild: 210. All
// rows on rank 0 would be beside what every other rank has, too.
#define ROW_BYTES 210

/** What ranks have in large blocks while a bed is made, by rank 0 and the most of another, in bytes. */
static void count_bytes(const char *text, size_t grains, int64_t *first, int64_t *others)
{
    enum { RANKS = 8 };
    clod_case *from = case_of(text, NULL);
    made_bed one, several;
    make_alone(&one, from, 2);
    check_apart(&one.state);
    assert_int_equal(one.state.grains.count, grains);
    dealt_bed how = {.from = from, .steps = 2, .piece = 2000, .into = &several};
    ranks_run(RANKS, run_rank, &how);
    check_same_bed(&one, &several);
    *first = how.most[0];
    *others = 0;
    for (int r = 1; r < RANKS; r++) {
        *others = how.most[r] > *others ? how.most[r] : *others;
    }
    end(&several);
    end(&one);
    clod_case_destroy(&from);
}

static void no_rank_has_a_list_of_all_grains(void **state)
{
    (void)state;
    const int64_t grains = 252000;
    int64_t first, others;
    if (looks_for_races()) {
        skip(); // it counts bytes
    }
    count_bytes(MANY, (size_t)grains, &first, &others);
    assert_true(first > 0);
    assert_true(first < others + ROW_BYTES * grains / 4);
    assert_true(others < ROW_BYTES * grains); // its eighth, with ghosts and lists
}

// A place alone has 32 bytes. A list of all places on rank 0, beside what every other rank has, would be seen.
static void no_rank_has_a_list_of_all_random_places(void **state)
{
    (void)state;
    const int64_t grains = 240000;
    int64_t first, others;
    if (looks_for_races()) {
        skip();
    }
    count_bytes(LOOSE, (size_t)grains, &first, &others);
    assert_true(first < others + 32 * grains / 2);
    assert_true(others < ROW_BYTES * grains);
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

// ---- a rank without memory

/** Few grains at random positions among others. */
static const char SOME[] = MATERIALS
    "domain: {min: [0 mm, 0 mm, -5 mm], max: [20 mm, 20 mm, 60 mm], periodic: [true, true, false]}\n"
    "grains:\n"
    "  - material: ore\n    count: 20\n    radius: {distribution: uniform, min: 0.9 mm, max: 1 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 1 mm], max: [20 mm, 20 mm, 20 mm]}}\n"
    "  - material: sand\n    count: 40\n    radius: {distribution: uniform, min: 0.6 mm, max: 1.2 mm}\n"
    "    region: {box: {min: [0 mm, 0 mm, 4 mm], max: [20 mm, 20 mm, 20 mm]}}\n" FLOOR STAGES;

/** One rank lacks memory once, after some that it got. */
typedef struct poor_rank {
    const clod_case *from;
    int rank, granted;
    bool refused; ///< it came to that
} poor_rank;

static void make_in_need(clod_ranks *ranks, void *context)
{
    poor_rank *how = context;
    const bool poor = ranks->rank == how->rank;
    asks = poor ? how->granted : -1;
    refused = false;
    if (ranks->rank > 0) {
        clod_crew_serve(ranks);
    } else {
        clod_status status = {0};
        made_bed made = {0};
        dealt_bed bed = {.from = how->from, .piece = 16, .into = &made};
        const bool good = give(&bed, ranks, &status);
        if (!good) { // all know of it, and the next one is made
            assert_int_equal(status.code, CLOD_FAILED);
            assert_non_null(strstr(status.text, "memory"));
            clod_state_fini(&made.state);
            asks = -1;
            status = (clod_status){0};
            assert_true(give(&bed, ranks, &status));
        }
        clod_state_fini(&made.state);
        clod_crew_dismiss(ranks);
        assert_true(good || poor || how->rank > 0);
    }
    how->refused = poor ? refused : how->refused;
    asks = -1;
}

static void a_rank_without_memory_is_an_error_of_all(void **state)
{
    (void)state;
    clod_case *from = case_of(SOME, NULL);
    for (int rank = 0; rank < 3; rank++) {
        poor_rank how = {.from = from, .rank = rank, .refused = true};
        for (; how.refused; how.granted++) {
            how.refused = false;
            ranks_run(3, make_in_need, &how);
        }
        assert_true(how.granted > 40);
    }
    clod_case_destroy(&from);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(groups_in_layers_have_the_bits_of_one_process),
        cmocka_unit_test(rings_and_random_places_have_the_bits_of_one_process),
        cmocka_unit_test(a_crowd_at_random_places_has_the_bits_of_one_process),
        cmocka_unit_test(grains_of_one_size_have_the_bits_of_one_process),
        cmocka_unit_test(grains_that_find_no_random_place_have_the_bits_of_one_process),
        cmocka_unit_test(more_ranks_than_grains_have_the_bits_of_one_process),
        cmocka_unit_test(no_rank_has_a_list_of_all_grains),
        cmocka_unit_test(no_rank_has_a_list_of_all_random_places),
        cmocka_unit_test(a_bed_that_cannot_be_made_leaves_nothing_behind),
        cmocka_unit_test(a_rank_without_memory_is_an_error_of_all),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
