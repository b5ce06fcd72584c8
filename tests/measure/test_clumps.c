// Clumps of chains and clusters that are put down by hand: their numbers by counting.

#include "measure/clumps.h"

#include <string.h>

#include "support/contact_graph.h"
#include "support/shuffled.h"

#define R 3e-3 // m

/** Clumps of a graph, and what they are. */
typedef struct found {
    clod_bonds bonds;
    clod_clumps clumps;
    clod_clump_stats stats;
    clod_clump_sizes sizes;
} found;

static void find(found *self, contact_graph *graph, double bond, const clod_clump_choice *of)
{
    clod_status status;
    const clod_survey_part all = {.state = &graph->state, .contacts = &graph->contacts};
    assert_true(clod_bonds_find(&self->bonds, &all, bond, &status));
    assert_true(clod_clumps_find(&self->clumps, &all, &self->bonds, of, &status));
    assert_true(clod_clumps_sum_up(&self->clumps, &self->stats, &self->sizes, &status));
}

static void drop(found *self)
{
    clod_clumps_fini(&self->clumps);
    clod_bonds_fini(&self->bonds);
}

static const clod_clump_choice PAIRS = {.least = 2};

static double mass_of(double radius)
{
    return GRAPH_DENSITY * 4.0 / 3.0 * M_PI * radius * radius * radius;
}

/** Three in a row, ids 10, 7, 3; the first bond carries half a weight, the other two. */
static void a_weak_bond_does_not_join(void **state)
{
    (void)state;
    contact_graph graph;
    found f;
    graph_init(&graph, 2);
    for (int k = 0; k < 3; k++) {
        graph_grain(&graph, (uint64_t[]){10, 7, 3}[k], 2.0 * R * k, 0.0, R);
    }
    graph_touch(&graph, 0, 1, 0.5);
    graph_touch(&graph, 1, 2, 2.0);
    find(&f, &graph, 1.0, &PAIRS);
    assert_int_equal(f.clumps.count, 1);
    assert_int_equal(f.clumps.clump[0].id, 3);
    assert_int_equal(f.clumps.clump[0].grains, 2);
    assert_int_equal(f.clumps.of[0], -1);
    assert_int_equal(f.clumps.of[1], 0);
    assert_int_equal(f.clumps.of[2], 0);
    check_relative(f.stats.share, 2.0 / 3.0, 1e-12);
    drop(&f);
    find(&f, &graph, 0.25, &PAIRS); // a quarter of a weight is enough
    assert_int_equal(f.clumps.clump[0].grains, 3);
    drop(&f);
    find(&f, &graph, 3.0, &PAIRS);
    assert_int_equal(f.clumps.count, 0);
    assert_true(f.stats.share == 0.0 && f.stats.d50 == 0.0);
    drop(&f);
    graph_fini(&graph);
}

/** The weight is that of the lighter grain: half the radius, an eighth of the mass. */
static void the_lighter_grain_counts(void **state)
{
    (void)state;
    contact_graph graph;
    found f;
    graph_init(&graph, 1);
    graph_grain(&graph, 1, 0.0, 0.0, R);
    graph_grain(&graph, 2, 1.5 * R, 0.0, 0.5 * R);
    graph_touch(&graph, 0, 1, 0.2); // of the heavier one: 1.6 of the lighter one
    find(&f, &graph, 1.0, &PAIRS);
    assert_int_equal(f.clumps.count, 1);
    drop(&f);
    find(&f, &graph, 1.7, &PAIRS);
    assert_int_equal(f.clumps.count, 0);
    drop(&f);
    // without gravity any pull is enough, but none is not
    memset(graph.state.gravity, 0, sizeof graph.state.gravity);
    graph.state.contacts[0].history[0] = 1e-30;
    find(&f, &graph, 1e6, &PAIRS);
    assert_int_equal(f.clumps.count, 1);
    drop(&f);
    graph.state.contacts[0].history[0] = 0.0;
    find(&f, &graph, 0.0, &PAIRS);
    assert_int_equal(f.clumps.count, 0);
    drop(&f);
    graph_fini(&graph);
}

/** A pair, a triangle and a star of six, and one alone; all of one size. */
static void clusters(contact_graph *graph)
{
    graph_init(graph, 20);
    for (uint64_t k = 0; k < 12; k++) {
        graph_grain(graph, 100 - k, 0.0, 0.0, R); // the last row has the smallest id
    }
    graph_touch(graph, 0, 1, 2.0);
    graph_touch(graph, 2, 3, 2.0);
    graph_touch(graph, 3, 4, 2.0);
    graph_touch(graph, 2, 4, 2.0);
    for (int32_t k = 6; k < 11; k++) {
        graph_touch(graph, 5, k, 2.0);
    }
}

