// Clumps of a bed that ranks step: those of one process, bit by bit, found where the grains are.
#include "measure/clumps_look.h"
#include "step/crew_part.h"

#include "support/bed.h"
#include "support/ranks_crew.h"
#include "support/sanitized.h"

#define LOOKS 5
#define MOST 512 // grains

static const clod_clumps_look LOOK = {
    .bond = 1.0,
    .follows = true,
    .choices = 4,
    .choice = {{.least = 2},
               {.least = 2, .free = true},
               {.least = 2,
                .cuts = true,
                .region = {{-0.015, -0.015, -0.02}, {0.01, 0.012, 0.02}, {0.0, 0.0}, 0.0, 0.0}},
               {.least = 3,
                .cuts = true,
                .free = true,
                .region = {{-0.02, -0.02, -0.02}, {0.03, 0.03, 0.05}, {0, 0}, 0.004, 0.02}}}};

/** All that is known at a moment. */
typedef struct told {
    clod_clumps_seen seen;
    clod_grain_clump clump[MOST]; ///< by id; of the last look alone
    int64_t left[1 + CLOD_CLUMP_CLASSES];
} told;

typedef struct clumped_bed {
    bed_kind kind;
    bool leaves; ///< some grains do
    int threads;
    told *to; ///< [LOOKS] of rank 0
} clumped_bed;

/** Grains that keep clumps, with ids in no order. */
static void begin(scene *s, const clumped_bed *how, clod_ranks *ranks)
{
    clod_status status = {0};
    bed_init(s, how->kind, 1);
    const size_t n = s->state.grains.count;
    assert_in_range(n, 100, MOST - 1);
    for (size_t g = 0; g < n; g++) {
        s->state.grains.id[g] = 1 + (g * 37 + n / 2) % n;
    }
    if (how->leaves) {
        clod_domain *domain = &s->state.domain;
        domain->removes = true;
        domain->outlets = 1;
        domain->outlet[0] =
            (clod_outlet){{-1.0, 0.008, -1.0}, {1.0, 1.0, 0.03}, {0.0, 0.0}, 0.0, 0.0};
    }
    assert_true(clod_grains_keep_clumps(&s->state.grains, &status));
    scene_start_with(s, (clod_step_options){.threads = how->threads, .ranks = ranks});
}

static void look(clod_step *step, const clod_clumps_look *at, clod_clumps_seen *seen)
{
    clod_status status = {0};
    clod_step_reader reader;
    const clod_contact_source contacts = clod_step_contacts(step, &reader);
    const clod_survey survey = clod_step_survey(step, &contacts);
    if (!clod_clumps_look_at(at, &survey, seen, &status)) {
        fail_msg("%s", status.text);
    }
}

/** What grains know, of the whole bed. */
static void see_grains(scene *s, told *to)
{
    clod_status status = {0};
    assert_true(clod_step_see(&s->step, &status));
    const clod_grains *grains = &s->state.grains;
    for (size_t g = 0; g < grains->count; g++) {
        to->clump[grains->id[g]] = grains->clump[g];
    }
    memcpy(to->left, s->state.exchange.left_clumps, sizeof to->left);
}

/** A picture of grains without adhesion, which then go to their ranks anew: they are in no clump, but no
 *  look that follows has seen that. */
static void dry(scene *s, clod_clumps_seen *seen)
{
    clod_status status = {0};
    clod_clumps_look picture = LOOK;
    picture.follows = false;
    picture.choices = 1;
    s->state.adhesion = 0.0;
    clod_laws_set_adhesion(&s->laws, s->state.adhesion);
    look(&s->step, &picture, seen);
    assert_true(clod_step_see(&s->step, &status) && clod_step_renew(&s->step, &status));
    scene_run(s, 1);
}

/** Looks between steps; before the last one adhesion ends. */
static void run_bed(void *context, clod_ranks *ranks)
{
    const clumped_bed *how = context;
    scene s;
    begin(&s, how, ranks);
    for (int k = 0; k < LOOKS; k++) {
        told *to = &how->to[k];
        scene_run(&s, 700 + k);
        if (k == LOOKS - 1) {
            dry(&s, &to->seen);
        }
        look(&s.step, &LOOK, &to->seen);
        assert_true(ranks == NULL || s.step.crew->stale); // nothing was gathered
        if (k == 1 || k >= LOOKS - 2) { // ranks go on with what they know, gathered or not
            see_grains(&s, to);
        }
    }
    clod_crew_end(&s.step.crew);
    scene_end(&s);
}

/** There is something to compare. */
static void check_full(const told looks[LOOKS], bool leaves)
{
    const clod_clumps_seen *seen = &looks[LOOKS - 2].seen;
    for (int32_t k = 0; k < LOOK.choices; k++) {
        assert_true(seen->found[k].stats.number > 0.0);
    }
    assert_true(seen->found[0].stats.largest > 5.0);
    assert_true(looks[LOOKS - 1].seen.found[0].stats.number == 0.0);
    assert_true(looks[LOOKS - 1].seen.lives.grains > 50); // all that were in some are in none
    int64_t clumped = 0;
    for (int k = 1; k <= CLOD_CLUMP_CLASSES; k++) {
        clumped += looks[LOOKS - 1].left[k];
    }
    assert_true(clumped > 0 || !leaves);
}

