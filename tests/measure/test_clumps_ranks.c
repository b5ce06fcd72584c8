// Clumps of graphs whose grains are dealt to ranks: those that labels find which are spread by hand over
// the whole graph, and the bits of one process.
#include "measure/clumps.h"

#include "support/dealt_graph.h"
#include "support/sanitized.h"

#define MANY DEALT_GRAINS

/** A graph, and what comes of it. */
typedef struct clumped_graph {
    dealt_graph graph;
    clod_clump_choice choice;
    clod_clump_name name[MANY]; ///< by row of the whole graph
    clod_clumps clumps;         ///< of rank 0
    clod_clump_stats stats;
    clod_clump_sizes sizes;
} clumped_graph;

// ---- graphs

static void place_of(dice *roll, double place[2])
{
    place[0] = dice_real(roll, -0.2, 1.2);
    place[1] = dice_real(roll, 0.0, 1.0);
}

/** Grains of sizes from 0.1 to 5 mm, ids in no order. */
static void add_grains(contact_graph *graph, dice *roll)
{
    graph_init(graph, 3 * MANY);
    for (int k = 0; k < MANY; k++) {
        double place[2];
        place_of(roll, place);
        graph_grain(graph, (uint64_t)k * 7 % MANY + 1, place[0], place[1],
                    dice_real(roll, 1e-4, 5e-3));
    }
}

static void touch_walls(contact_graph *graph, dice *roll)
{
    for (int k = 0; k < MANY / 60; k++) {
        graph_touch_wall(graph, dice_pick(roll, MANY), 0);
    }
}

/** About one bond for two grains, between any two. */
static void random_graph(contact_graph *graph, uint64_t seed)
{
    dice roll = {seed};
    add_grains(graph, &roll);
    for (int k = 0; k < MANY / 2; k++) {
        const int32_t i = dice_pick(&roll, MANY), j = dice_pick(&roll, MANY);
        if (i != j) {
            graph_touch(graph, i, j, dice_real(&roll, 0.0, 3.0));
        }
    }
    touch_walls(graph, &roll);
}

/** Chains of 2 to 60 grains in the order of rows, one behind the other. */
static void chains(contact_graph *graph, uint64_t seed)
{
    dice roll = {seed};
    add_grains(graph, &roll);
    int left = 0;
    for (int32_t k = 0; k + 1 < MANY; k++) {
        left = left > 0 ? left - 1 : dice_pick(&roll, 60);
        if (left > 0) {
            graph_touch(graph, k, k + 1, 1e3); // more than a weight, whatever the partner's
        }
    }
    touch_walls(graph, &roll);
}

// ---- the answer by hand

/** A contact that joins: it pulls more than the lighter grain weighs, and both count. */
static bool joins(const contact_graph *graph, const clod_contact *c, const bool in[MANY])
{
    const clod_grains *grains = &graph->state.grains;
    return c->shape < 0 && in[c->i] && in[c->j] &&
           c->history[0] > 10.0 * fmin(grains->velocity[c->i][3], grains->velocity[c->j][3]);
}

/** Which grains are in the region: the domain has period 1 along x, from 0. */
static void find_in(const clumped_graph *self, bool in[MANY])
{
    const clod_grains *grains = &self->graph.whole.state.grains;
    for (int g = 0; g < MANY; g++) {
        const double *p = grains->position[g];
        const double x = p[0] < 0.0 ? p[0] + 1.0 : p[0] >= 1.0 ? p[0] - 1.0 : p[0];
        const clod_outlet *box = &self->choice.region;
        in[g] = !self->choice.cuts || (x >= box->low[0] && x <= box->high[0] &&
                                       p[2] >= box->low[2] && p[2] <= box->high[2]);
    }
}

/** Least id of what hangs together with each row. */
static void spread_labels(const contact_graph *graph, const bool in[MANY], uint64_t label[MANY])
{
    memcpy(label, graph->state.grains.id, MANY * sizeof *label);
    for (bool again = true; again;) {
        again = false;
        for (size_t k = 0; k < graph->state.contact_count; k++) {
            const clod_contact *c = &graph->state.contacts[k];
            if (joins(graph, c, in) && label[c->i] != label[c->j]) {
                label[c->i] = label[c->j] =
                    label[c->i] < label[c->j] ? label[c->i] : label[c->j];
                again = true;
            }
        }
    }
}

static bool touches_wall(const contact_graph *graph, int row)
{
    bool any = false;
    for (size_t k = 0; k < graph->state.contact_count; k++) {
        const clod_contact *c = &graph->state.contacts[k];
        any = any || (c->shape >= 0 && c->i == row);
    }
    return any;
}

/** Compare with what is found; how many clumps there are. */
static size_t check_by_hand(const clumped_graph *self)
{
    bool in[MANY];
    uint64_t label[MANY];
    size_t clumps = 0;
    double counted = 0.0;
    find_in(self, in);
    spread_labels(&self->graph.whole, in, label);
    for (int g = 0; g < MANY; g++) {
        int together = 0;
        bool walled = false;
        double mass = 0.0, volume = 0.0;
        for (int other = 0; other < MANY; other++) {
            if (in[g] && in[other] && label[other] == label[g]) {
                const double r = self->graph.whole.state.grains.position[other][3];
                together++;
                walled = walled || touches_wall(&self->graph.whole, other);
                mass += self->graph.whole.state.grains.velocity[other][3];
                volume += 4.0 / 3.0 * M_PI * r * r * r;
            }
        }
        const bool clump = together >= self->choice.least && !(self->choice.free && walled);
        counted += in[g] ? self->graph.whole.state.grains.velocity[g][3] : 0.0;
        assert_int_equal(self->name[g].grains, clump ? together : 0);
        assert_int_equal(self->name[g].id, clump ? label[g] : 0);
        if (clump && self->graph.whole.state.grains.id[g] == label[g]) { // its first grain
            size_t k = 0;
            while (k < self->clumps.count && self->clumps.clump[k].id != label[g]) {
                k++;
            }
            assert_true(k < self->clumps.count);
            assert_int_equal(self->clumps.clump[k].grains, together);
            check_relative(self->clumps.clump[k].mass, mass, 1e-13);
            check_relative(self->clumps.clump[k].volume, volume, 1e-13);
            clumps++;
        }
    }
    assert_int_equal(self->clumps.count, clumps);
    check_relative(self->clumps.grains_mass, counted, 1e-13);
    for (size_t k = 1; k < clumps; k++) {
        assert_true(self->clumps.clump[k - 1].id < self->clumps.clump[k].id);
    }
    return clumps;
}

