// Grains that pass planes are counted, once each, in the direction in which they pass; no rounding
// and no period of the domain adds or hides one.
#include <stdint.h>
#include <stdlib.h>

#include "state/planes.h"
#include "step/passages.h"
#include "support/dice.h"
#include "support/sanitized.h"
#include "support/scene.h"

#define LATTICE 4096.0 ///< places that are multiples of its inverse: sums of them are exact

// ---- levels

static clod_domain domain_along_x(double low, double high)
{
    return (clod_domain){.min = {low, -10.0, -10.0},
                         .max = {high, 10.0, 10.0},
                         .periodic = {true, false, false}};
}

/** Passages between two places, from their levels. */
static double passages(const clod_plane *plane, const clod_domain *domain, double from,
                       double to)
{
    return clod_plane_level(plane, domain, to) - clod_plane_level(plane, domain, from);
}

/** Expected: images of the plane, one in each period of 1 m, in the half-open way; in numbers that a
 *  double has exactly. */
static void levels_count_the_images_on_the_way(void **state)
{
    (void)state;
    dice random = {1};
    const clod_domain domain = domain_along_x(-0.5, 0.5);
    const clod_domain open = {.min = {-0.5}, .max = {0.5}};
    static const double AT[] = {-0.5, -0.25, 0.0, 0.375, 0.5};
    int more = 0;
    for (int k = 0; k < 20000; k++) {
        const clod_plane plane = {.at = AT[k % 5], .sign = 1};
        const double from = floor(dice_real(&random, -3.0, 3.0) * LATTICE) / LATTICE;
        const double to = floor(dice_real(&random, -3.0, 3.0) * LATTICE) / LATTICE;
        const double images = floor(to - plane.at) - floor(from - plane.at);
        check_close(passages(&plane, &domain, from, to), images, 0.0);
        const double one = (to >= plane.at ? 1.0 : 0.0) - (from >= plane.at ? 1.0 : 0.0);
        check_close(passages(&plane, &open, from, to), one, 0.0);
        more += fabs(images) > 1.0;
    }
    assert_true(more > 1000); // of several periods too
}

/** Places within some units of the last digit of a place. */
static double near_place(double place, int units)
{
    for (int k = 0; k < abs(units); k++) {
        place = nextafter(place, units > 0 ? HUGE_VAL : -HUGE_VAL);
    }
    return place;
}

/** A rebuild puts a grain back into the domain: it passes no plane by that, or all of them alike. */
static void check_put_back(const clod_domain *domain, double x)
{
    const double at[4] = {domain->min[0], 0.6 * domain->min[0] + 0.4 * domain->max[0],
                          near_place(domain->max[0], -1), domain->max[0]};
    const double within = clod_domain_within(domain, 0, x);
    assert_true(within >= domain->min[0] && within < domain->max[0]);
    check_close(clod_domain_within(domain, 0, within), within, 0.0);
    double turns[4];
    for (int k = 0; k < 4; k++) {
        const clod_plane plane = {.at = at[k], .sign = 1};
        turns[k] = passages(&plane, domain, within, x);
        check_close(turns[k], turns[0], 0.0);
        // and a way forward passes it forward or not at all
        const double next = passages(&plane, domain, x, near_place(x, 1));
        assert_true(next == 0.0 || next == 1.0);
    }
}

/** Sides and periods that a double does not have exactly; places about each image of each side. */
static void to_be_put_back_passes_nothing(void **state)
{
    (void)state;
    static const double SIDES[][2] = {
        {0.1, 0.4}, {-1.0 / 3.0, 2.0 / 3.0}, {1e-3, 0.123456789}, {-7.3, 1000.1}, {0.0, 0.7}};
    for (size_t s = 0; s < sizeof SIDES / sizeof *SIDES; s++) {
        const clod_domain domain = domain_along_x(SIDES[s][0], SIDES[s][1]);
        const double period = SIDES[s][1] - SIDES[s][0];
        for (int turn = -3; turn <= 3; turn++) {
            for (int units = -6; units <= 6; units++) {
                check_put_back(&domain, near_place(SIDES[s][0] + turn * period, units));
                check_put_back(&domain, near_place(SIDES[s][1] + turn * period, units));
            }
        }
        check_put_back(&domain, domain.min[0] - 1e-20);
        check_put_back(&domain, domain.min[0] - 1e-300);
    }
}

