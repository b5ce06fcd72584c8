// The same bits whatever the instruction set, the number of threads, the search, the thin skin
// and the way in which the steps are asked for.

#include <omp.h>

#include "support/bed.h"
#include "support/bits.h"
#include "support/sanitized.h"

#define STEPS 2500

static void run_bed_alone(scene *s, bed_kind kind, clod_step_options options, bool ledger)
{
    clod_status status = {0};
    bed_init(s, kind, 1);
    scene_start_with(s, options);
    if (ledger) {
        scene_open_ledger(s);
    }
    scene_run(s, STEPS);
    assert_true(clod_step_export(&s->step, &status));
}

static void run_bed(scene *s, bed_kind kind, clod_step_options options)
{
    run_bed_alone(s, kind, options, true);
}

/** The reference runs: scalar, one thread. They must be worth comparing with. */
static scene reference[BED_KINDS];

static int run_references(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene *s = &reference[kind];
        run_bed(s, (bed_kind)kind, (clod_step_options){.threads = 1, .simd = "scalar"});
        assert_true(s->step.rebuilds >= 2 && s->step.refreshes > s->step.rebuilds);
        assert_true(s->state.contact_count > s->state.grains.count / 4);
        assert_true(kind == BED_CLUSTER || s->state.wall_contact_count > 5);
    }
    return 0;
}

static int end_references(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind++) {
        scene_end(&reference[kind]);
    }
    return 0;
}

/** Contacts between two parts: without any, threads would have been compared with nothing. */
static size_t contacts_between(const clod_near *near)
{
    size_t count = 0;
    for (int32_t l = 0; l < near->laws; l++) {
        for (int part = 0; part < near->parts; part++) {
            count += near->pairs.group_count[clod_near_group_between(near, part, l)];
        }
    }
    return count;
}

static void compare(clod_step_options options)
{
    static int compared;
    // With sanitizers every other bed, in turn: vectors meet each of them, and so do threads.
    const int first = sanitized() && !looks_for_races() ? compared++ % 2 : 0;
    for (int kind = first; kind < BED_KINDS; kind += sanitized() ? 2 : 1) {
        scene b;
        run_bed(&b, (bed_kind)kind, options);
        assert_true(options.threads == 1 || contacts_between(&b.step.near) > 0);
        check_same_bits(&reference[kind].state, &b.state);
        scene_end(&b);
    }
}

static void compare_sets(const char *simd)
{
    if (clod_kernel_choose(simd) == NULL) {
        print_message("this machine has no %s: not compared\n", simd);
        skip();
    }
    compare((clod_step_options){.threads = 1, .simd = simd});
}

static void avx2_gives_the_bits_of_scalar(void **state)
{
    (void)state;
    compare_sets("avx2");
}

static void avx512_gives_the_bits_of_scalar(void **state)
{
    (void)state;
    compare_sets("avx512");
}

static void neon_gives_the_bits_of_scalar(void **state)
{
    (void)state;
    compare_sets("neon");
}

static void two_threads_give_the_bits_of_one(void **state)
{
    (void)state;
    compare((clod_step_options){.threads = 2});
}

static void three_threads_give_the_bits_of_one(void **state)
{
    (void)state;
    compare((clod_step_options){.threads = 3});
}

/** Parts of some 40 grains: many contacts lie between two parts. */
static void seven_threads_give_the_bits_of_one(void **state)
{
    (void)state;
    compare((clod_step_options){.threads = 7});
}

static void all_pairs_give_the_bits_of_cells(void **state)
{
    (void)state;
    compare((clod_step_options){.threads = 1, .brute_force = true});
}

/** Three grains of two materials (three laws) that touch each other and a floor. */
static void few_grains(scene *s, int threads)
{
    const clod_case_contact contact = contact_ore();
    scene_init(s, 1e-6, &contact);
    bed_laws(s);
    s->state.gravity[2] = -9.81;
    scene_grain(s, 0.0, 0.0, 2.9999e-3, 3e-3);
    scene_grain(s, 5.995e-3, 0.0, 2.9999e-3, 3e-3);
    const size_t upper = scene_grain(s, 3e-3, 0.0, 8.195e-3, 3e-3);
    s->state.grains.material[upper] = 1;
    scene_wall(s, "floor", shape_floor(0.0))->surface_velocity.y = 0.2;
    scene_start_with(s, (clod_step_options){.threads = threads});
    scene_run(s, 20); // before they rebound
    assert_true(clod_step_export(&s->step, &s->step.status));
}