static void compare(clumped_bed how)
{
    static const int RANKS[] = {2, 3, 4, 7, 16};
    const size_t counts = how.kind == BED_SLIT ? 5 : 4; // 16 take long
    static told one[LOOKS], several[LOOKS];
    memset(one, 0, sizeof one);
    how.to = one;
    run_bed(&how, NULL);
    check_full(one, how.leaves);
    for (size_t k = 0; k < counts; k++) {
        if (left_out(k, how.kind == BED_SLIT ? 3 : 1)) {
            continue;
        }
        memset(several, 0, sizeof several);
        how.to = several;
        ranks_crew_run(RANKS[k], run_bed, &how);
        for (int l = 0; l < LOOKS; l++) {
            clod_clumps_seen *a = &one[l].seen, *b = &several[l].seen;
            assert_true(clod_exact_value(&a->lives.sum) == clod_exact_value(&b->lives.sum));
            a->lives.sum = b->lives.sum; // of the same value in several bytes
            assert_memory_equal(a, b, sizeof *a);
            assert_memory_equal(one[l].clump, several[l].clump, sizeof one[l].clump);
            assert_memory_equal(one[l].left, several[l].left, sizeof one[l].left);
        }
    }
}

static void a_slit(void **state)
{
    (void)state;
    compare((clumped_bed){.kind = BED_SLIT, .threads = 1});
}

static void a_drum(void **state)
{
    (void)state;
    compare((clumped_bed){.kind = BED_DRUM, .threads = 1});
}

static void a_hopper_that_grains_leave_on_two_threads_each(void **state)
{
    (void)state;
    compare((clumped_bed){.kind = BED_HOPPER, .leaves = true, .threads = 2});
}

static void a_cluster_without_walls(void **state)
{
    (void)state;
    compare((clumped_bed){.kind = BED_CLUSTER, .threads = 1});
}

// ---- what rank 0 gets

#define EDGE 24 ///< grains along each edge
#define RADIUS 1e-3

/** Bytes of messages to rank 0. */
typedef struct traffic {
    size_t all, largest;
} traffic;

static traffic got;
static void (*real_exchange)(clod_ranks *self, const clod_message *out, int outs,
                             const clod_message *in, int ins);

static void exchange(clod_ranks *self, const clod_message *out, int outs,
                     const clod_message *in, int ins)
{
    for (int k = 0; k < ins; k++) {
        got.all += in[k].bytes;
        got.largest = in[k].bytes > got.largest ? in[k].bytes : got.largest;
    }
    real_exchange(self, out, outs, in, ins);
}

typedef struct large_bed {
    clod_clumps_seen seen;
    traffic look, gather;
} large_bed;

/** Sheets of grains that hang together: across every cut of the ranks. */
static void look_at_sheets(void *context, clod_ranks *ranks)
{
    large_bed *to = context;
    const clod_case_contact ore = contact_ore();
    const clod_clumps_look all = {.bond = 1.0, .choices = 1, .choice = {{.least = 2}}};
    scene s;
    scene_init(&s, 1e-7, &ore);
    s.state.gravity[2] = -9.81;
    for (int k = 0; k < EDGE * EDGE * EDGE; k++) {
        const int x = k % EDGE, y = k / EDGE % EDGE, z = k / (EDGE * EDGE);
        const size_t g =
            scene_grain(&s, 1.999 * RADIUS * x, 2.1 * RADIUS * y, 1.999 * RADIUS * z, RADIUS);
        s.state.grains.id[g] = g + 1;
    }
    assert_true(clod_grains_keep_clumps(&s.state.grains, &(clod_status){0}));
    scene_start_with(&s, (clod_step_options){.threads = 1, .ranks = ranks});
    scene_run(&s, 2);
    if (ranks != NULL) {
        real_exchange = ranks->exchange;
        ranks->exchange = exchange;
    }
    got = (traffic){0, 0};
    look(&s.step, &all, &to->seen);
    to->look = got;
    got = (traffic){0, 0};
    assert_true(clod_step_see(&s.step, &(clod_status){0}));
    to->gather = got;
    if (ranks != NULL) {
        ranks->exchange = real_exchange;
    }
    clod_crew_end(&s.step.crew);
    scene_end(&s);
}

static void no_message_has_the_bed(void **state)
{
    (void)state;
    static large_bed one, several;
    look_at_sheets(&one, NULL);
    const clod_clump_stats *stats = &one.seen.found[0].stats;
    assert_true(stats->number == EDGE && stats->largest == EDGE * EDGE);
    for (int ranks = 2; ranks <= 8; ranks *= 2) {
        ranks_crew_run(ranks, look_at_sheets, &several);
        assert_memory_equal(several.seen.found, one.seen.found, sizeof one.seen.found);
        print_message(
            "%d grains, %d ranks: rank 0 gets %zu bytes for a look, in messages of up "
            "to %zu; %zu for the bed, %zu\n",
            EDGE * EDGE * EDGE, ranks, several.look.all, several.look.largest,
            several.gather.all, several.gather.largest);
        // the sums, or one link of 16 bytes a grain of the cuts that a rank may have, two across
        assert_in_range(several.look.largest, 1,
                        sizeof(clod_clumps_seen) + 2 * 16 * EDGE * EDGE);
        assert_true(several.gather.all > 20 * several.look.all);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slit),
        cmocka_unit_test(a_drum),
        cmocka_unit_test(a_hopper_that_grains_leave_on_two_threads_each),
        cmocka_unit_test(a_cluster_without_walls),
        cmocka_unit_test(no_message_has_the_bed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