/** The rebuild does what the planes expect of it; what is no number is told. */
static void a_rebuild_puts_back_to_the_same_place(void **state)
{
    (void)state;
    const clod_case_contact contact = contact_ore();
    const clod_neighbour none = {0};
    scene s;
    scene_init(&s, 1e-4, &contact);
    s.state.domain = domain_along_x(0.1, 0.4);
    double expected[9];
    for (int k = 0; k < 9; k++) {
        const double x = near_place(k < 5 ? 0.1 : 0.4, k % 5 - 2);
        scene_grain(&s, x, 0.0, 0.0, 1e-3);
        expected[k] = clod_domain_within(&s.state.domain, 0, x);
    }
    assert_true(clod_neighbour_wrap(&none, &s.state, 0, (clod_chunk){0, 9}));
    for (int k = 0; k < 9; k++) {
        check_close(s.state.grains.position[k][0], expected[k], 0.0);
    }
    s.state.grains.position[4][0] = (double)NAN;
    assert_false(clod_neighbour_wrap(&none, &s.state, 0, (clod_chunk){0, 9}));
    clod_state_fini(&s.state);
}

// ---- one step

/** A grain that moves from one place to another, and a plane x = 0 with a region. */
typedef struct move {
    double from[3], to[3];
    int64_t forward, back;
} move;

static void check_moves(const clod_plane *plane, const clod_domain *domain, const move *moves,
                        size_t count)
{
    const clod_case_contact contact = contact_ore();
    for (size_t k = 0; k < count; k++) {
        const move *m = &moves[k];
        clod_passed passed[1] = {{.grains = {0}}};
        clod_passage seen[1];
        scene s;
        scene_init(&s, 0.25, &contact);
        s.state.domain = *domain;
        scene_grain(&s, m->from[0], m->from[1], m->from[2], 1e-3);
        s.state.planes = (clod_planes){.count = 1, .plane = {*plane}};
        clod_passages_note(seen, &s.state, 0, 1);
        double *v = s.state.grains.velocity[0], speed2 = 0.0;
        for (int a = 0; a < 3; a++) { // as a drift does
            v[a] = (m->to[a] - m->from[a]) / s.state.dt;
            speed2 += v[a] * v[a];
            s.state.grains.position[0][a] = m->to[a];
        }
        clod_passages_count(passed, seen, &s.state, sqrt(speed2), 0, 1);
        if (passed->grains[CLOD_PASSED_FORWARD] != m->forward ||
            passed->grains[CLOD_PASSED_BACK] != m->back) {
            fail_msg("move %zu: %d forward, %d back", k,
                     (int)passed->grains[CLOD_PASSED_FORWARD],
                     (int)passed->grains[CLOD_PASSED_BACK]);
        }
        const double mass = s.state.grains.velocity[0][3];
        check_relative(clod_exact_value(&passed->mass[CLOD_PASSED_FORWARD]),
                       (double)m->forward * mass, 1e-15);
        check_relative(clod_exact_value(&passed->mass[CLOD_PASSED_BACK]),
                       (double)m->back * mass, 1e-15);
        clod_state_fini(&s.state);
    }
}