/** 2 + 3 + 6 of 12 grains; (4 + 9 + 36)/11; 2/11, 5/11 and 11/11 of the mass. */
static void numbers_of_clusters(void **state)
{
    (void)state;
    contact_graph graph;
    found f;
    clusters(&graph);
    find(&f, &graph, 1.0, &PAIRS);
    const clod_clump_stats *s = &f.stats;
    const double m = mass_of(R);
    assert_true(s->number == 3.0 && s->grains == 11.0 && s->largest == 6.0);
    check_relative(s->mass, 11.0 * m, 1e-12);
    check_relative(s->share, 11.0 / 12.0, 1e-12);
    check_relative(s->mean, 11.0 / 3.0, 1e-12);
    check_relative(s->mean_by_mass, 49.0 / 11.0, 1e-12);
    check_relative(s->largest_mass, 6.0 * m, 1e-12);
    check_relative(s->d10, 2.0 * R * cbrt(2.0), 1e-12);
    check_relative(s->d50, 2.0 * R * cbrt(6.0), 1e-12);
    check_relative(s->d90, 2.0 * R * cbrt(6.0), 1e-12);
    const uint64_t first[3] = {90, 96, 99}; // rows 10, 4 and 1: ascending by id
    for (int k = 0; k < 3; k++) {
        assert_int_equal(f.clumps.clump[k].id, first[k]);
    }
    assert_true(f.sizes.number[0] == 1.0 && f.sizes.number[1] == 1.0); // 2, 3
    assert_true(f.sizes.number[2] == 0.0 && f.sizes.number[3] == 1.0); // 4-5, 6-10
    check_relative(f.sizes.mass[3], 6.0 * m, 1e-12);
    drop(&f);
    find(&f, &graph, 1.0, &(clod_clump_choice){.least = 3});
    assert_int_equal(f.clumps.count, 2);
    drop(&f);
    graph_fini(&graph);
}

/** Those of which no grain touches a wall: the triangle does with one. */
static void free_clumps_touch_no_wall(void **state)
{
    (void)state;
    contact_graph graph;
    found f;
    clusters(&graph);
    graph_touch_wall(&graph, 4, 0);
    graph_touch_wall(&graph, 11, 0); // alone
    find(&f, &graph, 1.0, &(clod_clump_choice){.least = 2, .free = true});
    assert_int_equal(f.clumps.count, 2);
    assert_int_equal(f.clumps.of[2], -1);
    check_relative(f.stats.share, 8.0 / 12.0, 1e-12);
    drop(&f);
    graph_fini(&graph);
}

/** Five in a row at 0, 1, 2, 3, 4: a region cuts the chain. */
static void a_region_cuts(void **state)
{
    (void)state;
    contact_graph graph;
    found f;
    graph_init(&graph, 4);
    for (int k = 0; k < 5; k++) {
        graph_grain(&graph, (uint64_t)k + 1, k, 0.0, 0.5);
    }
    for (int32_t k = 0; k < 4; k++) {
        graph_touch(&graph, k, k + 1, 2.0);
    }
    const clod_outlet box = {.low = {0.5, -1.0, -1.0}, .high = {3.5, 1.0, 1.0}};
    clod_clump_choice choice = {.least = 2, .cuts = true, .region = box};
    find(&f, &graph, 1.0, &choice);
    assert_int_equal(f.clumps.count, 1);
    assert_int_equal(f.clumps.clump[0].grains, 3);
    assert_int_equal(f.clumps.clump[0].id, 2);
    check_relative(f.stats.share, 1.0, 1e-12); // of the grains in it
    drop(&f);
    // a ring about (2, 0) holds 0, 1, 3 and 4, and not the one in the middle
    const clod_outlet ring = {.low = {-0.1, -2.1, -1.0},
                              .high = {4.1, 2.1, 1.0},
                              .middle = {2.0, 0.0},
                              .inner = 0.9,
                              .outer = 2.1};
    choice.region = ring;
    find(&f, &graph, 1.0, &choice);
    assert_int_equal(f.clumps.count, 2);
    assert_true(f.stats.grains == 4.0);
    drop(&f);
    // with a period of 4 the one at 4 is at 0, until the next rebuild moves it there
    clod_domain *domain = &graph.state.domain;
    domain->periodic[0] = true;
    domain->min[0] = 0.0;
    domain->max[0] = 4.0;
    const clod_outlet start = {.low = {-0.1, -1.0, -1.0}, .high = {0.5, 1.0, 1.0}};
    choice.region = start;
    find(&f, &graph, 1.0, &choice);
    check_relative(f.clumps.grains_mass, 2.0 * mass_of(0.5), 1e-12);
    drop(&f);
    graph_fini(&graph);
}

static void classes_go_by_1_2_5(void **state)
{
    (void)state;
    static const int32_t FROM[] = {2, 3, 4, 6, 11, 21, 51, 101, 201, 501, 1001};
    for (int k = 0; k < (int)(sizeof FROM / sizeof *FROM); k++) {
        assert_int_equal(clod_clump_class(FROM[k]), k);
        assert_int_equal(clod_clump_class_least(k), FROM[k]);
        assert_int_equal(clod_clump_class(FROM[k] - (k > 0)), k > 0 ? k - 1 : 0);
    }
    assert_int_equal(clod_clump_class(INT32_MAX), CLOD_CLUMP_CLASSES - 1);
}