/** More threads than grains: some have nothing to do; grains that touch are in two parts. */
static void threads_without_work_do_no_harm(void **state)
{
    (void)state;
    scene one;
    few_grains(&one, 1);
    assert_int_equal(one.state.contact_count - one.state.wall_contact_count, 3);
    assert_int_equal(one.state.wall_contact_count, 2);
    for (int threads = 3; threads <= 7; threads += 4) {
        scene more;
        few_grains(&more, threads);
        check_same_bits(&one.state, &more.state);
        scene_end(&more);
    }
    scene_end(&one);
}

/** The run-time library gives one thread where four are asked for. */
static void fewer_threads_than_asked_for_are_enough(void **state)
{
    (void)state;
    if (looks_for_races()) {
        skip(); // it has one thread
    }
    const int levels = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
    compare((clod_step_options){.threads = 4});
    omp_set_max_active_levels(levels);
}

/** As nearly all runs are: the references have the ledger open. */
static void threads_without_a_ledger_give_the_bits_of_one(void **state)
{
    (void)state;
    static const int THREADS[] = {2, 7, 4};
    const int first = sanitized() ? 1 : 0, last = sanitized() ? 2 : 3;
    const int levels = omp_get_max_active_levels();
    for (int kind = 0; kind < BED_KINDS; kind += sanitized() && !looks_for_races() ? 2 : 1) {
        scene one;
        run_bed_alone(&one, (bed_kind)kind, (clod_step_options){.threads = 1}, false);
        for (int k = first; k < last; k++) {
            scene more;
            omp_set_max_active_levels(k < 2 ? levels : 0); // the last gets one thread of four
            run_bed_alone(&more, (bed_kind)kind, (clod_step_options){.threads = THREADS[k]},
                          false);
            assert_int_equal(more.step.threads, k < 2 ? THREADS[k] : 1);
            check_same_bits(&one.state, &more.state);
            scene_end(&more);
        }
        omp_set_max_active_levels(levels);
        scene_end(&one);
    }
}

/** A near list that is made anew in every step (walls must not move at all) changes no bit. */
static void the_thin_skin_does_not_matter(void **state)
{
    (void)state;
    for (int kind = 0; kind < BED_KINDS; kind += sanitized() ? 3 : 1) {
        clod_status status = {0};
        scene b;
        bed_init(&b, (bed_kind)kind, 1);
        scene_start(&b);
        scene_open_ledger(&b);
        for (int k = 0; k < STEPS; k++) {
            b.step.near.wall_skin = -1.0;
            scene_run(&b, 1);
        }
        assert_true(clod_step_export(&b.step, &status));
        assert_true(b.step.refreshes + b.step.rebuilds == STEPS);
        check_same_bits(&reference[kind].state, &b.state);
        scene_end(&b);
    }
}

/** All steps at once, in pieces, and with exports between them. */
static void the_way_of_asking_does_not_matter(void **state)
{
    (void)state;
    clod_status status = {0};
    scene b;
    bed_init(&b, BED_DRUM, 1);
    scene_start(&b);
    scene_open_ledger(&b);
    dice roll = {3};
    int left = STEPS;
    while (left > 0) {
        const int piece = dice_pick(&roll, 40) < left ? dice_pick(&roll, 40) : left;
        const int steps = piece < left ? piece : left;
        scene_run(&b, steps);
        left -= steps;
        if (dice_pick(&roll, 2) == 0) {
            assert_true(clod_step_export(&b.step, &status));
        }
    }
    assert_true(clod_step_export(&b.step, &status));
    check_same_bits(&reference[BED_DRUM].state, &b.state);
    scene_end(&b);
}

/** Grains given in another order, with the same ids: the order of sums is that of places. */
static void the_order_of_the_input_does_not_matter(void **state)
{
    (void)state;
    scene b;
    bed_init(&b, BED_SLIT, 1);
    clod_grains *g = &b.state.grains;
    for (size_t k = 0; k < g->count / 2; k++) {
        const size_t other = g->count - 1 - k;
        double row[3][4];
        double(*rows[3])[4] = {g->position, g->velocity, g->angular_velocity};
        for (int r = 0; r < 3; r++) {
            memcpy(row[r], rows[r][k], sizeof row[r]);
            memcpy(rows[r][k], rows[r][other], sizeof row[r]);
            memcpy(rows[r][other], row[r], sizeof row[r]);
        }
        const uint64_t id = g->id[k];
        g->id[k] = g->id[other];
        g->id[other] = id;
        const uint16_t material = g->material[k];
        g->material[k] = g->material[other];
        g->material[other] = material;
    }
    scene_start(&b);
    scene_open_ledger(&b);
    scene_run(&b, STEPS);
    assert_true(clod_step_export(&b.step, &b.step.status));
    check_same_bits(&reference[BED_SLIT].state, &b.state);
    scene_end(&b);
}

