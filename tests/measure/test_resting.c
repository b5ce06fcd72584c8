// What rests on which wall: columns, belts and bridges that are put down by hand.

#include "measure/resting.h"

#include "sim/build_up.h"
#include "support/contact_graph.h"
#include "support/scene.h"
#include "support/shuffled.h"

#define SPEED 0.05 // m/s
#define R 1e-2     // m

/** Walls move with their surfaces alone. */
static void carrier(const void *laws, const clod_contact *contact, double velocity[3])
{
    const contact_graph *graph = laws;
    clod_vec3_put(velocity, graph->state.walls.wall[contact->j].surface_velocity);
}

/** Walls 0: floor z = 0; 1: side x = 0; grains above and in front. */
static void add_walls(contact_graph *graph)
{
    scene s = {.state = graph->state};
    scene_wall(&s, "floor", shape_floor(0.0));
    scene_wall(&s, "side", shape_plane((clod_vec3){0}, (clod_vec3){1.0, 0.0, 0.0}));
    graph->state.walls = s.state.walls;
    graph->contacts.carrier = carrier;
    graph->contacts.laws = graph;
}

static void find(contact_graph *graph, clod_resting *to)
{
    clod_status status;
    const clod_survey_part all = {.state = &graph->state, .contacts = &graph->contacts};
    assert_true(clod_resting_find(to, &all, SPEED, &status));
}

static void move(contact_graph *graph, int32_t row, double vx, double vz)
{
    graph->state.grains.velocity[row][0] = vx;
    graph->state.grains.velocity[row][2] = vz;
}

/** Four on top of each other; the third moves, so the fourth rests on nothing. */
static void a_column_rests_up_to_what_moves(void **state)
{
    (void)state;
    contact_graph graph;
    clod_resting on[4];
    graph_init(&graph, 4);
    add_walls(&graph);
    for (int k = 0; k < 4; k++) {
        graph_grain(&graph, (uint64_t)k + 1, 1.0, R * (2 * k + 1), R);
    }
    for (int32_t k = 0; k < 3; k++) {
        graph_touch(&graph, k, k + 1, 0.0);
    }
    graph_touch_wall(&graph, 0, 0);
    find(&graph, on);
    for (int k = 0; k < 4; k++) {
        assert_int_equal(on[k].wall, 0);
        assert_int_equal(on[k].steps, k + 1);
    }
    move(&graph, 2, 0.0, 1.01 * SPEED);
    find(&graph, on);
    assert_int_equal(on[1].wall, 0);
    assert_int_equal(on[2].wall, -1);
    assert_int_equal(on[3].wall, -1);
    move(&graph, 2, 0.0, 0.99 * SPEED);
    find(&graph, on);
    assert_int_equal(on[3].wall, 0);
    graph_fini(&graph);
}

/** The floor is a belt at 2 m/s: what goes with it rests, and so does what lies on that. */
static void a_belt_carries(void **state)
{
    (void)state;
    contact_graph graph;
    clod_resting on[4];
    graph_init(&graph, 4);
    add_walls(&graph);
    graph.state.walls.wall[0].surface_velocity.x = 2.0;
    graph_grain(&graph, 1, 1.0, R, R);
    graph_grain(&graph, 2, 1.0, 3.0 * R, R);
    graph_grain(&graph, 3, 2.0, R, R); // slides: it stands still
    graph_grain(&graph, 4, 1.0, 5.0 * R, R);
    move(&graph, 0, 2.0, 0.0);
    move(&graph, 1, 2.04, 0.0);
    move(&graph, 3, 2.06, 0.0); // faster than the belt by more than the speed
    graph_touch(&graph, 0, 1, 0.0);
    graph_touch(&graph, 1, 3, 0.0);
    graph_touch_wall(&graph, 0, 0);
    graph_touch_wall(&graph, 2, 0);
    find(&graph, on);
    assert_int_equal(on[0].wall, 0);
    assert_int_equal(on[1].wall, 0);
    assert_int_equal(on[2].wall, -1);
    assert_int_equal(on[3].wall, -1);
    graph_fini(&graph);
}

/** A bridge of five between side and floor: the nearer wall; in the middle the first one. */
static void the_nearest_wall_counts(void **state)
{
    (void)state;
    contact_graph graph;
    clod_resting on[5];
    const int32_t expected[5] = {1, 1, 0, 0, 0};
    graph_init(&graph, 6);
    add_walls(&graph);
    for (int k = 0; k < 5; k++) {
        graph_grain(&graph, (uint64_t)k + 1, R * (2 * k + 1), R * (9 - 2 * k), R);
    }
    for (int32_t k = 0; k < 4; k++) {
        graph_touch(&graph, k, k + 1, 0.0);
    }
    graph_touch_wall(&graph, 0, 1);
    graph_touch_wall(&graph, 4, 0);
    find(&graph, on);
    for (int k = 0; k < 5; k++) {
        assert_int_equal(on[k].wall, expected[k]);
    }
    assert_int_equal(on[2].steps, 3);
    graph_fini(&graph);
}