/** Where the straight line between two places meets the plane decides. */
static void a_grain_counts_where_it_passes(void **state)
{
    (void)state;
    const clod_domain domain = {.min = {-10.0, -10.0, -10.0}, .max = {10.0, 10.0, 10.0}};
    clod_plane plane = {
        .region = {.low = {-1.0, -1.0, 0.0}, .high = {1.0, 1.0, 2.0}}, .at = 0.0, .sign = 1};
    const move moves[] = {{{-0.1, 0, 1}, {0.1, 0, 1}, 1, 0},
                          {{0.1, 0, 1}, {-0.1, 0, 1}, 0, 1},
                          {{-0.2, 0, 1}, {-0.1, 0, 1}, 0, 0},
                          {{0.1, 0, 1}, {0.2, 0, 1}, 0, 0},
                          {{-0.1, 0, 1}, {0.0, 0, 1}, 1, 0}, // on the plane is beyond it
                          {{0.0, 0, 1}, {0.1, 0, 1}, 0, 0},
                          {{0.0, 0, 1}, {-0.1, 0, 1}, 0, 1},
                          {{0.0, 0, 1}, {0.0, 1, 1}, 0, 0},
                          {{-0.1, 0.95, 1}, {0.1, 1.15, 1}, 0, 0}, // passes at y = 1.05
                          {{-0.1, 0.85, 1}, {0.1, 1.05, 1}, 1, 0}, // at y = 0.95
                          {{-0.3, 1.25, 1}, {0.1, 0.85, 1}, 1, 0}, // at y = 0.95
                          {{0.3, 1.25, 1}, {-0.1, 0.85, 1}, 0, 1}, // at y = 0.95
                          {{-0.1, 1.0, 1}, {0.1, 1.0, 1}, 1, 0},   // the border counts
                          {{-0.1, 0, -0.1}, {0.1, 0, -0.1}, 0, 0},
                          {{-5.0, 0, 1}, {5.0, 0, 1}, 1, 0}};
    const size_t count = sizeof moves / sizeof *moves;
    check_moves(&plane, &domain, moves, count);
    plane.sign = -1; // forward is the other way
    move turned[sizeof moves / sizeof *moves];
    for (size_t k = 0; k < count; k++) {
        turned[k] = moves[k];
        turned[k].forward = moves[k].back;
        turned[k].back = moves[k].forward;
    }
    check_moves(&plane, &domain, turned, count);
}

/** Along each axis, and through a ring. */
static void a_ring_counts_what_passes_it(void **state)
{
    (void)state;
    const clod_domain domain = {.min = {-10.0, -10.0, -10.0}, .max = {10.0, 10.0, 10.0}};
    const clod_plane ring = {.region = {.low = {-1.0, -1.0, 0.0},
                                        .high = {1.0, 1.0, 1.0},
                                        .inner = 0.5,
                                        .outer = 1.0},
                             .at = 0.25,
                             .axis = 2,
                             .sign = -1};
    const move through[] = {{{0.7, 0, 0.3}, {0.7, 0, 0.2}, 1, 0},
                            {{0.0, 0.7, 0.2}, {0.0, 0.7, 0.3}, 0, 1},
                            {{0.0, 0, 0.3}, {0.0, 0, 0.2}, 0, 0},     // its hole
                            {{0.8, 0.8, 0.3}, {0.8, 0.8, 0.2}, 0, 0}, // its box, not its circle
                            {{0.3, 0, 0.35}, {0.72, 0, 0.15}, 1, 0},  // at x = 0.51
                            {{0.28, 0, 0.35}, {0.7, 0, 0.15}, 0, 0}}; // at x = 0.49
    check_moves(&ring, &domain, through, sizeof through / sizeof *through);
    const clod_plane level = {.region = {.low = {-1.0, 0.0, -1.0}, .high = {1.0, 1.0, 1.0}},
                              .at = 0.5,
                              .axis = 1,
                              .sign = 1};
    const move along_y[] = {{{0, 0.4, 0}, {0, 0.6, 0}, 1, 0}, {{0.4, 0, 0}, {0.6, 0, 0}, 0, 0}};
    check_moves(&level, &domain, along_y, sizeof along_y / sizeof *along_y);
}

