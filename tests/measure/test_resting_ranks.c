// What rests on which wall in graphs whose grains are dealt to ranks: as grains are asked one by one in
// the whole graph, and as in one process.
#include "measure/resting.h"

#include "support/dealt_graph.h"
#include "support/scene.h"

#define MANY DEALT_GRAINS
#define SPEED 0.05 // m/s
#define WALLS 3
#define R 1e-3 // m

/** A graph, and what comes of it. */
typedef struct resting_graph {
    dealt_graph graph;
    clod_resting on[MANY]; ///< by row of the whole graph
} resting_graph;

/** Velocity of each wall's surface along x [m/s]. */
static const double BELT[WALLS] = {0.0, 0.03, -0.02};

static void carrier(const void *laws, const clod_contact *contact, double velocity[3])
{
    (void)laws;
    velocity[0] = BELT[contact->j];
    velocity[1] = velocity[2] = 0.0;
}

static void touch_wall(contact_graph *graph, int32_t row, int32_t wall, int32_t shape)
{
    graph_touch_wall(graph, row, wall);
    graph->state.contacts[graph->state.contact_count - 1].shape = shape;
}

/** Chains of rows, with bonds across if there are `ties`; some of their grains touch walls. */
static void make(contact_graph *graph, uint64_t seed, int ties)
{
    dice roll = {seed};
    graph_init(graph, 3 * MANY);
    graph->contacts.carrier = carrier;
    for (int k = 0; k < MANY; k++) {
        const int32_t g = graph_grain(graph, (uint64_t)k * 7 % MANY + 1, R * k, 0.0, R);
        graph->state.grains.velocity[g][0] = dice_real(&roll, -0.045, 0.06);
    }
    for (int32_t k = 0; k + 1 < MANY; k++) {
        graph_touch(graph, k, k + 1, 1.0);
    }
    for (int k = 0; k < ties; k++) {
        const int32_t i = dice_pick(&roll, MANY), j = dice_pick(&roll, MANY);
        if (i != j) {
            graph_touch(graph, i, j, 1.0);
        }
    }
    for (int32_t k = 10; k < MANY; k += 60) {
        touch_wall(graph, k, dice_pick(&roll, WALLS), dice_pick(&roll, 2));
        touch_wall(graph, k, dice_pick(&roll, WALLS), dice_pick(&roll, 2));
    }
}

// ---- the answer by hand

static bool is_slow(const contact_graph *graph, int g, int32_t wall)
{
    return fabs(graph->state.grains.velocity[g][0] - BELT[wall]) < SPEED;
}

/** Nearer, or of two as near before; an id of 0 is that of a wall. */
static bool comes_first(const clod_resting *a, uint64_t a_id, const clod_resting *b,
                        uint64_t b_id)
{
    if (b->wall < 0 || a->steps != b->steps || a->wall != b->wall) {
        return b->wall < 0 || a->steps < b->steps ||
               (a->steps == b->steps && a->wall < b->wall);
    }
    return a_id < b_id || (a_id == b_id && a->shape < b->shape);
}

/** The best that a grain finds among its contacts, of those that are known. */
static clod_resting ask(const contact_graph *graph, int g, const clod_resting known[MANY])
{
    clod_resting best = {-1, -1, 0};
    uint64_t best_id = 0;
    for (size_t k = 0; k < graph->state.contact_count; k++) {
        const clod_contact *c = &graph->state.contacts[k];
        clod_resting mine = {-1, -1, 0};
        uint64_t id = 0;
        if (c->shape >= 0 && c->i == g) {
            mine = (clod_resting){c->j, c->shape, 1};
        } else if (c->shape < 0 && (c->i == g || c->j == g)) {
            const int32_t other = c->i == g ? c->j : c->i;
            mine = known[other];
            mine.steps++;
            id = graph->state.grains.id[other];
        }
        if (mine.wall >= 0 && is_slow(graph, g, mine.wall) &&
            comes_first(&mine, id, &best, best_id)) {
            best = mine;
            best_id = id;
        }
    }
    return best;
}

/** Ask all grains, by what is known of those nearer, until nobody learns anything. */
static void ask_all(const contact_graph *graph, clod_resting known[MANY])
{
    for (int g = 0; g < MANY; g++) {
        known[g] = (clod_resting){-1, -1, 0};
    }
    for (bool again = true; again;) {
        clod_resting next[MANY];
        for (int g = 0; g < MANY; g++) {
            next[g] = known[g].wall >= 0 ? known[g] : ask(graph, g, known);
        }
        again = memcmp(next, known, sizeof next) != 0;
        memcpy(known, next, sizeof next);
    }
}

// ---- ranks

static void find_on(clod_ranks *ranks, void *context)
{
    resting_graph *self = context;
    const dealt_rank rank = {&self->graph, ranks};
    const clod_survey_part here = dealt_here(&rank);
    clod_resting to[MANY];
    clod_status status;
    CLOD_ASSERT(clod_resting_find(to, &here, SPEED, &status));
    for (size_t g = 0; g < here.state->grains.count; g++) {
        if (clod_survey_has(&here, g)) {
            self->on[self->graph.row[ranks->rank][g]] = to[g];
        }
    }
}

static void compare(uint64_t seed, int ties, int32_t depth)
{
    static const int SIZE[] = {1, 2, 3, 4, 7};
    static resting_graph several;
    clod_resting one[MANY], expected[MANY];
    clod_status status;
    memset(&several, 0, sizeof several);
    contact_graph *whole = &several.graph.whole;
    make(whole, seed, ties);
    ask_all(whole, expected);
    const clod_survey_part all = {.state = &whole->state, .contacts = &whole->contacts};
    assert_true(clod_resting_find(one, &all, SPEED, &status));
    assert_memory_equal(one, expected, sizeof one);
    int resting = 0;
    int32_t deepest = 0;
    for (int g = 0; g < MANY; g++) {
        resting += one[g].wall >= 0;
        deepest = one[g].steps > deepest ? one[g].steps : deepest;
    }
    assert_true(resting > MANY / 20 && resting < MANY && deepest >= depth);
    for (int n = 0; n < 5 * DEALINGS; n++) {
        memset(several.on, 0, sizeof several.on);
        dealt_begin(&several.graph, (dealing)(n % DEALINGS), SIZE[n / DEALINGS],
                    seed + (uint64_t)n);
        ranks_run(SIZE[n / DEALINGS], find_on, &several);
        assert_memory_equal(several.on, one, sizeof one);
        dealt_end(&several.graph);
    }
    graph_fini(whole);
}

static void chains_across_ranks(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 6; seed++) {
        compare(seed, 0, 5);
    }
}

static void heaps_across_ranks(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 6; seed++) {
        compare(seed, MANY / 2, 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(chains_across_ranks),
        cmocka_unit_test(heaps_across_ranks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