/** A grain in the corner touches both. */
static void in_a_corner_the_first_wall_counts(void **state)
{
    (void)state;
    contact_graph graph;
    clod_resting on[1];
    graph_init(&graph, 2);
    add_walls(&graph);
    graph_grain(&graph, 1, R, R, R);
    graph_touch_wall(&graph, 0, 1);
    graph_touch_wall(&graph, 0, 0);
    find(&graph, on);
    assert_int_equal(on[0].wall, 0);
    // it slides along the floor, which moves: then it rests on the side
    graph.state.walls.wall[0].surface_velocity.x = 1.0;
    find(&graph, on);
    assert_int_equal(on[0].wall, 1);
    graph_fini(&graph);
}

/** A floor of two shapes; the third grain lies on both others: it counts where 5 does, not 9. */
static void of_two_below_the_smaller_id_counts(void **state)
{
    (void)state;
    contact_graph graph;
    clod_resting on[3];
    graph_init(&graph, 4);
    add_walls(&graph);
    clod_wall *floor = &graph.state.walls.wall[0];
    floor->shapes = clod_memory_grow(floor->shapes, 1, 2, sizeof *floor->shapes);
    floor->shapes[1] = floor->shapes[0];
    floor->shape_count = 2;
    graph_grain(&graph, 9, 1.0, R, R);
    graph_grain(&graph, 5, 1.0 + 2.0 * R, R, R);
    graph_grain(&graph, 7, 1.0 + R, R * (1.0 + sqrt(3.0)), R);
    graph_touch(&graph, 0, 2, 0.0);
    graph_touch(&graph, 1, 2, 0.0);
    graph_touch_wall(&graph, 0, 0);
    graph_touch_wall(&graph, 1, 0);
    graph.state.contacts[3].shape = 1;
    find(&graph, on);
    assert_int_equal(on[0].shape, 0);
    assert_int_equal(on[1].shape, 1);
    assert_int_equal(on[2].shape, 1);
    assert_int_equal(on[2].steps, 2);
    graph_fini(&graph);
}

#define MANY 300

/** The same in whatever order rows and contacts stand: two belts of different speed. */
static void the_order_does_not_count(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 20; seed++) {
        contact_graph graph, other = {0};
        clod_resting on[MANY], there[MANY];
        dice roll = {seed};
        graph_init(&graph, 3 * MANY);
        add_walls(&graph);
        graph.state.walls.wall[0].surface_velocity.x = 0.03;
        for (int k = 0; k < MANY; k++) {
            graph_grain(&graph, (uint64_t)k + 1, 1.0, R, R);
            move(&graph, k, dice_real(&roll, -0.04, 0.07), 0.0);
        }
        for (int k = 0; k < 2 * MANY; k++) {
            const int32_t i = dice_pick(&roll, MANY), j = dice_pick(&roll, MANY);
            if (i != j) {
                graph_touch(&graph, i, j, 0.0);
            }
        }
        for (int32_t k = 0; k < MANY; k += 30) {
            graph_touch_wall(&graph, k, k % 60 / 30);
        }
        graph.state.build_position =
            clod_memory_alloc(graph.state.grains.capacity, sizeof(double[4]));
        other.state = shuffled(&graph.state, seed);
        other.contacts = clod_contact_source_of(&other.list, &other.state);
        other.contacts.carrier = carrier;
        other.contacts.laws = &other;
        find(&graph, on);
        find(&other, there);
        int resting = 0;
        for (int g = 0; g < MANY; g++) {
            resting += on[g].wall >= 0;
            for (int h = 0; h < MANY; h++) {
                if (other.state.grains.id[h] == graph.state.grains.id[g]) {
                    assert_memory_equal(&on[g], &there[h], sizeof on[g]);
                }
            }
        }
        assert_true(resting > MANY / 10 && resting < MANY);
        graph_fini(&graph);
        graph_fini(&other);
    }
}

/** By hand: means 1.5 s and 2.5 kg; 6 kg s over 5 s2. */
static void the_rate_is_that_of_least_squares(void **state)
{
    (void)state;
    const double time[] = {0.0, 1.0, 2.0, 3.0}, mass[] = {1.0, 2.0, 2.0, 5.0};
    check_relative(clod_build_up_rate(time, mass, 4), 1.2, 1e-12);
    assert_true(isnan(clod_build_up_rate(time, mass, 2)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_column_rests_up_to_what_moves),
        cmocka_unit_test(a_belt_carries),
        cmocka_unit_test(the_nearest_wall_counts),
        cmocka_unit_test(in_a_corner_the_first_wall_counts),
        cmocka_unit_test(of_two_below_the_smaller_id_counts),
        cmocka_unit_test(the_order_does_not_count),
        cmocka_unit_test(the_rate_is_that_of_least_squares),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