/** Across a periodic side, along it, and with images on both sides of the domain. */
static void sides_of_the_domain_are_passed_rightly(void **state)
{
    (void)state;
    clod_domain domain = domain_along_x(-0.5, 0.5);
    domain.periodic[1] = true;
    domain.min[1] = -0.5;
    domain.max[1] = 0.5;
    const clod_plane seam = {
        .region = {.low = {-0.5, 0.25, -1.0}, .high = {0.5, 0.5, 1.0}}, .at = 0.5, .sign = 1};
    clod_plane middle = seam;
    middle.at = 0.0;
    const move at_seam[] = {
        {{0.45, 0.3, 0}, {0.55, 0.3, 0}, 1, 0},     {{-0.45, 0.3, 0}, {-0.55, 0.3, 0}, 0, 1},
        {{0.55, 0.3, 0}, {0.45, 0.3, 0}, 0, 1}, // not put back yet
        {{1.45, 0.3, 0}, {1.55, 0.3, 0}, 1, 0},     {{0.45, 0.0, 0}, {0.55, 0.0, 0}, 0, 0},
        {{0.45, -0.7, 0}, {0.55, -0.7, 0}, 1, 0}, // y = 0.3
        {{0.45, 0.15, 0}, {0.55, 0.37, 0}, 1, 0}, // y = 0.26
        {{0.45, 0.13, 0}, {0.55, 0.35, 0}, 0, 0}, // y = 0.24
        {{-0.55, 0.15, 0}, {-0.45, 0.37, 0}, 1, 0}, {{-0.45, 0.13, 0}, {-0.55, 0.35, 0}, 0, 0}};
    check_moves(&seam, &domain, at_seam, sizeof at_seam / sizeof *at_seam);
    const move at_middle[] = {
        {{0.45, 0.3, 0}, {0.55, 0.3, 0}, 0, 0},   {{-0.05, 0.3, 0}, {0.05, 0.3, 0}, 1, 0},
        {{0.95, 0.3, 0}, {1.05, 0.3, 0}, 1, 0},   {{0.95, 0.15, 0}, {1.05, 0.37, 0}, 1, 0},
        {{0.95, 0.13, 0}, {1.05, 0.35, 0}, 0, 0}, {{1.05, 0.15, 0}, {0.95, 0.37, 0}, 0, 1},
        {{1.05, 0.13, 0}, {0.95, 0.35, 0}, 0, 0}, {{-0.95, 0.3, 0}, {-1.05, 0.3, 0}, 0, 1}};
    check_moves(&middle, &domain, at_middle, sizeof at_middle / sizeof *at_middle);
}

// ---- a bed

#define FLYING 150
#define FLIGHT 4000 ///< steps
#define PLANES 3

/** Grains that fly along x through a periodic box, each on its own line. */
static void begin_flight(scene *s, int threads)
{
    dice random = {7};
    const clod_case_contact contact = contact_ore();
    scene_init(s, 1e-4, &contact);
    s->state.domain = domain_along_x(0.1, 0.4);
    for (int k = 0; k < FLYING; k++) {
        const size_t g = scene_grain(s, dice_real(&random, 0.1, 0.4), 0.1 * (k % 15),
                                     0.1 * (k / 15.0), dice_real(&random, 1e-3, 2e-3));
        scene_move(s, g, dice_real(&random, -5.0, 5.0), 0.0, 0.0);
    }
    const clod_outlet all = {.low = {0.1, -10.0, -10.0}, .high = {0.4, 10.0, 10.0}};
    s->state.planes = (clod_planes){.count = PLANES,
                                    .plane = {{.region = all, .at = 0.1, .sign = 1},
                                              {.region = all, .at = 0.27, .sign = -1},
                                              {.region = all, .at = 0.4, .sign = 1}}};
    scene_start_with(s, (clod_step_options){.threads = threads});
}