/** Laws known to the vector loops (docs/adr/0021), and laws that differ from one of them in one
 * choice. */
#define NEIGHBOURS 9

static clod_case_contact neighbour_law(int k)
{
    clod_case_contact c = contact_ore(); // mepa, n = 3/2, adhesive, tangent, epsd2: known
    c.restitution = 0.5;
    switch (k) {
    case 0: // known
        c.law = CLOD_LAW_HERTZ;
        break;
    case 1: // known
        c.law = CLOD_LAW_HERTZ;
        c.rolling = CLOD_ROLLING_NONE;
        break;
    case 2:
        c.rolling = CLOD_ROLLING_NONE;
        break;
    case 3:
        c.rolling = CLOD_ROLLING_EPSD;
        c.rolling_damping = 0.3;
        break;
    case 4:
        c.coulomb = CLOD_COULOMB_FORCE;
        break;
    case 5:
        c.law = CLOD_LAW_HERTZ;
        c.rolling = CLOD_ROLLING_CDT;
        break;
    case 6: // its k_t is k1
        c.k1 = 2e5;
        c.k2 = 6e5;
        c.k_adh = 1e5;
        c.tangential = CLOD_TANGENTIAL_LITERAL;
        break;
    case 7:
        c.law = CLOD_LAW_EEPA;
        c.pull_off_force = 0.2;
        break;
    default:
        c.exponent = 1.4;
    }
    return c;
}

/** Contacts at ten moments, added up. */
static size_t run_neighbour(scene *s, int k, const char *simd)
{
    const clod_case_contact law = neighbour_law(k);
    bed_init(s, BED_CLUSTER, 1);
    for (size_t g = 0; g < s->state.grains.count; g++) {
        s->state.grains.position[g][3] = 3.2005e-3; // the lattice has 6.4 mm: they touch
    }
    for (int a = 0; a < 3; a++) {
        for (int b = a; b < 3; b++) {
            scene_law(s, a, b, &law);
        }
    }
    scene_start_with(s, (clod_step_options){.threads = 1, .simd = simd});
    size_t met = 0;
    for (int moment = 0; moment < 10; moment++) {
        scene_run(s, 20);
        assert_true(clod_step_export(&s->step, &s->step.status));
        met += s->state.contact_count;
    }
    return met;
}

static void known_laws_and_their_neighbours_give_the_bits_of_scalar(void **state)
{
    (void)state;
    static const char *const SETS[] = {"avx2", "avx512", "neon"};
    for (int k = 0; k < NEIGHBOURS; k++) {
        scene one;
        const size_t met = run_neighbour(&one, k, "scalar");
        assert_true(met > 500);
        for (size_t set = 0; set < sizeof SETS / sizeof *SETS; set++) {
            scene other;
            if (clod_kernel_choose(SETS[set]) != NULL) {
                assert_true(run_neighbour(&other, k, SETS[set]) == met);
                check_same_bits(&one.state, &other.state);
                scene_end(&other);
            }
        }
        scene_end(&one);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(avx2_gives_the_bits_of_scalar),
        cmocka_unit_test(avx512_gives_the_bits_of_scalar),
        cmocka_unit_test(neon_gives_the_bits_of_scalar),
        cmocka_unit_test(known_laws_and_their_neighbours_give_the_bits_of_scalar),
        cmocka_unit_test(two_threads_give_the_bits_of_one),
        cmocka_unit_test(three_threads_give_the_bits_of_one),
        cmocka_unit_test(seven_threads_give_the_bits_of_one),
        cmocka_unit_test(all_pairs_give_the_bits_of_cells),
        cmocka_unit_test(threads_without_work_do_no_harm),
        cmocka_unit_test(fewer_threads_than_asked_for_are_enough),
        cmocka_unit_test(threads_without_a_ledger_give_the_bits_of_one),
        cmocka_unit_test(the_thin_skin_does_not_matter),
        cmocka_unit_test(the_way_of_asking_does_not_matter),
        cmocka_unit_test(the_order_of_the_input_does_not_matter),
    };
    if (sanitized()) {
        cmocka_set_skip_filter("three_threads_*"); // as two and seven
    }
    if (looks_for_races()) {
        cmocka_set_test_filter("*threads*");
        cmocka_set_skip_filter("t*_threads_*"); // two and three, as seven
    }
    return cmocka_run_group_tests(tests, run_references, end_references);
}