#define MANY 400

/** Grains of different sizes with random bonds, about one each. */
static void random_graph(contact_graph *graph, uint64_t seed)
{
    dice roll = {seed};
    graph_init(graph, 2 * MANY);
    for (int k = 0; k < MANY; k++) {
        graph_grain(graph, (uint64_t)k * 7 % MANY + 1, dice_real(&roll, 0.0, 1.0), 0.0,
                    dice_real(&roll, 1e-3, 5e-3));
    }
    for (int k = 0; k < MANY; k++) {
        const int32_t i = dice_pick(&roll, MANY), j = dice_pick(&roll, MANY);
        if (i != j) {
            graph_touch(graph, i, j, dice_real(&roll, 0.0, 3.0));
        }
    }
    for (int k = 0; k < MANY / 50; k++) {
        graph_touch_wall(graph, dice_pick(&roll, MANY), 0);
    }
}

/** Least id of what hangs together with each row: by going over all contacts until none tells
 *  anything new. */
static void least_ids(const contact_graph *graph, double bond, uint64_t least[MANY])
{
    const clod_grains *grains = &graph->state.grains;
    memcpy(least, grains->id, MANY * sizeof *least);
    for (bool again = true; again;) {
        again = false;
        for (size_t k = 0; k < graph->state.contact_count; k++) {
            const clod_contact *c = &graph->state.contacts[k];
            if (c->shape >= 0) {
                continue;
            }
            const double light = fmin(grains->velocity[c->i][3], grains->velocity[c->j][3]);
            if (c->history[0] > bond * 10.0 * light && least[c->i] != least[c->j]) {
                least[c->i] = least[c->j] =
                    least[c->i] < least[c->j] ? least[c->i] : least[c->j];
                again = true;
            }
        }
    }
}

static void random_graphs_as_by_hand(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 20; seed++) {
        contact_graph graph;
        found f;
        uint64_t least[MANY];
        random_graph(&graph, seed);
        find(&f, &graph, 1.0, &PAIRS);
        least_ids(&graph, 1.0, least);
        for (int g = 0; g < MANY; g++) {
            int together = 0;
            for (int other = 0; other < MANY; other++) {
                together += least[other] == least[g];
            }
            const int32_t number = f.clumps.of[g];
            assert_int_equal(number >= 0, together > 1);
            if (number >= 0) {
                assert_int_equal(f.clumps.name[number].id, least[g]);
                assert_int_equal(f.clumps.name[number].grains, together);
            }
        }
        drop(&f);
        graph_fini(&graph);
    }
}

/** The same bytes in whatever order rows and contacts stand. */
static void the_order_does_not_count(void **state)
{
    (void)state;
    const clod_outlet half = {.low = {0.0, -1.0, -1.0}, .high = {0.5, 1.0, 1.0}};
    const clod_clump_choice choice[3] = {
        {.least = 2}, {.least = 3, .free = true}, {.least = 2, .cuts = true, .region = half}};
    for (uint64_t seed = 1; seed <= 20; seed++) {
        contact_graph graph, other = {0};
        found f, g;
        random_graph(&graph, seed);
        graph.state.build_position =
            clod_memory_alloc(graph.state.grains.capacity, sizeof(double[4]));
        other.state = shuffled(&graph.state, seed);
        other.contacts = clod_contact_source_of(&other.list, &other.state);
        other.contacts.strength = graph_strength;
        for (int k = 0; k < 3; k++) {
            find(&f, &graph, 1.0, &choice[k]);
            find(&g, &other, 1.0, &choice[k]);
            assert_true(f.clumps.count > 0);
            assert_int_equal(f.clumps.count, g.clumps.count);
            assert_memory_equal(&f.stats, &g.stats, sizeof f.stats);
            assert_memory_equal(&f.sizes, &g.sizes, sizeof f.sizes);
            for (size_t c = 0; c < f.clumps.count; c++) {
                assert_memory_equal(&f.clumps.clump[c].mass, &g.clumps.clump[c].mass,
                                    2 * sizeof(double));
                assert_int_equal(f.clumps.clump[c].id, g.clumps.clump[c].id);
            }
            drop(&f);
            drop(&g);
        }
        graph_fini(&graph);
        graph_fini(&other);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_weak_bond_does_not_join),
        cmocka_unit_test(the_lighter_grain_counts),
        cmocka_unit_test(numbers_of_clusters),
        cmocka_unit_test(free_clumps_touch_no_wall),
        cmocka_unit_test(a_region_cuts),
        cmocka_unit_test(classes_go_by_1_2_5),
        cmocka_unit_test(random_graphs_as_by_hand),
        cmocka_unit_test(the_order_does_not_count),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