/** Expected of free flight: images of the plane between x and x + v t. */
static void grains_that_fly_are_counted(void **state)
{
    (void)state;
    int64_t grains[PLANES][CLOD_PASSED_WAYS] = {{0}};
    double mass[PLANES][CLOD_PASSED_WAYS] = {{0.0}};
    scene s;
    begin_flight(&s, 1);
    for (size_t g = 0; g < FLYING; g++) {
        const double x = s.state.grains.position[g][0], v = s.state.grains.velocity[g][0];
        for (int p = 0; p < PLANES; p++) {
            const clod_plane *plane = &s.state.planes.plane[p];
            const double first = (x - plane->at) / 0.3;
            const double last = (x + v * FLIGHT * 1e-4 - plane->at) / 0.3;
            const double images = floor(last) - floor(first);
            const int way =
                (images > 0.0) == (plane->sign > 0) ? CLOD_PASSED_FORWARD : CLOD_PASSED_BACK;
            assert_true(fabs(last - nearbyint(last)) > 1e-9); // none ends on a plane
            grains[p][way] += llround(fabs(images));
            mass[p][way] += fabs(images) * s.state.grains.velocity[g][3];
        }
    }
    scene_run(&s, FLIGHT);
    assert_true(s.step.rebuilds > 10);
    for (int p = 0; p < PLANES; p++) {
        for (int way = 0; way < CLOD_PASSED_WAYS; way++) {
            const clod_passed *passed = &s.state.planes.passed[p];
            assert_true(grains[p][way] > FLYING); // more than once round
            assert_int_equal(passed->grains[way], grains[p][way]);
            check_relative(clod_exact_value(&passed->mass[way]), mass[p][way], 1e-13);
        }
    }
    scene_end(&s);
}

static void check_same_sums(const clod_passed *a, const clod_passed *b)
{
    for (int way = 0; way < CLOD_PASSED_WAYS; way++) {
        assert_int_equal(a->grains[way], b->grains[way]);
        assert_memory_equal(a->mass[way].chunk, b->mass[way].chunk, sizeof a->mass[way].chunk);
        assert_int_equal(a->mass[way].pending, 0); // a checkpoint has no more than the chunks
        assert_int_equal(b->mass[way].pending, 0);
    }
}

/** Sums have the same bytes on any number of threads, however the steps are cut into calls. */
static void sums_have_the_same_bytes(void **state)
{
    (void)state;
    static const int64_t CUTS[] = {1, FLIGHT, 90, 400};
    scene whole;
    begin_flight(&whole, 1);
    scene_run(&whole, FLIGHT);
    for (int k = looks_for_races() ? 3 : 0; k < 4; k++) {
        scene s;
        begin_flight(&s, 1 + k);
        for (int64_t left = FLIGHT; left > 0; left -= CUTS[k]) {
            scene_run(&s, left < CUTS[k] ? left : CUTS[k]);
        }
        for (int p = 0; p < PLANES; p++) {
            check_same_sums(&s.state.planes.passed[p], &whole.state.planes.passed[p]);
        }
        scene_end(&s);
    }
    scene_end(&whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(levels_count_the_images_on_the_way),
        cmocka_unit_test(to_be_put_back_passes_nothing),
        cmocka_unit_test(a_rebuild_puts_back_to_the_same_place),
        cmocka_unit_test(a_grain_counts_where_it_passes),
        cmocka_unit_test(a_ring_counts_what_passes_it),
        cmocka_unit_test(sides_of_the_domain_are_passed_rightly),
        cmocka_unit_test(grains_that_fly_are_counted),
        cmocka_unit_test(sums_have_the_same_bytes),
    };
    if (looks_for_races()) {
        cmocka_set_test_filter("sums_*"); // the others have one thread
    }
    return cmocka_run_group_tests(tests, NULL, NULL);
}