// ---- ranks

/** Find them in what is here; asserts of cmocka are for the first thread alone. */
static void find(clumped_graph *self, const clod_survey_part *here, const int32_t *row)
{
    clod_status status;
    clod_bonds bonds;
    clod_clumps clumps;
    CLOD_ASSERT(clod_bonds_find(&bonds, here, 1.0, &status));
    CLOD_ASSERT(clod_clumps_find(&clumps, here, &bonds, &self->choice, &status));
    for (size_t g = 0; g < here->state->grains.count; g++) {
        if (clod_survey_has(here, g)) {
            self->name[row == NULL ? g : (size_t)row[g]] =
                clumps.of[g] >= 0 ? clumps.name[clumps.of[g]] : (clod_clump_name){0, 0};
        }
    }
    clod_bonds_fini(&bonds);
    if (here->ranks != NULL && here->ranks->rank > 0) {
        CLOD_ASSERT(clumps.count == 0);
        clod_clumps_fini(&clumps);
        return;
    }
    self->clumps = clumps;
    CLOD_ASSERT(clod_clumps_sum_up(&clumps, &self->stats, &self->sizes, &status));
}

static void find_on(clod_ranks *ranks, void *context)
{
    clumped_graph *self = context;
    const dealt_rank rank = {&self->graph, ranks};
    const clod_survey_part here = dealt_here(&rank);
    find(self, &here, self->graph.row[ranks->rank]);
}

/** The same bytes as of one process. */
static void check_same(const clumped_graph *self, const clumped_graph *one)
{
    assert_memory_equal(&self->stats, &one->stats, sizeof one->stats);
    assert_memory_equal(&self->sizes, &one->sizes, sizeof one->sizes);
    assert_int_equal(self->clumps.count, one->clumps.count);
    for (size_t k = 0; k < one->clumps.count; k++) {
        const clod_clump *a = &self->clumps.clump[k], *b = &one->clumps.clump[k];
        assert_true(a->id == b->id && a->grains == b->grains);
        assert_memory_equal(&a->mass, &b->mass, 2 * sizeof(double));
    }
}

/** All choices. */
static const clod_clump_choice CHOICE[] = {
    {.least = 2},
    {.least = 4, .free = true},
    {.least = 2, .cuts = true, .region = {.low = {0.1, -1.0, -1.0}, .high = {0.7, 1.0, 1.0}}},
    {.least = 2,
     .cuts = true,
     .free = true,
     .region = {.low = {0.0, -1.0, 0.1}, .high = {0.95, 1.0, 0.9}}},
};

static void compare(void (*make)(contact_graph *graph, uint64_t seed), uint64_t seed)
{
    static const int SIZE[] = {1, 2, 3, 4, 7};
    static clumped_graph one, several;
    for (size_t c = 0; c < sizeof CHOICE / sizeof *CHOICE; c++) {
        memset(&one, 0, sizeof one);
        make(&one.graph.whole, seed);
        clod_domain *domain = &one.graph.whole.state.domain;
        domain->periodic[0] = true;
        domain->max[0] = 1.0;
        one.choice = CHOICE[c];
        const clod_survey_part all = {.state = &one.graph.whole.state,
                                      .contacts = &one.graph.whole.contacts};
        find(&one, &all, NULL);
        assert_true(check_by_hand(&one) > 3);
        for (int n = 0; n < 5 * DEALINGS; n++) {
            several = one;
            memset(several.name, -1, sizeof several.name);
            const int ranks = SIZE[n / DEALINGS];
            dealt_begin(&several.graph, (dealing)(n % DEALINGS), ranks, seed + (uint64_t)n);
            ranks_run(ranks, find_on, &several);
            check_by_hand(&several);
            check_same(&several, &one);
            clod_clumps_fini(&several.clumps);
            dealt_end(&several.graph);
        }
        clod_clumps_fini(&one.clumps);
        graph_fini(&one.graph.whole);
    }
}

static void random_graphs(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= (sanitized() ? 1 : 4); seed++) {
        compare(random_graph, seed);
    }
}

static void chains_through_all_ranks(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= (sanitized() ? 1 : 4); seed++) {
        compare(chains, seed);
    }
}

/** A bed without grains, and ranks without any. */
static void nobody(void **state)
{
    (void)state;
    static clumped_graph none;
    for (int r = 0; r < 3; r++) {
        graph_init(&none.graph.part[r], 1);
    }
    none.graph.ranks = 3;
    none.choice = CHOICE[0];
    ranks_run(3, find_on, &none);
    assert_int_equal(none.clumps.count, 0);
    assert_true(none.stats.number == 0.0 && none.clumps.grains_mass == 0.0);
    clod_clumps_fini(&none.clumps);
    dealt_end(&none.graph);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(random_graphs),
        cmocka_unit_test(chains_through_all_ranks),
        cmocka_unit_test(nobody),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
